// SPDX-License-Identifier: MIT
#pragma once

// Options of the simulated controller: its identity, network address, time mode and behaviour.

#include <QString>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/robot_model.h"
#include "robot/core/text.h"
#include "robot/core/version.h"
#include "robot/simulator/options/assumptions.h"

namespace tiller::simulator {

using tiller::operator<<;  // makes the enumerations below printable

enum class Time { Real, Virtual };

/// The start pose of the vendor's simulated UR5e [rad]. Source: its first primary package.
inline const JointPositions kHomeJoints{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

struct SimulatorOptions {
    RobotModelId model = RobotModelId::UR5e;
    SoftwareVersion software{5, 22, 1, 1214193};
    Text listenAddress = QStringLiteral("127.0.0.1");
    int portOffset = 0;         ///< added to every standard port
    bool anyFreePorts = false;  ///< the system assigns the ports; call ports() after start()
    Time time = Time::Real;
    bool poweredOn = false;  ///< start in RUNNING, brakes released
    JointPositions startJoints = kHomeJoints;
    std::optional<int> priority = {};  ///< requested SCHED_FIFO priority of the thread; empty: normal
    std::uint64_t seed = 1;            ///< seed for measurement noise and random() of scripts
    bool remoteControl = true;         ///< initial state of the Local/Remote switch
    bool gateLocalControl =
        false;  ///< refuse the same requests as a robot in Local control (the vendor's simulator does not)
    bool gateLoopbackClients = false;  ///< refuse dashboard clients on this PC too
    bool fastTransitions = false;      ///< each step of power on and brake release takes 10 ms
    double startTime = 60.0;  ///< `timestamp` at start [s]; below 40, some clients wait for the boot to end
    double bootTime = 0;      ///< time from the start to POWER_OFF [s]; above 0, `timestamp` starts at 0
    bool safetyUnconfirmed = false;  ///< the start waits in CONFIRM_SAFETY for the operator
    double calibration =
        0;  ///< maximum deviation of the arm from its nominal model [mm and mrad]; reported to clients
    /// Maximum deviation of the reported calibration from the actual arm [mm and mrad].
    double calibrationError = 0;
    Text programsFolder = {};  ///< folder for `load`; empty: no program files
    Text urcapsFolder = {};    ///< additional stand-ins for URCap nodes, see README.md; empty: none
    struct Device {
        Text name;
        Text file;  ///< response table, see equipment/device_table.h
    };
    std::vector<Device> devices = {};  ///< devices on the network of the robot
    Text serialNumber = {};            ///< empty: the default for the model
    /// If no data have arrived for this time, the script of an External Control node is complete.
    std::chrono::milliseconds scriptSilence{150};
    BehaviourOptions assumptions = {};  ///< options for undocumented behaviour of real controllers
};

/// Port numbers in use. 0: not started, or the software version does not have the service.
struct Ports {
    std::uint16_t dashboard = 29999;
    std::uint16_t primary = 30001;
    std::uint16_t secondary = 30002;
    std::uint16_t realtime = 30003;
    std::uint16_t rtde = 30004;
    std::uint16_t primaryReadOnly = 30011;
    std::uint16_t secondaryReadOnly = 30012;
    std::uint16_t realtimeReadOnly = 30013;
    std::uint16_t interpreter = 30020;  ///< 0 for software without interpreter mode
    std::uint16_t robotApi = 80;        ///< HTTP, PolyScope X only; 8080 if the system reserves port 80
    std::uint16_t gripper = 63352;      ///< Robotiq gripper
    std::uint16_t faults = 29990;       ///< fault injection, see faults.h

    static constexpr Ports none() { return {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}; }
};

/// The newest RTDE data package that a client can read.
struct RtdeDelivery {
    std::uint16_t port = 0;  ///< port of the client
    double timestamp = 0;    ///< time stamp of the package [s]
};

}  // namespace tiller::simulator
