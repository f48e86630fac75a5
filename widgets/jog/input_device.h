// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interface to gamepads and SpaceMouse devices: name, properties, and the current state of the axes and the
// enabling button. Tests provide simulated devices.

#include <QString>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/joints.h"

namespace tiller {

/// Adjustable conversion of raw axis values to an input.
struct DeviceTuning {
    double deadZone = 0.08;     ///< dead zone as a fraction of the full deflection
    double exponent = 1.0;      ///< exponent of the response curve outside the dead zone
    bool dominantAxis = false;  ///< use only the axis with the largest deflection

    static constexpr double kMinDeadZone = 0.03;
    static constexpr double kMaxDeadZone = 0.50;
    static constexpr double kMaxExponent = 4.0;
    /// Returns the settings limited to valid ranges. NaN is replaced by the default.
    DeviceTuning sane() const;
    friend bool operator==(const DeviceTuning&, const DeviceTuning&) = default;
};

struct DeviceShape : DeviceTuning {
    QString kind;         ///< device type, e.g. "gamepad"; all devices of a type share the settings
    QString deadManName;  ///< name of the enabling button, e.g. "left bumper"
    QString directions;   ///< the axes and their motions, as a sentence
    /// Maximum time between two reports of a deflected device, because a hand is never perfectly still. If it
    /// is exceeded, the device or its driver has hung, and the last value is invalid. During a motion,
    /// HoldBounds::holdTimeoutNs also limits this time.
    std::chrono::milliseconds maxReportInterval{100};
};

inline const QString kGamepadKind = QStringLiteral("gamepad");
inline const QString kSpaceMouseKind = QStringLiteral("spaceMouse");
/// Default settings.
inline constexpr DeviceTuning kGamepadTuning{0.08, 2.2, false};
inline constexpr DeviceTuning kSpaceMouseTuning{0.10, 1.0, true};

struct DeviceReading {
    Vector6 axes = Vector6::Zero();  ///< raw values of X Y Z Rx Ry Rz in the jog frame, -1 ... 1
    bool deadMan = false;
    bool stop = false;  ///< button that stops any motion
    bool fresh = true;  ///< true if the device has reported since the last reading
};

/// Threads  GUI
class InputDevice {
public:
    virtual ~InputDevice() = default;
    virtual QString name() const = 0;
    virtual DeviceShape shape() const = 0;
    /// The current state of the device; empty if the device was disconnected.
    virtual std::optional<DeviceReading> read() = 0;
};

/// Detects devices.
/// Threads  GUI
class DeviceSource {
public:
    virtual ~DeviceSource() = default;
    /// Returns the devices connected since the last call.
    virtual std::vector<std::unique_ptr<InputDevice>> appeared() = 0;
};

/// Applies dead zone, curve and dominant axis.
Vector6 shaped(const Vector6& axes, const DeviceTuning& tuning);

}  // namespace tiller
