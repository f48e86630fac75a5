// SPDX-License-Identifier: MIT
// The rules of control.script: one slot, epochs, time-to-live. The other tests are in
// tst_control_script_commands.cpp.
#include <QTest>

#include "tests/unit/robot/control/script_bench.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
namespace urscript = tiller::simulator::urscript;

namespace {

using Bench = ScriptBench;

}  // namespace

class TestControlScript : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void compilesForEverySoftware_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::newRow("CB3 3.15") << 3 << 15;
        QTest::newRow("e-Series 5.3, without get_steptime") << 5 << 3;
        QTest::newRow("e-Series 5.22") << 5 << 22;
        QTest::newRow("PolyScope X") << 10 << 11;
    }
    void compilesForEverySoftware() {
        QFETCH(int, major);
        QFETCH(int, minor);
        const SoftwareVersion version{static_cast<std::uint32_t>(major), static_cast<std::uint32_t>(minor), 0,
                                      0};
        for (const auto range : {RegisterRange::Lower, RegisterRange::Upper}) {
            Bench bench(range, version);
            bench.hold(ScriptCommand::Idle, 1, 3);
            QCOMPARE(bench.out(0), bench.sequence);
        }
    }

    // Functions that the controller does not support are omitted, together with the features that need them.
    void compilesWithoutOptionalFunctions_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"teach_mode", "servoc", "is_within_safety_limits",
                                 "enable_external_ft_sensor", "time", "direct_torque", "get_mass_matrix"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }
    void compilesWithoutOptionalFunctions() {
        QFETCH(QString, name);
        urscript::CompileOptions options;
        options.version = SoftwareVersion{5, 25, 1, 0};
        options.missing = {name.toStdString(), "end_" + name.toStdString()};
        const auto with = urscript::compile(
            controlScript(*options.version, RegisterRange::Upper, 1, {}, kArm).text.toStdString(), options);
        QVERIFY(!with);
        QCOMPARE(refusedName(QString::fromStdString(with.error.text)), name);
        const auto without = urscript::compile(
            controlScript(*options.version, RegisterRange::Upper, 1, {}, kArm, {}, {name}).text.toStdString(),
            options);
        QVERIFY2(bool(without), without.error.text.c_str());
    }
    void requiredFunctionsAreNotLeftOut() {
        QCOMPARE(refusedName(QStringLiteral("compile_error_name_not_found:speedl:")), QString());
        QCOMPARE(refusedName(QStringLiteral("syntax_error_on_line:3:teach_mode():")), QString());
    }

    // A controller may take two periods to transfer a package. Each period then contains a mixture of the two
    // newest packages.
    void aPartialPackageMovesNothing_data() {
        QTest::addColumn<int>("pattern");
        QTest::newRow("first half first") << 0;
        QTest::newRow("last half first") << 1;
        QTest::newRow("every other") << 2;
        QTest::newRow("the others") << 3;
    }
    void aPartialPackageMovesNothing() {
        QFETCH(int, pattern);
        Bench bench;
        bench.comesLate = [pattern](std::size_t i) {
            return pattern == 0   ? i >= kCommandSize / 2
                   : pattern == 1 ? i < kCommandSize / 2
                                  : i % 2 == static_cast<std::size_t>(pattern - 2);
        };
        bench.hold(ScriptCommand::Idle, 1, 3);
        const JointPositions there(0.3, -1, 1, -1, -1, 0.1);
        bench.hold(ScriptCommand::MoveJ, 2, 5, there.array());
        QCOMPARE(bench.count<urscript::Move>(), 1);
        const auto target = [](const urscript::Move& move) { return std::get<JointPositions>(move.target); };
        QCOMPARE(target(*bench.last<urscript::Move>()), there);
        // A second move directly follows the first move and uses the parameters of its own package.
        const JointPositions elsewhere(-0.2, -0.9, 1.1, -1.2, -1.4, 0.5);
        bench.hold(ScriptCommand::MoveJ, 3, 60, elsewhere.array());
        QCOMPARE(bench.count<urscript::Move>(), 2);
        QCOMPARE(target(*bench.last<urscript::Move>()), elsewhere);
        QCOMPARE(bench.state(), ScriptState::Done);
        // A stop takes effect, and the next motion is executed.
        bench.hold(ScriptCommand::JogCartesian, 4, 5, {0.05, 0, 0, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.hold(ScriptCommand::Idle, 5, 2);
        QCOMPARE(bench.state(), ScriptState::Braking);
        bench.hold(ScriptCommand::Idle, 5, 40);
        QCOMPARE(bench.state(), ScriptState::Ready);
        bench.hold(ScriptCommand::JogCartesian, 6, 4, {0.05, 0, 0, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
        // A direct change from one kind of motion to another, and a servo motion whose first target arrives
        // later.
        bench.hold(ScriptCommand::Idle, 7, 40);
        Command servo;
        servo.kind = ScriptCommand::ServoJ;
        servo.epoch = 8;
        servo.speed = 0.002;
        servo.acceleration = 0.1;
        servo.rotationAcceleration = 300;
        for (int i = 0; i < 10; ++i) {
            servo.choice = i < 5 ? 0 : 1;
            servo.values = i < 5 ? std::array<double, 6>{} : bench.host.q.array();
            bench.send(servo);
            bench.frame();
        }
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.hold(ScriptCommand::Idle, 9, 40);
        for (const auto& motion : bench.host.motions) {
            const auto* servoed = std::get_if<urscript::ServoJ>(&motion.command);
            QVERIFY(servoed == nullptr || (servoed->q == bench.host.q && servoed->lookahead >= 0.03));
        }
        // A request uses the parameters of its own package.
        bench.idleEpoch = 9;
        QCOMPARE(bench.ask(RequestKind::SetPayload, 1, {1.5, 0, 0, 0.1, 0, 0}).outcome, Outcome::Done);
        QCOMPARE(bench.host.load.mass, 1.5);
        QCOMPARE(bench.ask(RequestKind::SetPayload, 1, {2.5, 0, 0, 0.1, 0, 0}).outcome, Outcome::Done);
        QCOMPARE(bench.host.load.mass, 2.5);
        QVERIFY(bench.running());
    }

    // The script's own period counter does not advance during a pause, but the clock does.
    void commandsFromBeforeAPauseAreExpired() {
        for (const bool isMove : {false, true}) {
            Bench bench;
            bench.host.moveFrames = 1000;
            const ScriptCommand kind = isMove ? ScriptCommand::MoveJ : ScriptCommand::JogCartesian;
            bench.hold(ScriptCommand::Idle, 1, 2);
            bench.hold(kind, 2, 10, {0.1, 0, 0, 0, 0, 0});
            QCOMPARE(bench.state(), ScriptState::Executing);
            bench.host.timeNs += 90'000'000;
            bench.hold(kind, 2, 3, {0.1, 0, 0, 0, 0, 0});
            QCOMPARE(bench.state(), ScriptState::Executing);
            bench.host.timeNs += 110'000'000;
            bench.hold(kind, 2, 1, {0.1, 0, 0, 0, 0, 0});
            QCOMPARE(bench.state(), ScriptState::Braking);
            bench.hold(kind, 2, 1100, {0.1, 0, 0, 0, 0, 0});
            QCOMPARE(bench.state(), ScriptState::Expired);
        }
    }

    // The control program publishes its time without a client only after 0.5 s, when its client has also lost
    // control.
    void theTimeWithoutAClientIsCounted() {
        for (const auto range : {RegisterRange::Lower, RegisterRange::Upper}) {
            Bench bench(range);
            bench.hold(ScriptCommand::Idle, 1, 3);
            bench.frame(248);
            QCOMPARE(bench.out(2), 0);
            bench.frame(4);
            for (int i = 0; i < 100; ++i) {
                const int before = bench.out(2);
                QVERIFY2(before <= -500, qPrintable(QString::number(before)));
                bench.frame(50);
                QVERIFY(std::abs(before - bench.out(2) - 100) <= 1);
                if (bench.out(2) < -4800) {
                    break;
                }
            }
            bench.hold(ScriptCommand::Idle, 1, 1);
            QCOMPARE(bench.out(2), 0);
            bench.frame(2600);
            QVERIFY(!bench.running());
        }
    }

    void aMotionMayFinishWithoutAHeartbeat() {
        Bench bench;
        bench.mayFinish = true;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 3);
        bench.hold(ScriptCommand::MoveJ, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.frame(600);
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.frame(600);
        QCOMPARE(bench.state(), ScriptState::Done);
    }

    // Even if the arm is at standstill, program time may resume at the previous speed.
    void theArmIsStoppedHardAfterAPause() {
        for (const bool moves : {false, true}) {
            for (const auto kind : {ScriptCommand::JogJoints, ScriptCommand::JogCartesian}) {
                Bench bench;
                bench.hold(ScriptCommand::Idle, 1, 2);
                bench.hold(kind, 2, 10, {0.1, 0, 0, 0, 0, 0});
                bench.host.timeNs += 200'000'000;
                bench.host.qd[0] = moves ? 0.3 : 0.0;
                bench.host.tcpVelocity = {{0.1, 0, 0}, {0, 0, 0.25}};
                bench.frame();
                QCOMPARE(bench.state(), ScriptState::Braking);
                if (kind == ScriptCommand::JogJoints) {
                    QCOMPARE(bench.last<urscript::StopJ>()->deceleration, moves ? 4.0 : 400.0);
                } else {
                    QCOMPARE(bench.last<urscript::StopL>()->deceleration, moves ? 2.0 : 200.0);
                    QCOMPARE(bench.last<urscript::StopL>()->rotationDeceleration, moves ? 4.0 : 400.0);
                }
            }
        }
    }

    void aPauseIsDetectedWithoutAClock_data() {
        QTest::addColumn<int>("major");
        QTest::addColumn<int>("minor");
        QTest::newRow("5.16") << 5 << 16;
        QTest::newRow("5.0") << 5 << 0;
        QTest::newRow("CB3 3.15") << 3 << 15;
    }
    void aPauseIsDetectedWithoutAClock() {
        QFETCH(int, major);
        QFETCH(int, minor);
        constexpr double kSpeed = 0.1;
        const bool hasRecord = major == 5 && minor >= 4;
        for (const double slowingDown : {0.0, 0.02, 0.05}) {  // [s]
            Bench bench(RegisterRange::Upper,
                        {static_cast<std::uint32_t>(major), static_cast<std::uint32_t>(minor), 0, 0});
            std::vector<JointPositions> record;
            bench.host.steady = false;
            bench.host.history = [&](int steps) {
                return record[record.size() - static_cast<std::size_t>(steps)];
            };
            const auto hold = [&](ScriptCommand kind, int epoch) {
                bench.hold(kind, epoch, 1, {0, kSpeed, 0, 0, 0, 0});
                record.push_back(bench.host.q);
            };
            record.push_back(bench.host.q);
            hold(ScriptCommand::Idle, 1);
            hold(ScriptCommand::Idle, 1);
            for (int i = 0; i < 100; ++i) {
                // Accelerates as fast as an arm can.
                bench.host.qd[1] = std::min(kSpeed, bench.host.qd[1] + 40 * bench.host.step);
                bench.host.q[1] += bench.host.qd[1] * bench.host.step;
                hold(ScriptCommand::JogJoints, 2);
            }
            QCOMPARE(bench.state(), ScriptState::Executing);
            bench.host.q[1] += kSpeed * slowingDown;
            bench.host.qd[1] = 0;
            record.insert(record.end(), 60, bench.host.q);
            hold(ScriptCommand::JogJoints, 2);
            // Without a position record, a standstill without a braking distance does not reveal a pause.
            const bool shows = hasRecord || slowingDown > 0;
            QCOMPARE(bench.state(), shows ? ScriptState::Braking : ScriptState::Executing);
        }
    }

    void noPlaceholderIsLeftInTheScript() {
        const ControlScript script = controlScript({5, 22, 0, 0}, RegisterRange::Upper, 1, {}, kArm);
        QVERIFY(!script.text.contains(QLatin1String("{{")));
        QVERIFY(script.text.startsWith(QLatin1String("def ")));
        const QString source = QString::fromUtf8(controlScriptTemplate());
        const QString line = source.section(QLatin1Char('\n'), script.firstLine - 1, script.firstLine - 1);
        QVERIFY(line.startsWith(QLatin1String("def ")));
    }

    void answersWithSequenceEpochAndSession() {
        Bench bench;
        bench.frame();
        bench.send(ScriptCommand::Idle, 7);
        bench.frame();
        QCOMPARE(bench.out(0), bench.sequence);
        QCOMPARE(bench.out(1), 7);
        QCOMPARE(bench.state(), ScriptState::Ready);
        QCOMPARE(bench.out(3), kSession);
        QVERIFY(bench.host.motions.empty());
    }

    // Values left in the registers by an earlier client, such as a jog, cause no motion.
    void registersFoundAtTheStartMoveNothing() {
        Bench bench;
        Command left;
        left.kind = ScriptCommand::JogCartesian;
        left.epoch = 5;
        left.values = {0.1, 0, 0, 0, 0, 0};
        bench.send(left);
        bench.program.reset();
        const auto text =
            controlScript({5, 22, 0, 0}, RegisterRange::Upper, kSession, {}, kArm).text.toStdString();
        bench.program = std::make_unique<urscript::Interpreter>(urscript::compile(text).program, bench.host);
        bench.frame(100);
        QVERIFY(bench.host.motions.empty());
    }

    void packagesOfAnotherSessionAreIgnored() {
        Bench bench;
        for (int i = 0; i < 20; ++i) {
            Command other;
            other.session = kSession + 1;
            other.kind = ScriptCommand::JogCartesian;
            other.epoch = 3;
            bench.send(other);
            bench.frame();
        }
        QVERIFY(bench.host.motions.empty());
        QVERIFY(bench.out(0) != bench.sequence);
    }

    void aJogRunsEachFrameWithTheNewestValues() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 1, {0.05, 0, 0, 0, 0, 0});
        QCOMPARE(bench.count<urscript::SpeedL>(), 0);  // the second half of the package may still be missing
        bench.hold(ScriptCommand::JogCartesian, 2, 1, {0.05, 0, 0, 0, 0, 0});
        QCOMPARE(bench.count<urscript::SpeedL>(), 1);
        QCOMPARE(bench.state(), ScriptState::Executing);
        const auto* motion = bench.last<urscript::SpeedL>();
        QVERIFY(motion != nullptr);
        QVERIFY(near(motion->xd.linear, {0.05, 0, 0}));
        QCOMPARE(motion->acceleration, 1.4);
        QCOMPARE(motion->rotationAcceleration, 2.0);
        QCOMPARE(motion->duration.value(), 0.002);
        bench.hold(ScriptCommand::JogCartesian, 2, 10, {0, 0.02, 0, 0, 0, 0});
        QVERIFY(bench.count<urscript::SpeedL>() >= 10);
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, {0, 0.02, 0}));
        QCOMPARE(bench.count<urscript::StopL>(), 0);
    }

    void toolAndCustomFramesAreTransformedToTheBase() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        Command jog;
        jog.kind = ScriptCommand::JogCartesian;
        jog.epoch = 2;
        jog.choice = static_cast<std::int32_t>(JogFrame::Tool);
        jog.values = {0.01, 0.02, 0.03, 0.1, 0.2, 0.3};
        bench.send(jog);
        bench.frame(2);
        const Eigen::Matrix3d R = rotationMatrix(bench.host.tcpPose(urscript::Source::Target).rotation);
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, R * Eigen::Vector3d(0.01, 0.02, 0.03)));
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.angular, R * Eigen::Vector3d(0.1, 0.2, 0.3)));
        jog.epoch = 3;
        jog.choice = static_cast<std::int32_t>(JogFrame::Custom);
        jog.rotation = {0.3, -0.2, 0.5};
        bench.send(jog);
        bench.frame(2);
        const Eigen::Matrix3d C = rotationMatrix(Eigen::Vector3d(0.3, -0.2, 0.5));
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, C * Eigen::Vector3d(0.01, 0.02, 0.03)));
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.angular, C * Eigen::Vector3d(0.1, 0.2, 0.3)));
    }

    void aJointJogRunsSpeedj() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogJoints, 2, 6, {0, 0, 0.1, 0, 0, 0});
        QVERIFY(bench.count<urscript::SpeedJ>() >= 5);
        QCOMPARE(bench.last<urscript::SpeedJ>()->qd[2], 0.1);
    }

    void aStopBrakesInTheSameFrame_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<bool>("line");
        QTest::newRow("jog Cartesian") << 1 << true;
        QTest::newRow("jog joints") << 2 << false;
        QTest::newRow("movej") << 3 << false;
        QTest::newRow("movel") << 4 << true;
    }
    void aStopBrakesInTheSameFrame() {
        QFETCH(int, kind);
        QFETCH(bool, line);
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(static_cast<ScriptCommand>(kind), 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.host.tcpVelocity = {{0.1, 0, 0}, {0, 0, 0.25}};
        bench.send(ScriptCommand::Idle, 3);
        bench.frame();
        QCOMPARE(bench.state(), ScriptState::Braking);
        if (line) {
            QVERIFY(bench.last<urscript::StopL>() != nullptr);
            QCOMPARE(bench.last<urscript::StopL>()->deceleration, 2.0);
            QCOMPARE(bench.last<urscript::StopL>()->rotationDeceleration, 4.0);
        } else {
            QVERIFY(bench.last<urscript::StopJ>() != nullptr);
            QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 4.0);
        }
        const auto before = bench.host.motions.size();
        bench.hold(ScriptCommand::Idle, 3, 40);
        QCOMPARE(bench.state(), ScriptState::Ready);
        QCOMPARE(bench.host.motions.size(), before);
    }

    void repliesContinueWhileTheArmBrakes() {
        Bench bench;
        bench.host.moveFrames = 200;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 5);
        for (int i = 0; i < 100; ++i) {
            bench.send(ScriptCommand::Idle, 3);
            bench.frame();
            QCOMPARE(bench.out(0), bench.sequence);
        }
        QCOMPARE(bench.state(), ScriptState::Braking);
    }

    void missingHeartbeatEndsEveryMotion_data() { aStopBrakesInTheSameFrame_data(); }
    void missingHeartbeatEndsEveryMotion() {
        QFETCH(int, kind);
        const auto command = static_cast<ScriptCommand>(kind);
        Bench bench;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(command, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.frame(bench.silentFrames() - 1);
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.frame();
        QCOMPARE(bench.state(), ScriptState::Braking);
        bench.host.moveFrames = 3;
        // The same epoch, received late, is not executed again.
        const auto before = bench.host.motions.size();
        bench.hold(command, 2, 2000, {0.1, 0, 0, 0, 0, 0});
        QCOMPARE(bench.host.motions.size(), before);
        QCOMPARE(bench.state(), ScriptState::Expired);
        // Another press starts another epoch.
        bench.hold(command, 3, 2, {0.1, 0, 0, 0, 0, 0});
        QCOMPARE(bench.state(), ScriptState::Executing);
    }

    // The deceleration increases with the speed. The arm is at standstill 210 ms after the newest package.
    void brakingEndsInTime_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("turning");  // of the leading joint [rad/s]
        QTest::addColumn<double>("speed");    // of the TCP [m/s]
        QTest::addColumn<double>("silent");   // deceleration when the heartbeat is missing
        QTest::addColumn<double>("asked");    // deceleration when a stop command arrives
        QTest::newRow("movej, slow") << 3 << 0.4 << 0.1 << 4.0 << 4.0;
        QTest::newRow("movej, default speed") << 3 << 1.05 << 0.5 << 1.05 / 0.11 << 1.05 / 0.21;
        QTest::newRow("movej, fast") << 3 << 3.0 << 1.5 << 3.0 / 0.11 << 3.0 / 0.21;
        QTest::newRow("movej, faster than any joint") << 3 << 6.28 << 3.0 << 40.0 << 6.28 / 0.21;
        QTest::newRow("movel, slow") << 4 << 0.4 << 0.1 << 2.0 << 2.0;
        QTest::newRow("movel, default speed") << 4 << 0.4 << 0.25 << 0.25 / 0.11 << 2.0;
        QTest::newRow("movel, fast") << 4 << 2.0 << 1.0 << 1.0 / 0.11 << 1.0 / 0.21;
        QTest::newRow("speedj") << 14 << 3.0 << 1.5 << 3.0 / 0.11 << 3.0 / 0.21;
        QTest::newRow("speedl") << 15 << 2.0 << 1.0 << 1.0 / 0.11 << 1.0 / 0.21;
        QTest::newRow("servoj") << 11 << 3.0 << 1.5 << 3.0 / 0.11 << 3.0 / 0.21;
    }
    void brakingEndsInTime() {
        QFETCH(int, kind);
        QFETCH(double, turning);
        QFETCH(double, speed);
        QFETCH(double, silent);
        QFETCH(double, asked);
        const auto command = static_cast<ScriptCommand>(kind);
        for (const bool stopped : {false, true}) {
            Bench bench;
            bench.host.moveFrames = 1000;
            bench.hold(ScriptCommand::Idle, 1, 2);
            bench.hold(command, 2, 5, {0.1, 0, 0, 0, 0, 0});
            bench.host.qd[0] = turning;
            bench.host.tcpVelocity = {{speed, 0, 0}, {0, 0, 0}};
            if (stopped) {
                bench.send(ScriptCommand::Idle, 3);
                bench.frame();
            } else {
                bench.frame(bench.silentFrames());
            }
            QCOMPARE(bench.state(), ScriptState::Braking);
            const auto* line = bench.last<urscript::StopL>();
            const auto* joints = bench.last<urscript::StopJ>();
            QVERIFY(line != nullptr || joints != nullptr);
            const double actual = line != nullptr ? line->deceleration : joints->deceleration;
            QVERIFY2(std::abs(actual - (stopped ? asked : silent)) < 1e-6,
                     qPrintable(QString::number(actual)));
        }
    }

    // A gentle stop continues only while the client monitors it.
    void aGentleStopEndsInTimeWithoutTheClient() {
        Bench bench;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveJ, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.host.qd[0] = 1.05;
        Command stop;
        stop.kind = ScriptCommand::Idle;
        stop.epoch = 3;
        stop.choice = 1;
        stop.acceleration = 0.5;
        bench.send(stop);
        bench.frame();
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 0.5);
        bench.host.qd[0] = 1.0;
        bench.frame(bench.silentFrames() - 1);
        QCOMPARE(bench.count<urscript::StopJ>(), 1);
        bench.frame(2);
        QVERIFY(std::abs(bench.last<urscript::StopJ>()->deceleration - 1.0 / 0.11) < 1e-6);
        bench.frame(20);
        QCOMPARE(bench.count<urscript::StopJ>(), 2);
    }

    // A normal stop also replaces a gentler stop in progress.
    void aStopEndsAGentlerOneInTime() {
        Bench bench;
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveJ, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.host.qd[0] = 3.0;
        Command stop;
        stop.kind = ScriptCommand::Idle;
        stop.epoch = 3;
        stop.choice = 1;
        stop.acceleration = 5;
        bench.send(stop);
        bench.frame();
        QCOMPARE(bench.last<urscript::StopJ>()->deceleration, 5.0);
        bench.hold(ScriptCommand::Idle, 4, 2);
        QVERIFY(std::abs(bench.last<urscript::StopJ>()->deceleration - 3.0 / 0.21) < 1e-6);
        bench.hold(ScriptCommand::Idle, 4, 20);
        QCOMPARE(bench.count<urscript::StopJ>(), 2);
    }

    void theTimeToLiveIsAlso100MsOnOldControllers() {
        Bench bench(RegisterRange::Lower, {3, 15, 0, 0});
        bench.host.moveFrames = 1000;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 3, {0.1, 0, 0, 0, 0, 0});
        bench.frame(12);  // 96 ms
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.frame();
        QCOMPARE(bench.state(), ScriptState::Braking);
    }

    void anOlderEpochIsNeverObeyed() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 10, 2);
        bench.hold(ScriptCommand::JogCartesian, 9, 20, {0.1, 0, 0, 0, 0, 0});
        bench.hold(ScriptCommand::JogCartesian, 10, 20, {0.1, 0, 0, 0, 0, 0});
        QVERIFY(bench.host.motions.empty());
        bench.hold(ScriptCommand::JogCartesian, 11, 2, {0.1, 0, 0, 0, 0, 0});
        QVERIFY(!bench.host.motions.empty());
    }

    void aMoveRunsOnceAndIsReportedDone() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveJ, 2, 10, {1, 2, 3, 4, 5, 6});
        QCOMPARE(bench.state(), ScriptState::Executing);
        bench.hold(ScriptCommand::MoveJ, 2, 60, {1, 2, 3, 4, 5, 6});
        QCOMPARE(bench.state(), ScriptState::Done);
        QCOMPARE(bench.out(1), 2);
        QCOMPARE(bench.host.motions.size(), 1U);
        const auto& move = std::get<urscript::Move>(bench.host.motions.front().command);
        QCOMPARE(move.kind, urscript::Move::Kind::J);
        QCOMPARE(std::get<JointPositions>(move.target)[4], 5.0);
        QCOMPARE(move.velocity, 0.5);
        QCOMPARE(move.acceleration, 1.4);
    }

    void aLinearMoveGoesToThePose() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveL, 2, 3, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
        const auto& move = std::get<urscript::Move>(bench.host.motions.front().command);
        QCOMPARE(move.kind, urscript::Move::Kind::L);
        QCOMPARE(std::get<Pose>(move.target).rotation.z(), 0.6);
    }

    void aMoveKeepsItsTargetForTheSameEpoch() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveJ, 2, 3, {1, 1, 1, 1, 1, 1});
        bench.hold(ScriptCommand::MoveJ, 2, 60, {9, 9, 9, 9, 9, 9});
        QCOMPARE(bench.host.motions.size(), 1U);
    }

    void aNewMoveStopsTheOldOneFirst() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::MoveJ, 2, 5, {1, 1, 1, 1, 1, 1});
        bench.hold(ScriptCommand::MoveL, 3, 60, {2, 2, 2, 0, 0, 0});
        QCOMPARE(bench.count<urscript::StopJ>(), 1);
        QVERIFY(bench.host.motions.size() == 3);
        const auto& move = std::get<urscript::Move>(bench.host.motions.back().command);
        QCOMPARE(move.kind, urscript::Move::Kind::L);
        QCOMPARE(std::get<Pose>(move.target).position.x(), 2.0);
    }

    void aJogOfTheSameKindTakesOverWithoutAStop() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.hold(ScriptCommand::JogCartesian, 3, 5, {0, 0.1, 0, 0, 0, 0});
        QCOMPARE(bench.count<urscript::StopL>(), 0);
        QCOMPARE(bench.out(1), 3);
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, {0, 0.1, 0}));
        bench.hold(ScriptCommand::JogJoints, 4, 60, {0.1, 0, 0, 0, 0, 0});
        QCOMPARE(bench.count<urscript::StopL>(), 1);
        QVERIFY(bench.last<urscript::SpeedJ>() != nullptr);
    }

    // Press, release and press while the arm is still braking: the second motion begins after the braking has
    // ended.
    void aPressDuringBrakingWaitsForStandstill() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.hold(ScriptCommand::Idle, 3, 2);
        const int before = bench.count<urscript::SpeedL>();
        bench.hold(ScriptCommand::JogCartesian, 4, 5, {-0.1, 0, 0, 0, 0, 0});
        QCOMPARE(bench.count<urscript::SpeedL>(), before);
        bench.hold(ScriptCommand::JogCartesian, 4, 40, {-0.1, 0, 0, 0, 0, 0});
        QVERIFY(bench.count<urscript::SpeedL>() > before);
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, {-0.1, 0, 0}));
    }

    void unknownCommandsMoveNothing() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(static_cast<ScriptCommand>(77), 2, 50);
        QVERIFY(bench.host.motions.empty());
        QVERIFY(bench.running());
    }

    void endStopsTheArmAndTheProgram() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 5, {0.1, 0, 0, 0, 0, 0});
        bench.hold(ScriptCommand::End, 3, 3);
        QVERIFY(bench.running());
        QVERIFY(bench.last<urscript::StopL>() != nullptr);
        bench.hold(ScriptCommand::End, 3, 40);
        QVERIFY(!bench.running());
    }

    void aProgramWithoutAClientEnds() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.frame(2490);
        QVERIFY(bench.running());
        bench.frame(20);
        QVERIFY(!bench.running());
    }

    // A rotation keeps the TCP at its initial position, and deviations are corrected.
    void aRotationKeepsTheTcpInPlace() {
        Bench bench;
        bench.hold(ScriptCommand::Idle, 1, 2);
        bench.hold(ScriptCommand::JogCartesian, 2, 2, {0, 0, 0, 0, 0, 0.5});
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.linear, {0, 0, 0}));
        QVERIFY(near(bench.last<urscript::SpeedL>()->xd.angular, {0, 0, 0.5}));
    }
};

QTEST_GUILESS_MAIN(TestControlScript)
#include "tst_control_script.moc"
