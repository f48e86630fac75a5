// SPDX-License-Identifier: MIT
#pragma once

// Private to robot/station/program.

#include <algorithm>
#include <initializer_list>

#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

/// Closes a branch of an `if` with `end`, unless the next step has one of these kinds and continues the `if`.
inline void closeBranch(StepWriter& writer, std::initializer_list<const char*> continuations) {
    const StepKind* next = writer.next();
    const bool goesOn =
        next != nullptr && std::any_of(continuations.begin(), continuations.end(), [&](const char* id) {
            return QLatin1String(next->id) == QLatin1String(id);
        });
    writer.close(goesOn ? QString() : QStringLiteral("end"));
}

}  // namespace tiller::program
