// SPDX-License-Identifier: MIT
#include "robot/control/detail/registers.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "robot/rtde/fields.h"

namespace tiller::control {

namespace {

constexpr int kIntInputs = 9;
constexpr int kSliderRegister = 10;
// The last six of the 24 registers stay free for other clients: users set registers 18 to 22 manually.
constexpr int kDoubleInputs = 18;
static_assert(kIntInputs + 1 + kDoubleInputs == kCommandSize);
constexpr int kWatchdogRegister = 9;
constexpr int kIntOutputs = 8;
constexpr int kDoubleOutputs = 6;

std::array<double, 6> six(std::span<const double> values, std::size_t first) {
    std::array<double, 6> out{};
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
    return out;
}

}  // namespace

int firstRegister(RegisterRange range) {
    return range == RegisterRange::Upper ? rtde::kFirstUpperRegister : 0;
}

std::vector<std::string> outputNames(RegisterRange range, const std::vector<std::string>& extra) {
    std::vector<std::string> names{"timestamp",         "runtime_state",         "robot_mode",
                                   "safety_mode",       "target_speed_fraction", "actual_q",
                                   "actual_qd",         "actual_TCP_pose",       "actual_TCP_speed",
                                   "tcp_offset",        "speed_scaling",         "actual_TCP_force",
                                   "robot_status_bits", "safety_status_bits"};
    for (int i = 0; i < kIntOutputs; ++i) {
        names.push_back(rtde::intRegisterName(rtde::Direction::Output, firstRegister(range) + i));
    }
    for (int i = 0; i < kDoubleOutputs; ++i) {
        names.push_back(rtde::doubleRegisterName(rtde::Direction::Output, firstRegister(range) + i));
    }
    for (const std::string& name : extra) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

std::string watchdogName(RegisterRange range) {
    return rtde::intRegisterName(rtde::Direction::Input, firstRegister(range) + kWatchdogRegister);
}

std::vector<std::string> inputNames(RegisterRange range, Inputs recipe) {
    if (recipe == kWatchdogInputs) {
        return {watchdogName(range)};
    }
    if (recipe == kWrenchInputs) {
        return {"external_force_torque"};
    }
    std::vector<std::string> names;
    for (int i = 0; i < kIntInputs; ++i) {
        names.push_back(rtde::intRegisterName(rtde::Direction::Input, firstRegister(range) + i));
    }
    names.push_back(rtde::intRegisterName(rtde::Direction::Input, firstRegister(range) + kSliderRegister));
    for (int i = 0; i < kDoubleInputs; ++i) {
        names.push_back(rtde::doubleRegisterName(rtde::Direction::Input, firstRegister(range) + i));
    }
    return names;
}

Result<FeedbackLayout> FeedbackLayout::of(const rtde::Recipe& outputs, RegisterRange range) {
    FeedbackLayout layout;
    QStringList missing;
    const auto find = [&](const std::string& name) {
        const auto index = outputs.indexOf(name);
        if (!index) {
            missing.append(QString::fromStdString(name));
        }
        return index.value_or(0);
    };
    layout.timestamp_ = find("timestamp");
    layout.runtimeState_ = find("runtime_state");
    layout.robotMode_ = find("robot_mode");
    layout.safetyMode_ = find("safety_mode");
    layout.speedFraction_ = find("target_speed_fraction");
    layout.q_ = find("actual_q");
    layout.qd_ = find("actual_qd");
    layout.tcpPose_ = find("actual_TCP_pose");
    layout.tcpSpeed_ = find("actual_TCP_speed");
    layout.tcpOffset_ = outputs.indexOf("tcp_offset");  // not available in older software
    layout.speedScaling_ = outputs.indexOf("speed_scaling");
    layout.tcpForce_ = outputs.indexOf("actual_TCP_force");
    layout.robotStatus_ = outputs.indexOf("robot_status_bits");
    layout.safetyStatus_ = outputs.indexOf("safety_status_bits");
    for (int i = 0; i < kDoubleOutputs; ++i) {
        layout.numbers_[static_cast<std::size_t>(i)] =
            find(rtde::doubleRegisterName(rtde::Direction::Output, firstRegister(range) + i));
    }
    for (int i = 0; i < kIntOutputs; ++i) {
        layout.echo_[static_cast<std::size_t>(i)] =
            find(rtde::intRegisterName(rtde::Direction::Output, firstRegister(range) + i));
    }
    if (!missing.isEmpty()) {
        return Error{ErrorCode::FieldUnknown, QStringLiteral("set up the data for control"),
                     missing.join(QStringLiteral(", "))};
    }
    return layout;
}

Feedback FeedbackLayout::decode(std::span<const double> values, std::int64_t hostNs) const {
    Feedback f;
    f.hostNs = hostNs;
    f.timestamp = values[timestamp_];
    f.runtimeState = static_cast<RuntimeState>(values[runtimeState_]);
    f.robotMode = static_cast<RobotMode>(values[robotMode_]);
    f.safetyMode = static_cast<SafetyMode>(values[safetyMode_]);
    f.speedFraction = values[speedFraction_];
    f.q = JointPositions(six(values, q_));
    f.qd = JointVelocities(six(values, qd_));
    f.tcpPose = Pose::fromArray(six(values, tcpPose_));
    const auto speed = six(values, tcpSpeed_);
    f.tcpSpeed = Twist::fromVector(Eigen::Map<const Vector6>(speed.data()));
    if (tcpOffset_) {
        f.tcpOffset = Pose::fromArray(six(values, *tcpOffset_));
    }
    if (speedScaling_) {
        f.speedScaling = values[*speedScaling_];
    }
    if (tcpForce_) {
        const auto force = six(values, *tcpForce_);
        f.tcpForce = Eigen::Vector3d(force[0], force[1], force[2]);
    }
    if (robotStatus_) {
        f.robotStatusBits = static_cast<std::uint32_t>(values[*robotStatus_]);
    }
    if (safetyStatus_) {
        f.safetyStatusBits = static_cast<std::uint32_t>(values[*safetyStatus_]);
    }
    const auto whole = [&](std::size_t i) { return static_cast<std::int32_t>(values[echo_[i]]); };
    f.echo.sequence = whole(0);
    f.echo.epoch = whole(1);
    f.echo.state = whole(2) < 0 ? ScriptState::Expired : static_cast<ScriptState>(whole(2));
    f.echo.session = whole(3);
    f.echo.answer.number = whole(4);
    f.echo.answer.outcome = static_cast<Outcome>(whole(5));
    f.echo.answer.whole = whole(6);
    f.echo.waypoint = whole(7);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        f.echo.answer.numbers[i] = values[numbers_[i]];
    }
    return f;
}

std::array<double, kCommandSize> encode(const Command& command) {
    std::array<double, kCommandSize> out{};
    auto* at = out.data();
    *at++ = command.sequence;
    *at++ = command.epoch;
    *at++ = static_cast<double>(command.kind);
    *at++ = command.choice;
    *at++ = command.session;
    *at++ = command.request.number;
    *at++ = static_cast<double>(command.request.kind);
    *at++ = command.request.whole;
    *at++ = (command.forcePermitted ? 1 : 0) + (command.mayFinish ? 2 : 0) + 4 * command.heartbeatTimeoutMs;
    *at++ = std::round(command.speedFraction * 1000);
    at = std::copy(command.values.begin(), command.values.end(), at);
    *at++ = command.speed;
    *at++ = command.acceleration;
    *at++ = command.rotationAcceleration;
    at = std::copy(command.rotation.begin(), command.rotation.end(), at);
    std::copy(command.request.numbers.begin(), command.request.numbers.end(), at);
    return out;
}

}  // namespace tiller::control
