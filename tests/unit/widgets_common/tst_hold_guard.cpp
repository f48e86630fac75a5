// SPDX-License-Identifier: GPL-3.0-or-later
// Every stop rule of the jog contract that a key can see, with real events, in virtual time.
#include <QApplication>
#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QWheelEvent>
#include <memory>

#include "robot/core/clock.h"
#include "widgets/common/hold_button.h"

using namespace tiller;
using control::StopCause;

Q_DECLARE_METATYPE(tiller::control::StopCause)

namespace {

/// Stands for the session: counts what it is told.
struct FakeTarget {
    std::uint64_t next = 0;
    std::uint64_t running = 0;  // 0 = nothing moves
    int begun = 0;
    int holds = 0;
    QList<StopCause> ends;
    bool refuse = false;
    bool bounded = false;

    HoldMotion motion() {
        return {.begin = [this]() -> Result<HoldMotion::Id> {
                    if (refuse) {
                        return Error{ErrorCode::NotInControl, QStringLiteral("jog"), {}};
                    }
                    ++begun;
                    running = ++next;
                    return running;
                },
                .hold =
                    [this](HoldMotion::Id id) {
                        ++holds;
                        return id == running;
                    },
                .end =
                    [this](HoldMotion::Id id, StopCause cause) {
                        if (id == running) {
                            running = 0;
                        }
                        ends.append(cause);
                    },
                .runsToEnd = [this] { return bounded; }};
    }
};

}  // namespace

class TestHoldGuard : public QObject {
    Q_OBJECT

private:
    struct Scene {
        VirtualClock clock;
        FakeTarget target;
        FakeTarget otherTarget;
        QWidget window;
        HoldButton* key;
        HoldButton* other;
        QLineEdit* edit;
        QPushButton* button;

        Scene() {
            auto* layout = new QHBoxLayout(&window);
            layout->setContentsMargins(60, 60, 60, 60);
            key = new HoldButton(QStringLiteral("X+"), &window);
            other = new HoldButton(QStringLiteral("Y+"), &window);
            edit = new QLineEdit(&window);
            button = new QPushButton(QStringLiteral("Teach"), &window);
            for (QWidget* w : {static_cast<QWidget*>(key), static_cast<QWidget*>(other),
                               static_cast<QWidget*>(edit), static_cast<QWidget*>(button)}) {
                w->setFixedSize(80, 60);
                layout->addWidget(w);
            }
            for (auto [k, t] : {std::pair{key, &target}, std::pair{other, &otherTarget}}) {
                k->guard().setClock(clock);
                k->setMotion(t->motion());
            }
            window.show();
            window.activateWindow();
            if (!QTest::qWaitForWindowActive(&window)) {
                qFatal("the window did not become active");
            }
        }
        void press() { QTest::mousePress(key, Qt::LeftButton, {}, QPoint(40, 30)); }
        void release() { QTest::mouseRelease(key, Qt::LeftButton, {}, QPoint(40, 30)); }
        void expectStopped(StopCause cause) {
            QCOMPARE(target.ends, QList<StopCause>{cause});
            QVERIFY(!key->isHolding());
            QVERIFY(!key->isDown());
            // It stays stopped, whatever the finger still does.
            const int holds = target.holds;
            clock.advanceNs(20 * kNsPerMs);
            key->guard().pump();
            QTest::mouseMove(key, QPoint(41, 31));
            QCOMPARE(target.holds, holds);
            QCOMPARE(target.begun, 1);
            release();
            QCOMPARE(target.begun, 1);
            QCOMPARE(target.ends.size(), 1);
        }
        void expectNewPressMoves() {
            window.activateWindow();
            press();
            QCOMPARE(target.begun, 2);
            release();
        }
    };

private Q_SLOTS:
    void pressBeginsAndReleaseEnds() {
        Scene s;
        s.press();
        QCOMPARE(s.target.begun, 1);
        QVERIFY(s.key->isDown());
        s.release();
        s.expectStopped(StopCause::Released);
        s.expectNewPressMoves();
    }

    void motionIsRefreshedEveryTwentyMilliseconds() {
        Scene s;
        s.press();
        for (int i = 0; i < 5; ++i) {
            s.clock.advanceNs(HoldGuard::kRefreshMs * kNsPerMs);
            s.key->guard().pump();
        }
        QVERIFY(s.target.holds >= 5);
        QCOMPARE(HoldGuard::kRefreshMs, 20);
        s.release();
    }

    void theTimerRefreshesWithoutHelp() {
        Scene s;
        s.press();
        QTRY_VERIFY(s.target.holds >= 3);
        s.release();
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::Released});
    }

    void pointerWithinThirtyPixelsKeepsMoving() {
        Scene s;
        s.press();
        QTest::mouseMove(s.key, QPoint(-30, 30));
        QTest::mouseMove(s.key, QPoint(40, -30));
        QTest::mouseMove(s.key, QPoint(s.key->width() + 29, s.key->height() + 29));
        QVERIFY(s.key->isHolding());
        s.release();
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::Released});
    }

    void pointerBeyondThirtyPixelsStops_data() {
        QTest::addColumn<QPoint>("place");
        QTest::newRow("left") << QPoint(-31, 30);
        QTest::newRow("above") << QPoint(40, -31);
        QTest::newRow("right") << QPoint(80 + 30, 30);
        QTest::newRow("below") << QPoint(40, 60 + 30);
    }
    void pointerBeyondThirtyPixelsStops() {
        QFETCH(QPoint, place);
        Scene s;
        s.press();
        QTest::mouseMove(s.key, place);
        QTest::mouseMove(s.key, QPoint(40, 30));  // coming back does not resume
        s.expectStopped(StopCause::PointerLeft);
        s.expectNewPressMoves();
    }

    void focusToAnotherWidgetStops() {
        Scene s;
        s.press();
        s.edit->setFocus();
        s.expectStopped(StopCause::FocusLost);
        s.expectNewPressMoves();
    }

    void tabKeyStops() {
        Scene s;
        s.press();
        QTest::keyClick(s.key, Qt::Key_Tab);
        s.expectStopped(StopCause::FocusLost);
    }

    void anotherWindowStops() {
        Scene s;
        s.press();
        QWidget second;
        second.show();
        second.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&second));
        s.expectStopped(StopCause::DialogOpened);  // showing it is enough
    }

    void deactivatedWindowStops() {
        QWidget second;
        second.show();
        Scene s;
        s.press();
        second.activateWindow();
        QTRY_VERIFY(!s.target.ends.isEmpty());
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void minimisedWindowStops() {
        Scene s;
        s.press();
        s.window.showMinimized();
        QTRY_VERIFY(!s.target.ends.isEmpty());
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void hiddenWindowStops() {
        Scene s;
        s.press();
        s.window.hide();
        s.expectStopped(StopCause::WindowClosed);
    }

    void closedWindowStops() {
        Scene s;
        s.press();
        s.window.close();
        s.expectStopped(StopCause::WindowClosed);
    }

    void destroyedKeyStops() {
        Scene s;
        s.press();
        delete s.key;
        QCOMPARE(s.target.ends.size(), 1);
        QCOMPARE(s.target.running, 0U);
    }

    void anotherTabStops() {
        VirtualClock clock;
        FakeTarget target;
        QTabWidget tabs;
        auto* key = new HoldButton(QStringLiteral("X+"));
        key->guard().setClock(clock);
        key->setMotion(target.motion());
        tabs.addTab(key, QStringLiteral("one"));
        tabs.addTab(new QWidget, QStringLiteral("two"));
        tabs.show();
        QVERIFY(QTest::qWaitForWindowActive(&tabs));
        QTest::mousePress(key, Qt::LeftButton);
        QCOMPARE(target.begun, 1);
        tabs.setCurrentIndex(1);
        QCOMPARE(target.ends.size(), 1);
        QVERIFY(!key->isHolding());
    }

    void hiddenKeyStops() {
        Scene s;
        s.press();
        s.key->hide();
        s.expectStopped(StopCause::SelectionChanged);
    }

    void modalDialogStops() {
        Scene s;
        s.press();
        QDialog dialog(&s.window);
        dialog.setModal(true);
        dialog.show();
        s.expectStopped(StopCause::DialogOpened);
    }

    void modelessDialogStops() {
        Scene s;
        s.press();
        QDialog dialog(&s.window);
        dialog.show();
        s.expectStopped(StopCause::DialogOpened);
    }

    void menuStops() {
        Scene s;
        s.press();
        QMenu menu;
        menu.addAction(QStringLiteral("one"));
        menu.popup(s.window.mapToGlobal(QPoint(0, 0)));
        s.expectStopped(StopCause::DialogOpened);
    }

    void tooltipDoesNotStop() {
        Scene s;
        s.press();
        QWidget tip(&s.window, Qt::ToolTip);
        tip.show();
        QVERIFY(s.key->isHolding());
        s.release();
        s.expectStopped(StopCause::Released);
    }

    void changedSelectionStops() {
        Scene s;
        s.press();
        s.key->guard().stop(StopCause::SelectionChanged);
        s.expectStopped(StopCause::SelectionChanged);
    }

    void secondMouseButtonStops_data() {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::newRow("right") << Qt::RightButton;
        QTest::newRow("middle") << Qt::MiddleButton;
        QTest::newRow("back") << Qt::BackButton;
    }
    void secondMouseButtonStops() {
        QFETCH(Qt::MouseButton, button);
        Scene s;
        s.press();
        QTest::mousePress(s.key, button, {}, QPoint(40, 30));
        QTest::mouseRelease(s.key, button, {}, QPoint(40, 30));
        s.expectStopped(StopCause::SecondButton);
        s.expectNewPressMoves();
    }

    void otherButtonsNeverMove() {
        Scene s;
        for (const auto button : {Qt::RightButton, Qt::MiddleButton, Qt::BackButton}) {
            QTest::mousePress(s.key, button);
            QTest::mouseRelease(s.key, button);
        }
        QCOMPARE(s.target.begun, 0);
    }

    void pressOnAnotherKeyStopsAndMovesNothing() {
        Scene s;
        s.press();
        QTest::mousePress(s.other, Qt::LeftButton);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::SecondButton});
        QCOMPARE(s.otherTarget.begun, 0);
        QTest::mouseRelease(s.other, Qt::LeftButton);
        QTest::mousePress(s.other, Qt::LeftButton);
        QCOMPARE(s.otherTarget.begun, 1);
        QTest::mouseRelease(s.other, Qt::LeftButton);
    }

    void escapeStops() {
        Scene s;
        s.press();
        QTest::keyPress(s.key, Qt::Key_Escape);
        s.expectStopped(StopCause::Escape);
        s.expectNewPressMoves();
    }

    void spaceStopsAndNeverPressesAKey() {
        Scene s;
        s.press();
        QTest::keyPress(s.key, Qt::Key_Space);
        QTest::keyRelease(s.key, Qt::Key_Space);
        s.expectStopped(StopCause::Space);
        for (const auto key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Select}) {
            QTest::keyClick(s.key, key);
        }
        QCOMPARE(s.target.begun, 1);
    }

    void keyboardAutoRepeatIsIgnored() {
        Scene s;
        s.press();
        for (const auto key : {Qt::Key_X, Qt::Key_Right, Qt::Key_Escape}) {
            QKeyEvent repeat(QEvent::KeyPress, key, Qt::NoModifier, QString(), true);
            QApplication::sendEvent(s.key, &repeat);
        }
        QVERIFY(s.key->isHolding());
        s.release();
        s.expectStopped(StopCause::Released);
    }

    void wheelNeverMoves() {
        Scene s;
        for (const int delta : {120, -120}) {
            QWheelEvent wheel(QPointF(40, 30), s.key->mapToGlobal(QPointF(40, 30)), QPoint(),
                              QPoint(0, delta), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(s.key, &wheel);
        }
        QCOMPARE(s.target.begun, 0);
    }

    void disabledKeyStops() {
        Scene s;
        s.press();
        s.key->setUnavailable(QStringLiteral("Protective stop"));
        s.expectStopped(StopCause::ControlLost);
        QCOMPARE(s.key->toolTip(), QStringLiteral("Protective stop"));
        s.press();
        QCOMPARE(s.target.begun, 1);
        s.release();
        s.key->setUnavailable({});
        s.expectNewPressMoves();
    }

    void disabledParentStops() {
        Scene s;
        s.press();
        s.window.setEnabled(false);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::ControlLost});
    }

    void inactiveApplicationStops() {
        Scene s;
        s.press();
        Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
        s.expectStopped(StopCause::WindowDeactivated);
    }

    void droppedMotionNeedsANewPress() {
        Scene s;
        QSignalSpy ended(&s.key->guard(), &HoldGuard::ended);
        s.press();
        s.target.running = 0;  // the session stopped it
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QVERIFY(!s.key->isHolding());
        QVERIFY(s.target.ends.isEmpty());  // nothing left to end
        QCOMPARE(ended.count(), 1);
        const int holds = s.target.holds;
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QCOMPARE(s.target.holds, holds);
        s.release();
        QCOMPARE(s.target.begun, 1);
        s.expectNewPressMoves();
    }

    void stalledEventLoopStops() {
        Scene s;
        s.press();
        s.clock.advanceNs(100 * kNsPerMs);
        s.key->guard().pump();
        QVERIFY(s.key->isHolding());
        s.clock.advanceNs(101 * kNsPerMs);
        s.key->guard().pump();
        s.expectStopped(StopCause::EventLoopStalled);
    }

    void refusedPressSaysWhyAndMovesNothing() {
        Scene s;
        s.target.refuse = true;
        QSignalSpy refused(&s.key->guard(), &HoldGuard::refused);
        s.press();
        QCOMPARE(refused.count(), 1);
        QCOMPARE(refused.first().first().value<Error>().code, ErrorCode::NotInControl);
        QVERIFY(!s.key->isDown());
        s.target.refuse = false;
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QTest::mouseMove(s.key, QPoint(42, 30));
        QCOMPARE(s.target.begun, 0);  // a refused press does not turn into a motion later
        s.release();
    }

    void lostReleaseStops() {
        Scene s;
        s.press();
        QMouseEvent move(QEvent::MouseMove, QPointF(40, 30), s.key->mapToGlobal(QPointF(40, 30)),
                         Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(s.key, &move);
        s.expectStopped(StopCause::Released);
    }

    void boundedStepRunsOnAfterRelease() {
        Scene s;
        s.target.bounded = true;
        s.press();
        s.release();
        QVERIFY(s.key->isHolding());
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QVERIFY(s.target.holds >= 1);
        QVERIFY(s.target.ends.isEmpty());
        s.target.running = 0;  // arrived
        s.key->guard().pump();
        QVERIFY(!s.key->isHolding());
        QCOMPARE(s.target.begun, 1);
    }

    void boundedStepObeysEveryOtherRule() {
        for (int rule = 0; rule < 4; ++rule) {
            Scene s;
            s.target.bounded = true;
            s.press();
            s.release();
            QVERIFY(s.key->isHolding());
            if (rule == 0) {
                QTest::keyPress(s.key, Qt::Key_Escape);
            } else if (rule == 1) {
                s.edit->setFocus();
            } else if (rule == 2) {
                QTest::mousePress(s.button, Qt::RightButton);
                QTest::mouseRelease(s.button, Qt::RightButton);
            } else {
                s.press();  // the same key again: nothing is queued
            }
            QVERIFY(!s.key->isHolding());
            QCOMPARE(s.target.ends.size(), 1);
            QCOMPARE(s.target.begun, 1);
        }
    }

    void oneTouchPointMovesAndASecondStops() {
        Scene s;
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        QTest::touchEvent(&s.window, screen.get()).press(0, QPoint(40, 30), s.key);
        QCOMPARE(s.target.begun, 1);
        QTest::touchEvent(&s.window, screen.get()).stationary(0).press(1, QPoint(20, 20), s.key);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::SecondButton});
        QTest::touchEvent(&s.window, screen.get())
            .release(0, QPoint(40, 30), s.key)
            .release(1, QPoint(20, 20), s.key);
        QCOMPARE(s.target.begun, 1);
        QTest::touchEvent(&s.window, screen.get()).press(2, QPoint(40, 30), s.key);
        QCOMPARE(s.target.begun, 2);
        QTest::touchEvent(&s.window, screen.get()).release(2, QPoint(40, 30), s.key);
        QCOMPARE(s.target.ends.last(), StopCause::Released);
    }

    void secondTouchOnAnotherKeyStopsAndMovesNothing() {
        Scene s;
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        QTest::touchEvent(&s.window, screen.get()).press(0, QPoint(40, 30), s.key);
        QCOMPARE(s.target.begun, 1);
        QTest::touchEvent(&s.window, screen.get()).stationary(0).press(1, QPoint(40, 30), s.other);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::SecondButton});
        QCOMPARE(s.otherTarget.begun, 0);
        QTest::touchEvent(&s.window, screen.get())
            .release(0, QPoint(40, 30), s.key)
            .release(1, QPoint(40, 30), s.other);
        QCOMPARE(s.otherTarget.begun, 0);
    }
};

QTEST_MAIN(TestHoldGuard)
#include "tst_hold_guard.moc"
