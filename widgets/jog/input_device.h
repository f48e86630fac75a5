// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a gamepad or a SpaceMouse looks like to the rest: a name, how it is shaped, and what its axes and its
// dead-man say now. Tests bring their own.

#include <QString>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/joints.h"

namespace tiller {

/// How raw axes become a wish: what the operator may choose of it.
struct DeviceTuning {
    double deadZone = 0.08;     ///< of the full deflection
    double exponent = 1.0;      ///< of the curve beyond the dead zone
    bool dominantAxis = false;  ///< only the axis that is out furthest counts

    static constexpr double kLeastDeadZone = 0.03;
    static constexpr double kMostDeadZone = 0.50;
    static constexpr double kMostExponent = 4.0;
    /// Brought into the range of what makes sense; not a number becomes what it is at first.
    DeviceTuning sane() const;
    friend bool operator==(const DeviceTuning&, const DeviceTuning&) = default;
};

struct DeviceShape : DeviceTuning {
    QString kind;         ///< what is chosen for one of a kind holds for all: "gamepad"
    QString deadManName;  ///< what has to be held: "left shoulder"
    QString directions;   ///< which stick moves what, in a sentence
    /// A hand is never quite still: deflected and without a report for longer than this, the device or its
    /// driver hangs, and what it said last is nobody's wish any more. Longer than 100 ms it holds only as far
    /// as HoldBounds::silenceAt() lets the arm go.
    std::chrono::milliseconds silenceAtMost{100};
};

inline const QString kGamepadKind = QStringLiteral("gamepad");
inline const QString kSpaceMouseKind = QStringLiteral("spaceMouse");
/// As they are until somebody tunes them.
inline constexpr DeviceTuning kGamepadTuning{0.08, 2.2, false};
inline constexpr DeviceTuning kSpaceMouseTuning{0.10, 1.0, true};

struct DeviceReading {
    Vector6 axes = Vector6::Zero();  ///< X Y Z Rx Ry Rz of the jog frame, -1 ... 1, as the device gives them
    bool deadMan = false;
    bool stop = false;  ///< a key that stops whatever moves
    bool fresh = true;  ///< the device has reported something since it was read last
};

/// Threads  GUI
class InputDevice {
public:
    virtual ~InputDevice() = default;
    virtual QString name() const = 0;
    virtual DeviceShape shape() const = 0;
    /// Its state now; nothing when it is gone for good.
    virtual std::optional<DeviceReading> read() = 0;
};

/// Finds devices.
/// Threads  GUI
class DeviceSource {
public:
    virtual ~DeviceSource() = default;
    /// Devices that have appeared since the last call.
    virtual std::vector<std::unique_ptr<InputDevice>> appeared() = 0;
};

/// A reading with dead zone, curve and dominant axis applied.
Vector6 shaped(const Vector6& axes, const DeviceTuning& tuning);

}  // namespace tiller
