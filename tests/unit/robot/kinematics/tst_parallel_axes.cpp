// SPDX-License-Identifier: MIT
//
// Parameters reported by calibrated arms, and their conversion.

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/parallel_axes.h"

using namespace tiller;
using namespace tiller::kinematics;

namespace {

/// A real UR10e. Source: documentation of ur_calibration, Universal Robots ROS 2 driver.
DhParameters realArm() {
    DhParameters dh;
    dh.theta = {-2.4147806894359e-07, 1.60233952386695,      -1.68607190752171,
                0.0837331147700119,   -1.01260355871158e-07, 3.91986209186124e-08};
    dh.a = {2.12234865571206e-05,  0.0193171326277006,    -0.569251663611088,
            -4.61409023720934e-05, -6.39280053471802e-05, 0};
    dh.d = {0.180539811714259, 439.140974079901,  -446.027059806332,
            7.0603368964236,   0.119811341150314, 0.115670917257426};
    dh.alpha = {1.57014608044242, 0.0013941666682559, 0.00693818880325995,
                1.56998468543761, -1.57038520649543,  0};
    return dh;
}

JointPositions randomJoints(std::mt19937_64& random) {
    std::uniform_real_distribution<double> angle(-3.1, 3.1);
    JointPositions q;
    for (int i = 0; i < kJointCount; ++i) {
        q[i] = angle(random);
    }
    return q;
}

double apart(const std::array<double, 6>& a, const std::array<double, 6>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

}  // namespace

class TestParallelAxes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nominalModelsAreUnchanged() {
        for (const RobotModel& model : robotModels()) {
            const DhParameters dh = resolveParallelAxes(model.dh);
            QVERIFY2(dh == model.dh, model.name);
            QVERIFY2(asDenavitHartenberg(dh) == model.dh, model.name);
            QVERIFY2(calibrated(model, model.dh) == model.dh, model.name);
        }
    }

    void theLinksOfARealArmMatchItsModel() {
        const DhParameters arm = resolveParallelAxes(realArm());
        const DhParameters& model = robotModel(RobotModelId::UR10e).dh;
        QVERIFY(apart(arm.a, model.a) < 0.005);
        QVERIFY(apart(arm.d, model.d) < 0.005);
        QVERIFY(apart(arm.alpha, model.alpha) < 0.01);
        QVERIFY(apart(arm.theta, model.theta) < 0.05);
        QVERIFY(apart(arm.beta, model.beta) < 0.01);
        QCOMPARE(arm.d[1], 0.0);
        QCOMPARE(arm.d[2], 0.0);
    }

    void theFlangeIsUnchangedAndTheElbowIsCorrected() {
        const DhParameters reported = realArm();
        const DhParameters arm = resolveParallelAxes(reported);
        const DhParameters& model = robotModel(RobotModelId::UR10e).dh;
        std::mt19937_64 random(3);
        for (int n = 0; n < 1000; ++n) {
            const JointPositions q = randomJoints(random);
            const auto before = linkFrames(reported, q);
            const auto now = linkFrames(arm, q);
            QVERIFY((before[6].matrix() - now[6].matrix()).cwiseAbs().maxCoeff() < 1e-10);
            const auto nominal = linkFrames(model, q);
            for (std::size_t i = 1; i <= 6; ++i) {
                QVERIFY((now[i].translation() - nominal[i].translation()).norm() < 0.06);
                // The axes are the same lines in space.
                const Eigen::Vector3d axis = before[i].linear().col(2);
                QVERIFY((now[i].linear().col(2) - axis).norm() < 1e-10);
                QVERIFY((now[i].translation() - before[i].translation()).cross(axis).norm() < 1e-9);
            }
        }
    }

    void theInverseRecoversTheOriginalJoints() {
        const DhParameters arm = calibrated(robotModel(RobotModelId::UR10e), realArm());
        std::mt19937_64 random(4);
        int looked = 0;
        for (int n = 0; n < 1000; ++n) {
            const JointPositions q = randomJoints(random);
            const SingularityMeasure measure = singularityMeasure(arm, q);
            if (measure.wrist < 0.1 || measure.elbow < 0.2 || measure.shoulder < 0.1) {
                continue;
            }
            ++looked;
            const auto found = inverseNearest(arm, forwardTcp(arm, q), {}, q);
            QVERIFY(found.has_value());
            QVERIFY((found->values - q.values).cwiseAbs().maxCoeff() < 1e-8);
        }
        QVERIFY(looked > 300);
    }

    void bothDescriptionsAreEquivalent() {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> off(-0.003, 0.003);
        for (const RobotModel& model : robotModels()) {
            for (int n = 0; n < 50; ++n) {
                DhParameters arm = model.dh;
                for (std::size_t i = 0; i < 6; ++i) {
                    const bool parallel = i == 1 || i == 2;
                    arm.theta[i] += off(random);
                    arm.a[i] += off(random);
                    arm.alpha[i] += off(random);
                    arm.d[i] += parallel ? 0 : off(random);
                    arm.beta[i] += parallel ? off(random) : 0;
                }
                const DhParameters reported = asDenavitHartenberg(arm);
                QVERIFY(reported.beta == decltype(reported.beta){});
                const DhParameters again = resolveParallelAxes(reported);
                QVERIFY(apart(again.a, arm.a) < 1e-8);
                QVERIFY(apart(again.d, arm.d) < 1e-8);
                QVERIFY(apart(again.alpha, arm.alpha) < 1e-8);
                QVERIFY(apart(again.theta, arm.theta) < 1e-8);
                QVERIFY(apart(again.beta, arm.beta) < 1e-8);
                const JointPositions q = randomJoints(random);
                QVERIFY((forward(reported, q).matrix() - forward(arm, q).matrix()).cwiseAbs().maxCoeff() <
                        1e-9);
            }
        }
    }

    void anImplausibleCalibrationIsIgnored_data() {
        QTest::addColumn<double>("number");
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("as long as a house") << 12.0;
        QTest::newRow("the largest") << std::numeric_limits<double>::max();
    }
    void anImplausibleCalibrationIsIgnored() {
        QFETCH(double, number);
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        for (std::size_t i = 0; i < 6; ++i) {
            DhParameters reported = model.dh;
            reported.a[i] = number;
            QVERIFY(calibrated(model, reported) == model.dh);
            reported = model.dh;
            reported.theta[i] = number;
            QVERIFY(std::isfinite(number) || calibrated(model, reported) == model.dh);
        }
        QVERIFY(calibrated(model, DhParameters()) == model.dh);
        DhParameters bent = realArm();  // not possible for an arm with parallel axes
        bent.alpha[1] = 1;
        QVERIFY(calibrated(model, bent) == model.dh);
    }
};

QTEST_GUILESS_MAIN(TestParallelAxes)
#include "tst_parallel_axes.moc"
