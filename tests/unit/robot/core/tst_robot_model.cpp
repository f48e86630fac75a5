// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <QSet>
#include <QTest>
#include <cmath>

#include "robot/core/robot_model.h"

using namespace tiller;

class TestRobotModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyModelIsFoundByItsIdAndItsName() {
        QCOMPARE(robotModels().size(), std::size_t(14));
        QSet<QString> names;
        for (const RobotModel& model : robotModels()) {
            QCOMPARE(&robotModel(model.id), &model);
            QCOMPARE(robotModelByName(model.name), std::optional(model.id));
            QCOMPARE(robotModelByName(QString(model.name).toUpper()), std::optional(model.id));
            names.insert(model.name);
        }
        QCOMPARE(names.size(), 14);
    }

    void namesMayBeWrittenLoosely() {
        QCOMPARE(robotModelByName("ur5e"), std::optional(RobotModelId::UR5e));
        QCOMPARE(robotModelByName("ur8 long"), std::optional(RobotModelId::UR8Long));
        QVERIFY(!robotModelByName("UR4").has_value());
        QVERIFY(!robotModelByName("").has_value());
    }

    void theKinematicChainIsThatOfAUrArm() {
        for (const RobotModel& model : robotModels()) {
            const DhParameters& dh = model.dh;
            for (const std::size_t i : {0U, 3U, 4U, 5U}) {
                QCOMPARE(dh.a[i], 0.0);
            }
            QVERIFY(dh.a[1] < 0 && dh.a[2] < 0);
            QCOMPARE(dh.d[1], 0.0);
            QCOMPARE(dh.d[2], 0.0);
            for (const std::size_t i : {0U, 3U, 4U, 5U}) {
                QVERIFY(dh.d[i] > 0);
            }
            QCOMPARE(dh.alpha[0], 1.570796327);
            QCOMPARE(dh.alpha[4], -1.570796327);
        }
    }

    void reachFitsTheLinks() {
        for (const RobotModel& model : robotModels()) {
            const double stretched = std::abs(model.dh.a[1]) + std::abs(model.dh.a[2]) + model.dh.d[4];
            QVERIFY2(std::abs(stretched - model.reach) < 0.13, model.name);
        }
    }

    void limitsAndMassesArePositive() {
        for (const RobotModel& model : robotModels()) {
            QVERIFY(model.maxPayload > 0);
            for (std::size_t i = 0; i < 6; ++i) {
                QVERIFY(model.maxJointSpeed[i] > 2 && model.maxJointSpeed[i] < 6.3);
                QVERIFY(model.maxTorque[i] > 0);
                QVERIFY(model.torquePerCurrent[i] > 5 && model.torquePerCurrent[i] < 25);
                QVERIFY(model.links[i].mass > 0);
            }
        }
    }

    void inertiasAreThoseOfSolidBodies() {
        // The principal moments are positive, and none exceeds the sum of the other two.
        for (const RobotModel& model : robotModels()) {
            for (const LinkInertia& link : model.links) {
                const auto& t = link.inertia;
                Eigen::Matrix3d I;
                I << t[0], t[1], t[2], t[1], t[3], t[4], t[2], t[4], t[5];
                const Eigen::Vector3d principal =
                    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(I).eigenvalues();
                QVERIFY2(principal[0] > 0, model.name);
                QVERIFY2(principal[2] <= (principal[0] + principal[1]) * 1.001, model.name);
            }
        }
    }

    void cylindersLieAlongTheirLinks() {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        QCOMPARE(model.links[1].inertia[0], 0.0151074);  // upper arm along x: smallest moment about x
        QCOMPARE(model.links[1].inertia[3], 0.1338858);
        QCOMPARE(model.links[0].inertia[3], 0.00666);    // shoulder along y of its frame, the joint axis
        QCOMPARE(model.links[5].inertia[5], 0.0001321);  // wrist 3: about z
    }

    void ur5eGravityTorqueGivesTheRecordedCurrents() {
        // 21.261 Nm at 2.14101 A, as reported by a simulated controller at standstill.
        const auto& gain = robotModel(RobotModelId::UR5e).torquePerCurrent;
        QVERIFY(std::abs(21.261 / gain[1] - 2.141012668609619) < 1e-3);
        QVERIFY(std::abs(14.823 / gain[2] - 1.492674708366394) < 1e-3);
        QVERIFY(std::abs(1.812 / gain[3] - 0.23313859105110168) < 1e-3);
    }

    void modelsOfTheSameTypeHaveTheSameJoints() {
        for (const RobotModel& model : robotModels()) {
            const auto found = robotModelByType(model.robotType, model.isCb3());
            QVERIFY2(found.has_value(), model.name);
            QCOMPARE(robotModel(*found).maxTorque, model.maxTorque);
            QCOMPARE(robotModel(*found).isCb3(), model.isCb3());
        }
        QVERIFY(!robotModelByType(99, false).has_value());
    }

    void exactlyThreeModelsAreCb3() {
        int cb3 = 0;
        for (const RobotModel& model : robotModels()) {
            cb3 += model.isCb3() ? 1 : 0;
        }
        QCOMPARE(cb3, 3);
        QVERIFY(robotModel(RobotModelId::UR5).isCb3());
        QVERIFY(!robotModel(RobotModelId::UR5e).isCb3());
    }

    void identityMatchesTheExpectationOfClients() {
        QCOMPARE(QString(robotModel(RobotModelId::UR5e).dashboardName), QString("UR5"));
        QCOMPARE(robotModel(RobotModelId::UR5e).robotType, 1);
        QCOMPARE(robotModel(RobotModelId::UR16e).robotType, 4);
        QCOMPARE(robotModel(RobotModelId::UR15).robotType, 9);
    }
};

QTEST_GUILESS_MAIN(TestRobotModel)
#include "tst_robot_model.moc"
