// SPDX-License-Identifier: MIT
#pragma once

// Private to robot/station/program.

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

/// Converts the value of the field `type`.
inline VariableType variableType(const QString& word) {
    return word == QLatin1String("whole")  ? VariableType::Whole
           : word == QLatin1String("flag") ? VariableType::Flag
           : word == QLatin1String("text") ? VariableType::Text
           : word == QLatin1String("pose") ? VariableType::Pose
                                           : VariableType::Number;
}

}  // namespace tiller::program
