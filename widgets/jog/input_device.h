// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interface to gamepads and SpaceMouse: name, properties, and the current axes and enabling button. Tests
// provide simulated devices.

#include <QString>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/joints.h"

namespace tiller {

/// Conversion of raw axes to an input, adjustable by the user.
struct DeviceTuning {
    double deadZone = 0.08;     ///< fraction of the full deflection
    double exponent = 1.0;      ///< exponent of the curve outside of the dead zone
    bool dominantAxis = false;  ///< only the axis with the largest deflection is used

    static constexpr double kMinDeadZone = 0.03;
    static constexpr double kMaxDeadZone = 0.50;
    static constexpr double kMaxExponent = 4.0;
    /// Limited to valid ranges; NaN is replaced by the default.
    DeviceTuning sane() const;
    friend bool operator==(const DeviceTuning&, const DeviceTuning&) = default;
};

struct DeviceShape : DeviceTuning {
    QString kind;         ///< the settings apply to all devices of a type: "gamepad"
    QString deadManName;  ///< name of the enabling button, e.g. "left bumper"
    QString directions;   ///< axes and their motions, in a sentence
    /// A hand is never perfectly still. If a deflected device does not report for this time, the device or
    /// its driver hangs and its last value is invalid. Values above 100 ms are limited by
    /// HoldBounds::holdTimeoutAt().
    std::chrono::milliseconds maxReportInterval{100};
};

inline const QString kGamepadKind = QStringLiteral("gamepad");
inline const QString kSpaceMouseKind = QStringLiteral("spaceMouse");
/// Defaults of the settings.
inline constexpr DeviceTuning kGamepadTuning{0.08, 2.2, false};
inline constexpr DeviceTuning kSpaceMouseTuning{0.10, 1.0, true};

struct DeviceReading {
    Vector6 axes = Vector6::Zero();  ///< X Y Z Rx Ry Rz of the jog frame, -1 ... 1, raw values
    bool deadMan = false;
    bool stop = false;  ///< button that stops any motion
    bool fresh = true;  ///< the device has reported since the last reading
};

/// Threads  GUI
class InputDevice {
public:
    virtual ~InputDevice() = default;
    virtual QString name() const = 0;
    virtual DeviceShape shape() const = 0;
    /// The current state of the device; empty after it was disconnected.
    virtual std::optional<DeviceReading> read() = 0;
};

/// Detects devices.
/// Threads  GUI
class DeviceSource {
public:
    virtual ~DeviceSource() = default;
    /// Devices connected since the last call.
    virtual std::vector<std::unique_ptr<InputDevice>> appeared() = 0;
};

/// Applies dead zone, curve and dominant axis.
Vector6 shaped(const Vector6& axes, const DeviceTuning& tuning);

}  // namespace tiller
