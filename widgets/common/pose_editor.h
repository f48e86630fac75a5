// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A pose in six figures, to be read and to be typed, in the units and the notation chosen in the settings.

#include <QWidget>
#include <array>

#include "robot/core/spatial.h"

namespace tiller {

class FigureBox;

class PoseEditor : public QWidget {
    Q_OBJECT

public:
    /// name    its boxes are the objects name.x ... name.rz
    /// spoken  what the position is of: "Origin", "TCP"
    /// advice  what typing does, one sentence, for the tool tips
    PoseEditor(const QString& name, const QString& spoken, const QString& advice, QWidget* parent = nullptr);

    void setPose(const Pose& pose);
    /// The first box, with its figure selected.
    void editFirst();

Q_SIGNALS:
    /// A figure was finished. The other five keep the digits that are not shown.
    void poseEntered(const tiller::Pose& pose);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showFigures();
    void take(int figure);

    Pose pose_;
    std::array<FigureBox*, 6> boxes_{};
    std::array<double, 6> shown_{};
};

}  // namespace tiller
