// SPDX-License-Identifier: MIT
// Values reported by the arm: torques, currents, forces, accelerometer, noise, history.
#include <QTest>
#include <cmath>

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/dynamics.h"
#include "tests/unit/robot/simulator/arm/arm_fixture.h"

using namespace tiller;
using namespace tiller::simulator::arm;

namespace {
const JointPositions kPoseC(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);
}

class TestArmSensors : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void gravityTorquesMatchTheRecordedRobot();
    void currentsMatchTheRecordedRobot();
    void massMatrixGivesTheTorquesOfAcceleration();
    void forceOnTheFlangeLoadsTheJoints();
    void payloadAddsItsTorque();
    void zeroingAfterAPayloadChangeUsesTheNewPayload();
    void configuredPayloadIsCompensated();
    void wrongPayloadCausesAForceReading();
    void zeroingRemovesTheReading();
    void inertiaOfTheLoadIsCompensated();
    void handForceIsReported();
    void forcesAffectTheJointTorques();
    void accelerometerMeasuresGravityInTheToolFrame();
    void mountingChangesTheTorques();
    void noiseIsSmallSeededAndAllowsStandstillDetection();
    void constantAccelerationHasConstantReadings();
    void actualValuesFollowWithASmallLag();
    void temperaturesRiseSlowly();
    void supplyFollowsThePower();
    void brakingDissipatesEnergyAsHeat();
    void aTcpOffsetTakesEffectImmediatelyWithoutMotion();
    void momentumOfOneRotatingJointIsCorrect();
    void theBaseForceIncludesWeightAndMotion();
    void historyReturnsEarlierSteps();
    void contactIsReportedWithItsStart();
    void everyModelSupportsItsOwnWeight();
};

void TestArmSensors::gravityTorquesMatchTheRecordedRobot() {
    Dynamics dynamics(robotModel(RobotModelId::UR5e));
    const Vector6 torque = dynamics.gravityTorques(kPoseC.values);
    const double expected[] = {0, 21.261, 14.823, 1.812, 0.0136, 0};
    for (int j = 0; j < kJointCount; ++j) {
        QVERIFY2(std::abs(std::abs(torque[j]) - expected[j]) < 6e-4,
                 qPrintable(QString("joint %1: %2").arg(j).arg(torque[j])));
    }
}

void TestArmSensors::currentsMatchTheRecordedRobot() {
    // Source: first state package of the manufacturer's simulator, a UR5e at its start position.
    WatchedArm arm;
    arm.step();
    const double expected[] = {
        0, 2.141012668609619, 1.492674708366394, 0.23313859105110168, 0.0017549219774082303, 0};
    for (int j = 0; j < kJointCount; ++j) {
        QVERIFY2(std::abs(std::abs(arm.state().targetCurrent[j]) - expected[j]) < 1e-4,
                 qPrintable(QString("joint %1: %2").arg(j).arg(arm.state().targetCurrent[j])));
        QVERIFY(std::abs(arm.state().actualCurrent[j] - arm.state().targetCurrent[j]) < 1e-9);
    }
}

void TestArmSensors::massMatrixGivesTheTorquesOfAcceleration() {
    Dynamics dynamics(robotModel(RobotModelId::UR5e));
    dynamics.setPayload({.mass = 2,
                         .centreOfGravity = {0.01, 0.02, 0.08},
                         .inertia = (Vector6() << 0.02, 0.03, 0.04, 0.001, -0.002, 0.003).finished()});
    const Vector6 q = kPoseC.values;
    const Vector6 qd = (Vector6() << 0.5, -0.4, 0.3, 0.2, -0.6, 0.7).finished();
    const Vector6 qdd = (Vector6() << 1, 2, -1, 0.5, -0.5, 3).finished();
    const Vector6 expected =
        dynamics.massMatrix(q) * qdd + dynamics.coriolis(q, qd) + dynamics.gravityTorques(q);
    QVERIFY((dynamics.torques(q, qd, qdd) - expected).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((dynamics.massMatrix(q) - dynamics.massMatrix(q).transpose()).cwiseAbs().maxCoeff() < 1e-9);
}

void TestArmSensors::forceOnTheFlangeLoadsTheJoints() {
    const RobotModel& model = robotModel(RobotModelId::UR5e);
    Dynamics dynamics(model);
    ArmGeometry geometry(model);
    Posture posture;
    const Vector6 q = kPoseC.values;
    geometry.evaluate(q, posture);  // no TCP, so the Jacobian is that of the flange
    const Wrench onFlange{{3, -5, 7}, {0.4, 0.2, -0.6}};
    const Eigen::Matrix3d R = posture.frames[6].linear();
    Vector6 inBase;
    inBase << R * onFlange.force, R * onFlange.torque;
    const Vector6 expected = dynamics.gravityTorques(q) - posture.jacobian.transpose() * inBase;
    const Vector6 found = dynamics.torques(q, Vector6::Zero(), Vector6::Zero(), onFlange);
    QVERIFY((found - expected).cwiseAbs().maxCoeff() < 1e-9);
}

// The payload is set and the sensor is zeroed in the same step, as in set_payload().
void TestArmSensors::zeroingAfterAPayloadChangeUsesTheNewPayload() {
    for (const bool hangs : {true, false}) {
        WatchedArm arm;
        if (hangs) {
            arm->environment().setLoad(Payload{.mass = 2, .centreOfGravity = {0.02, -0.03, 0.09}});
        }
        arm.step();
        QVERIFY(std::abs(arm.state().tcpForce.force.norm() - (hangs ? 2 * 9.82 : 0)) < 1e-6);
        arm->setPayload({.mass = 2, .centreOfGravity = {0.02, -0.03, 0.09}});
        arm->zeroForceSensor();
        arm.step();
        QVERIFY2(arm.state().tcpForce.force.norm() < 1e-6,
                 qPrintable(QString::number(arm.state().tcpForce.force.norm())));
        QVERIFY(arm.state().tcpForce.torque.norm() < 1e-6);
    }
}

void TestArmSensors::payloadAddsItsTorque() {
    WatchedArm arm;
    arm.step();
    const double before = arm.state().targetMoment[1];
    arm->setPayload({.mass = 3});
    arm.step();
    // 3 kg at the flange, with the horizontal lever arm to the shoulder axis.
    const Eigen::Vector3d flange = arm.state().actualFlangePose.position;
    const double lever = std::abs(flange.x() * std::cos(-1.6007) + flange.y() * std::sin(-1.6007));
    QVERIFY(std::abs(std::abs(arm.state().targetMoment[1] - before) - 3 * 9.82 * lever) < 1e-6);
}

void TestArmSensors::configuredPayloadIsCompensated() {
    WatchedArm arm;
    arm->setPayload({.mass = 2, .centreOfGravity = {0, 0, 0.1}});
    arm.run(0.01);
    QVERIFY(arm.state().tcpForceScalar < 1e-9);
    QVERIFY(std::abs(arm.state().ftRawWrench.force.norm() - 2 * 9.82) < 1e-9);
}

void TestArmSensors::wrongPayloadCausesAForceReading() {
    WatchedArm arm;
    arm->environment().setLoad(Payload{.mass = 1.5});
    arm->setPayload({.mass = 0.5});
    arm.run(0.01);
    QVERIFY(std::abs(arm.state().tcpForce.force.z() + 9.82) < 1e-6);
    QVERIFY(std::abs(arm.state().actualMoment[1] - arm.state().targetMoment[1]) > 1.0);
}

void TestArmSensors::zeroingRemovesTheReading() {
    WatchedArm arm(false);
    arm->environment().setLoad(Payload{.mass = 1.5});
    arm.run(0.1);
    QVERIFY(arm.state().tcpForceScalar > 14);
    const Wrench raw = arm.state().ftRawWrench;
    arm->zeroForceSensor();
    arm.run(0.1);
    QVERIFY2(arm.state().tcpForceScalar < 2, qPrintable(QString::number(arm.state().tcpForceScalar)));
    QVERIFY((arm.state().ftRawWrench.force - raw.force).norm() < 2);
}

void TestArmSensors::inertiaOfTheLoadIsCompensated() {
    WatchedArm arm;
    arm->setTcp(Pose(0, 0.05, 0.1, 0, 0, 0));
    arm->setPayload({.mass = 4, .centreOfGravity = {0.02, -0.03, 0.1}});
    arm->motion().moveJ(JointPositions(0, -1.2, -1.5, -1, 1.2, 1), {.a = 8, .v = 2});
    double raw = 0;
    double felt = 0;
    for (int n = 0; n < 500; ++n) {
        arm.step();
        raw = std::max(raw, std::abs(arm.state().ftRawWrench.force.norm() - 4 * 9.82));
        felt = std::max(felt, arm.state().tcpForceScalar);
    }
    QVERIFY2(raw > 5, qPrintable(QString::number(raw)));
    QVERIFY2(felt < 1e-9, qPrintable(QString::number(felt)));
}

void TestArmSensors::handForceIsReported() {
    WatchedArm arm;
    arm->setTcp(Pose(0, 0, 0.15, 0, 0.3, 0));
    arm->environment().setHandWrench({{4, -5, 6}, {0.1, 0.2, -0.3}});
    arm.run(0.004);
    QVERIFY((arm.state().tcpForce.force - Eigen::Vector3d(4, -5, 6)).norm() < 1e-9);
    QVERIFY((arm.state().tcpForce.torque - Eigen::Vector3d(0.1, 0.2, -0.3)).norm() < 1e-9);
    QVERIFY((arm.state().wrenchFromCurrents.force - Eigen::Vector3d(4, -5, 6)).norm() < 0.01);
}

void TestArmSensors::forcesAffectTheJointTorques() {
    WatchedArm arm;
    arm->environment().setHandWrench({{0, 0, -20}, {0, 0, 0}});
    arm.run(0.004);
    // A downward push of 20 N has the same effect as a load of that weight.
    const double pushed = arm.state().externalTorque[1];
    WatchedArm loaded;
    loaded->environment().setLoad(Payload{.mass = 20 / 9.82});
    loaded.run(0.004);
    QVERIFY(std::abs(pushed) > 5);
    QVERIFY(std::abs(pushed - loaded.state().externalTorque[1]) < 1e-6);
}

void TestArmSensors::accelerometerMeasuresGravityInTheToolFrame() {
    WatchedArm arm;
    arm.run(0.01);
    const Eigen::Matrix3d R = rotationMatrix(arm.state().actualFlangePose.rotation);
    QVERIFY((R * arm.state().toolAccelerometer - Eigen::Vector3d(0, 0, 9.82)).norm() < 1e-9);
    // The tool points down, so gravity along its z axis is negative.
    QVERIFY(arm.state().toolAccelerometer.z() < -9.7);
    arm->motion().speedL({{0.5, 0, 0}, {0, 0, 0}}, 2.0, 0.1);
    arm.run(0.05);
    const Eigen::Matrix3d now = rotationMatrix(arm.state().actualFlangePose.rotation);
    QVERIFY((now * arm.state().toolAccelerometer - Eigen::Vector3d(2, 0, 9.82)).norm() < 0.05);
}

void TestArmSensors::mountingChangesTheTorques() {
    WatchedArm arm;
    arm->setGravity({9.82, 0, 0});
    arm.step();
    // With wall mounting, the base joint carries the weight of the arm.
    QVERIFY(std::abs(arm.state().targetMoment[0]) > 10);
    QVERIFY(std::abs(arm.state().toolAccelerometer.norm() - 9.82) < 1e-9);
}

void TestArmSensors::noiseIsSmallSeededAndAllowsStandstillDetection() {
    WatchedArm a(false);
    WatchedArm b(false);
    double noise = 0;
    double speed = 0;
    double current = 0;
    const JointPositions resting = a.state().actualQ;
    for (int n = 0; n < 2000; ++n) {
        a.step();
        b.step();
        // Encoder readings are constant while the joints are at standstill.
        QCOMPARE(a.state().actualQ, resting);
        QCOMPARE(a.state().actualQ, b.state().actualQ);
        QCOMPARE(a.state().actualCurrent, b.state().actualCurrent);
        speed = std::max(speed, a.state().actualQd.values.cwiseAbs().maxCoeff());
        current =
            std::max(current, (a.state().actualCurrent - a.state().targetCurrent).cwiseAbs().maxCoeff());
    }
    QVERIFY(speed < 1e-3);
    QVERIFY(current > 1e-3 && current < 0.1);
    QVERIFY(a.state().isSteady());
    // All joints except the base are at standstill, so their readings must not vary.
    a->motion().speedJ(JointVelocities(0.5, 0, 0, 0, 0, 0), 5, 1.0);
    b->motion().speedJ(JointVelocities(0.5, 0, 0, 0, 0, 0), 5, 1.0);
    double previous = a.state().actualQ[0];
    for (int n = 0; n < 500; ++n) {
        a.step();
        b.step();
        QCOMPARE(a.state().actualQ, b.state().actualQ);
        QCOMPARE(a.state().actualQ[1], resting[1]);
        if (n > 100) {
            noise = std::max(noise, std::abs(a.state().actualQ[0] - previous - 0.5 * a->period()));
        }
        previous = a.state().actualQ[0];
    }
    QVERIFY(noise > 1e-7 && noise < 5e-5);
    WatchedArm ideal(true);
    ideal.run(0.1);
    QCOMPARE(ideal.state().actualQ, ideal.state().targetQ);
}

// A script at a quarter of the frame rate produces a new acceleration every fourth period. The values in
// between must be exactly constant for clients.
void TestArmSensors::constantAccelerationHasConstantReadings() {
    WatchedArm arm;
    arm->setSpeedFraction(0.25);
    arm.run(1);
    const double period = 0.002;
    int steady = 0;
    for (int n = 1; n <= 50; ++n) {
        const double speed = 0.0007 * n + 0.00003 * n * n;
        const double change = 0.0007 + 0.00003 * (2 * n - 1);
        QVERIFY(
            arm->motion()
                .speedJ(JointVelocities(speed, -0.3 * speed, 0.1 * speed, 0, 0, 0), change / period, period)
                .ok());
        Vector6 before;
        for (int tick = 0; tick < 4; ++tick) {
            arm.step();
            const Vector6 qdd = arm.state().targetQdd.values;
            steady += tick > 0 && qdd == before ? 1 : 0;
            before = qdd;
        }
    }
    QCOMPARE(steady, 150);
}

void TestArmSensors::actualValuesFollowWithASmallLag() {
    WatchedArm arm(false);
    arm.finish(arm->motion().speedJ(JointVelocities(1, 0, 0, 0, 0, 0), 4, 1.0));
    const double lag = arm.state().targetQ[0] - arm.state().actualQ[0];
    QVERIFY2(lag > 0.5e-3 && lag < 5e-3, qPrintable(QString::number(lag)));
    QVERIFY(arm.state().positionDeviationRatio > 0 && arm.state().positionDeviationRatio < 0.2);
    arm.finish(arm->motion().stopJ(4));
    arm.run(0.05);
    QVERIFY(std::abs(arm.state().targetQ[0] - arm.state().actualQ[0]) < 5e-5);
}

void TestArmSensors::temperaturesRiseSlowly() {
    WatchedArm arm;
    const double start = arm.state().jointTemperature[1];
    arm.run(20);
    const double warmer = arm.state().jointTemperature[1] - start;
    QVERIFY2(warmer > 1e-3 && warmer < 1, qPrintable(QString::number(warmer)));
}

void TestArmSensors::supplyFollowsThePower() {
    WatchedArm arm;
    arm.step();
    QVERIFY(std::abs(arm.state().robotVoltage - 48) < 1);
    QVERIFY(arm.state().robotCurrent > 0.3 && arm.state().robotCurrent < 5);
    arm->setDriveState(DriveState::Off);
    arm.step();
    QCOMPARE(arm.state().robotVoltage, 0.0);
    QCOMPARE(arm.state().robotCurrent, 0.0);
    QCOMPARE(arm.state().mainVoltage, 48.0);
}

void TestArmSensors::brakingDissipatesEnergyAsHeat() {
    WatchedArm arm;
    arm.run(0.1);
    const double before = arm.state().energyBraked;
    // Rotation about a vertical axis lifts no weight, so braking takes the same torque as accelerating.
    arm.finish(arm->motion().speedJ(JointVelocities(1, 0, 0, 0, 0, 0), 4));
    QVERIFY(arm.state().energyBraked - before < 0.05);
    arm.finish(arm->motion().stopJ(4));
    const double inertia = arm->massMatrix(arm.state().targetQ)(0, 0);
    const double braked = arm.state().energyBraked - before;
    QVERIFY2(std::abs(braked - 0.5 * inertia) < 0.1 * inertia, qPrintable(QString::number(braked)));
    QVERIFY(arm.state().energyConsumed > braked);
}

void TestArmSensors::aTcpOffsetTakesEffectImmediatelyWithoutMotion() {
    WatchedArm arm;
    arm.step();
    const Pose flange = arm.state().actualTcpPose;
    const JointPositions q = arm.state().targetQ;
    arm->setTcp(Pose(0, 0, 0.2, 0, 0, 0));
    arm.step();
    QCOMPARE(arm.state().targetQ, q);
    const Eigen::Vector3d moved = arm.state().actualTcpPose.position - flange.position;
    QVERIFY((moved - 0.2 * rotationMatrix(flange.rotation).col(2)).norm() < 1e-9);
    QCOMPARE(arm->tcp(), Pose(0, 0, 0.2, 0, 0, 0));
}

void TestArmSensors::momentumOfOneRotatingJointIsCorrect() {
    WatchedArm arm;
    arm->setPayload({.mass = 5});
    arm.finish(arm->motion().speedJ(JointVelocities(1, 0, 0, 0, 0, 0), 4, 1.0));
    QVERIFY(arm.state().momentum > 5 * arm.state().actualTcpSpeed.linear.norm());
    arm.finish(arm->motion().stopJ(4));
    arm.step();
    QVERIFY(arm.state().momentum < 1e-9);
}

// The first joint rotates about the z axis of the base. The torque on the base about this axis equals the
// joint torque, which recursive Newton-Euler computes independently.
void TestArmSensors::theBaseForceIncludesWeightAndMotion() {
    WatchedArm arm;
    Payload payload;
    payload.mass = 3;
    payload.centreOfGravity = {0.02, -0.01, 0.08};
    payload.inertia << 0.01, 0.02, 0.03, 0.001, 0.002, -0.001;
    arm->setPayload(payload);
    arm.run(0.1);
    double mass = payload.mass;
    for (const LinkInertia& link : arm->model().links) {
        mass += link.mass;
    }
    const Wrench resting = arm.state().targetBaseWrench;
    QVERIFY((resting.force - Eigen::Vector3d(0, 0, mass * 9.82)).norm() < 1e-6);
    QVERIFY(std::abs(resting.torque.z()) < 1e-9 && resting.torque.head<2>().norm() > 1);
    arm->motion().moveJ(JointPositions(-0.6, -1.2, -1.5, -1.2, 1.0, 0.8), {.a = 2, .v = 1});
    double worst = 0;
    double most = 0;
    for (int n = 0; n < 600; ++n) {
        arm.step();
        worst =
            std::max(worst, std::abs(arm.state().targetBaseWrench.torque.z() - arm.state().targetMoment[0]));
        most = std::max(most, std::abs(arm.state().targetMoment[0]));
    }
    QVERIFY2(most > 3 && worst < 0.02 * most, qPrintable(QString("%1 of %2").arg(worst).arg(most)));
}

void TestArmSensors::historyReturnsEarlierSteps() {
    WatchedArm arm;
    arm->motion().moveJ(JointPositions(0, -1.2, -1.5, -1, 1.2, 1), {.a = 2, .v = 1});
    std::vector<JointPositions> seen;
    for (int n = 0; n < 300; ++n) {
        arm.step();
        seen.push_back(arm.state().actualQ);
    }
    QCOMPARE(*arm->jointHistory(0), seen.back());
    QCOMPARE(*arm->jointHistory(100), seen[199]);
    QVERIFY(!arm->jointHistory(-1));
    QVERIFY(!arm->jointHistory(301));
    QVERIFY(!arm->jointHistory(100000));
}

void TestArmSensors::contactIsReportedWithItsStart() {
    WatchedArm arm;
    const double z = arm.state().targetTcpPose.position.z();
    QVERIFY(arm->environment().addPlane({.point = {0, 0, z - 0.02}, .normal = {0, 0, 3}}));
    int contact = 0;
    int since = 0;
    for (int n = 0; n < 2000 && contact == 0; ++n) {
        QCOMPARE(contact, 0);
        arm->motion().speedL({{0, 0, -0.02}, {0, 0, 0}}, 0.5, 0.002);
        arm.step();
        contact = arm->toolContact({0, 0, -1});
        QCOMPARE(arm->toolContact({0, 0, 1}), 0);
        since = arm.tcp().z() < z - 0.02 ? since + 1 : 0;
    }
    QVERIFY(contact > 0);
    QVERIFY(arm->toolContact({0, 0, 0}) > 0);
    QVERIFY2(std::abs(contact - since) <= 3, qPrintable(QString("%1 %2").arg(contact).arg(since)));
    const Pose there = Pose(arm.state().targetTcpPose);
    QVERIFY(there.position.z() > z - 0.025);
    QVERIFY(arm.state().tcpForce.force.z() > 4);
}

void TestArmSensors::everyModelSupportsItsOwnWeight() {
    for (const RobotModel& model : robotModels()) {
        WatchedArm arm(true, model.id, kPoseC);
        arm.finish(
            arm->motion().moveJ(JointPositions(-1.2, -1.5, -1.9, -1, 1.4, 0.4), {.a = 1.4, .v = 1.05}));
        QCOMPARE(arm->period(), model.isCb3() ? 0.008 : 0.002);
        QVERIFY2(arm.state().targetMoment.values.allFinite(), model.name);
        QVERIFY2(arm.state().targetCurrent.allFinite(), model.name);
        QVERIFY2(arm.state().targetMoment.values.cwiseAbs().maxCoeff() > 1, model.name);
        for (int j = 0; j < kJointCount; ++j) {
            QVERIFY2(std::abs(arm.state().targetMoment[j]) < model.maxTorque[static_cast<std::size_t>(j)],
                     model.name);
        }
    }
}

QTEST_GUILESS_MAIN(TestArmSensors)
#include "tst_arm_sensors.moc"
