// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The simulated robot inside the application. It uses the first of the addresses 127.0.0.1, 127.0.0.2 ...
// with free standard ports, so that several windows and `tiller-cli simulate` can run at the same time.

#include <QList>
#include <memory>

#include "robot/core/result.h"
#include "robot/simulator/simulator.h"
#include "robot/station/link/robot_session.h"

namespace tiller::app {

class LocalSimulator {
public:
    /// Starts the simulated robot if it is not running.
    /// Returns  the address for the session
    /// Errors   Rejected if no loopback address has free ports; AddressInvalid
    Result<RobotAddress> start();
    void stop();
    simulator::Simulator* controller() { return controller_.get(); }
    /// Adds a controller that another part of this process owns. It must exist until null is passed or this
    /// object is destroyed.
    void borrow(simulator::Simulator* controller) { borrowed_ = controller; }
    /// All running controllers.
    QList<simulator::Simulator*> controllers() const;
    /// The controller to which a session is connected; null if the controller is not in controllers().
    simulator::Simulator* controllerOf(const SessionState& state) const;

private:
    std::unique_ptr<simulator::Simulator> controller_;
    simulator::Simulator* borrowed_ = nullptr;
    RobotAddress address_;
};

}  // namespace tiller::app
