// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/arm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "robot/simulator/arm/arm_geometry.h"
#include "robot/simulator/arm/compliance_controller.h"
#include "robot/simulator/arm/motion_generator.h"
#include "robot/simulator/arm/sensors.h"
#include "robot/simulator/arm/torque_motion.h"

namespace tiller::simulator::arm {

namespace {
constexpr double kHistory = 10.0;       // s
constexpr double kContactFound = 5.0;   // N opposite to the direction
constexpr double kContactBegan = 1.0;   // N
constexpr double kContactMemory = 2.0;  // s

double periodOf(const RobotModel& model, const ArmOptions& options) {
    return options.period > 0 ? options.period : (model.isCb3() ? 0.008 : 0.002);
}
}  // namespace

struct Arm::Parts {
    Parts(const RobotModel& m, const ArmOptions& options)
        : model(m)
        , period(periodOf(m, options))
        , geometry(model)
        , generator(geometry, period, options.start)
        , complianceController(geometry, generator, period)
        , superposition(geometry, generator.limits(), period)
        , sensors(geometry, period, options.seed, options.ideal)
        , torque(sensors.dynamics())
        , motion(generator)
        , compliance(complianceController)
        , joints(static_cast<std::size_t>(std::lround(kHistory / period)))
        , forces(static_cast<std::size_t>(std::lround(kContactMemory / period))) {
        generator.setTorqueMotion(&torque);
    }

    void measure() {
        sensors.update(complianceController.target(), drive, environment, state);
        state.speedScaling = generator.speedScaling();
        state.scaledBy = generator.scaledBy();
        state.speedFraction = generator.speedFraction();
        state.collisionRatio = sensors.contactForce() / Environment::kForceLimit;
    }

    /// Returns the program target including superposed motions.
    const JointTarget& layOver() {
        if (!superposition.active()) {
            superposed = generator.target();
            return superposed;
        }
        std::optional<StopReason> stop;
        if (generator.protectiveStop()) {
            stop = generator.protectiveStop()->reason;
        } else {
            stop = superposition.step(generator.target(), generator.isHeld(), superposed);
        }
        if (stop) {
            superposition.drop();
            generator.raiseFrom(superposed, *stop);
            superposed = generator.target();
        }
        return superposed;
    }

    /// Makes the program continue from the position that includes the offset and the conveyor motion.
    void foldSuperposition() {
        if (superposition.active()) {
            generator.relocate(superposed);
        }
    }

    MotionStart endSuperposition(void (Superposition::*end)(), double deceleration) {
        foldSuperposition();
        (superposition.*end)();
        return generator.stopJ(deceleration);
    }

    void stepPayload() {
        if (payloadLeft <= 0) {
            return;
        }
        payloadLeft = std::max(0.0, payloadLeft - period);
        const double part = 1 - payloadLeft / payloadTime;
        Payload now;
        now.mass = payloadFrom.mass + part * (payloadTo.mass - payloadFrom.mass);
        now.centreOfGravity =
            payloadFrom.centreOfGravity + part * (payloadTo.centreOfGravity - payloadFrom.centreOfGravity);
        now.inertia = payloadFrom.inertia + part * (payloadTo.inertia - payloadFrom.inertia);
        sensors.setPayload(now);
    }

    /// Triggers stops caused by forces on the arm.
    void watchForces() {
        if (drive != DriveState::Running || generator.protectiveStop()) {
            return;
        }
        const bool hit = sensors.contactForce() > Environment::kForceLimit;
        const int joint = hit ? -1 : sensors.overloadedJoint();
        if (!hit && joint < 0) {
            return;
        }
        complianceController.drop();
        superposition.drop();
        generator.relocate(complianceController.target());
        generator.raise(hit ? StopReason::TcpForceLimit : StopReason::Overload, joint);
    }

    void remember() {
        joints[newest(joints.size())] = state.actualQ.values;
        forces[newest(forces.size())] = sensors.unexplained().force;
    }

    std::size_t newest(std::size_t size) const { return static_cast<std::size_t>(state.controlStep) % size; }
    std::size_t back(std::size_t size, int steps) const {
        return static_cast<std::size_t>(state.controlStep - static_cast<std::uint64_t>(steps)) % size;
    }

    const RobotModel model;  // a copy, because the arm may outlive the caller's model
    double period;
    ArmGeometry geometry;
    MotionGenerator generator;
    ComplianceController complianceController;
    Superposition superposition;
    Sensors sensors;
    TorqueMotion torque;
    Motion motion;
    Compliance compliance;
    Environment environment;
    ArmState state;
    DriveState drive = DriveState::Off;
    JointTarget superposed;  ///< last target during a superposition
    std::optional<Wrench> externalForce;
    Payload payloadFrom;
    Payload payloadTo;
    double payloadTime = 0;
    double payloadLeft = 0;  ///< [s] remaining time of a transition
    std::vector<Vector6> joints;
    std::vector<Eigen::Vector3d> forces;
};

Arm::Arm(const RobotModel& model, const ArmOptions& options)
    : parts_(std::make_unique<Parts>(model, options)) {
    setJointPositions(options.start);
}

Arm::~Arm() = default;

void Arm::step() {
    Parts& p = *parts_;
    ++p.state.controlStep;
    p.stepPayload();
    if (p.generator.followsTorque()) {
        p.torque.setExternal(p.sensors.unexplainedTorques());
    }
    p.generator.step();
    p.complianceController.apply(p.layOver(), p.externalForce.value_or(p.state.tcpForce),
                                 p.sensors.unexplained(), p.drive == DriveState::Running);
    p.measure();
    const bool stands = p.state.targetQd.values.isZero(0);
    p.state.standstillTime = stands ? p.state.standstillTime + p.period : 0.0;
    p.remember();
    p.watchForces();
}

double Arm::period() const {
    return parts_->period;
}

const RobotModel& Arm::model() const {
    return parts_->model;
}

const ArmState& Arm::state() const {
    return parts_->state;
}

Motion& Arm::motion() {
    return parts_->motion;
}

Compliance& Arm::compliance() {
    return parts_->compliance;
}

Superposition& Arm::superposition() {
    return parts_->superposition;
}

MotionStart Arm::endPathOffset(double deceleration) {
    return parts_->endSuperposition(&Superposition::endOffset, deceleration);
}

MotionStart Arm::endConveyorTracking(double deceleration) {
    return parts_->endSuperposition(&Superposition::endTracking, deceleration);
}

void Arm::setToolSpeedLimit(const std::optional<double>& limit) {
    parts_->generator.setToolSpeedLimit(limit.value_or(std::numeric_limits<double>::infinity()));
}

void Arm::raiseProtectiveStop(StopReason reason) {
    Parts& p = *parts_;
    if (!p.generator.protectiveStop()) {
        p.superposition.drop();
        p.generator.relocate(p.complianceController.target());
        p.generator.raise(reason, -1);
    }
}

Environment& Arm::environment() {
    return parts_->environment;
}

void Arm::setDriveState(DriveState state) {
    parts_->drive = state;
    const bool running = state == DriveState::Running;
    if (!running && parts_->complianceController.isForceMode()) {
        parts_->generator.relocate({parts_->complianceController.target().q, Vector6::Zero()});
    }
    if (!running) {
        parts_->complianceController.drop();
        if (parts_->superposition.active()) {
            parts_->superposition.drop();
            parts_->generator.relocate({parts_->superposed.q, Vector6::Zero()});
        }
    }
    parts_->generator.setOperational(running);
}

DriveState Arm::driveState() const {
    return parts_->drive;
}

void Arm::setSpeedFraction(double fraction) {
    if (std::isfinite(fraction)) {
        parts_->generator.setSpeedFraction(std::clamp(fraction, 0.0, 1.0));
    }
}

void Arm::hold() {
    parts_->generator.hold();
}

void Arm::resume() {
    parts_->generator.resume();
}

void Arm::setReadings(const Readings& readings) {
    parts_->generator.setReadings(readings);
}

bool Arm::isHeld() const {
    return parts_->generator.isHeld();
}

void Arm::abort(double deceleration) {
    Parts& p = *parts_;
    if (p.complianceController.isForceMode() || p.complianceController.isFreedrive()) {
        p.complianceController.drop();
        p.generator.relocate(p.complianceController.target());
    }
    p.foldSuperposition();
    p.superposition.drop();
    p.generator.abort(deceleration);
}

const std::optional<ProtectiveStop>& Arm::protectiveStop() const {
    return parts_->generator.protectiveStop();
}

void Arm::clearProtectiveStop() {
    parts_->generator.clearProtectiveStop();
}

std::optional<MotionWarning> Arm::takeWarning() {
    return parts_->generator.takeWarning();
}

void Arm::setTcp(const Pose& T_flange_tcp) {
    if (T_flange_tcp.allFinite()) {
        parts_->geometry.setTcp(T_flange_tcp);
        parts_->generator.setTcp(T_flange_tcp);
    }
}

const Pose& Arm::tcp() const {
    return parts_->geometry.tcp();
}

void Arm::setPayload(const Payload& payload, double transition) {
    Parts& p = *parts_;
    p.payloadFrom = p.sensors.payload();
    p.payloadTo = payload;
    p.payloadTime = p.payloadLeft = std::isfinite(transition) ? std::max(0.0, transition) : 0.0;
    if (p.payloadLeft <= 0) {
        p.sensors.setPayload(payload);
    }
}

const Payload& Arm::payload() const {
    return parts_->sensors.payload();
}

void Arm::setGravity(const Eigen::Vector3d& gravity) {
    parts_->sensors.setGravity(gravity);
}

const Eigen::Vector3d& Arm::gravity() const {
    return parts_->sensors.gravity();
}

void Arm::setExternalForce(const std::optional<Wrench>& wrench) {
    parts_->externalForce = wrench;
}

double Arm::unexplainedForce() const {
    return parts_->sensors.unexplained().force.norm();
}

void Arm::zeroForceSensor() {
    parts_->sensors.zeroForce();
}

void Arm::setJointPositions(const JointPositions& q) {
    Parts& p = *parts_;
    p.complianceController.drop();
    p.superposition.drop();
    p.generator.relocate({q.values, Vector6::Zero()});
    p.complianceController.apply(p.layOver(), {}, {}, p.drive == DriveState::Running);
    p.sensors.place(q.values);
    p.measure();
    std::fill(p.joints.begin(), p.joints.end(), p.state.actualQ.values);
    std::fill(p.forces.begin(), p.forces.end(), Eigen::Vector3d::Zero());
}

std::optional<JointPositions> Arm::jointHistory(int steps) const {
    const Parts& p = *parts_;
    if (steps < 0 || static_cast<std::size_t>(steps) >= p.joints.size() ||
        static_cast<std::uint64_t>(steps) > p.state.controlStep) {
        return std::nullopt;
    }
    return JointPositions(p.joints[p.back(p.joints.size(), steps)]);
}

int Arm::toolContact(const Eigen::Vector3d& direction) const {
    const Parts& p = *parts_;
    const double length = direction.norm();
    const auto against = [&](int steps) {
        const Eigen::Vector3d& force = p.forces[p.back(p.forces.size(), steps)];
        return length > 1e-9 ? -force.dot(direction) / length : force.norm();
    };
    if (against(0) < kContactFound) {
        return 0;
    }
    const int known = static_cast<int>(std::min<std::uint64_t>(p.state.controlStep, p.forces.size() - 1));
    int steps = 1;
    while (steps < known && against(steps) > kContactBegan) {
        ++steps;
    }
    return steps;
}

Matrix6 Arm::massMatrix(const JointPositions& q, bool rotors) const {
    return parts_->sensors.dynamics().massMatrix(q.values, rotors);
}

JointTorques Arm::coriolisTorques(const JointPositions& q, const JointVelocities& qd) const {
    return JointTorques(parts_->sensors.dynamics().coriolis(q.values, qd.values));
}

}  // namespace tiller::simulator::arm
