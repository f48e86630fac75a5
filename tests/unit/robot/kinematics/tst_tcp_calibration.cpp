// SPDX-License-Identifier: MIT
#include <QTest>
#include <random>

#include "robot/core/spatial.h"
#include "robot/kinematics/tcp_calibration.h"

using namespace tiller;
using namespace tiller::kinematics;

namespace {

const Eigen::Vector3d kTip(0.012, -0.034, 0.187);
const Eigen::Vector3d kPoint(-0.42, 0.13, 0.05);

/// Flange poses for which the tip of the tool is at the point.
std::vector<Eigen::Isometry3d> posesOnPoint(std::initializer_list<Eigen::Vector3d> turns) {
    std::vector<Eigen::Isometry3d> result;
    for (const Eigen::Vector3d& turn : turns) {
        Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
        T.linear() = rotationMatrix({M_PI, 0, 0}) * rotationMatrix(turn);
        T.translation() = kPoint - T.linear() * kTip;
        result.push_back(T);
    }
    return result;
}

std::vector<Eigen::Isometry3d> fourPoses() {
    return posesOnPoint({{0, 0, 0}, {0.6, 0, 0.4}, {-0.3, 0.6, 0}, {-0.3, -0.5, -1.2}});
}

Eigen::Isometry3d at(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = R;
    T.translation() = p;
    return T;
}

}  // namespace

class TestTcpCalibration : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fourPosesGiveTheTcp() {
        const auto poses = fourPoses();
        const TipFit fit = fitTip(poses);
        QVERIFY(fit.ok());
        QVERIFY2((fit.tip - kTip).norm() < 1e-9, qPrintable(QString::number((fit.tip - kTip).norm())));
        QVERIFY((fit.point - kPoint).norm() < 1e-9);
        QCOMPARE(fit.residuals.size(), std::size_t(4));
        QVERIFY(fit.rms < 1e-12);
    }

    void knownTcpsAreFoundFromRandomPoses() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(-1, 1);
        int fits = 0;
        for (int n = 0; n < 500; ++n) {
            const Eigen::Vector3d tip = 0.3 * Eigen::Vector3d(number(random), number(random), number(random));
            std::vector<Eigen::Isometry3d> poses;
            for (int i = 0; i < 5; ++i) {
                const Eigen::Vector3d turn(number(random), number(random), 3 * number(random));
                const Eigen::Matrix3d R = rotationMatrix(turn);
                poses.push_back(at(R, kPoint - R * tip));
            }
            const TipFit fit = fitTip(poses);
            if (fit.ok()) {
                ++fits;
                QVERIFY((fit.tip - tip).norm() < 1e-9);
            }
        }
        QVERIFY2(fits > 400, qPrintable(QString::number(fits)));
    }

    void theErrorAndTheWorstPoseAreReported() {
        auto poses = fourPoses();
        poses.push_back(posesOnPoint({{0.5, 0.5, 2.0}}).front());
        poses[2].translation() += Eigen::Vector3d(0, 0.004, 0);
        const TipFit fit = fitTip(poses);
        QVERIFY(fit.ok());
        QCOMPARE(fit.worst, 2);
        QVERIFY(fit.residuals[2] > 0.001 && fit.residuals[2] < 0.004);
        QVERIFY(fit.rms > 0.0005 && fit.rms < fit.residuals[2]);
        QVERIFY((fit.tip - kTip).norm() < 0.01);
    }

    void threePosesAreTooFew() {
        auto poses = fourPoses();
        poses.pop_back();
        const TipFit fit = fitTip(poses);
        QVERIFY(fit.problem == TipFit::Problem::TooFew);
        QVERIFY(fit.spread > 0);
        QVERIFY(fitTip({}).problem == TipFit::Problem::TooFew);
    }

    void posesRotatedAboutOneAxisAreRefused() {
        const auto aboutOne = posesOnPoint({{0, 0, 0}, {0, 0, 0.8}, {0, 0, 1.6}, {0, 0, -1}});
        QVERIFY(fitTip(aboutOne).problem == TipFit::Problem::TooAlike);
        const auto hardly = posesOnPoint({{0, 0, 0}, {0.02, 0, 0}, {0, 0.02, 0}, {0, 0, 0.02}});
        QVERIFY(fitTip(hardly).problem == TipFit::Problem::TooAlike);
    }

    void invalidPosesAreRefused() {
        auto poses = fourPoses();
        poses[1].translation().x() = std::nan("");
        QVERIFY(fitTip(poses).problem == TipFit::Problem::NotFinite);
    }

    void onePoseGivesTheRotation() {
        const Eigen::Matrix3d R_flange_tool = rotationMatrix({0.2, -0.4, 1.1});
        const Eigen::Matrix3d R_base_tool = rotationMatrix({M_PI, 0, 0});
        const Eigen::Matrix3d R_base_flange = R_base_tool * R_flange_tool.transpose();
        QVERIFY((toolRotation(R_base_flange, R_base_tool) - R_flange_tool).norm() < 1e-12);
    }

    void threePosesGiveTheRotation() {
        const Eigen::Matrix3d R_flange_tool = rotationMatrix({0.2, -0.4, 1.1});
        const Eigen::Matrix3d R_base_flange = rotationMatrix({2.9, 0.3, -0.2});
        const Eigen::Matrix3d R_base_tool = R_base_flange * R_flange_tool;
        const Eigen::Vector3d start(0.3, 0.2, 0.4);
        const ToolRotationFit fit = fitToolRotation(
            {at(R_base_flange, start), at(R_base_flange, start + 0.08 * R_base_tool.col(2)),
             at(R_base_flange, start + 0.06 * R_base_tool.col(0) + 0.03 * R_base_tool.col(2))});
        QVERIFY(fit.ok());
        QVERIFY((fit.R_flange_tool - R_flange_tool).norm() < 1e-9);
        QVERIFY(std::abs(fit.alongZ - 0.08) < 1e-12);
        QVERIFY(fit.residual < 1e-7);
    }

    void threePoorPosesAreExplained() {
        using Problem = ToolRotationFit::Problem;
        const Eigen::Matrix3d R = rotationMatrix({M_PI, 0, 0});
        const Eigen::Isometry3d first = at(R, {0, 0, 0});
        const Eigen::Isometry3d down = at(R, {0, 0, -0.1});
        QVERIFY(fitToolRotation({first, at(R, {0, 0, -0.01}), at(R, {0.1, 0, 0})}).problem ==
                Problem::ZTooClose);
        QVERIFY(fitToolRotation({first, down, at(R, {0.01, 0, 0})}).problem == Problem::XTooClose);
        QVERIFY(fitToolRotation({first, down, at(R, {0.005, 0, 0.1})}).problem == Problem::InLine);
        const ToolRotationFit turned =
            fitToolRotation({first, down, at(R * rotationMatrix({0, 0.05, 0}), {0.1, 0, 0})});
        QVERIFY(turned.problem == Problem::Turned);
        QCOMPARE(turned.worst, 2);
        QVERIFY(std::abs(turned.residual - 0.05) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(TestTcpCalibration)
#include "tst_tcp_calibration.moc"
