// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of jog inputs other than the buttons of the pad: the targets of their motions and the operator input
// that they require. Uses the real window, real events and real sockets, with the simulated robot in virtual
// time.

#include <QLineEdit>
#include <QTest>

#include "tests/support/jog_window_test.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_selectors.h"

using namespace tiller;
using namespace tiller::test;

class TestJogBehaviour : public JogWindowTest {
    Q_OBJECT

private Q_SLOTS:
    void backFollowsThePathToItsStart() {
        window().jogColumn().selectors().setSpeedClass(3);
        const Pose start = cell().truth().tcpPose;
        jog("jog.Z+", 1200);
        const Pose corner = cell().truth().tcpPose;
        jog("jog.Y+", 1200);
        QVERIFY(distanceMm(start, corner) > 80 && distanceMm(corner, cell().truth().tcpPose) > 80);
        press(key("backKey"));
        double nearest = 1e9;
        QVERIFY(cell().advanceUntil(
            [&] {
                nearest = std::min(nearest, distanceMm(corner, cell().truth().tcpPose));
                return !key("backKey").isHolding();
            },
            20'000));
        release(key("backKey"));
        QVERIFY2(nearest < 12, qPrintable(QString::number(nearest)));
        QVERIFY(timeToStandstill(cell()) >= 0);
        QVERIFY2(distanceMm(start, cell().truth().tcpPose) < 3,
                 qPrintable(QString::number(distanceMm(start, cell().truth().tcpPose))));
        cell().advanceMs(60);
        QVERIFY2(!key("backKey").isEnabled(), "Back is still enabled at the start of the path");
    }

    void alignTurnsTheToolToTheNearestAxis() {
        jog("jog.Rx+", 1500);
        const Pose before = cell().truth().tcpPose;
        press(key("alignKey"));
        QVERIFY(cell().advanceUntil([&] { return !key("alignKey").isHolding(); }, 20'000));
        release(key("alignKey"));
        const Pose after = cell().truth().tcpPose;
        const Eigen::Vector3d z = rotationMatrix(after.rotation).col(2);
        QVERIFY2(z.cwiseAbs().maxCoeff() > 0.99999,
                 qPrintable(QString::number(z.cwiseAbs().maxCoeff(), 'g', 8)));
        QVERIFY(distanceMm(before, after) < 0.1);
    }

    void aTouchEndsTheMotionUntilContact() {
        window().jogColumn().selectors().setUntilContact(15);
        press(key("jog.Z-"));
        cell().advanceMs(600);
        QVERIFY(std::abs(tcpSpeed(cell()) - 0.020) < 0.002);
        const Pose at = cell().truth().tcpPose;
        cell().robot.pressHand(Wrench::fromVector((Vector6() << 0, 0, 25, 0, 0, 0).finished()));
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        QVERIFY2(distanceMm(at, cell().truth().tcpPose) < 1.0,
                 "the arm moved more than 1 mm after the contact");
        cell().advanceMs(400);
        QCOMPARE(window().session().state().lastStop.cause, control::StopCause::Contact);
        QVERIFY2(!key("jog.Z-").isHolding(), "the button still holds a motion after the contact");
    }

    void severalAxesAreNoFasterThanOne() {
        window().jogColumn().selectors().setSpeedClass(2);
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(40);
        QTest::keyPress(&window(), Qt::Key_Up);
        cell().advanceMs(500);
        const Eigen::Vector3d v = cell().truth().tcpSpeed.linear;
        QVERIFY(v.x() > 0.03 && v.y() > 0.03 && std::abs(v.z()) < 0.002);
        QVERIFY(v.norm() < 0.0505);
        QTest::keyRelease(&window(), Qt::Key_Up);
        cell().advanceMs(500);
        QVERIFY2(std::abs(cell().truth().tcpSpeed.linear.y()) < 0.002,
                 "the axis of the released key still moves");
        QVERIFY(cell().truth().tcpSpeed.linear.x() > 0.045);
        QTest::keyRelease(&window(), Qt::Key_Right);
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void armedKeysMakeOneStepForEachPress() {
        window().jogColumn().selectors().setFreeStep({0.001, toRadians(1)});
        keyboard().setArmed(true);
        const auto movedMm = [this](const auto& action) {
            const Pose from = cell().truth().tcpPose;
            action();
            cell().advanceMs(1500);
            return distanceMm(from, cell().truth().tcpPose);
        };
        const auto tap = [this](Qt::Key one) {
            QTest::keyPress(&window(), one);
            cell().advanceMs(40);
            QTest::keyRelease(&window(), one);
        };
        QVERIFY(std::abs(movedMm([&] { tap(Qt::Key_Right); }) - 1) < 0.05);
        QVERIFY(std::abs(movedMm([&] { QTest::keyPress(&window(), Qt::Key_Up); }) - 1) < 0.05);
        // The arm does not move again while the key is held, even after the motion type changes to "Hold".
        bench_->find<SegmentedControl>("jogMotion").setCurrentIndex(0);
        QVERIFY(movedMm([&] {}) < 0.01);
        QVERIFY(movedMm([&] { QTest::keyRelease(&window(), Qt::Key_Up); }) < 0.01);
        window().jogColumn().selectors().setFreeStep({0.001, toRadians(1)});
        // Two directions together are not a step.
        QVERIFY(movedMm([&] {
                    QTest::keyPress(&window(), Qt::Key_Right);
                    cell().advanceMs(1500);
                    QTest::keyPress(&window(), Qt::Key_PageUp);
                    QTest::keyRelease(&window(), Qt::Key_Right);
                    cell().advanceMs(200);
                    QTest::keyRelease(&window(), Qt::Key_PageUp);
                }) < 1.05);
        const double joint = cell().truth().q[5];
        QTest::keyPress(&window(), Qt::Key_6);
        tap(Qt::Key_Plus);
        cell().advanceMs(1500);
        QVERIFY(std::abs(toDegrees(cell().truth().q[5] - joint) - 1) < 0.02);
        QTest::keyRelease(&window(), Qt::Key_6);
        cell().advanceMs(500);
        QVERIFY(std::abs(toDegrees(cell().truth().q[5] - joint) - 1) < 0.02);
    }

    void aLongStepByKeyEndsAtTheRelease() {
        window().jogColumn().selectors().setFreeStep({0.05, toRadians(45)});
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(400);
        QVERIFY(!standsStill(cell()));
        QTest::keyRelease(&window(), Qt::Key_Right);
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
    }

    void theKeyboardMovesOnlyWhileArmedAndDisarmsByItself() {
        QTest::keyPress(&window(), Qt::Key_PageUp);
        cell().advanceMs(200);
        QVERIFY(standsStill(cell()));
        QTest::keyRelease(&window(), Qt::Key_PageUp);
        keyboard().setArmed(true);
        QVERIFY(window().findChild<QWidget*>("armedFrame")->isVisible());
        // An auto-repeat event is not a press.
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_PageUp, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(&window(), &repeat);
        cell().advanceMs(200);
        QVERIFY(standsStill(cell()));
        cell().clock.advanceNs((KeyboardJog::kIdleSeconds - 1) * kNsPerSecond);
        keyboard().checkIdle();
        QVERIFY(keyboard().isArmed());
        cell().clock.advanceNs(2 * kNsPerSecond);
        keyboard().checkIdle();
        QVERIFY(!keyboard().isArmed());
    }

    void focusInATextFieldEndsKeyHolds() {
        QLineEdit text(&window());
        text.show();
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        text.setFocus(Qt::TabFocusReason);
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        cell().advanceMs(100);
        QCOMPARE(window().session().state().lastStop.cause, control::StopCause::FocusLost);
        QTest::keyRelease(&text, Qt::Key_Right);
        QVERIFY2(!keyboard().isArmed(), "the keys belong to the field");
        text.clearFocus();
        keyboard().setArmed(true);
        QTest::keyPress(&window(), Qt::Key_Right);
        cell().advanceMs(300);
        QVERIFY2(!standsStill(cell()), "a new press did not move the arm");
        QTest::keyRelease(&window(), Qt::Key_Right);
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void aStickMustReturnToNeutral() {
        bench_->device = tilted();
        cell().advanceMs(200);
        QVERIFY(!standsStill(cell()));
        QTest::keyPress(&window(), Qt::Key_Escape);
        QVERIFY(timeToStandstill(cell()) >= 0);
        // While the stick is deflected, releasing and pressing the enabling button again is not sufficient.
        bench_->device->deadMan = false;
        cell().advanceMs(100);
        bench_->device->deadMan = true;
        cell().advanceMs(300);
        QVERIFY(standsStill(cell()));
        bench_->device = Deflection();
        cell().advanceMs(100);
        bench_->device = tilted();
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        bench_->device = Deflection();
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void aScreenPressStopsADeviceJogAndStartsNothing() {
        bench_->device = tilted();
        cell().advanceMs(200);
        press(key("jog.Y+"));
        QVERIFY(timeToStandstill(cell()) >= 0);
        cell().advanceMs(300);
        QVERIFY(standsStill(cell()));
        release(key("jog.Y+"));
        bench_->device = Deflection();
    }

    void freedriveMovesOnlyAlongTheFreeAxes() {
        window().jogColumn().setFreedriveAxes(FreedriveAxes::Line);
        const Pose before = cell().truth().tcpPose;
        press(key("freedriveKey"));
        cell().advanceMs(100);
        cell().robot.pressHand(Wrench::fromVector((Vector6() << 40, 0, 40, 0, 0, 0).finished()));
        cell().advanceMs(500);
        const Pose after = cell().truth().tcpPose;
        QVERIFY(after.position.z() - before.position.z() > 0.002);
        QVERIFY2(std::abs(after.position.x() - before.position.x()) < 0.0005,
                 qPrintable(QString::number(1e3 * (after.position.x() - before.position.x()))));
        release(key("freedriveKey"));
        QVERIFY(timeToStandstill(cell()) >= 0);
    }
};

QTEST_MAIN(TestJogBehaviour)
#include "tst_jog_behaviour.moc"
