// SPDX-License-Identifier: MIT
#pragma once

// Recovery from a safety stop in words: a checklist and one button. The steps follow robot/dashboard/recovery.h;
// widgets/status/recovery_page.h shows them.

#include <QStringList>

#include "robot/dashboard/recovery.h"
#include "robot/station/link/session_state.h"

namespace tiller {

using dashboard::RecoveryStep;

struct RecoveryGuide {
    QString title;  ///< "Protective stop"
    QString what;   ///< meaning and suggested action, as sentences
    /// Checks to be ticked by the operator before `step` can be taken; empty if nothing is unlocked.
    QStringList checks;
    RecoveryStep step = RecoveryStep::Look;  ///< the next step; its button is labelled keyText()
    bool takesControl = false;               ///< Completed on the robot: control has to be taken next
    QString waiting;    ///< why the step cannot be taken yet although all is ticked; empty when it can
    int countdown = 0;  ///< [s] left of the controller's lock, rounded up

    /// "Unlock", the label of the button; empty if the PC cannot do anything.
    QString keyText() const;
};

/// sinceStop  by the controller's clock [s]
RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop);

}  // namespace tiller
