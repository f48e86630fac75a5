// SPDX-License-Identifier: MIT
#include "robot/io/outputs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "robot/receive/robot_state.h"
#include "robot/rtde/connection.h"

namespace tiller::io {

namespace {

using std::chrono::milliseconds;

/// Groups of fields. Each group has a separate recipe, because another client may use some of the groups.
enum Group : std::size_t { kStandard, kConfigurable, kTool, kSlider, kAnalog, kGroups };

struct GroupFacts {
    const char* name;
    std::array<const char*, 4> fields;  ///< the entries before the first null
    int firstBit;
    int bits;
};

constexpr std::array<GroupFacts, kGroups> kFacts = {{
    {"standard digital outputs",
     {"standard_digital_output_mask", "standard_digital_output"},
     0,
     kStandardOutputs},
    {"configurable digital outputs",
     {"configurable_digital_output_mask", "configurable_digital_output"},
     kFirstConfigurable,
     kFirstTool - kFirstConfigurable},
    {"tool digital outputs",
     {"tool_digital_output_mask", "tool_digital_output"},
     kFirstTool,
     kDigitalOutputs - kFirstTool},
    {"speed slider", {"speed_slider_mask", "speed_slider_fraction"}, 0, 0},
    {"analog outputs",
     {"standard_analog_output_mask", "standard_analog_output_type", "standard_analog_output_0",
      "standard_analog_output_1"},
     0,
     0},
}};

constexpr int kAnalogOutputs = 2;
constexpr std::uint32_t kAllOutputs = (1U << kDigitalOutputs) - 1;
// The slider is displayed in whole percent, and the robot may round the value.
constexpr double kSliderTolerance = 0.005;
constexpr std::int64_t kFreshNs = 1 * kNsPerSecond;

/// RTDE fields that confirm a command.
using ReportFields = std::array<const char*, 3>;
constexpr ReportFields kDigitalReport{"actual_digital_output_bits"};
constexpr ReportFields kSliderReport{"target_speed_fraction"};
constexpr ReportFields kAnalogReport{"analog_io_types", "standard_analog_output0", "standard_analog_output1"};

std::vector<std::string> fieldsOf(const GroupFacts& facts) {
    std::vector<std::string> names;
    for (const char* field : facts.fields) {
        if (field != nullptr) {
            names.emplace_back(field);
        }
    }
    return names;
}

Group groupOf(int output) {
    return output < kFirstConfigurable ? kStandard : output < kFirstTool ? kConfigurable : kTool;
}

/// Controllers report currents in mA or in A. The two ranges do not overlap.
bool isLevel(double reported, AnalogDomain domain, double level) {
    constexpr double kTolerance = 0.01;  // fraction of the range
    if (domain == AnalogDomain::Voltage) {
        constexpr double kVolts = 10.0;
        return std::abs(reported / kVolts - level) < kTolerance;
    }
    constexpr double kSurelyMilliamperes = 1.0;
    constexpr double kMinValue = 4.0;  // [mA]
    constexpr double kRange = 16.0;    // [mA]
    const double milliamperes = reported > kSurelyMilliamperes ? reported : reported * 1000.0;
    return std::abs((milliamperes - kMinValue) / kRange - level) < kTolerance;
}

Error invalid(const QString& what) {
    return {ErrorCode::InvalidArgument, what, {}};
}

}  // namespace

OutputFeedback OutputFeedback::fromReceiver(const receive::Receiver& receiver) {
    std::vector<std::string> absent;
    for (const auto& fields : {kDigitalReport, kSliderReport, kAnalogReport}) {
        for (const char* field : fields) {
            if (field != nullptr && receiver.layout()->find(field) == nullptr) {
                absent.emplace_back(field);
            }
        }
    }
    const auto newest = [&receiver] {
        Report report;
        const receive::Sample sample = receiver.latest();
        report.sequence = sample.sequence;
        if (sample.isEmpty() || receiver.ageNs() > kFreshNs) {
            return report;
        }
        const receive::RobotState state(sample);
        report.digitalOutputs = state.digitalOutputs();
        if (state.has("target_speed_fraction")) {
            report.speedSlider = state.speedSlider();
        }
        if (const auto types = state.analogIoTypes(); types && state.has("standard_analog_output0")) {
            constexpr unsigned kFirstOutput = 2;  // bits 0 and 1 are the analog inputs
            report.analogOutputs = {state.analogOutput(0), state.analogOutput(1)};
            report.analogDomains = *types >> kFirstOutput;
        }
        return report;
    };
    return {newest, std::move(absent)};
}

struct Outputs::Link {
    OutputsOptions options;
    OutputFeedback feedback;
    mutable std::mutex mutex;  ///< locked while connecting and sending, never while waiting for the robot
    std::unique_ptr<rtde::Connection> connection;
    std::atomic<bool> connected{false};
    std::mutex waitMutex;
    std::condition_variable waitEnds;
    std::atomic<std::uint64_t> disconnects{0};

    Result<void> open(const Deadline& deadline) {
        drop();
        rtde::ConnectionOptions wanted;
        wanted.host = options.host;
        wanted.port = options.port;
        for (const GroupFacts& facts : kFacts) {
            wanted.request.inputs.push_back({fieldsOf(facts), false});
        }
        auto opened = rtde::Connection::open(wanted, deadline);
        if (!opened) {
            return opened.error();
        }
        connection = std::move(opened).value();
        connected = true;
        return {};
    }

    void drop() {
        connected = false;
        connection.reset();
    }

    /// The robot sends no data on this connection, so a closed connection is only detected by an explicit
    /// check.
    bool isAlive() const {
        if (!connection) {
            return false;
        }
        return connection->readPackage({}, std::chrono::nanoseconds(0)) == rtde::Connection::Read::Nothing;
    }

    Result<void> available(Group group) const {
        if (!connection) {
            return Error{ErrorCode::NotConnected, QStringLiteral("no connection to set outputs"), {}};
        }
        const rtde::Recipe& recipe = connection->inputs()[group];
        if (recipe.isValid() && recipe.fields().size() == fieldsOf(kFacts[group]).size()) {
            return {};
        }
        const QString name = QString::fromLatin1(kFacts[group].name);
        const auto& owned = connection->session().inUse()[group];
        if (!owned.empty()) {
            return Error{ErrorCode::RegisterInUse,
                         QStringLiteral("%1: another RTDE client or a fieldbus uses %2")
                             .arg(name, QString::fromStdString(rtde::joinNames(owned))),
                         {}};
        }
        return Error{
            ErrorCode::FieldUnknown,
            QStringLiteral("%1: this robot does not support setting this output over RTDE").arg(name),
            {}};
    }

    Result<void> send(Group group, std::span<const double> values) {
        if (auto ready = available(group); !ready) {
            return ready;
        }
        switch (connection->sendInputs(group, values)) {
            case rtde::Connection::Send::Sent:
                return {};
            case rtde::Connection::Send::Busy:
                return Error{ErrorCode::LinkLost, connection->peer(),
                             QStringLiteral("the robot is not reading its inputs")};
            case rtde::Connection::Send::Failed:
                break;
        }
        const Error error = connection->error();
        drop();
        return error;
    }

    /// Checks that the receiver receives the fields that confirm the command.
    Result<void> confirmable(const QString& what, const ReportFields& fields) const {
        for (const char* field : fields) {
            if (field != nullptr &&
                std::find(feedback.absent.begin(), feedback.absent.end(), field) != feedback.absent.end()) {
                return Error{ErrorCode::FieldUnknown, what,
                             QStringLiteral("the receiver was started without the field %1, which is "
                                            "required to confirm the command")
                                 .arg(QLatin1String(field))};
            }
        }
        return {};
    }

    /// State just before sending. Only later reports confirm the command, and only later disconnects end the
    /// wait.
    struct Moment {
        std::uint64_t sequence = 0;
        std::uint64_t disconnects = 0;
    };
    Moment moment() const { return {feedback.newest().sequence, disconnects}; }

    template <class Done>
    Result<void> confirm(const QString& what, const Moment& before, const Deadline& deadline, Done done) {
        std::unique_lock lock(waitMutex);
        while (!deadline.hasExpired()) {
            const Report report = feedback.newest();
            if (report.sequence > before.sequence && done(report)) {
                return {};
            }
            if (waitEnds.wait_for(lock, milliseconds(2), [&] { return disconnects != before.disconnects; })) {
                return Error{ErrorCode::Cancelled, what, {}};
            }
        }
        if (deadline.isCancelled()) {
            return Error{ErrorCode::Cancelled, what, {}};
        }
        // The controller may have dropped the connection without closing it. The next call opens a new
        // connection.
        lock.unlock();
        const std::lock_guard guard(mutex);
        drop();
        return Error{ErrorCode::Timeout, what, QStringLiteral("the robot did not confirm the value")};
    }
};

Outputs::Outputs(OutputsOptions options, OutputFeedback feedback) : d_(std::make_unique<Link>()) {
    d_->options = std::move(options);
    d_->feedback = std::move(feedback);
}

Outputs::~Outputs() {
    disconnect();
}

Result<void> Outputs::connect(const Deadline& deadline) {
    const std::lock_guard lock(d_->mutex);
    return d_->open(deadline);
}

void Outputs::disconnect() {
    {
        const std::lock_guard lock(d_->waitMutex);
        ++d_->disconnects;
    }
    d_->waitEnds.notify_all();
    const std::lock_guard lock(d_->mutex);
    d_->drop();
}

bool Outputs::isConnected() const {
    return d_->connected;
}

Result<void> Outputs::setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const Deadline& deadline) {
    if (mask == 0 || (mask & ~kAllOutputs) != 0) {
        return invalid(QStringLiteral("use only digital outputs 0 to %1").arg(kDigitalOutputs - 1));
    }
    if (auto can = d_->confirmable(QStringLiteral("set digital outputs"), kDigitalReport); !can) {
        return can;
    }
    Link::Moment before;
    {
        const std::lock_guard lock(d_->mutex);
        if (!d_->isAlive()) {
            if (auto opened = d_->open(deadline); !opened) {
                return opened;
            }
        }
        // Check every group before sending to the first group, so that either all outputs are set or none.
        std::vector<Group> groups;
        for (const Group group : {kStandard, kConfigurable, kTool}) {
            const std::uint32_t ofGroup = ((1U << kFacts[group].bits) - 1) << kFacts[group].firstBit;
            if ((mask & ofGroup) != 0) {
                if (auto ready = d_->available(group); !ready) {
                    return ready;
                }
                groups.push_back(group);
            }
        }
        before = d_->moment();
        for (const Group group : groups) {
            const std::uint32_t width = (1U << kFacts[group].bits) - 1;
            const std::uint32_t groupMask = (mask >> kFacts[group].firstBit) & width;
            const std::uint32_t groupValues = (values >> kFacts[group].firstBit) & groupMask;
            const std::array<double, 2> package{static_cast<double>(groupMask),
                                                static_cast<double>(groupValues)};
            if (auto sent = d_->send(group, package); !sent) {
                return sent;
            }
        }
    }
    const std::uint64_t wanted = values & mask;
    return d_->confirm(QStringLiteral("set digital outputs"), before, deadline, [&](const Report& report) {
        return report.digitalOutputs && (*report.digitalOutputs & mask) == wanted;
    });
}

Result<void> Outputs::setDigitalOutput(int output, bool on, const Deadline& deadline) {
    if (output < 0 || output >= kDigitalOutputs) {
        return invalid(QStringLiteral("digital output %1 does not exist; use 0 to %2")
                           .arg(output)
                           .arg(kDigitalOutputs - 1));
    }
    const std::uint32_t bit = 1U << output;
    return setDigitalOutputs(bit, on ? bit : 0, deadline);
}

Result<void> Outputs::setSpeedSlider(double fraction, const Deadline& deadline) {
    if (!std::isfinite(fraction) || fraction > 1.0 || fraction < kLowestSpeedFraction) {
        return invalid(
            QStringLiteral(
                "speed slider: %1 is outside the range %2 to 1. To stop the arm, stop or pause the program")
                .arg(fraction)
                .arg(kLowestSpeedFraction));
    }
    if (auto can = d_->confirmable(QStringLiteral("set the speed slider"), kSliderReport); !can) {
        return can;
    }
    Link::Moment before;
    {
        const std::lock_guard lock(d_->mutex);
        if (!d_->isAlive()) {
            if (auto opened = d_->open(deadline); !opened) {
                return opened;
            }
        }
        before = d_->moment();
        if (auto sent = d_->send(kSlider, std::array{1.0, fraction}); !sent) {
            return sent;
        }
    }
    return d_->confirm(QStringLiteral("set the speed slider"), before, deadline, [&](const Report& report) {
        return report.speedSlider && std::abs(*report.speedSlider - fraction) < kSliderTolerance;
    });
}

Result<void> Outputs::setAnalogOutput(int output, AnalogDomain domain, double level,
                                      const Deadline& deadline) {
    if (output < 0 || output >= kAnalogOutputs) {
        return invalid(QStringLiteral("analog output %1 does not exist; use 0 or 1").arg(output));
    }
    if (!std::isfinite(level) || level < 0 || level > 1) {
        return invalid(QStringLiteral("analog level: %1 is outside the range 0 to 1").arg(level));
    }
    const auto which = static_cast<std::size_t>(output);
    const unsigned bit = 1U << which;
    if (auto can = d_->confirmable(QStringLiteral("set analog output %1").arg(output), kAnalogReport); !can) {
        return can;
    }
    Link::Moment before;
    {
        const std::lock_guard lock(d_->mutex);
        if (!d_->isAlive()) {
            if (auto opened = d_->open(deadline); !opened) {
                return opened;
            }
        }
        before = d_->moment();
        const std::array<double, 4> package{static_cast<double>(bit),
                                            domain == AnalogDomain::Voltage ? static_cast<double>(bit) : 0.0,
                                            level, level};
        if (auto sent = d_->send(kAnalog, package); !sent) {
            return sent;
        }
    }
    return d_->confirm(QStringLiteral("set analog output %1").arg(output), before, deadline,
                       [&](const Report& report) {
                           const bool voltage = (report.analogDomains & bit) != 0;
                           return report.analogOutputs && voltage == (domain == AnalogDomain::Voltage) &&
                                  isLevel((*report.analogOutputs)[which], domain, level);
                       });
}

Result<void> Outputs::canSetAnalogOutput() const {
    const std::lock_guard lock(d_->mutex);
    return d_->available(kAnalog);
}

Result<void> Outputs::canSetDigitalOutput(int output) const {
    if (output < 0 || output >= kDigitalOutputs) {
        return invalid(QStringLiteral("digital output %1").arg(output));
    }
    const std::lock_guard lock(d_->mutex);
    return d_->available(groupOf(output));
}

Result<void> Outputs::canSetSpeedSlider() const {
    const std::lock_guard lock(d_->mutex);
    return d_->available(kSlider);
}

}  // namespace tiller::io
