// SPDX-License-Identifier: MIT
#pragma once

// The way back from a stop of the safety system in words: a list of things to look at and one key. What leads on
// is the rule of robot/dashboard/recovery.h; the page that shows it is widgets/status/recovery_page.h.

#include <QStringList>

#include "robot/dashboard/recovery.h"
#include "robot/station/link/session_state.h"

namespace tiller {

using dashboard::RecoveryStep;

struct RecoveryGuide {
    QString title;  ///< "Protective stop"
    QString what;   ///< what it means and what to do, as sentences
    /// To be looked at and ticked by the operator before `step` can be taken; empty where nothing is
    /// unlocked.
    QStringList checks;
    RecoveryStep step = RecoveryStep::Look;  ///< what leads on; its key is keyText()
    bool takesControl = false;  ///< Done, as far as the robot goes: what is left is to take control of it
    QString waiting;    ///< why the step cannot be taken yet although all is ticked; empty when it can
    int countdown = 0;  ///< [s] left of the controller's lock, rounded up

    /// "Unlock", as on the page's one key; empty where there is nothing the PC can do.
    QString keyText() const;
};

/// sinceStop  by the controller's clock [s]
RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop);

}  // namespace tiller
