// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A robot and a session that share one virtual clock: real sockets, real threads, no real time. Robot and
// session advance in lock-step, so a test gives the same result on a fast and on a slow machine.

#include <QObject>
#include <functional>
#include <memory>

#include "robot/core/clock.h"
#include "robot/receive/sample.h"
#include "robot/simulator/simulator.h"
#include "robot/station/link/robot_session.h"

namespace tiller::test {

class VirtualCell {
public:
    /// Both must outlive the cell; the session must have been made with the clock.
    /// robot  what it shall be like; options() with whatever is to be different
    VirtualCell(VirtualClock& clock, RobotSession& session,
                const simulator::SimulatorOptions& robot = options());
    /// A UR5e, powered, brakes released, in virtual time, at a loopback address of this process.
    static simulator::SimulatorOptions options();
    ~VirtualCell();

    /// Starts the robot and connects to it.
    /// Returns  false when there were no data; what() says why
    bool connect();
    /// The same, and takes control.
    /// Returns  false when any of it did not happen; what() says which
    bool bringUp();
    QString what() const { return what_; }

    /// Advances robot, clock and session. Every control period the robot sends, receiver and controller
    /// answer; every 16 ms the session refreshes and events are processed; every 80 ms windows repaint; every
    /// 20 ms `everyRefresh` runs, in place of a timer of the interface.
    void advanceMs(int ms);
    /// Until the condition holds, at most so long in virtual time.
    bool advanceUntil(const std::function<bool()>& condition, int atMostMs);
    /// As advanceMs, but the interface does nothing meanwhile: a window that hangs.
    void advanceWithFrozenInterface(int ms);

    std::function<void()> everyRefresh;

    VirtualClock& clock;
    RobotSession& session;
    simulator::Simulator robot;

    simulator::Truth truth() const { return robot.truth(); }

private:
    void tick();
    void awaitFirstAnswers(std::uint64_t inputs);
    void interfaceTurn();

    class PaintDelay;

    int portOffset_;
    std::unique_ptr<PaintDelay> paintDelay_;
    QString what_;
    int sinceRefresh_ = 0;
    int sincePump_ = 0;
    std::uint64_t inputsBeforeTaking_ = 0;
    receive::Sample newest_;
};

/// Path the TCP went between two poses, in a straight line [mm].
double distanceMm(const Pose& a, const Pose& b);

}  // namespace tiller::test
