// SPDX-License-Identifier: MIT
#pragma once

// Client of the dashboard server of CB3 and e-Series (port 29999): power, brakes, recovery, programs,
// identification. The protocol uses one line per request and one line per reply.

#include <QString>
#include <memory>

#include "robot/core/deadline.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/core/version.h"

class QTcpSocket;

namespace tiller::dashboard {

using tiller::operator<<;  // makes the enumerations below printable

inline constexpr int kDashboardPort = 29999;

struct ProgramState {
    enum class Run { Stopped, Playing, Paused };
    Run run = Run::Stopped;
    QString program;  ///< empty if none is loaded
};

/// Threads  one at a time: the thread that connected. For threads that must not block, see service_worker.h.
///          Every call blocks until the reply or the deadline.
/// Errors   of every call: NotConnected, ConnectionClosed, Timeout (no reply), Cancelled,
///          RemoteControlRequired (the robot is in Local), Rejected (an undocumented reply, see
///          controllerMessage), InvalidArgument (a line break in a text). The context contains address and
///          command. Timeout and Cancelled close the connection, because a late reply would be mistaken for
///          the reply to the next command. RemoteControlRequired closes it, because the controller applies a
///          change to Remote only to connections opened afterwards.
class DashboardClient {
public:
    explicit DashboardClient(Text host, int port = kDashboardPort);
    ~DashboardClient();
    DashboardClient(const DashboardClient&) = delete;
    DashboardClient& operator=(const DashboardClient&) = delete;

    /// Connects and reads the greeting.
    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled
    Result<void> connect(const Deadline& deadline);
    void close();              ///< No effect without a connection.
    bool isConnected() const;  ///< Connection state after the last call.
    /// Checks whether the server has closed the connection since the last reply, and closes the socket in
    /// this case.
    /// Returns  isConnected()
    /// Blocks   never
    bool checkConnection();

    // Power and recovery commands return when the action has started; robotMode() shows the progress.
    Result<void> powerOn(const Deadline& deadline);
    Result<void> powerOff(const Deadline& deadline);      ///< Switches the power off; the brakes engage.
    Result<void> brakeRelease(const Deadline& deadline);  ///< Changes to RUNNING; powers on if necessary.
    /// Rejected during the first 5 s after the stop.
    Result<void> unlockProtectiveStop(const Deadline& deadline);
    Result<void> closeSafetyPopup(const Deadline& deadline);  ///< Closes one safety popup.
    Result<void> restartSafety(const Deadline& deadline);     ///< After a safety violation or fault.

    Result<RobotMode> robotMode(const Deadline& deadline);    ///< Rejected if the reply is not a known mode.
    Result<SafetyMode> safetyMode(const Deadline& deadline);  ///< Rejected if the reply is not a known mode.
    /// Also false if remote control is disabled in the settings. Since 5.6
    Result<bool> isInRemoteControl(const Deadline& deadline);

    // Identification
    Result<SoftwareVersion> polyscopeVersion(const Deadline& deadline);
    Result<QString> serialNumber(const Deadline& deadline);  ///< since 3.12 / 5.6
    Result<QString> robotModel(const Deadline& deadline);    ///< "UR5" also for a UR5e; since 3.12 / 5.6

    // Programs
    Result<ProgramState> programState(const Deadline& deadline);
    /// path  relative to the programs folder
    Result<void> loadProgram(const Text& path, const Deadline& deadline);
    Result<void> play(const Deadline& deadline);   ///< Starts or resumes the loaded program.
    Result<void> pause(const Deadline& deadline);  ///< Pauses the running program.
    Result<void> stop(const Deadline& deadline);   ///< Stops the running program.

    // Pendant
    Result<void> popup(const Text& text, const Deadline& deadline);
    Result<void> closePopup(const Deadline& deadline);  ///< Closes the popup opened by popup().
    /// Adds an entry to the log of the teach pendant.
    Result<void> addToLog(const Text& text, const Deadline& deadline);

    /// Sends any command and returns the reply.
    /// Errors   as for all calls, except Rejected
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
