// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging with a gamepad or a SpaceMouse. A device moves the arm only after it has been selected with use(),
// and only while its enabling button is held. After a stop, the device must first return to neutral (see
// HoldRules).

#include <QMap>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "widgets/jog/axis_jog.h"
#include "widgets/jog/input_device.h"

namespace tiller {

/// Threads  GUI
class DeviceJog : public QObject {
    Q_OBJECT

public:
    explicit DeviceJog(AxisJog& jog, QObject* parent = nullptr);
    ~DeviceJog() override;

    /// Adds a source of devices, e.g. all gamepads. May be called several times.
    void addSource(std::unique_ptr<DeviceSource> source);
    const std::vector<std::unique_ptr<InputDevice>>& devices() const { return devices_; }

    /// The device that is selected to move the arm. Initially null, because the selection is not saved.
    const InputDevice* used() const { return used_; }
    void use(const InputDevice* device);
    /// Properties of the device, with the settings for its type.
    DeviceShape shape(const InputDevice& device) const;
    /// Applies settings, limited by sane(), to all devices of a type. Ends a motion that such a device
    /// commands.
    void tune(const QString& kind, const DeviceTuning& tuning);

    /// The latest reading of a device, and the input that results from it.
    DeviceReading reading(const InputDevice* device) const;
    Deflection wish(const InputDevice* device) const;

    /// Reads all devices once. Called by a timer every 10 ms, or by tests in virtual time.
    void poll();
    static constexpr int kPollMs = 10;
    void setClock(const Clock& clock);

Q_SIGNALS:
    /// Devices were added or removed, or a different device is in use.
    void devicesChanged();
    /// The device in use was disconnected.
    void lost(const QString& name);
    /// The device in use stopped reporting during a motion, and the motion was stopped. The device is still
    /// connected and must return to neutral.
    void stoppedReporting(const QString& name);
    void tuned(const QString& kind, const tiller::DeviceTuning& tuning);
    /// The stop button of the device in use was pressed.
    void stopPressed();

private:
    void look();
    void follow(const DeviceReading& now);
    std::chrono::nanoseconds maxReportInterval() const;

    AxisJog& jog_;
    const Clock* clock_ = &SteadyClock::shared();
    std::vector<std::unique_ptr<DeviceSource>> sources_;
    std::vector<std::unique_ptr<InputDevice>> devices_;
    std::vector<DeviceReading> readings_;  ///< one per device
    const InputDevice* used_ = nullptr;
    QMap<QString, DeviceTuning> tunings_;  ///< settings by device type; if missing, the defaults apply
    bool stopHeld_ = false;
    bool wasNeutral_ = false;   ///< true if the last input was neutral
    bool silent_ = false;       ///< true if the device is deflected but no longer reports
    std::int64_t heardNs_ = 0;  ///< time at which the device last reported [ns]
    QTimer pollTimer_;
    QTimer lookTimer_;
};

}  // namespace tiller
