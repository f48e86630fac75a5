// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Displays and edits a pose as six numbers, in the units and notation of the settings.

#include <QWidget>
#include <array>

#include "robot/core/spatial.h"

namespace tiller {

class DecimalSpinBox;

class PoseEditor : public QWidget {
    Q_OBJECT

public:
    /// name    prefix of the object names: name.x ... name.rz
    /// spoken  name for screen readers, e.g. "Origin" or "TCP"
    /// advice  sentence for the tooltips about the effect of editing
    PoseEditor(const QString& name, const QString& spoken, const QString& advice, QWidget* parent = nullptr);

    void setPose(const Pose& pose);
    /// Sets the focus to the first box and selects its text.
    void editFirst();

Q_SIGNALS:
    /// The user has edited a value. The other five values keep their full precision.
    void poseEntered(const tiller::Pose& pose);

protected:
    void changeEvent(QEvent* event) override;

private:
    void updateValueTexts();
    void take(int figure);

    Pose pose_;
    std::array<DecimalSpinBox*, 6> boxes_{};
    std::array<double, 6> shown_{};
};

}  // namespace tiller
