// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jogging with a gamepad or a SpaceMouse. A device moves the arm only after it was switched on here, only
// while its dead-man is held, and after any stop only once it has come back to neutral; see HoldRules for the
// rules.

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

    /// Where devices come from. May be called several times.
    void addSource(std::unique_ptr<DeviceSource> source);
    const std::vector<std::unique_ptr<InputDevice>>& devices() const { return devices_; }

    /// The device that moves the arm, or null. Never remembered: after a start none does.
    const InputDevice* used() const { return used_; }
    void use(const InputDevice* device);
    /// The device's shape, with what was chosen for its kind.
    DeviceShape shape(const InputDevice& device) const;
    /// Chooses for all devices of a kind, in sane(); ends their motion.
    void tune(const QString& kind, const DeviceTuning& tuning);

    /// The newest reading of a device, and what it asks for.
    DeviceReading reading(const InputDevice* device) const;
    Deflection wish(const InputDevice* device) const;

    /// Reads all devices once. A timer does this every 10 ms; tests in virtual time do it themselves.
    void poll();
    static constexpr int kPollMs = 10;
    void setClock(const Clock& clock);

Q_SIGNALS:
    /// Devices have come or gone, or another one is used.
    void devicesChanged();
    /// The device in use disappeared.
    void lost(const QString& name);
    /// The device in use moved the arm and said nothing any more: what it moved was stopped. It is still
    /// there, and has to come back to neutral.
    void fellSilent(const QString& name);
    void tuned(const QString& kind, const tiller::DeviceTuning& tuning);
    /// The stop key of the device in use.
    void stopPressed();

private:
    void look();
    void follow(const DeviceReading& now);
    std::chrono::nanoseconds silenceAtMost() const;

    AxisJog& jog_;
    const Clock* clock_ = &SteadyClock::shared();
    std::vector<std::unique_ptr<DeviceSource>> sources_;
    std::vector<std::unique_ptr<InputDevice>> devices_;
    std::vector<DeviceReading> readings_;  ///< one for each device
    const InputDevice* used_ = nullptr;
    QMap<QString, DeviceTuning> tunings_;  ///< by kind; what is not in it is as the device is at first
    bool stopHeld_ = false;
    bool wasNeutral_ = false;   ///< what it asked for last
    bool silent_ = false;       ///< deflected, and hangs
    std::int64_t heardNs_ = 0;  ///< its last report
    QTimer pollTimer_;
    QTimer lookTimer_;
};

}  // namespace tiller
