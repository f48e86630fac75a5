// SPDX-License-Identifier: MIT
#pragma once

// The steps of a running program, from the step register in consecutive robot samples. Steps shorter than the
// sample interval can be missing.

#include <vector>

#include "robot/core/modes.h"
#include "robot/station/program/preview/preview.h"

namespace tiller::program {

class StepLog {
public:
    /// steps  number of steps of the script
    explicit StepLog(int steps = 0) : timings_(static_cast<std::size_t>(steps)) {}

    /// Adds a sample. Samples have no effect before the start of the program, while another program ends, and
    /// after its end.
    /// time   time stamp of the robot [s]
    /// value  value of the step register
    /// gate   value of script::kGateRegister
    void add(double time, RuntimeState runtime, int value, int gate = 0);

    int step() const { return step_; }             ///< Number of the running or waiting step; 0: none.
    bool isWaiting() const { return isWaiting_; }  ///< True while the program waits before step().
    int begun() const { return begun_; }           ///< Number of steps that have begun, with repetitions.
    int lastStep() const { return last_; }         ///< Number of the last step that was running; 0: none.
    int failedStep() const { return failed_; }     ///< Number of the step that ended the program; 0: none.
    double seconds() const { return time_; }       ///< Duration of the run so far [s].
    bool hasBegun() const { return phase_ != Phase::Before && phase_ != Phase::Stopped; }
    bool hasEnded() const { return phase_ == Phase::Ended; }
    /// True if the program was stopped before its end. A program that reaches its end resets the step
    /// register.
    bool isCutShort() const { return hasEnded() && value_ > 0; }
    /// True while the program is paused on the teach pendant or by another client.
    bool isPausedOnRobot() const { return isPausedOnRobot_; }
    /// One per step; step number 1 is at index 0. Times are relative to the start of the program. The
    /// totals exclude the time for which the program waits before a step.
    const std::vector<StepTiming>& timings() const { return timings_; }

private:
    enum class Phase { Before, Stopped, Running, Ended };
    void follow(int value);

    Phase phase_ = Phase::Before;
    int settling_ = 0;  ///< samples to ignore, because the register may still have an old value
    double began_ = 0;  ///< time stamp of the start [s]
    double time_ = 0;
    int step_ = 0;
    bool isWaiting_ = false;
    int begun_ = 0;
    int last_ = 0;
    int failed_ = 0;
    int value_ = 0;  ///< newest value of the step register
    bool isPausedOnRobot_ = false;
    std::vector<StepTiming> timings_;
};

}  // namespace tiller::program
