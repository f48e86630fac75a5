// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The simulated robot inside the application: the first of 127.0.0.1, 127.0.0.2 ... whose standard ports are
// free, so that several windows and `tiller-cli simulate` live side by side.

#include <QList>
#include <memory>

#include "robot/core/result.h"
#include "robot/simulator/simulator.h"
#include "robot/station/link/robot_session.h"

namespace tiller::app {

class LocalSimulator {
public:
    /// Starts it, unless it runs already.
    /// Returns  where the session finds it
    /// Errors   Rejected when no loopback address has the ports free; AddressInvalid
    Result<RobotAddress> start();
    void stop();
    simulator::Simulator* controller() { return controller_.get(); }
    /// Counts another controller of this process as one of its own, until it is null again or this ends; it
    /// must run so long.
    void borrow(simulator::Simulator* controller) { borrowed_ = controller; }
    /// Those that run.
    QList<simulator::Simulator*> controllers() const;
    /// The one of them that a session is connected to; null when it is none of them.
    simulator::Simulator* controllerOf(const SessionState& state) const;

private:
    std::unique_ptr<simulator::Simulator> controller_;
    simulator::Simulator* borrowed_ = nullptr;
    RobotAddress address_;
};

}  // namespace tiller::app
