// SPDX-License-Identifier: MIT
#pragma once

// Texts for the numbered messages of the controller: meaning and suggested action.

#include <QString>

namespace tiller {

struct CodeWords {
    QString title;    ///< "Collision"
    QString meaning;  ///< event reported by the controller
    QString action;   ///< suggested action
    bool known = false;
};

/// code  as in ControllerMessage::code: 153 for C153. Codes without an entry return a text for their kind,
/// and the advice to look up the code.
CodeWords controllerCode(int code);

}  // namespace tiller
