// SPDX-License-Identifier: MIT
#pragma once

// A two-finger gripper of Robotiq: activation, moves with speed and force, contact with objects, automatic release,
// faults; and its variables by name, as served by the gripper program on a robot.
// Source: instruction manual of the manufacturer (registers); protocol: see gripper_server.h.

#include <optional>
#include <string_view>

namespace tiller::simulator {

class Gripper {
public:
    /// Sets a variable, held to its range. False when there is no such variable or it cannot be set.
    bool set(std::string_view name, int value);
    /// Nothing when there is no such variable.
    std::optional<int> get(std::string_view name) const;
    /// Something that stops the fingers at 0 (open) to 255 (closed), on the way there from either side.
    void setObject(std::optional<int> position) { object_ = position; }

    void step(double dt);

private:
    enum Status { kReset = 0, kActivating = 1, kActive = 3 };
    enum Object { kMoving = 0, kStoppedOpening = 1, kStoppedClosing = 2, kAtDestination = 3 };
    enum Fault { kNone = 0, kDelayed = 5, kNotActivated = 7, kReleasing = 11, kReleased = 15 };

    /// An automatic release has begun, and no reset has come since.
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
    int lights_[4] = {};         ///< LBP, LRD, LBL, LGN
    int currentLimit_ = 0;       ///< [10 mA]
    double position_ = 3;        ///< 0..255; fingers wide open stand at 3 of 255
    double activationTime_ = 0;  ///< [s] since it began
    std::optional<int> object_;
    int contact_ = 0;  ///< the fingers press on the object: 1 closing, -1 opening, 0 not
};

}  // namespace tiller::simulator
