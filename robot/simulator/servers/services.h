// SPDX-License-Identifier: MIT
#pragma once

// All services of one controller, opened and served together. Which there are depends on the software:
// PolyScope X has the Robot API in place of the dashboard.

#include <vector>

#include "robot/simulator/equipment/gripper_server.h"
#include "robot/simulator/programs/program_store.h"
#include "robot/simulator/servers/net/link.h"
#include "robot/simulator/servers/primary/primary_server.h"
#include "robot/simulator/servers/primary/realtime_server.h"
#include "robot/simulator/servers/rtde/rtde_server.h"
#include "robot/simulator/servers/service/dashboard_server.h"
#include "robot/simulator/servers/service/fault_server.h"
#include "robot/simulator/servers/service/interpreter_server.h"
#include "robot/simulator/servers/service/robot_api_server.h"
#include "robot/simulator/simulator.h"

namespace tiller::simulator {

/// Threads  the simulator's.
class Services {
public:
    /// faults  answers the lines of the fault port
    Services(Plant& plant, FaultServer::Handler faults);

    /// Opens all ports or none. Errors as Listener::open().
    Result<void> open(const SimulatorOptions& options);
    void close();
    Ports ports() const;

    /// Reads all clients and answers; no time passes. The fault port is served apart.
    void service();
    /// Sends what the last control period brought.
    void publish();
    /// Ends all connections but those of the fault port.
    void closeClients();
    /// What leaving or entering remote control does to the connections of a robot that gates them.
    void closeScriptClients();

    RtdeServer& rtde() { return rtde_; }
    const RtdeServer& rtde() const { return rtde_; }
    GripperServer& gripper() { return gripper_; }
    FaultServer& faults() { return faults_; }
    Link& link() { return link_; }

private:
    struct Entry {
        Server* server;
        std::uint16_t Ports::*port;
        const char* name;
    };
    Result<void> openOne(const Entry& entry, const QHostAddress& address, const SimulatorOptions& options);

    Plant& plant_;
    Link link_;
    ProgramStore store_;
    DashboardServer dashboard_;
    RobotApiServer robotApi_;
    PrimaryServer primary_, secondary_, primaryReadOnly_, secondaryReadOnly_;
    RealtimeServer realtime_, realtimeReadOnly_;
    RtdeServer rtde_;
    InterpreterServer interpreter_;
    GripperServer gripper_;
    FaultServer faults_;
    std::vector<Entry> all_;  ///< the fault port last
};

}  // namespace tiller::simulator
