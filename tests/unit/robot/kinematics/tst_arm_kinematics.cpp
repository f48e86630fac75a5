// SPDX-License-Identifier: MIT
#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "reference_poses.h"
#include "robot/kinematics/arm_kinematics.h"

using namespace tiller;
using namespace tiller::kinematics;

namespace {

constexpr double kPi = std::numbers::pi;

DhParameters exactDh(RobotModelId id) {
    DhParameters dh = robotModel(id).dh;
    for (double& alpha : dh.alpha) {
        alpha = alpha > 0.5 ? kPi / 2 : alpha < -0.5 ? -kPi / 2 : 0.0;
    }
    return dh;
}

JointPositions randomJoints(std::mt19937_64& random, double range = kPi) {
    std::uniform_real_distribution<double> angle(-range, range);
    JointPositions q;
    for (int i = 0; i < 6; ++i) {
        q[i] = angle(random);
    }
    return q;
}

double turnBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return rotationVector(a.linear().transpose() * b.linear()).norm();
}

double angularDistance(const JointPositions& a, const JointPositions& b) {
    double largest = 0;
    for (int i = 0; i < 6; ++i) {
        largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
    }
    return largest;
}

bool contains(const InverseSolutions& solutions, const JointPositions& q, double tolerance) {
    for (const JointPositions& solution : solutions.span()) {
        if (angularDistance(solution, q) < tolerance) {
            return true;
        }
    }
    return false;
}

}  // namespace

class TestArmKinematics : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyModelReachesTheReferencePoses() {
        QCOMPARE(std::size(reference::kFlangePositions), std::size_t(14 * 4));
        for (const auto& expected : reference::kFlangePositions) {
            for (const auto& configuration : reference::kConfigurations) {
                if (configuration.name != expected.configuration) {
                    continue;
                }
                const Pose pose = forwardTcp(exactDh(expected.model), JointPositions(configuration.q));
                for (int i = 0; i < 3; ++i) {
                    const auto index = static_cast<std::size_t>(i);
                    QVERIFY2(std::abs(pose.position[i] - expected.position[index]) < 1e-9,
                             robotModel(expected.model).name);
                    QVERIFY(std::abs(pose.rotation[i] - configuration.rotation[index]) < 1e-9);
                }
            }
        }
    }

    void roundedRightAngleGivesTheRecordedPose() {
        const Pose pose = forwardTcp(robotModel(RobotModelId::UR5e).dh,
                                     {-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310});
        const Pose recorded(-0.14396865671352163, -0.43562006080319216, 0.2020300254283846,
                            -0.0012213596815925638, 3.1162765284819756, 0.038891915636886834);
        QVERIFY((pose.position - recorded.position).norm() < 1e-12);
        QVERIFY((pose.rotation - recorded.rotation).norm() < 1e-12);
    }

    void recordedUr10PosesAreReached() {
        const DhParameters& dh = robotModel(RobotModelId::UR10).dh;
        const Pose first = forwardTcp(dh, {-1.60070020357240848, -1.72710019746888929, -2.20299989381899053,
                                           -0.80799991289247686, 1.59510004520416260, -0.03099996248354131});
        const Eigen::Vector3d expectedFirst(-0.179925914147547, -0.606869755162764, 0.230789102067257);
        QVERIFY((first.position - expectedFirst).norm() < 1e-9);
        const Pose second = forwardTcp(dh, {1.32645022869110107, 2.42600774765014648, 5.95157289505004883,
                                            1.27409040927886963, -0.54105216661562138, 0.12217304855585098});
        const Eigen::Vector3d expectedSecond(0.39922988003280424, 0.59688365069340565, -0.66778190402763756);
        QVERIFY((second.position - expectedSecond).norm() < 1e-9);
    }

    void tcpOffsetIsAppliedInTheFlangeFrame() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const JointPositions q(0.1, -1.3, 1.1, -0.4, 0.9, 0.2);
        const Pose offset(0.01, 0.02, 0.13, 0.1, -0.2, 0.3);
        const Eigen::Isometry3d expected = forward(dh, q) * offset.transform();
        const Pose pose = forwardTcp(dh, q, offset);
        QVERIFY((pose.position - expected.translation()).norm() < 1e-15);
        QVERIFY(turnBetween(pose.transform(), expected) < 1e-14);
    }

    void linkFramesEndAtTheFlange() {
        const DhParameters& dh = robotModel(RobotModelId::UR20).dh;
        const JointPositions q(0.3, -1.0, 0.5, 1.4, -0.6, 2.0);
        const auto frames = linkFrames(dh, q);
        QVERIFY(frames[0].isApprox(Eigen::Isometry3d::Identity(), 0));
        QVERIFY(frames[6].isApprox(forward(dh, q), 0));
        QVERIFY(std::abs(frames[1].translation().z() - dh.d[0]) < 1e-15);
    }

    void inverseFindsExactlyTheTabulatedSolutions() {
        for (const RobotModelId id :
             {RobotModelId::UR3, RobotModelId::UR5e, RobotModelId::UR10e, RobotModelId::UR20}) {
            const DhParameters dh = exactDh(id);
            const InverseSolutions solutions = inverse(dh, forward(dh, {0.5, -1.2, 1.4, -1.7, -1.5, 0.3}));
            int expected = 0;
            for (const auto& row : reference::kSolutionsOfB) {
                if (row.model == id) {
                    ++expected;
                    QVERIFY2(contains(solutions, JointPositions(row.q), 2e-9), robotModel(id).name);
                }
            }
            QCOMPARE(solutions.count, expected);
        }
    }

    void tenThousandRandomPosesRoundTripExactly() {
        std::mt19937_64 random(20240917);
        int lost = 0;
        int eight = 0;
        double worstPosition = 0;
        double worstTurn = 0;
        double worstJoint = 0;
        for (int n = 0; n < 10000; ++n) {
            const auto models = robotModels();
            const DhParameters& dh = models[static_cast<std::size_t>(n) % models.size()].dh;
            const JointPositions q = randomJoints(random);
            const Eigen::Isometry3d T = forward(dh, q);
            const InverseSolutions solutions = inverse(dh, T);
            eight += solutions.count == 8 ? 1 : 0;
            double nearest = 10;
            for (const JointPositions& solution : solutions.span()) {
                const Eigen::Isometry3d back = forward(dh, solution);
                worstPosition = std::max(worstPosition, (back.translation() - T.translation()).norm());
                worstTurn = std::max(worstTurn, turnBetween(back, T));
                nearest = std::min(nearest, angularDistance(solution, q));
                for (int i = 0; i < 6; ++i) {
                    QVERIFY(solution[i] > -kPi && solution[i] <= kPi);
                }
            }
            lost += nearest > 1e-3 ? 1 : 0;
            // At a singularity, the joint positions are not determined to this precision.
            const SingularityMeasure measure = singularityMeasure(dh, q);
            if (std::min({measure.wrist, measure.elbow, measure.shoulder}) > 1e-3) {
                worstJoint = std::max(worstJoint, nearest);
            }
        }
        QCOMPARE(lost, 0);
        QVERIFY2(worstPosition < 1e-9, qPrintable(QString::number(worstPosition)));
        QVERIFY2(worstTurn < 1e-9, qPrintable(QString::number(worstTurn)));
        QVERIFY2(worstJoint < 1e-9, qPrintable(QString::number(worstJoint)));
        QVERIFY(eight > 6500);
    }

    void solutionsAreDistinct() {
        std::mt19937_64 random(5);
        const DhParameters& dh = robotModel(RobotModelId::UR10e).dh;
        for (int n = 0; n < 500; ++n) {
            const InverseSolutions solutions = inverse(dh, forward(dh, randomJoints(random)));
            for (int a = 0; a < solutions.count; ++a) {
                for (int b = a + 1; b < solutions.count; ++b) {
                    QVERIFY(angularDistance(solutions.q[static_cast<std::size_t>(a)],
                                            solutions.q[static_cast<std::size_t>(b)]) > 1e-6);
                }
            }
        }
    }

    void singularPosesAreStillSolved() {
        const double h = kPi / 2;
        const JointPositions singular[] = {
            {0, 0, 0, 0, 0, 0},              // stretched arm, aligned wrist
            {0, -h, 0, -h, 0, 0},            // upright
            {0.4, -1.0, 1.2, -0.7, 0, 0.3},  // wrist singularity only
            {0.4, -1.0, 1.2, -0.7, kPi, 0.3},
            {0.4, -1.0, 1e-9, -0.7, 1.0, 0.3},  // elbow singularity only
        };
        for (const RobotModel& model : robotModels()) {
            for (const JointPositions& q : singular) {
                const Eigen::Isometry3d T = forward(model.dh, q);
                const InverseSolutions solutions = inverse(model.dh, T, q[5]);
                QVERIFY2(solutions.count > 0, model.name);
                for (const JointPositions& solution : solutions.span()) {
                    const Eigen::Isometry3d back = forward(model.dh, solution);
                    QVERIFY((back.translation() - T.translation()).norm() < 2e-9);
                    QVERIFY(turnBetween(back, T) < 2e-9);
                }
            }
        }
    }

    void shoulderSingularPosesAreStillSolved() {
        // The wrist centre is on the cylinder around axis 1: theta4 is chosen so that the measure vanishes.
        for (const RobotModel& model : robotModels()) {
            const DhParameters& dh = model.dh;
            const double q2 = -1.7;
            const double q3 = 0.9;
            const double sine = -(dh.a[1] * std::cos(q2) + dh.a[2] * std::cos(q2 + q3)) / dh.d[4];
            if (std::abs(sine) > 1) {
                continue;
            }
            const JointPositions q(0.2, q2, q3, std::asin(sine) - q2 - q3, 1.1, 0.4);
            QVERIFY(singularityMeasure(dh, q).shoulder < 1e-12);
            const Eigen::Isometry3d T = forward(dh, q);
            const InverseSolutions solutions = inverse(dh, T);
            QVERIFY2(solutions.count > 0, model.name);
            for (const JointPositions& solution : solutions.span()) {
                QVERIFY((forward(dh, solution).translation() - T.translation()).norm() < 2e-9);
            }
        }
    }

    void freeWrist3TakesTheGivenAngle() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const Eigen::Isometry3d T = forward(dh, {0.4, -1.0, 1.2, -0.7, 0, 0.3});
        const InverseSolutions solutions = inverse(dh, T, 1.25);
        bool found = false;
        for (const JointPositions& solution : solutions.span()) {
            found = found || (std::abs(solution[4]) < 1e-6 && std::abs(solution[5] - 1.25) < 1e-6);
        }
        QVERIFY(found);
    }

    void posesOutOfReachHaveNoSolution() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        QCOMPARE(inverse(dh, Pose(2.0, 0, 0.3, 0, 3.14, 0).transform()).count, 0);
        // Inside the cylinder around axis 1, which is unreachable because of the wrist offset.
        QCOMPARE(inverse(dh, Pose(0, 0, 0.6, 0, 0, 0).transform()).count, 0);
        QVERIFY(!inverseNearest(dh, Pose(0, 0, 5, 0, 0, 0), {}, {}).has_value());
        QVERIFY(!inverseNearest(dh, Pose(std::nan(""), 0, 5, 0, 0, 0), {}, {}).has_value());
    }

    void smallCalibrationIsSolvedExactly() {
        DhParameters dh = robotModel(RobotModelId::UR5e).dh;
        dh.theta = {1e-4, -2e-3, 1e-3, 5e-4, -1e-4, 3e-4};
        dh.a[0] = 3e-5;
        dh.a[1] += 4e-4;
        dh.d[1] = 2e-4;
        dh.alpha[1] = 3e-4;
        dh.alpha[3] += 2e-4;
        std::mt19937_64 random(77);
        int solved = 0;
        for (int n = 0; n < 1000; ++n) {
            const JointPositions q = randomJoints(random);
            const SingularityMeasure measure = singularityMeasure(dh, q);
            if (measure.wrist < 0.1 || measure.elbow < 0.2 || measure.shoulder < 0.1) {
                continue;
            }
            ++solved;
            QVERIFY(contains(inverse(dh, forward(dh, q)), q, 1e-9));
        }
        QVERIFY(solved > 300);
    }

    void nearestKeepsBranchAndTurns() {
        std::mt19937_64 random(9);
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const Pose offset(0, 0, 0.12, 0, 0, 0.5);
        for (int n = 0; n < 1000; ++n) {
            const JointPositions q = randomJoints(random, 6.2);
            const SingularityMeasure measure = singularityMeasure(dh, q);
            if (std::min({measure.wrist, measure.elbow, measure.shoulder}) < 0.05) {
                continue;
            }
            JointPositions near = q;
            near[n % 6] += 0.01;
            const auto found = inverseNearest(dh, forwardTcp(dh, q, offset), offset, near);
            QVERIFY(found.has_value());
            QVERIFY((found->values - q.values).cwiseAbs().maxCoeff() < 1e-8);
        }
    }

    void nearestStaysInsideTheJointRange() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const JointPositions q(3.0, -1.2, 1.4, -1.7, -1.5, 0.3);
        // The solution for wrist 3 that is nearest to 6.5 rad is outside the permitted range of +-pi.
        const auto found = inverseNearest(dh, forwardTcp(dh, q), {}, {3.0, -1.2, 1.4, -1.7, -1.5, 6.5}, kPi);
        QVERIFY(found.has_value());
        for (int i = 0; i < 6; ++i) {
            QVERIFY(std::abs((*found)[i]) <= kPi);
        }
    }

    void jacobianMatchesFiniteDifferences() {
        std::mt19937_64 random(3);
        const Pose offset(0.02, -0.01, 0.15, 0.2, 0.1, -0.4);
        constexpr double kStep = 1e-6;
        for (int n = 0; n < 200; ++n) {
            const auto models = robotModels();
            const DhParameters& dh = models[static_cast<std::size_t>(n) % models.size()].dh;
            const JointPositions q = randomJoints(random);
            const Matrix6 J = jacobian(dh, q, offset);
            for (int i = 0; i < 6; ++i) {
                JointPositions before = q;
                JointPositions after = q;
                before[i] -= kStep / 2;
                after[i] += kStep / 2;
                const Eigen::Isometry3d T0 = forward(dh, before) * offset.transform();
                const Eigen::Isometry3d T1 = forward(dh, after) * offset.transform();
                Vector6 expected;
                expected << (T1.translation() - T0.translation()) / kStep,
                    rotationVector(T1.linear() * T0.linear().transpose()) / kStep;
                QVERIFY((J.col(i) - expected).norm() < 1e-7);
            }
        }
    }

    void jacobianDeterminantFollowsTheFormula() {
        std::mt19937_64 random(4);
        for (const RobotModel& model : robotModels()) {
            const DhParameters dh = exactDh(model.id);
            for (int n = 0; n < 50; ++n) {
                const JointPositions q = randomJoints(random);
                const double a2 = dh.a[1];
                const double a3 = dh.a[2];
                const double expected = std::sin(q[2]) * std::sin(q[4]) * a2 * a3 *
                                        (a2 * std::cos(q[1]) + a3 * std::cos(q[1] + q[2]) +
                                         dh.d[4] * std::sin(q[1] + q[2] + q[3]));
                QVERIFY(std::abs(jacobian(dh, q).determinant() - expected) < 1e-12);
            }
        }
    }

    void singularityMeasuresVanishInTheirSingularity() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        const SingularityMeasure upright = singularityMeasure(dh, {0, -kPi / 2, 0, -kPi / 2, 0, 0});
        QVERIFY(upright.wrist < 1e-15);
        QVERIFY(upright.elbow < 1e-15);
        const SingularityMeasure free = singularityMeasure(dh, {0, -1.2, 1.4, -1.7, -1.5, 0.3});
        QVERIFY(free.wrist > 0.9);
        QVERIFY(free.elbow > 0.9);
        QVERIFY(free.shoulder > 0.1);
    }

    void posesUsedByOtherClientsAreReachable() {
        const DhParameters& dh = robotModel(RobotModelId::UR5e).dh;
        JointPositions q(-1.57, -1.6, 1.6, -0.7, 0.7, 0.2);
        const Pose path[] = {{-0.203, 0.263, 0.559, 0.68, -1.083, -2.076},
                             {-0.203, 0.463, 0.559, 0.68, -1.083, -2.076},
                             {-0.203, 0.363, 0.759, 0.68, -1.083, -2.076},
                             {-0.209, 0.492, 0.5522, 0.928, -1.134, -2.168},
                             {-0.209, 0.425, 0.841, 1.16, -0.477, -2.553},
                             {-0.140, -0.400, 0.100, 0, 3.14, 0},
                             {0.280, -0.400, 0.100, 0, 3.14, 0}};
        for (const Pose& pose : path) {
            const auto next = inverseNearest(dh, pose, {}, q);
            QVERIFY(next.has_value());
            q = *next;
        }
    }
};

QTEST_GUILESS_MAIN(TestArmKinematics)
#include "tst_arm_kinematics.moc"
