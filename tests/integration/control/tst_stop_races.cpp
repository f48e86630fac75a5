// SPDX-License-Identifier: MIT
// Stops, connection losses and errors during a call, and effects that must end with the call.
#include <unistd.h>

#include <QFile>
#include <array>
#include <stdexcept>

#include "robot/control/arm_queries.h"
#include "robot/control/motions.h"
#include "robot/control/packet_loop.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "tests/integration/control/cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

bool isAsleep(pid_t thread) {
    QFile stat(QStringLiteral("/proc/self/task/%1/stat").arg(thread));
    return stat.open(QIODevice::ReadOnly) && stat.readAll().contains(") S ");
}

}  // namespace

class TestStopRaces : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The arm moves, and time does not advance. One call waits for the end of the program, and the other call
    // waits for the first call. The stop must end both.
    void stopAlsoEndsQueuedCallers() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        Pose target = cell.tcp();
        target.position.z() += 0.2;
        QVERIFY(Motions(*cell.controller).moveL(target, {0.1, 0.5, Holding::Free}).ok());
        QVERIFY(cell.stepMs(600));
        QVERIFY(!cell.isStanding());
        Programs programs(*cell.controller);
        std::array<std::optional<Result<Motion>>, 2> functions;
        std::array<std::thread, 2> callers;
        std::array<std::atomic<pid_t>, 2> ids{};
        std::atomic<bool> waits{false};
        // A waiting call queries its token. At this point, the call has passed its check for stops.
        const CancelToken asked([&] {
            waits = true;
            return false;
        });
        for (std::size_t i = 0; i < callers.size(); ++i) {
            callers[i] = std::thread([&, i] {
                ids[i] = gettid();
                functions[i] = programs.startFunction(QStringLiteral("later"),
                                                      QStringLiteral("set_standard_digital_out(3, True)"),
                                                      Deadline::after(std::chrono::seconds(60), asked));
            });
            // The second call queries nothing, because it waits for the mutex.
            QTRY_VERIFY_WITH_TIMEOUT(ids[i] != 0 && (i == 0 ? waits.load() : isAsleep(ids[i])), 60'000);
        }
        cell.controller->stop(StopCause::StopButton);
        cell.during([&] {
            callers[0].join();
            callers[1].join();
            return true;
        });
        QCOMPARE(functions[0]->error().code, ErrorCode::Stopped);
        QCOMPARE(functions[1]->error().code, ErrorCode::Stopped);
        QVERIFY(cell.stepMs(300));
        QVERIFY((cell.robot.truth().digitalOutputs & 8U) == 0);
        QVERIFY(cell.controller->status().inControl);
    }

    // Effects that continue after the statement that starts them. A stop must end them, and they must not
    // outlive their function.
    void noMotionRemainsAfterAFunction_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<bool>("stopped");
        const std::pair<const char*, QString> bodies[] = {
            {"thread",
             QStringLiteral("thread rise():\n  while True:\n    speedl([0,0,0.1,0,0,0], 0.5, 0.002)\n"
                            "  end\nend\nrun rise()\n")},
            {"conveyor", QStringLiteral("encoder_enable_pulse_decode(0, 1, 0, 1)\n"
                                        "track_conveyor_linear(p[0,0,1,0,0,0], 10000, 0)\n")},
            {"path offset", QStringLiteral("thread offset():\n  local z = 0.0\n  while True:\n"
                                           "    z = z + 0.0001\n    path_offset_set(p[0,0,z,0,0,0], 1)\n"
                                           "    sync()\n  end\nend\npath_offset_enable()\nrun offset()\n")}};
        for (const auto& [name, body] : bodies) {
            QTest::addRow("%s, stopped", name) << body + QStringLiteral("sleep(100)") << true;
            // The test controls the end of the effect, because the call that starts the effect may return
            // late.
            QTest::addRow("%s, at its end", name)
                << body + QStringLiteral("while not get_standard_digital_in(0):\n  sync()\nend") << false;
        }
    }
    void noMotionRemainsAfterAFunction() {
        QFETCH(QString, body);
        QFETCH(bool, stopped);
        Cell cell;
        cell.robot.changeWorld([](simulator::arm::Environment& world) { world.setConveyorSpeed(0, 1000); });
        QVERIFY(cell.takeControl().ok());
        const auto function = cell.during([&] {
            return Programs(*cell.controller).startFunction(QStringLiteral("go_on"), body, testTimeout());
        });
        QVERIFY2(function.ok(), why(function));
        QVERIFY(cell.stepMs(300));
        QVERIFY(!cell.isStanding());
        if (stopped) {
            cell.controller->stop(StopCause::StopButton);
        } else {
            cell.robot.setDigitalInput(0, true);
            const auto ended = cell.during([&] { return function->wait(testTimeout()); });
            QVERIFY2(ended.ok(), why(ended));
        }
        QVERIFY(cell.standsWithinMs(150));
        const Pose stands = cell.tcp();
        QVERIFY(cell.stepMs(500));
        QVERIFY((cell.tcp().position - stands.position).norm() < 1e-4);
        QVERIFY(cell.controller->status().inControl);
    }

    void aStopEndsAScript() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        bool stopped = false;
        cell.everyTick = [&] {
            if (!stopped && (cell.robot.truth().digitalOutputs & 2U) != 0) {
                stopped = true;
                cell.controller->stop(StopCause::StopButton);
            }
        };
        // The script continues when the input is set. This must not happen before the caller has detected the
        // stop.
        const auto ran = cell.during([&] {
            return Programs(*cell.controller)
                .runScript(QStringLiteral("def mine():\n  set_standard_digital_out(1, True)\n"
                                          "  while not get_standard_digital_in(0):\n    sync()\n  end\n"
                                          "  set_standard_digital_out(2, True)\n  sleep(0.1)\nend\n"),
                           testTimeout());
        });
        QCOMPARE(ran.error().code, ErrorCode::Stopped);
        cell.robot.setDigitalInput(0, true);
        QVERIFY(cell.stepMs(600));
        QVERIFY((cell.robot.truth().digitalOutputs & 4U) == 0);
        QVERIFY(cell.controller->status().inControl);
    }

    // Values stored in the previous program are not stored in the new program.
    void newProgramReceivesAllSettingsAgain() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        ArmQueries ask(*cell.controller);
        InverseOptions near;
        const Pose pose = cell.tcp();
        near.near = JointPositions(0, 0, 0, 0, 0, 0);  // initial value in a new program
        const auto other = cell.during([&] { return ask.inverseKinematics(pose, near, testTimeout()); });
        QVERIFY2(other.ok(), why(other));
        near.near = cell.robot.truth().q;
        near.near->values *= -1;
        const auto first = cell.during([&] { return ask.inverseKinematics(pose, near, testTimeout()); });
        QVERIFY2(first.ok(), why(first));
        QVERIFY((first->values - other->values).cwiseAbs().maxCoeff() > 0.1);
        cell.release();
        QVERIFY(cell.takeControl().ok());
        const auto second = cell.during([&] { return ask.inverseKinematics(pose, near, testTimeout()); });
        QVERIFY2(second.ok(), why(second));
        QVERIFY((first->values - second->values).cwiseAbs().maxCoeff() < 1e-6);
    }

    void anExceptionInACallbackEndsOnlyItsMotion() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        const auto ended = cell.during([&] {
            return PacketLoop(*cell.controller)
                .speedL(
                    [](const CycleState& state) -> std::optional<Twist> {
                        if (state.cycle > 5) {
                            throw std::runtime_error("no more paint");
                        }
                        return Twist{};
                    },
                    {}, testTimeout());
        });
        QCOMPARE(ended.error().code, ErrorCode::Stopped);
        QVERIFY2(ended.error().controllerMessage.contains(QStringLiteral("no more paint")), why(ended));
        QVERIFY(cell.controller->status().inControl);
    }

    void aProtectiveStopNeedsControl() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(
            cell.during([&] { return Programs(*cell.controller).endControlProgram(testTimeout()); }).ok());
        QCOMPARE(
            cell.during([&] { return ToolSetup(*cell.controller).triggerProtectiveStop(Deadline::never()); })
                .error()
                .code,
            ErrorCode::NotInControl);
    }

    void aPathKeepsTheLimitsOfTheConnectedArm() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        JointPositions q = cell.robot.truth().q;
        q[5] = 8;  // valid for a UR3e but not for a UR5e
        const auto path =
            Motions(*cell.controller).movePath({{PathEntry::Kind::MoveJ, q, {}, 0.5, 1.4, 0}}, testTimeout());
        QVERIFY(!path.ok());
        QVERIFY2(path.error().controllerMessage.contains(QStringLiteral("entry 1, target")), why(path));
    }

    void softStopIsRefusedWhereItWouldHaveNoEffect() {
        Cell cell;
        QCOMPARE(Motions(*cell.controller).stopJ(0.05).error().code, ErrorCode::LimitExceeded);
        QCOMPARE(Motions(*cell.controller).stopL(1, 0.01).error().code, ErrorCode::LimitExceeded);
    }
};

QTEST_GUILESS_MAIN(TestStopRaces)
#include "tst_stop_races.moc"
