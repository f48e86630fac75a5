// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_superposition.h"

#include <cmath>
#include <numbers>

#include "robot/simulator/plant/plant.h"

namespace tiller::simulator {

namespace {

Result<void> mayTrack(arm::Arm& arm, double ticks) {
    if (!(std::abs(ticks) > 0)) {
        return urscript::scriptError(
            "conveyor tracking: the number of ticks per metre or revolution must not be 0");
    }
    if (arm.compliance().isForceMode() || arm.compliance().isFreedrive()) {
        return urscript::scriptError(
            "conveyor tracking: not possible while force mode or freedrive is active");
    }
    return {};
}

}  // namespace

void ScriptSuperposition::stepConveyors() {
    arm::Arm& arm = plant_.arm();
    plant_.encoders().step(plant_.pins().digitalInputs, arm.environment().conveyorSpeeds(),
                           plant_.stepTime());
    arm.superposition().setTravel(plant_.encoders().travel(trackedEncoder_));
}

Result<void> ScriptSuperposition::enablePathOffset() {
    const arm::Compliance& compliance = plant_.arm().compliance();
    if (compliance.isForceMode() || compliance.isFreedrive()) {
        return urscript::scriptError(
            "path_offset_enable: not possible while force mode or freedrive is active");
    }
    plant_.arm().superposition().enableOffset();
    return {};
}

Result<void> ScriptSuperposition::setPathOffset(const Pose& offset, int type) {
    if (!offset.allFinite()) {
        return urscript::scriptError("path_offset_set: the offset must contain only finite numbers");
    }
    plant_.arm().superposition().setOffset(offset, static_cast<arm::OffsetFrame>(type));
    return {};
}

Result<Pose> ScriptSuperposition::pathOffset(int type) const {
    return plant_.arm().superposition().offset(static_cast<arm::OffsetFrame>(type));
}

Result<void> ScriptSuperposition::setPathOffsetFilter(double alpha) {
    if (alpha < 0 || alpha > 1) {
        return urscript::scriptError("path_offset_set_alpha_filter: alpha must be from 0 to 1");
    }
    plant_.arm().superposition().setFilter(alpha);
    return {};
}

Result<void> ScriptSuperposition::setPathOffsetLimits(double translation, double rotation) {
    if (translation < 0 || rotation < 0) {
        return urscript::scriptError("path_offset_set_max_offset: limits must not be negative");
    }
    plant_.arm().superposition().setLimits(translation, rotation);
    return {};
}

Result<void> ScriptSuperposition::trackConveyorLinear(const Pose& direction, double ticksPerMeter,
                                                      int encoder) {
    arm::Arm& arm = plant_.arm();
    if (Result<void> may = mayTrack(arm, ticksPerMeter); !may) {
        return may;
    }
    const double length = direction.position.norm();
    if (!(length > 1e-9) || !std::isfinite(length)) {
        return urscript::scriptError("track_conveyor_linear: the direction must not be zero");
    }
    trackedEncoder_ = encoder;
    arm.superposition().setTravel(plant_.encoders().travel(encoder));
    arm.superposition().trackLinear(direction.position / (length * ticksPerMeter));
    return {};
}

Result<void> ScriptSuperposition::trackConveyorCircular(const Pose& center, double ticksPerRevolution,
                                                        bool rotateTool, int encoder) {
    arm::Arm& arm = plant_.arm();
    if (Result<void> may = mayTrack(arm, ticksPerRevolution); !may) {
        return may;
    }
    if (!center.allFinite()) {
        return urscript::scriptError("track_conveyor_circular: the centre must contain only finite numbers");
    }
    trackedEncoder_ = encoder;
    arm.superposition().setTravel(plant_.encoders().travel(encoder));
    arm.superposition().trackCircular(center, 2 * std::numbers::pi / ticksPerRevolution, rotateTool);
    return {};
}

Result<double> ScriptSuperposition::encoderTicks(int encoder) const {
    return plant_.encoders().ticks(encoder);
}

Result<void> ScriptSuperposition::setEncoderTicks(int encoder, double ticks) {
    plant_.encoders().set(encoder, ticks);
    return {};
}

Result<void> ScriptSuperposition::enableEncoder(int encoder, int decoder, int inputA, int inputB) {
    plant_.encoders().enablePulses(encoder, decoder, inputA, inputB);
    return {};
}

Result<void> ScriptSuperposition::setEncoderRange(int encoder, int rangeId) {
    plant_.encoders().enableCount(encoder, rangeId);
    return {};
}

}  // namespace tiller::simulator
