// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a gamepad or a SpaceMouse looks like to the rest: a name, how it is shaped, and what its axes and its
// dead-man say now. Tests bring their own.

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/joints.h"

namespace tiller {

/// How raw axes become a wish.
struct DeviceShape {
    double deadZone = 0.08;     ///< of the full deflection
    double exponent = 1.0;      ///< of the curve beyond the dead zone
    bool dominantAxis = false;  ///< only the axis that is out furthest counts
    QString deadManName;        ///< what has to be held: "left shoulder"
    QString directions;         ///< which stick moves what, in a sentence
};

struct DeviceReading {
    Vector6 axes = Vector6::Zero();  ///< X Y Z Rx Ry Rz of the jog frame, -1 ... 1, as the device gives them
    bool deadMan = false;
    bool stop = false;  ///< a key that stops whatever moves
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

/// Finds devices. Threads  GUI
class DeviceSource {
public:
    virtual ~DeviceSource() = default;
    /// Devices that have appeared since the last call.
    virtual std::vector<std::unique_ptr<InputDevice>> appeared() = 0;
};

/// A reading with dead zone, curve and dominant axis applied.
Vector6 shaped(const Vector6& axes, const DeviceShape& shape, bool dominantAxis);

}  // namespace tiller
