// SPDX-License-Identifier: MIT
// Time, messages, and control of the running program.

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

Status sync(Call& c) {
    c.endFrame = true;
    return Status::Done;
}

Status sleep(Call& c) {
    const double seconds = c.number(0);
    if (!(seconds >= 0)) {
        fault("sleep: time must not be negative");
    }
    // Limited to one year, because a larger value could overflow the nanoseconds.
    c.consumedNs = std::llround(std::min(seconds, 3.2e7) * 1e9);
    return Status::Done;
}

Status getSteptime(Call& c) {
    c.result = c.host.stepTime();
    return Status::Done;
}

Status time(Call& c) {
    const std::int32_t mode = c.integer(0);
    if (mode != 0 && mode != 2) {
        fault("time: mode must be 0 or 2");
    }
    const std::int64_t ns = mode == 0 ? c.host.controllerTimeNs() : c.host.systemTimeNs();
    StructData data;
    data.members.emplace_back("sec", static_cast<std::int32_t>(ns / 1'000'000'000));
    data.members.emplace_back("nanosec", static_cast<std::int32_t>(ns % 1'000'000'000));
    c.result = Value::structure(std::move(data));
    return Status::Done;
}

Status textmsg(Call& c) {
    c.host.textMessage(toMessageText(c.args[0]) + toMessageText(c.args[1]));
    return Status::Done;
}

Status popup(Call& c) {
    if (!c.first) {
        return c.host.popupOpen(static_cast<int>(c.state)) ? Status::Again : Status::Done;
    }
    Popup popup;
    popup.text = toMessageText(c.args[0]);
    popup.title = c.string(1);
    popup.warning = c.boolean(2);
    popup.error = c.boolean(3);
    popup.blocking = c.boolean(4);
    c.state = c.host.showPopup(popup);
    return popup.blocking ? Status::Again : Status::Done;
}

template <RequestedType kind>
Status request(Call& c) {
    if (c.first) {
        const Result<int> id = c.host.requestValue(kind, c.string(0));
        if (!id.ok()) {
            fault(id.error());
        }
        c.state = *id;
        return Status::Again;
    }
    const std::optional<RequestAnswer> answer = c.host.requestedValue(static_cast<int>(c.state));
    if (!answer) {
        return Status::Again;
    }
    c.result = std::visit([](const auto& v) { return Value(v); }, *answer);
    return Status::Done;
}

Status protectiveStop(Call& c) {
    c.check(c.host.protectiveStop());
    return Status::Done;
}

Status powerdown(Call& c) {
    c.host.powerDown();
    return Status::Done;
}

Status setWatchdog(Call& c) {
    const double frequency = c.finite(1);
    if (!(frequency > 0)) {
        fault("rtde_set_watchdog: min_frequency must be greater than 0");
    }
    std::string action = c.string(2);
    std::transform(action.begin(), action.end(), action.begin(),
                   [](char ch) { return static_cast<char>(std::tolower(static_cast<unsigned char>(ch))); });
    WatchdogAction what = WatchdogAction::Pause;
    if (action == "stop") {
        what = WatchdogAction::Stop;
    } else if (action == "ignore") {
        what = WatchdogAction::Ignore;
    } else if (action != "pause") {
        fault("rtde_set_watchdog: action must be \"pause\", \"stop\" or \"ignore\"");
    }
    c.check(c.host.setWatchdog(c.string(0), frequency, what));
    return Status::Done;
}

Status assertTrue(Call& c) {
    if (!c.boolean(0)) {
        fault("Assertion failed: " + toMessageText(c.args[1]));
    }
    return Status::Done;
}

constexpr BuiltinRow kProgramRows[] = {
    {"sync()", sync},
    {"sleep(t)", sleep},
    {"get_steptime()", getSteptime},
    {"time(mode=0)", time, kPlain, {{17}}},
    {"textmsg(s1, s2=\"\")", textmsg},
    {"popup(s, title=\"Popup\", warning=False, error=False, blocking=False)", popup},
    {"varmsg(name, value)", setting},
    {"request_boolean_from_primary_client(text)", request<RequestedType::Boolean>, kPlain, kAfter2019By2021},
    {"request_integer_from_primary_client(text)", request<RequestedType::Integer>, kPlain, kAfter2019By2021},
    {"request_float_from_primary_client(text)", request<RequestedType::Float>, kPlain, kAfter2019By2021},
    {"request_string_from_primary_client(text)", request<RequestedType::String>, kPlain, kAfter2019By2021},
    {"protective_stop()", protectiveStop, kPlain, {{0, 0, 8}}},
    {"powerdown()", powerdown},
    {"rtde_set_watchdog(variable_name, min_frequency, action=\"pause\")", setWatchdog},
    {"assert(cond, msg=\"\")", assertTrue},
};

}  // namespace

std::span<const BuiltinRow> programBuiltins() {
    return kProgramRows;
}

}  // namespace tiller::simulator::urscript
