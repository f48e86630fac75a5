// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Teaches a frame from three points. The points are recorded one after the other at the TCP position. Shows
// which point is next, the distance of the TCP from the recorded points, and the reason if the points do not
// define a frame.

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

    /// Starts teaching.
    /// make  label of the finish button
    void begin(const QString& title, const QString& make);
    /// tip       TCP position in the base frame [m]; empty if no point can be recorded
    /// obstacle  the reason why no point can be recorded
    void setTip(const std::optional<Eigen::Vector3d>& tip, const QString& obstacle);
    /// Records the next missing point. If none is missing, records the last point again. If the first two
    /// points are too close to each other, records the second point again.
    void takeNext();
    /// Emits made() if the points define a frame.
    void finish();

    /// The frame defined by the recorded points. If only the third point is missing, the current TCP position
    /// is used instead.
    std::optional<Pose> preview() const;
    QString feedback() const;

Q_SIGNALS:
    /// Emitted before a point is recorded. A directly connected slot must call setTip() with the newest data.
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
