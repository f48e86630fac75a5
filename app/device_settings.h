// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of gamepads and SpaceMouse: which one moves the arm, how far a stick has to be pushed before
// it counts, how gently it begins, and whether only its main axis counts.

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
    /// The page on which a device is tried out.
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
