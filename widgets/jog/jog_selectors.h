// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rows at the top of the jog column: frame, motion, rotation and speed of the next press, selected by a button,
// in its menu, or entered manually. Motion and rotation are the lengths and angles of steps: each row has a
// separate selection, except that Hold applies to both.

#include <QVector>
#include <QWidget>
#include <functional>

#include "robot/station/jog/jog_motion.h"

class QMenu;

namespace tiller {

class SegmentedControl;

class JogSelectors : public QWidget {
    Q_OBJECT

public:
    /// limits  returns the maximum speed that can be entered
    explicit JogSelectors(std::function<control::MotionLimits()> limits, QWidget* parent = nullptr);

    const JogSelection& selection() const { return selection_; }

    /// The axes of the view in the base frame. Enables the frame "View".
    void setViewRotation(const Eigen::Matrix3d& R_base_view);
    /// The frames offered by the fourth button of "Frame".
    void setTaughtFrames(const QVector<TaughtFrame>& frames);
    /// Selects a frame, as the fourth button of "Frame".
    void chooseTaughtFrame(const QUuid& frame);
    /// index  index into speedClasses()
    void setSpeedClass(int index);
    /// A TCP speed entered manually [m/s]; rotation and joint speeds in proportion.
    void setFreeSpeed(double tcpSpeed);
    /// A step entered manually. Above 10 mm or 10 deg it runs only while the button is held.
    void setFreeStep(const StepSize& step);
    /// Changes only the length [m] or only the angle [rad].
    void setStepLength(double length);
    void setStepAngle(double angle);
    /// Moves until contact with this force [N].
    void setUntilContact(double force);
    enum class Entry { Step, Turn, Speed, ContactForce };
    /// Opens the field for entering one of these values.
    void askFor(Entry entry);

    /// Height of the buttons, and spacing of the rows [px].
    void setRowHeight(int height, int spacing);
    /// Minimum height with such rows.
    int heightWhen(int height, int spacing) const;
    /// Updates all numbers after a change of units.
    void refreshTexts();

Q_SIGNALS:
    /// Emitted before the selection changes or a menu opens: the current motion must end.
    void changing(tiller::control::StopCause cause);
    /// The selection has changed.
    void changed();

private:
    void connectControls();
    void chooseFrame(int segment);
    void showFrames();
    void offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill);
    void choose(MotionChoice motion);
    /// Handles a click on a button of the length or angle row.
    void chooseStep(double StepSize::*size, int segment);
    void fillLengthMenu(QMenu& menu);
    void fillAngleMenu(QMenu& menu);
    void fillSpeedMenu(QMenu& menu);
    void askForNumber(const QString& text, double value, double least, double most, int digits,
                      std::function<void(double)> use);

    std::function<control::MotionLimits()> limits_;
    JogSelection selection_;
    QVector<TaughtFrame> frames_;
    bool hasView_ = false;
    bool following_ = false;                  ///< true while the program updates the buttons
    StepSize step_{0.001, toRadians(1.0)};    ///< last selected step, even if Hold is active
    StepSize other_{0.050, toRadians(45.0)};  ///< values of the last button of each row
    SegmentedControl* frame_ = nullptr;
    SegmentedControl* motion_ = nullptr;
    SegmentedControl* turn_ = nullptr;
    SegmentedControl* speed_ = nullptr;
};

}  // namespace tiller
