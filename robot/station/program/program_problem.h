// SPDX-License-Identifier: MIT
#pragma once

// A problem that prevents a program from running, with its step and field.

#include <QString>
#include <QUuid>
#include <vector>

namespace tiller::program {

struct ProgramProblem {
    QUuid program;
    QUuid step;      ///< null: the whole program
    int number = 0;  ///< number in the step register; 0: no step
    QString field;   ///< key of the field; empty: the whole step
    QString text;    ///< a translated sentence
    friend bool operator==(const ProgramProblem&, const ProgramProblem&) = default;
};

}  // namespace tiller::program
