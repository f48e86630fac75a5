// SPDX-License-Identifier: MIT
#pragma once

// Interface through which the control box accesses the running programs: their state, and the requests to
// stop, pause and resume.

#include <cstdint>

#include "robot/core/modes.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class RunningPrograms {
public:
    /// State of the main program.
    virtual RuntimeState state() const = 0;
    /// True in any state except Stopped.
    bool isActive() const { return state() != RuntimeState::Stopped; }
    bool isPaused() const { return state() == RuntimeState::Paused; }
    virtual std::uint32_t currentLine() const = 0;
    /// True if the program that is ending is the main program. The host calls this function within a frame.
    virtual bool isEndingMain() const = 0;

    /// Ends the main program in the next period.
    virtual void requestStop() = 0;
    /// Ends the main program within this call.
    virtual void stopNow() = 0;
    virtual void pause() = 0;
    virtual void resume() = 0;
    /// Handles a protective stop. A program from a file waits for `play`. By default, a program sent over a
    /// socket ends and must be sent again, see BehaviourOptions::protectiveStop. Source: Dashboard Server
    /// guide, "unlock protective stop"; the ROS 2 driver, which sends the program again.
    virtual void haltForProtectiveStop() = 0;

protected:
    ~RunningPrograms() = default;
};

}  // namespace tiller::simulator
