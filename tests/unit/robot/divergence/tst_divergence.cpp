// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot/divergence/divergence.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/unit/robot/divergence/recorded_arm.h"

using namespace tiller;
using namespace tiller::divergence;
using test::RecordedArm;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

const Outcome& outcome(const Report& report, Quantity quantity) {
    return report.outcomes[static_cast<std::size_t>(quantity)];
}

simulator::arm::Payload gripper() {
    return {1.2, {0, 0.01, 0.06}, Vector6::Zero()};
}

/// Joint and linear moves with a payload. The arm ends at its start position.
void work(RecordedArm& robot) {
    auto& arm = robot.arm;
    const JointPositions home = arm.state().targetQ;
    robot.run(50);
    arm.setPayload(gripper(), 0.1);
    robot.finish(arm.motion().moveJ(home + JointPositions(0.8, 0.2, -0.3, 0.4, 0.2, 1.0), {1.4, 1.05, 0, 0}));
    Pose down = arm.state().targetTcpPose;
    down.position.z() -= 0.1;
    robot.finish(arm.motion().moveL(down, {1.2, 0.25, 0, 0}));
    robot.run(100);
    robot.finish(arm.motion().moveJ(home, {1.4, 1.05, 0, 0}));
    robot.run(50);
}

}  // namespace

class TestDivergence : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anUndisturbedArmNeverDiverges_data();
    void anUndisturbedArmNeverDiverges();
    void aPushIsDetectedAtItsStart_data();
    void aPushIsDetectedAtItsStart();
    void anUnknownLoadDiverges();
    void aJointThatDoesNotFollowIsNamed();
    void theTcpIsComparedWithTheActiveTool();
    void aPushBelowTheMinimumDurationIsIgnored();
    void gapsAndSparseRowsCauseNoDivergence_data();
    void gapsAndSparseRowsCauseNoDivergence();
    void nothingIsComparedWithoutPowerOrInFreedrive();
    void missingColumnsAreReported();
    void targetSpeedsAreDerivedFromPositions();
    void onlyTheRequestedRangeIsCompared();
    void theRobotModelMustBeKnown();
    void aRecordingOfAnotherModelIsRecognised_data();
    void aRecordingOfAnotherModelIsRecognised();
    void aModelIsConfirmedOnlyIfTheDataDistinguishIt();
    void theStatedModelIsAMisstatement();
    void aCalibratedArmConfirmsItsModel();
    void invalidLimitsAreRefused();
    void theComparisonCanBeCancelled();
    void nonFiniteValuesAreHandled();
};

void TestDivergence::anUndisturbedArmNeverDiverges_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("tilt");
    for (const RobotModel& model : robotModels()) {
        QTest::newRow(model.name) << QString::fromLatin1(model.name) << 0.0;
    }
    QTest::newRow("on a wall") << "UR5e" << std::numbers::pi / 2;
    QTest::newRow("under a ceiling") << "UR10e" << std::numbers::pi;
    QTest::newRow("on a slope") << "UR5e" << 0.3;
}

void TestDivergence::anUndisturbedArmNeverDiverges() {
    QFETCH(QString, model);
    QFETCH(double, tilt);
    RecordedArm robot(robotModelByName(model).value());
    const Eigen::Vector3d gravity(0, 9.82 * std::sin(tilt), 9.82 * std::cos(tilt));
    robot.arm.setGravity(gravity);
    work(robot);
    const Report report = compare(robot.recording()).value();
    QCOMPARE(report.model, robot.arm.model().id);
    QVERIFY((report.gravity - gravity).norm() < 0.01);
    QVERIFY(!report.first());
    QCOMPARE(report.rows, robot.rows());
    QVERIFY(report.leftOut < 20);
    for (const Outcome& each : report.outcomes) {
        QVERIFY(each.missing.empty());
        QCOMPARE(each.rows, report.rows - report.leftOut);
        QVERIFY2(each.greatest && each.greatest->amount < each.limit / 10,
                 qPrintable(QString::number(each.greatest ? each.greatest->amount : -1)));
    }
}

void TestDivergence::aPushIsDetectedAtItsStart_data() {
    QTest::addColumn<bool>("moving");
    QTest::addColumn<double>("force");
    QTest::newRow("standing") << false << 60.0;
    QTest::newRow("moving") << true << 60.0;
    QTest::newRow("lighter, found by the force alone") << true << 35.0;
}

// The stop occurs later than the push, as on a real controller.
void TestDivergence::aPushIsDetectedAtItsStart() {
    QFETCH(bool, moving);
    QFETCH(double, force);
    RecordedArm robot;
    auto& arm = robot.arm;
    robot.run(200);
    if (moving) {
        JointPositions there = arm.state().targetQ;
        there[0] += 1.5;
        arm.motion().moveJ(there, {1.4, 1.05, 0, 0});
        robot.run(300);
    }
    const std::uint64_t push = robot.rows();
    arm.environment().setHandWrench({{0, 0, -force}, {0, 0, 0}});
    robot.run(150);
    const std::uint64_t stop = robot.rows();
    arm.raiseProtectiveStop(simulator::arm::StopReason::TcpForceLimit);
    robot.run(300);
    const Report report = compare(robot.recording()).value();
    const auto first = report.first();
    QVERIFY(first.has_value());
    QCOMPARE(first->row, push);
    QVERIFY(first->row < stop);
    QVERIFY(!report.partedFromStart());
    QVERIFY(std::abs(first->seconds - static_cast<double>(push) * arm.period()) < 1e-6);
    const Outcome& forces = outcome(report, Quantity::TcpForce);
    QVERIFY(forces.parted && std::abs(forces.parted->amount - force) < 3);
    QCOMPARE(forces.parted->joint, -1);
    if (force > 50) {
        // A force straight down on the extended arm. The shoulder carries most of it.
        const Outcome& currents = outcome(report, Quantity::JointCurrent);
        QVERIFY(currents.parted.has_value());
        QCOMPARE(currents.parted->row, push);
        QCOMPARE(currents.parted->joint, 1);
        QVERIFY(currents.parted->amount > currents.limit);
    }
    QVERIFY(!outcome(report, Quantity::JointPosition).parted);
    QVERIFY(!outcome(report, Quantity::TcpPosition).parted);
}

void TestDivergence::anUnknownLoadDiverges() {
    RecordedArm robot;
    simulator::arm::Payload carried;
    carried.mass = 4.5;
    robot.arm.environment().setLoad(carried);
    robot.run(300);
    const Report report = compare(robot.recording()).value();
    QVERIFY(report.first().has_value());
    QVERIFY(report.partedFromStart());
    QVERIFY(outcome(report, Quantity::JointCurrent).parted || outcome(report, Quantity::TcpForce).parted);
}

void TestDivergence::aJointThatDoesNotFollowIsNamed() {
    RecordedArm robot;
    work(robot);
    // From row 400 on, the lag of the elbow increases.
    std::vector<double>& elbow = robot.columns["actual_q_2"];
    for (std::size_t row = 400; row < elbow.size(); ++row) {
        elbow[row] += 0.01 * kDegree * static_cast<double>(row - 400);
    }
    const Report report = compare(robot.recording()).value();
    const Difference found = outcome(report, Quantity::JointPosition).parted.value();
    QCOMPARE(found.joint, 2);
    QVERIFY2(found.row >= 450 && found.row <= 453, qPrintable(QString::number(found.row)));
    QVERIFY(found.amount > 5 * kDegree);
    QCOMPARE(report.first()->row, found.row);
    // With another limit, the first deviation is at another row; without a limit, there is none.
    Choice choice;
    choice.limits.jointPosition = 1 * kDegree;
    const std::uint64_t later =
        outcome(compare(robot.recording(), choice).value(), Quantity::JointPosition).parted->row;
    QVERIFY(later >= 500 && later <= 503);
    choice.limits.jointPosition = 0;
    const Report without = compare(robot.recording(), choice).value();
    QVERIFY(!without.first());
    QVERIFY(!outcome(without, Quantity::JointPosition).greatest);
}

void TestDivergence::theTcpIsComparedWithTheActiveTool() {
    RecordedArm robot;
    robot.run(100);
    robot.arm.setTcp(Pose(0, 0, 0.2, 0, 0.3, 0));
    work(robot);
    QVERIFY(!compare(robot.recording()).value().first());
    for (std::size_t row = 700; row < robot.rows(); ++row) {
        robot.columns["actual_TCP_pose_0"][row] += 0.006;
    }
    const Report report = compare(robot.recording()).value();
    const Difference found = outcome(report, Quantity::TcpPosition).parted.value();
    QCOMPARE(found.row, std::uint64_t(700));
    QVERIFY(std::abs(found.amount - 0.006) < 0.001);
    QCOMPARE(found.joint, -1);
}

void TestDivergence::aPushBelowTheMinimumDurationIsIgnored() {
    RecordedArm robot;
    robot.run(200);
    robot.arm.environment().setHandWrench({{0, 0, -100}, {0, 0, 0}});
    robot.run(3);
    robot.arm.environment().setHandWrench({});
    robot.run(200);
    QVERIFY(!compare(robot.recording()).value().first());
    Choice choice;
    choice.limits.lasting = 0;
    QCOMPARE(compare(robot.recording(), choice).value().first()->row, std::uint64_t(200));
}

void TestDivergence::gapsAndSparseRowsCauseNoDivergence_data() {
    QTest::addColumn<int>("every");
    QTest::addColumn<int>("gap");
    QTest::newRow("a short gap") << 1 << 20;
    QTest::newRow("a long gap") << 1 << 200;
    QTest::newRow("every fifth row") << 5 << 0;
    QTest::newRow("every fifth row and a gap") << 5 << 300;
}

void TestDivergence::gapsAndSparseRowsCauseNoDivergence() {
    QFETCH(int, every);
    QFETCH(int, gap);
    RecordedArm robot;
    work(robot);
    const auto recording =
        robot.recording(static_cast<std::size_t>(every), 300, static_cast<std::size_t>(300 + gap));
    const Report report = compare(recording).value();
    QVERIFY(!report.first());
    QVERIFY(report.rows == recording.rows() && report.leftOut < 30);
}

void TestDivergence::nothingIsComparedWithoutPowerOrInFreedrive() {
    RecordedArm robot;
    robot.run(200);
    robot.robotMode = 3;  // POWER_OFF
    robot.arm.setDriveState(simulator::arm::DriveState::Off);
    robot.run(200);
    robot.robotMode = 7;
    robot.arm.setDriveState(simulator::arm::DriveState::Running);
    robot.run(200);
    for (std::size_t row = 450; row < 500; ++row) {
        robot.columns["robot_status_bits"][row] = 7;  // power, program, and the freedrive button
        robot.columns["actual_TCP_force_2"][row] += 100;
    }
    const Report report = compare(robot.recording()).value();
    QVERIFY(!report.first());
    QVERIFY2(report.leftOut >= 250 && report.leftOut <= 290, qPrintable(QString::number(report.leftOut)));
}

void TestDivergence::missingColumnsAreReported() {
    RecordedArm robot;
    robot.run(100);
    robot.arm.environment().setHandWrench({{0, 0, -60}, {0, 0, 0}});
    robot.run(100);
    robot.drop("payload");
    robot.drop("payload_cog");
    robot.drop("target_TCP_pose");
    robot.drop("tcp_offset");
    const Report report = compare(robot.recording()).value();
    QCOMPARE(outcome(report, Quantity::JointCurrent).missing,
             (std::vector<std::string>{"payload", "payload_cog"}));
    QCOMPARE(outcome(report, Quantity::TcpPosition).missing, std::vector<std::string>{"target_TCP_pose"});
    QCOMPARE(report.first()->quantity, Quantity::TcpForce);
    QCOMPARE(report.first()->row, std::uint64_t(100));
    robot.drop("target_q");
    const auto refused = compare(robot.recording());
    QCOMPARE(refused.error().code, ErrorCode::FieldUnknown);
    QVERIFY2(refused.error().toString().contains("target_q"), qPrintable(refused.error().toString()));
}

void TestDivergence::targetSpeedsAreDerivedFromPositions() {
    RecordedArm robot;
    work(robot);
    robot.drop("target_qd");
    robot.drop("target_moment");
    QVERIFY(!compare(robot.recording()).value().first());
}

void TestDivergence::onlyTheRequestedRangeIsCompared() {
    RecordedArm robot;
    robot.run(500);
    robot.arm.environment().setHandWrench({{0, 0, -60}, {0, 0, 0}});
    robot.run(500);
    Choice choice;
    choice.until = 0.9;
    const Report before = compare(robot.recording(), choice).value();
    QVERIFY(!before.first());
    QVERIFY(before.rows >= 450 && before.rows <= 452);
    choice.until = 2;
    choice.from = 0.8;
    QCOMPARE(compare(robot.recording(), choice).value().first()->row, std::uint64_t(500));
}

void TestDivergence::theRobotModelMustBeKnown() {
    RecordedArm robot;
    robot.run(100);
    robot.model = "";
    QCOMPARE(compare(robot.recording()).error().code, ErrorCode::InvalidArgument);
    QVERIFY(compare(robot.recording()).error().toString().contains("contains no robot model"));
    robot.model = "KR6";
    QVERIFY(compare(robot.recording()).error().toString().contains("KR6"));
    Choice choice;
    choice.model = RobotModelId::UR5e;
    QVERIFY(!compare(robot.recording(), choice).value().first());
    // A wrong model is detected.
    choice.model = RobotModelId::UR20;
    QVERIFY(compare(robot.recording(), choice).value().partedFromStart());
}

void TestDivergence::aRecordingOfAnotherModelIsRecognised_data() {
    QTest::addColumn<QString>("stated");
    QTest::addColumn<QStringList>("dropped");
    QTest::addColumn<bool>("moves");
    const QString poses[] = {"target_TCP_pose", "actual_TCP_pose", "tcp_offset"};
    QTest::newRow("stated") << "UR5e" << QStringList{poses[0], poses[1], poses[2]} << false;
    QTest::newRow("by the pose at standstill") << "" << QStringList() << false;
    QTest::newRow("by the poses of a motion") << "" << QStringList{poses[2]} << true;
    QTest::newRow("by the actual poses") << "" << QStringList{poses[0]} << true;
}

// The deviation limits alone do not distinguish the arms, because only differences between target and actual
// positions are compared with them.
void TestDivergence::aRecordingOfAnotherModelIsRecognised() {
    QFETCH(QString, stated);
    QFETCH(QStringList, dropped);
    QFETCH(bool, moves);
    RecordedArm robot;
    robot.run(100);
    if (moves) {
        work(robot);
    }
    robot.model = stated.toStdString();
    for (const QString& field : dropped + QStringList{"actual_current", "actual_TCP_force"}) {
        robot.drop(field.toStdString());
    }
    Choice choice;
    choice.model = RobotModelId::UR10e;
    const Report wrong = compare(robot.recording(), choice).value();
    QVERIFY(wrong.firstCompared);
    // Only the actual poses deviate from a model with the recorded offset.
    QCOMPARE(wrong.first().has_value(), dropped == QStringList{"target_TCP_pose"});
    QVERIFY(wrong.otherModel.has_value());
    QCOMPARE(*wrong.otherModel, RobotModelId::UR5e);
    QVERIFY(!wrong.isModelConfirmed);
    choice.model = RobotModelId::UR5e;
    const Report right = compare(robot.recording(), choice).value();
    QVERIFY(!right.first() && !right.otherModel && right.isModelConfirmed);
}

void TestDivergence::aModelIsConfirmedOnlyIfTheDataDistinguishIt() {
    RecordedArm robot;
    robot.run(200);
    robot.model = "";
    robot.drop("tcp_offset");  // at standstill, any offset explains the pose
    robot.drop("actual_current");
    robot.drop("actual_TCP_force");
    for (const RobotModelId id : {RobotModelId::UR5e, RobotModelId::UR10e}) {
        Choice choice;
        choice.model = id;
        const Report report = compare(robot.recording(), choice).value();
        QVERIFY(!report.first() && !report.otherModel && !report.isModelConfirmed);
    }
    // The comparison without poses in the recording:
    robot.drop("target_TCP_pose");
    robot.drop("actual_TCP_pose");
    Choice choice;
    choice.model = RobotModelId::UR5e;
    QVERIFY(!compare(robot.recording(), choice).value().isModelConfirmed);
}

void TestDivergence::theStatedModelIsAMisstatement() {
    RecordedArm robot;
    robot.run(200);
    robot.model = "UR10e";
    const Report report = compare(robot.recording()).value();
    QVERIFY(report.otherModel && !report.isModelConfirmed);
    QCOMPARE(*report.otherModel, RobotModelId::UR5e);
}

void TestDivergence::aCalibratedArmConfirmsItsModel() {
    RecordedArm robot;
    robot.run(50);
    work(robot);
    robot.model = "";
    const Pose tool(0, 0, 0.1, 0, 0, 0);
    DhParameters dh = robotModel(RobotModelId::UR5e).dh;
    dh.a[1] += 0.0015;
    dh.d[3] -= 0.001;
    dh.theta[2] += 0.002;
    for (std::size_t row = 0; row < robot.rows(); ++row) {
        JointPositions q;
        for (int joint = 0; joint < kJointCount; ++joint) {
            q[joint] = robot.columns["target_q_" + std::to_string(joint)][row];
        }
        const Pose pose = kinematics::forwardTcp(dh, q, tool);
        for (int i = 0; i < 6; ++i) {
            robot.columns["target_TCP_pose_" + std::to_string(i)][row] = pose[i];
            robot.columns["tcp_offset_" + std::to_string(i)][row] = tool[i];
        }
    }
    Choice choice;
    choice.model = RobotModelId::UR5e;
    QVERIFY(compare(robot.recording(), choice).value().isModelConfirmed);
    choice.model = RobotModelId::UR10e;
    QCOMPARE(compare(robot.recording(), choice).value().otherModel, std::optional(RobotModelId::UR5e));
    // The models are also distinguished without the TCP offset.
    robot.drop("tcp_offset");
    QCOMPARE(compare(robot.recording(), choice).value().otherModel, std::optional(RobotModelId::UR5e));
}

void TestDivergence::invalidLimitsAreRefused() {
    RecordedArm robot;
    robot.run(20);
    for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Choice choice;
        choice.limits.force = wrong;
        QCOMPARE(compare(robot.recording(), choice).error().code, ErrorCode::InvalidArgument);
    }
    // Rows with intervals that are too long.
    const auto sparse = robot.recording(10);
    RecordedArm slow;
    slow.run(2000);
    QCOMPARE(compare(slow.recording(200)).error().code, ErrorCode::InvalidArgument);
    QVERIFY(compare(sparse).ok());
}

void TestDivergence::theComparisonCanBeCancelled() {
    RecordedArm robot;
    robot.run(9000);
    std::vector<double> reported;
    Choice choice;
    choice.progress = [&](double part) {
        reported.push_back(part);
        return reported.size() < 2;
    };
    QCOMPARE(compare(robot.recording(), choice).error().code, ErrorCode::Cancelled);
    QCOMPARE(reported.size(), std::size_t(2));
    QVERIFY(reported[0] == 0 && reported[1] > 0 && reported[1] < 1);
}

void TestDivergence::nonFiniteValuesAreHandled() {
    RecordedArm whole;
    whole.run(30);
    std::uint32_t state = 5;
    const auto random = [&state](std::size_t below) {
        state = state * 1664525U + 1013904223U;
        return static_cast<std::size_t>(state >> 8U) % below;
    };
    const double kWrong[] = {
        std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300, 0, 1e9, -3};
    for (int i = 0; i < 1000; ++i) {
        RecordedArm broken;
        broken.columns = whole.columns;
        for (std::size_t change = 0; change < 1 + random(20); ++change) {
            auto column = broken.columns.begin();
            std::advance(column, static_cast<std::ptrdiff_t>(random(broken.columns.size())));
            column->second[random(column->second.size())] = kWrong[random(std::size(kWrong))];
        }
        const auto recording = broken.recording();
        const auto report = compare(recording);
        QVERIFY(report.ok() || report.error().code == ErrorCode::InvalidArgument);
        if (report) {
            QCOMPARE(report->rows, recording.rows());
            QVERIFY(!report->first() || std::isfinite(report->first()->amount));
        }
    }
}

QTEST_GUILESS_MAIN(TestDivergence)
#include "tst_divergence.moc"
