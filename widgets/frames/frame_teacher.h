// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Teaches a frame by three points, recorded one after the other at the TCP position. Shows the next point, the
// distance of the TCP, and problems of points that do not define a frame.

#include <QWidget>
#include <array>
#include <optional>

#include "robot/project/frame_points.h"

class QLabel;
class QPushButton;

namespace tiller {

class ElidedLabel;

class FrameTeacher : public QWidget {
    Q_OBJECT

public:
    explicit FrameTeacher(QWidget* parent = nullptr);

    /// Starts teaching. make  label of the finish button
    void begin(const QString& title, const QString& make);
    /// The TCP in the base frame [m]; empty, with the reason, if no point can be recorded.
    void setTip(const std::optional<Eigen::Vector3d>& tip, const QString& obstacle);
    /// The next missing point; the last one if none is missing.
    void takeNext();
    /// Emits made() if the points define a frame.
    void finish();

    /// The frame of the recorded points; if only one is missing, with the TCP in its place.
    std::optional<Pose> preview() const;
    QString feedback() const;

Q_SIGNALS:
    /// A point is about to be recorded: call setTip() with the newest data before returning.
    void tipWanted();
    void made(const tiller::Pose& T_base_frame);
    void cancelled();
    void previewChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::optional<Eigen::Vector3d>& point(int index);
    int nextMissing() const;
    void take(int index);
    void refresh();

    project::FramePoints points_;
    std::optional<Eigen::Vector3d> tip_;
    QString obstacle_;
    QLabel* title_;
    std::array<ElidedLabel*, 3> places_{};
    std::array<QPushButton*, 3> keys_{};
    QLabel* feedback_;
    QPushButton* cancel_;
    QPushButton* make_;
};

}  // namespace tiller
