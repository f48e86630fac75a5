// SPDX-License-Identifier: MIT
#pragma once

// Translation context of all texts about programs.

#include <QCoreApplication>

namespace tiller::program {

struct ProgramText {
    Q_DECLARE_TR_FUNCTIONS(ProgramText)
};

}  // namespace tiller::program
