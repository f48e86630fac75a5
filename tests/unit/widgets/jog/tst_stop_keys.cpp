// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDialog>
#include <QInputMethodQueryEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>
#include <memory>

#include "robot/station/link/robot_session.h"
#include "widgets/jog/stop_keys.h"

using namespace tiller;
using control::StopCause;

class TestStopKeys : public QObject {
    Q_OBJECT

private:
    struct Scene {
        QList<StopCause> stops;
        StopKeys::Use use = StopKeys::Use::StopOnly;
        StopKeys keys{[this](StopCause cause) { stops.append(cause); }, [this] { return use; }};
        QWidget window;
        QLineEdit* edit = new QLineEdit(&window);
        QPushButton* button = new QPushButton(&window);

        Scene() {
            auto* layout = new QVBoxLayout(&window);
            layout->addWidget(edit);
            layout->addWidget(button);
            window.show();
            window.activateWindow();
            if (!QTest::qWaitForWindowActive(&window)) {
                qFatal("the window did not become active");
            }
        }
    };

    /// A session that reports states set by the test, and a line edit.
    struct Dark {
        VirtualClock clock;
        RobotSession session{clock};
        StopKeys keys{session, clock};
        SessionState state;
        QList<int> passed;  ///< key events that reached the line edit
        class Line : public QLineEdit {
        public:
            explicit Line(QList<int>& passed) : passed_(passed) {}

        protected:
            void keyPressEvent(QKeyEvent* event) override {
                if (event->key() == Qt::Key_Escape) {
                    passed_.append(event->key());
                    event->accept();
                    return;
                }
                QLineEdit::keyPressEvent(event);
            }

        private:
            QList<int>& passed_;
        } edit{passed};

        Dark() {
            state.sequence = 1;
            state.control = ControlState::InControl;
            edit.show();
            edit.activateWindow();
            if (!QTest::qWaitForWindowActive(&edit)) {
                qFatal("the window did not become active");
            }
            edit.setFocus();
        }
        void tell(LinkState link, bool moving) {
            state.link = link;
            state.moving = moving;
            Q_EMIT session.stateChanged(state);
        }
        void press(Qt::Key key) { QTest::keyClick(&edit, key); }
    };

private Q_SLOTS:
    void escapeAndSpaceStopWhateverHasTheFocus() {
        Scene s;
        for (QWidget* focus : {static_cast<QWidget*>(s.edit), static_cast<QWidget*>(s.button), &s.window}) {
            focus->setFocus();
            s.stops.clear();
            QTest::keyClick(focus, Qt::Key_Escape);
            QCOMPARE(s.stops, QList<StopCause>{StopCause::Escape});
            s.stops.clear();
            QTest::keyClick(focus, Qt::Key_Space);
            QCOMPARE(s.stops, QList<StopCause>{StopCause::Space});
        }
    }
    void spaceDoesNotPressAButtonWhileMoving() {
        Scene s;
        QSignalSpy clicked(s.button, &QPushButton::clicked);
        s.button->setFocus();
        QTest::keyClick(s.button, Qt::Key_Space);
        QCOMPARE(clicked.count(), 0);
    }
    void spaceStopsAndWritesASpaceWhenNothingMoves() {
        Scene s;
        s.use = StopKeys::Use::StopAndControl;
        s.edit->setFocus();
        QTest::keyClicks(s.edit, QStringLiteral("above tray"));
        QCOMPARE(s.edit->text(), QStringLiteral("above tray"));
        QVERIFY(s.stops.contains(StopCause::Space));
    }
    void keysOfTheFocusedControlDoNotStop() {
        Scene s;
        s.use = StopKeys::Use::Control;
        QSignalSpy clicked(s.button, &QPushButton::clicked);
        s.edit->setFocus();
        QTest::keyClicks(s.edit, QStringLiteral("above tray"));
        QTest::keyClick(s.edit, Qt::Key_Escape);
        QCOMPARE(s.edit->text(), QStringLiteral("above tray"));
        s.button->setFocus();
        QTest::keyClick(s.button, Qt::Key_Space);
        QCOMPARE(clicked.count(), 1);
        QVERIFY(s.stops.isEmpty());
    }
    // A window manager may leave the keyboard focus in the window that the dialog blocks. Qt then discards
    // the key events of that window.
    void aBlockedWindowStops_data() {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<Qt::KeyboardModifier>("modifier");
        QTest::addColumn<Qt::WindowModality>("modality");
        for (const Qt::WindowModality modality : {Qt::WindowModal, Qt::ApplicationModal}) {
            for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Escape}) {
                for (const Qt::KeyboardModifier modifier :
                     {Qt::NoModifier, Qt::ShiftModifier, Qt::AltModifier}) {
                    QTest::addRow("%x %x %d", key, modifier, modality) << key << modifier << modality;
                }
            }
        }
    }
    void aBlockedWindowStops() {
        QFETCH(Qt::Key, key);
        QFETCH(Qt::KeyboardModifier, modifier);
        QFETCH(Qt::WindowModality, modality);
        const QList<StopCause> one{key == Qt::Key_Space ? StopCause::Space : StopCause::Escape};
        Scene s;
        QDialog dialog(&s.window);
        auto* field = new QLineEdit(&dialog);
        dialog.setWindowModality(modality);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        field->setFocus();
        QTest::keyClick(dialog.windowHandle(), key, modifier);
        QCOMPARE(s.stops, one);
        QVERIFY(dialog.isVisible() && field->text().isEmpty());

        s.window.activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(s.window.isActiveWindow(), 60'000);
        for (const StopKeys::Use use : {StopKeys::Use::StopOnly, StopKeys::Use::StopAndControl}) {
            s.use = use;
            s.stops.clear();
            QTest::keyClick(s.window.windowHandle(), key, modifier);
            QCOMPARE(s.stops, one);
        }
        s.use = StopKeys::Use::Control;
        s.stops.clear();
        QTest::keyClick(s.window.windowHandle(), key, modifier);
        QVERIFY(s.stops.isEmpty());
        QVERIFY(dialog.isVisible());
    }
    // The upper dialog blocks the main window and the lower dialog. After it has closed, the lower dialog
    // blocks the main window.
    void aBlockedWindowStopsBelowTwoDialogs() {
        Scene s;
        QDialog lower(&s.window);
        lower.open();
        QVERIFY(QTest::qWaitForWindowActive(&lower));
        auto upper = std::make_unique<QDialog>(&lower);
        upper->open();
        QVERIFY(QTest::qWaitForWindowActive(upper.get()));
        for (QWidget* blocked : {static_cast<QWidget*>(&s.window), static_cast<QWidget*>(&lower)}) {
            blocked->activateWindow();
            QTRY_VERIFY_WITH_TIMEOUT(blocked->isActiveWindow(), 60'000);
            s.stops.clear();
            QTest::keyClick(blocked->windowHandle(), Qt::Key_Space);
            QCOMPARE(s.stops, QList<StopCause>{StopCause::Space});
        }
        upper.reset();
        s.window.activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(s.window.isActiveWindow(), 60'000);
        s.stops.clear();
        QTest::keyClick(s.window.windowHandle(), Qt::Key_Escape);
        QCOMPARE(s.stops, QList<StopCause>{StopCause::Escape});
    }
    void aDialogGetsItsKeysWhenNothingNeedsStopping() {
        Scene s;
        s.use = StopKeys::Use::Control;
        QDialog dialog(&s.window);
        auto* field = new QLineEdit(&dialog);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        field->setFocus();
        QTest::keyClick(dialog.windowHandle(), Qt::Key_Space);
        QCOMPARE(field->text(), QStringLiteral(" "));
        QTest::keyClick(dialog.windowHandle(), Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QVERIFY(s.stops.isEmpty());
    }
    void inputMethodsDoNotConsumeTheStopKeys() {
        Scene s;
        const auto enabled = [&s] {
            QInputMethodQueryEvent query(Qt::ImEnabled | Qt::ImHints);
            QApplication::sendEvent(s.edit, &query);
            return query.value(Qt::ImEnabled).toBool();
        };
        QVERIFY(!enabled());
        s.use = StopKeys::Use::StopAndControl;
        QVERIFY(enabled());
        s.use = StopKeys::Use::Control;
        QVERIFY(enabled());
    }
    void nativeDialogsAreNotUsed() {
        Scene s;
        QVERIFY(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
    }
    void spaceStopsAndWritesNothingWhileMoving() {
        Scene s;
        s.edit->setFocus();
        QTest::keyClicks(s.edit, QStringLiteral("a b"));
        QCOMPARE(s.edit->text(), QStringLiteral("ab"));
        QCOMPARE(s.stops, QList<StopCause>{StopCause::Space});
    }
    void stopIsSentEvenWhenNoMotionIsReported() {
        Scene s;
        s.use = StopKeys::Use::StopAndControl;
        QTest::keyClick(s.button, Qt::Key_Escape);
        QVERIFY(s.stops.contains(StopCause::Escape));
    }
    void spaceWithinASecondAfterAMotionPressesNothing() {
        VirtualClock clock;
        RobotSession session(clock);
        StopKeys keys(session, clock);
        QPushButton button;
        button.show();
        button.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&button));
        button.setFocus();
        QSignalSpy clicked(&button, &QPushButton::clicked);
        const auto tell = [&session](bool moving) {
            SessionState state;
            state.control = ControlState::InControl;
            state.moving = moving;
            Q_EMIT session.stateChanged(state);
        };
        tell(true);
        tell(false);
        clock.advanceNs(999 * kNsPerMs);
        tell(false);
        QTest::keyClick(&button, Qt::Key_Space);
        QCOMPARE(clicked.count(), 0);
        clock.advanceNs(2 * kNsPerMs);
        QTest::keyClick(&button, Qt::Key_Space);
        QCOMPARE(clicked.count(), 1);
    }
    // The palette can be closed, and a name can be typed, while the robot is switched off.
    void withoutDataKeysWorkNormallyWhenNothingMoved() {
        Dark s;
        s.tell(LinkState::Live, false);
        s.clock.advanceNs(2 * kNsPerSecond);
        s.tell(LinkState::Stale, false);
        s.tell(LinkState::Lost, false);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{Qt::Key_Escape});
        QTest::keyClicks(&s.edit, QStringLiteral("a b"));
        QCOMPARE(s.edit.text(), QStringLiteral("a b"));
    }
    void withoutDataTheFirstKeyStopsWhenSomethingMoved() {
        Dark s;
        s.tell(LinkState::Live, true);
        s.tell(LinkState::Stale, true);
        s.clock.advanceNs(10 * kNsPerSecond);  // the state is still unknown
        s.tell(LinkState::Lost, true);
        s.press(Qt::Key_Escape);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{});
        QTest::keyClicks(&s.edit, QStringLiteral("a b"));
        QCOMPARE(s.edit.text(), QStringLiteral("ab"));
        s.clock.advanceNs(1001 * kNsPerMs);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{Qt::Key_Escape});
    }
    // An operator who only monitors a robot must not stop a production program by typing.
    void aForeignProgramContinuesWhileMonitoring() {
        for (const ControlState control : {ControlState::None, ControlState::Refused}) {
            Dark s;
            s.state.control = control;
            s.state.runtimeState = RuntimeState::Playing;
            for (const LinkState link : {LinkState::Live, LinkState::Stale, LinkState::Lost}) {
                s.tell(link, true);
                s.edit.clear();
                QTest::keyClicks(&s.edit, QStringLiteral("a b"));
                QCOMPARE(s.edit.text(), QStringLiteral("a b"));
                s.press(Qt::Key_Escape);
            }
            QCOMPARE(s.passed.size(), 3);
        }
    }
    // Another program takes over while the operator is about to press a key that was a stop key until the
    // takeover.
    void theKeysStopForThreeSecondsAfterControlWasLost() {
        Dark s;
        s.state.runtimeState = RuntimeState::Playing;
        s.tell(LinkState::Live, false);
        s.clock.advanceNs(5 * kNsPerSecond);
        s.state.control = ControlState::None;
        s.state.controlLoss = control::ControlLoss::ScriptStopped;
        s.tell(LinkState::Live, true);
        s.clock.advanceNs(2900 * kNsPerMs);
        s.tell(LinkState::Live, true);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{});
        s.clock.advanceNs(101 * kNsPerMs);
        s.tell(LinkState::Live, true);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{Qt::Key_Escape});
    }
    void theKeysDoNotStopAfterControlWasReleased() {
        Dark s;
        s.tell(LinkState::Live, true);
        s.state.control = ControlState::None;
        s.state.controlLoss = control::ControlLoss::Released;
        s.state.runtimeState = RuntimeState::Playing;
        s.tell(LinkState::Live, true);
        s.press(Qt::Key_Escape);
        QCOMPARE(s.passed, QList<int>{Qt::Key_Escape});
    }
    // Auto-repeats of a key press that stopped the arm must not reach the focused widget, even after the
    // motion has ended.
    void repeatsOfAStopKeyAreIgnored() {
        Scene s;
        QTest::keyPress(s.edit, Qt::Key_Space);
        s.use = StopKeys::Use::StopAndControl;
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), true);
        QApplication::sendEvent(s.edit, &repeat);
        QVERIFY(s.edit->text().isEmpty());
        QCOMPARE(s.stops.size(), 1);
    }
    void autoRepeatIsIgnored() {
        Scene s;
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(s.button, &repeat);
        QVERIFY(s.stops.isEmpty());
    }
};

QTEST_MAIN(TestStopKeys)
#include "tst_stop_keys.moc"
