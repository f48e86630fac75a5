// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The page for testing a gamepad or a SpaceMouse. It shows the current values, the resulting input, and the
// direction of the arm. The user enables and disables devices for jogging on this page.

#include <QDialog>
#include <QTimer>
#include <functional>

#include "widgets/jog/device_jog.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace tiller {

class DeviceBars;

/// Describes the motion, e.g. "X+ 34 mm/s, Rz− 5 °/s in Base". Empty if the arm would not move.
QString motionText(const JogSelection& selection, const Deflection& deflection,
                   const control::MotionLimits& limits);

class DeviceTrainer : public QDialog {
    Q_OBJECT

public:
    /// selection, limits  return the selection of the jog column and the limits of the session; called at
    /// each refresh
    DeviceTrainer(DeviceJog& devices, std::function<JogSelection()> selection,
                  std::function<control::MotionLimits()> limits, QWidget* parent = nullptr);

    /// Updates the display of the selected device. Called by a timer 20 times per second.
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
    QString directionText_;
    QCheckBox* use_;
    QCheckBox* dominant_;
    QTimer timer_;
};

}  // namespace tiller
