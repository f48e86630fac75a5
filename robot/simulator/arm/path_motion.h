// SPDX-License-Identifier: MIT
#pragma once

// Executes planned moves: in sequence, blended, or started while an earlier motion decelerates. The result is
// always the sum of two motions: the rest of the old one (which alone would end at rest at the corner) and
// the new one (which alone would start there). Position and velocity are continuous by construction, and the
// sum stays inside the blend zone.

#include "robot/simulator/arm/path_segment.h"

namespace tiller::simulator::arm {

/// State of the arm after a step that has not been committed yet.
struct PathCandidate {
    Vector6 q = Vector6::Zero();
    Vector6 rateProgram = Vector6::Zero();  ///< dq by program time
    Vector6 rateReal = Vector6::Zero();  ///< dq by real time: the part that decays regardless of program time
    bool reached = true;                 ///< false: the tool path cannot be followed here
    Vector6 currentQ = Vector6::Zero();  ///< of each of the two motions
    Vector6 tailQ = Vector6::Zero();
};

class PathMotion {
public:
    PathMotion(const ArmGeometry& geometry, double period) : geometry_(geometry), period_(period) {}

    bool active() const { return active_; }
    void drop() { active_ = tailActive_ = nextWaiting_ = false; }

    /// Starts from rest. With `runOut` the arm is still moving: it decelerates along it and stops at the
    /// start of `segment`.
    void start(const Segment& segment);
    void start(const Segment& segment, const Segment& runOut);

    /// True if a move can be blended into the current one.
    bool acceptsNext() const;
    bool nextWaiting() const { return nextWaiting_; }
    /// `segment` starts where the current one ends. `switchTime`: time of the current one at which it starts.
    void setNext(const Segment& segment, double switchTime);

    /// Computes the step for `dt` [s] of real and `dtProgram` of program time.
    void evaluate(double dt, double dtProgram, PathCandidate& candidate);
    /// Executes that step.
    void commit(double dt, double dtProgram, const PathCandidate& candidate);

    const Segment& current() const { return current_; }
    const Segment& goal() const { return nextWaiting_ ? next_ : current_; }
    /// True if the command of `current` may return: its blend zone begins within the next one or two periods.
    bool currentReturned(double timeScale) const;
    bool finished() const;
    bool followsTool() const {
        return active_ && (current_.inToolSpace || (tailActive_ && tail_.inToolSpace) ||
                           (nextWaiting_ && next_.inToolSpace));
    }
    /// Returns true for a single joint move or stop: every joint stays between its start and its target.
    bool withinItsEnds() const { return !tailActive_ && !current_.inToolSpace; }

    /// To be called before each step: starts the next move at its switch time.
    void prepare(double dtProgramMax);

private:
    bool evaluateSegment(const Segment& segment, double time, Vector6& q, Vector6& rate);
    bool evaluateToolSum(double tailTime, double time, PathCandidate& candidate);

    const ArmGeometry& geometry_;
    double period_;
    Segment current_;
    Segment tail_;
    Segment next_;
    bool active_ = false;
    bool tailActive_ = false;
    bool tailIsRunOut_ = false;
    bool nextWaiting_ = false;
    double switchTime_ = 0;
    Vector6 q_ = Vector6::Zero();
    Posture posture_;
};

}  // namespace tiller::simulator::arm
