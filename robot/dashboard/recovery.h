// SPDX-License-Identifier: MIT
#pragma once

// Guided recovery from a stop to a running robot. Checks the state, and performs and reports one step at a
// time. Decisions that require a person are made in advance as explicit consents. Without them, no protective
// stop is unlocked and the safety system is not restarted, because the manufacturer forbids automatic reset.

#include <functional>

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/robot_api_client.h"
#include "robot/dashboard/robot_service.h"

namespace tiller::dashboard {

using tiller::operator<<;  // makes the enumerations below printable

/// Explicit consents of the caller for one recovery. The default permits no action.
struct RecoveryConsent {
    bool causeInspected = false;  ///< the cause was inspected: required to unlock a protective stop
    bool restartSafety = false;   ///< the safety system may be restarted, for which the arm loses power
    bool powerOn = false;         ///< the arm may be powered on
    bool releaseBrakes = false;   ///< the brakes may be released, during which the joints can move
};

enum class RecoveryStep {
    Look,              ///< reads the modes; also repeated until they change
    CloseSafetyPopup,  ///< closes the safety popup once, before an unlock
    WaitForUnlock,     ///< waits while the controller refuses to unlock, see kUnlockAfter
    Unlock,            ///< unlocks a protective stop
    RestartSafety,     ///< after a violation or fault
    PowerOn,
    ReleaseBrakes,
    AskPerson,  ///< an action at the robot is required: emergency stop, safeguard, enabling device
    Done,       ///< RUNNING, and the safety mode allows motion
};

/// Time during which a controller refuses to unlock a protective stop [s].
/// Source  Dashboard Server guide, "unlock protective stop"
inline constexpr double kUnlockAfter = 5.0;

/// Selects the next recovery step for the current modes.
/// Returns  Look, Unlock, RestartSafety, PowerOn, ReleaseBrakes, AskPerson or Done
/// Threads  any. Blocks: never. Real-time: yes
RecoveryStep nextRecoveryStep(SafetyMode safety, RobotMode mode);

/// Called in the thread of recover() before each step.
using RecoveryProgress = std::function<void(RecoveryStep)>;

/// Brings the robot to RUNNING with safety mode NORMAL or REDUCED. If the controller restarts during the
/// recovery, the function reconnects until the deadline.
/// Errors   as for DashboardClient; Rejected, with the missing condition, if a step requires a consent that was
///          not given, or an action at the robot (emergency stop pressed, safeguard open). In this
///          case, only the reported steps have been performed.
/// Threads  the thread that connected the client. Blocks: until the deadline
Result<void> recover(DashboardClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});
/// Same as recover() above, for PolyScope X.
Result<void> recover(RobotApiClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});

/// Same as recover() above, through the dashboard server or, if it is not available, through the Robot API.
Result<void> recover(const ServiceAddress& address, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});

}  // namespace tiller::dashboard
