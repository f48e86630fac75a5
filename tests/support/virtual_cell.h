// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A robot and a session with a common virtual clock, with real sockets and real threads, but not in real
// time. Robot and session advance in lock-step, so that the result of a test does not depend on the speed of
// the computer.

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
    /// clock, session  must outlive the cell; the session must have been created with the clock
    /// robot           simulator options, based on options()
    VirtualCell(VirtualClock& clock, RobotSession& session,
                const simulator::SimulatorOptions& robot = options());
    /// Options for a UR5e in virtual time that is powered on with released brakes, at a loopback address of
    /// this process.
    static simulator::SimulatorOptions options();
    ~VirtualCell();

    /// Starts the robot and connects to it. Returns false if no data arrive; what() then returns the reason.
    bool connect();
    /// Like connect(), and takes control. Returns false on failure; what() then returns the reason.
    bool bringUp();
    QString what() const { return what_; }

    /// Advances robot, clock and session. In every control period, the robot sends, and receiver and
    /// controller reply. The session refreshes every 16 ms. `everyRefresh` runs every 20 ms, like a timer of
    /// the user interface.
    void advanceMs(int ms);
    /// Advances until the condition is true, but at most for this virtual time.
    bool advanceUntil(const std::function<bool()>& condition, int atMostMs);
    /// Like advanceMs(), but without `everyRefresh`, refreshes of the session and user interface events, as
    /// if the window were hanging.
    void advanceWithFrozenInterface(int ms);

    std::function<void()> everyRefresh;

    VirtualClock& clock;
    RobotSession& session;
    simulator::Simulator robot;

    simulator::SimulatedState truth() const { return robot.truth(); }

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

/// Distance of the TCP between two poses [mm].
double distanceMm(const Pose& a, const Pose& b);

}  // namespace tiller::test
