// SPDX-License-Identifier: MIT
#pragma once

// What the session asks of the controller itself: power, recovery and programs, the program of others that is to be
// stopped, and what RTDE does not tell: the control mode, the operational mode and the loaded program. Outcomes come
// as messages and with the next state.

#include <QCoreApplication>
#include <QString>
#include <cstdint>
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

    void perform(RobotCommand command);
    /// Only ever on the operator's explicit word.
    void unlockProtectiveStop(const UnlockConsent& consent);
    /// name  as the controller's programs folder has it
    void loadProgram(const QString& name);

    // For the session.
    /// A stop by STOP, Esc or Space: to a program of others, and to our own on every route where nothing confirms
    /// that the control program has obeyed.
    /// epoch  of the stop: Controller::stop()
    void stopPrograms(control::StopCause cause, std::uint64_t epoch);
    /// Such a stop would be sent at once: its connection is open.
    bool stopsForeignProgramsAtOnce() const;
    void followForeignStop(const SampleBatch& batch);
    /// Queries the values not available over RTDE about twice a second.
    void ask();
    /// A stop before this time does not apply to later programs.
    void forgetStop() { unconfirmed_.reset(); }
    void forget();

private:
    void followReport(const dashboard::ServiceReport& report);
    void leaveForLocal();
    void stopOnEveryRoute(control::StopCause cause);

    RobotSession& session_;
    SessionBackend& d_;
    /// A stop while in control that nothing has confirmed yet.
    struct Unconfirmed {
        control::StopCause cause;
        control::StopConfirmation confirmation;
    };
    std::optional<Unconfirmed> unconfirmed_;
    std::int64_t reportAskedNs_ = 0;
    bool reportAsked_ = false;
    bool remoteSeen_ = false;   ///< the robot was in Remote control when it was asked last
    bool primarySeen_ = false;  ///< its primary interface was connected in the last frame
};

}  // namespace tiller
