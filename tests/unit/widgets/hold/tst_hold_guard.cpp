// SPDX-License-Identifier: GPL-3.0-or-later
// Every stop rule of the jog contract that a single button can detect, with real events, in virtual time.
#include <QDialog>
#include <QMenu>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabWidget>
#include <QWheelEvent>
#include <memory>

#include "tests/unit/widgets/hold/hold_scene.h"

using namespace tiller;
using namespace tiller::test;

class TestHoldGuard : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pressStartsAndReleaseEnds() {
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

    void theTimerRefreshesTheMotion() {
        Scene s;
        s.press();
        QTRY_VERIFY_WITH_TIMEOUT(s.target.holds >= 3, 60'000);
        s.release();
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::Released});
    }

    // The motion pauses in the last quarter of the maximum hold time. Pausing may take longer than the
    // remaining hold time.
    void theMotionPausesBeforeTheMaximumHoldTime_data() {
        QTest::addColumn<int>("needed");  // [s]
        QTest::addColumn<int>("end");     // [s]
        QTest::newRow("soon") << 0 << 20;
        QTest::newRow("within the limit") << 3 << 20;
        QTest::newRow("later") << 12 << 27;
    }
    void theMotionPausesBeforeTheMaximumHoldTime() {
        QFETCH(int, needed);
        QFETCH(int, end);
        Scene s;
        QList<std::int64_t> asked;
        const std::int64_t begin = s.clock.nowNs();
        HoldMotion motion = s.target.motion();
        motion.pause = [&] {
            asked << s.clock.nowNs() - begin;
            return needed * kNsPerSecond;
        };
        s.key->setMotion(motion);
        s.press();
        while (s.key->isHolding() && s.clock.nowNs() - begin < 60 * kNsPerSecond) {
            s.clock.advanceNs(HoldGuard::kRefreshMs * kNsPerMs);
            s.key->guard().pump();
        }
        QCOMPARE(asked, QList<std::int64_t>{15 * kNsPerSecond});
        QCOMPARE((s.clock.nowNs() - begin) / kNsPerSecond, end);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::HeldTooLong});
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
        QTest::mouseMove(s.key, QPoint(40, 30));  // moving back onto the button does not resume the motion
        s.expectStopped(StopCause::PointerLeft);
        s.expectNewPressMoves();
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

    // The start of the motion changes the state of the robot, and a slot disables the button. Qt does not
    // send the release to a disabled widget.
    void aButtonDisabledByItsOwnStartStops() {
        Scene s;
        HoldMotion motion = s.target.motion();
        motion.begin = [&s, begin = motion.begin] {
            s.key->setEnabled(false);
            return begin();
        };
        s.key->setMotion(motion);
        s.press();
        QCOMPARE(s.target.begun, 1);
        QVERIFY(!s.key->isHolding());
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::ControlLost});
    }

    void disabledParentStops() {
        Scene s;
        s.press();
        s.window.setEnabled(false);
        QCOMPARE(s.target.ends, QList<StopCause>{StopCause::ControlLost});
    }

    void anEndedMotionNeedsANewPress() {
        Scene s;
        QSignalSpy ended(&s.key->guard(), &HoldGuard::ended);
        s.press();
        s.target.running = 0;  // the session stopped the motion
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QVERIFY(!s.key->isHolding());
        QVERIFY(s.target.ends.isEmpty());  // there is nothing to end
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

    void refusedPressGivesTheReasonWithoutMotion() {
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
        QCOMPARE(s.target.begun, 0);  // a refused press must not start a motion later
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

    void aBoundedStepContinuesAfterRelease() {
        Scene s;
        s.target.bounded = true;
        s.press();
        s.release();
        QVERIFY(s.key->isHolding());
        s.clock.advanceNs(20 * kNsPerMs);
        s.key->guard().pump();
        QVERIFY(s.target.holds >= 1);
        QVERIFY(s.target.ends.isEmpty());
        s.target.running = 0;  // the target is reached
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
                s.press();  // the same button again: nothing is queued
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
