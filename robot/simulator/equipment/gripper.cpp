// SPDX-License-Identifier: MIT
#include "robot/simulator/equipment/gripper.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator {

namespace {

// End positions and speeds of the fingers of a real gripper. Source: instruction manual of the 2F-85 (20 to
// 150 mm/s over 85 mm). 85 mm correspond to 255 steps.
constexpr double kFullyOpen = 3;
constexpr double kFullyClosed = 230;
constexpr double kSlowest = 20.0 / 85.0 * 255.0;   ///< [steps/s]
constexpr double kFastest = 150.0 / 85.0 * 255.0;  ///< [steps/s]
/// Duration of the closing and opening motion of an activation [s].
constexpr double kActivationTime = 1.2;
constexpr double kReleaseSpeed = kSlowest;
constexpr std::string_view kLights[] = {"LBP", "LRD", "LBL", "LGN"};

}  // namespace

bool Gripper::set(std::string_view name, int value) {
    const int byte = std::clamp(value, 0, 255);
    const int bit = value != 0 ? 1 : 0;
    if (name == "ACT") {
        activate(bit != 0);
    } else if (name == "GTO") {
        goTo_ = bit;
    } else if (name == "ATR") {
        release_ = bit;
    } else if (name == "ARD" || name == "ADR") {
        releaseDirection_ = bit;
    } else if (name == "POS") {
        requested_ = byte;
    } else if (name == "SPE") {
        speed_ = byte;
    } else if (name == "FOR") {
        force_ = byte;
    } else {
        return setAside(name, byte);
    }
    if (goTo_ != 0 && (name == "POS" || name == "GTO") && !isReleased()) {
        if (status_ == kActive) {
            objectStatus_ = kMoving;
        } else {
            fault_ = status_ == kActivating ? kDelayed : kNotActivated;
        }
    }
    return true;
}

// Sets variables that have no effect on the motion.
bool Gripper::setAside(std::string_view name, int value) {
    for (std::size_t i = 0; i < std::size(kLights); ++i) {
        if (name == kLights[i]) {
            lights_[i] = value;
            return true;
        }
    }
    if (name == "MSC") {
        currentLimit_ = value;
        return true;
    }
    return name == "SID" || name == "MOD" || name == "SCN_BLOCK";  // accepted without effect
}

void Gripper::activate(bool active) {
    if (!active) {
        activated_ = 0;
        status_ = kReset;
        objectStatus_ = kMoving;
        fault_ = kNone;
        goTo_ = 0;
    } else if (activated_ == 0) {
        activated_ = 1;
        status_ = kActivating;
        activationTime_ = 0;
        fault_ = kNone;
    }
}

std::optional<int> Gripper::get(std::string_view name) const {
    const struct {
        std::string_view name;
        int value;
    } all[] = {
        {"ACT", activated_},
        {"GTO", goTo_},
        {"ATR", release_},
        {"ARD", releaseDirection_},
        {"ADR", releaseDirection_},
        {"FOR", force_},
        {"SPE", speed_},
        {"POS", static_cast<int>(std::lround(position_))},
        {"STA", status_},
        {"PRE", requested_},
        {"OBJ", objectStatus_},
        {"FLT", fault_},
        {"COU", 0},
        {"MSC", currentLimit_},
        {"MOD", 0},
        {"SID", 9},
    };
    for (const auto& variable : all) {
        if (variable.name == name) {
            return variable.value;
        }
    }
    return std::nullopt;
}

double Gripper::fingerSpeed() const {
    return kSlowest + (kFastest - kSlowest) * speed_ / 255.0;
}

void Gripper::move(double target, double speed, double dt) {
    const double end = std::clamp(target, kFullyOpen, kFullyClosed);
    const double before = position_;
    const bool closing = end > before;
    const double next = closing ? std::min(end, before + speed * dt) : std::max(end, before - speed * dt);
    const int direction = closing ? 1 : -1;
    if (object_ && end != before) {
        const double at = *object_;
        const bool meets = closing ? before < at && next >= at : before > at && next <= at;
        if (meets || (before == at && contact_ == direction)) {
            position_ = at;
            contact_ = direction;
            objectStatus_ = closing ? kStoppedClosing : kStoppedOpening;
            return;
        }
    }
    contact_ = 0;
    position_ = next;
    objectStatus_ = position_ == end ? kAtDestination : kMoving;
}

void Gripper::step(double dt) {
    if (release_ != 0 && activated_ != 0 && !isReleased()) {
        // The status stays kReset until the gripper is activated again.
        status_ = kReset;
        fault_ = kReleasing;
    }
    if (fault_ == kReleasing) {
        move(releaseDirection_ != 0 ? kFullyOpen : kFullyClosed, kReleaseSpeed, dt);
        fault_ = objectStatus_ == kMoving ? kReleasing : kReleased;
    } else if (status_ == kActivating) {
        activationTime_ += dt;
        // During activation, the gripper closes, opens and measures its range.
        const double part = activationTime_ / kActivationTime;
        position_ =
            kFullyOpen + (kFullyClosed - kFullyOpen) * (part < 0.5 ? 2 * part : std::max(0.0, 2 - 2 * part));
        if (part >= 1) {
            position_ = kFullyOpen;
            status_ = kActive;
            fault_ =
                fault_ == kDelayed ? kNone : fault_;  // requests received in the meantime are executed next
        }
    } else if (status_ == kActive && goTo_ != 0 && fault_ == kNone) {
        move(requested_, fingerSpeed(), dt);
    }
}

}  // namespace tiller::simulator
