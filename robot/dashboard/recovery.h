// SPDX-License-Identifier: MIT
#pragma once

// The way back from a stop to a robot that runs, as one guided operation: looks what is wrong, does step
// after step, tells each. What a person has to decide is asked for beforehand, by name: nothing here unlocks
// a protective stop or restarts the safety system unless the caller says so (the manufacturer forbids
// automatic reset).

#include <functional>

#include "robot/core/text.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/robot_api_client.h"
#include "robot/dashboard/robot_service.h"

namespace tiller::dashboard {

using tiller::operator<<;  // for the enumerations below

/// What the caller takes upon himself, each for one recovery. The default permits nothing.
struct RecoveryConsent {
    bool causeInspected = false;  ///< "I have seen why it stopped": the unlock of a protective stop
    bool restartSafety = false;   ///< violation or fault: the arm loses power
    bool powerOn = false;         ///< the arm gets power
    bool releaseBrakes = false;   ///< the arm may move a little
};

enum class RecoveryStep {
    Look,              ///< also: nothing to do but wait until the modes change
    CloseSafetyPopup,  ///< once, before an unlock
    WaitForUnlock,     ///< the controller refuses for kUnlockAfter
    Unlock,            ///< of a protective stop
    RestartSafety,     ///< after a violation or a fault
    PowerOn,
    ReleaseBrakes,
    AskPerson,  ///< it ends when somebody at the robot ends it: emergency stop, safeguard, enabling device
    Done,       ///< RUNNING, and the safety system lets the arm move
};

/// For so long a controller refuses to unlock a protective stop [s].
/// Source  Dashboard Server guide, "unlock protective stop"
inline constexpr double kUnlockAfter = 5.0;

/// The one rule of the way back: what leads on from these modes.
/// Returns  Look, Unlock, RestartSafety, PowerOn, ReleaseBrakes, AskPerson or Done
/// Threads  any. Blocks: never. Real-time: yes
RecoveryStep nextRecoveryStep(SafetyMode safety, RobotMode mode);

/// Called in the thread of recover(), before each step.
using RecoveryProgress = std::function<void(RecoveryStep)>;

/// Leads the robot to RUNNING in NORMAL or REDUCED. A controller that restarts meanwhile is waited for: connections that it
/// ends or refuses are made again until the deadline.
/// Errors   as DashboardClient; Rejected with what is missing when a step needs a consent that was not given,
///          or a person at the robot (emergency stop pressed, safeguard open): nothing was done then beyond
///          the steps told
/// Threads  the one that connected the client. Blocks: until the deadline
Result<void> recover(DashboardClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});
/// The same on PolyScope X.
Result<void> recover(RobotApiClient& client, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});

/// The same by the dashboard, or, where there is none, by the Robot API.
Result<void> recover(const ServiceAddress& address, const RecoveryConsent& consent, const Deadline& deadline,
                     const RecoveryProgress& progress = {});

}  // namespace tiller::dashboard
