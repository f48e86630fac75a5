// SPDX-License-Identifier: MIT
// The life of the interface, waiting and recording; the getters are in receive_values.cpp.
#include "robot/ur_rtde/rtde_receive_interface.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "robot/core/modes.h"
#include "robot/rtde/fields.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/receive_fields.h"
#include "robot/ur_rtde/detail/receive_private.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

namespace check = tiller::urrtde::check;
using std::chrono::milliseconds;
using tiller::receive::ReceiverOptions;
using tiller::receive::ReceiverState;
using tiller::receive::Sample;

namespace {

constexpr milliseconds kConnectTime(3000);
constexpr milliseconds kSilenceLimit(2500);
constexpr double kRampUpTime = 0.2;  // [s] from a standstill to full speed after a pause

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

}  // namespace

const Sample& RTDEReceiveInterface::Private::newest() const {
    // One for each thread, so that nobody waits and nothing is allocated.
    thread_local Sample sample;
    receiver.latest(sample);
    return sample;
}

std::vector<double> RTDEReceiveInterface::Private::list(std::string_view field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::runtime_error(std::string(field) + " is not followed, or this robot does not send it");
    }
    return {values.begin(), values.end()};
}

double RTDEReceiveInterface::Private::number(std::string_view field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::runtime_error(std::string(field) + " is not followed, or this robot does not send it");
    }
    return values.front();
}

double RTDEReceiveInterface::Private::registerValue(const std::string& field) const {
    const auto values = newest().field(field);
    if (values.empty()) {
        throw std::range_error(
            field +
            " is not followed: registers 12-19 are, or 36-43 with use_upper_range_registers, or "
            "those named in `variables`");
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
    while (receiver.counters().packets == before) {
        if (deadline.isCancelled()) {
            throw tiller::urrtde::Interrupted();
        }
        if (deadline.hasExpired() || receiver.state() == ReceiverState::Stopped) {
            return false;
        }
        std::this_thread::sleep_for(milliseconds(1));
    }
    return true;
}

void RTDEReceiveInterface::Private::start() {
    const std::uint64_t before = receiver.counters().packets;
    if (const auto started = receiver.start(); !started) {
        throw std::invalid_argument(started.error().message());
    }
    const auto deadline = tiller::urrtde::within(kConnectTime + milliseconds(500));
    while (receiver.counters().packets == before) {
        const bool failed = receiver.state() == ReceiverState::Waiting;
        if (failed || deadline.hasExpired()) {
            const tiller::Error error = receiver.lastError();
            if (deadline.isCancelled()) {
                throw tiller::urrtde::Interrupted();
            }
            throw std::runtime_error(failed ? error.toString().toStdString()
                                            : "the robot sends no data over RTDE: is it switched on?");
        }
        std::this_thread::sleep_for(milliseconds(1));
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
    options.asGiven = true;  // programs find columns by their number
    options.fields.clear();
    for (const auto& entry : d_->receiver.layout()->entries()) {
        options.fields.push_back(entry.name);
    }
    for (const std::string& name : variables) {
        if (std::find(options.fields.begin(), options.fields.end(), name) == options.fields.end()) {
            throw std::invalid_argument("variables: \"" + name + "\" is not followed");
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

}  // namespace ur_rtde
