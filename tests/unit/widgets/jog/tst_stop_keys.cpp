// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "widgets/jog/stop_keys.h"
#include "widgets/session/robot_session.h"

using namespace tiller;
using control::StopCause;

class TestStopKeys : public QObject {
    Q_OBJECT

private:
    struct Scene {
        QList<StopCause> stops;
        bool moving = true;
        StopKeys keys{[this](StopCause cause) { stops.append(cause); }, [this] { return moving; }};
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

    /// A session that tells what the test says, and a line to type in.
    struct Dark {
        VirtualClock clock;
        RobotSession session{clock};
        StopKeys keys{session, clock};
        SessionState state;
        QList<int> passed;  ///< to the line
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
    void spaceWritesASpaceWhenNothingMoves() {
        Scene s;
        s.moving = false;
        s.edit->setFocus();
        QTest::keyClicks(s.edit, QStringLiteral("above tray"));
        QCOMPARE(s.edit->text(), QStringLiteral("above tray"));
        QVERIFY(s.stops.isEmpty());
    }
    void spaceStopsAndWritesNothingWhileMoving() {
        Scene s;
        s.edit->setFocus();
        QTest::keyClicks(s.edit, QStringLiteral("a b"));
        QCOMPARE(s.edit->text(), QStringLiteral("ab"));
        QCOMPARE(s.stops, QList<StopCause>{StopCause::Space});
    }
    void stopIsSentEvenWhenNothingSeemsToMove() {
        Scene s;
        s.moving = false;
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
    // The palette can be closed and a name typed while the robot is switched off.
    void withoutDataTheKeysGoOnWhenNothingMovedBefore() {
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
    void withoutDataTheFirstStopIsAStopWhenSomethingMovedBefore() {
        Dark s;
        s.tell(LinkState::Live, true);
        s.tell(LinkState::Stale, true);
        s.clock.advanceNs(10 * kNsPerSecond);  // and still nobody knows
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
    void aProgramOfOthersMakesTheKeysStop() {
        for (const RuntimeState runtime :
             {RuntimeState::Playing, RuntimeState::Resuming, RuntimeState::Pausing}) {
            Dark s;
            s.state.runtimeState = runtime;
            s.tell(LinkState::Live, false);
            QTest::keyClicks(&s.edit, QStringLiteral("a b"));
            QCOMPARE(s.edit.text(), QStringLiteral("ab"));
        }
        Dark ours;
        ours.state.runtimeState = RuntimeState::Playing;
        ours.state.control = ControlState::InControl;
        ours.tell(LinkState::Live, false);
        QTest::keyClicks(&ours.edit, QStringLiteral("a b"));
        QCOMPARE(ours.edit.text(), QStringLiteral("a b"));
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
