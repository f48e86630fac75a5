// SPDX-License-Identifier: MIT
//
// Compares the reachability flag of a waypoint with an independent calculation from the geometry of the arm,
// which uses neither joint angles nor the code under test. Axes 2, 3 and 4 are parallel and horizontal. Axis
// 5 is perpendicular to them and to axis 6. Given the positions of the axes, three lengths determine the
// result.

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "robot/project/reachability.h"

using namespace tiller;
using namespace tiller::project;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kWaypoints = 10'000;
/// Within this distance of the limit of the reach [m], either result is accepted, because the right angles in
/// the catalogue are rounded.
constexpr double kEitherWay = 1e-6;

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(engine_);
    }
    bool onceIn(int times) { return std::uniform_int_distribution<int>(1, times)(engine_) == 1; }
    Vector3d direction() {
        std::normal_distribution<double> normal;
        return Vector3d(normal(engine_), normal(engine_), normal(engine_)).normalized();
    }
    /// Returns a uniformly distributed point in the ball [m].
    Vector3d place(double radius) { return direction() * radius * std::cbrt(between(0, 1)); }
    Isometry3d pose(double radius) {
        Isometry3d T = Isometry3d::Identity();
        T.linear() = Eigen::AngleAxisd(between(-kPi, kPi), direction()).toRotationMatrix();
        T.translation() = place(radius);
        return T;
    }
    JointPositions joints(double range) {
        JointPositions q;
        for (int i = 0; i < kJointCount; ++i) {
            q[i] = between(-range, range);
        }
        return q;
    }

private:
    std::mt19937_64 engine_;
};

/// T_base_flange, axis by axis, with exact right angles.
Isometry3d flangeAt(const DhParameters& dh, const JointPositions& q) {
    Isometry3d T = Isometry3d::Identity();
    for (std::size_t i = 0; i < 6; ++i) {
        T.rotate(Eigen::AngleAxisd(q[static_cast<int>(i)], Vector3d::UnitZ()));
        T.translate(Vector3d(dh.a[i], 0, dh.d[i]));
        const double quarters = std::round(dh.alpha[i] / (kPi / 2));
        T.rotate(Eigen::AngleAxisd(quarters * kPi / 2, Vector3d::UnitX()));
    }
    return T;
}

/// Returns the distance of the flange pose from the limit of the reach [m]. Negative if the arm is too short
/// or too long by this distance.
double slack(const DhParameters& dh, const Isometry3d& flange) {
    const Vector3d axis6 = flange.linear().col(2);
    const Vector3d wrist = flange.translation() - dh.d[5] * axis6;
    const double away = std::hypot(wrist.x(), wrist.y());
    if (away < dh.d[3]) {
        return away - dh.d[3];
    }
    const double longest = std::abs(dh.a[1]) + std::abs(dh.a[2]);
    const double shortest = std::abs(std::abs(dh.a[1]) - std::abs(dh.a[2]));
    const Vector3d out(wrist.x() / away, wrist.y() / away, 0);
    const Vector3d aside(-out.y(), out.x(), 0);
    const double along = dh.d[3] / away;
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    double best = -std::numeric_limits<double>::infinity();
    for (const double side : {1.0, -1.0}) {
        const Vector3d axis2 = along * out + side * across * aside;
        const Vector3d elbowEnd = wrist - dh.d[3] * axis2 - Vector3d(0, 0, dh.d[0]);
        const auto offer = [&](double length) {
            best = std::max(best, std::min(longest - length, length - shortest));
        };
        const Vector3d axis5 = axis2.cross(axis6);
        if (axis5.norm() > 1e-9) {
            offer((elbowEnd - dh.d[4] * axis5.normalized()).norm());
            offer((elbowEnd + dh.d[4] * axis5.normalized()).norm());
        } else {
            // Axis 6 is parallel to axis 2, so wrist 3 is free and axis 5 can be anywhere around it.
            const double inPlane = elbowEnd.norm();
            const double middle = (longest + shortest) / 2;
            offer(std::clamp(middle, std::abs(inPlane - dh.d[4]), inPlane + dh.d[4]));
        }
    }
    return best;
}

struct Case {
    Waypoint point;
    FrameList frames;
    QByteArray kind = "drawn";    ///< how the case was generated
    Isometry3d flange;            ///< flange pose of the case
    bool fromJoints = false;      ///< generated from joint positions, so within reach
    bool atTaughtJoints = false;  ///< generated from the taught joints
};

Case randomCase(const RobotModel& model, Dice& dice) {
    Case result;
    Waypoint& point = result.point;
    point.id = QUuid::createUuid();
    point.joints = dice.joints(kPi);
    point.move = dice.onceIn(2) ? MoveKind::Joint : MoveKind::Linear;
    if (dice.onceIn(10)) {
        point.priority = TargetKind::Joints;
        point.joints = dice.joints(1.05 * kJointPositionLimit);
        return result;
    }
    point.priority = TargetKind::Pose;
    if (dice.onceIn(2)) {
        point.tcpOffset = Pose(dice.pose(0.3));
    }
    result.fromJoints = dice.onceIn(3);
    if (result.fromJoints) {
        JointPositions q = dice.joints(kPi);
        if (dice.onceIn(4)) {
            q[4] = dice.onceIn(2) ? 0 : kPi;
            result.kind += ", wrist 3 free";
        }
        if (dice.onceIn(4)) {
            q[2] = 0;
            result.kind += ", full length";
        }
        result.atTaughtJoints = dice.onceIn(2);
        if (result.atTaughtJoints) {
            point.joints = q;
        }
        result.flange = flangeAt(model.dh, q);
    } else {
        result.flange = dice.pose(1.25 * (model.reach + model.dh.d[4] + model.dh.d[5]));
    }
    Isometry3d T_base_frame = Isometry3d::Identity();
    if (dice.onceIn(2)) {
        Frame frame;
        frame.id = QUuid::createUuid();
        frame.name = QStringLiteral("f");
        T_base_frame = dice.pose(1);
        frame.T_base_frame = Pose(T_base_frame);
        result.frames.append(frame);
        point.frame = frame.id;
    }
    point.pose = Pose(T_base_frame.inverse() * result.flange * point.tcpOffset.transform());
    return result;
}

QString figures(const Case& c, double left) {
    QString text = QStringLiteral("%1, slack %2 m, joints").arg(QString::fromLatin1(c.kind)).arg(left);
    for (int i = 0; i < kJointCount; ++i) {
        text += QStringLiteral(" %1").arg(c.point.joints[i], 0, 'g', 17);
    }
    text += QStringLiteral(", pose");
    for (int i = 0; i < 6; ++i) {
        text += QStringLiteral(" %1").arg(c.point.pose[i], 0, 'g', 17);
    }
    return text;
}

}  // namespace

class TestReachFlags : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void reachFlagsAgreeWithTheGeometryOfTheArm_data() {
        QTest::addColumn<int>("model");
        for (std::size_t i = 0; i < robotModels().size(); ++i) {
            QTest::newRow(robotModels()[i].name) << static_cast<int>(i);
        }
    }
    void reachFlagsAgreeWithTheGeometryOfTheArm() {
        QFETCH(int, model);
        const RobotModel& arm = robotModels()[static_cast<std::size_t>(model)];
        Dice dice(static_cast<unsigned>(1 + model));
        int reached = 0;
        int refused = 0;
        int eitherWay = 0;
        for (int i = 0; i < kWaypoints; ++i) {
            const Case c = randomCase(arm, dice);
            const Reach reach = project::reach(arm, c.point, c.frames);
            if (c.point.priority == TargetKind::Joints) {
                const bool inside = std::all_of(&c.point.joints.values[0], &c.point.joints.values[0] + 6,
                                                [](double q) { return std::abs(q) <= kJointPositionLimit; });
                QCOMPARE(reach.obstacle, inside ? Reach::Obstacle::None : Reach::Obstacle::JointLimit);
                QVERIFY(reach.q == c.point.joints);
                continue;
            }
            const double left = c.fromJoints ? 1.0 : slack(arm.dh, c.flange);
            if (std::abs(left) < kEitherWay) {
                ++eitherWay;
            } else {
                QVERIFY2(reach.ok() == (left > 0), qPrintable(figures(c, left)));
            }
            if (!reach.ok()) {
                QCOMPARE(reach.obstacle, Reach::Obstacle::OutOfReach);
                ++refused;
                continue;
            }
            ++reached;
            const Isometry3d there = flangeAt(arm.dh, reach.q);
            QVERIFY2((there.translation() - c.flange.translation()).norm() < 1e-7,
                     qPrintable(figures(c, left)));
            QVERIFY2((there.linear() - c.flange.linear()).norm() < 1e-7, qPrintable(figures(c, left)));
            QVERIFY(reach.q.values.cwiseAbs().maxCoeff() <= kJointPositionLimit);
            if (c.atTaughtJoints) {
                // At full extension, and where wrist 3 is free, the last digits of the pose have a larger
                // effect on the joints.
                QVERIFY2((reach.q.values - c.point.joints.values).cwiseAbs().maxCoeff() < 1e-3,
                         qPrintable(figures(c, left)));
            }
        }
        // The test is meaningful only if both results are frequent.
        QVERIFY2(reached > kWaypoints / 4 && refused > kWaypoints / 10,
                 qPrintable(QStringLiteral("%1 reached, %2 refused").arg(reached).arg(refused)));
        QVERIFY(eitherWay < 10);
    }

    // Checks the independent calculation itself. It must accept poses generated from joints and refuse the
    // same poses after they were moved out of reach. An error of the arm length would be detected.
    void theReferenceGeometryKnowsTheReach() {
        Dice dice(99);
        for (const RobotModel& arm : robotModels()) {
            for (int i = 0; i < 200; ++i) {
                const JointPositions q = dice.joints(kPi);
                QVERIFY(slack(arm.dh, flangeAt(arm.dh, q)) > -kEitherWay);
                JointPositions stretched = q;
                stretched[2] = 0;
                const Isometry3d end = flangeAt(arm.dh, stretched);
                QVERIFY(slack(arm.dh, end) > -kEitherWay);
            }
            Isometry3d far = Isometry3d::Identity();
            far.translation() = Vector3d(0, 0, 2 * arm.reach + arm.dh.d[0]);
            QVERIFY(slack(arm.dh, far) < 0);
        }
    }
};

QTEST_GUILESS_MAIN(TestReachFlags)
#include "tst_reach_flags.moc"
