// SPDX-License-Identifier: MIT
#include "robot/control/compliance.h"

#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/versions.h"

namespace tiller::control {

namespace {

constexpr SoftwareVersion kDampingOnCb3{3, 5, 0, 0};

std::int32_t bitsOf(const std::array<bool, 6>& axes) {
    std::int32_t bits = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        bits |= axes[i] ? 1 << i : 0;
    }
    return bits;
}

std::span<const double> numbersOf(const Vector6& values) {
    return {values.data(), 6};
}

}  // namespace

Result<void> Compliance::setForceMode(const ForceMode& mode, const Deadline& deadline) {
    constexpr auto kContext = "set force mode";
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = stops_.value_or(d.mailbox.epoch().stops());
    ArgumentCheck check = ArgumentCheck(kContext).pose("taskFrame", mode.taskFrame);
    const Vector6 wrench = mode.wrench.vector();
    // These limits exceed the force and torque of all arms. The controller's own limits are lower.
    constexpr double kHighestForce = 1000.0;
    constexpr double kHighestTorque = 200.0;
    for (int i = 0; i < 6; ++i) {
        const double most = i < 3 ? kHighestForce : kHighestTorque;
        check.range("wrench", wrench[i], -most, most, i < 3 ? "N" : "Nm");
    }
    constexpr double kHighestLimit = 10.0;
    for (const double limit : mode.limits) {
        check.positive("limits", limit, kHighestLimit, "m/s, rad/s, m or rad", "mm or degrees");
    }
    if (!check.ok()) {
        return check.error();
    }
    const QString context = QString::fromLatin1(kContext);
    const auto type = static_cast<int>(mode.type);
    if (type < 1 || type > 3) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("type: must be 1, 2 or 3")};
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    std::array<double, 18> numbers{};
    std::copy_n(wrench.data(), 6, numbers.begin());
    const auto frame = mode.taskFrame.array();
    std::copy(frame.begin(), frame.end(), numbers.begin() + 6);
    std::copy(mode.limits.begin(), mode.limits.end(), numbers.begin() + 12);
    constexpr int kAboveAxes = 64;
    const std::int32_t whole = bitsOf(mode.compliant) + type * kAboveAxes;
    d.loop.permitForce(true);
    Result<void> on;
    if (d.mailbox.epoch().stops() == stops) {
        on = noAnswer(d.requests.request(RequestKind::ForceMode, whole, numbers, context, deadline));
    } else {
        on = Error{ErrorCode::Stopped, context, QStringLiteral("interrupted by a stop")};
    }
    if (!on) {
        d.loop.permitForce(false);  // force mode may have started despite the error
    }
    return on;
}

Result<void> Compliance::endForceMode(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const auto ended =
        d.requests.request(RequestKind::EndForceMode, 0, {}, QStringLiteral("end force mode"), deadline);
    d.loop.permitForce(false);  // also ends force mode if the answer is lost
    return noAnswer(ended);
}

Result<void> Compliance::setForceDamping(double damping, const Deadline& deadline) {
    const ArgumentCheck check = ArgumentCheck("set force damping").range("damping", damping, 0, 1, "");
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("set force damping");
    if (const auto known = d.program.needs(kESeries, kDampingOnCb3, context); !known) {
        return known;
    }
    return noAnswer(d.requests.request(RequestKind::ForceDamping, 0, {&damping, 1}, context, deadline));
}

Result<void> Compliance::setForceGainScaling(double scaling, const Deadline& deadline) {
    const ArgumentCheck check = ArgumentCheck("set force gain scaling").range("scaling", scaling, 0, 2, "");
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("set force gain scaling");
    if (const auto known = d.program.needs(kESeries, {}, context); !known) {
        return known;
    }
    return noAnswer(d.requests.request(RequestKind::ForceGainScaling, 0, {&scaling, 1}, context, deadline));
}

Result<Motion> Compliance::startFreedrive(const Freedrive& freedrive, Holding holding) {
    const ArgumentCheck check = ArgumentCheck("start freedrive").pose("feature", freedrive.feature);
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    const QString context = QStringLiteral("start freedrive");
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    const Freedrive whole;
    if (freedrive.freeAxes != whole.freeAxes || !(freedrive.feature == whole.feature)) {
        if (const auto known = d.program.needs({5, 10, 0, 0}, {}, context); !known) {
            return known.error();
        }
    }
    if (bitsOf(freedrive.freeAxes) == 0) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("freeAxes: at least one axis must be free")};
    }
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(ScriptCommand::Freedrive);
    command.held = holding == Holding::Held;
    command.choice = bitsOf(freedrive.freeAxes);
    command.target = freedrive.feature.array();
    const auto id = d.start(command, stops, context);
    return id ? MotionAccess::make(*controller_, *id, MotionKind::Freedrive) : Result<Motion>(id.error());
}

Result<Motion> Compliance::startTeachMode(Holding holding) {
    auto& d = ControllerAccess::of(*controller_);
    const std::uint64_t stops = d.mailbox.epoch().stops();
    const QString context = QStringLiteral("start teach mode");
    if (const auto known = d.program.knows("teach_mode", context); !known) {
        return known.error();
    }
    if (const Error error = d.obstacle(context); error.code != ErrorCode::None) {
        return error;
    }
    MotionCommand command;
    command.kind = MotionCommand::Kind::Program;
    command.program = static_cast<std::int32_t>(ScriptCommand::Teach);
    command.held = holding == Holding::Held;
    const auto id = d.start(command, stops, context);
    return id ? MotionAccess::make(*controller_, *id, MotionKind::Freedrive) : Result<Motion>(id.error());
}

Result<void> Compliance::startContactDetection(const Twist& direction, const Deadline& deadline,
                                               AfterContact after) {
    const Vector6 values = direction.vector();
    const ArgumentCheck check =
        ArgumentCheck("start contact detection").finite("direction", values.data(), 6);
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("start contact detection");
    if (const auto known = d.program.needs(kContactSince, {}, context); !known) {
        return known;
    }
    const std::int32_t how = after == AfterContact::Return ? 2 : 1;
    return noAnswer(d.requests.request(RequestKind::WatchContact, how, numbersOf(values), context, deadline));
}

Result<bool> Compliance::hasContact(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const auto answer = d.requests.request(RequestKind::ReadContact, 0, {},
                                           QStringLiteral("read contact detection"), deadline);
    return answer ? Result<bool>(answer->whole != 0) : answer.error();
}

Result<bool> Compliance::endContactDetection(const Deadline& deadline) {
    const auto touched = hasContact(deadline);
    if (!touched) {
        return touched;
    }
    auto& d = ControllerAccess::of(*controller_);
    const auto ended = d.requests.request(RequestKind::WatchContact, 0, {},
                                          QStringLiteral("end contact detection"), deadline);
    return ended ? touched : Result<bool>(ended.error());
}

}  // namespace tiller::control
