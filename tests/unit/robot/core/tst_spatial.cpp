// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "robot/core/spatial.h"

using namespace tiller;

namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Vector3d randomAxis(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

class TestSpatial : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void rotationVectorsRoundTrip() {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> angle(0, kPi - 1e-6);
        for (int n = 0; n < 2000; ++n) {
            const Eigen::Vector3d v = randomAxis(random) * angle(random);
            QVERIFY((rotationVector(rotationMatrix(v)) - v).norm() < 1e-12);
        }
    }

    void rotationVectorsNearPiKeepTheirRotation() {
        std::mt19937_64 random(2);
        for (const double short_of : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
            for (int n = 0; n < 200; ++n) {
                const Eigen::Vector3d v = randomAxis(random) * (kPi - short_of);
                const Eigen::Vector3d back = rotationVector(rotationMatrix(v));
                // At pi, both signs of the axis represent the same rotation.
                QVERIFY(std::min((back - v).norm(), (back + v).norm()) < 1e-9);
                QVERIFY((rotationMatrix(back) - rotationMatrix(v)).norm() < 1e-12);
                QVERIFY(back.norm() <= kPi + 1e-12);
            }
        }
    }

    void anglesBeyondPiBecomeTheShorterRotation() {
        const Eigen::Vector3d v(0, 0, 1.5 * kPi);
        const Eigen::Vector3d back = rotationVector(rotationMatrix(v));
        QVERIFY((back - Eigen::Vector3d(0, 0, -0.5 * kPi)).norm() < 1e-12);
    }

    void tinyRotationsKeepTheirPrecision() {
        for (const double size : {1e-3, 1e-6, 1e-9, 1e-13, 1e-15}) {
            const Eigen::Vector3d v(size, -0.5 * size, 0.25 * size);
            QVERIFY((rotationVector(rotationMatrix(v)) - v).norm() < 1e-15);
        }
        QVERIFY(rotationVector(Eigen::Matrix3d::Identity()).isZero(0));
    }

    void rotationMatrixMatchesAKnownOne() {
        const Eigen::Matrix3d R = rotationMatrix(Eigen::Vector3d(0, 0, kPi / 2));
        QVERIFY((R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm() < 1e-15);
    }

    void rpyRotatesAboutFixedAxesInOrderXYZ() {
        // First 90 deg about x, then 90 deg about z: y becomes z.
        const Eigen::Matrix3d R = rotationMatrix(rotationVectorFromRpy(Eigen::Vector3d(kPi / 2, 0, kPi / 2)));
        QVERIFY((R * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm() < 1e-14);
        QVERIFY((R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm() < 1e-14);
    }

    void rpyRoundTrips() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> turn(-kPi + 1e-6, kPi - 1e-6);
        std::uniform_real_distribution<double> pitch(-kPi / 2 + 1e-3, kPi / 2 - 1e-3);
        for (int n = 0; n < 2000; ++n) {
            const Eigen::Vector3d rpy(turn(random), pitch(random), turn(random));
            QVERIFY((rpyFromRotationVector(rotationVectorFromRpy(rpy)) - rpy).norm() < 1e-9);
        }
    }

    void rpyAtGimbalLockKeepsTheRotationAndYawZero() {
        for (const double pitch : {kPi / 2, -kPi / 2}) {
            for (const double roll : {0.0, 0.3, -1.2, 2.5}) {
                const Eigen::Vector3d v = rotationVectorFromRpy(Eigen::Vector3d(roll, pitch, 0.8));
                const Eigen::Vector3d rpy = rpyFromRotationVector(v);
                QCOMPARE(rpy.z(), 0.0);
                QVERIFY((rotationMatrix(rotationVectorFromRpy(rpy)) - rotationMatrix(v)).norm() < 1e-8);
            }
        }
    }

    void poseAndTransformAreTheSame() {
        const Pose pose(0.1, -0.2, 0.3, 0.4, -0.5, 0.6);
        const Pose back(pose.transform());
        QVERIFY((back.position - pose.position).norm() < 1e-15);
        QVERIFY((back.rotation - pose.rotation).norm() < 1e-14);
        QCOMPARE(Pose::fromArray(pose.array()), pose);
        QVERIFY(pose.allFinite());
        QVERIFY(!Pose(0, 0, std::nan(""), 0, 0, 0).allFinite());
    }

    void twistAndWrenchKeepTheirOrder() {
        Vector6 v;
        v << 1, 2, 3, 4, 5, 6;
        QCOMPARE(Twist::fromVector(v).linear, Eigen::Vector3d(1, 2, 3));
        QCOMPARE(Twist::fromVector(v).vector(), v);
        QCOMPARE(Wrench::fromVector(v).torque, Eigen::Vector3d(4, 5, 6));
        QCOMPARE(Wrench::fromVector(v).vector(), v);
        QVERIFY(Twist().isZero());
        QVERIFY(!Twist::fromVector(v).isZero());
    }
};

QTEST_GUILESS_MAIN(TestSpatial)
#include "tst_spatial.moc"
