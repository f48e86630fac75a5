// SPDX-License-Identifier: MIT
// Moves, servo and speed commands, stops.

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

void checkMove(const Call& c, const Move& move) {
    if (!(move.acceleration > 0) || !(move.velocity > 0)) {
        fault(c.name() + ": acceleration and velocity must be greater than 0");
    }
    if (move.duration < 0 || move.blend < 0) {
        fault(c.name() + ": time and blend radius must not be negative");
    }
}

Move moveOf(Call& c, Move::Kind kind) {
    Move move;
    move.kind = kind;
    move.target = c.target(0);
    move.acceleration = c.finite(1);
    move.velocity = c.finite(2);
    return move;
}

Status movej(Call& c) {
    return c.motion([&] {
        Move move = moveOf(c, Move::Kind::J);
        move.duration = c.finite(3);
        move.blend = c.finite(4);
        checkMove(c, move);
        return MotionCommand(move);
    });
}

Status movel(Call& c) {
    return c.motion([&] {
        Move move = moveOf(c, Move::Kind::L);
        move.duration = c.finite(3);
        move.blend = c.finite(4);
        checkMove(c, move);
        return MotionCommand(move);
    });
}

Status movep(Call& c) {
    return c.motion([&] {
        Move move = moveOf(c, Move::Kind::P);
        move.blend = c.finite(3);
        checkMove(c, move);
        return MotionCommand(move);
    });
}

Status movec(Call& c) {
    return c.motion([&] {
        Move move;
        move.kind = Move::Kind::C;
        move.via = c.target(0);
        move.target = c.target(1);
        move.acceleration = c.finite(2);
        move.velocity = c.finite(3);
        move.blend = c.finite(4);
        move.orientationMode = c.integerIn(5, 0, 1);
        checkMove(c, move);
        return MotionCommand(move);
    });
}

Value frameInBase(const Call& c, const std::string& frame, const Pose& inFrame) {
    const Result<Pose> pose = c.host.convertPose(inFrame, frame, "base");
    if (!pose.ok()) {
        fault(pose.error());
    }
    return *pose;
}

MotionCommand optimove(Call& c, Move::Kind kind) {
    // A goal may be a frame name or struct(pose, frame).
    if (c.args[0].is(Value::Type::String)) {
        c.args[0] = frameInBase(c, c.string(0), {});
    } else if (c.args[0].is(Value::Type::Struct)) {
        const Value* pose = c.args[0].structure().find("pose");
        const Value* frame = c.args[0].structure().find("frame");
        if (pose == nullptr || frame == nullptr || !pose->is(Value::Type::Pose) ||
            !frame->is(Value::Type::String)) {
            c.badArgument(0, "struct(pose, frame)");
        }
        c.args[0] = frameInBase(c, frame->string(), Pose::fromArray(pose->pose()));
    }
    Move move = moveOf(c, kind);
    move.blend = c.finite(3);
    checkMove(c, move);
    if (move.acceleration > 1 || move.velocity > 1) {
        fault(c.name() + ": acceleration and velocity are fractions, at most 1");
    }
    return move;
}
Status optimovej(Call& c) {
    return c.motion([&] { return optimove(c, Move::Kind::OptimoveJ); });
}
Status optimovel(Call& c) {
    return c.motion([&] { return optimove(c, Move::Kind::OptimoveL); });
}

// The parameters a and v (1 and 2) have no effect, as on the controller.
Status servoj(Call& c) {
    return c.motion([&] {
        ServoJ servo;
        servo.q = c.joints(0);
        servo.duration = c.given(3) ? c.finite(3) : static_cast<double>(c.stepNs()) * 1e-9;
        servo.lookahead = c.finite(4);
        servo.gain = c.finite(5);
        return MotionCommand(servo);
    });
}

Status servoc(Call& c) {
    return c.motion([&] {
        return MotionCommand(ServoC{c.target(0), c.finite(1), c.finite(2), c.finite(3)});
    });
}

std::optional<double> duration(const Call& c, std::size_t i) {
    return c.given(i) ? std::optional(std::max(c.finite(i), 0.0)) : std::nullopt;
}

// The acceleration may be infinite, because scripts divide by a remaining time.
double acceleration(const Call& c, std::size_t i) {
    const double a = c.number(i);
    if (std::isnan(a)) {
        c.badArgument(i, "a number");
    }
    return std::abs(a);
}

std::array<double, 6> speeds(const Call& c) {
    const std::array<double, 6> v = c.six(0);
    if (!std::all_of(v.begin(), v.end(), [](double d) { return std::isfinite(d); })) {
        c.badArgument(0, "a list of six finite numbers");
    }
    return v;
}

Status speedj(Call& c) {
    return c.motion([&] {
        return MotionCommand(SpeedJ{JointVelocities(speeds(c)), acceleration(c, 1), duration(c, 2)});
    });
}

Status speedl(Call& c) {
    return c.motion([&] {
        const std::array<double, 6> v = speeds(c);
        SpeedL speed;
        speed.xd = Twist::fromVector(Eigen::Map<const Vector6>(v.data()));
        speed.acceleration = acceleration(c, 1);
        speed.duration = duration(c, 2);
        speed.rotationAcceleration = c.given(3) ? acceleration(c, 3) : speed.acceleration;
        return MotionCommand(speed);
    });
}

Status stopj(Call& c) {
    return c.motion([&] { return MotionCommand(StopJ{std::abs(c.finite(0))}); });
}

Status stopl(Call& c) {
    return c.motion([&] {
        const double a = std::abs(c.finite(0));
        return MotionCommand(StopL{a, c.given(1) ? std::abs(c.finite(1)) : a});
    });
}

// The function has two signatures: (torques, friction_comp) and (torque, viscous_scale, coulomb_scale).
Status directTorque(Call& c) {
    return c.motion([&] {
        DirectTorque torque;
        torque.torque = JointTorques(c.six(0));
        if (!torque.torque.allFinite()) {
            c.badArgument(0, "a list of six finite numbers");
        }
        if (c.given(1) && c.args[1].is(Value::Type::Bool)) {
            torque.frictionCompensation = c.boolean(1);
        } else if (c.given(1)) {
            const std::array<double, 6> scale = c.six(1);
            torque.viscous = Eigen::Map<const Vector6>(scale.data());
        }
        if (c.given(2)) {
            const std::array<double, 6> scale = c.six(2);
            torque.coulomb = Eigen::Map<const Vector6>(scale.data());
        }
        if (c.given(3)) {
            torque.frictionCompensation = c.boolean(3);
        }
        return MotionCommand(torque);
    });
}

Status setPos(Call& c) {
    c.check(c.host.setJointPositions(c.joints(0)));
    return Status::Done;
}

Status resetRevolutionCounter(Call& c) {
    c.check(c.host.resetRevolutionCounter(c.given(0) ? c.joints(0) : JointPositions()));
    return Status::Done;
}

Status motionVersionSet(Call& c) {
    c.context().motionVersion = c.integerIn(0, 1, 2);
    return setting(c);
}
Status motionVersionGet(Call& c) {
    c.result = std::int32_t{c.context().motionVersion};
    return Status::Done;
}
Status jerkGainSet(Call& c) {
    const double gain = c.number(0);
    if (!(gain >= 0.01 && gain <= 1.0)) {
        fault("jerk_gain_scaling_set: gain must be from 0.01 to 1.0");
    }
    c.context().jerkGain = gain;
    return setting(c);
}
Status jerkGainGet(Call& c) {
    c.result = c.context().jerkGain;
    return Status::Done;
}

constexpr const char* kNoJerkLimit = "motion profiles have no jerk limit";

constexpr BuiltinRow kMotionRows[] = {
    {"movej(q, a=1.4, v=1.05, t=0, r=0)", movej, kMotion},
    {"movel(pose, a=1.2, v=0.25, t=0, r=0)", movel, kMotion},
    {"movep(pose, a=1.2, v=0.25, r=0)", movep, kMotion},
    {"movec(pose_via, pose_to, a=1.2, v=0.25, r=0, mode=0)", movec, kMotion},
    {"optimovej(goal, a=0.3, v=0.3, r=0)", optimovej, kMotion, {{21, 8}}, nullptr, kNoJerkLimit},
    {"optimovel(goal, a=0.3, v=0.3, r=0)", optimovel, kMotion, {{21, 8}}, nullptr, kNoJerkLimit},
    {"servoj(q, a?, v?, t?, lookahead_time=0.1, gain=300)", servoj, kMotion},
    {"servoc(pose, a=1.2, v=0.25, r=0)", servoc, kMotion},
    {"speedj(qd, a, t|t_min?)", speedj, kMotion},
    {"speedl(xd, a, t|t_min?, aRot?)", speedl, kMotion},
    {"stopj(a)", stopj, kMotion},
    {"stopl(a, aRot?)", stopl, kMotion},
    {"direct_torque(torque|torques, viscous_scale?, coulomb_scale?, friction_comp?)",
     directTorque,
     kMotion,
     {{23, 10}}},
    {"set_pos(q)", setPos},
    {"reset_revolution_counter(qNear?)", resetRevolutionCounter},
    {"set_safety_mode_transition_hardness(type)", setting, kPlain, kAfter33},
    {"position_deviation_warning(enabled, threshold=0.8)", setting},
    {"pause_on_error_code(code, argument?)", setting, kPlain, kAfter2019},
    {"tool_wrench_limit_set(frame_offset, Fx?, Fy?, Fz?, Mx?, My?, Mz?)", setting, kPlain, {{19}}},
    {"tool_wrench_limit_disable()", setting, kPlain, {{19}}},
    {"motion_version_set(version)", motionVersionSet, kPlain, kAfter515, nullptr,
     "movej and movel always use the profile of version 1"},
    {"motion_version_get()", motionVersionGet, kPlain, kAfter515},
    {"jerk_gain_scaling_set(gain)", jerkGainSet, kPlain, kAfter515, nullptr, kNoJerkLimit},
    {"jerk_gain_scaling_get()", jerkGainGet, kPlain, kAfter515},
    {"frame_tracking_enable(frame_name)", absent, kPlain, kPolyScopeX, "a moving frame"},
    {"frame_tracking_disable()", absent, kPlain, kPolyScopeX, "a moving frame"},
};

}  // namespace

std::span<const BuiltinRow> motionBuiltins() {
    return kMotionRows;
}

}  // namespace tiller::simulator::urscript
