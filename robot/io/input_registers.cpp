// SPDX-License-Identifier: MIT
#include "robot/io/input_registers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <tuple>

#include "robot/core/wait_until.h"
#include "robot/rtde/connection.h"
#include "robot/rtde/fields.h"

namespace tiller::io {

using std::chrono::milliseconds;

struct InputRegisters::Private {
    InputRegistersOptions options;
    Newest newest;
    std::vector<std::string> names;  ///< register names, with one recipe each
    mutable std::mutex mutex;
    std::unique_ptr<rtde::Connection> connection;
    std::atomic<bool> connected{false};

    Result<void> checkNumbers() const {
        const auto check = [](const char* name, const std::vector<int>& numbers, int first, int last) {
            const auto wrong = std::find_if(numbers.begin(), numbers.end(),
                                            [&](int number) { return number < first || number > last; });
            return wrong == numbers.end()
                       ? Result<void>()
                       : Error{ErrorCode::InvalidArgument, QStringLiteral("claim input registers"),
                               QStringLiteral("%1: %2 does not exist; valid numbers are %3 to %4")
                                   .arg(QLatin1String(name))
                                   .arg(*wrong)
                                   .arg(first)
                                   .arg(last)};
        };
        for (const auto& [name, numbers, first, last] :
             {std::tuple("ints", options.ints, 0, 47), std::tuple("doubles", options.doubles, 0, 47),
              std::tuple("bits", options.bits, 64, 127)}) {
            if (auto checked = check(name, numbers, first, last); !checked) {
                return checked;
            }
        }
        return {};
    }

    Result<void> open(const Deadline& deadline) {
        connected = false;
        connection.reset();
        if (auto checked = checkNumbers(); !checked) {
            return checked;
        }
        rtde::ConnectionOptions wanted;
        wanted.host = options.host;
        wanted.port = options.port;
        for (const std::string& name : names) {
            wanted.request.inputs.push_back({{name}, false});
        }
        auto opened = rtde::Connection::open(wanted, deadline);
        if (!opened) {
            return opened.error();
        }
        connection = std::move(opened).value();
        connected = true;
        return {};
    }

    /// The robot sends no data on this connection, so a closed connection is only detected by an explicit
    /// check.
    bool isAlive() const {
        return connection &&
               connection->readPackage({}, std::chrono::nanoseconds(0)) == rtde::Connection::Read::Nothing;
    }

    Result<void> send(const std::string& name, double value, const Deadline& deadline) {
        const QString what = QStringLiteral("set %1").arg(QString::fromStdString(name));
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end()) {
            return Error{ErrorCode::InvalidArgument, what,
                         QStringLiteral("number: this register was not requested in the options")};
        }
        const auto recipe = static_cast<std::size_t>(at - names.begin());
        const std::lock_guard lock(mutex);
        if (!isAlive()) {
            if (auto opened = open(deadline); !opened) {
                return opened;
            }
        }
        if (!connection->inputs()[recipe].isValid()) {
            const bool owned = !connection->session().inUse()[recipe].empty();
            return Error{
                owned ? ErrorCode::RegisterInUse : ErrorCode::FieldUnknown, what,
                owned ? QStringLiteral("another RTDE client or a fieldbus uses this register") : QString()};
        }
        switch (connection->sendInputs(recipe, std::array{value})) {
            case rtde::Connection::Send::Sent:
                return {};
            case rtde::Connection::Send::Busy:
                return Error{ErrorCode::LinkLost, what,
                             QStringLiteral("the robot is not reading its inputs")};
            case rtde::Connection::Send::Failed:
                break;
        }
        const Error error = connection->error();
        connected = false;
        connection.reset();
        return error;
    }

    Result<void> set(const std::string& name, double value, const Deadline& deadline) {
        if (auto sent = send(name, value, deadline); !sent || !newest) {
            return sent;
        }
        const auto settled = [&] {
            const auto reported = newest(name);
            return !reported || *reported == value;  // field not received, or value confirmed
        };
        if (waitUntil(deadline, settled)) {
            return {};
        }
        return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout,
                     QStringLiteral("set %1").arg(QString::fromStdString(name)),
                     QStringLiteral("the robot did not confirm the value")};
    }
};

InputRegisters::InputRegisters(InputRegistersOptions options, Newest newest)
    : d_(std::make_unique<Private>()) {
    d_->options = std::move(options);
    d_->newest = std::move(newest);
    for (const int number : d_->options.ints) {
        d_->names.push_back(rtde::intRegisterName(rtde::Direction::Input, number));
    }
    for (const int number : d_->options.doubles) {
        d_->names.push_back(rtde::doubleRegisterName(rtde::Direction::Input, number));
    }
    for (const int number : d_->options.bits) {
        d_->names.push_back("input_bit_register_" + std::to_string(number));
    }
}

InputRegisters::~InputRegisters() = default;

InputRegisters::Newest InputRegisters::fromReceiver(const receive::Receiver& receiver) {
    return [&receiver](const std::string& field) -> std::optional<double> {
        const receive::Sample sample = receiver.latest();
        const auto values = sample.isEmpty() ? std::span<const double>() : sample.field(field);
        return values.empty() ? std::nullopt : std::optional<double>(values[0]);
    };
}

Result<void> InputRegisters::connect(const Deadline& deadline) {
    const std::lock_guard lock(d_->mutex);
    return d_->open(deadline);
}

void InputRegisters::disconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->connected = false;
    d_->connection.reset();
}

bool InputRegisters::isConnected() const {
    return d_->connected;
}

Result<void> InputRegisters::setInt(int number, std::int32_t value, const Deadline& deadline) {
    return d_->set(rtde::intRegisterName(rtde::Direction::Input, number), value, deadline);
}

Result<void> InputRegisters::setDouble(int number, double value, const Deadline& deadline) {
    if (!std::isfinite(value)) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("set a register"),
                     QStringLiteral("value: the value is not a number")};
    }
    return d_->set(rtde::doubleRegisterName(rtde::Direction::Input, number), value, deadline);
}

Result<void> InputRegisters::setBit(int number, bool value, const Deadline& deadline) {
    return d_->set("input_bit_register_" + std::to_string(number), value ? 1 : 0, deadline);
}

}  // namespace tiller::io
