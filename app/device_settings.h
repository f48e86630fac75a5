// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Settings for gamepads and SpaceMouse devices: the device that moves the arm, dead zone, sensitivity curve,
// and restriction to the dominant axis.

#include <QMap>
#include <QWidget>

#include "widgets/jog/input_device.h"

class QComboBox;
class QLabel;

namespace tiller {

class DeviceJog;

namespace app {

class DeviceSettings : public QWidget {
    Q_OBJECT

public:
    explicit DeviceSettings(DeviceJog& devices, const QMap<QString, DeviceTuning>& chosen,
                            QWidget* parent = nullptr);

Q_SIGNALS:
    void tuningChosen(const QString& kind, const tiller::DeviceTuning& tuning);
    /// The user wants to open the device test page.
    void trainerWanted();

private:
    QWidget* buildKind(const QString& kind, const QString& title, const DeviceTuning& first);
    void listDevices();

    DeviceJog& devices_;
    QMap<QString, DeviceTuning> chosen_;
    QComboBox* used_;
    QLabel* there_;
};

}  // namespace app
}  // namespace tiller
