// SPDX-License-Identifier: MIT
#pragma once

// A Robotiq two-finger gripper: activation, moves with speed and force, contact with objects, automatic
// release, and faults. Provides its variables by name, like the gripper service on a robot. Source:
// instruction manual of the manufacturer (registers). For the protocol, see gripper_server.h.

#include <optional>
#include <string_view>

namespace tiller::simulator {

class Gripper {
public:
    /// Sets a variable, clamped to its range. Returns false if it does not exist or cannot be set.
    bool set(std::string_view name, int value);
    /// Returns the value of a variable; empty if it does not exist.
    std::optional<int> get(std::string_view name) const;
    /// Places an object that stops the fingers at `position`, 0 (open) to 255 (closed), in either direction.
    void setObject(std::optional<int> position) { object_ = position; }

    void step(double dt);

private:
    enum Status { kReset = 0, kActivating = 1, kActive = 3 };
    enum Object { kMoving = 0, kStoppedOpening = 1, kStoppedClosing = 2, kAtDestination = 3 };
    enum Fault { kNone = 0, kDelayed = 5, kNotActivated = 7, kReleasing = 11, kReleased = 15 };

    /// True from the start of an automatic release until a reset.
    bool isReleased() const { return fault_ == kReleasing || fault_ == kReleased; }
    bool setAside(std::string_view name, int value);
    void activate(bool active);
    void move(double target, double speed, double dt);
    double fingerSpeed() const;

    int activated_ = 0, goTo_ = 0, release_ = 0;
    int releaseDirection_ = 0;  ///< 0 closing, 1 opening
    int requested_ = 0, speed_ = 255, force_ = 150;
    int status_ = kReset;
    int objectStatus_ = kMoving;
    int fault_ = kNone;
    int lights_[4] = {};         ///< values of LBP, LRD, LBL, LGN
    int currentLimit_ = 0;       ///< [10 mA]
    double position_ = 3;        ///< 0..255; at 3, the fingers are fully open
    double activationTime_ = 0;  ///< time since the start of the activation [s]
    std::optional<int> object_;
    int contact_ = 0;  ///< direction in which the object blocks: 1 closing, -1 opening, 0 no contact
};

}  // namespace tiller::simulator
