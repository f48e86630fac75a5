// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/control_private.h"

namespace ur_rtde {

using tiller::urrtde::CommandId;
namespace check = tiller::urrtde::check;
using List = std::vector<double>;

namespace {

constexpr double kUnused = 1000;
constexpr double kMaxForce = 1000;  // [N], [Nm]; above what any arm withstands

List joined(List first, const List& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

double flag(bool value) {
    return value ? 1.0 : 0.0;
}

List reals(const std::vector<int>& values) {
    return {values.begin(), values.end()};
}

List servoValues(List target, double speed, double acceleration, double time, double lookahead, double gain) {
    // Not used by any software of today: whatever they are, nothing depends on them.
    check::number("speed", speed, 0, kUnused);
    check::number("acceleration", acceleration, 0, kUnused);
    check::number("time", time, 0, 10, "s");
    check::number("lookahead_time", lookahead, UR_SERVO_LOOKAHEAD_TIME_MIN, UR_SERVO_LOOKAHEAD_TIME_MAX, "s");
    check::number("gain", gain, UR_SERVO_GAIN_MIN, UR_SERVO_GAIN_MAX);
    return joined(std::move(target), {speed, acceleration, time, lookahead, gain});
}

}  // namespace

// ---- moves ----------------------------------------------------------------------------------------------

void RTDEControlInterface::stopL(double a, bool asynchronous) {
    check::number("a", a, 0.01, UR_TOOL_ACCELERATION_MAX, "m/s2");
    d_->session.backend()->stop({CommandId::StopL, 20, {a, flag(asynchronous)}}, !asynchronous);
}

void RTDEControlInterface::stopJ(double a, bool asynchronous) {
    check::number("a", a, 0.01, UR_JOINT_ACCELERATION_MAX, "rad/s2");
    d_->session.backend()->stop({CommandId::StopJ, 20, {a, flag(asynchronous)}}, !asynchronous);
}

bool RTDEControlInterface::moveJ(const List& q, double speed, double acceleration, bool asynchronous) {
    check::joints("q", q, d_->limits());
    check::jointMove(speed, acceleration, d_->limits());
    return d_->move(CommandId::MoveJ, joined(q, {speed, acceleration, flag(asynchronous)}));
}

bool RTDEControlInterface::moveJ_IK(const List& pose, double speed, double acceleration, bool asynchronous) {
    check::pose("pose", pose);
    check::jointMove(speed, acceleration, d_->limits());
    return d_->move(CommandId::MoveJIk, joined(pose, {speed, acceleration, flag(asynchronous)}));
}

bool RTDEControlInterface::moveL(const List& pose, double speed, double acceleration, bool asynchronous) {
    check::pose("pose", pose);
    check::toolMove(speed, acceleration);
    return d_->move(CommandId::MoveL, joined(pose, {speed, acceleration, flag(asynchronous)}));
}

bool RTDEControlInterface::moveL_FK(const List& q, double speed, double acceleration, bool asynchronous) {
    check::joints("q", q, d_->limits());
    check::toolMove(speed, acceleration);
    return d_->move(CommandId::MoveLFk, joined(q, {speed, acceleration, flag(asynchronous)}));
}

bool RTDEControlInterface::moveJ(const std::vector<List>& path, bool asynchronous) {
    Path entries;
    entries.appendMovejPath(path);
    return movePath(entries, asynchronous);
}

bool RTDEControlInterface::moveL(const std::vector<List>& path, bool asynchronous) {
    Path entries;
    entries.appendMovelPath(path);
    return movePath(entries, asynchronous);
}

bool RTDEControlInterface::movePath(const Path& path, bool asynchronous) {
    if (path.size() == 0) {
        throw std::invalid_argument("path is empty");
    }
    return d_->session.backend()->follow(path, asynchronous);
}

bool RTDEControlInterface::moveUntilContact(const List& xd, const List& direction, double acceleration) {
    check::twist("xd", xd);
    check::list("direction", direction, 6);
    check::number("acceleration", acceleration, 0.01, UR_TOOL_ACCELERATION_MAX, "m/s2");
    return d_->feelsContact() &&
           d_->done(CommandId::MoveUntilContact, 16, joined(joined(xd, direction), {acceleration}));
}

AsyncOperationStatus RTDEControlInterface::getAsyncOperationProgressEx() {
    return AsyncOperationStatus(d_->session.backend()->progress());
}

int RTDEControlInterface::getAsyncOperationProgress() {
    const AsyncOperationStatus status = getAsyncOperationProgressEx();
    return status.isAsyncOperationRunning() ? status.progress() : status.operationId() % 2 - 2;
}

// ---- streams --------------------------------------------------------------------------------------------

bool RTDEControlInterface::speedJ(const List& qd, double acceleration, double time) {
    check::jointSpeeds("qd", qd, d_->limits());
    check::number("acceleration", acceleration, 0.001, UR_JOINT_ACCELERATION_MAX, "rad/s2");
    check::number("time", time, 0, 3600, "s");
    return d_->session.backend()->stream({CommandId::SpeedJ, 13, joined(qd, {acceleration, time})});
}

bool RTDEControlInterface::speedL(const List& xd, double acceleration, double time) {
    check::twist("xd", xd);
    check::number("acceleration", acceleration, 0.001, UR_TOOL_ACCELERATION_MAX, "m/s2");
    check::number("time", time, 0, 3600, "s");
    return d_->session.backend()->stream({CommandId::SpeedL, 13, joined(xd, {acceleration, time})});
}

bool RTDEControlInterface::speedStop(double a) {
    check::number("a", a, 0.01, UR_TOOL_ACCELERATION_MAX, "m/s2");
    return d_->session.backend()->stop({CommandId::SpeedStop, 8, {a}});
}

bool RTDEControlInterface::servoJ(const List& q, double speed, double acceleration, double time,
                                  double lookahead_time, double gain) {
    check::joints("q", q, d_->limits());
    return d_->session.backend()->stream(
        {CommandId::ServoJ, 2, servoValues(q, speed, acceleration, time, lookahead_time, gain)});
}

bool RTDEControlInterface::servoL(const List& pose, double speed, double acceleration, double time,
                                  double lookahead_time, double gain) {
    check::pose("pose", pose);
    return d_->session.backend()->stream(
        {CommandId::ServoL, 2, servoValues(pose, speed, acceleration, time, lookahead_time, gain)});
}

bool RTDEControlInterface::servoC(const List& pose, double speed, double acceleration, double blend) {
    check::pose("pose", pose);
    check::toolMove(speed, acceleration);
    check::number("blend", blend, UR_BLEND_MIN, UR_BLEND_MAX, "m");
    return d_->session.backend()->stream({CommandId::ServoC, 5, joined(pose, {speed, acceleration, blend})});
}

bool RTDEControlInterface::servoStop(double a) {
    check::number("a", a, 0.01, UR_TOOL_ACCELERATION_MAX, "m/s2");
    return d_->session.backend()->stop({CommandId::ServoStop, 8, {a}});
}

bool RTDEControlInterface::jogStart(const List& speeds, int feature, double acc, const List& custom_frame) {
    check::twist("speeds", speeds);
    check::integer("feature", feature, FEATURE_BASE, FEATURE_CUSTOM);
    check::number("acc", acc, 0.001, UR_TOOL_ACCELERATION_MAX, "m/s2");
    if (!custom_frame.empty()) {
        check::pose("custom_frame", custom_frame);
    } else if (feature == FEATURE_CUSTOM) {
        throw std::invalid_argument("custom_frame is needed with FEATURE_CUSTOM");
    }
    return d_->done(CommandId::JogStart, 14,
                    joined(joined(speeds, {static_cast<double>(feature), acc}),
                           custom_frame.empty() ? List(6, 0.0) : custom_frame));
}

bool RTDEControlInterface::jogStop() {
    return d_->session.backend()->stop({CommandId::JogStop, 4, {}});
}

// ---- force and hands ------------------------------------------------------------------------------------

bool RTDEControlInterface::forceMode(const List& task_frame, const std::vector<int>& selection_vector,
                                     const List& wrench, int type, const List& limits) {
    check::pose("task_frame", task_frame);
    check::flags("selection_vector", selection_vector, 6);
    check::listWithin("wrench", wrench, 6, kMaxForce, "N, Nm");
    check::integer("type", type, 1, 3);
    check::twist("limits", limits);
    List values{static_cast<double>(type)};
    values = joined(joined(values, reals(selection_vector)), task_frame);
    return d_->session.backend()->stream({CommandId::ForceMode, 3, joined(joined(values, wrench), limits)});
}

bool RTDEControlInterface::forceModeStop() {
    return d_->session.backend()->stop({CommandId::ForceModeStop, 4, {}});
}

bool RTDEControlInterface::freedriveMode(const std::vector<int>& free_axes, const List& feature) {
    check::flags("free_axes", free_axes, 6);
    check::pose("feature", feature);
    return d_->done(CommandId::FreedriveMode, 17, joined(reals(free_axes), feature));
}

bool RTDEControlInterface::endFreedriveMode() {
    return d_->done(CommandId::EndFreedriveMode, 4);
}

int RTDEControlInterface::getFreedriveStatus() {
    const auto answer = d_->session.backend()->perform({CommandId::FreedriveStatus, 4, {}});
    if (!answer) {
        throw std::runtime_error("getFreedriveStatus: the robot did not answer");
    }
    return answer->result;
}

bool RTDEControlInterface::teachMode() {
    return d_->done(CommandId::TeachMode, 4);
}

bool RTDEControlInterface::endTeachMode() {
    return d_->done(CommandId::EndTeachMode, 4);
}

int RTDEControlInterface::toolContact(const List& direction) {
    check::list("direction", direction, 6);
    return d_->integer(CommandId::ToolContact, 6, direction);
}

bool RTDEControlInterface::startContactDetection(const List& direction) {
    check::list("direction", direction, 6);
    return d_->feelsContact() && d_->done(CommandId::StartContactDetection, 6, direction);
}

bool RTDEControlInterface::readContactDetection() {
    return d_->done(CommandId::ReadContactDetection, 4);
}

bool RTDEControlInterface::stopContactDetection() {
    return d_->done(CommandId::StopContactDetection, 4);
}

}  // namespace ur_rtde
