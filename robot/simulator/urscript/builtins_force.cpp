// SPDX-License-Identifier: MIT
// Force mode, freedrive, screw driving.

#include <algorithm>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

std::array<bool, 6> flags(const Call& c, std::size_t i) {
    const std::array<double, 6> values = c.six(i);
    std::array<bool, 6> out{};
    std::transform(values.begin(), values.end(), out.begin(), [](double d) { return d != 0; });
    return out;
}

Status forceMode(Call& c) {
    ForceMode mode;
    mode.taskFrame = c.poseOr6(0);
    mode.compliant = flags(c, 1);
    const std::array<double, 6> wrench = c.six(2);
    mode.wrench = Wrench::fromVector(Eigen::Map<const Vector6>(wrench.data()));
    mode.type = c.integerIn(3, 1, 3);
    const std::array<double, 6> limits = c.six(4);
    mode.limits = Eigen::Map<const Vector6>(limits.data());
    if (!mode.taskFrame.allFinite() || !mode.wrench.vector().allFinite() || !mode.limits.allFinite()) {
        fault("force_mode: arguments must be finite numbers");
    }
    c.check(c.host.forceMode(mode));
    return Status::Done;
}

Status endForceMode(Call& c) {
    c.host.endForceMode();
    return Status::Done;
}

double within(const Call& c, double low, double high) {
    const double value = c.number(0);
    if (!(value >= low && value <= high)) {
        fault(c.name() + ": value must be from " + toStr(low) + " to " + toStr(high));
    }
    return value;
}

Status setDamping(Call& c) {
    c.check(c.host.setForceModeDamping(within(c, 0, 1)));
    return Status::Done;
}
Status getDamping(Call& c) {
    c.result = c.host.forceModeDamping();
    return Status::Done;
}
Status setGain(Call& c) {
    c.check(c.host.setForceModeGainScaling(within(c, 0, 2)));
    return Status::Done;
}
Status getGain(Call& c) {
    c.result = c.host.forceModeGainScaling();
    return Status::Done;
}

Status freedriveMode(Call& c) {
    Freedrive mode;
    if (c.given(0)) {
        mode.freeAxes = flags(c, 0);
    }
    if (c.given(1) && c.args[1].is(Value::Type::String)) {
        const std::string& name = c.string(1);
        if (name != "base" && name != "tool") {
            fault("freedrive_mode: feature must be a pose, \"base\" or \"tool\"");
        }
        mode.tool = name == "tool";
    } else if (c.given(1)) {
        mode.feature = c.poseOr6(1);
    }
    c.check(c.host.freedrive(mode));
    return Status::Done;
}

Status freedriveUnchecked(Call& c) {
    Freedrive mode;
    mode.checkPayload = false;
    c.check(c.host.freedrive(mode));
    return Status::Done;
}

Status endFreedrive(Call& c) {
    c.host.endFreedrive();
    return Status::Done;
}

Status teachMode(Call& c) {
    c.check(c.host.freedrive({}));
    return Status::Done;
}

Status freedriveStatus(Call& c) {
    c.result = std::int32_t{c.host.freedriveStatus()};
    return Status::Done;
}

Status screwDriving(Call& c) {
    c.check(c.host.screwDriving(c.finite(0), c.finite(1)));
    return Status::Done;
}
Status endScrewDriving(Call& c) {
    c.check(c.host.endScrewDriving());
    return Status::Done;
}

constexpr BuiltinRow kForceRows[] = {
    {"force_mode(task_frame, selection_vector, wrench, type, limits)", forceMode},
    {"end_force_mode()", endForceMode},
    {"force_mode_set_damping(damping)", setDamping, kPlain, {{0, 0, 5}}},
    {"force_mode_get_damping()", getDamping, kPlain, kAfter515},
    // Available in series 3 too, because control scripts for both series contain conditional calls of this
    // function.
    {"force_mode_set_gain_scaling(scaling)", setGain},
    {"force_mode_get_gain_scaling()", getGain, kPlain, kAfter515},
    {"freedrive_mode(freeAxes?, feature?)", freedriveMode},
    {"freedrive_mode_no_incorrect_payload_check()", freedriveUnchecked, kPlain, kAfter515},
    {"end_freedrive_mode()", endFreedrive},
    {"get_freedrive_status()", freedriveStatus, kPlain, {{10}}},
    {"teach_mode()", teachMode},
    {"end_teach_mode()", endFreedrive},
    {"screw_driving(f, v_limit)", screwDriving, kPlain, kAfter2019},
    {"end_screw_driving()", endScrewDriving, kPlain, kAfter2019},
};

}  // namespace

std::span<const BuiltinRow> forceBuiltins() {
    return kForceRows;
}

}  // namespace tiller::simulator::urscript
