// SPDX-License-Identifier: MIT
#pragma once

// Client of the Robot API (HTTP) of PolyScope X, which replaces the dashboard server: power, safety and programs.
// Software 10.11 or later (queries: 10.12).

#include <QJsonObject>
#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"

namespace tiller::dashboard {

inline constexpr int kRobotApiPort = 80;

/// Every call uses a separate connection, so there is no connect function.
/// Threads  any, several at once. Every call blocks until the reply or the deadline.
/// Errors   of every call: AddressInvalid, HostUnreachable, ConnectionRefused, ConnectionClosed, Timeout,
///          Cancelled, ProtocolError (the reply is not from this API), RemoteControlRequired (403),
///          VersionUnsupported (404 for a query: software before 10.12), Rejected (other failures; see
///          controllerMessage)
/// Source   Robot API of PolyScope X
class RobotApiClient {
public:
    explicit RobotApiClient(Text host, int port = kRobotApiPort) : host_(std::move(host)), port_(port) {}

    /// Version of the API, e.g. "3.1.4". Use this call to check whether the API is available.
    Result<QString> apiVersion(const Deadline& deadline) const;

    // The power and recovery functions return when the action has started; robotMode() shows the progress.
    Result<void> powerOn(const Deadline& deadline);
    Result<void> powerOff(const Deadline& deadline);      ///< Switches the power off; the brakes engage.
    Result<void> brakeRelease(const Deadline& deadline);  ///< Changes to RUNNING.
    Result<void> unlockProtectiveStop(const Deadline& deadline);  ///< Call only after inspecting the arm.
    Result<void> restartSafety(const Deadline& deadline);         ///< After a safety violation or fault.

    Result<RobotMode> robotMode(const Deadline& deadline) const;     ///< ProtocolError: unknown mode.
    Result<SafetyMode> safetyMode(const Deadline& deadline) const;   ///< ProtocolError: unknown mode.
    Result<bool> isInRemoteControl(const Deadline& deadline) const;  ///< False in automatic and manual mode.

    /// name  without the file extension
    Result<void> loadProgram(const Text& name, const Deadline& deadline);
    /// action  "play", "pause", "resume" or "stop"
    Result<void> runProgram(const Text& action, const Deadline& deadline);
    Result<ProgramState::Run> programState(const Deadline& deadline) const;  ///< State of the loaded program.

    /// Sends any request below /universal-robots/robot-api and returns the JSON object of the reply, or an
    /// empty object if the reply contains none.
    Result<QJsonObject> request(const QByteArray& method, const QString& path, const QJsonObject& body,
                                const Deadline& deadline) const;

private:
    Result<void> act(const char* action, const Deadline& deadline);
    Result<QString> modeAt(const QString& path, const Deadline& deadline) const;

    QString host_;
    int port_;
};

}  // namespace tiller::dashboard
