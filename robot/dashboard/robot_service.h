// SPDX-License-Identifier: MIT
#pragma once

// What a person does at the pendant and a PC can do too: power, recovery, programs. One face for the two ways
// there are, the dashboard server of CB3 and e-Series and the Robot API of PolyScope X; which of them a robot
// has is found out by asking it.

#include <QString>
#include <memory>
#include <optional>

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/robot_api_client.h"
#include "robot/dashboard/robot_command.h"

namespace tiller::dashboard {

/// What RTDE does not tell.
struct ServiceReport {
    ServiceKind kind = ServiceKind::Unknown;
    std::optional<bool> remoteControl;  ///< nothing where the software does not say
    QString operationalMode;            ///< "MANUAL", "AUTOMATIC"; empty: none set, or not said
    QString program;                    ///< loaded on the robot; empty: none, or not said
};

/// Threads  one at a time. Every call blocks until the reply or the deadline.
/// Errors   of every call: those of the client behind it; VersionUnsupported for what offers() denies
class RobotService {
public:
    virtual ~RobotService() = default;

    virtual ServiceKind kind() const = 0;  ///< Dashboard or Robot API.
    /// False once the way to the robot is gone: it takes openService() again.
    virtual bool isConnected() = 0;

    /// Returns when the controller has taken the command.
    virtual Result<void> perform(RobotCommand command, const Deadline& deadline) = 0;
    /// Only ever on a person's explicit word: the manufacturer forbids automatic reset.
    virtual Result<void> unlockProtectiveStop(const Deadline& deadline) = 0;
    /// name  as the controller's programs folder has it; PolyScope X takes it with and without its ending
    virtual Result<void> loadProgram(const Text& name, const Deadline& deadline) = 0;
    /// What RTDE does not tell: control mode, operational mode, loaded program.
    virtual Result<ServiceReport> look(const Deadline& deadline) = 0;
};

struct ServiceAddress {
    Text host;
    int dashboardPort = kDashboardPort;
    int robotApiPort = kRobotApiPort;
};

/// Where the services of a robot listen whose ports are all moved by the same number.
ServiceAddress serviceAt(const Text& host, int portOffset = 0);

/// Connects to the dashboard, or, where there is none, to the Robot API.
/// Errors   of the dashboard where neither answers: AddressInvalid, HostUnreachable, ConnectionRefused,
///          Timeout, Cancelled
Result<std::unique_ptr<RobotService>> openService(const ServiceAddress& address, const Deadline& deadline);

}  // namespace tiller::dashboard
