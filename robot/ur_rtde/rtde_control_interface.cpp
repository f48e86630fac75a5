// SPDX-License-Identifier: MIT
// The life of the interface, programs, settings and questions; motions are in control_motions.cpp.
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/control_private.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

using tiller::urrtde::CommandId;
using tiller::urrtde::SessionOptions;
namespace check = tiller::urrtde::check;
using List = std::vector<double>;

namespace {

constexpr double kMaxMass = 100.0;    // [kg], above every arm's payload
constexpr double kMaxLength = 2.0;    // [m], centres of gravity and the like
constexpr double kMaxGravity = 20.0;  // [m/s2]

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

}  // namespace

RTDEControlInterface::RTDEControlInterface(std::string hostname, double frequency, uint16_t flags,
                                           int ur_cap_port, int rt_priority)
    : d_(std::make_unique<Private>(checked({std::move(hostname), frequency, flags, ur_cap_port, rt_priority}),
                                   frequency > 0 ? 1 / frequency : 0)) {}

RTDEControlInterface::~RTDEControlInterface() = default;

void RTDEControlInterface::disconnect() {
    d_->session.disconnect();
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
                                                    const std::string& script) {
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
    return d_->session.backend()->runCustom(text + "end\n");
}

bool RTDEControlInterface::sendCustomScript(const std::string& script) {
    if (script.empty()) {
        throw std::invalid_argument("script is empty");
    }
    return d_->session.backend()->runCustom(script);
}

bool RTDEControlInterface::sendCustomScriptFile(const std::string& file_path) {
    std::ifstream file(file_path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file || text.str().empty()) {
        throw std::invalid_argument("file_path: cannot read " + file_path);
    }
    return d_->session.backend()->runCustom(text.str());
}

void RTDEControlInterface::setCustomScriptFile(const std::string& file_path) {
    if (!file_path.empty() && !std::ifstream(file_path)) {
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
        check::listWithin("cog", cog, 3, kMaxLength, "m", "; is this one in millimetres?");
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
    check::listWithin("sensor_measuring_offset", offset, 3, kMaxLength, "m", "; is this one in millimetres?");
    check::listWithin("sensor_cog", cog, 3, kMaxLength, "m", "; is this one in millimetres?");
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

// ---- questions ------------------------------------------------------------------------------------------

namespace {

[[noreturn]] void throwUnanswered(const char* what) {
    throw std::runtime_error(
        std::string(what) +
        ": the robot did not answer. Does the control program run, and is there no stop?");
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
        return {};  // software that keeps no history has none of contacts either
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
    // Without a TCP the active one counts, which has to be asked for: the command takes what is in the
    // registers.
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

}  // namespace ur_rtde
