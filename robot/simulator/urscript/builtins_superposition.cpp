// SPDX-License-Identifier: MIT
// Path offsets, conveyor tracking and the conveyor encoders.

#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

Status stopSuperposition(Call& c) {
    return c.motion([&] { return MotionCommand(StopSuperposition{std::abs(c.finite(0))}); });
}

Status pathOffsetEnable(Call& c) {
    c.check(c.host.enablePathOffset());
    return Status::Done;
}
Status pathOffsetSet(Call& c) {
    c.check(c.host.setPathOffset(c.poseOr6(0), c.integerIn(1, 1, 4)));
    return Status::Done;
}
Status pathOffsetGet(Call& c) {
    const Result<Pose> offset = c.host.pathOffset(c.integerIn(0, 1, 4));
    if (!offset.ok()) {
        fault(offset.error());
    }
    c.result = *offset;
    return Status::Done;
}
Status pathOffsetFilter(Call& c) {
    c.check(c.host.setPathOffsetFilter(c.finite(0)));
    return Status::Done;
}
Status pathOffsetLimits(Call& c) {
    c.check(c.host.setPathOffsetLimits(c.finite(0), c.finite(1)));
    return Status::Done;
}

Status trackLinear(Call& c) {
    c.check(c.host.trackConveyorLinear(c.poseOr6(0), c.finite(1), c.integerIn(2, 0, 1)));
    return Status::Done;
}
Status trackCircular(Call& c) {
    c.check(c.host.trackConveyorCircular(c.pose(0), c.finite(1), c.boolean(2), c.integerIn(3, 0, 1)));
    return Status::Done;
}

Status encoderGet(Call& c) {
    const Result<double> ticks = c.host.encoderTicks(c.args.empty() ? 0 : c.integerIn(0, 0, 1));
    if (!ticks.ok()) {
        fault(ticks.error());
    }
    c.result = *ticks;
    return Status::Done;
}
Status conveyorGet(Call& c) {
    encoderGet(c);
    c.result = static_cast<std::int32_t>(std::fmod(c.result.asFloat(), 2147483648.0));
    return Status::Done;
}
Status encoderSet(Call& c) {
    c.check(c.host.setEncoderTicks(c.integerIn(0, 0, 1), c.finite(1)));
    return Status::Done;
}
Status conveyorSet(Call& c) {
    c.check(c.host.setEncoderTicks(0, c.finite(0)));
    return Status::Done;
}
Status encoderEnable(Call& c) {
    c.check(c.host.enableEncoder(c.integerIn(0, 0, 1), c.integerIn(1, 0, 4), c.integerIn(2, 0, 3),
                                 c.integerIn(3, 0, 3)));
    return Status::Done;
}
Status conveyorDecode(Call& c) {
    c.check(c.host.enableEncoder(0, c.integerIn(0, 0, 4), c.integerIn(1, 0, 3), c.integerIn(2, 0, 3)));
    return Status::Done;
}
Status encoderRange(Call& c) {
    c.check(c.host.setEncoderRange(c.integerIn(0, 0, 1), c.integerIn(1, 0, 4)));
    return Status::Done;
}
// Difference between two tick counts with overflow of the 32-bit counter.
Status encoderUnwind(Call& c) {
    c.integerIn(0, 0, 1);
    c.result = std::remainder(c.finite(1), 4294967296.0);
    return Status::Done;
}

constexpr BuiltinRow kSuperpositionRows[] = {
    {"path_offset_enable()", pathOffsetEnable, kPlain, kAfter2019By2021},
    {"path_offset_disable(a=20)", stopSuperposition, kMotion, kAfter2019By2021},
    {"path_offset_set(offset, type)", pathOffsetSet, kPlain, kAfter2019By2021},
    {"path_offset_get(type)", pathOffsetGet, kPlain, kAfter2019},
    {"path_offset_set_alpha_filter(alpha)", pathOffsetFilter, kPlain, kAfter2019By2021},
    {"path_offset_set_max_offset(transLimit, rotLimit)", pathOffsetLimits, kPlain, kAfter2019},
    {"track_conveyor_linear(direction, ticks_per_meter, encoder_index=0)", trackLinear},
    {"track_conveyor_circular(center, ticks_per_revolution, rotate_tool=False, encoder_index=0)",
     trackCircular},
    {"stop_conveyor_tracking(a=20)", stopSuperposition, kMotion},
    {"conveyor_pulse_decode(type, A, B)", conveyorDecode},
    {"encoder_enable_pulse_decode(encoder_index, decoder_type, A, B)", encoderEnable, kPlain, kAfter33},
    {"encoder_enable_set_tick_count(encoder_index, range_id)", encoderRange, kPlain, kAfter33},
    {"encoder_get_tick_count(encoder_index)", encoderGet, kPlain, kAfter33},
    {"encoder_set_tick_count(encoder_index, count)", encoderSet, kPlain, kAfter33},
    {"encoder_unwind_delta_tick_count(encoder_index, delta_tick_count)", encoderUnwind, kPlain,
     kAfter2019By2021},
    {"get_conveyor_tick_count()", conveyorGet},
    {"set_conveyor_tick_count(tick_count, absolute_encoder_resolution=0)", conveyorSet},
};

}  // namespace

std::span<const BuiltinRow> superpositionBuiltins() {
    return kSuperpositionRows;
}

}  // namespace tiller::simulator::urscript
