// SPDX-License-Identifier: MIT
#pragma once

// Compiles and runs scripts for the tests in this folder.

#include <QTest>
#include <memory>

#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/value_format.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

namespace tiller::simulator::urscript {

/// A script on a fake robot. compile() must succeed.
struct ScriptRun {
    FakeHost host;
    std::unique_ptr<Interpreter> interpreter;

    explicit ScriptRun(const std::string& text, const Limits& limits = {}) { load(text, limits); }
    ScriptRun() = default;

    void load(const std::string& text, const Limits& limits = {}) {
        const CompileOutcome outcome = compile(text);
        if (!outcome) {
            qFatal("%d:%d %s", outcome.error.line, outcome.error.column, outcome.error.text.c_str());
        }
        interpreter = std::make_unique<Interpreter>(outcome.program, host, limits);
    }
    Interpreter::State frames(int count) {
        for (int i = 0; i < count && !interpreter->ended(); ++i) {
            interpreter->runFrame();
        }
        return interpreter->state();
    }
    std::string error() const { return interpreter->error() ? interpreter->error()->text : std::string(); }
    /// Value of a global variable in the format of to_str; "(unset)" if it has no value.
    std::string value(const char* name) const {
        const Value* v = interpreter->global(name);
        return v == nullptr ? "(unset)" : toStr(*v);
    }
};

/// Returns the value of the expression after `body` has run, in the format of to_str; "error: ..." if
/// compiling or running fails.
inline std::string evaluate(const std::string& expression, const std::string& body = {}) {
    const CompileOutcome outcome = compile("def t():\n" + body + "\nresult = " + expression + "\nend\n");
    if (!outcome) {
        return "error: " + outcome.error.text;
    }
    FakeHost host;
    Interpreter interpreter(outcome.program, host);
    for (int i = 0; i < 2000 && !interpreter.ended(); ++i) {
        interpreter.runFrame();
    }
    if (interpreter.error()) {
        return "error: " + interpreter.error()->text;
    }
    const Value* v = interpreter.global("result");
    return v == nullptr ? "error: no result" : toStr(*v);
}

}  // namespace tiller::simulator::urscript
