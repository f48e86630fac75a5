// SPDX-License-Identifier: MIT
#pragma once

// Texts for numbered controller messages: meaning and suggested action.

#include <QString>

namespace tiller {

struct CodeWords {
    QString title;    ///< e.g. "Singularity"
    QString meaning;  ///< event reported by the controller
    QString action;   ///< suggested action
    bool known = false;
};

/// code  number as in ControllerMessage::code, e.g. 153 for C153. For a code without an entry, returns a
///       general title, and the advice to look up the code.
CodeWords controllerCode(int code);

}  // namespace tiller
