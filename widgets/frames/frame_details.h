// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The lower end of the tab: the selected frame in figures, to be read and to be typed. Typing moves nothing
// but the frame.

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

    /// waypoints  how many move with it
    void setFrame(const std::optional<project::Frame>& frame, int waypoints);
    /// Nothing while there are no data.
    void setTcp(const std::optional<Pose>& T_base_tcp);
    void editFigures();

    QString headline() const;

Q_SIGNALS:
    /// The operator finished a figure: the frame shall stand here.
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
