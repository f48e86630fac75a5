// SPDX-License-Identifier: MIT
#pragma once

// General purpose input registers a program on the robot can read: integers, floating point numbers and bits.
// Through an RTDE connection of its own, each register claimed by itself, so that one that somebody else owns
// does not cost the others.

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
    /// The registers this client wants to write, by number: 0-23 are a fieldbus' unless there is none, 24-47
    /// are for clients like this. The control program uses integers 0-9 and doubles 0-17 of its range.
    std::vector<int> ints = {};     ///< 0-47
    std::vector<int> doubles = {};  ///< 0-47
    std::vector<int> bits = {};     ///< 64-127
};

/// Threads  any; calls are carried out one after the other
class InputRegisters {
public:
    /// newest  the value the robot reports for a field, nothing where it is not followed; left out: writing
    /// is
    ///         not confirmed
    using Newest = std::function<std::optional<double>(const std::string& field)>;
    explicit InputRegisters(InputRegistersOptions options, Newest newest = {});
    ~InputRegisters();
    InputRegisters(const InputRegisters&) = delete;
    InputRegisters& operator=(const InputRegisters&) = delete;

    /// The newest value from a receiver that follows the registers ("input_int_register_24").
    static Newest fromReceiver(const receive::Receiver& receiver);

    /// Errors  as rtde::Connection::open; InvalidArgument naming a number that no register has; registers owned by others
    ///         are no error here
    Result<void> connect(const Deadline& deadline);
    void disconnect();         ///< Frees the registers.
    bool isConnected() const;  ///< The link stands.

    /// Errors  NotConnected, InvalidArgument (not asked for in the options; not a number), RegisterInUse,
    ///         FieldUnknown, LinkLost, Timeout (the robot does not report it), Cancelled
    /// Blocks  until the robot reports the value, where the receiver follows the register
    Result<void> setInt(int number, std::int32_t value, const Deadline& deadline);
    Result<void> setDouble(int number, double value, const Deadline& deadline);  ///< As setInt().
    Result<void> setBit(int number, bool value, const Deadline& deadline);       ///< As setInt(); 64 ... 127.

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::io
