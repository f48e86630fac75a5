// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Three points, one after the other, each where the TCP is when its key is pressed. It says at any time what
// is still missing, how far the tip is, and what is wrong with points that make no frame.

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

    /// Begins anew. make  label of the key that finishes it
    void begin(const QString& title, const QString& make);
    /// The TCP in the base frame [m]; nothing, and why, when no point can be taken.
    void setTip(const std::optional<Eigen::Vector3d>& tip, const QString& obstacle);
    /// The next point that is missing; the last one again when none is.
    void takeNext();
    /// Tells made() if the points make a frame.
    void finish();

    /// The frame of the points taken; with the tip in place of the one that is missing, if only one is.
    std::optional<Pose> preview() const;
    QString feedback() const;

Q_SIGNALS:
    /// A point is about to be taken: setTip() with the newest data, before this returns.
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
