// SPDX-License-Identifier: MIT
#pragma once

// The robot and its services, owned by the simulator thread, and their processing cycle.

#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/servers/services.h"
#include "robot/simulator/simulator.h"

namespace tiller::simulator {

/// Threads  the simulator thread
struct ControllerServices {
    explicit ControllerServices(const SimulatorOptions& options);

    /// Accepts connections, reads requests and sends replies. Robot time does not advance.
    void service();
    void tick();
    void setRemoteControl(bool remote);

    ControllerModel plant;
    Services services;
    bool silent = false;  ///< no data are read or sent; connections stay open

private:
    std::uint64_t boots_ = 0;
};

}  // namespace tiller::simulator
