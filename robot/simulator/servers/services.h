// SPDX-License-Identifier: MIT
#pragma once

// All services of one controller, opened and served together.

#include "robot/simulator/controller.h"
#include "robot/simulator/servers/dashboard_server.h"
#include "robot/simulator/servers/interpreter_server.h"
#include "robot/simulator/servers/primary_server.h"
#include "robot/simulator/servers/realtime_server.h"
#include "robot/simulator/servers/rtde_server.h"

namespace tiller::simulator {

/// Threads  the simulator's.
class Services {
public:
    explicit Services(Plant& plant);

    /// Opens all ports or none. Errors as Listener::open().
    Result<void> open(const ControllerOptions& options);
    void close();
    Ports ports() const;

    /// Reads all clients and answers; no time passes.
    void service();
    /// Sends what the last control period brought.
    void publish();
    void closeClients();
    /// What leaving or entering remote control does to the connections of a robot that gates them.
    void closeScriptClients();

    const RtdeServer& rtde() const { return rtde_; }

private:
    struct Entry {
        Server* server;
        std::uint16_t Ports::*port;
        const char* name;
    };
    /// Of the simulated software.
    bool exists(const Entry& entry) const;
    static constexpr std::size_t kCount = 9;

    Plant& plant_;
    DashboardServer dashboard_;
    PrimaryServer primary_, secondary_, primaryReadOnly_, secondaryReadOnly_;
    RealtimeServer realtime_, realtimeReadOnly_;
    RtdeServer rtde_;
    InterpreterServer interpreter_;
    Entry all_[kCount];
};

}  // namespace tiller::simulator
