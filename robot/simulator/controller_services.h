// SPDX-License-Identifier: MIT
#pragma once

// Objects owned by the simulator thread: the robot and its services, which it runs in a cycle.

#include "robot/simulator/box/controller_model.h"
#include "robot/simulator/servers/services.h"
#include "robot/simulator/simulator.h"

namespace tiller::simulator {

/// Threads  the simulator thread
struct ControllerServices {
    explicit ControllerServices(const SimulatorOptions& options);

    /// Accepts connections, reads requests and sends replies. Does not advance time.
    void service();
    /// Runs one control period.
    void tick();
    void setRemoteControl(bool remote);

    ControllerModel plant;
    Services services;
    bool silent = false;  ///< nothing is read or sent; connections stay open

private:
    std::uint64_t boots_ = 0;
};

}  // namespace tiller::simulator
