// SPDX-License-Identifier: MIT
//
// Modifications of a path (offsets, conveyors), and stops and slow-downs: unknown loads, reduced mode, hard
// contact. Programs are sent over the primary interface, and results are received over RTDE, in virtual time.

#include <QSet>
#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/integration/motion/recorded_robot.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// The largest acceleration of any joint, computed from the target speeds of adjacent samples [rad/s2].
double worstAcceleration(const std::vector<MotionSample>& samples) {
    double worst = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double dt = samples[i].time - samples[i - 1].time;
        for (std::size_t j = 0; j < 6; ++j) {
            worst = std::max(worst, std::abs(samples[i].targetQd[j] - samples[i - 1].targetQd[j]) / dt);
        }
    }
    return worst;
}

/// Error codes among the current messages of the primary stream.
std::vector<qint32> errorCodes(RecordedRobot& robot) {
    std::vector<qint32> codes;
    for (const QByteArray& message : robot.script.messages(6)) {
        codes.push_back(intAt(message, 0));
    }
    return codes;
}

/// The newest value of an INT32 output, which a separate client receives.
class Watched {
public:
    Watched(RecordedRobot& robot, const QByteArray& name) : robot_(robot), rtde_(robot.robot.rtde()) {
        ready =
            rtde_.useVersion() && rtde_.setupOutputs(500, name) == QByteArray("\x01INT32") && rtde_.start();
    }
    qint32 now() {
        robot_.step();
        return intAt(rtde_.packages().back().payload, 1);
    }
    bool ready = false;

private:
    RecordedRobot& robot_;
    RawRtde rtde_;
};

QByteArray number(double value) {
    return QByteArray::number(value, 'g', 17);
}

}  // namespace

class TestMotionFeatures : public QObject {
    Q_OBJECT

    std::unique_ptr<RecordedRobot> robot_;

    const MotionSample& now() const { return robot_->now(); }
    bool stopped(double seconds) {
        return robot_->until([this] { return (now().safetyBits >> 2 & 1U) != 0; }, seconds);
    }

private Q_SLOTS:
    void init() {
        robot_ = std::make_unique<RecordedRobot>();
        QVERIFY(robot_->ready);
        robot_->step();
    }
    void cleanup() {
        // With any path modification, no joint may exceed its limits.
        QVERIFY2(worstAcceleration(robot_->samples) < 41,
                 qPrintable(QString::number(worstAcceleration(robot_->samples))));
        robot_.reset();
    }

    void anOffsetIsAddedToThePath_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<QByteArray>("offset");
        QTest::addColumn<QByteArray>("along");  // expected effect along the base axes
        // The line is along -x, and the tool axis z points nearly straight down.
        QTest::newRow("base") << 1 << QByteArray("p[0,0,d,0,0,0]") << QByteArray("z");
        QTest::newRow("tool") << 2 << QByteArray("p[0,0,-d,0,0,0]") << QByteArray("z");
        QTest::newRow("motion, across") << 3 << QByteArray("p[0,d,0,0,0,0]") << QByteArray("y");
        QTest::newRow("world") << 4 << QByteArray("p[0,0,d,0,0,0]") << QByteArray("z");
    }
    void anOffsetIsAddedToThePath() {
        QFETCH(int, type);
        QFETCH(QByteArray, offset);
        QFETCH(QByteArray, along);
        const Six start = now().targetPose;
        robot_->send(
            "def weave():\n  path_offset_enable()\n  path_offset_set_alpha_filter(0.2)\n"
            "  thread wave():\n    t = 0.0\n    while True:\n      t = t + get_steptime()\n"
            "      d = 0.01 * sin(6.2831853 * t)\n      path_offset_set(" +
            offset + ", " + QByteArray::number(type) +
            ")\n      write_output_float_register(0, d)\n"
            "      along = get_target_tcp_pose()\n"
            "      write_output_float_register(1, along[0])\n      sync()\n    end\n  end\n"
            "  w = run wave()\n  p = get_target_tcp_pose()\n  p[0] = p[0] - 0.2\n"
            "  write_output_integer_register(0, 1)\n  movel(p, a=0.5, v=0.1)\n"
            "  write_output_integer_register(0, 2)\n  kill w\n  path_offset_disable()\nend\n");
        QVERIFY(robot_->until([this] { return now().runtime == 2; }, 1));
        QVERIFY(robot_->until([this] { return now().runtime == 1; }, 20));
        const std::size_t axis = along == "y" ? 1 : 2;
        double highest = 0;
        double worst = 0;
        double worstAlong = 0;
        for (const MotionSample& s : robot_->marked(1)) {
            const double off = s.targetPose[axis] - start[axis];
            highest = std::max(highest, std::abs(off));
            // The filter lags by some periods. Across the path, the sign depends on the tangent.
            worst = std::max(worst, std::abs(std::abs(off) - std::abs(s.value[0])));
            worstAlong = std::max(worstAlong, std::abs(s.value[1] - s.targetPose[0]));
        }
        QVERIFY2(highest > 0.0095 && highest < 0.0105, qPrintable(QString::number(highest)));
        QVERIFY2(worst < 1.5e-3, qPrintable(QString::number(worst)));
        QVERIFY(worstAlong < 2e-3);
        QVERIFY(now().speed() < 1e-3);
    }

    void aJumpOfTheOffsetIsFollowedSmoothly() {
        const Six start = now().targetPose;
        QVERIFY(
            robot_->execute("def jump():\n  path_offset_enable()\n  path_offset_set(p[0,0,0.05,0,0,0.1], 1)\n"
                            "  sleep(2)\n  write_output_integer_register(0, 1)\n  sync()\n  sync()\n"
                            "  path_offset_disable()\nend\n"));
        const MotionSample there = robot_->marked(1).front();
        QVERIFY(std::abs(there.targetPose[2] - start[2] - 0.05) < 1e-6);
        QVERIFY(there.speed() < 1e-6);
        // The arm remains at its new position.
        QVERIFY(std::abs(now().targetPose[2] - start[2] - 0.05) < 1e-5);
    }

    void offsetsAreLimited() {
        const Six start = now().targetPose;
        QVERIFY(robot_->execute(
            "def far():\n  path_offset_set_max_offset(0.02, 0.1)\n  path_offset_enable()\n"
            "  path_offset_set(p[0,0,0.5,0,0,0], 1)\n  sleep(2)\n  p = path_offset_get(1)\n"
            "  write_output_float_register(0, p[2])\n  sync()\n  path_offset_disable()\nend\n"));
        QVERIFY(std::abs(now().value[0] - 0.02) < 1e-9);
        QVERIFY(std::abs(now().targetPose[2] - start[2] - 0.02) < 1e-5);
    }

    void forceModeAndOffsetsAreMutuallyExclusive() {
        QVERIFY(robot_->execute(
            "def both():\n  path_offset_enable()\n"
            "  force_mode(p[0,0,0,0,0,0],[0,0,1,0,0,0],[0,0,-10,0,0,0],2,[0.1,0.1,0.1,1,1,1])\n"
            "end\n"));
        QCOMPARE(robot_->script.messages(10).size(), std::size_t(1));
    }

    void aLinearConveyorCarriesTheArm() {
        const double start = now().targetPose[1];
        robot_->robot.controller.changeWorld(
            [](simulator::arm::Environment& world) { world.setConveyorSpeed(0, 1000); });
        // With 10 000 ticks per metre, the conveyor runs at 0.1 m/s along -y. On the conveyor, the arm moves
        // up and down.
        QVERIFY(robot_->execute(
            "def pick():\n  encoder_enable_pulse_decode(0, 1, 0, 1)\n"
            "  p = get_target_tcp_pose()\n  track_conveyor_linear(p[0,-1,0,0,0,0], 10000, 0)\n"
            "  sleep(1)\n  write_output_integer_register(0, 1)\n"
            "  p[2] = p[2] + 0.05\n  movel(p, a=0.5, v=0.2)\n  p[2] = p[2] - 0.05\n  movel(p, a=0.5, v=0.2)\n"
            "  write_output_integer_register(0, 2)\n  write_output_float_register(0, "
            "encoder_get_tick_count(0))\n"
            "  stop_conveyor_tracking(5)\n  write_output_integer_register(0, 3)\n  sync()\nend\n"));
        const auto on = robot_->marked(1);
        QVERIFY(on.size() > 300);
        for (std::size_t i = 1; i < on.size(); ++i) {
            const double speed = (on[i].target() - on[i - 1].target()).y() / (on[i].time - on[i - 1].time);
            QVERIFY2(std::abs(speed + 0.1) < 1e-3, qPrintable(QString::number(speed)));
        }
        // The distance that the arm followed the conveyor corresponds to the encoder count.
        QVERIFY(std::abs(on.front().targetPose[2] - on.back().targetPose[2]) < 1e-3);
        QVERIFY(std::abs(start - now().targetPose[1] - now().value[0] / 10000) < 0.03);
        QVERIFY(robot_->marked(3).front().speed() < 1e-6);
    }

    void aTurntableCarriesTheArmAndTurnsTheTool_data() {
        QTest::addColumn<bool>("turns");
        QTest::newRow("keeps its orientation") << false;
        QTest::newRow("turns along") << true;
    }
    void aTurntableCarriesTheArmAndTurnsTheTool() {
        QFETCH(bool, turns);
        robot_->robot.controller.changeWorld(
            [](simulator::arm::Environment& world) { world.setConveyorSpeed(1, 100); });
        const Pose start = Pose::fromArray(now().targetPose);
        const Eigen::Vector3d centre = start.position + Eigen::Vector3d(0.1, 0, 0);
        robot_->send(
            "def turntable():\n  encoder_enable_pulse_decode(1, 1, 2, 3)\n  track_conveyor_circular(p[" +
            number(centre.x()) + ',' + number(centre.y()) +
            ",0,0,0,0], 1000, rotate_tool=" + (turns ? "True" : "False") +
            ", encoder_index=1)\n  sleep(2)\n"
            "  write_output_integer_register(0, 1)\n  sync()\n  stop_conveyor_tracking()\nend\n");
        QVERIFY(robot_->until([this] { return now().mark == 1; }, 5));
        const Pose there = Pose::fromArray(now().targetPose);
        QVERIFY(std::abs((there.position - centre).norm() - 0.1) < 1e-3);
        const Eigen::Vector3d before = start.position - centre;
        const Eigen::Vector3d after = there.position - centre;
        // 100 ticks per second at 1000 ticks per turn, for two seconds.
        const double angle = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
        QVERIFY2(std::abs(angle - 0.4 * std::numbers::pi) < 0.02, qPrintable(QString::number(angle)));
        const Eigen::AngleAxisd turned(
            Eigen::Matrix3d(there.transform().linear() * start.transform().linear().transpose()));
        QVERIFY(std::abs(turned.angle() - (turns ? 0.4 * std::numbers::pi : 0.0)) < 0.02);
        QVERIFY(robot_->until([this] { return now().runtime == 1; }, 5));
    }

    void anEncoderCountsPulsesOfDigitalInputs() {
        robot_->send(
            "def count():\n  encoder_enable_pulse_decode(0, 1, 0, 1)\n"
            "  write_output_integer_register(0, 1)\n  while True:\n"
            "    write_output_float_register(0, encoder_get_tick_count(0))\n    sync()\n  end\nend\n");
        QVERIFY(robot_->until([this] { return now().mark == 1; }, 1));
        const auto phase = [this](bool a, bool b) {
            robot_->robot.controller.setDigitalInput(0, a);
            robot_->robot.controller.setDigitalInput(1, b);
            robot_->step(3);
        };
        for (int n = 0; n < 3; ++n) {
            phase(true, false);
            phase(true, true);
            phase(false, true);
            phase(false, false);
        }
        QCOMPARE(now().value[0], 12.0);
        phase(false, true);
        phase(true, true);
        QCOMPARE(now().value[0], 10.0);
        Watched pulses(*robot_, "encoder0_raw");
        Watched reported(*robot_, "encoder1_raw");
        QVERIFY(pulses.ready && reported.ready);
        QCOMPARE(pulses.now(), 10);
        QCOMPARE(reported.now(), 0);
        // A count set by a program wraps around as configured.
        robot_->send(
            "def counts():\n  encoder_enable_set_tick_count(1, 2)\n"
            "  encoder_set_tick_count(1, 65530)\n  encoder_set_tick_count(1, 65540)\n"
            "  write_output_float_register(1, encoder_get_tick_count(1))\n"
            "  write_output_integer_register(0, 2)\n  sync()\nend\n");
        QVERIFY(robot_->until([this] { return now().mark == 2; }, 2));
        QCOMPARE(now().value[1], 4.0);
        QCOMPARE(reported.now(), 4);
    }

    void aScrewdriverPressesAlongItsTool() {
        const double z = now().targetPose[2];
        robot_->robot.controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.005}});
        });
        QVERIFY(
            robot_->execute("def screw():\n  zero_ftsensor()\n  screw_driving(15, 0.05)\n  sleep(3)\n"
                            "  write_output_integer_register(0, 1)\n  sleep(0.5)\n"
                            "  write_output_integer_register(0, 2)\n  end_screw_driving()\nend\n"));
        for (const MotionSample& s : robot_->marked(1)) {
            QVERIFY2(std::abs(s.force[2] - 15) < 1, qPrintable(QString::number(s.force[2])));
        }
        for (const MotionSample& s : robot_->samples) {
            QVERIFY(s.targetPose[2] - z > -0.02);
        }
    }

    void excessiveLoadCausesAProtectiveStop() {
        robot_->robot.controller.changeWorld([](simulator::arm::Environment& world) {
            simulator::arm::Payload load;
            load.mass = 80;
            world.setLoad(load);
        });
        QVERIFY(stopped(1));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{155});
    }

    void freedriveDoesNotStartWithAWrongPayload() {
        robot_->robot.controller.changeWorld([](simulator::arm::Environment& world) {
            simulator::arm::Payload load;
            load.mass = 8;
            world.setLoad(load);
        });
        robot_->step(5);
        robot_->send("def free():\n  freedrive_mode()\n  sleep(1)\nend\n");
        QVERIFY(stopped(1));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{156});
    }

    void freedriveWithoutTheCheckSinksUnderAWrongPayload() {
        robot_->robot.controller.changeWorld([](simulator::arm::Environment& world) {
            simulator::arm::Payload load;
            load.mass = 8;
            world.setLoad(load);
        });
        robot_->step(5);
        const double z = now().targetPose[2];
        QVERIFY(
            robot_->execute("def free():\n  freedrive_mode_no_incorrect_payload_check()\n  sleep(0.5)\n"
                            "  end_freedrive_mode()\nend\n"));
        QVERIFY(now().targetPose[2] < z - 0.01);
        QCOMPARE(now().safetyBits, 1U);
    }

    void aHardContactStopsProtectivelyAndEndsTheForce() {
        const double z = now().targetPose[2];
        robot_->robot.controller.changeWorld([z](simulator::arm::Environment& world) {
            world.addPlane({.point = {0, 0, z - 0.05}});
        });
        robot_->send(
            "def hit():\n  p = get_target_tcp_pose()\n  p[2] = p[2] - 0.1\n  movel(p, a=1, v=0.2)\nend\n");
        QVERIFY(stopped(5));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{158});
        QVERIFY(robot_->until([this] { return now().speed() == 0; }, 1));
        QVERIFY(now().targetPose[2] > z - 0.075);
    }

    void aJointAtTheEndOfItsRangeIsAProtectiveStop() {
        QVERIFY(robot_->execute(
            "def near():\n  q = get_target_joint_positions()\n  q[5] = 6.2\n  set_pos(q)\nend\n"));
        robot_->send(
            "def over():\n  while True:\n    speedj([0,0,0,0,0,0.5], 2, get_steptime())\n  end\nend\n");
        QVERIFY(stopped(5));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{150});
        QVERIFY(now().targetQ[5] < 6.3355451848);
    }

    void aTorqueThatMakesAJointTooFastIsAProtectiveStop() {
        auto options = VirtualRobot::options();
        options.software = {5, 25, 0, 1254000};
        robot_ = std::make_unique<RecordedRobot>(options);
        QVERIFY(robot_->ready);
        robot_->send("def torque():\n  while True:\n    direct_torque([30,0,0,0,0,0])\n  end\nend\n");
        QVERIFY(stopped(5));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{153});
    }

    void forceModeThatLeavesThePathIsAProtectiveStop() {
        // The elbow already moves at its speed limit, so the other axes must make the motion required by the
        // force.
        robot_->send(
            "def leave():\n  force_mode(p[0,0,0,0,0,0], [0,0,1,0,0,0], [0,0,80,0,0,0], 2,"
            " [0.003,0.003,1,0.03,0.03,0.03])\n  q = get_target_joint_positions()\n  q[2] = q[2] + 2\n"
            "  movej(q, a=30, v=3.3)\nend\n");
        QVERIFY(stopped(5));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{159});
    }

    void aPathThroughASingularPositionIsAProtectiveStop() {
        QVERIFY(robot_->execute("def up():\n  set_pos([0,-1.2,0.6,-1,-1.5707,0])\nend\n"));
        robot_->send(
            "def out():\n  p = get_target_tcp_pose()\n  p[0] = p[0] - 0.6\n  movel(p, a=1, v=0.25)\nend\n");
        QVERIFY(stopped(10));
        QCOMPARE(errorCodes(*robot_), std::vector<qint32>{154});
    }

    void reducedModeSlowsThePath() {
        const Six start = now().targetPose;
        robot_->robot.controller.reducedMode(true);
        robot_->run(0.6);
        QVERIFY(
            robot_->execute("def fast():\n  p = get_target_tcp_pose()\n  p[2] = p[2] + 0.4\n"
                            "  write_output_integer_register(0, 1)\n  movel(p, a=3, v=1.5)\nend\n"));
        double fastest = 0;
        double scaling = 1;
        const auto samples = robot_->marked(1);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            fastest =
                std::max(fastest, (samples[i].target() - samples[i - 1].target()).norm() / robot_->dt());
            if (samples[i].runtime == 2) {
                scaling = std::min(scaling, samples[i].scaling);
            }
            QVERIFY(std::abs(samples[i].targetPose[0] - start[0]) < 1e-5);
        }
        QVERIFY2(fastest > 0.7 && fastest < 0.77, qPrintable(QString::number(fastest)));
        QVERIFY2(scaling < 0.9, qPrintable(QString::number(scaling)));
    }

    void limiterOfAPathIsReported() {
        constexpr qint32 kNoProgram = 0;
        constexpr qint32 kNotScaled = 1;
        constexpr qint32 kToolSpeed = 8;
        constexpr qint32 kJointSpeed = 10;
        Watched source(*robot_, "time_scale_source");
        QVERIFY(source.ready);
        QCOMPARE(source.now(), kNoProgram);
        const auto during = [&](const QByteArray& move) {
            robot_->send("def up():\n  p = get_target_tcp_pose()\n  p[2] = p[2] + 0.4\n  " + move +
                         "\nend\n");
            QSet<qint32> seen;
            const double begin = now().time;
            do {
                seen.insert(source.now());
            } while (now().runtime == 2 || now().time < begin + 0.1);
            return seen;
        };
        const QByteArray up = "movel(p, a=3, v=1.5)";
        QVERIFY(!during("movel(p, a=1, v=0.2)").contains(kToolSpeed));
        QVERIFY(robot_->execute(
            "def back():\n  movej([-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310])\nend\n"));
        robot_->robot.controller.reducedMode(true);
        robot_->run(0.6);
        const QSet<qint32> reduced = during(up);
        QVERIFY(reduced.contains(kToolSpeed) && reduced.contains(kNotScaled) &&
                !reduced.contains(kJointSpeed));
    }

    void pausedPathResumes() {
        RawDashboard dashboard = robot_->robot.dashboard();
        const Six start = now().targetPose;
        robot_->send(
            "def line():\n  p = get_target_tcp_pose()\n  p[2] = p[2] + 0.3\n  movel(p, a=1, v=0.1)\nend\n");
        QVERIFY(robot_->until([&] { return now().targetPose[2] > start[2] + 0.05; }, 5));
        robot_->send("pause program\n");
        QVERIFY(robot_->until([this] { return now().runtime == 4; }, 1));
        const double there = now().targetPose[2];
        robot_->run(0.5);
        QCOMPARE(now().targetPose[2], there);
        robot_->send("run program\n");
        QVERIFY(robot_->until([this] { return now().runtime == 1; }, 10));
        QVERIFY(std::abs(now().targetPose[2] - start[2] - 0.3) < 1e-6);
        for (const MotionSample& s : robot_->samples) {
            QVERIFY(std::abs(s.targetPose[0] - start[0]) < 1e-5);
        }
    }
};

QTEST_GUILESS_MAIN(TestMotionFeatures)
#include "tst_motion_features.moc"
