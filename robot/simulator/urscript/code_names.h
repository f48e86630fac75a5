// SPDX-License-Identifier: MIT
#pragma once

// Resolves names of variables and functions: globals and functions of the text, and locals of the function
// being compiled. In an interpreter mode line, the names of the program are resolved too.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/linked_code.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

class CodeNames {
public:
    const std::optional<CompileError>& error() const { return error_; }

protected:
    /// surroundings  the program to which an interpreter mode line is added; null for a whole program
    CodeNames(const ast::Tree& tree, const LinkedCode* surroundings)
        : tree_(tree), surroundings_(surroundings) {}

    struct Slot {
        bool global = false;
        int index = -1;
    };
    void collectGlobals();
    void collectLocals(const ast::Block& block);
    static const ast::Expr* rootOf(const ast::Expr* target);
    /// Returns the slot; -1 if the global does not exist.
    int findGlobal(std::string_view name) const;
    int globalSlot(std::string_view name);
    int localSlot(std::string_view name);
    Slot resolve(std::string_view name);
    /// A function that can be called or run.
    struct Callee {
        int index = -1;
        ast::FunctionKind kind = ast::FunctionKind::Def;
        const ast::Function* here = nullptr;      // defined in this text; otherwise null
        const FunctionCode* elsewhere = nullptr;  // compiled earlier; otherwise null
        explicit operator bool() const { return index >= 0; }
    };
    Callee findFunction(std::string_view name) const;
    int indexOf(const ast::Function& f) const;
    bool isOutermost(const ast::Function& f) const;
    void report(ast::Position at, std::string text);
    void nameNotFound(ast::Position at, std::string_view name);
    /// Sets the function whose names are resolved by the following calls.
    void enter(const ast::Function& f);

    const ast::Tree& tree_;
    std::unique_ptr<Bytecode> out_ = std::make_unique<Bytecode>();
    // the function being compiled
    const ast::Function* function_ = nullptr;
    FunctionCode* code_ = nullptr;

private:
    void collectGlobals(const ast::Block& block, bool outermost);

    const LinkedCode* surroundings_;
    std::map<std::string_view, int> globals_;
    std::optional<CompileError> error_;
    std::map<std::string_view, int> locals_;
    std::set<std::string_view> explicitLocals_;
};

}  // namespace tiller::simulator::urscript
