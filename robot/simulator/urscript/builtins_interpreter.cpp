// SPDX-License-Identifier: MIT
// interpreter_mode() and the functions that end or clear it.

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/interpreter_mode.h"

namespace tiller::simulator::urscript {

namespace {

Status interpreterMode(Call& c) {
    InterpreterMode& mode = *c.context().mode;
    if (c.context().kind == ProgramKind::Secondary) {
        fault(kTooMuchBehind);
    }
    if (c.thread != 0) {
        fault("interpreter_mode: only the main thread can enter interpreter mode");
    }
    if (mode.isInLine()) {
        fault("interpreter_mode: interpreter mode is already active");
    }
    switch (mode.proceed(c.boolean(0), c.boolean(1))) {
        case InterpreterMode::Next::Line:
            return Status::Line;
        case InterpreterMode::Next::Nothing:
            return Status::Again;
        case InterpreterMode::Next::End:
            break;
    }
    return Status::Done;
}

Status endInterpreter(Call& c) {
    c.context().mode->requestEnd();
    return Status::Done;
}

Status clearInterpreter(Call& c) {
    c.context().mode->requestClear();
    return Status::Done;
}

constexpr Since kSince{{10, 0, kNever}};

constexpr BuiltinRow kInterpreterRows[] = {
    // As a bare statement, interpreter_mode() replaces the running program, as a motion command does.
    {"interpreter_mode(clearQueueOnEnter=True, clearOnEnd=True)", interpreterMode, kMotion, kSince},
    {"end_interpreter()", endInterpreter, kPlain, kSince},
    {"clear_interpreter()", clearInterpreter, kClearsInterpreter, kSince},
};

}  // namespace

std::span<const BuiltinRow> interpreterBuiltins() {
    return kInterpreterRows;
}

}  // namespace tiller::simulator::urscript
