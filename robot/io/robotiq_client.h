// SPDX-License-Identifier: MIT
#pragma once

// Controls a Robotiq gripper at the robot's wrist through the socket of its URCap on the controller. The
// protocol uses named variables (ACT, GTO, POS, ...), with one request per line and one reply per request.
// Neither control of the arm nor a running program is needed. Stopping the arm does not affect the gripper,
// which keeps its grip. Source: the manufacturer's instruction manual (registers and their meaning), and the
// script of its URCap.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"

namespace tiller::io {

using tiller::operator<<;  // makes the enumerations below printable

inline constexpr int kRobotiqPort = 63352;
/// Maximum of positions, speeds and forces; the minimum is 0. Position 0 is open.
inline constexpr int kRobotiqMost = 255;

enum class RobotiqActivation { Reset = 0, Activating = 1, Active = 3 };
/// Object detection during the last motion.
enum class RobotiqObject { Moving = 0, StoppedOpening = 1, StoppedClosing = 2, AtDestination = 3 };
enum class RobotiqFault {
    None = 0x00,
    ActionDelayed = 0x05,  ///< motion requested during activation
    NotActivated = 0x07,   ///< motion requested before activation
    Temperature = 0x08,
    Communication = 0x09,
    UnderVoltage = 0x0A,
    ReleaseActive = 0x0B,  ///< opening or closing slowly (automatic release)
    Internal = 0x0C,
    Activation = 0x0D,
    Overcurrent = 0x0E,
    ReleaseFinished = 0x0F,  ///< reset and activation required
};

/// State reported by the gripper.
struct RobotiqState {
    RobotiqActivation activation = RobotiqActivation::Reset;
    RobotiqObject object = RobotiqObject::Moving;
    RobotiqFault fault = RobotiqFault::None;
    bool goTo = false;  ///< a motion was requested since activation; otherwise `object` is undefined
    int position = 0;   ///< 0 open ... 255 closed
    int requested = 0;  ///< last requested position

    /// True if the fingers hold an object from outside or inside.
    bool holds() const {
        return activation == RobotiqActivation::Active && goTo &&
               (object == RobotiqObject::StoppedClosing || object == RobotiqObject::StoppedOpening);
    }
    friend bool operator==(const RobotiqState&, const RobotiqState&) = default;
};

/// Threads  one at a time. There is no internal thread: every call blocks until the reply or the deadline.
/// Errors   of every call: NotConnected, ConnectionClosed, Timeout (the URCap does not respond), Cancelled. These
///          close the connection, because a late reply would be mistaken for the reply to the next request.
///          ProtocolError: an unexpected reply (see controllerMessage), or a register value that is not a byte. A
///          reply without a line end also closes the connection.
class RobotiqClient {
public:
    using Values = std::vector<std::pair<std::string, int>>;

    explicit RobotiqClient(Text host, int port = kRobotiqPort);
    ~RobotiqClient();
    RobotiqClient(const RobotiqClient&) = delete;
    RobotiqClient& operator=(const RobotiqClient&) = delete;

    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused (no URCap), Timeout, Cancelled
    Result<void> connect(const Deadline& deadline);
    void close();              ///< No effect without a connection.
    bool isConnected() const;  ///< Connection state after the last call.

    /// Reads a variable. Empty if the URCap has no value, because the gripper has no power or the variable
    /// does not exist.
    Result<std::optional<int>> get(const std::string& name, const Deadline& deadline);
    /// Sets several variables at once.
    /// Errors  Rejected: the reply was not an acknowledgement
    Result<void> set(const Values& values, const Deadline& deadline);

    /// Reads the complete state. Empty if the gripper has no power or its cable is disconnected.
    Result<std::optional<RobotiqState>> look(const Deadline& deadline);
    /// Resets the gripper and starts the activation, which opens and closes the fingers once and releases a
    /// held object. Use look() to find out when the activation is complete.
    /// Errors  Rejected: the gripper does not reset
    Result<void> beginActivation(const Deadline& deadline);
    /// Starts a motion, and returns when the gripper has accepted it. Until then, the reported state is that
    /// of the previous motion. Use look() to find out when and where the fingers stop.
    /// position, speed, force  0 ... 255
    /// Errors  InvalidArgument; Rejected: the gripper does not accept the request
    Result<void> move(int position, int speed, int force, const Deadline& deadline);
    /// Stops the fingers at their current position. A held object remains gripped. The next move() continues.
    Result<void> stop(const Deadline& deadline);

private:
    struct Link;
    std::unique_ptr<Link> d_;
};

}  // namespace tiller::io
