// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rows at the top of the jog column: frame, motion, turn and speed of the next press, chosen by a key, from a
// menu behind it, or entered by hand. Motion and turn are the lengths and the angles of steps: each row chooses for
// itself, and Hold in one is Hold in both.

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
    /// limits  asked for the greatest speed that can be entered
    explicit JogSelectors(std::function<control::MotionLimits()> limits, QWidget* parent = nullptr);

    const JogSelection& selection() const { return selection_; }

    /// The view's axes in the base frame. The frame "View" can be chosen once this was called.
    void setViewRotation(const Eigen::Matrix3d& R_base_view);
    /// The frames the fourth key of "Frame" offers.
    void setTaughtFrames(const QVector<TaughtFrame>& frames);
    /// Chooses one of them, as the fourth key of "Frame" does.
    void chooseTaughtFrame(const QUuid& frame);
    /// index  into speedClasses()
    void setSpeedClass(int index);
    /// A TCP speed entered by hand [m/s]; turns and joints in proportion.
    void setFreeSpeed(double tcpSpeed);
    /// A step entered by hand. Longer than 10 mm or 10 deg it runs only while the key is held.
    void setFreeStep(const StepSize& step);
    /// Only its length [m], or only its angle [rad]; the other one stays.
    void setStepLength(double length);
    void setStepAngle(double angle);
    /// Moves until the tool touches something with this force [N].
    void setUntilContact(double force);
    enum class Entry { Step, Turn, Speed, ContactForce };
    /// Opens the field in which the operator enters one of these by hand.
    void askFor(Entry entry);

    /// How high the keys are, and how far the rows are apart [px].
    void setRowHeight(int height, int spacing);
    /// The least height with such rows, whichever there are now.
    int heightWhen(int height, int spacing) const;
    /// Writes every figure again: the operator chose other units.
    void refreshTexts();

Q_SIGNALS:
    /// The selection is about to change, or something opens: no motion may go on.
    void changing(tiller::control::StopCause cause);
    /// The selection is another one now.
    void changed();

private:
    void connectControls();
    void chooseFrame(int segment);
    void showFrames();
    void offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill);
    void choose(MotionChoice motion);
    /// A key of the row of lengths or of angles.
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
    bool following_ = false;                  ///< the keys follow the selection, not a hand
    StepSize step_{0.001, toRadians(1.0)};    ///< chosen last, though Hold may be on
    StepSize other_{0.050, toRadians(45.0)};  ///< what the last key of each row stands for
    SegmentedControl* frame_ = nullptr;
    SegmentedControl* motion_ = nullptr;
    SegmentedControl* turn_ = nullptr;
    SegmentedControl* speed_ = nullptr;
};

}  // namespace tiller
