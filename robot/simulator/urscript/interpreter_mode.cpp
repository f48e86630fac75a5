// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/interpreter_mode.h"

#include <utility>

#include "robot/simulator/urscript/compiler.h"

namespace tiller::simulator::urscript {

InterpreterMode::Reply InterpreterMode::submit(std::string_view line) {
    if (!isActive()) {
        return {Reply::Kind::Discard, 0, "program is not in interpreter mode"};
    }
    if (awaitsClear_ || clearing_) {
        return {Reply::Kind::Wait, 0, {}};
    }
    if (queue_.size() >= kMaxWaiting) {
        return {Reply::Kind::Discard, 0, "too many statements are waiting"};
    }
    if (code_.functions.size() + code_.globals.size() >
        code_.program.code->functions.size() + code_.program.code->globals.size() + kMaxDefinitions) {
        return {Reply::Kind::Discard, 0, "too many definitions without clear_interpreter()"};
    }
    LineOutcome outcome = compileLine(line, code_);
    if (!outcome.code) {
        return {Reply::Kind::Discard, 0, outcome.error.text};
    }
    awaitsClear_ = outcome.code->clearsInterpreter;
    code_.addGlobals(outcome.code->globals);
    auto unit = std::make_unique<Unit>(std::move(outcome.code));
    for (std::size_t i = 1; i < unit->code->functions.size(); ++i) {
        code_.functions.push_back({&unit->code->functions[i], unit.get()});
    }
    queue_.push_back({++counts_.lastInterpreted, std::move(unit)});
    counts_.unexecuted = static_cast<std::uint32_t>(queue_.size());
    return {Reply::Kind::Ack, counts_.lastInterpreted, {}};
}

// Lines with definitions are kept until they are cleared. Other lines are removed at once.
void InterpreterMode::retire(std::unique_ptr<Unit> unit) {
    if (unit != nullptr && unit->code->functions.size() > 1) {
        definitions_.push_back(std::move(unit));
    }
}

void InterpreterMode::skip() {
    for (Line& line : queue_) {
        retire(std::move(line.unit));
    }
    queue_.clear();
    counts_.unexecuted = 0;
    awaitsClear_ = false;
}

void InterpreterMode::clear() {
    skip();
    clearing_ = false;
    forget_ = true;
    counts_.lastCleared = counts_.lastInterpreted;
}

InterpreterMode::Next InterpreterMode::proceed(bool clearQueueOnEnter, bool clearOnEnd) {
    if (!active_) {
        active_ = true;
        clearOnEnd_ = clearOnEnd;
        if (clearQueueOnEnter) {
            clear();
        }
    }
    if (clearing_) {
        clear();
    }
    if (ending_) {
        ending_ = active_ = false;
        if (clearOnEnd_) {
            clear();
        }
        return Next::End;
    }
    return queue_.empty() || linesLeft_ <= 0 ? Next::Nothing : Next::Line;
}

const Unit& InterpreterMode::begin() {
    retire(std::move(running_));
    Line line = std::move(queue_.front());
    queue_.pop_front();
    running_ = std::move(line.unit);
    counts_.lastExecuted = line.id;
    counts_.unexecuted = static_cast<std::uint32_t>(queue_.size());
    inLine_ = true;
    --linesLeft_;
    return *running_;
}

void InterpreterMode::lineDone() {
    inLine_ = false;
    if (running_->code->clearsInterpreter && !clearing_) {
        awaitsClear_ = false;  // the line has not executed its clear_interpreter()
    }
}

void InterpreterMode::forget() {
    code_.dropLines();
    running_.reset();
    definitions_.clear();
}

}  // namespace tiller::simulator::urscript
