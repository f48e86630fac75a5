// SPDX-License-Identifier: MIT
#pragma once

// Power, safety and programs of a PolyScope X robot, which has no dashboard server: its Robot API over HTTP,
// from software 10.11 on (questions from 10.12).

#include <QJsonObject>
#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"

namespace tiller::dashboard {

inline constexpr int kRobotApiPort = 80;

/// Every call is a connection of its own, so there is nothing to connect and nothing to lose.
/// Threads  any, several at once. Every call blocks until the reply or the deadline.
/// Errors   of every call: AddressInvalid, HostUnreachable, ConnectionRefused, ConnectionClosed, Timeout,
/// Cancelled,
///          ProtocolError (not what the API answers with), RemoteControlRequired (403), VersionUnsupported
///          (404 of a question: software before 10.12), Rejected (anything else; the robot's words are in
///          controllerMessage)
/// Source   Robot API of PolyScope X
class RobotApiClient {
public:
    explicit RobotApiClient(Text host, int port = kRobotApiPort) : host_(std::move(host)), port_(port) {}

    /// The version the API gives itself, as in "3.1.4": whether it is there at all.
    Result<QString> apiVersion(const Deadline& deadline) const;

    // A reply means "begun": the change shows in robotMode().
    Result<void> powerOn(const Deadline& deadline);
    Result<void> powerOff(const Deadline& deadline);              ///< Engages the brakes.
    Result<void> brakeRelease(const Deadline& deadline);          ///< To RUNNING.
    Result<void> unlockProtectiveStop(const Deadline& deadline);  ///< After a look at the arm.
    Result<void> restartSafety(const Deadline& deadline);         ///< After a violation or a fault.

    Result<RobotMode> robotMode(const Deadline& deadline) const;     ///< Of the newest state.
    Result<SafetyMode> safetyMode(const Deadline& deadline) const;   ///< Of the newest state.
    Result<bool> isInRemoteControl(const Deadline& deadline) const;  ///< Else automatic or manual.

    /// name  without its ending
    Result<void> loadProgram(const Text& name, const Deadline& deadline);
    /// action  "play", "pause", "resume" or "stop"
    Result<void> runProgram(const Text& action, const Deadline& deadline);
    Result<ProgramState::Run> programState(const Deadline& deadline) const;  ///< Of the loaded program.

    /// Any request below /universal-robots/robot-api; the object of the reply, empty when it has none.
    Result<QJsonObject> request(const QByteArray& method, const QString& path, const QJsonObject& body,
                                const Deadline& deadline) const;

private:
    Result<void> act(const char* action, const Deadline& deadline);
    Result<QString> modeAt(const QString& path, const Deadline& deadline) const;

    QString host_;
    int port_;
};

}  // namespace tiller::dashboard
