// SPDX-License-Identifier: GPL-3.0-or-later
// The robot changes from remote to local control while Tiller is in control. Motion stops, control is
// released, and the reason is displayed. A robot that was never in remote control may be controlled in local
// control.
#include <QElapsedTimer>
#include <QTest>
#include <optional>
#include <thread>

#include "robot/io/outputs.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// Session time within which the session queries the control mode [ms]. The reply itself takes real time.
constexpr int kNoticedMs = 600;
constexpr int kWaitTimeoutMs = 20'000;

struct Bench {
    QStringList warnings;  // declared first, because the session may send a message in its destructor
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell;
    RobotSession::MotionId jog = 0;

    explicit Bench(const simulator::SimulatorOptions& options = VirtualCell::options())
        : cell(clock, session, options) {
        test::onMessage(session.journal(), &session, [this](Severity severity, const QString& text) {
            if (severity != Severity::Info) {
                warnings << text;
            }
        });
        cell.everyRefresh = [this] {
            if (jog != 0) {
                session.hold(jog);
            }
        };
    }
    bool knowsRemote() {
        return within([this] { return session.state().remoteControl; });
    }
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kWaitTimeoutMs) {
            cell.advanceMs(16);
        }
        return condition();
    }
    /// Waits in real time, without advancing session time, until a pending request is answered.
    bool answered(const std::function<bool()>& condition) {
        return QTest::qWaitFor(
            [&] {
                session.refresh();
                return condition();
            },
            kWaitTimeoutMs);
    }
    bool beginJog() {
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        const auto begun = session.beginJog(up);
        if (!begun) {
            return false;
        }
        jog = *begun;
        return cell.advanceUntil([this] { return cell.truth().tcpSpeed.linear.norm() > 0.04; }, 1000);
    }
    bool isInControl() const { return session.state().control == ControlState::InControl; }
    QString said() const { return warnings.join(QLatin1Char('\n')); }
};

}  // namespace

class TestControlPlace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void switchingToLocalReleasesControl() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        QVERIFY(bench.beginJog());
        bench.warnings.clear();
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(kNoticedMs);
        QVERIFY(bench.answered([&] { return !bench.warnings.isEmpty(); }));
        QVERIFY2(bench.said().contains(QStringLiteral("Local")), qPrintable(bench.said()));
        // The operator still holds the key, but the arm does not move.
        QVERIFY(
            bench.cell.advanceUntil([&] { return bench.cell.truth().tcpSpeed.linear.norm() < 0.001; }, 250));
        QVERIFY(bench.within([&] { return !bench.isInControl(); }));
        QVERIFY(bench.within([&] { return bench.cell.truth().runtimeState == RuntimeState::Stopped; }));
        // The reason is updated after the controller itself has reported the mode.
        QVERIFY(bench.answered([&] { return bench.session.state().control == ControlState::Refused; }));
        QVERIFY(bench.session.state().controlReason.contains(QStringLiteral("Local")));
        QCOMPARE(bench.warnings.size(), 1);
        // Back in remote control: control is not taken automatically, but the operator can take it again.
        bench.jog = 0;
        bench.cell.robot.setRemoteControl(true);
        QVERIFY(bench.knowsRemote());
        bench.cell.advanceMs(1000);
        QVERIFY(!bench.isInControl());
        bench.session.takeControl();
        QVERIFY(bench.within([&] { return bench.isInControl(); }));
        QVERIFY(bench.beginJog());
    }

    // A robot that accepts no commands in local control is recognized once it has been in remote control.
    void inLocalTheNextStepPointsToTheTeachPendant() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        QVERIFY(!bench.session.state().remoteNeeded);
        bench.cell.robot.setRemoteControl(false);
        QVERIFY(bench.within([&] { return bench.session.state().remoteNeeded; }));
        QVERIFY2(bench.session.state().controlReason.contains(QStringLiteral("Switch the robot to Remote")),
                 qPrintable(bench.session.state().controlReason));
        bench.cell.robot.setRemoteControl(true);
        QVERIFY(bench.within([&] { return !bench.session.state().remoteNeeded; }));
        QVERIFY(!bench.session.state().controlReason.contains(QStringLiteral("Remote")));
    }

    // A refused command also indicates local control. The refusal is cleared when the robot is in remote
    // control again.
    void aRefusalInLocalIsKeptUntilRemote() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.remoteControl = false;
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        Bench bench(options);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.within([&] { return bench.session.state().service == dashboard::ServiceKind::Dashboard; }));
        QVERIFY(!bench.session.state().remoteNeeded);
        bench.session.takeControl();
        QVERIFY(bench.within([&] { return bench.session.state().control == ControlState::Refused; }));
        QVERIFY2(bench.session.state().remoteNeeded, qPrintable(bench.said()));
        bench.cell.robot.setRemoteControl(true);
        QVERIFY(bench.knowsRemote());
        QVERIFY(!bench.session.state().remoteNeeded);
        QCOMPARE(bench.session.state().control, ControlState::None);
        bench.session.takeControl();
        QVERIFY2(bench.within([&] { return bench.isInControl(); }), qPrintable(bench.said()));
    }

    // Remote control is disabled in the robot settings: the reply is "false" from the beginning.
    void aRobotNeverInRemoteIsNotATransition() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.remoteControl = false;
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.within([&] { return bench.session.state().service == dashboard::ServiceKind::Dashboard; }));
        QVERIFY(bench.beginJog());
        QVERIFY(!bench.session.state().remoteNeeded);
        bench.cell.advanceMs(3000);
        QVERIFY(bench.isInControl());
        QVERIFY(bench.cell.truth().tcpSpeed.linear.norm() > 0.01);
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    // Software without support for the query.
    void noTransitionWithoutReportedMode() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.software = {5, 5, 1, 0};
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.within([&] { return bench.session.state().service == dashboard::ServiceKind::Dashboard; }));
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(3000);
        QVERIFY(bench.isInControl());
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    void noTransitionWithoutControl() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        bench.cell.robot.setRemoteControl(false);
        QVERIFY(bench.within([&] { return !bench.session.state().remoteControl; }));
        QCOMPARE(bench.session.state().control, ControlState::None);
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    // The speed slider is logged once it stops changing, regardless of who moved it.
    void aMovedSpeedSliderIsLogged() {
        QStringList said;  // declared first, because the session may send a message in its destructor
        QList<Origin> origins;
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text, Origin origin) {
                            if (text.startsWith(QStringLiteral("Speed slider"))) {
                                said << text;
                                origins << origin;
                            }
                        });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(1000);
        QVERIFY(said.isEmpty());  // the initial position is not logged
        bench.cell.robot.setSpeedSlider(0.3);
        bench.cell.advanceMs(1000);
        QCOMPARE(said, QStringList{QStringLiteral("Speed slider: 30 %")});
        QCOMPARE(origins.last(), Origin::Robot);
        for (const double place : {0.4, 0.5, 0.6}) {
            bench.session.outputs().setSpeedSlider(place);
            bench.cell.advanceMs(50);
        }
        QVERIFY(bench.within([&] { return said.size() == 2; }));
        bench.cell.advanceMs(1000);
        QCOMPARE(said.last(), QStringLiteral("Speed slider: 60 %"));
        QCOMPARE(said.size(), 2);
        QCOMPARE(origins.last(), Origin::Operator);
    }

    void theJournalNamesTheRobotAndTheTimeOfItsController() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(1000);
        bench.session.outputs().setDigitalOutput(3, true);
        const auto eventOf = [&bench](const QString& start) -> std::optional<JournalEvent> {
            for (const JournalEvent& event : bench.session.journal().events()) {
                if (event.text.startsWith(start)) {
                    return event;
                }
            }
            return {};
        };
        QVERIFY(bench.within([&] { return eventOf(QStringLiteral("Output DO 3: on")).has_value(); }));
        const auto connecting = eventOf(QStringLiteral("Connecting to"));
        QVERIFY(connecting && !connecting->controllerSeconds);
        QCOMPARE(connecting->robot, QStringLiteral("Virtual UR5e"));
        const auto output = eventOf(QStringLiteral("Output DO 3: on"));
        QVERIFY(output->controllerSeconds && output->origin == Origin::Operator);
        QCOMPARE(output->robot, QStringLiteral("Virtual UR5e"));
        const double age = bench.session.state().robotTime - *output->controllerSeconds;
        QVERIFY2(age >= 0 && age < 1, qPrintable(QString::number(age)));
        bench.session.disconnectFromRobot();
        bench.session.journal().add(Severity::Info, QStringLiteral("Later"));
        QCOMPARE(eventOf(QStringLiteral("Disconnected"))->robot, QStringLiteral("Virtual UR5e"));
        QVERIFY(eventOf(QStringLiteral("Later"))->robot.isEmpty());
    }

    // The log and its export use the operator's name for an output.
    void outputsAreLoggedByTheirNames() {
        QStringList said;
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { said << text; });
        bench.session.outputs().setNames({{QStringLiteral("DO 3"), QStringLiteral("Gripper")}});
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.session.outputs().setDigitalOutput(3, true);
        QVERIFY(bench.within([&] { return said.contains(QStringLiteral("Output Gripper (DO 3): on")); }));
        bench.session.outputs().setDigitalOutput(17, true);
        QVERIFY(bench.within([&] { return said.contains(QStringLiteral("Output TO 1: on")); }));
    }

    /// Another client can claim the inputs of the robot while Tiller does not use them.
    void inputsAreClaimedOnlyWhileTheyAreUsed() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        io::OutputsOptions options;
        options.host = bench.cell.robot.listenAddress();
        const auto areFree = [&] {
            io::Outputs other(options, io::OutputFeedback{[] { return io::Report(); }});
            std::thread connecting([&] { (void)other.connect(Deadline::after(std::chrono::minutes(1))); });
            const bool connected =
                bench.answered([&] { return bench.cell.robot.drainSockets(), other.isConnected(); });
            connecting.join();
            return connected && other.canSetSpeedSlider() && other.canSetDigitalOutput(0) &&
                   other.canSetAnalogOutput();
        };
        bench.cell.advanceMs(1000);
        QTest::qWait(200);  // nothing is claimed, so there is no event to wait for
        QVERIFY2(areFree(), "inputs are claimed while only monitoring");
        // A single command without control claims the inputs only temporarily.
        bench.session.outputs().setSpeedSlider(0.5);
        QVERIFY(bench.within([&] { return bench.cell.truth().speedSlider == 0.5; }));
        QVERIFY(!areFree());
        bench.cell.advanceMs(4000);
        QVERIFY(bench.answered(areFree));
        // While Tiller is in control, the inputs stay claimed.
        bench.session.takeControl();
        QVERIFY(bench.within([&] { return bench.isInControl(); }));
        QVERIFY(bench.answered([&] { return !areFree(); }));
        bench.cell.advanceMs(4000);
        QVERIFY(!areFree());
        bench.session.releaseControl();
        QVERIFY(bench.within([&] { return !bench.isInControl(); }));
        bench.cell.advanceMs(4000);
        QVERIFY(bench.answered(areFree));
    }

    void aTooLowSpeedSliderIsRefused() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        bench.session.outputs().setSpeedSlider(0);
        QVERIFY(bench.within([&] { return !bench.warnings.isEmpty(); }));
        QVERIFY2(bench.said().contains(QStringLiteral("0.02")), qPrintable(bench.said()));
        QCOMPARE(bench.cell.truth().speedSlider, 1.0);
    }

    void aTransitionOnPolyscopeXIsDetected() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.software = {10, 12, 0, 0};
        options.portOffset = 20'000;
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        bench.warnings.clear();
        bench.cell.robot.setRemoteControl(false);
        QVERIFY(bench.within([&] { return !bench.isInControl(); }));
        QVERIFY(bench.within([&] { return !bench.warnings.isEmpty(); }));
        QVERIFY2(bench.said().contains(QStringLiteral("Local")), qPrintable(bench.said()));
    }
};

QTEST_MAIN(TestControlPlace)
#include "tst_control_place.moc"
