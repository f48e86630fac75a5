// SPDX-License-Identifier: MIT
#pragma once

// Texts for the recovery from a safety stop: a checklist and one button. The steps follow
// robot/dashboard/recovery.h; widgets/status/recovery_page.h shows them.

#include <QStringList>

#include "robot/dashboard/recovery.h"
#include "robot/station/link/session_state.h"

namespace tiller {

using dashboard::RecoveryStep;

struct RecoveryGuide {
    QString title;  ///< "Protective stop"
    QString what;   ///< meaning and suggested action, as sentences
    /// Checks that the operator must confirm before `step` can be executed; empty if nothing is unlocked.
    QStringList checks;
    RecoveryStep step = RecoveryStep::Look;  ///< the next step; its button is labelled keyText()
    bool takesControl = false;               ///< Completed by the robot: take control next
    QString waiting;  ///< why the step is not possible yet although all checks are confirmed; empty if it is
    int countdown = 0;  ///< [s] remaining lock time of the controller, rounded up

    /// "Unlock", the label of the button; empty if the PC cannot help.
    QString keyText() const;
};

/// sinceStop  by the controller's clock [s]
RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop);

}  // namespace tiller
