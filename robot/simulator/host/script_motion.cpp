// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

namespace {

using urscript::Move;

/// optimovej and optimovel use fractions of these limits.
constexpr double kOptimoveJointAcceleration = 10.0;  ///< [rad/s2] at fraction 1
constexpr double kOptimoveToolSpeed = 1.0;           ///< [m/s] at fraction 1
constexpr double kOptimoveToolAcceleration = 2.5;    ///< [m/s2] at fraction 1

/// Freedrive does not start while the unexpected external force on the tool exceeds this value [N]. The
/// threshold of a real controller is not published.
constexpr double kUnexplainedInFreedrive = 50.0;

/// Settling time of a stop [s]. It is not published for real controllers. A known client treats a move as
/// failed if it ends in a stop sooner than this.
constexpr double kSettling = 0.04;

Error refusal(arm::MotionError error, int joint) {
    std::string text;
    switch (error) {
        case arm::MotionError::InvalidArgument:
            text = "motion command with a value out of range";
            break;
        case arm::MotionError::JointTargetOutOfRange:
            text = "target outside the range of joint " + std::to_string(joint);
            break;
        case arm::MotionError::NoInverseKinematics:
            text = "no inverse kinematics solution for the target pose";
            break;
        case arm::MotionError::NotOperational:
            text = "the arm cannot move in this mode";
            break;
        case arm::MotionError::Busy:
            text = "a blended move is still waiting";
            break;
        case arm::MotionError::None:
            break;
    }
    return urscript::scriptError(std::move(text));
}

/// Starts a command on the motion generator of the arm.
struct Starter {
    arm::Arm& arm;

    arm::MotionStart operator()(const Move& move) const {
        const arm::MoveParameters given{move.acceleration, move.velocity, move.duration, move.blend};
        arm::Motion& motion = arm.motion();
        switch (move.kind) {
            case Move::Kind::J:
                return motion.moveJ(move.target, given);
            case Move::Kind::L:
                return motion.moveL(move.target, given);
            case Move::Kind::P:
                return motion.moveP(move.target, given);
            case Move::Kind::C:
                return motion.moveC(move.via.value_or(move.target), move.target, given,
                                    move.orientationMode == 1 ? arm::ArcOrientation::FixedToArc
                                                              : arm::ArcOrientation::Interpolated);
            case Move::Kind::OptimoveJ: {
                const double fastest =
                    *std::min_element(arm.model().maxJointSpeed.begin(), arm.model().maxJointSpeed.end());
                return motion.moveJ(move.target, {move.acceleration * kOptimoveJointAcceleration,
                                                  move.velocity * fastest, 0, move.blend});
            }
            case Move::Kind::OptimoveL:
                return motion.moveL(move.target, {move.acceleration * kOptimoveToolAcceleration,
                                                  move.velocity * kOptimoveToolSpeed, 0, move.blend});
        }
        return {0, arm::MotionError::InvalidArgument, -1};
    }
    arm::MotionStart operator()(const urscript::ServoJ& servo) const {
        return arm.motion().servoJ(servo.q, servo.duration, servo.lookahead, servo.gain);
    }
    arm::MotionStart operator()(const urscript::ServoC& servo) const {
        const Pose target =
            std::holds_alternative<Pose>(servo.target)
                ? std::get<Pose>(servo.target)
                : kinematics::forwardTcp(arm.model().dh, std::get<JointPositions>(servo.target), arm.tcp());
        return arm.motion().servoC(target, servo.acceleration, servo.velocity, servo.blend);
    }
    arm::MotionStart operator()(const urscript::SpeedJ& speed) const {
        return arm.motion().speedJ(speed.qd, speed.acceleration, speed.duration);
    }
    arm::MotionStart operator()(const urscript::SpeedL& speed) const {
        return arm.motion().speedL(speed.xd, speed.acceleration, speed.duration, speed.rotationAcceleration);
    }
    arm::MotionStart operator()(const urscript::StopJ& stop) const {
        return arm.motion().stopJ(stop.deceleration);
    }
    arm::MotionStart operator()(const urscript::StopL& stop) const {
        return arm.motion().stopL(stop.deceleration, stop.rotationDeceleration);
    }
    arm::MotionStart operator()(const urscript::DirectTorque& torque) const {
        const Vector6 all = Vector6::Constant(torque.frictionCompensation ? 1.0 : 0.0);
        return arm.motion().directTorque(torque.torque, torque.viscous.value_or(all),
                                         torque.coulomb.value_or(all));
    }
    // The command does not specify whether to end the conveyor tracking or the offset. End the conveyor
    // tracking first.
    arm::MotionStart operator()(const urscript::StopSuperposition& stop) const {
        return arm.superposition().tracksConveyor() ? arm.endConveyorTracking(stop.deceleration)
                                                    : arm.endPathOffset(stop.deceleration);
    }
};

}  // namespace

Result<void> ScriptMotion::startMotion(urscript::ThreadId thread, const urscript::MotionCommand& command) {
    const arm::MotionStart start = std::visit(Starter{plant_.arm()}, command);
    if (!start.ok()) {
        return refusal(start.error, start.joint);
    }
    const bool stop =
        std::holds_alternative<urscript::StopJ>(command) || std::holds_alternative<urscript::StopL>(command);
    motions_[thread] = {start.id, stop, 0};
    return {};
}

// After the target has stopped, a stop command waits up to kSettling for the arm to settle.
bool ScriptMotion::comesToRest(Motion& motion) const {
    const bool waits = plant_.assumptions().stopReturns == BehaviourOptions::StopReturns::Standing;
    if (waits && motion.settles && plant_.arm().state().standstillTime < kSettling &&
        motion.settled < kSettling) {
        motion.settled += plant_.stepTime();
        return false;
    }
    return true;
}

Result<bool> ScriptMotion::motionFinished(urscript::ThreadId thread) {
    const auto it = motions_.find(thread);
    if (it == motions_.end()) {
        return true;
    }
    switch (plant_.arm().motion().progress(it->second.id)) {
        case arm::MotionProgress::Running:
            return false;
        case arm::MotionProgress::Failed:
            // The protective stop pauses the program, which may continue after the move when it is resumed.
            return !plant_.safety().isProtectiveStopped() && !plant_.arm().protectiveStop();
        case arm::MotionProgress::Returned:
            if (!comesToRest(it->second)) {
                return false;
            }
            break;
        case arm::MotionProgress::Superseded:
            break;
    }
    motions_.erase(it);
    return true;
}

void ScriptMotion::motionAbandoned(urscript::ThreadId thread) {
    if (motions_.erase(thread) > 0) {
        plant_.arm().motion().abandon();
    }
}

Result<void> ScriptMotion::begunForces(const arm::ForceModeParameters& parameters) {
    if (plant_.arm().superposition().active()) {
        return urscript::scriptError("force mode cannot be combined with path offset or conveyor tracking");
    }
    const arm::MotionError error = plant_.arm().compliance().startForceMode(parameters);
    return error == arm::MotionError::None ? Result<void>() : Result<void>(refusal(error, -1));
}

Result<void> ScriptMotion::forceMode(const urscript::ForceMode& mode) {
    return begunForces({mode.taskFrame, mode.compliant, mode.wrench, mode.type, mode.limits});
}

// Force mode along the tool's z axis; the other axes follow the program.
Result<void> ScriptMotion::screwDriving(double force, double speedLimit) {
    arm::ForceModeParameters parameters;
    parameters.compliant[2] = true;
    parameters.wrench.force.z() = force;
    parameters.limits[2] = std::abs(speedLimit);
    parameters.followTool = true;
    return begunForces(parameters);
}

Result<void> ScriptMotion::endScrewDriving() {
    plant_.arm().compliance().endForceMode();
    return {};
}

void ScriptMotion::endForceMode() {
    plant_.arm().compliance().endForceMode();
}

Result<void> ScriptMotion::setForceModeDamping(double damping) {
    plant_.arm().compliance().setDamping(damping);
    return {};
}

double ScriptMotion::forceModeDamping() const {
    return plant_.arm().compliance().damping();
}

Result<void> ScriptMotion::setForceModeGainScaling(double scaling) {
    if (plant_.options().software.isCb3()) {
        return urscript::scriptError("force_mode_set_gain_scaling: not available on this controller series");
    }
    plant_.arm().compliance().setGainScaling(scaling);
    return {};
}

double ScriptMotion::forceModeGainScaling() const {
    return plant_.arm().compliance().gainScaling();
}

Result<void> ScriptMotion::freedrive(const urscript::Freedrive& mode) {
    arm::Arm& arm = plant_.arm();
    if (arm.superposition().active()) {
        return urscript::scriptError("freedrive cannot be combined with path offset or conveyor tracking");
    }
    if (mode.checkPayload && !arm.compliance().isFreedrive() &&
        arm.unexplainedForce() > kUnexplainedInFreedrive) {
        arm.raiseProtectiveStop(arm::StopReason::WrongPayload);
        return {};
    }
    const arm::FreedriveParameters parameters{mode.freeAxes, mode.feature, mode.tool};
    const arm::MotionError error = plant_.arm().compliance().startFreedrive(parameters);
    return error == arm::MotionError::None ? Result<void>() : Result<void>(refusal(error, -1));
}

void ScriptMotion::endFreedrive() {
    plant_.arm().compliance().endFreedrive();
}

int ScriptMotion::freedriveStatus() const {
    return plant_.arm().compliance().freedriveStatus();
}

Result<void> ScriptMotion::setJointPositions(const JointPositions& q) {
    plant_.arm().setJointPositions(q);
    return {};
}

// Removes full revolutions only, and only of wrist 3 of the smallest arms, which can rotate without limit.
Result<void> ScriptMotion::resetRevolutionCounter(const JointPositions& qNear) {
    constexpr double kTurn = 2 * std::numbers::pi;
    arm::Arm& arm = plant_.arm();
    const RobotModelId id = arm.model().id;
    if (id == RobotModelId::UR3 || id == RobotModelId::UR3e) {
        JointPositions q = arm.state().targetQ;
        const double turns = std::round((q[5] - qNear[5]) / kTurn);
        if (turns != 0) {
            q[5] -= turns * kTurn;
            arm.setJointPositions(q);
        }
    }
    return {};
}

}  // namespace tiller::simulator
