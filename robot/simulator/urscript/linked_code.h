// SPDX-License-Identifier: MIT
#pragma once

// The code run by a virtual machine: the program and the lines added in interpreter mode. Functions and
// globals are numbered across both, so that a later line can use the definitions of earlier lines.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/simulator/urscript/bytecode.h"

namespace tiller::simulator::urscript {

/// Bytecode, and constants that belong to one virtual machine.
struct Unit {
    const Bytecode* code = nullptr;
    std::unique_ptr<const Bytecode> owned;  ///< code of a line; null for the program, which is not owned
    std::vector<Value> constants;

    explicit Unit(const Bytecode& shared) : code(&shared) { takeConstants(); }
    explicit Unit(std::unique_ptr<const Bytecode> line) : code(line.get()), owned(std::move(line)) {
        takeConstants();
    }

private:
    void takeConstants() {
        constants.reserve(code->constants.size());
        for (const Value& v : code->constants) {
            constants.push_back(v.detached());
        }
    }
};

struct LinkedCode {
    struct Callee {
        const FunctionCode* function = nullptr;
        const Unit* unit = nullptr;
    };
    explicit LinkedCode(const Bytecode& code) : program(code) {
        addGlobals(code.globals);
        for (const FunctionCode& f : code.functions) {
            functions.push_back({&f, &program});
        }
    }
    void addGlobals(const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            slots.emplace(name, static_cast<int>(globals.size()));
            globals.push_back(name);
        }
    }
    /// Removes the functions and globals of all lines. Those of the program remain.
    void dropLines() {
        functions.resize(program.code->functions.size());
        while (globals.size() > program.code->globals.size()) {
            slots.erase(globals.back());
            globals.pop_back();
        }
    }

    const Unit program;
    std::vector<Callee> functions;
    std::vector<std::string> globals;  ///< names, indexed by slot
    std::map<std::string, int, std::less<>> slots;
};

}  // namespace tiller::simulator::urscript
