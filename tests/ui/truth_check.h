// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Does the window tell the truth? Header (robot mode, safety mode, speed slider), joints and outputs are held
// against what the simulated controller is really doing. A value may be missing or old as long as the window
// marks it: grey "NO DATA", "–", "pending…", or the link's chip that says that data are late.

#include <QList>
#include <QString>
#include <QWidget>

#include "robot/simulator/simulator.h"

namespace tiller::test {

struct Lie {
    QString text;     ///< what is shown and what is true
    int graceMs = 0;  ///< it is one when it has stood for so long [ms]
};

class TruthCheck {
public:
    /// From a change on the robot until it shows [ms].
    static constexpr int kGraceMs = 300;
    /// The speed slider stays where a hand left it until the robot has had time to follow [ms].
    static constexpr int kSliderSettlesMs = 800;
    /// After a cut, until data count as late [ms].
    static constexpr int kStaleMs = 300;

    /// window  with header, joints and outputs; must outlive the check
    explicit TruthCheck(const QWidget& window) : window_(window) {}

    /// standing  the arm has come to rest: the header must not call it moving any more
    QList<Lie> lies(const simulator::Truth& truth, bool standing);
    /// Values that were shown as known and held against the truth, since the beginning: a window that marks
    /// all as unknown says nothing wrong, and nothing.
    int compared() const { return compared_; }

private:
    void checkModes(const simulator::Truth& truth, bool standing, QList<Lie>& lies);
    void checkJoints(const simulator::Truth& truth, QList<Lie>& lies);
    void checkOutputs(const simulator::Truth& truth, QList<Lie>& lies);
    bool isMarked() const;

    const QWidget& window_;
    int compared_ = 0;
};

}  // namespace tiller::test
