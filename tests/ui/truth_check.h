// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks that the window displays the actual state. Header (robot mode, safety mode, speed slider), joints
// and outputs are compared with the state of the simulated controller. A value may be missing or outdated if
// the window indicates it by a grey "NO DATA", "–", "pending…", or late data in the connection chip.

#include <QList>
#include <QString>
#include <QWidget>

#include "robot/simulator/simulator.h"

namespace tiller::test {

struct Lie {
    QString text;     ///< displayed value and actual value
    int graceMs = 0;  ///< duration after which the difference counts as an error [ms]
};

class TruthCheck {
public:
    /// Maximum time from a change on the robot until the change is displayed [ms].
    static constexpr int kGraceMs = 300;
    /// Time for which the speed slider keeps the user's value, so that the robot can follow [ms].
    static constexpr int kSliderSettlesMs = 800;
    /// Time from a disconnection until data count as late [ms].
    static constexpr int kStaleMs = 300;

    /// window  contains the header, joints and outputs; must outlive the check
    explicit TruthCheck(const QWidget& window) : window_(window) {}

    /// standing  true after the arm has stopped; the header must then not show motion
    QList<Lie> lies(const simulator::SimulatedState& truth, bool standing);
    /// Number of displayed values compared so far. Without this count, a window that marks every value as
    /// unknown would pass.
    int compared() const { return compared_; }

private:
    void checkModes(const simulator::SimulatedState& truth, bool standing, QList<Lie>& lies);
    void checkJoints(const simulator::SimulatedState& truth, QList<Lie>& lies);
    void checkOutputs(const simulator::SimulatedState& truth, QList<Lie>& lies);
    bool isMarked() const;

    const QWidget& window_;
    int compared_ = 0;
};

}  // namespace tiller::test
