// SPDX-License-Identifier: MIT
#pragma once

// The controller's numbered messages in words: what the number means, and what the operator can do.

#include <QString>

namespace tiller {

struct CodeWords {
    QString title;    ///< "Collision"
    QString meaning;  ///< what the controller noticed
    QString action;   ///< what to do about it
    bool known = false;
};

/// code  as in ControllerMessage::code: 153 for C153. Numbers without an entry of their own give words for
///       their kind, and the advice to look the number up.
CodeWords controllerCode(int code);

}  // namespace tiller
