// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/rtde_io_interface.h"

#include <array>
#include <iostream>
#include <mutex>
#include <stdexcept>

#include "robot/platform/thread_priority.h"
#include "robot/rtde/connection.h"
#include "robot/rtde/fields.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

namespace {

using tiller::rtde::Connection;
using tiller::rtde::Direction;
namespace check = tiller::urrtde::check;

/// Separate recipes for inputs that another client may use separately.
enum Group : std::size_t { kStandard, kConfigurable, kTool, kSlider, kAnalog, kIntRegisters };

constexpr int kFirstRegister = 18;
constexpr int kRegisters = 5;
constexpr double kLowestSpeed = 0.02;
constexpr std::chrono::milliseconds kIoConnectTime(3000);
constexpr std::chrono::milliseconds kReconnectTime(1000);

}  // namespace

struct RTDEIOInterface::Private {
    std::string host;
    bool verbose = false;
    int offset = 0;
    std::mutex mutex;  ///< protects the connection
    std::unique_ptr<Connection> connection;

    tiller::Result<void> open(std::chrono::milliseconds atMost) {
        connection.reset();
        tiller::rtde::ConnectionOptions wanted;
        wanted.host = QString::fromStdString(host);
        auto& inputs = wanted.request.inputs;
        inputs = {{{"standard_digital_output_mask", "standard_digital_output"}, false},
                  {{"configurable_digital_output_mask", "configurable_digital_output"}, false},
                  {{"tool_digital_output_mask", "tool_digital_output"}, false},
                  {{"speed_slider_mask", "speed_slider_fraction"}, false},
                  {{"standard_analog_output_mask", "standard_analog_output_type", "standard_analog_output_0",
                    "standard_analog_output_1"},
                   false}};
        for (int i = 0; i < kRegisters; ++i) {
            inputs.push_back(
                {{tiller::rtde::intRegisterName(Direction::Input, offset + kFirstRegister + i)}, false});
        }
        for (int i = 0; i < kRegisters; ++i) {
            inputs.push_back(
                {{tiller::rtde::doubleRegisterName(Direction::Input, offset + kFirstRegister + i)}, false});
        }
        auto opened = Connection::open(wanted, tiller::urrtde::within(atMost));
        if (!opened) {
            return opened.error();
        }
        connection = std::move(opened).value();
        return {};
    }

    /// The robot sends no data on this connection, so a closed connection is detected only by checking it.
    bool isAlive() const {
        return connection &&
               connection->readPackage({}, std::chrono::nanoseconds(0)) == Connection::Read::Nothing;
    }

    bool send(std::size_t recipe, std::span<const double> values) {
        const std::lock_guard lock(mutex);
        if (!connection) {
            return complain("not connected");
        }
        if (!isAlive() && !open(kReconnectTime)) {
            return complain("the connection is lost");
        }
        const auto& inputs = connection->inputs()[recipe];
        if (!inputs.isValid() || inputs.size() != values.size()) {
            const auto& owned = connection->session().inUse()[recipe];
            return complain(owned.empty() ? "this robot has no such input"
                                          : "another RTDE client or a fieldbus uses " + owned.front());
        }
        return connection->sendInputs(recipe, values) == Connection::Send::Sent ||
               complain("the robot is not reading its inputs");
    }
    bool send(std::size_t recipe, std::initializer_list<double> values) {
        return send(recipe, std::span(values.begin(), values.size()));
    }

    bool setDigital(Group group, int output, bool on) {
        const double bit = 1U << output;
        return send(group, {bit, on ? bit : 0.0});
    }

    bool setAnalog(int output, bool voltage, double ratio) {
        const double bit = 1U << output;
        return send(kAnalog,
                    {bit, voltage ? bit : 0.0, output == 0 ? ratio : 0.0, output == 1 ? ratio : 0.0});
    }

    std::size_t registerGroup(int number, int kind) const {
        check::integer("input_id", number, offset + kFirstRegister, offset + kFirstRegister + kRegisters - 1);
        return static_cast<std::size_t>(static_cast<int>(kIntRegisters) + kind * kRegisters + number -
                                        offset - kFirstRegister);
    }

    bool complain(const std::string& what) const {
        if (verbose) {
            std::cerr << "RTDEIOInterface: " << what << std::endl;
        }
        return false;
    }
};

RTDEIOInterface::RTDEIOInterface(std::string hostname, bool verbose, bool use_upper_range_registers,
                                 int rt_priority)
    : d_(std::make_unique<Private>()) {
    if (hostname.empty()) {
        throw std::invalid_argument("hostname is empty");
    }
    check::priority(rt_priority);
    if (rt_priority > 0) {
        tiller::realtime::requestThreadPriority(rt_priority);  // the caller's thread does all the work
    }
    d_->host = std::move(hostname);
    d_->verbose = verbose;
    d_->offset = use_upper_range_registers ? tiller::rtde::kFirstUpperRegister : 0;
    if (const auto opened = d_->open(kIoConnectTime); !opened) {
        tiller::urrtde::raise(opened.error());
    }
}

RTDEIOInterface::~RTDEIOInterface() = default;

void RTDEIOInterface::disconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->connection.reset();
}

bool RTDEIOInterface::reconnect() {
    const std::lock_guard lock(d_->mutex);
    return d_->open(kIoConnectTime).ok();
}

bool RTDEIOInterface::setStandardDigitalOut(std::uint8_t output_id, bool signal_level) {
    check::integer("output_id", output_id, 0, 7);
    return d_->setDigital(kStandard, output_id, signal_level);
}

bool RTDEIOInterface::setConfigurableDigitalOut(std::uint8_t output_id, bool signal_level) {
    check::integer("output_id", output_id, 0, 7);
    return d_->setDigital(kConfigurable, output_id, signal_level);
}

bool RTDEIOInterface::setToolDigitalOut(std::uint8_t output_id, bool signal_level) {
    check::integer("output_id", output_id, 0, 1);
    return d_->setDigital(kTool, output_id, signal_level);
}

bool RTDEIOInterface::setSpeedSlider(double speed) {
    check::number("speed", speed, kLowestSpeed, 1);
    return d_->send(kSlider, {1, speed});
}

bool RTDEIOInterface::setAnalogOutputVoltage(std::uint8_t output_id, double voltage_ratio) {
    check::integer("output_id", output_id, 0, 1);
    check::number("voltage_ratio", voltage_ratio, 0, 1);
    return d_->setAnalog(output_id, true, voltage_ratio);
}

bool RTDEIOInterface::setAnalogOutputCurrent(std::uint8_t output_id, double current_ratio) {
    check::integer("output_id", output_id, 0, 1);
    check::number("current_ratio", current_ratio, 0, 1);
    return d_->setAnalog(output_id, false, current_ratio);
}

bool RTDEIOInterface::setInputIntRegister(int input_id, int value) {
    return d_->send(d_->registerGroup(input_id, 0), {static_cast<double>(value)});
}

bool RTDEIOInterface::setInputDoubleRegister(int input_id, double value) {
    const double limit = std::numeric_limits<double>::max();
    check::number("value", value, -limit, limit);
    return d_->send(d_->registerGroup(input_id, 1), {value});
}

}  // namespace ur_rtde
