// SPDX-License-Identifier: MIT
//
// Requirements on motion, measured by a client. Programs are sent over the primary interface, and results are
// received over RTDE, in virtual time.

#include <QTest>
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/integration/motion/recorded_robot.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Duration of a trapezoidal profile, or of a triangular one for a short length.
double trapezoid(double length, double a, double v) {
    return v * v / a > length ? 2 * std::sqrt(length / a) : length / v + v / a;
}

double distance(const Eigen::Vector3d& p, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - from - t * along).norm();
}

QByteArray marked(const QByteArray& motion) {
    return "def timed():\n  sync()\n  write_output_integer_register(0, 1)\n  " + motion +
           "\n  write_output_integer_register(0, 2)\n  sync()\nend\n";
}

Six shifted(const Six& pose, double x, double y, double z) {
    Six moved = pose;
    moved[0] += x;
    moved[1] += y;
    moved[2] += z;
    return moved;
}

}  // namespace

class TestMotionAcceptance : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aServoedCircleIsTrackedWithinTwoMillimetres();
    void moveJTakesTheTimeOfItsProfile_data();
    void moveJTakesTheTimeOfItsProfile();
    void moveLTakesTheTimeOfItsProfile_data();
    void moveLTakesTheTimeOfItsProfile();
    void aSlowSliderStretchesMovesAndKeepsThePath();
    void blendsPassWithinTheirRadius_data();
    void blendsPassWithinTheirRadius();
    void forceModeHoldsTenNewton_data();
    void forceModeHoldsTenNewton();
    void aBoxStopsATool();
    void gravityTorquesAgreeWithKdl_data();
    void gravityTorquesAgreeWithKdl();
};

// The client computes the circle and streams one joint target per period. The script only servos.
void TestMotionAcceptance::aServoedCircleIsTrackedWithinTwoMillimetres() {
    constexpr double kRadius = 0.1;
    constexpr double kFrequency = 0.25;
    RecordedRobot robot;
    QVERIFY(robot.ready);
    QCOMPARE(robot.rtde
                 .setupInputs("input_double_register_0,input_double_register_1,input_double_register_2,"
                              "input_double_register_3,input_double_register_4,input_double_register_5")
                 .front(),
             '\1');
    robot.step();
    const Pose start = Pose::fromArray(robot.now().targetPose);
    const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
    JointPositions q(robot.now().targetQ);
    std::uint64_t sent = robot.robot.controller.inputPackages();
    const auto stream = [&] {
        QByteArray package(1, '\1');
        for (int j = 0; j < 6; ++j) {
            package += bigEndian(q[j]);
        }
        robot.rtde.sendPackage('U', package);
        return robot.robot.controller.waitForInputPackages(++sent, Deadline::after(std::chrono::seconds(20)));
    };
    QVERIFY(stream());
    robot.send(
        "def servo():\n  while True:\n    q = [0,0,0,0,0,0]\n    i = 0\n    while i < 6:\n"
        "      q[i] = read_input_float_register(i)\n      i = i + 1\n    end\n"
        "    servoj(q, t=get_steptime(), lookahead_time=0.1, gain=300)\n  end\nend\n");
    QVERIFY(robot.until([&] { return robot.now().runtime == 2; }, 1));

    // Like all clients, enter the circle smoothly: one second from standstill to full angular speed.
    const double omega = 2 * std::numbers::pi * kFrequency;
    double phase = 0;
    double worst = 0;
    double worstPath = 0;
    for (int n = 0; n < 5500; ++n) {
        const double pace = std::min(1.0, n * robot.dt());
        phase += omega * pace * robot.dt();
        Pose goal = start;
        goal.position += kRadius * Eigen::Vector3d(std::cos(phase) - 1, 0, std::sin(phase));
        const auto solution = kinematics::inverseNearest(dh, goal, Pose(), q);
        QVERIFY(solution.has_value());
        q = *solution;
        QVERIFY(stream());
        robot.step();
        const Eigen::Vector3d actual = robot.now().actual();
        worst = std::max(worst, (actual - goal.position).norm());
        const Eigen::Vector3d centre = start.position - Eigen::Vector3d(kRadius, 0, 0);
        worstPath = std::max(worstPath, std::abs((actual - centre).norm() - kRadius));
    }
    QVERIFY(phase > 4 * std::numbers::pi);
    qInfo("worst distance to the commanded point %.3f mm, to the circle %.3f mm", worst * 1e3,
          worstPath * 1e3);
    QVERIFY2(worst < 0.002, qPrintable(QString::number(worst)));
}

void TestMotionAcceptance::moveJTakesTheTimeOfItsProfile_data() {
    QTest::addColumn<int>("joint");
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("v");
    QTest::newRow("trapezoid") << 0 << 1.6 << 3.4 << 3.1 * 0.5;
    QTest::newRow("triangle") << 0 << -0.2 << 1.4 << 1.05;
    QTest::newRow("slow") << 4 << 0.5 << 0.5 << 0.2;
    QTest::newRow("defaults") << 3 << 1.0 << 1.4 << 1.05;
    QTest::newRow("sharp") << 5 << 2.0 << 20.0 << 3.0;
    QTest::newRow("hair's breadth") << 2 << 0.0004 << 1.4 << 1.05;
}

void TestMotionAcceptance::moveJTakesTheTimeOfItsProfile() {
    QFETCH(int, joint);
    QFETCH(double, way);
    QFETCH(double, a);
    QFETCH(double, v);
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.step();
    Six goal = robot.now().targetQ;
    goal[static_cast<std::size_t>(joint)] += way;
    goal[1] += 0.3 * way;  // this joint follows synchronously
    QVERIFY(robot.execute(marked("movej(" + listOf(goal) + ", a=" + QByteArray::number(a) +
                                 ", v=" + QByteArray::number(v) + ")")));
    const double lasted = static_cast<double>(robot.marked(1).size()) * robot.dt();
    const double wanted = trapezoid(std::abs(way), a, v);
    QVERIFY2(std::abs(lasted - wanted) <= robot.dt() + 1e-9,
             qPrintable(QString("%1 s instead of %2 s").arg(lasted).arg(wanted)));
    for (std::size_t j = 0; j < 6; ++j) {
        QVERIFY(std::abs(robot.now().targetQ[j] - goal[j]) < 1e-9);
    }
}

void TestMotionAcceptance::moveLTakesTheTimeOfItsProfile_data() {
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("v");
    QTest::newRow("test vector of a client") << 0.2 << 2.5 << 2.5;
    QTest::newRow("defaults") << 0.3 << 1.2 << 0.25;
    QTest::newRow("slow") << 0.05 << 0.1 << 0.02;
    QTest::newRow("short") << 0.001 << 1.2 << 0.25;
}

void TestMotionAcceptance::moveLTakesTheTimeOfItsProfile() {
    QFETCH(double, way);
    QFETCH(double, a);
    QFETCH(double, v);
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.step();
    const Six start = robot.now().targetPose;
    const Six goal = shifted(start, 0, 0, way);
    QVERIFY(robot.execute(marked("movel(" + poseOf(goal) + ", a=" + QByteArray::number(a) +
                                 ", v=" + QByteArray::number(v) + ")")));
    const double lasted = static_cast<double>(robot.marked(1).size()) * robot.dt();
    const double wanted = trapezoid(way, a, v);
    QVERIFY2(std::abs(lasted - wanted) <= robot.dt() + 1e-9,
             qPrintable(QString("%1 s instead of %2 s").arg(lasted).arg(wanted)));
    for (const MotionSample& s : robot.marked(1)) {
        QVERIFY(distance(s.target(), positionOf(start), positionOf(goal)) < 1e-6);
    }
    QVERIFY((robot.now().target() - positionOf(goal)).norm() < 1e-6);
}

void TestMotionAcceptance::aSlowSliderStretchesMovesAndKeepsThePath() {
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.robot.controller.setSpeedSlider(0.25);
    robot.step();
    const Six start = robot.now().targetPose;
    const Six goal = shifted(start, 0, 0, 0.2);
    QVERIFY(robot.execute(marked("movel(" + poseOf(goal) + ", a=1.2, v=0.25)")));
    const double lasted = static_cast<double>(robot.marked(1).size()) * robot.dt();
    QVERIFY(std::abs(lasted - 4 * trapezoid(0.2, 1.2, 0.25)) <= 4 * robot.dt() + 1e-9);
    for (const MotionSample& s : robot.marked(1)) {
        QVERIFY(distance(s.target(), positionOf(start), positionOf(goal)) < 1e-6);
    }
}

void TestMotionAcceptance::blendsPassWithinTheirRadius_data() {
    QTest::addColumn<QByteArray>("first");
    QTest::addColumn<QByteArray>("second");
    QTest::addColumn<double>("radius");
    for (const double radius : {0.01, 0.05, 0.1}) {
        for (const QByteArray first : {"movel", "movej", "movep"}) {
            for (const QByteArray second : {"movel", "movej", "movep"}) {
                QTest::addRow("%s to %s, %g mm", first.constData(), second.constData(), radius * 1e3)
                    << first << second << radius;
            }
        }
    }
}

void TestMotionAcceptance::blendsPassWithinTheirRadius() {
    QFETCH(QByteArray, first);
    QFETCH(QByteArray, second);
    QFETCH(double, radius);
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.step();
    const Six start = robot.now().targetPose;
    const Six corner = shifted(start, 0, 0, 0.25);
    const Six end = shifted(start, -0.25, 0, 0.25);
    const auto move = [](const QByteArray& name, const Six& pose, double r) {
        // movej receives joint positions here, so that its corner is exactly the pose of the other moves.
        const QByteArray target = name == "movej" ? "get_inverse_kin(" + poseOf(pose) + ")" : poseOf(pose);
        const QByteArray speed = name == "movej" ? ", a=2, v=1" : ", a=1.2, v=0.3";
        return "  " + name + '(' + target + speed + ", r=" + QByteArray::number(r) + ")\n";
    };
    QVERIFY(robot.execute("def blend():\n" + move(first, corner, radius) +
                          "  write_output_integer_register(0, 1)\n" + move(second, end, 0) + "end\n"));
    QVERIFY((robot.now().target() - positionOf(end)).norm() < 1e-4);
    double nearest = 1;
    double slowest = 10;
    bool inside = false;
    for (std::size_t i = 1; i < robot.samples.size(); ++i) {
        const Eigen::Vector3d p = robot.samples[i].target();
        const double toCorner = (p - positionOf(corner)).norm();
        nearest = std::min(nearest, toCorner);
        if (toCorner < radius) {
            inside = true;
            slowest = std::min(slowest, (p - robot.samples[i - 1].target()).norm() / robot.dt());
        }
        if (toCorner > radius * 1.001) {
            // Outside the blend zone, the path is that of the moves without a blend.
            const bool beforeCorner = !inside;
            const bool straight = beforeCorner ? first != "movej" : second != "movej";
            if (straight) {
                const double off = beforeCorner ? distance(p, positionOf(start), positionOf(corner))
                                                : distance(p, positionOf(corner), positionOf(end));
                QVERIFY2(off < 1e-5, qPrintable(QString::number(off)));
            }
        }
    }
    QVERIFY2(nearest < radius, qPrintable(QString::number(nearest)));
    // The arm blends the corner without a stop.
    QVERIFY2(nearest > 1e-4 && slowest > 0.02,
             qPrintable(QString("%1 m from the corner, %2 m/s").arg(nearest).arg(slowest)));
}

void TestMotionAcceptance::forceModeHoldsTenNewton_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<QByteArray>("frame");
    QTest::addColumn<QByteArray>("selection");
    QTest::addColumn<QByteArray>("wrench");
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("gain");
    const QByteArray z = "[0,0,1,0,0,0]";
    const QByteArray y = "[0,1,0,0,0,0]";
    QTest::newRow("clients' settings")
        << 2 << QByteArray("p[0,0,0,0,0,0]") << z << QByteArray("[0,0,-10,0,0,0]") << 0.025 << 0.5;
    QTest::newRow("defaults") << 2 << QByteArray("p[0,0,0,0,0,0]") << z << QByteArray("[0,0,-10,0,0,0]")
                              << 0.005 << 1.0;
    QTest::newRow("in the tool frame")
        << 2 << QByteArray("get_actual_tcp_pose()") << z << QByteArray("[0,0,10,0,0,0]") << 0.005 << 1.0;
    // The origin of the frame is straight below, so y points towards it.
    QTest::newRow("towards a point") << 1 << QByteArray("pose_add(get_actual_tcp_pose(), p[0,0,-0.5,0,0,0])")
                                     << y << QByteArray("[0,10,0,0,0,0]") << 0.005 << 1.0;
    QTest::newRow("along the motion")
        << 3 << QByteArray("p[0,0,0,0,0,0]") << z << QByteArray("[0,0,-10,0,0,0]") << 0.005 << 1.0;
}

void TestMotionAcceptance::forceModeHoldsTenNewton() {
    QFETCH(int, type);
    QFETCH(QByteArray, frame);
    QFETCH(QByteArray, selection);
    QFETCH(QByteArray, wrench);
    QFETCH(double, damping);
    QFETCH(double, gain);
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.step();
    const Eigen::Vector3d start = robot.now().target();
    // An axis that deviates from the normal measures friction as a force, so this case is run without
    // friction.
    const double friction = type == 1 ? 0.0 : 0.2;
    // Motion across this axis pushes into the plane, and the resulting force increases with the speed.
    const double speed = type == 1 ? 0.03 : 0.05;
    robot.robot.controller.changeWorld([start, friction](simulator::arm::Environment& world) {
        simulator::arm::ContactPlane plane;
        plane.point = start - Eigen::Vector3d(0, 0, 0.01);
        plane.material.friction = friction;
        world.addPlane(plane);
    });
    robot.send("def press():\n  zero_ftsensor()\n  force_mode_set_damping(" + QByteArray::number(damping) +
               ")\n  force_mode_set_gain_scaling(" + QByteArray::number(gain) + ")\n  force_mode(" + frame +
               ", " + selection + ", " + wrench + ", " + QByteArray::number(type) +
               ", [0.1,0.1,0.1,0.2,0.2,0.2])\n  sleep(3)\n  write_output_integer_register(0, 1)\n  sleep(2)\n"
               "  p = get_target_tcp_pose()\n  p[0] = p[0] - 0.05\n  movel(p, a=0.3, v=" +
               QByteArray::number(speed) +
               ")\n"
               "  write_output_integer_register(0, 2)\n  sleep(1)\n  end_force_mode()\nend\n");
    QVERIFY(robot.until([&] { return robot.now().runtime == 2; }, 1));
    QVERIFY(robot.until([&] { return robot.now().runtime == 1; }, 30));
    const auto pressing = robot.marked(1);
    QVERIFY(pressing.size() > 1500);
    double lowest = 1e9;
    double highest = -1e9;
    for (const MotionSample& s : pressing) {
        lowest = std::min(lowest, s.force[2]);
        highest = std::max(highest, s.force[2]);
    }
    qInfo("%.2f to %.2f N, at rest and while moving sideways", lowest, highest);
    QVERIFY2(lowest > 9 && highest < 11, qPrintable(QString("%1 to %2 N").arg(lowest).arg(highest)));
    QVERIFY(std::abs(robot.marked(2).front().target().x() - (start.x() - 0.05)) < 2e-3);
}

void TestMotionAcceptance::aBoxStopsATool() {
    RecordedRobot robot;
    QVERIFY(robot.ready);
    robot.step();
    const Eigen::Vector3d start = robot.now().target();
    robot.robot.controller.changeWorld([start](simulator::arm::Environment& world) {
        simulator::arm::ContactBox box;
        box.T_base_box.position = start - Eigen::Vector3d(0, 0, 0.10);
        box.size = {0.1, 0.1, 0.1};
        world.addBox(box);
    });
    // The contact procedure of both clients: move until contact, then back to the start.
    QVERIFY(
        robot.execute("def touch():\n  zero_ftsensor()\n  while tool_contact([0,0,0,0,0,0]) == 0:\n"
                      "    speedl([0,0,-0.05,0,0,0], 1, t=get_steptime())\n  end\n"
                      "  n = tool_contact([0,0,0,0,0,0])\n  write_output_integer_register(0, n)\n  stopl(3)\n"
                      "  movel(get_actual_joint_positions_history(n), a=1.2, v=0.05)\nend\n"));
    QVERIFY(robot.now().safetyBits == 1);
    QVERIFY(robot.now().mark > 0);
    const double face = start.z() - 0.05;
    QVERIFY2(std::abs(robot.now().actual().z() - face) < 1e-3,
             qPrintable(QString::number(robot.now().actual().z() - face)));
}

void TestMotionAcceptance::gravityTorquesAgreeWithKdl_data() {
    QTest::addColumn<RobotModelId>("id");
    for (const RobotModel& model : robotModels()) {
        QTest::newRow(model.name) << model.id;
    }
}

// The kinematic chain is computed independently from the data of the model. RTDE must report its gravity
// torque, even with a payload and a tilted base.
void TestMotionAcceptance::gravityTorquesAgreeWithKdl() {
    QFETCH(RobotModelId, id);
    auto options = VirtualRobot::options();
    options.model = id;
    const RobotModel& model = robotModel(id);
    // The newest software that supports all models of the series.
    options.software = model.isCb3() ? SoftwareVersion{3, 15, 8, 106339} : SoftwareVersion{5, 25, 0, 1254000};
    RecordedRobot robot(options);
    QVERIFY(robot.ready);
    const Eigen::Vector3d gravity(0, 4.91, 8.504);
    const double mass = 0.5 * model.maxPayload;
    KDL::Chain chain;
    for (std::size_t i = 0; i < 6; ++i) {
        const LinkInertia& link = model.links[i];
        const auto& c = link.centreOfMass;
        const auto& m = link.inertia;
        KDL::RigidBodyInertia body(link.mass, {c[0], c[1], c[2]},
                                   KDL::RotationalInertia(m[0], m[3], m[5], m[1], m[2], m[4]));
        if (i == 5) {
            body = body + KDL::RigidBodyInertia(mass, {0.01, -0.02, 0.08});
        }
        chain.addSegment(KDL::Segment(
            KDL::Joint(KDL::Joint::RotZ),
            KDL::Frame::DH(model.dh.a[i], model.dh.alpha[i], model.dh.d[i], model.dh.theta[i]), body));
    }
    KDL::ChainDynParam expected(chain, KDL::Vector(-gravity.x(), -gravity.y(), -gravity.z()));
    const std::array<Six, 4> poses = {{{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310},
                                       {0.5, -1.2, 1.4, -1.7, -1.5, 0.3},
                                       {0, 0, 0, 0, 0, 0},
                                       {1.0, -0.9, -1.3, 0.4, 0.8, -2.1}}};
    for (const Six& q : poses) {
        QVERIFY(robot.execute("def place():\n  set_payload(" + QByteArray::number(mass) +
                              ", [0.01,-0.02,0.08])\n  set_gravity([0,4.91,8.504])\n  set_pos(" + listOf(q) +
                              ")\n  sync()\nend\n"));
        robot.step(5);
        KDL::JntArray joints(6);
        KDL::JntArray torque(6);
        for (unsigned j = 0; j < 6; ++j) {
            joints(j) = q[j];
        }
        expected.JntToGravity(joints, torque);
        for (unsigned j = 0; j < 6; ++j) {
            QVERIFY2(
                std::abs(robot.now().moment[j] - torque(j)) < 1e-6 * (1 + std::abs(torque(j))),
                qPrintable(
                    QString("joint %1: %2 instead of %3").arg(j).arg(robot.now().moment[j]).arg(torque(j))));
        }
    }
}

QTEST_GUILESS_MAIN(TestMotionAcceptance)
#include "tst_motion_acceptance.moc"
