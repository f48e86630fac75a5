// SPDX-License-Identifier: MIT
#pragma once

// Executes planned moves in sequence, blended, or started while an earlier motion decelerates. Where two
// motions overlap, the result is their sum: the end of the previous motion, which alone would come to rest at
// the corner, and the start of the next motion, which alone would start from rest there. Position and
// velocity are continuous by construction, and the sum stays inside the blend zone. A rounded corner of movep
// is part of the path of the next move and does not overlap the previous move.

#include "robot/simulator/arm/path_segment.h"

namespace tiller::simulator::arm {

/// State of the arm after a step that has not been committed yet.
struct PathCandidate {
    Vector6 q = Vector6::Zero();
    Vector6 rateProgram = Vector6::Zero();  ///< derivative of q with respect to program time
    Vector6 rateReal = Vector6::Zero();     ///< derivative of q with respect to real time; decays regardless
                                            ///< of program time
    bool reached = true;                    ///< false: the tool path cannot be followed at this position
    Vector6 currentQ = Vector6::Zero();     ///< joint positions of each of the two motions
    Vector6 tailQ = Vector6::Zero();
};

class PathMotion {
public:
    PathMotion(const ArmGeometry& geometry, double period) : geometry_(geometry), period_(period) {}

    bool active() const { return active_; }
    void drop() { active_ = tailActive_ = nextWaiting_ = false; }

    /// Starts from rest. With `runOut`, the arm is still moving: it decelerates along `runOut`, which ends at
    /// the start of `segment`.
    void start(const Segment& segment);
    void start(const Segment& segment, const Segment& runOut);

    /// True if another move can be blended into the current move.
    bool acceptsNext() const;
    bool nextWaiting() const { return nextWaiting_; }
    /// Sets the next segment, which starts where the current segment ends.
    /// switchTime  time within the current segment at which `segment` starts [s]
    void setNext(const Segment& segment, double switchTime);

    /// Computes the step for `dt` [s] of real time and `dtProgram` [s] of program time.
    void evaluate(double dt, double dtProgram, PathCandidate& candidate);
    /// Executes the step computed by evaluate().
    void commit(double dt, double dtProgram, const PathCandidate& candidate);

    const Segment& current() const { return current_; }
    const Segment& goal() const { return nextWaiting_ ? next_ : current_; }
    /// True if the command of the current segment may return: its blend zone begins within the next one or
    /// two periods.
    bool currentReturned(double timeScale) const;
    bool finished() const;
    bool followsTool() const {
        return active_ && (current_.inToolSpace || (tailActive_ && tail_.inToolSpace) ||
                           (nextWaiting_ && next_.inToolSpace));
    }
    /// True for a single joint move or stop. Every joint then stays between its start and its target.
    bool withinItsEnds() const { return !tailActive_ && !current_.inToolSpace; }

    /// Starts the next move at its switch time. Must be called before each step.
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
