// SPDX-License-Identifier: MIT
#include "robot/station/program/execution/run_gate.h"

namespace tiller::program {

using script::StepGate;

bool RunGate::isAtBreakpoint(const StepLog& log) const {
    return log.isWaiting() && gate_.permitted >= StepGate::kUnlimited &&
           gate_.permitted - StepGate::kUnlimited <= log.begun();
}

bool RunGate::isPaused(const StepLog& log) const {
    return gate_.permitted < StepGate::kUnlimited || isAtBreakpoint(log);
}

void RunGate::pause(const StepLog& log) {
    if (!isPaused(log)) {
        gate_.permitted = log.begun();
    }
}

void RunGate::resume(const StepLog& log) {
    withdrawChange();
    gate_.permitted = StepGate::kUnlimited + (log.isWaiting() ? log.begun() + 1 : 0);
}

void RunGate::step(const StepLog& log) {
    if (isPaused(log) && log.isWaiting()) {
        withdrawChange();
        gate_.permitted = log.begun() + 1;
    }
}

}  // namespace tiller::program
