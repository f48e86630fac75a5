// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The page for trying out a gamepad or a SpaceMouse: what it says now, what becomes of it, and which way the
// arm would go. Here a device is switched on and off for jogging.

#include <QDialog>
#include <QTimer>
#include <functional>

#include "widgets/jog/device_jog.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace tiller {

class DeviceBars;

/// "X+ 34 mm/s, Rz− 5 °/s in Base"; empty when nothing would move.
QString whichWay(const JogSelection& selection, const Deflection& deflection,
                 const control::MotionLimits& limits);

class DeviceTrainer : public QDialog {
    Q_OBJECT

public:
    /// selection, limits  of the jog column and the session, asked at each refresh
    DeviceTrainer(DeviceJog& devices, std::function<JogSelection()> selection,
                  std::function<control::MotionLimits()> limits, QWidget* parent = nullptr);

    /// Shows what the chosen device says now. A timer does this 20 times a second.
    void refresh();
    QString directionText() const;

private:
    void listDevices();
    const InputDevice* chosen() const;

    DeviceJog& devices_;
    std::function<JogSelection()> selection_;
    std::function<control::MotionLimits()> limits_;
    QComboBox* list_;
    QLabel* hint_;
    DeviceBars* bars_;
    QLabel* deadMan_;
    QLabel* direction_;
    QString way_;  ///< what stands on it
    QCheckBox* use_;
    QCheckBox* dominant_;
    QTimer timer_;
};

}  // namespace tiller
