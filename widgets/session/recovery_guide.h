// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The way back from a stop of the safety system in words: a list of things to look at and one key. What leads on
// is the rule of robot/dashboard/recovery.h; the page that shows it is widgets/status/recovery_page.h.

#include <QStringList>

#include "widgets/session/session_state.h"

namespace tiller {

/// What the page's one key does.
enum class RecoveryKey {
    None,           ///< nothing the PC can do: see `waiting`
    Unlock,         ///< a protective stop
    RestartSafety,  ///< a violation or a fault
    PowerOn,
    ReleaseBrakes,
    TakeControl,
    Done,  ///< the arm can be moved again
};

struct RecoveryGuide {
    QString title;  ///< "Protective stop"
    QString what;   ///< what it means and what to do, as sentences
    /// To be looked at and ticked by the operator before `step` can be taken; empty where nothing is
    /// unlocked.
    QStringList checks;
    RecoveryKey step = RecoveryKey::None;
    QString waiting;    ///< why the step cannot be taken yet although all is ticked; empty when it can
    int countdown = 0;  ///< [s] left of the controller's lock, rounded up
};

/// sinceStop  by the controller's clock [s]
RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop);
/// "Unlock", as on the key.
QString recoveryKeyText(RecoveryKey step);

}  // namespace tiller
