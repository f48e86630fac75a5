// SPDX-License-Identifier: MIT
//
// The motion part of ScriptHost: URScript's commands in the arm's words.

#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/simulator/plant.h"
#include "robot/simulator/script_host.h"

namespace tiller::simulator {

namespace {

using urscript::Move;

/// optimovej and optimovel take fractions of what the arm can do.
constexpr double kOptimoveJointAcceleration = 10.0;  ///< [rad/s2] at 1
constexpr double kOptimoveToolSpeed = 1.0;           ///< [m/s] at 1
constexpr double kOptimoveToolAcceleration = 2.5;    ///< [m/s2] at 1

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

/// Starts each kind of command on the arm's motion generator.
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
    arm::MotionStart operator()(const urscript::StopSuperposition&) const {
        return {};  // nothing is superposed here, so nothing has to stop
    }
};

}  // namespace

Result<void> ScriptHost::accepted(urscript::ThreadId thread, const arm::MotionStart& start) {
    if (!start.ok()) {
        return refusal(start.error, start.joint);
    }
    motions_[thread] = start.id;
    return {};
}

Result<void> ScriptHost::startMotion(urscript::ThreadId thread, const urscript::MotionCommand& command) {
    return accepted(thread, std::visit(Starter{plant_.arm()}, command));
}

Result<bool> ScriptHost::motionFinished(urscript::ThreadId thread) {
    const auto it = motions_.find(thread);
    if (it == motions_.end() || it->second == 0) {
        return true;
    }
    switch (plant_.arm().motion().progress(it->second)) {
        case arm::MotionProgress::Running:
            return false;
        case arm::MotionProgress::Failed:
            // The program is about to be paused; it may go on behind the move once it is resumed.
            return !plant_.safety().isProtectiveStopped() && !plant_.arm().protectiveStop();
        case arm::MotionProgress::Returned:
        case arm::MotionProgress::Superseded:
            break;
    }
    motions_.erase(it);
    return true;
}

void ScriptHost::motionAbandoned(urscript::ThreadId thread) {
    if (motions_.erase(thread) > 0) {
        plant_.arm().motion().abandon();
    }
}

Result<void> ScriptHost::forceMode(const urscript::ForceMode& mode) {
    const arm::ForceModeParameters parameters{mode.taskFrame, mode.compliant, mode.wrench, mode.type,
                                              mode.limits};
    const arm::MotionError error = plant_.arm().compliance().startForceMode(parameters);
    return error == arm::MotionError::None ? Result<void>() : Result<void>(refusal(error, -1));
}

void ScriptHost::endForceMode() {
    plant_.arm().compliance().endForceMode();
}

Result<void> ScriptHost::setForceModeDamping(double damping) {
    plant_.arm().compliance().setDamping(damping);
    return {};
}

double ScriptHost::forceModeDamping() const {
    return plant_.arm().compliance().damping();
}

Result<void> ScriptHost::setForceModeGainScaling(double scaling) {
    plant_.arm().compliance().setGainScaling(scaling);
    return {};
}

double ScriptHost::forceModeGainScaling() const {
    return plant_.arm().compliance().gainScaling();
}

Result<void> ScriptHost::freedrive(const urscript::Freedrive& mode) {
    const arm::FreedriveParameters parameters{mode.freeAxes, mode.feature, mode.tool};
    const arm::MotionError error = plant_.arm().compliance().startFreedrive(parameters);
    return error == arm::MotionError::None ? Result<void>() : Result<void>(refusal(error, -1));
}

void ScriptHost::endFreedrive() {
    plant_.arm().compliance().endFreedrive();
}

int ScriptHost::freedriveStatus() const {
    return plant_.arm().compliance().freedriveStatus();
}

Result<void> ScriptHost::setJointPositions(const JointPositions& q) {
    plant_.arm().setJointPositions(q);
    return {};
}

}  // namespace tiller::simulator
