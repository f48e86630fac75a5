// SPDX-License-Identifier: MIT
#pragma once

// Why a program cannot run, at the step and field where it is wrong.

#include <QString>
#include <QUuid>
#include <vector>

namespace tiller::program {

struct ProgramProblem {
    QUuid program;
    QUuid step;      ///< null: the program as a whole
    int number = 0;  ///< of the step as in the step register; 0 where there is none
    QString field;   ///< key of the field; empty: the step as a whole
    QString text;    ///< translated, a sentence
    friend bool operator==(const ProgramProblem&, const ProgramProblem&) = default;
};

}  // namespace tiller::program
