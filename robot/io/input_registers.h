// SPDX-License-Identifier: MIT
#pragma once

// Sets general purpose input registers (integers, doubles and bits) that a program on the robot can read,
// through a separate RTDE connection. Each register is requested separately, so that a register used by
// another client does not affect the others.

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"
#include "robot/rtde/protocol.h"

namespace tiller::io {

struct InputRegistersOptions {
    Text host = {};
    std::uint16_t port = rtde::kPort;
    /// Numbers of the registers to write. Registers 0-23 are reserved for a fieldbus if one is used; 24-47
    /// are intended for external clients. The control program uses integers 0-10 and doubles 0-17 of its
    /// range.
    std::vector<int> ints = {};     ///< 0-47
    std::vector<int> doubles = {};  ///< 0-47
    std::vector<int> bits = {};     ///< 64-127
};

/// Threads  any; calls are serialized
class InputRegisters {
public:
    /// newest  returns the value that the robot reports for a field, or nothing if the field is not received.
    ///         Without this function, writes are not confirmed.
    using Newest = std::function<std::optional<double>(const std::string& field)>;
    explicit InputRegisters(InputRegistersOptions options, Newest newest = {});
    ~InputRegisters();
    InputRegisters(const InputRegisters&) = delete;
    InputRegisters& operator=(const InputRegisters&) = delete;

    /// Reads the newest value from a receiver that subscribed to the registers (e.g. "input_int_register_24").
    static Newest fromReceiver(const receive::Receiver& receiver);

    /// Errors  as for rtde::Connection::open(); InvalidArgument for an invalid register number; registers used by other
    ///         clients do not cause an error here
    Result<void> connect(const Deadline& deadline);
    void disconnect();  ///< Disconnects and releases the registers.
    bool isConnected() const;

    /// Errors  NotConnected, InvalidArgument (not listed in the options, or NaN), RegisterInUse, FieldUnknown,
    ///         LinkLost, Timeout (the robot does not report the value), Cancelled
    /// Blocks  until the robot reports the value, if the receiver subscribed to the register
    Result<void> setInt(int number, std::int32_t value, const Deadline& deadline);
    /// Errors and blocking: as for setInt().
    Result<void> setDouble(int number, double value, const Deadline& deadline);
    /// Bits 64 ... 127. Errors and blocking: as for setInt().
    Result<void> setBit(int number, bool value, const Deadline& deadline);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::io
