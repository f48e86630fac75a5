// SPDX-License-Identifier: MIT
#pragma once

// Pendant functions that are also available to a PC: power, recovery, programs. Provides a common interface
// for the dashboard server of CB3 and e-Series and the Robot API of PolyScope X, and detects which service is
// available.

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/robot_api_client.h"
#include "robot/dashboard/robot_command.h"

namespace tiller::dashboard {

/// Values that RTDE does not report.
struct ServiceReport {
    ServiceKind kind = ServiceKind::Unknown;
    std::optional<bool> remoteControl;  ///< empty if the software does not report it
    QString operationalMode;            ///< "MANUAL", "AUTOMATIC"; empty: not set or not reported
    QString program;                    ///< loaded on the robot; empty: no program, or not reported
    bool programIsStopped = false;      ///< the loaded program is stopped; another program may be running
};

/// Threads  one at a time. Every call blocks until the reply or the deadline.
/// Errors   of every call: those of the underlying client; VersionUnsupported for commands without support, see
///          offers()
class RobotService {
public:
    virtual ~RobotService() = default;

    virtual ServiceKind kind() const = 0;
    /// False after the connection is lost; call openService() again.
    virtual bool isConnected() = 0;

    /// Returns when the controller has accepted the command.
    virtual Result<void> perform(RobotCommand command, const Deadline& deadline) = 0;
    /// Requires an explicit confirmation by a person: the manufacturer forbids automatic reset.
    virtual Result<void> unlockProtectiveStop(const Deadline& deadline) = 0;
    /// name  as in the programs folder of the controller. For PolyScope X, the file extension is optional.
    virtual Result<void> loadProgram(const Text& name, const Deadline& deadline) = 0;
    /// Names of the programs on the controller, for loadProgram(). Only PolyScope X 10.12 and newer reports them.
    virtual Result<QStringList> programs(const Deadline& deadline) = 0;
    /// Reads control mode, operational mode and loaded program.
    virtual Result<ServiceReport> look(const Deadline& deadline) = 0;
};

struct ServiceAddress {
    Text host;
    int dashboardPort = kDashboardPort;
    int robotApiPort = kRobotApiPort;
};

/// Address of the services if all ports of the robot are shifted by the same offset.
ServiceAddress serviceAt(const Text& host, int portOffset = 0);

/// Connects to the dashboard server or, if it is not available, to the Robot API.
/// Errors   of the dashboard if neither responds: AddressInvalid, HostUnreachable, ConnectionRefused,
///          Timeout, Cancelled
Result<std::unique_ptr<RobotService>> openService(const ServiceAddress& address, const Deadline& deadline);

}  // namespace tiller::dashboard
