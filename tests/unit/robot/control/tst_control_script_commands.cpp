// SPDX-License-Identifier: MIT
// Functions of control.script: streams, sections, stops with a given deceleration, and requests.
#include <QFile>
#include <QTest>

#include "robot/control/detail/setpoint_command.h"
#include "tests/unit/robot/control/script_bench.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

using Bench = ScriptBench;

Command servo(ScriptCommand kind, std::int32_t epoch, bool target) {
    Command command;
    command.kind = kind;
    command.epoch = epoch;
    command.choice = target ? 1 : 0;
    command.values = {0.2, -1, 1, -1, -1, 0};
    command.speed = 0.002;
    command.acceleration = 0.1;
    command.rotationAcceleration = 300;
    return command;
}

constexpr SoftwareVersion kHasTorque{5, 25, 1, 0};

/// One set of torques in a stream, with a speed limit of 0.25 m/s.
Command torque(std::int32_t epoch, const JointTorques& target, const TorqueParameters& parameters = {}) {
    MotionCommand filled;
    fill(filled, target);
    fill(filled, parameters, 0.002);
    Command command;
    command.kind = ScriptCommand::Torque;
    command.epoch = epoch;
    command.choice = 250;
    command.values = filled.target;
    command.speed = filled.speed;
    command.acceleration = filled.acceleration;
    command.rotationAcceleration = filled.rotationAcceleration;
    command.rotation = filled.rotation;
    return command;
}

/// A stream of torques in epoch 2, with the arm at 0.4 rad/s.
struct TorqueBench : Bench {
    explicit TorqueBench() : Bench(RegisterRange::Upper, kHasTorque) {
        host.tcpVelocity = {};
        hold(ScriptCommand::Idle, 1, 2);
        push(5);
        host.qd[0] = 0.4;
    }
    void push(int frames) {
        for (int i = 0; i < frames; ++i) {
            Bench::send(torque(2, JointTorques(10, 0, 0, 0, 0, 0)));
            frame();
        }
    }
    /// Torque of the base joint in the newest command [Nm]; empty if it is not a torque command.
    std::optional<double> base() const {
        const auto* given = last<urscript::DirectTorque>();
        return given != nullptr ? std::optional(given->torque[0]) : std::nullopt;
    }
};

Command stopJ(std::int32_t epoch, double deceleration) {
    Command stop;
    stop.epoch = epoch;
    stop.choice = 1;
    stop.acceleration = deceleration;
    return stop;
}

/// Starts a linear stream whose stops take a long time.
void moveInEpoch2(Bench& bench) {
    bench.host.moveFrames = 1000;
    bench.hold(ScriptCommand::Idle, 1, 2);
    bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, 0.1, 0, 0, 0});
}

bool called(const Bench& bench, const std::string& what) {
    return std::find(bench.host.calls.begin(), bench.host.calls.end(), what) != bench.host.calls.end();
}

}  // namespace

class TestControlScriptCommands : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // Standard output 2, configurable output 1 and tool output 0 in one command; the robot measures the time.
    void pulsedOutputsReturnAfterTheirDuration() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.host.pins[16] = true;
        const Answer answer = bench.ask(RequestKind::BeginPulses, 1 << 2 | 1 << 9 | 1 << 16,
                                        {0.02, 1 << 2 | 1 << 9, 0, 0, 0, 0});
        QCOMPARE(answer.outcome, Outcome::Done);
        int frames = 0;
        for (; bench.host.pins[2] && frames < 100; ++frames) {
            QVERIFY(bench.host.pins[9] && !bench.host.pins[16]);
            bench.hold(ScriptCommand::Idle, 1, 1);
        }
        QVERIFY2(std::abs(frames - 10) <= 1, qPrintable(QString::number(frames)));
        QVERIFY(!bench.host.pins[9]);
        QVERIFY2(bench.host.pins[16], "the inverted pulse did not end");
        for (std::size_t pin = 0; pin < 18; ++pin) {
            QCOMPARE(bool(bench.host.pins[pin]), pin == 16);
        }
    }

    // Without a heartbeat, a Held pulse ends like a motion. Other pulses end after their duration.
    void aMissingHeartbeatEndsOnlyHeldPulses() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.ask(RequestKind::BeginPulses, 1 << 1, {0.5, 1 << 1, 1, 0, 0, 0});
        bench.ask(RequestKind::BeginPulses, 1 << 2, {0.5, 1 << 2, 0, 0, 0, 0});
        bench.frame(bench.silentFrames() - 10);
        QVERIFY(bench.host.pins[1] && bench.host.pins[2]);
        bench.frame(20);
        QVERIFY(!bench.host.pins[1]);
        QVERIFY(bench.host.pins[2]);
        bench.frame(static_cast<int>(0.45 / bench.host.step));
        QVERIFY(!bench.host.pins[2]);
        QVERIFY(bench.running());
    }

    void aCancelledPulseReturnsImmediately() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.ask(RequestKind::BeginPulses, 1 << 3, {60, 1 << 3, 0, 0, 0, 0});
        QVERIFY(bench.host.pins[3]);
        bench.host.pins[4] = true;
        bench.ask(RequestKind::EndPulses, 1 << 3 | 1 << 4);
        QVERIFY(!bench.host.pins[3]);
        QVERIFY2(bench.host.pins[4], "an output without a pulse was switched off");
    }

    // All pulses end with the program, whether it ends on request or because it received no data for five
    // seconds.
    void theEndOfTheProgramEndsItsPulses() {
        for (const bool asked : {true, false}) {
            Bench bench;
            bench.hold(ScriptCommand::Idle, 1, 2);
            bench.ask(RequestKind::BeginPulses, 1 << 3, {60, 1 << 3, 0, 0, 0, 0});
            if (asked) {
                bench.hold(ScriptCommand::End, 2, 5);
            } else {
                bench.frame(static_cast<int>(5.1 / bench.host.step));
            }
            QVERIFY(!bench.running());
            QVERIFY(!bench.host.pins[3]);
        }
    }

    void aServoHoldsPositionThenFollows() {
        Bench bench;
        bench.host.q = JointPositions(0.19, -1, 1, -1, -1, 0);
        bench.hold(ScriptCommand::Idle, 1, 2);
        for (int i = 0; i < 5; ++i) {
            bench.send(servo(ScriptCommand::ServoJ, 2, false));
            bench.frame();
        }
        QCOMPARE(bench.last<urscript::ServoJ>()->q, bench.host.q);
        for (int i = 0; i < 5; ++i) {
            bench.send(servo(ScriptCommand::ServoJ, 2, true));
            bench.frame();
        }
        const auto* last = bench.last<urscript::ServoJ>();
        QCOMPARE(last->q[0], 0.2);
        QCOMPARE(last->lookahead, 0.1);
        QCOMPARE(last->gain, 300.0);
        QCOMPARE(last->duration, 0.002);
    }

    // The first target must be close to the arm, and each later target close to the previous target.
    void aServoDoesNotJump() {
        Bench bench;
        bench.host.q = JointPositions(0.2, -1, 1, -1, -1, 0);
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command target = servo(ScriptCommand::ServoJ, 2, true);
        target.values[3] += 0.05;  // permitted: 0.02 rad plus the rotation of a joint in 2 ms
        for (int i = 0; i < 60; ++i) {
            bench.send(target);
            bench.frame();
        }
        QVERIFY(bench.running());
        QCOMPARE(bench.state(), ScriptState::TooFar);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        for (const auto& motion : bench.host.motions) {
            const auto* servoed = std::get_if<urscript::ServoJ>(&motion.command);
            QVERIFY(servoed == nullptr || servoed->q == bench.host.q);
        }
        // Small steps are permitted over any total distance.
        target = servo(ScriptCommand::ServoJ, 3, true);
        for (int i = 0; i < 50; ++i) {
            target.values[3] += 0.015;
            bench.send(target);
            bench.frame();
        }
        bench.frame();
        QCOMPARE(bench.state(), ScriptState::Executing);
        QCOMPARE(bench.last<urscript::ServoJ>()->q[3], target.values[3]);
        const double before = target.values[3];
        target.values[3] += 0.4;  // more than a joint can move while packages may be missing
        for (int i = 0; i < 60; ++i) {
            bench.send(target);
            bench.frame();
        }
        QCOMPARE(bench.state(), ScriptState::TooFar);
        for (const auto& motion : bench.host.motions) {
            const auto* servoed = std::get_if<urscript::ServoJ>(&motion.command);
            QVERIFY(servoed == nullptr || servoed->q[3] <= before);
        }
    }

    void anUnreachablePoseEndsTheServoNotTheProgram() {
        Bench bench;
        bench.host.reachable = false;
        bench.hold(ScriptCommand::Idle, 1, 2);
        for (int i = 0; i < 60; ++i) {
            bench.send(servo(ScriptCommand::ServoL, 2, true));
            bench.frame();
        }
        QVERIFY(bench.running());
        QCOMPARE(bench.state(), ScriptState::OutOfReach);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        bench.hold(ScriptCommand::MoveJToPose, 3, 60, {0.1, 0.2, 0.3, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::OutOfReach);
        QCOMPARE(bench.count<urscript::Move>(), 0);
    }

    void speedStreamsUseTheNewestValues() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, 0.1, 0, 0, 0});
        bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, 0.2, 0, 0, 0});
        QCOMPARE(bench.last<urscript::SpeedL>()->xd.linear.z(), 0.2);
        bench.hold(ScriptCommand::SpeedJ, 3, 60, {0, 0, 0, 0, 0, 0.3});
        QCOMPARE(bench.count<urscript::StopL>(), 1);
        QCOMPARE(bench.last<urscript::SpeedJ>()->qd[5], 0.3);
    }

    void aStopUsesTheRequestedDeceleration() {
        Bench bench;
        moveInEpoch2(bench);
        bench.send(stopJ(3, 0.7));
        bench.frame();
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 0.7);
        bench.hold(ScriptCommand::Idle, 4, 2);  // the stop key still uses the full deceleration
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 4.0);
        QCOMPARE(bench.count<urscript::StopJ>(), 2);
    }

    void aSectionRunsOnceAndCannotChangeTheProgram() {
        Bench bench(RegisterRange::Upper, {5, 22, 0, 0},
                    QStringLiteral("speed = 77\nvalues = 1\ntiller_waypoint = 2\n"
                                   "movej([0,0,0,0,0,0], a=1, v=speed)"));
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::Section, 2, 5);
        QCOMPARE(bench.state(), ScriptState::Executing);
        QCOMPARE(bench.out(7), 2);
        QCOMPARE(std::get<urscript::Move>(bench.host.motions.back().command).velocity, 77.0);
        bench.hold(ScriptCommand::Section, 2, 60);
        QCOMPARE(bench.state(), ScriptState::Done);
        bench.hold(ScriptCommand::MoveJ, 3, 3, {1, 2, 3, 4, 5, 6});
        const auto& move = std::get<urscript::Move>(bench.host.motions.back().command);
        QCOMPARE(std::get<JointPositions>(move.target)[5], 6.0);
        QCOMPARE(move.velocity, 0.5);
    }

    void errorLinesAreMappedToTheSection() {
        const ControlScript plain = controlScript({5, 22, 0, 0}, RegisterRange::Upper, 1, {}, kArm);
        const ControlScript script = controlScript({5, 22, 0, 0}, RegisterRange::Upper, 1, {}, kArm,
                                                   QStringLiteral("a = 1\nb = 2\nc = 3"));
        const QString found = script.text.section(QLatin1Char('\n'), script.sectionLine, script.sectionLine);
        QVERIFY(found.contains(QLatin1String("b = 2")));
        QCOMPARE(script.place(script.sectionLine + 1, 5), QStringLiteral("line 2"));
        QCOMPARE(script.place(script.sectionLine + 5, 5), plain.place(plain.sectionLine + 3, 5));
        QVERIFY(script.place(3, 1).startsWith(QLatin1String("control.script line ")));
        // In every part of the script, the line number refers to the source file of that part.
        const QStringList sent = script.text.split(QLatin1Char('\n'));
        for (const char* sought : {"thread tiller_move_line()", "def tiller_serve()", "def tiller_obey()"}) {
            const auto at = std::find_if(sent.begin(), sent.end(), [&](const QString& line) {
                return line.contains(QLatin1String(sought));
            });
            QVERIFY(at != sent.end());
            const QStringList place =
                script.place(static_cast<int>(at - sent.begin()) + 1, 1).split(QLatin1Char(' '));
            QFile file(qEnvironmentVariable("TILLER_TEST_DATA") + QStringLiteral("/../../robot/control/") +
                       place[0]);
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
            const QString line = lines.value(place[2].chopped(1).toInt() - 1);
            QVERIFY2(line.contains(QString::fromLatin1(sought).remove(QStringLiteral("tiller_"))),
                     qPrintable(line));
        }
    }

    void functionsUnusedByASectionAreLeftOut() {
        const auto text = [](const char* section) {
            return controlScript({5, 22, 0, 0}, RegisterRange::Upper, 1, {}, kArm,
                                 QString::fromLatin1(section))
                .text;
        };
        QVERIFY(!text("sync()").contains(QLatin1String("stop_conveyor_tracking(")));
        QVERIFY(!text("sync()").contains(QLatin1String("path_offset_disable(")));
        QVERIFY(text("track_conveyor_linear(p[1,0,0,0,0,0], 1000)")
                    .contains(QLatin1String("stop_conveyor_tracking(")));
        QVERIFY(text("path_offset_enable()").contains(QLatin1String("path_offset_disable(")));
    }

    void contactEndsTheMoveAndReturnsToTheContactPoint() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::UntilContact, 2, 10, {0, 0, -0.05, 0, 0, 0});
        QVERIFY(bench.last<urscript::SpeedL>() != nullptr);
        bench.host.contact = 7;
        bench.hold(ScriptCommand::UntilContact, 2, 200, {0, 0, -0.05, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Done);
        QCOMPARE(bench.count<urscript::StopL>(), 1);
        const auto& back = std::get<urscript::Move>(bench.host.motions.back().command);
        QCOMPARE(back.kind, urscript::Move::Kind::L);
        QCOMPARE(std::get<JointPositions>(back.target)[0], bench.host.q[0] - 7);
    }

    void watchedContactEndsAnyMotion() {
        Bench bench;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.ask(RequestKind::WatchContact, 1, {0, 0, 1, 0, 0, 0});
        bench.hold(ScriptCommand::MoveL, 2, 5, {0.1, 0.2, 0.3, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.host.contact = 3;
        bench.hold(ScriptCommand::MoveL, 2, 2, {0.1, 0.2, 0.3, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Braking);
        bench.host.moveFrames = 2;
        bench.idleEpoch = 3;
        QCOMPARE(bench.ask(RequestKind::ReadContact).whole, 1);
    }

    // The motion back from the contact is part of the watched motion, so a stop ends it too.
    void aStopEndsTheReturnAfterAWatchedContact_data() {
        QTest::addColumn<bool>("stopped");
        QTest::newRow("to the end") << false;
        QTest::newRow("stopped") << true;
    }
    void aStopEndsTheReturnAfterAWatchedContact() {
        QFETCH(bool, stopped);
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.ask(RequestKind::WatchContact, 2, {0, 0, 1, 0, 0, 0});
        bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, -0.05, 0, 0, 0});
        bench.host.contact = 7;
        bench.host.moveFrames = 50;
        bench.hold(ScriptCommand::SpeedL, 2, 60, {0, 0, -0.05, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
        const auto* back = bench.last<urscript::Move>();
        QVERIFY(back != nullptr);
        QCOMPARE(std::get<JointPositions>(back->target)[0], bench.host.q[0] - 7);
        if (stopped) {
            bench.hold(ScriptCommand::Idle, 3, 2);
            QVERIFY(bench.last<urscript::StopJ>() != nullptr || bench.last<urscript::StopL>() != nullptr);
            return;
        }
        bench.hold(ScriptCommand::SpeedL, 2, 60, {0, 0, -0.05, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Contact);
        bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, -0.05, 0, 0, 0});  // the motion does not resume
        QVERIFY(bench.last<urscript::SpeedL>() == nullptr);
    }

    void anInitialForceIsNotAContact() {
        Bench bench;
        bench.host.contact = 2;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.ask(RequestKind::WatchContact, 1, {0, 0, 1, 0, 0, 0});
        bench.hold(ScriptCommand::SpeedL, 2, 5, {0, 0, -0.05, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.host.contact = 0;
        bench.hold(ScriptCommand::SpeedL, 2, 2, {0, 0, -0.05, 0, 0, 0});
        bench.host.contact = 3;
        bench.hold(ScriptCommand::SpeedL, 2, 2, {0, 0, -0.05, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Braking);
    }

    void movesContinueAfterTheClientSignsOff_data() {
        QTest::addColumn<ScriptCommand>("kind");
        QTest::addColumn<bool>("finishes");
        QTest::newRow("movej") << ScriptCommand::MoveJ << true;
        QTest::newRow("movel") << ScriptCommand::MoveL << true;
        QTest::newRow("section") << ScriptCommand::Section << true;
        QTest::newRow("speedl") << ScriptCommand::SpeedL << false;
        QTest::newRow("servoj") << ScriptCommand::ServoJ << false;
        QTest::newRow("until contact") << ScriptCommand::UntilContact << false;
        QTest::newRow("freedrive") << ScriptCommand::Freedrive << false;
    }
    void movesContinueAfterTheClientSignsOff() {
        QFETCH(ScriptCommand, kind);
        QFETCH(bool, finishes);
        Bench bench(RegisterRange::Upper, {5, 22, 0, 0}, QStringLiteral("sleep(0.4)"));
        bench.host.moveFrames = 200;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.mayFinish = true;
        bench.hold(kind, 2, 5, {0.1, 0.2, 0.3, 0, 0, 0});
        bench.frame(bench.silentFrames() + 10);
        QCOMPARE(bench.state() == ScriptState::Executing, finishes);
        bench.frame(400);
        QCOMPARE(bench.state(), finishes ? ScriptState::Done : ScriptState::Expired);
        bench.frame(static_cast<int>(6 / bench.host.step));
        QVERIFY(bench.running());  // the program waits for the next client
    }

    void aMoveMayHaveALongerHeartbeatTimeout_data() { movesContinueAfterTheClientSignsOff_data(); }
    void aMoveMayHaveALongerHeartbeatTimeout() {
        QFETCH(ScriptCommand, kind);
        QFETCH(bool, finishes);
        Bench bench(RegisterRange::Upper, {5, 22, 0, 0}, QStringLiteral("sleep(2)"));
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.heartbeatTimeoutMs = 500;
        bench.hold(kind, 2, 5, {0.1, 0.2, 0.3, 0, 0, 0});
        bench.host.moveFrames = 5;  // stops take 5 frames
        bench.frame(bench.silentFrames() + 10);
        QCOMPARE(bench.state() == ScriptState::Executing, finishes);
        bench.frame(bench.silentFrames() * 3);
        QCOMPARE(bench.state() == ScriptState::Executing, finishes);
        bench.frame(bench.silentFrames() * 2);  // after more than 0.5 s without heartbeat
        QCOMPARE(bench.state(), ScriptState::Expired);
    }

    void theHeartbeatTimeoutIsNotInherited() {
        Bench bench;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.heartbeatTimeoutMs = 2000;
        bench.hold(ScriptCommand::MoveJ, 2, 5);
        bench.heartbeatTimeoutMs = 0;
        bench.host.moveFrames = 5;
        bench.hold(ScriptCommand::Idle, 2, 60);
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::MoveL, 3, 5);
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.host.moveFrames = 5;
        bench.frame(bench.silentFrames() + 30);
        QCOMPARE(bench.state(), ScriptState::Expired);
    }

    void setpointsMayHaveADurationAndUseToolAxes() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command speed;
        speed.kind = ScriptCommand::SpeedL;
        speed.epoch = 2;
        speed.values = {0, 0, 0.1, 0, 0, 0};
        speed.speed = 0.05;
        speed.acceleration = speed.rotationAcceleration = 1;
        speed.choice = 2;
        speed.rotation = {3.14159265358979, 0, 0};
        bench.send(speed);
        bench.frame(2);
        QVERIFY(bench.last<urscript::SpeedL>() != nullptr);
        QVERIFY(std::abs(bench.last<urscript::SpeedL>()->xd.linear.z() + 0.1) < 1e-9);
        QCOMPARE(bench.last<urscript::SpeedL>()->duration, 0.05);
    }

    void anUnguardedServoFollowsItsTarget() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command unguarded = servo(ScriptCommand::ServoJ, 2, true);
        unguarded.choice = 2;
        unguarded.values = {2, 0, 0, 0, 0, 0};
        for (int i = 0; i < 5; ++i) {
            bench.send(unguarded);
            bench.frame();
        }
        QCOMPARE(bench.state(), ScriptState::Executing);
        QCOMPARE(bench.last<urscript::ServoJ>()->q[0], 2.0);
    }

    void torquesAreSentInEachPeriodAfterTheFirst() {
        Bench bench(RegisterRange::Upper, kHasTorque);
        bench.host.tcpVelocity = {};
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command none = torque(2, {});
        none.choice = 0;
        for (int i = 0; i < 5; ++i) {
            bench.send(none);
            bench.frame();
        }
        QVERIFY(bench.host.motions.empty());
        QCOMPARE(bench.state(), ScriptState::Executing);
        TorqueParameters friction;
        friction.viscousScale = {0, 1, 0.9, 0.123, 0.999, 0.57};
        friction.coulombScale = {1, 0, 0.8, 0.456, 0.001, 0.43};
        constexpr int kFrames = 20;
        for (int i = 0; i < kFrames; ++i) {
            bench.send(torque(2, JointTorques(1, -2, 3, -4, 5, -6), friction));
            bench.frame();
        }
        // The first torque is applied only after enough frames for all values to arrive.
        QCOMPARE(bench.count<urscript::DirectTorque>(), kFrames - 1);
        for (const auto& motion : bench.host.motions) {
            const auto* given = std::get_if<urscript::DirectTorque>(&motion.command);
            QVERIFY(given != nullptr);
            QCOMPARE(given->torque, JointTorques(1, -2, 3, -4, 5, -6));
            for (int i = 0; i < kJointCount; ++i) {
                const auto joint = static_cast<std::size_t>(i);
                QVERIFY(std::abs(given->viscous.value()[i] - friction.viscousScale[joint]) < 1e-9);
                QVERIFY(std::abs(given->coulomb.value()[i] - friction.coulombScale[joint]) < 1e-9);
            }
        }
        QVERIFY(bench.running());
    }

    void theEndOfTorquesIsDamped_data() {
        QTest::addColumn<int>("end");
        QTest::newRow("stop") << 0;
        QTest::newRow("silence") << 1;
        QTest::newRow("another motion") << 2;
        QTest::newRow("the end of the program") << 3;
    }
    void theEndOfTorquesIsDamped() {
        QFETCH(int, end);
        TorqueBench bench;
        QCOMPARE(bench.base(), std::optional(10.0));
        const auto goOn = [&] {
            if (end != 1) {
                bench.send(end == 0   ? ScriptCommand::Idle
                           : end == 2 ? ScriptCommand::MoveJ
                                      : ScriptCommand::End,
                           3, {1, 2, 3, 4, 5, 6});
            }
            bench.frame();
        };
        for (int i = 0; i < 60 && bench.state() != ScriptState::Braking; ++i) {
            QCOMPARE(bench.base(), std::optional(10.0));
            goOn();
        }
        QCOMPARE(bench.state(), ScriptState::Braking);
        // The damping starts in the same period. No command in between returns the joints to position
        // control.
        constexpr double kDamping = 30;
        const auto before = bench.host.motions.size();
        for (std::size_t i = 0; i < 10; ++i) {
            QCOMPARE(bench.host.motions.size(), before + i);
            const auto* given = bench.last<urscript::DirectTorque>();
            QVERIFY(given != nullptr);
            QVERIFY(std::abs(given->torque[0] + kDamping * bench.host.inertia * bench.host.qd[0]) < 1e-9);
            QCOMPARE(given->torque[1], 0.0);
            QVERIFY(given->viscous->isZero());
            QVERIFY(given->coulomb->isZero());
            bench.host.qd[0] *= 0.9;
            goOn();
        }
        // Once the arm is slow, it brakes as after any other motion.
        bench.host.qd[0] = 0.04;
        goOn();
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 4.0);
        bench.host.qd[0] = 0;
        for (int i = 0; i < 30; ++i) {
            goOn();
        }
        QCOMPARE(bench.count<urscript::StopJ>(), 1);
        QCOMPARE(bench.running(), end != 3);
        if (end == 1) {
            QCOMPARE(bench.state(), ScriptState::Expired);
        } else if (end == 2) {
            QCOMPARE(bench.state(), ScriptState::Executing);
            QVERIFY(bench.last<urscript::Move>() != nullptr);
        }
    }

    // If an external force keeps pushing the arm, position control takes over after 0.1 s.
    void theDampingTakesAtMost100Ms() {
        TorqueBench bench;
        const int before = bench.count<urscript::DirectTorque>();
        for (int i = 0; i < 100 && bench.last<urscript::StopJ>() == nullptr; ++i) {
            bench.hold(ScriptCommand::Idle, 3, 1);
        }
        QCOMPARE(bench.count<urscript::DirectTorque>() - before, 50);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
    }

    void theDampingStaysWithinTheJointTorqueLimits() {
        TorqueBench bench;
        bench.host.inertia = 100;
        bench.host.qd = JointVelocities(0.4, 0.2, 0, 0, 0, 0);
        bench.hold(ScriptCommand::Idle, 3, 1);
        const auto* given = bench.last<urscript::DirectTorque>();
        QVERIFY(given != nullptr);
        QVERIFY(std::abs(given->torque[0] + 150) < 1e-9);
        QVERIFY(std::abs(given->torque[1] + 75) < 1e-9);
    }

    void aHarderStopWaitsForTheDampingToo() {
        TorqueBench bench;
        bench.hold(ScriptCommand::Idle, 3, 3);
        bench.send(stopJ(4, 20));
        bench.frame();
        QVERIFY(bench.base().has_value());
        bench.host.qd[0] = 0.01;
        bench.send(stopJ(4, 20));
        bench.frame();
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 20.0);
    }

    void aStopBeforeTheFirstTorquesNeedsNoDamping() {
        TorqueBench bench;
        bench.hold(ScriptCommand::Idle, 3, 100);
        const int before = bench.count<urscript::DirectTorque>();
        Command none = torque(4, {});
        none.choice = 0;
        for (int i = 0; i < 5; ++i) {
            bench.send(none);
            bench.frame();
        }
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.hold(ScriptCommand::Idle, 5, 1);
        QCOMPARE(bench.state(), ScriptState::Braking);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.count<urscript::DirectTorque>(), before);
    }

    // During a pause, the controller has returned to position control and the arm has stopped.
    void noTorqueIsSentAfterAPause() {
        TorqueBench bench;
        const int before = bench.count<urscript::DirectTorque>();
        bench.host.timeNs += 200'000'000;
        bench.host.qd[0] = 0;
        bench.push(1);
        QCOMPARE(bench.state(), ScriptState::Braking);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
        QCOMPARE(bench.count<urscript::DirectTorque>(), before);
    }

    void torquesEndAboveTheCap_data() {
        QTest::addColumn<bool>("elbow");
        QTest::newRow("TCP") << false;
        QTest::newRow("elbow") << true;
    }
    void torquesEndAboveTheCap() {
        QFETCH(bool, elbow);
        TorqueBench bench;
        constexpr double kUpperArm = 0.425;
        bench.host.tcpVelocity.linear = {0, 0.24, 0};
        bench.host.qd = JointVelocities(0, 0.24 / kUpperArm, 0, 0, 0, 0);
        bench.push(5);
        QCOMPARE(bench.state(), ScriptState::Executing);
        if (elbow) {
            bench.host.qd[1] = 0.26 / kUpperArm;
        } else {
            bench.host.tcpVelocity.linear.y() = -0.26;
        }
        bench.push(1);
        QCOMPARE(bench.state(), ScriptState::Braking);
        QVERIFY(bench.base().value() <= 0.0);
        bench.host.qd = {};
        bench.host.tcpVelocity = {};
        bench.push(50);
        QCOMPARE(bench.state(), elbow ? ScriptState::ElbowTooFast : ScriptState::TcpTooFast);
        QVERIFY(bench.last<urscript::StopJ>() != nullptr);
    }

    void aPartialPackageLeavesNoPeriodWithoutTorque() {
        for (const bool first : {false, true}) {
            TorqueBench bench;
            bench.comesLate = [first](std::size_t i) {
                return first ? i >= kCommandSize / 2 : i < kCommandSize / 2;
            };
            for (int i = 0; i < 5; ++i) {
                const auto before = bench.host.motions.size();
                bench.hold(ScriptCommand::Idle, 3, 1);
                QCOMPARE(bench.host.motions.size(), before + 1);
                QVERIFY(bench.base().has_value());
                QVERIFY(bench.base().value() <= 10.0);
            }
            QCOMPARE(bench.state(), ScriptState::Braking);
        }
    }

    void onlySoftwareWithTorqueSupportReceivesTorques_data() {
        QTest::addColumn<QList<int>>("version");
        QTest::addColumn<bool>("has");
        QTest::newRow("CB3") << QList<int>{3, 15, 8} << false;
        QTest::newRow("5.25.0") << QList<int>{5, 25, 0} << false;
        QTest::newRow("5.25.1") << QList<int>{5, 25, 1} << true;
        QTest::newRow("10.11.0") << QList<int>{10, 11, 0} << false;
        QTest::newRow("10.12.0") << QList<int>{10, 12, 0} << false;
        QTest::newRow("10.12.1") << QList<int>{10, 12, 1} << true;
    }
    void onlySoftwareWithTorqueSupportReceivesTorques() {
        QFETCH(QList<int>, version);
        QFETCH(bool, has);
        const SoftwareVersion software{static_cast<std::uint32_t>(version[0]),
                                       static_cast<std::uint32_t>(version[1]),
                                       static_cast<std::uint32_t>(version[2]), 0};
        const QString text = controlScript(software, RegisterRange::Upper, 1, {}, kArm).text;
        QCOMPARE(text.contains(QLatin1String("direct_torque(")), has);
        QCOMPARE(text.contains(QLatin1String("get_mass_matrix(")), has);
        QVERIFY(!text.contains(QLatin1String("{{")));
        Bench bench(RegisterRange::Upper, software);
        bench.host.tcpVelocity = {};
        bench.hold(ScriptCommand::Idle, 1, 2);
        for (int i = 0; i < 20; ++i) {
            bench.send(torque(2, JointTorques(1, 0, 0, 0, 0, 0)));
            bench.frame();
        }
        QCOMPARE(bench.host.motions.empty(), !has);
        QVERIFY(bench.running());
        // A missing feature does not prevent the next motion.
        bench.hold(ScriptCommand::JogJoints, 3, 60, {0.1, 0, 0, 0, 0, 0});
        QVERIFY(bench.last<urscript::SpeedJ>() != nullptr);
    }

    void freedriveAndTeachModeEndWithTheirCommand() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command freedrive;
        freedrive.kind = ScriptCommand::Freedrive;
        freedrive.epoch = 2;
        freedrive.choice = 5;
        bench.send(freedrive);
        bench.frame(2);
        QVERIFY(called(bench, "freedrive"));
        QVERIFY(!called(bench, "end_freedrive"));
        bench.hold(ScriptCommand::Idle, 3, 40);
        QVERIFY(called(bench, "end_freedrive"));
        QCOMPARE(bench.state(), ScriptState::Ready);
        bench.host.calls.clear();
        bench.hold(ScriptCommand::Teach, 4, 3);
        bench.frame(bench.silentFrames() + 1);
        QVERIFY(called(bench, "end_freedrive"));
    }

    void forceModeEndsWithItsPermit_data() {
        QTest::addColumn<bool>("silence");
        QTest::newRow("permit taken back") << false;
        QTest::newRow("link lost") << true;
    }
    void forceModeEndsWithItsPermit() {
        QFETCH(bool, silence);
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.forcePermitted = true;
        bench.ask(RequestKind::Store, 0, {0, 0, 0, 0, 0, 0});
        bench.ask(RequestKind::Store, 6, {1, 1, 1, 1, 1, 1});
        QCOMPARE(bench.ask(RequestKind::ForceMode, 4 + 2 * 64, {0, 0, 10, 0, 0, 0}).outcome, Outcome::Done);
        QVERIFY(called(bench, "force_mode 2"));
        bench.hold(ScriptCommand::Idle, 1, 20);
        QVERIFY(!called(bench, "end_force_mode"));
        if (silence) {
            bench.frame(bench.silentFrames() + 1);
        } else {
            bench.forcePermitted = false;
            bench.hold(ScriptCommand::Idle, 1, 2);
        }
        QVERIFY(called(bench, "end_force_mode"));
    }

    void forceModeEndsWithAPause() {
        Bench bench;
        bench.forcePermitted = true;
        bench.hold(ScriptCommand::Idle, 1, 2);
        QCOMPARE(bench.ask(RequestKind::ForceMode, 4 + 2 * 64, {0, 0, 10, 0, 0, 0}).outcome, Outcome::Done);
        bench.host.calls.clear();
        bench.hold(ScriptCommand::Idle, 1, 10);
        QVERIFY(!called(bench, "end_force_mode"));
        // A package that arrived while the program was paused does not count as a heartbeat.
        bench.host.timeNs += 200'000'000;
        bench.hold(ScriptCommand::Idle, 1, 1);
        QVERIFY(called(bench, "end_force_mode"));
    }

    // The software has neither a clock nor a position record.
    void forceModeEndsWithAPauseOnOldSoftware() {
        for (const bool moves : {false, true}) {
            Bench bench(RegisterRange::Upper, {3, 15, 0, 0});
            bench.forcePermitted = true;
            bench.host.steady = false;
            bench.hold(ScriptCommand::Idle, 1, 2);
            QCOMPARE(bench.ask(RequestKind::ForceMode, 4 + 2 * 64, {0, 0, 10, 0, 0, 0}).outcome,
                     Outcome::Done);
            bench.host.calls.clear();
            bench.host.qd[1] = moves ? 0.1 : 0.01;
            bench.hold(ScriptCommand::Idle, 1, 3);
            QVERIFY(!called(bench, "end_force_mode"));
            bench.host.qd[1] = 0;
            bench.hold(ScriptCommand::Idle, 1, 1);
            QCOMPARE(called(bench, "end_force_mode"), moves);
        }
    }

    void forceModeDoesNotStartWithoutItsPermit() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        QCOMPARE(bench.ask(RequestKind::ForceMode, 4 + 2 * 64, {0, 0, 10, 0, 0, 0}).outcome,
                 Outcome::NotPermitted);
        QVERIFY(!called(bench, "force_mode 2"));
    }

    void modesStartedByASectionEndWithIt_data() {
        QTest::addColumn<QString>("end");
        QTest::newRow("stop") << "stop";
        QTest::newRow("silence") << "silence";
        QTest::newRow("its own end") << "its own end";
    }
    void modesStartedByASectionEndWithIt() {
        QFETCH(QString, end);
        const QString wait =
            end == QLatin1String("its own end") ? QStringLiteral("sync()") : QStringLiteral("sleep(100)");
        Bench bench(RegisterRange::Upper, {5, 22, 0, 0},
                    QStringLiteral("freedrive_mode()\nforce_mode(p[0,0,0,0,0,0], [0,0,1,0,0,0], "
                                   "[0,0,9,0,0,0], 2, [1,1,1,1,1,1])\n") +
                        wait);
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::Section, 2, 2);
        QVERIFY(called(bench, "force_mode 2"));
        if (end == QLatin1String("stop")) {
            bench.hold(ScriptCommand::Idle, 3, 2);
        } else if (end == QLatin1String("silence")) {
            bench.frame(bench.silentFrames() + 1);
        } else {
            bench.hold(ScriptCommand::Section, 2, 5);
        }
        QVERIFY(called(bench, "end_force_mode"));
        QVERIFY(called(bench, "end_freedrive"));
    }

    void aLaterStopNeverReducesTheDeceleration() {
        Bench bench;
        moveInEpoch2(bench);
        bench.send(stopJ(3, 8));
        bench.frame();
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 8.0);
        bench.send(stopJ(4, 0.2));
        bench.frame(2);
        bench.hold(ScriptCommand::Idle, 5, 2);  // a normal stop decelerates with 4 rad/s2
        QCOMPARE(bench.count<urscript::StopJ>(), 1);
        bench.send(stopJ(6, 12));
        bench.frame(2);
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 12.0);
    }

    void eachRequestIsServedOnceAndAnswered() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        const Answer first = bench.ask(RequestKind::SetPayload, 1, {1.5, 0, 0, 0.1, 0, 0});
        QCOMPARE(first.number, bench.request.number);
        QCOMPARE(first.outcome, Outcome::Done);
        QCOMPARE(bench.host.load.mass, 1.5);
        bench.host.load.mass = 9;
        bench.hold(ScriptCommand::Idle, 1, 20);  // the same request number repeatedly
        QCOMPARE(bench.host.load.mass, 9.0);
        QCOMPARE(bench.ask(RequestKind::SetTcp, 0, {0, 0, 0.2, 0, 0, 0}).outcome, Outcome::Done);
        QCOMPARE(bench.host.tcp.position.z(), 0.2);
        const Answer torques = bench.ask(RequestKind::JointTorques);
        QCOMPARE(torques.numbers[5], 6.0);
        QCOMPARE(bench.ask(RequestKind::StepTime).numbers[0], 0.002);
        bench.host.contact = 4;
        QCOMPARE(bench.ask(RequestKind::ToolContact).whole, 4);
        QCOMPARE(bench.ask(static_cast<RequestKind>(77)).outcome, Outcome::Unknown);
        QVERIFY(bench.running());
    }

    void inverseKinematicsReportsAMissingSolution() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        QCOMPARE(bench.ask(RequestKind::InverseKinematics, 0, {0.3, 0.2, 0.1, 0, 0, 0}).outcome,
                 Outcome::Done);
        bench.host.reachable = false;
        QCOMPARE(bench.ask(RequestKind::InverseKinematics, 0, {0.3, 0.2, 0.1, 0, 0, 0}).outcome,
                 Outcome::NoSolution);
        QVERIFY(bench.running());
    }

    void requestsOfAnotherSessionAreNotServed() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.request = {55, RequestKind::SetPayload, 0, {3, 0, 0, 0, 0, 0}};
        Command other;
        other.session = kSession + 1;
        other.epoch = 1;
        bench.send(other);
        bench.frame(5);
        QVERIFY(bench.host.load.mass != 3.0);
    }

    void functionsMissingInOldSoftwareAreLeftOut() {
        for (const auto& version : {SoftwareVersion{3, 5, 0, 0}, SoftwareVersion{5, 3, 0, 0}}) {
            const QString text = controlScript(version, RegisterRange::Lower, 1, {}, kArm).text;
            for (const char* name : {"tool_contact(", "get_inverse_kin_has_solution(",
                                     "get_freedrive_status(", "set_target_payload("}) {
                QVERIFY2(!text.contains(QLatin1String(name)), name);
            }
            QVERIFY(!text.contains(QLatin1String("{{")));
            Bench bench(RegisterRange::Lower, version);
            bench.hold(ScriptCommand::Idle, 1, 2);
            QCOMPARE(bench.ask(RequestKind::ToolContact).outcome, Outcome::Unknown);
        }
    }
};

QTEST_GUILESS_MAIN(TestControlScriptCommands)
#include "tst_control_script_commands.moc"
