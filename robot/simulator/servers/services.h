// SPDX-License-Identifier: MIT
#pragma once

// All services of one controller. The set of services depends on the software: PolyScope X has the Robot API
// instead of the dashboard.

#include <memory>
#include <vector>

#include "robot/simulator/equipment/device_server.h"
#include "robot/simulator/equipment/gripper_server.h"
#include "robot/simulator/net/link.h"
#include "robot/simulator/options/simulator_options.h"
#include "robot/simulator/programs/program_store.h"
#include "robot/simulator/servers/primary/primary_server.h"
#include "robot/simulator/servers/primary/realtime_server.h"
#include "robot/simulator/servers/rtde/rtde_server.h"
#include "robot/simulator/servers/service/dashboard_server.h"
#include "robot/simulator/servers/service/fault_server.h"
#include "robot/simulator/servers/service/interpreter_server.h"
#include "robot/simulator/servers/service/robot_api_server.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class Services {
public:
    /// faults  processes the lines received on the fault port
    Services(ControllerModel& plant, FaultServer::Handler faults);

    /// Opens all ports, or none in case of an error.
    /// Errors  same as Listener::open()
    Result<void> open(const SimulatorOptions& options);
    void close();
    Ports ports() const;

    /// Reads data from all clients and sends replies. Does not advance time. Excludes the fault port.
    void service();
    /// Advances the gripper by one control period, and sends the results of the period to all clients.
    void publish();
    /// Closes all connections except those of the fault port.
    void closeClients();
    /// Closes the script connections, as a robot does when it changes to local control.
    void closeScriptClients();

    RtdeServer& rtde() { return rtde_; }
    const RtdeServer& rtde() const { return rtde_; }
    GripperServer& gripper() { return gripper_; }
    /// Returns the device with this name, or null.
    DeviceServer* device(const QString& name) const;
    /// Sets whether the device accepts connections and replies. A device that refuses connections does not
    /// listen.
    /// Errors  same as Listener::open()
    Result<void> setPresence(DeviceServer& device, DeviceServer::Presence presence);
    FaultServer& faults() { return faults_; }
    Link& link() { return link_; }

private:
    struct Entry {
        Server* server;
        std::uint16_t Ports::*port;
        const char* name;
    };
    Result<void> openDevice(DeviceServer& device);
    Result<void> openOne(const Entry& entry, const QHostAddress& address, const SimulatorOptions& options);

    ControllerModel& plant_;
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
    std::vector<std::unique_ptr<DeviceServer>> devices_;
    std::vector<Entry> all_;  ///< all services; the fault port is last
};

}  // namespace tiller::simulator
