// SPDX-License-Identifier: MIT
#pragma once

// Texts for the recovery from a safety stop: a checklist and one button. The steps are those of
// robot/dashboard/recovery.h. widgets/status/recovery_page.h shows the texts.

#include <QStringList>

#include "robot/dashboard/recovery.h"
#include "robot/station/link/session_state.h"

namespace tiller {

using dashboard::RecoveryStep;

struct RecoveryGuide {
    QString title;  ///< e.g. "Protective stop"
    QString what;   ///< meaning and suggested action, as sentences
    /// Checks that the operator must confirm before `step` can be executed; empty if nothing is unlocked.
    QStringList checks;
    RecoveryStep step = RecoveryStep::Look;  ///< next step; keyText() is the label of its button
    bool takesControl = false;               ///< the recovery is complete; the next action is to take control
    QString waiting;    ///< why `step` is not possible yet, even with all checks confirmed; otherwise empty
    int countdown = 0;  ///< remaining lock time of the controller, rounded up [s]

    /// Label of the button, e.g. "Unlock"; empty if the step must be performed at the robot.
    QString keyText() const;
};

/// sinceStop  time since the stop on the controller's clock [s]
RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop);

}  // namespace tiller
