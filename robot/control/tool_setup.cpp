// SPDX-License-Identifier: MIT
#include "robot/control/tool_setup.h"

#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/versions.h"
#include "robot/core/wait_until.h"

namespace tiller::control {

namespace {

/// [kg]; exceeds the payload of all models. The controller checks its own limit.
constexpr double kHeaviestPayload = 50.0;
constexpr double kFarthest = 2.0;  ///< [m] from the flange

std::array<double, 7> numbersOf(double first, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b = Eigen::Vector3d::Zero()) {
    return {first, a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

Error check(const char* context, const ExternalSensor& sensor) {
    return ArgumentCheck(context)
        .range("mass", sensor.mass, 0, kHeaviestPayload, "kg")
        .offset("measuringOffset", sensor.measuringOffset, kFarthest)
        .offset("centreOfGravity", sensor.centreOfGravity, kFarthest)
        .error();
}

}  // namespace

Result<void> ToolSetup::setPayload(double mass, const std::optional<Eigen::Vector3d>& centreOfGravity,
                                   const Deadline& deadline) {
    const Eigen::Vector3d centre = centreOfGravity.value_or(Eigen::Vector3d::Zero());
    const ArgumentCheck check = ArgumentCheck("set the payload")
                                    .range("mass", mass, 0, kHeaviestPayload, "kg")
                                    .offset("centreOfGravity", centre, kFarthest);
    if (!check.ok()) {
        return check.error();
    }
    return noAnswer(ControllerAccess::of(*controller_)
                        .requests.request(RequestKind::SetPayload, centreOfGravity ? 1 : 0,
                                          std::span<const double>(numbersOf(mass, centre)).first(4),
                                          QStringLiteral("set the payload"), deadline));
}

Result<void> ToolSetup::setTargetPayload(double mass, const Eigen::Vector3d& centreOfGravity,
                                         const std::array<double, 6>& inertia, const Deadline& deadline) {
    constexpr auto kContext = "set the target payload";
    const ArgumentCheck check = ArgumentCheck(kContext)
                                    .range("mass", mass, 0, kHeaviestPayload, "kg")
                                    .offset("centreOfGravity", centreOfGravity, kFarthest)
                                    .finite("inertia", inertia.data(), 6);
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QString::fromLatin1(kContext);
    if (const auto known = d.program.needs({5, 10, 0, 0}, {}, context); !known) {
        return known;
    }
    const Eigen::Vector3d& c = centreOfGravity;
    std::array<double, 10> numbers{mass, c.x(), c.y(), c.z()};
    std::copy(inertia.begin(), inertia.end(), numbers.begin() + 4);
    return noAnswer(d.requests.request(RequestKind::SetTargetPayload, 0, numbers, context, deadline));
}

Result<void> ToolSetup::setTcp(const Pose& tcp, const Deadline& deadline) {
    const ArgumentCheck check =
        ArgumentCheck("set the TCP").pose("tcp", tcp).offset("tcp", tcp.position, kFarthest);
    if (!check.ok()) {
        return check.error();
    }
    const auto numbers = tcp.array();
    return noAnswer(
        ControllerAccess::of(*controller_)
            .requests.request(RequestKind::SetTcp, 0, numbers, QStringLiteral("set the TCP"), deadline));
}

Result<void> ToolSetup::setGravity(const Eigen::Vector3d& direction, const Deadline& deadline) {
    constexpr double kOnAnyPlanet = 30.0;
    ArgumentCheck check = ArgumentCheck("set gravity").finite("direction", direction.data(), 3);
    if (check.ok()) {
        check.range("direction", direction.norm(), 0, kOnAnyPlanet, "m/s2");
    }
    if (!check.ok()) {
        return check.error();
    }
    return noAnswer(ControllerAccess::of(*controller_)
                        .requests.request(RequestKind::SetGravity, 0, {direction.data(), 3},
                                          QStringLiteral("set gravity"), deadline));
}

Result<void> ToolSetup::zeroForceSensor(const Deadline& deadline) {
    return noAnswer(ControllerAccess::of(*controller_)
                        .requests.request(RequestKind::ZeroForceSensor, 0, {},
                                          QStringLiteral("zero the force sensor"), deadline));
}

Result<void> ToolSetup::useExternalSensor(const ExternalSensor& sensor, const Deadline& deadline) {
    constexpr auto kContext = "use an external force sensor";
    if (const Error error = check(kContext, sensor); error.code != ErrorCode::None) {
        return error;
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QString::fromLatin1(kContext);
    if (const auto known = d.program.needs({5, 9, 0, 0}, {3, 14, 0, 0}, context); !known) {
        return known;
    }
    return noAnswer(d.requests.request(RequestKind::ExternalSensor, 1,
                                       numbersOf(sensor.mass, sensor.measuringOffset, sensor.centreOfGravity),
                                       context, deadline));
}

Result<void> ToolSetup::useExternalSensorLegacy(const ExternalSensor& sensor, const Deadline& deadline) {
    constexpr auto kContext = "use an external force sensor";
    if (const Error error = check(kContext, sensor); error.code != ErrorCode::None) {
        return error;
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QString::fromLatin1(kContext);
    if (const auto known = d.program.knows("enable_external_ft_sensor", context); !known) {
        return known;
    }
    return noAnswer(d.requests.request(RequestKind::ExternalSensorLegacy, 1,
                                       numbersOf(sensor.mass, sensor.measuringOffset, sensor.centreOfGravity),
                                       context, deadline));
}

Result<void> ToolSetup::useOwnSensor(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("use the robot's own force sensor");
    const bool modern = d.program.needs({5, 9, 0, 0}, {3, 14, 0, 0}, context).ok();
    if (const auto known = d.program.knows("enable_external_ft_sensor", context); !modern && !known) {
        return known;
    }
    return noAnswer(d.requests.request(
        modern ? RequestKind::ExternalSensor : RequestKind::ExternalSensorLegacy, 0, {}, context, deadline));
}

Result<void> ToolSetup::setExternalWrench(const Wrench& wrench) {
    const Vector6 values = wrench.vector();
    const ArgumentCheck check = ArgumentCheck("send a wrench").finite("wrench", values.data(), 6);
    if (!check.ok()) {
        return check.error();
    }
    std::array<double, 6> numbers{};
    std::copy_n(values.data(), numbers.size(), numbers.begin());
    return ControllerAccess::of(*controller_).link.sendWrench(numbers);
}

Result<void> ToolSetup::setWatchdog(double minFrequency, const Deadline& deadline) {
    constexpr double kControlRate = 500.0;
    constexpr double kSlowest = 0.01;
    const ArgumentCheck check =
        ArgumentCheck("set the watchdog").range("minFrequency", minFrequency, kSlowest, kControlRate, "Hz");
    if (!check.ok()) {
        return check.error();
    }
    if (auto kicked = kickWatchdog(); !kicked) {
        return kicked;
    }
    return noAnswer(ControllerAccess::of(*controller_)
                        .requests.request(RequestKind::SetWatchdog, 0, {&minFrequency, 1},
                                          QStringLiteral("set the watchdog"), deadline));
}

Result<void> ToolSetup::kickWatchdog() {
    return ControllerAccess::of(*controller_).link.kickWatchdog();
}

Result<void> ToolSetup::triggerProtectiveStop(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("trigger a protective stop");
    if (const auto known = d.program.needs(kESeries, {3, 8, 0, 0}, context); !known) {
        return known;
    }
    if (!d.loop.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    // The protective stop pauses the program, so the answer may not arrive. The safety mode is decisive.
    const Deadline answerTime =
        Deadline::after(std::min(std::chrono::milliseconds(100), deadline.remaining()), deadline.token());
    const auto asked = d.requests.request(RequestKind::ProtectiveStop, 0, {}, context, answerTime);
    if (!asked && asked.error().code == ErrorCode::Cancelled) {
        return asked.error();
    }
    // If control was lost before the request, no protective stop occurs.
    const Deadline soon = Deadline::after(std::chrono::seconds(2), deadline.token());
    Error failed;
    const auto settled = [&] {
        if (d.loop.status().safetyMode == SafetyMode::ProtectiveStop) {
            return true;
        }
        if (!asked && asked.error().code == ErrorCode::NotInControl && soon.hasExpired()) {
            failed = asked.error();
        } else if (!d.link.isRunning()) {
            failed = {asked ? ErrorCode::LinkLost : asked.error().code, context, {}};
        }
        return failed.code != ErrorCode::None;
    };
    if (!waitUntil(deadline, settled)) {
        failed = {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                  safetyModeName(d.loop.status().safetyMode)};
    }
    return failed.code == ErrorCode::None ? Result<void>() : failed;
}

}  // namespace tiller::control
