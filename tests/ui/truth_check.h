// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks that the window displays the real state: header (robot mode, safety mode, speed slider), joints and
// outputs are compared with the state of the simulated controller. A value may be missing or old if the window
// marks it: grey "NO DATA", "–", "pending…", or late data in the connection chip.

#include <QList>
#include <QString>
#include <QWidget>

#include "robot/simulator/simulator.h"

namespace tiller::test {

struct Lie {
    QString text;     ///< displayed and actual value
    int graceMs = 0;  ///< minimum duration of an error [ms]
};

class TruthCheck {
public:
    /// Time from a change on the robot until it is displayed [ms].
    static constexpr int kGraceMs = 300;
    /// The speed slider keeps the user's value until the robot had time to follow [ms].
    static constexpr int kSliderSettlesMs = 800;
    /// Time from a disconnection until data count as late [ms].
    static constexpr int kStaleMs = 300;

    /// `window`: has the header, joints and outputs; must outlive the check.
    explicit TruthCheck(const QWidget& window) : window_(window) {}

    /// `standing`: the arm has come to rest, so the header must not show motion any more.
    QList<Lie> lies(const simulator::SimulatedState& truth, bool standing);
    /// Number of displayed values that were compared so far: a window that marks everything as unknown would pass
    /// otherwise.
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
