// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rows at the top of the jog column: frame, motion, rotation and speed of the next press. The user
// selects a value with a button or in the menu of a button, or enters it. The rows "Motion" and "Rotation"
// contain the step lengths and the step angles. Each row has a separate selection, except that Hold applies
// to both rows.

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

    /// Sets the axes of the view in the base frame, and enables the frame "View".
    void setViewRotation(const Eigen::Matrix3d& R_base_view);
    /// Sets the frames for the fourth button of "Frame".
    void setTaughtFrames(const QVector<TaughtFrame>& frames);
    /// Selects a taught frame. Equivalent to the fourth button of "Frame".
    void chooseTaughtFrame(const QUuid& frame);
    /// index  index into speedClasses()
    void setSpeedClass(int index);
    /// Sets a custom TCP speed [m/s]. Rotation and joint speeds are proportional to it.
    void setFreeSpeed(double tcpSpeed);
    /// Sets a custom step. A step above 10 mm or 10 deg continues only while the button is held.
    void setFreeStep(const StepSize& step);
    /// Changes only the length [m] or only the angle [rad].
    void setStepLength(double length);
    void setStepAngle(double angle);
    /// Selects moving until contact with this force [N].
    void setUntilContact(double force);
    enum class Entry { Step, Turn, Speed, ContactForce };
    /// Opens the input field for this value.
    void askFor(Entry entry);

    /// Sets the height of the buttons and the spacing of the rows [px].
    void setRowHeight(int height, int spacing);
    /// Minimum height with rows of this height and spacing [px].
    int heightWhen(int height, int spacing) const;
    /// Updates all numbers after a change of units.
    void refreshTexts();

Q_SIGNALS:
    /// The selection is about to change, or a menu is about to open, so the current motion must end.
    void changing(tiller::control::StopCause cause);
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
    bool following_ = false;                  ///< true while the code updates the buttons
    StepSize step_{0.001, toRadians(1.0)};    ///< last selected step, kept while Hold is selected
    StepSize other_{0.050, toRadians(45.0)};  ///< custom step of the last button in each row
    SegmentedControl* frame_ = nullptr;
    SegmentedControl* motion_ = nullptr;
    SegmentedControl* turn_ = nullptr;
    SegmentedControl* speed_ = nullptr;
};

}  // namespace tiller
