// SPDX-License-Identifier: MIT
#pragma once

// The dashboard server of CB3 and e-Series (port 29999): power, brakes, recovery, programs, identity. One
// line out, one line back.

#include <QString>
#include <memory>

#include "robot/core/deadline.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/core/version.h"

class QTcpSocket;

namespace tiller::dashboard {

using tiller::operator<<;  // for the enumerations below

inline constexpr int kDashboardPort = 29999;

struct ProgramState {
    enum class Run { Stopped, Playing, Paused };
    Run run = Run::Stopped;
    QString program;  ///< empty when none is loaded
};

/// Threads  one at a time, the one that connected; for a thread that must not wait there is
///          service_worker.h. Every call blocks until the reply or the deadline.
/// Errors   of every call: NotConnected, ConnectionClosed, Timeout (the server is mute), Cancelled,
///          RemoteControlRequired (the robot is in Local), Rejected (any other reply than the documented one,
///          which is then in controllerMessage), InvalidArgument (a line break in a text). The context names
///          address and command. After Timeout or Cancelled the connection is closed, because a late reply
///          would be taken for the answer to the next command; and after RemoteControlRequired, because
///          controllers honour the switch to Remote on new connections only.
class DashboardClient {
public:
    explicit DashboardClient(Text host, int port = kDashboardPort);
    ~DashboardClient();
    DashboardClient(const DashboardClient&) = delete;
    DashboardClient& operator=(const DashboardClient&) = delete;

    /// Connects and reads the greeting.
    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled
    Result<void> connect(const Deadline& deadline);
    void close();              ///< Harmless when not connected.
    bool isConnected() const;  ///< As of the last call.
    /// Looks whether the server has hung up since the last reply, and closes this end then too.
    /// Returns  isConnected(). Blocks: never
    bool checkConnection();

    // Power and recovery. A reply means "begun": the change shows in robotMode().
    Result<void> powerOn(const Deadline& deadline);
    Result<void> powerOff(const Deadline& deadline);      ///< Engages the brakes.
    Result<void> brakeRelease(const Deadline& deadline);  ///< To RUNNING; powers on if need be.
    /// Refused (Rejected) for 5 s after the stop.
    Result<void> unlockProtectiveStop(const Deadline& deadline);
    Result<void> closeSafetyPopup(const Deadline& deadline);  ///< Closes one popup.
    Result<void> restartSafety(const Deadline& deadline);     ///< After a violation or a fault.

    Result<RobotMode> robotMode(const Deadline& deadline);    ///< Of the newest state.
    Result<SafetyMode> safetyMode(const Deadline& deadline);  ///< Of the newest state.
    /// false also where remote control is switched off in the settings. Since 5.6
    Result<bool> isInRemoteControl(const Deadline& deadline);

    // Identity
    Result<SoftwareVersion> polyscopeVersion(const Deadline& deadline);
    Result<QString> serialNumber(const Deadline& deadline);  ///< since 3.12 / 5.6
    Result<QString> robotModel(const Deadline& deadline);    ///< "UR5" for a UR5e too; since 3.12 / 5.6

    // Programs
    Result<ProgramState> programState(const Deadline& deadline);
    /// path  below the programs folder
    Result<void> loadProgram(const Text& path, const Deadline& deadline);
    Result<void> play(const Deadline& deadline);   ///< Starts or resumes the loaded program.
    Result<void> pause(const Deadline& deadline);  ///< Pauses the program that runs.
    Result<void> stop(const Deadline& deadline);   ///< Stops the program that runs.

    // Pendant
    Result<void> popup(const Text& text, const Deadline& deadline);
    Result<void> closePopup(const Deadline& deadline);                  ///< Closes the one popup() opened.
    Result<void> addToLog(const Text& text, const Deadline& deadline);  ///< On the teach pendant.

    /// Any command; the reply as it came.
    /// Errors   as above, without Rejected
    Result<QString> command(const Text& line, const Deadline& deadline);

private:
    Result<QString> readLine(const Deadline& deadline, const QString& context);
    Result<void> expect(const QString& line, const QString& reply, const Deadline& deadline);
    Result<QString> valueAfter(const QString& line, const QString& prefix, const Deadline& deadline);
    Error rejected(const QString& line, const QString& reply) const;
    QString contextOf(const QString& line) const;

    QString host_;
    int port_;
    std::unique_ptr<QTcpSocket> socket_;
};

}  // namespace tiller::dashboard
