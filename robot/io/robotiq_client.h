// SPDX-License-Identifier: MIT
#pragma once

// A Robotiq gripper at the robot's wrist, through the socket that its URCap opens on the controller: variables
// by name (ACT, GTO, POS, ...), one line out, one answer back. The controller of the arm need not be in our
// hands, no program has to run, and a stop of the arm does not reach the gripper: it goes on holding.
// Source: the maker's instruction manual (registers and their meaning), and its URCap's own script.

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

using tiller::operator<<;  // for the enumerations below

inline constexpr int kRobotiqPort = 63352;
/// Positions, speeds and forces go from 0 to this; position 0 is open.
inline constexpr int kRobotiqMost = 255;

enum class RobotiqActivation { Reset = 0, Activating = 1, Active = 3 };
/// What the fingers met, of the motion asked for last.
enum class RobotiqObject { Moving = 0, StoppedOpening = 1, StoppedClosing = 2, AtDestination = 3 };
enum class RobotiqFault {
    None = 0x00,
    ActionDelayed = 0x05,  ///< asked to move while it is being activated
    NotActivated = 0x07,   ///< asked to move before it was
    Temperature = 0x08,
    Communication = 0x09,
    UnderVoltage = 0x0A,
    ReleaseActive = 0x0B,  ///< opens or closes slowly, by its automatic release
    Internal = 0x0C,
    Activation = 0x0D,
    Overcurrent = 0x0E,
    ReleaseFinished = 0x0F,  ///< has to be reset and activated
};

/// What the gripper says of itself, in one look.
struct RobotiqState {
    RobotiqActivation activation = RobotiqActivation::Reset;
    RobotiqObject object = RobotiqObject::Moving;
    RobotiqFault fault = RobotiqFault::None;
    bool goTo = false;  ///< a motion was asked for since the activation: without one, `object` means nothing
    int position = 0;   ///< 0 open ... 255 closed
    int requested = 0;  ///< where it was sent last

    /// The fingers press on something, from outside or from inside.
    bool holds() const {
        return activation == RobotiqActivation::Active && goTo &&
               (object == RobotiqObject::StoppedClosing || object == RobotiqObject::StoppedOpening);
    }
    friend bool operator==(const RobotiqState&, const RobotiqState&) = default;
};

/// Threads  one at a time. Has no thread of its own; every call blocks until the answer or the deadline.
/// Errors   of every call: NotConnected, ConnectionClosed, Timeout (the URCap is mute), Cancelled. After one
///          of them the connection is closed, because a late answer would be taken for that to the next line.
///          ProtocolError: another answer than was asked for, which is in controllerMessage, or a register
///          that is no byte. After an answer without an end the connection is closed too
class RobotiqClient {
public:
    using Values = std::vector<std::pair<std::string, int>>;

    explicit RobotiqClient(Text host, int port = kRobotiqPort);
    ~RobotiqClient();
    RobotiqClient(const RobotiqClient&) = delete;
    RobotiqClient& operator=(const RobotiqClient&) = delete;

    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused (no URCap), Timeout, Cancelled
    Result<void> connect(const Deadline& deadline);
    void close();              ///< Harmless when not connected.
    bool isConnected() const;  ///< As of the last call.

    /// Nothing where the URCap has no value: the gripper is without power, or there is no such variable.
    Result<std::optional<int>> get(const std::string& name, const Deadline& deadline);
    /// Several at once.
    /// Errors  Rejected: anything but an acknowledgement came back
    Result<void> set(const Values& values, const Deadline& deadline);

    /// Reads all of RobotiqState; nothing where the gripper is without power or its cable is out.
    Result<std::optional<RobotiqState>> look(const Deadline& deadline);
    /// Resets it and begins the activation, which opens and closes the fingers once: what they hold is let go.
    /// look() tells when it is over.
    /// Errors  Rejected: it does not become reset
    Result<void> beginActivation(const Deadline& deadline);
    /// Sends the fingers somewhere, and returns when the gripper has taken that: before, its state is that of
    /// an earlier motion. look() tells when and where they stand.
    /// position, speed, force  0 ... 255
    /// Errors  InvalidArgument; Rejected: it does not take the request
    Result<void> move(int position, int speed, int force, const Deadline& deadline);
    /// Lets the fingers stand where they are; what they hold they go on holding. The next move() goes on.
    Result<void> stop(const Deadline& deadline);

private:
    struct Link;
    std::unique_ptr<Link> d_;
};

}  // namespace tiller::io
