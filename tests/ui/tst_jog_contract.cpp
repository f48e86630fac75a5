// SPDX-License-Identifier: GPL-3.0-or-later
//
// The jog contract, line by line, with the real window, real events and real sockets, and the simulated robot
// in virtual time. The limits are those of the contract.

#include <QDialog>
#include <QTabBar>
#include <QTest>

#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Limits of the jog contract.
constexpr int kPressToMotionMs = 20;
constexpr int kReleaseToStandstillMs = 100;
constexpr int kDeathToStandstillMs = 250;
// 100 mm/s: one class above the initial speed, and the reference speed of the contract.
constexpr int kReferenceSpeedClass = 3;

}  // namespace

class TestJogContract : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    HoldToRunButton& key(const char* name = "jog.X+") { return bench_->find<HoldToRunButton>(name); }

    /// Presses a jog button and waits until the arm has reached the jog speed.
    void startJog(const char* name = "jog.X+") {
        press(key(name));
        cell().advanceMs(400);
    }
    void expectStandstillFor(int ms) {
        const Pose before = cell().truth().tcpPose;
        cell().advanceMs(ms);
        QVERIFY(distanceMm(before, cell().truth().tcpPose) < 0.05);
    }

private Q_SLOTS:
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        QVector<HoldToRunButton*> keys = bench_->window.jogColumn().holdKeys();
        keys << bench_->window.findChild<HoldToRunButton*>("waypoint.goTo");
        driveKeys(cell(), keys);
        bench_->window.jogColumn().selectors().setSpeedClass(kReferenceSpeedClass);
        cell().advanceMs(40);
    }
    void cleanup() { bench_.reset(); }

    void pressMovesTheArmAtOnce() {
        press(key());
        int ms = 0;
        while (ms < 200 && tcpSpeed(cell()) <= 0.0) {
            cell().advanceMs(2);
            ms += 2;
        }
        QVERIFY2(ms <= kPressToMotionMs, qPrintable(QString::number(ms)));
        cell().advanceMs(300);
        const Twist speed = cell().truth().tcpSpeed;
        QVERIFY2(std::abs(speed.linear.x() - 0.1) < 0.002,
                 "X+ does not move along +X of the base at 100 mm/s");
        QVERIFY(std::abs(speed.linear.y()) < 0.002 && std::abs(speed.linear.z()) < 0.002);
        release(key());
    }

    void releaseEndsInStandstill() {
        startJog();
        QVERIFY(tcpSpeed(cell()) > 0.095);
        const Pose at = cell().truth().tcpPose;
        release(key());
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        // v^2/2a at 2 m/s2, plus the distance within 20 ms of latency.
        QVERIFY(distanceMm(at, cell().truth().tcpPose) <= 2.5 + 2.0);
        expectStandstillFor(500);
    }

    void theStopIsMeasuredAndShown() {
        startJog();
        release(key());
        cell().advanceMs(400);
        const control::StopMeasurement stop = bench_->window.session().state().lastStop;
        QCOMPARE(stop.cause, control::StopCause::Released);
        QVERIFY(stop.durationMs > 10 && stop.durationMs <= kReleaseToStandstillMs);
        QVERIFY(stop.distanceMm > 0.5 && stop.distanceMm < 5.0);
    }

    void everyStopRuleEndsTheMotion_data() {
        QTest::addColumn<int>("rule");
        const char* names[] = {"pointer leaves the key",
                               "focus lost",
                               "window deactivated",
                               "window minimised",
                               "dialog opens",
                               "tab changes",
                               "frame changes",
                               "motion class changes",
                               "speed class changes",
                               "another button or key pressed",
                               "Esc",
                               "Space",
                               "key hidden"};
        int rule = 0;
        for (const char* name : names) {
            QTest::newRow(name) << rule++;
        }
    }
    void everyStopRuleEndsTheMotion() {
        QFETCH(int, rule);
        startJog();
        QVERIFY(tcpSpeed(cell()) > 0.095);
        app::MainWindow& window = bench_->window;
        QDialog dialog(&window);
        switch (rule) {
            case 0:
                sendMouse(key(), QEvent::MouseMove, Qt::LeftButton, QPointF(-40, 10));
                break;
            case 1: {
                QWidget* other = window.findChild<QTabBar*>("tabs");
                other->setFocus();
                QFocusEvent lost(QEvent::FocusOut);
                QApplication::sendEvent(&key(), &lost);
                break;
            }
            case 2: {
                QEvent deactivated(QEvent::WindowDeactivate);
                QApplication::sendEvent(&window, &deactivated);
                break;
            }
            case 3:
                window.showMinimized();
                break;
            case 4:
                dialog.open();
                break;
            case 5:
                window.showTab("io");
                break;
            case 6:
                window.findChild<SegmentedControl*>("jogFrame")->setCurrentIndex(1);
                break;
            case 7:
                window.findChild<SegmentedControl*>("jogMotion")->setCurrentIndex(1);
                break;
            case 8:
                window.jogColumn().selectors().setSpeedClass(1);
                break;
            case 9:
                sendMouse(key(), QEvent::MouseButtonPress, Qt::RightButton);
                break;
            case 10:
                QTest::keyPress(&window, Qt::Key_Escape);
                break;
            case 11:
                QTest::keyPress(&window, Qt::Key_Space);
                break;
            case 12:
                key().hide();
                break;
            default:
                QFAIL("unknown rule");
        }
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kReleaseToStandstillMs, qPrintable(QString::number(ms)));
        expectStandstillFor(500);
    }

    void aStoppedJogNeedsANewPress() {
        startJog();
        QTest::keyPress(&bench_->window, Qt::Key_Escape);
        QVERIFY(timeToStandstill(cell()) >= 0);
        // The button is still held. The arm must not move, regardless of the pointer.
        sendMouse(key(), QEvent::MouseMove, Qt::LeftButton, QPointF(20, 20));
        expectStandstillFor(1000);
        release(key());
        expectStandstillFor(200);
        startJog();
        QVERIFY(tcpSpeed(cell()) > 0.095);
        release(key());
    }

    void aHungWindowStopsTheArm() {
        startJog();
        // The user interface is blocked for two seconds. The control thread detects it.
        int ms = 0;
        while (!standsStill(cell()) && ms < 2000) {
            cell().advanceWithFrozenInterface(2);
            ms += 2;
        }
        QVERIFY2(ms <= kDeathToStandstillMs, qPrintable(QString::number(ms)));
        cell().advanceWithFrozenInterface(2000 - ms);
        // The user interface runs again and the button is still held, but the arm must not move.
        expectStandstillFor(500);
    }

    void aSilentLinkStopsTheArm() {
        startJog();
        cell().robot.silence(true);
        int ms = 0;
        while (ms < 1000 && (ms < 10 || !standsStill(cell()))) {
            cell().clock.advanceNs(2 * kNsPerMs);
            cell().robot.step();
            ms += 2;
        }
        QVERIFY2(ms <= kDeathToStandstillMs, qPrintable(QString::number(ms)));
    }

    void closingTheWindowStopsTheArm() {
        startJog();
        bench_->window.close();
        int ms = 0;
        while (ms < 1000 && !standsStill(cell())) {
            cell().clock.advanceNs(2 * kNsPerMs);
            cell().robot.step();
            ms += 2;
            QTest::qWait(1);
        }
        QVERIFY2(ms <= kDeathToStandstillMs, qPrintable(QString::number(ms)));
    }

    void sleepAndSessionLockStopTheArm_data() {
        QTest::addColumn<QByteArray>("what");
        QTest::newRow("sleep") << QByteArray("onPrepareForSleep");
        QTest::newRow("lock") << QByteArray("onLock");
        QTest::newRow("screen saver") << QByteArray("onScreenSaver");
    }
    void sleepAndSessionLockStopTheArm() {
        QFETCH(QByteArray, what);
        startJog();
        auto* watch = bench_->window.findChild<QObject*>("sleepWatch");
        QVERIFY(watch != nullptr);
        QVERIFY(what == "onLock" ? QMetaObject::invokeMethod(watch, what.constData())
                                 : QMetaObject::invokeMethod(watch, what.constData(), Q_ARG(bool, true)));
        QVERIFY(timeToStandstill(cell()) >= 0);
        // The stop is evaluated only after a period of standstill.
        expectStandstillFor(400);
        QCOMPARE(bench_->window.session().state().lastStop.cause, control::StopCause::Sleep);
    }

    void aProtectiveStopEndsTheJogPermanently() {
        startJog();
        cell().robot.protectiveStop();
        cell().advanceMs(300);
        QVERIFY(standsStill(cell()));
        QVERIFY(!bench_->window.session().state().canMove());
        QVERIFY(!bench_->window.session().state().controlReason.isEmpty());
        // No function of the application unlocks automatically.
        cell().advanceMs(7000);
        QCOMPARE(cell().truth().safetyMode, SafetyMode::ProtectiveStop);
        release(key());
        press(key());
        expectStandstillFor(300);
    }

    void onlyTheLeftButtonMovesTheArm() {
        sendMouse(key(), QEvent::MouseButtonPress, Qt::RightButton);
        expectStandstillFor(200);
        sendMouse(key(), QEvent::MouseButtonRelease, Qt::RightButton);
        QWheelEvent wheel(QPointF(10, 10), key().mapToGlobal(QPointF(10, 10)), QPoint(0, 120), QPoint(0, 120),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&key(), &wheel);
        expectStandstillFor(200);
    }

    void aStepIsOneBoundedMotion() {
        bench_->window.findChild<SegmentedControl*>("jogMotion")->setCurrentIndex(2);
        const Pose before = cell().truth().tcpPose;
        press(key());
        cell().advanceMs(60);
        release(key());
        cell().advanceMs(1500);
        const Pose after = cell().truth().tcpPose;
        QVERIFY2(std::abs(after.position.x() - before.position.x() - 0.001) < 2e-5,
                 qPrintable(QString::number(1000 * (after.position.x() - before.position.x()))));
        expectStandstillFor(300);
    }

    void releasingTheGoToKeyStopsDespiteModifiers_data() {
        QTest::addColumn<bool>("modifierFirst");
        QTest::newRow("let go") << false;
        QTest::newRow("a modifier, then let go") << true;
    }
    void releasingTheGoToKeyStopsDespiteModifiers() {
        QFETCH(bool, modifierFirst);
        app::MainWindow& window = bench_->window;
        window.waypoints().teach();
        startJog();
        cell().advanceMs(600);
        release(key());
        QVERIFY(timeToStandstill(cell()) >= 0);
        window.selectWaypoint(0);
        window.waypoints().setFocus();
        QTest::keyPress(&window, Qt::Key_G);
        cell().advanceMs(200);
        QVERIFY(!standsStill(cell()));
        if (modifierFirst) {
            QTest::keyPress(&window, Qt::Key_Control, Qt::ControlModifier);
            cell().advanceMs(20);
            QTest::keyRelease(&window, Qt::Key_G, Qt::ControlModifier);
            QTest::keyRelease(&window, Qt::Key_Control);
        } else {
            QTest::keyRelease(&window, Qt::Key_G);
        }
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= kDeathToStandstillMs, qPrintable(QString::number(ms)));
        expectStandstillFor(500);
    }

    void aRotationKeepsTheTcpInPlace() {
        const Pose before = cell().truth().tcpPose;
        press(key("jog.Rz+"));
        QVERIFY(cell().advanceUntil(
            [&] {
                const Pose now = cell().truth().tcpPose;
                const Eigen::Matrix3d R =
                    rotationMatrix(now.rotation) * rotationMatrix(before.rotation).transpose();
                return rotationVector(R).norm() > 1.5707963;
            },
            20'000));
        const Pose after = cell().truth().tcpPose;
        release(key("jog.Rz+"));
        QVERIFY2(distanceMm(before, after) < 0.1, qPrintable(QString::number(distanceMm(before, after))));
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void toolDirectionsFollowTheTool() {
        bench_->window.findChild<SegmentedControl*>("jogFrame")->setCurrentIndex(1);
        press(key("jog.Z+"));
        cell().advanceMs(300);
        const simulator::SimulatedState truth = cell().truth();
        const Eigen::Vector3d toolZ = rotationMatrix(truth.tcpPose.rotation).col(2);
        QVERIFY(truth.tcpSpeed.linear.normalized().dot(toolZ) > 0.9999);
        release(key("jog.Z+"));
        QVERIFY(timeToStandstill(cell()) >= 0);
    }

    void theSlowSpeedIsSelectedAfterARestart() {
        bench_->window.jogColumn().selectors().setSpeedClass(4);
        app::MainWindow again{app::Settings(bench_->folder.filePath("settings.ini")), bench_->clock};
        QVERIFY(speedClasses()[static_cast<std::size_t>(again.jogColumn().selection().speedClass)].tcp <=
                0.050001);
    }
};

QTEST_MAIN(TestJogContract)
#include "tst_jog_contract.moc"
