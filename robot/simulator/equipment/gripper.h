// SPDX-License-Identifier: MIT
#pragma once

// A two-finger gripper of Robotiq: activation, moves with speed and force, contact with objects, automatic
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
    /// Places an object that stops the fingers at 0 (open) to 255 (closed), from either side.
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
    double position_ = 3;        ///< 0..255; fully open fingers are at 3 of 255
    double activationTime_ = 0;  ///< [s] since the start of the activation
    std::optional<int> object_;
    int contact_ = 0;  ///< the fingers press on the object: 1 closing, -1 opening, 0 no contact
};

}  // namespace tiller::simulator
