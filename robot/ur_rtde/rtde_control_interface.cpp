// SPDX-License-Identifier: MIT
#include <sstream>
#include <stdexcept>

#include "robot/core/file_reading.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/control_session.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

using tiller::urrtde::CommandId;
using tiller::urrtde::SessionOptions;
namespace check = tiller::urrtde::check;
using List = std::vector<double>;

namespace {

constexpr double kMaxMass = 100.0;    // [kg], exceeds the payload of all arms
constexpr double kMaxLength = 2.0;    // [m], for centres of gravity and similar lengths
constexpr double kMaxGravity = 20.0;  // [m/s2]

tiller::control::Supervision supervisionOf(bool unattended) {
    return unattended ? tiller::control::Supervision::Unattended : tiller::control::Supervision::Heartbeat;
}

SessionOptions checked(const SessionOptions& options) {
    if (options.host.empty()) {
        throw std::invalid_argument("hostname is empty");
    }
    check::frequency(options.frequency);
    check::port("ur_cap_port", options.capPort);
    check::priority(options.priority);
    return options;
}

List joined(List first, const List& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

constexpr double kUnused = 1000;
constexpr double kMaxForce = 1000;  // [N], [Nm]; exceeds the limits of all arms

double flag(bool value) {
    return value ? 1.0 : 0.0;
}

List reals(const std::vector<int>& values) {
    return {values.begin(), values.end()};
}

List servoValues(List target, double speed, double acceleration, double time, double lookahead, double gain) {
    // Current software ignores `speed` and `acceleration`, so a wide range is accepted.
    check::number("speed", speed, 0, kUnused);
    check::number("acceleration", acceleration, 0, kUnused);
    check::number("time", time, 0, 10, "s");
    check::number("lookahead_time", lookahead, UR_SERVO_LOOKAHEAD_TIME_MIN, UR_SERVO_LOOKAHEAD_TIME_MAX, "s");
    check::number("gain", gain, UR_SERVO_GAIN_MIN, UR_SERVO_GAIN_MAX);
    return joined(std::move(target), {speed, acceleration, time, lookahead, gain});
}

}  // namespace

struct RTDEControlInterface::Private {
    explicit Private(const SessionOptions& options, double p) : session(options), givenPeriod(p) {}

    tiller::urrtde::ControlSession session;
    double givenPeriod;  ///< [s]; 0: default of the controller

    tiller::control::JointLimits limits() const { return session.backend()->jointLimits(); }

    /// True from 5.4 on. In older software, the program has no contact detection.
    bool feelsContact() const {
        const auto& version = session.identity().versions;
        return version.major > 5 || (version.major == 5 && version.minor >= 4);
    }
    bool done(CommandId id, int recipe, const List& values = {}) {
        const auto answer = session.backend()->perform({id, recipe, values});
        return answer && (answer->result != 0 || !answersResult(id));
    }
    bool move(CommandId id, const List& values) {
        const auto answer = session.backend()->perform({id, 1, values});
        return answer && (answer->result != 0 || session.isForeign());
    }
    /// The six result values; empty if there is no reply or no result.
    List six(CommandId id, int recipe, const List& values = {}, bool mayFail = false) {
        const auto answer = session.backend()->perform({id, recipe, values});
        if (!answer || (mayFail && answer->result == 0)) {
            return {};
        }
        return {answer->values.begin(), answer->values.end()};
    }
    int integer(CommandId id, int recipe, const List& values = {}) {
        const auto answer = session.backend()->perform({id, recipe, values});
        return answer ? answer->result : 0;
    }

private:
    /// False for commands without a result, for which custom programs do not change the result register.
    static bool answersResult(CommandId id) {
        switch (id) {
            case CommandId::PoseWithinLimits:
            case CommandId::JointsWithinLimits:
            case CommandId::IsSteady:
            case CommandId::HasSolution:
            case CommandId::HasSolutionNear:
            case CommandId::ReadContactDetection:
            case CommandId::StopContactDetection:
                return true;
            default:
                return false;
        }
    }
};

RTDEControlInterface::RTDEControlInterface(std::string hostname, double frequency, uint16_t flags,
                                           int ur_cap_port, int rt_priority)
    : d_(std::make_unique<Private>(checked({std::move(hostname), frequency, flags, ur_cap_port, rt_priority}),
                                   frequency > 0 ? 1 / frequency : 0)) {}

RTDEControlInterface::~RTDEControlInterface() = default;

void RTDEControlInterface::disconnect(bool unattended) {
    d_->session.disconnect(supervisionOf(unattended));
}

bool RTDEControlInterface::reconnect() {
    try {
        d_->session.reconnect();
    } catch (const tiller::urrtde::Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        d_->session.keepError(error.what());
        return false;
    }
    return isConnected();
}

std::string RTDEControlInterface::lastError() const {
    return d_->session.lastError();
}

bool RTDEControlInterface::isConnected() {
    return d_->session.isConnected();
}

const Versions& RTDEControlInterface::versions() const {
    return d_->session.identity().versions;
}

const std::string& RTDEControlInterface::serial_number() const {
    return d_->session.identity().serialNumber;
}

void RTDEControlInterface::unlockProtectiveStop() {
    d_->session.unlockProtectiveStop();
}

void RTDEControlInterface::waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start) {
    RTDEUtility::waitPeriod(t_cycle_start, d_->givenPeriod > 0
                                               ? d_->givenPeriod
                                               : d_->session.backend()->version().controlPeriod());
}

std::chrono::steady_clock::time_point RTDEControlInterface::initPeriod() {
    return std::chrono::steady_clock::now();
}

// ---- programs -------------------------------------------------------------------------------------------

bool RTDEControlInterface::reuploadScript() {
    return d_->session.reupload();
}

bool RTDEControlInterface::sendCustomScriptFunction(const std::string& function_name,
                                                    const std::string& script, bool unattended) {
    if (function_name.empty()) {
        throw std::invalid_argument("function_name is empty");
    }
    if (script.empty()) {
        throw std::invalid_argument("script is empty");
    }
    std::istringstream lines(script);
    std::string text = "def " + function_name + "():\n";
    for (std::string line; std::getline(lines, line);) {
        text += "\t" + line + "\n";
    }
    return d_->session.backend()->runCustom(text + "end\n", supervisionOf(unattended));
}

bool RTDEControlInterface::sendCustomScript(const std::string& script, bool unattended) {
    if (script.empty()) {
        throw std::invalid_argument("script is empty");
    }
    return d_->session.backend()->runCustom(script, supervisionOf(unattended));
}

bool RTDEControlInterface::sendCustomScriptFile(const std::string& file_path, bool unattended) {
    const auto text = tiller::readWholeFile(QString::fromStdString(file_path), tiller::kMaxScriptBytes);
    if (!text || text->isEmpty()) {
        throw std::invalid_argument("file_path: cannot read " + file_path);
    }
    return d_->session.backend()->runCustom(text->toStdString(), supervisionOf(unattended));
}

void RTDEControlInterface::setCustomScriptFile(const std::string& file_path) {
    if (!file_path.empty() &&
        !tiller::readWholeFile(QString::fromStdString(file_path), tiller::kMaxScriptBytes)) {
        throw std::invalid_argument("file_path: cannot read " + file_path);
    }
    d_->session.useScriptFile(file_path);
}

void RTDEControlInterface::stopScript() {
    d_->session.backend()->stopProgram();
}

bool RTDEControlInterface::isProgramRunning() {
    return isConnected() && (getRobotStatus() & (1U << ROBOT_STATUS_PROGRAM_RUNNING)) != 0;
}

uint32_t RTDEControlInterface::getRobotStatus() {
    return d_->session.backend()->robotStatus();
}

// ---- settings -------------------------------------------------------------------------------------------

bool RTDEControlInterface::setPayload(double mass, const List& cog) {
    check::number("mass", mass, 0, kMaxMass, "kg");
    if (!cog.empty()) {
        check::listWithin("cog", cog, 3, kMaxLength, "m", ". Was the value given in millimetres?");
    }
    return d_->done(CommandId::SetPayload, 7, joined({mass}, cog.empty() ? List(3, 0.0) : cog));
}

bool RTDEControlInterface::setTcp(const List& tcp_offset) {
    check::pose("tcp_offset", tcp_offset);
    return d_->done(CommandId::SetTcp, 6, tcp_offset);
}

bool RTDEControlInterface::setGravity(const List& direction) {
    check::listWithin("direction", direction, 3, kMaxGravity, "m/s2");
    return d_->done(CommandId::SetGravity, 7, joined(direction, {0.0}));
}

bool RTDEControlInterface::setWatchdog(double min_frequency) {
    check::number("min_frequency", min_frequency, 0.01, 500, "Hz");
    return d_->done(CommandId::SetWatchdog, 8, {min_frequency});
}

bool RTDEControlInterface::kickWatchdog() {
    return d_->session.backend()->kickWatchdog();
}

bool RTDEControlInterface::triggerProtectiveStop() {
    return d_->session.backend()->protectiveStop();
}

// ---- force and sensor -----------------------------------------------------------------------------------

bool RTDEControlInterface::zeroFtSensor() {
    return d_->done(CommandId::ZeroFtSensor, 4);
}

bool RTDEControlInterface::forceModeSetDamping(double damping) {
    check::number("damping", damping, 0, 1);
    return d_->done(CommandId::ForceModeDamping, 8, {damping});
}

bool RTDEControlInterface::forceModeSetGainScaling(double scaling) {
    check::number("scaling", scaling, 0, 2);
    return d_->done(CommandId::ForceModeGainScaling, 8, {scaling});
}

bool RTDEControlInterface::setExternalForceTorque(const List& external_force_torque) {
    check::list("external_force_torque", external_force_torque, 6);
    return d_->session.backend()->stream({CommandId::ExternalForceTorque, 18, external_force_torque});
}

namespace {
List sensor(bool enable, double mass, const List& offset, const List& cog) {
    check::number("sensor_mass", mass, 0, kMaxMass, "kg");
    check::listWithin("sensor_measuring_offset", offset, 3, kMaxLength, "m",
                      ". Was the value given in millimetres?");
    check::listWithin("sensor_cog", cog, 3, kMaxLength, "m", ". Was the value given in millimetres?");
    return joined(joined({enable ? 1.0 : 0.0, mass}, offset), cog);
}
}  // namespace

bool RTDEControlInterface::ftRtdeInputEnable(bool enable, double sensor_mass,
                                             const List& sensor_measuring_offset, const List& sensor_cog) {
    return d_->done(CommandId::FtRtdeInput, 19,
                    sensor(enable, sensor_mass, sensor_measuring_offset, sensor_cog));
}

bool RTDEControlInterface::enableExternalFtSensor(bool enable, double sensor_mass,
                                                  const List& sensor_measuring_offset,
                                                  const List& sensor_cog) {
    return d_->done(CommandId::ExternalFtSensor, 19,
                    sensor(enable, sensor_mass, sensor_measuring_offset, sensor_cog));
}

// ---- queries --------------------------------------------------------------------------------------------

namespace {

[[noreturn]] void throwUnanswered(const char* what) {
    throw std::runtime_error(std::string(what) +
                             ": the robot did not respond. Check that the control program is running and the "
                             "robot is not stopped.");
}

List answered(const char* what, const List& answer) {
    if (answer.empty()) {
        throwUnanswered(what);
    }
    return answer;
}

}  // namespace

double RTDEControlInterface::getStepTime() {
    const List answer = d_->six(CommandId::StepTime, 4);
    return answer.empty() ? 0.0 : answer.front();
}

List RTDEControlInterface::getActualJointPositionsHistory(int steps) {
    check::integer("steps", steps, 0, 100000);
    if (steps > 0 && !d_->feelsContact()) {
        return {};  // software without position history has no contact history either
    }
    return d_->six(CommandId::JointPositionsHistory, 9, {static_cast<double>(steps)});
}

List RTDEControlInterface::getTargetWaypoint() {
    return d_->six(CommandId::TargetWaypoint, 4);
}

namespace {
List kinematicsQuestion(const List& x, const List& near, double positionError, double orientationError,
                        const tiller::control::JointLimits& arm) {
    check::pose("x", x);
    check::number("max_position_error", positionError, 0, 1, "m");
    check::number("max_orientation_error", orientationError, 0, 1, "rad");
    if (near.empty()) {
        return x;
    }
    check::joints("qnear", near, arm);
    return joined(joined(x, near), {positionError, orientationError});
}
}  // namespace

List RTDEControlInterface::getInverseKinematics(const List& x, const List& qnear, double max_position_error,
                                                double max_orientation_error) {
    const List values = kinematicsQuestion(x, qnear, max_position_error, max_orientation_error, d_->limits());
    return qnear.empty() ? d_->six(CommandId::InverseKinematics, 6, values, true)
                         : d_->six(CommandId::InverseKinematicsNear, 10, values, true);
}

bool RTDEControlInterface::getInverseKinematicsHasSolution(const List& x, const List& qnear,
                                                           double max_position_error,
                                                           double max_orientation_error) {
    const List values = kinematicsQuestion(x, qnear, max_position_error, max_orientation_error, d_->limits());
    const auto answer = qnear.empty()
                            ? d_->session.backend()->perform({CommandId::HasSolution, 6, values})
                            : d_->session.backend()->perform({CommandId::HasSolutionNear, 10, values});
    if (!answer) {
        throwUnanswered("getInverseKinematicsHasSolution");
    }
    return answer->result != 0;
}

List RTDEControlInterface::getForwardKinematics(const List& q, const List& tcp_offset) {
    if (q.empty() && tcp_offset.empty()) {
        return answered("getForwardKinematics", d_->six(CommandId::ForwardKinematics, 4));
    }
    const List joints = q.empty() ? answered("getForwardKinematics", getActualJointPositionsHistory()) : q;
    check::joints("q", joints, d_->limits());
    if (!tcp_offset.empty()) {
        check::pose("tcp_offset", tcp_offset);
    }
    // Without a TCP argument, the active TCP applies. The active TCP must be queried, because the command
    // always uses the register values.
    const List tcp = tcp_offset.empty() ? getTCPOffset() : tcp_offset;
    return answered("getForwardKinematics", d_->six(CommandId::ForwardKinematicsOf, 12, joined(joints, tcp)));
}

List RTDEControlInterface::poseTrans(const List& p_from, const List& p_from_to) {
    check::pose("p_from", p_from);
    check::pose("p_from_to", p_from_to);
    return answered("poseTrans", d_->six(CommandId::PoseTrans, 12, joined(p_from, p_from_to)));
}

bool RTDEControlInterface::isPoseWithinSafetyLimits(const List& pose) {
    check::pose("pose", pose);
    return d_->done(CommandId::PoseWithinLimits, 6, pose);
}

bool RTDEControlInterface::isJointsWithinSafetyLimits(const List& q) {
    check::list("q", q, 6);
    return d_->done(CommandId::JointsWithinLimits, 6, q);
}

List RTDEControlInterface::getJointTorques() {
    return answered("getJointTorques", d_->six(CommandId::JointTorques, 4));
}

List RTDEControlInterface::getTCPOffset() {
    return answered("getTCPOffset", d_->six(CommandId::TcpOffset, 4));
}

List RTDEControlInterface::getActualToolFlangePose() {
    return answered("getActualToolFlangePose", d_->six(CommandId::ToolFlangePose, 4));
}

bool RTDEControlInterface::isSteady() {
    return d_->done(CommandId::IsSteady, 4);
}

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

// ---- streams of setpoints ------------------------------------------------------------------------------

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
        throw std::invalid_argument("custom_frame is required with FEATURE_CUSTOM");
    }
    return d_->done(CommandId::JogStart, 14,
                    joined(joined(speeds, {static_cast<double>(feature), acc}),
                           custom_frame.empty() ? List(6, 0.0) : custom_frame));
}

bool RTDEControlInterface::jogStop() {
    return d_->session.backend()->stop({CommandId::JogStop, 4, {}});
}

// ---- force mode and freedrive ---------------------------------------------------------------------------

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
        throw std::runtime_error("getFreedriveStatus: the robot did not respond");
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
