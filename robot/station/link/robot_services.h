// SPDX-License-Identifier: MIT
#pragma once

// Requests from the session to the controller: power, recovery and programs, and stopping external programs.
// Also queries the values that RTDE does not report: control mode, operational mode and loaded program.
// Results are logged and appear in the next session state.

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <optional>

#include "robot/control/control_status.h"
#include "robot/control/stop_confirmation.h"
#include "robot/station/link/robot_command.h"

namespace tiller {

namespace dashboard {
struct ServiceReport;
}
class RobotSession;
struct SampleBatch;
struct SessionBackend;

class RobotServices {
    Q_DECLARE_TR_FUNCTIONS(RobotServices)

public:
    RobotServices(RobotSession& session, SessionBackend& backend) : session_(session), d_(backend) {}

    /// confirmed  the operator agrees to the effect on the program of the robot. Without confirmation,
    ///            commands that start a program, or that pause or end an external program, are not sent, and
    ///            RobotSession::commandQuestion() is emitted
    void perform(RobotCommand command, bool confirmed = false);
    /// Requires the operator's explicit confirmation.
    void unlockProtectiveStop(const UnlockConsent& consent);
    /// name  path relative to the controller's programs folder
    void loadProgram(const QString& name);
    /// Calls `done` with the names for loadProgram(). Never calls it if the robot does not report the names,
    /// e.g. e-Series.
    /// context  after its destruction, `done` is not called
    void listPrograms(QObject* context, const std::function<void(const QStringList&)>& done);

    // Called by the session.
    /// Handles a stop by STOP, Esc or Space. Stops external programs. Also stops Tiller's own program on all
    /// routes, unless it is confirmed that the control program has stopped.
    /// epoch  number of the stop, see Controller::stop()
    void stopPrograms(control::StopCause cause, std::uint64_t epoch);
    /// True if the connection for stopping external programs is open, so that a stop can be sent at once.
    bool stopsForeignProgramsAtOnce() const;
    void followForeignStop(const SampleBatch& batch);
    /// Queries the values not available over RTDE about twice a second.
    void ask();
    /// Discards a pending stop, so that it cannot affect programs started later.
    void forgetStop() { unconfirmed_.reset(); }
    void forget();

private:
    void followReport(const dashboard::ServiceReport& report);
    void leaveForLocal();
    void stopOnEveryRoute(control::StopCause cause);

    RobotSession& session_;
    SessionBackend& d_;
    /// A stop while in control that is not confirmed yet.
    struct Unconfirmed {
        control::StopCause cause;
        control::StopConfirmation confirmation;
    };
    std::optional<Unconfirmed> unconfirmed_;
    std::int64_t reportAskedNs_ = 0;
    bool reportAsked_ = false;
    bool remoteSeen_ = false;          ///< the robot was in Remote control at the last query
    bool hasReportedSilence_ = false;  ///< a stop without data was reported in this outage
    bool primarySeen_ = false;         ///< the primary interface was connected in the last frame
};

}  // namespace tiller
