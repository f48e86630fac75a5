// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/rtde_receive_interface.h"

#include <algorithm>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string_view>

#include "robot/core/modes.h"
#include "robot/core/wait_until.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/rtde/fields.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/receive_fields.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

namespace check = tiller::urrtde::check;
using List = std::vector<double>;
using std::chrono::milliseconds;
using tiller::receive::ReceiverOptions;
using tiller::receive::ReceiverState;
using tiller::receive::Sample;
using tiller::rtde::Direction;

namespace {

constexpr milliseconds kReceiveConnectTime(3000);
constexpr milliseconds kSilenceLimit(2500);
constexpr double kRampUpTime = 0.2;  // [s] from standstill to full speed after a pause

ReceiverOptions optionsOf(const std::string& host, double frequency, std::vector<std::string> variables,
                          bool upper, int priority) {
    if (host.empty()) {
        throw std::invalid_argument("hostname is empty");
    }
    check::frequency(frequency);
    check::priority(priority);
    for (const std::string& name : variables) {
        if (tiller::rtde::findOutput(name) == nullptr) {
            throw std::invalid_argument("variables: there is no RTDE output \"" + name + "\"");
        }
    }
    ReceiverOptions options;
    options.host = QString::fromStdString(host);
    options.frequency = frequency > 0 ? frequency : 0;
    options.fields = variables.empty() ? tiller::urrtde::receiveFields(upper) : std::move(variables);
    options.priority = std::max(priority, 0);
    return options;
}

constexpr int kDigitalPins = 18;

}  // namespace

struct RTDEReceiveInterface::Private {
    explicit Private(ReceiverOptions options) : receiver(std::move(options)) {}

    tiller::receive::Receiver receiver;
    tiller::recording::Recorder recorder;
    bool verbose = false;
    double givenPeriod = 0;  ///< [s]; 0: default of the controller

    std::mutex mutex;  ///< protects starting and stopping
    std::mutex pausing;
    PausingState state = PausingState::RUNNING;
    double resumedAt = 0;  ///< `timestamp` at the end of the last pause [s]

    /// Copies the newest packet to the buffer of the calling thread and returns it.
    const Sample& newest() const;
    List list(std::string_view field) const;
    double number(std::string_view field) const;
    double registerValue(const std::string& field) const;
    double speed();
    /// Starts the receiver and waits for the first packet. Without data, the receiver keeps retrying.
    void start();
    bool waitForPackage(milliseconds atMost);
};

const Sample& RTDEReceiveInterface::Private::newest() const {
    // One buffer per thread, which avoids locks and allocations.
    thread_local Sample sample;
    receiver.latest(sample);
    return sample;
}

List RTDEReceiveInterface::Private::list(std::string_view field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::runtime_error(std::string(field) + " is not received, or this robot does not send it");
    }
    return {values.begin(), values.end()};
}

double RTDEReceiveInterface::Private::number(std::string_view field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::runtime_error(std::string(field) + " is not received, or this robot does not send it");
    }
    return values.front();
}

double RTDEReceiveInterface::Private::registerValue(const std::string& field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::range_error(
            field +
            " is not received: only registers 12-19 (36-43 with use_upper_range_registers) and the registers "
            "named in `variables` are received");
    }
    return values.front();
}

double RTDEReceiveInterface::Private::speed() {
    const double full = number("speed_scaling") * number("target_speed_fraction");
    const auto runtime = static_cast<tiller::RuntimeState>(number("runtime_state"));
    const double now = number("timestamp");
    const std::lock_guard lock(pausing);
    if (runtime == tiller::RuntimeState::Pausing || runtime == tiller::RuntimeState::Paused) {
        state = PausingState::PAUSED;
        return 0;
    }
    if (state == PausingState::PAUSED) {
        state = PausingState::RAMPUP;
        resumedAt = now;
    }
    if (state == PausingState::RAMPUP && now - resumedAt >= kRampUpTime) {
        state = PausingState::RUNNING;
    }
    return state == PausingState::RUNNING ? full : full * std::max(0.0, (now - resumedAt) / kRampUpTime);
}

bool RTDEReceiveInterface::Private::waitForPackage(milliseconds atMost) {
    const std::uint64_t before = receiver.counters().packets;
    const auto deadline = tiller::urrtde::within(atMost);
    const auto came = [&] { return receiver.counters().packets != before; };
    tiller::waitUntil(deadline, [&] { return came() || receiver.state() == ReceiverState::Stopped; });
    if (!came() && deadline.isCancelled()) {
        throw tiller::urrtde::Interrupted();
    }
    return came();
}

void RTDEReceiveInterface::Private::start() {
    const std::uint64_t before = receiver.counters().packets;
    if (const auto started = receiver.start(); !started) {
        throw std::invalid_argument(started.error().message());
    }
    const auto deadline = tiller::urrtde::within(kReceiveConnectTime + milliseconds(500));
    const auto came = [&] { return receiver.counters().packets != before; };
    bool failed = false;
    tiller::waitUntil(deadline, [&] {
        failed = !came() && receiver.state() == ReceiverState::Waiting;
        return failed || came();
    });
    if (!came()) {
        if (deadline.isCancelled()) {
            throw tiller::urrtde::Interrupted();
        }
        throw std::runtime_error(failed ? receiver.lastError().toString().toStdString()
                                        : "the robot sends no data over RTDE. Check that it is switched on.");
    }
    if (verbose) {
        for (const std::string& field : receiver.absentFields()) {
            std::cout << "RTDEReceiveInterface: this robot does not send " << field << std::endl;
        }
    }
}

RTDEReceiveInterface::RTDEReceiveInterface(std::string hostname, double frequency,
                                           std::vector<std::string> variables, bool verbose,
                                           bool use_upper_range_registers, int rt_priority)
    : d_(std::make_unique<Private>(
          optionsOf(hostname, frequency, std::move(variables), use_upper_range_registers, rt_priority))) {
    d_->verbose = verbose;
    d_->givenPeriod = frequency > 0 ? 1 / frequency : 0;
    d_->start();
}

RTDEReceiveInterface::~RTDEReceiveInterface() {
    disconnect();
}

void RTDEReceiveInterface::disconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->recorder.stop();
    d_->receiver.stop();
}

bool RTDEReceiveInterface::reconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->receiver.stop();
    try {
        d_->start();
    } catch (const tiller::urrtde::Interrupted&) {
        throw;
    } catch (const std::runtime_error& error) {
        if (d_->verbose) {
            std::cerr << "RTDEReceiveInterface: " << error.what() << std::endl;
        }
        return false;
    }
    return true;
}

bool RTDEReceiveInterface::isConnected() {
    return d_->receiver.state() == ReceiverState::Receiving && !d_->newest().isEmpty();
}

std::chrono::steady_clock::time_point RTDEReceiveInterface::initPeriod() {
    return std::chrono::steady_clock::now();
}

void RTDEReceiveInterface::waitPeriod(const std::chrono::steady_clock::time_point& t_cycle_start) {
    RTDEUtility::waitPeriod(t_cycle_start, d_->givenPeriod > 0 ? d_->givenPeriod : d_->receiver.period());
}

bool RTDEReceiveInterface::startFileRecording(const std::string& filename,
                                              const std::vector<std::string>& variables) {
    if (filename.empty()) {
        throw std::invalid_argument("filename is empty");
    }
    tiller::recording::RecorderOptions options;
    options.path = QString::fromStdString(filename);
    options.format = tiller::recording::csvFormat();  // CSV for every file name, as in ur_rtde
    options.asGiven = true;                           // programs identify columns by number
    options.fields.clear();
    for (const auto& entry : d_->receiver.layout()->entries()) {
        options.fields.push_back(entry.name);
    }
    for (const std::string& name : variables) {
        if (std::find(options.fields.begin(), options.fields.end(), name) == options.fields.end()) {
            throw std::invalid_argument("variables: \"" + name + "\" is not received");
        }
    }
    if (!variables.empty()) {
        options.fields = variables;
    }
    const std::lock_guard lock(d_->mutex);
    const auto started = d_->recorder.start(options, d_->receiver);
    if (!started && d_->verbose) {
        std::cerr << "RTDEReceiveInterface: " << started.error().toString().toStdString() << std::endl;
    }
    return started.ok();
}

bool RTDEReceiveInterface::stopFileRecording() {
    const std::lock_guard lock(d_->mutex);
    const bool recording = d_->recorder.progress().state == tiller::recording::RecorderState::Recording;
    d_->recorder.stop();
    return recording && d_->recorder.progress().state == tiller::recording::RecorderState::Finished;
}

void RTDEReceiveInterface::receiveCallback() {
    d_->waitForPackage(kSilenceLimit);
}

void RTDEReceiveInterface::recordCallback() {
    if (d_->recorder.progress().state == tiller::recording::RecorderState::Recording) {
        d_->waitForPackage(kSilenceLimit);
    }
}

double RTDEReceiveInterface::getTimestamp() {
    return d_->number("timestamp");
}

List RTDEReceiveInterface::getTargetQ() {
    return d_->list("target_q");
}

List RTDEReceiveInterface::getTargetQd() {
    return d_->list("target_qd");
}

List RTDEReceiveInterface::getTargetQdd() {
    return d_->list("target_qdd");
}

List RTDEReceiveInterface::getTargetCurrent() {
    return d_->list("target_current");
}

List RTDEReceiveInterface::getTargetMoment() {
    return d_->list("target_moment");
}

List RTDEReceiveInterface::getActualQ() {
    return d_->list("actual_q");
}

List RTDEReceiveInterface::getActualQd() {
    return d_->list("actual_qd");
}

List RTDEReceiveInterface::getActualCurrent() {
    return d_->list("actual_current");
}

List RTDEReceiveInterface::getJointControlOutput() {
    return d_->list("joint_control_output");
}

List RTDEReceiveInterface::getActualTCPPose() {
    return d_->list("actual_TCP_pose");
}

List RTDEReceiveInterface::getActualTCPSpeed() {
    return d_->list("actual_TCP_speed");
}

List RTDEReceiveInterface::getActualTCPForce() {
    return d_->list("actual_TCP_force");
}

List RTDEReceiveInterface::getTargetTCPPose() {
    return d_->list("target_TCP_pose");
}

List RTDEReceiveInterface::getTargetTCPSpeed() {
    return d_->list("target_TCP_speed");
}

uint64_t RTDEReceiveInterface::getActualDigitalInputBits() {
    return static_cast<uint64_t>(d_->number("actual_digital_input_bits"));
}

List RTDEReceiveInterface::getJointTemperatures() {
    return d_->list("joint_temperatures");
}

double RTDEReceiveInterface::getActualExecutionTime() {
    return d_->number("actual_execution_time");
}

int32_t RTDEReceiveInterface::getRobotMode() {
    return static_cast<int32_t>(d_->number("robot_mode"));
}

uint32_t RTDEReceiveInterface::getRobotStatus() {
    return static_cast<uint32_t>(d_->number("robot_status_bits"));
}

int32_t RTDEReceiveInterface::getSafetyMode() {
    return static_cast<int32_t>(d_->number("safety_mode"));
}

uint32_t RTDEReceiveInterface::getSafetyStatusBits() {
    return static_cast<uint32_t>(d_->number("safety_status_bits"));
}

List RTDEReceiveInterface::getActualToolAccelerometer() {
    return d_->list("actual_tool_accelerometer");
}

double RTDEReceiveInterface::getSpeedScaling() {
    return d_->number("speed_scaling");
}

double RTDEReceiveInterface::getTargetSpeedFraction() {
    return d_->number("target_speed_fraction");
}

double RTDEReceiveInterface::getActualMomentum() {
    return d_->number("actual_momentum");
}

double RTDEReceiveInterface::getActualMainVoltage() {
    return d_->number("actual_main_voltage");
}

double RTDEReceiveInterface::getActualRobotVoltage() {
    return d_->number("actual_robot_voltage");
}

double RTDEReceiveInterface::getActualRobotCurrent() {
    return d_->number("actual_robot_current");
}

List RTDEReceiveInterface::getActualJointVoltage() {
    return d_->list("actual_joint_voltage");
}

uint64_t RTDEReceiveInterface::getActualDigitalOutputBits() {
    return static_cast<uint64_t>(d_->number("actual_digital_output_bits"));
}

uint32_t RTDEReceiveInterface::getRuntimeState() {
    return static_cast<uint32_t>(d_->number("runtime_state"));
}

double RTDEReceiveInterface::getStandardAnalogInput0() {
    return d_->number("standard_analog_input0");
}

double RTDEReceiveInterface::getStandardAnalogInput1() {
    return d_->number("standard_analog_input1");
}

double RTDEReceiveInterface::getStandardAnalogOutput0() {
    return d_->number("standard_analog_output0");
}

double RTDEReceiveInterface::getStandardAnalogOutput1() {
    return d_->number("standard_analog_output1");
}

List RTDEReceiveInterface::getFtRawWrench() {
    return d_->list("ft_raw_wrench");
}

double RTDEReceiveInterface::getPayload() {
    return d_->number("payload");
}

List RTDEReceiveInterface::getPayloadCog() {
    return d_->list("payload_cog");
}

List RTDEReceiveInterface::getPayloadInertia() {
    return d_->list("payload_inertia");
}

std::vector<int32_t> RTDEReceiveInterface::getJointMode() {
    const List modes = d_->list("joint_mode");
    return {modes.begin(), modes.end()};
}

bool RTDEReceiveInterface::getDigitalInState(std::uint8_t input_id) {
    check::integer("input_id", input_id, 0, kDigitalPins - 1);
    return (getActualDigitalInputBits() >> input_id & 1U) != 0;
}

bool RTDEReceiveInterface::getDigitalOutState(std::uint8_t output_id) {
    check::integer("output_id", output_id, 0, kDigitalPins - 1);
    return (getActualDigitalOutputBits() >> output_id & 1U) != 0;
}

bool RTDEReceiveInterface::isProtectiveStopped() {
    return (getSafetyStatusBits() >> IS_PROTECTIVE_STOPPED & 1U) != 0;
}

bool RTDEReceiveInterface::isEmergencyStopped() {
    return (getSafetyStatusBits() >> IS_EMERGENCY_STOPPED & 1U) != 0;
}

int RTDEReceiveInterface::getOutputIntRegister(int output_id) {
    check::integer("output_id", output_id, 0, tiller::rtde::kRegisterCount - 1);
    return static_cast<int>(d_->registerValue(tiller::rtde::intRegisterName(Direction::Output, output_id)));
}

double RTDEReceiveInterface::getOutputDoubleRegister(int output_id) {
    check::integer("output_id", output_id, 0, tiller::rtde::kRegisterCount - 1);
    return d_->registerValue(tiller::rtde::doubleRegisterName(Direction::Output, output_id));
}

double RTDEReceiveInterface::getSpeedScalingCombined() {
    return d_->speed();
}

}  // namespace ur_rtde
