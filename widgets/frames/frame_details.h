// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Details of the selected frame below the table, as editable numbers. Editing changes only the frame.

#include <QWidget>
#include <optional>

#include "robot/project/waypoint.h"

class QLabel;

namespace tiller {

class ElidedLabel;
class PoseEditor;

class FrameDetails : public QWidget {
    Q_OBJECT

public:
    explicit FrameDetails(QWidget* parent = nullptr);

    /// waypoints  number of waypoints that move with the frame
    void setFrame(const std::optional<project::Frame>& frame, int waypoints);
    /// Sets the TCP pose; empty without data.
    void setTcp(const std::optional<Pose>& T_base_tcp);
    void editValues();

    QString headline() const;

Q_SIGNALS:
    /// The user has edited a value of the pose.
    void placeEntered(const tiller::Pose& T_base_frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void showFacts();

    std::optional<project::Frame> frame_;
    int waypoints_ = 0;
    std::optional<Pose> tcp_;
    QLabel* name_;
    ElidedLabel* facts_;
    PoseEditor* pose_;
};

}  // namespace tiller
