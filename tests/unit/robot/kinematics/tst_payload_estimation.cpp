// SPDX-License-Identifier: MIT
#include <QTest>
#include <random>

#include "robot/kinematics/payload_estimation.h"

using namespace tiller;
using namespace tiller::kinematics;

namespace {

const Eigen::Vector3d kCentre(0.02, -0.03, 0.09);
const Wrench kZero{{0.9, -1.4, 2.3}, {0.05, -0.03, 0.02}};

PayloadReading reading(const Eigen::Vector3d& turn, double mass, const Eigen::Vector3d& down) {
    PayloadReading result;
    result.R_base_flange = rotationMatrix({M_PI, 0, 0}) * rotationMatrix(turn);
    const Eigen::Vector3d weight = result.R_base_flange.transpose() * (mass * kStandardGravity * down);
    result.felt = {weight + kZero.force, kCentre.cross(weight) + kZero.torque};
    return result;
}

std::vector<PayloadReading> fourReadings(double mass, const Eigen::Vector3d& down = {0, 0, -1}) {
    return {reading({0, 0, 0}, mass, down), reading({0.8, 0, 0}, mass, down),
            reading({-0.4, 0.8, 0}, mass, down), reading({0, -0.8, 0.8}, mass, down)};
}

}  // namespace

class TestPayloadEstimation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fourPosesGiveMassCentreAndZero() {
        const PayloadEstimate found = estimatePayload(fourReadings(2.0));
        QVERIFY(found.ok());
        QVERIFY(std::abs(found.mass - 2.0) < 1e-9);
        QVERIFY((found.centre - kCentre).norm() < 1e-9);
        QVERIFY((found.zero.force - kZero.force).norm() < 1e-9);
        QVERIFY((found.zero.torque - kZero.torque).norm() < 1e-9);
        QVERIFY(found.forceResidual < 1e-9 && found.torqueResidual < 1e-9);
    }

    void mountingNeedNotBeKnown() {
        const Eigen::Vector3d down = Eigen::Vector3d(0.5, 0, -0.8).normalized();
        const PayloadEstimate found = estimatePayload(fourReadings(1.3, down));
        QVERIFY(std::abs(found.mass - 1.3) < 1e-9);
        QVERIFY((found.down - down).norm() < 1e-9);
    }

    void sensorNoiseCostsLittle() {
        std::mt19937 random(11);
        std::normal_distribution<double> force(0, 0.12);
        std::normal_distribution<double> torque(0, 0.006);
        for (int n = 0; n < 100; ++n) {
            std::vector<PayloadReading> readings = fourReadings(2.0);
            for (PayloadReading& r : readings) {
                // Noise of the mean of 100 samples.
                for (int i = 0; i < 3; ++i) {
                    r.felt.force[i] += force(random) / 10;
                    r.felt.torque[i] += torque(random) / 10;
                }
            }
            const PayloadEstimate found = estimatePayload(readings);
            QVERIFY2(std::abs(found.mass - 2.0) < 0.05, qPrintable(QString::number(found.mass)));
            QVERIFY((found.centre - kCentre).norm() < 0.005);
        }
    }

    void aPoseWithContactIsReported() {
        std::vector<PayloadReading> readings = fourReadings(2.0);
        readings.push_back(reading({0.4, 0.4, -1}, 2.0, {0, 0, -1}));
        readings.push_back(reading({-0.6, -0.4, 2}, 2.0, {0, 0, -1}));
        readings[4].felt.force.z() += 3;
        const PayloadEstimate found = estimatePayload(readings);
        QCOMPARE(found.worst, 4);
        QVERIFY(found.forceResidual > 0.3);
    }

    void tooFewSimilarOrWeightlessReadingsAreReported() {
        using Problem = PayloadEstimate::Problem;
        std::vector<PayloadReading> few = fourReadings(2.0);
        few.pop_back();
        QVERIFY(estimatePayload(few).problem == Problem::TooFew);
        const Eigen::Vector3d down(0, 0, -1);
        const std::vector<PayloadReading> alike = {reading({0, 0, 0}, 2, down), reading({0, 0, 1}, 2, down),
                                                   reading({0, 0, 2}, 2, down), reading({0, 0, 3}, 2, down)};
        QVERIFY(estimatePayload(alike).problem == Problem::TooAlike);
        QVERIFY(estimatePayload(fourReadings(0.02)).problem == Problem::NoWeight);
        std::vector<PayloadReading> mute = fourReadings(2.0);
        mute[0].felt.force.x() = std::nan("");
        QVERIFY(estimatePayload(mute).problem == Problem::NotFinite);
    }

    void compensatedForcesGiveTheSameResult() {
        const Eigen::Vector3d tcp(0.01, 0.02, 0.15);
        const double reported = 0.7;
        const Eigen::Vector3d toldCentre(0, 0, 0.04);
        std::vector<PayloadReading> readings = fourReadings(2.0);
        for (PayloadReading& r : readings) {
            // Force as reported by the controller: at the TCP in the base frame, without the known payload.
            const Eigen::Vector3d known =
                r.R_base_flange.transpose() * Eigen::Vector3d(0, 0, -reported * kStandardGravity);
            const Eigen::Vector3d force = r.felt.force - known;
            const Eigen::Vector3d torque = r.felt.torque - toldCentre.cross(known) - tcp.cross(force);
            const Wrench atTcp{r.R_base_flange * force, r.R_base_flange * torque};
            r.felt = feltAtFlange(atTcp, r.R_base_flange, tcp, reported, toldCentre, {0, 0, -1});
        }
        const PayloadEstimate found = estimatePayload(readings);
        QVERIFY(std::abs(found.mass - 2.0) < 1e-9);
        QVERIFY((found.centre - kCentre).norm() < 1e-9);
    }
};

QTEST_GUILESS_MAIN(TestPayloadEstimation)
#include "tst_payload_estimation.moc"
