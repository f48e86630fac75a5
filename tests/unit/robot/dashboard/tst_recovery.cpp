// SPDX-License-Identifier: MIT
#include <QTest>
#include <atomic>
#include <vector>

#include "robot/dashboard/recovery.h"
#include "tests/support/raw_peer.h"

using namespace tiller;
using namespace tiller::dashboard;
using test::RawPeer;

namespace {

/// A robot that changes its modes on command, and counts the commands.
struct Robot {
    std::atomic<int> safety{1};  ///< SafetyMode
    std::atomic<int> mode{7};    ///< RobotMode
    std::atomic<int> refusals{0};
    std::atomic<int> unlocks{0};
    std::atomic<int> outages{0};  ///< number of times the controller disconnects instead of answering
    RawPeer peer{[this](RawPeer::Link& link) {
        link.send("Connected\n");
        while (!link.isOver()) {
            const QByteArray line = link.readLine();
            if (line.isNull()) {
                return;
            }
            if (outages > 0) {
                --outages;
                return;
            }
            link.send(reply(line) + "\n");
        }
    }};
    QByteArray reply(const QByteArray& line) {
        if (line == "safetymode") {
            return "Safetymode: " + safetyModeName(static_cast<SafetyMode>(safety.load())).toLatin1();
        }
        if (line == "robotmode") {
            return "Robotmode: " + robotModeName(static_cast<RobotMode>(mode.load())).toLatin1();
        }
        if (line == "unlock protective stop") {
            if (refusals-- > 0) {
                return "Cannot unlock protective stop until 5s after occurrence. Always inspect cause";
            }
            ++unlocks;
            safety = 1;
            return "Protective stop releasing";
        }
        if (line == "restart safety") {
            safety = 1;
            mode = 3;
            return "Restarting safety";
        }
        if (line == "power on") {
            mode = 5;
            return "Powering on";
        }
        if (line == "brake release") {
            mode = 7;
            return "Brake releasing";
        }
        return "closing safety popup";
    }
};

struct Bench {
    explicit Bench(SafetyMode safety, RobotMode mode)
        : client(QStringLiteral("127.0.0.1"), robot.peer.port()) {
        robot.safety = static_cast<int>(safety);
        robot.mode = static_cast<int>(mode);
        if (!client.connect(Deadline::after(std::chrono::seconds(20)))) {
            qFatal("no connection");
        }
    }
    Result<void> run(const RecoveryConsent& consent) {
        return recover(client, consent, Deadline::after(std::chrono::seconds(60)),
                       [this](RecoveryStep step) { steps.push_back(step); });
    }
    Robot robot;
    DashboardClient client;
    std::vector<RecoveryStep> steps;
};

}  // namespace

class TestRecovery : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProtectiveStopIsNeverUnlockedWithoutConsent() {
        Bench bench(SafetyMode::ProtectiveStop, RobotMode::Running);
        RecoveryConsent allButThis{false, true, true, true};
        const Error error = bench.run(allButThis).error();
        QCOMPARE(error.code, ErrorCode::Rejected);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("inspected")));
        QCOMPARE(bench.robot.unlocks.load(), 0);
    }

    void withConsentItIsUnlockedOnceTheControllerPermits() {
        Bench bench(SafetyMode::ProtectiveStop, RobotMode::Running);
        bench.robot.refusals = 2;
        QVERIFY(bench.run({true, false, false, false}).ok());
        QCOMPARE(bench.robot.unlocks.load(), 1);
        const std::vector<RecoveryStep> reported{RecoveryStep::Look, RecoveryStep::CloseSafetyPopup,
                                                 RecoveryStep::Unlock, RecoveryStep::WaitForUnlock,
                                                 RecoveryStep::Done};
        QCOMPARE(bench.steps, reported);
    }

    void recoveryFromAViolationIsComplete() {
        Bench bench(SafetyMode::Violation, RobotMode::PowerOff);
        QVERIFY(bench.run({false, true, true, true}).ok());
        QCOMPARE(bench.robot.mode.load(), 7);
        Bench refused(SafetyMode::Violation, RobotMode::PowerOff);
        QCOMPARE(refused.run({true, false, true, true}).error().code, ErrorCode::Rejected);
    }

    void powerAndBrakesNeedTheirOwnConsent() {
        Bench off(SafetyMode::Normal, RobotMode::PowerOff);
        QVERIFY(
            off.run({true, true, false, true}).error().controllerMessage.contains(QStringLiteral("power")));
        QCOMPARE(off.robot.mode.load(), 3);
        Bench idle(SafetyMode::Normal, RobotMode::Idle);
        QVERIFY(
            idle.run({true, true, true, false}).error().controllerMessage.contains(QStringLiteral("brakes")));
        QCOMPARE(idle.robot.mode.load(), 5);
    }

    void statesThatRequireAPersonAreReported() {
        Bench bench(SafetyMode::RobotEmergencyStop, RobotMode::PowerOff);
        const Error error = bench.run({true, true, true, true}).error();
        QCOMPARE(error.code, ErrorCode::Rejected);
        QVERIFY(error.controllerMessage.contains(QStringLiteral("person")));
        QCOMPARE(bench.robot.mode.load(), 3);
    }

    void recoveryWaitsForARestartingController() {
        Bench bench(SafetyMode::Normal, RobotMode::PowerOff);
        bench.robot.outages = 5;
        QVERIFY(bench.run({false, false, true, true}).ok());
        QCOMPARE(bench.robot.mode.load(), 7);
        const std::vector<RecoveryStep> steps{RecoveryStep::Look, RecoveryStep::PowerOn,
                                              RecoveryStep::ReleaseBrakes, RecoveryStep::Done};
        QCOMPARE(bench.steps, steps);
    }

    void aDeadlineEndsTheWaitForARestart() {
        Bench bench(SafetyMode::Normal, RobotMode::PowerOff);
        bench.robot.outages = 1'000'000;
        CancelToken token;
        const auto done = recover(bench.client, {}, Deadline::after(std::chrono::seconds(60), token),
                                  [&](RecoveryStep) { token.cancel(); });
        QCOMPARE(done.error().code, ErrorCode::Cancelled);
        const auto late = recover(bench.client, {}, Deadline::after(std::chrono::milliseconds(300)));
        QCOMPARE(late.error().code, ErrorCode::Timeout);
    }

    void theNextStepFollowsFromTheModes() {
        QCOMPARE(nextRecoveryStep(SafetyMode::Normal, RobotMode::Booting), RecoveryStep::Look);
        QCOMPARE(nextRecoveryStep(SafetyMode::Normal, RobotMode::PowerOff), RecoveryStep::PowerOn);
        QCOMPARE(nextRecoveryStep(SafetyMode::Reduced, RobotMode::Idle), RecoveryStep::ReleaseBrakes);
        QCOMPARE(nextRecoveryStep(SafetyMode::Reduced, RobotMode::Running), RecoveryStep::Done);
        // The safety mode has priority over the robot mode.
        for (const RobotMode mode : {RobotMode::PowerOff, RobotMode::Idle, RobotMode::Running}) {
            QCOMPARE(nextRecoveryStep(SafetyMode::ProtectiveStop, mode), RecoveryStep::Unlock);
            QCOMPARE(nextRecoveryStep(SafetyMode::Violation, mode), RecoveryStep::RestartSafety);
            QCOMPARE(nextRecoveryStep(SafetyMode::Fault, mode), RecoveryStep::RestartSafety);
            QCOMPARE(nextRecoveryStep(SafetyMode::SafeguardStop, mode), RecoveryStep::AskPerson);
            QCOMPARE(nextRecoveryStep(SafetyMode::SystemEmergencyStop, mode), RecoveryStep::AskPerson);
        }
    }

    void aRunningRobotNeedsNoRecovery() {
        Bench bench(SafetyMode::Reduced, RobotMode::Running);
        QVERIFY(bench.run({}).ok());
    }
};

QTEST_GUILESS_MAIN(TestRecovery)
#include "tst_recovery.moc"
