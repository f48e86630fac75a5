// SPDX-License-Identifier: MIT
#pragma once

// Values of variables as a user types them and as URScript.

#include <QString>

#include "robot/core/result.h"
#include "robot/script/step_gate.h"

namespace tiller::program {

/// The value of the text; a flag is 0 or 1.
/// text    a number, or True or False in any case
/// Errors  InvalidArgument with a sentence if the text does not fit the type
Result<double> typedValue(script::GateVariable::Type type, const QString& text);

/// URScript literal of this type, e.g. "3.0" for a Number and "3" for a Whole.
QString scriptValue(script::GateVariable::Type type, double value);

}  // namespace tiller::program
