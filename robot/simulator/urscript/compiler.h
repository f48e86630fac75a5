// SPDX-License-Identifier: MIT
#pragma once

// The code generator itself, in three files: names, statements, expressions. Others include program.h.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "robot/simulator/urscript/builtin.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/linked_code.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

class Compiler {
public:
    /// surroundings  what a line of interpreter mode is added to; null: a whole program
    Compiler(const ast::Tree& tree, const CompileOptions& options, const LinkedCode* surroundings = nullptr)
        : tree_(tree), options_(options), surroundings_(surroundings) {}

    std::unique_ptr<Bytecode> run();

    const std::optional<CompileError>& error() const { return error_; }

private:
    // ---- names
    struct Slot {
        bool global = false;
        int index = -1;
    };
    void collectGlobals();
    void collectGlobals(const ast::Block& block, bool outermost);
    void collectLocals(const ast::Block& block);
    static const ast::Expr* rootOf(const ast::Expr* target);
    /// -1: there is none of that name.
    int findGlobal(std::string_view name) const;
    int globalSlot(std::string_view name);
    int localSlot(std::string_view name);
    Slot resolve(std::string_view name);
    /// A function that can be called or run, wherever it was defined.
    struct Callee {
        int index = -1;
        ast::FunctionKind kind = ast::FunctionKind::Def;
        const ast::Function* here = nullptr;      // in this text, or
        const FunctionCode* elsewhere = nullptr;  // compiled before
        explicit operator bool() const { return index >= 0; }
    };
    Callee findFunction(std::string_view name) const;
    int indexOf(const ast::Function& f) const;
    bool isOutermost(const ast::Function& f) const;
    void report(ast::Position at, std::string text);
    void nameNotFound(ast::Position at, std::string_view name);

    // ---- code
    int emit(Op op, ast::Position at, int b = 0, int a = 0, int stackChange = 0) {
        code_->code.push_back({op, static_cast<std::uint16_t>(a), b});
        code_->positions.push_back(at);
        depth_ += stackChange;
        code_->stack = std::max(code_->stack, depth_);
        return static_cast<int>(code_->code.size()) - 1;
    }
    int here() const { return static_cast<int>(code_->code.size()); }
    void land(int jump) { code_->code[static_cast<std::size_t>(jump)].b = here(); }

    int constant(Value v) {
        out_->constants.push_back(std::move(v));
        return static_cast<int>(out_->constants.size()) - 1;
    }
    int text(std::string_view s) {
        const auto [it, added] = texts_.try_emplace(std::string(s), static_cast<int>(out_->constants.size()));
        if (added) {
            out_->constants.emplace_back(std::string(s));
        }
        return it->second;
    }

    void function(const ast::Function& f);
    void defaultOf(const ast::Function& f, const ast::Parameter& parameter);
    void block(const ast::Block& statements);
    void statement(const ast::Stmt& s);
    void ifStatement(const ast::Stmt& s);
    void whileStatement(const ast::Stmt& s);
    void assign(const ast::Stmt& s);

    // ---- expressions
    Path pathOf(const ast::Expr* target, bool global = false);
    static bool isPath(const ast::Expr* e);
    void expression(const ast::Expr* e);
    static Op operatorOf(ast::ExprKind kind);
    void method(const ast::Expr* e);

    // ---- calls
    struct Formal {
        std::string_view name;
        std::string_view alias;
        bool required;
        const Value* value;  // of a builtin's default
    };
    void call(const ast::Expr* e);
    static const Builtin& row(int builtin) { return builtins()[static_cast<std::size_t>(builtin)]; }
    int arguments(const ast::Expr* e, const std::vector<Formal>& formals);

    const ast::Tree& tree_;
    const CompileOptions& options_;
    const LinkedCode* surroundings_;
    std::unique_ptr<Bytecode> out_ = std::make_unique<Bytecode>();
    std::map<std::string_view, int> globals_;
    std::map<std::string, int, std::less<>> texts_;
    std::optional<CompileError> error_;

    // of the function being compiled
    const ast::Function* function_ = nullptr;
    FunctionCode* code_ = nullptr;
    std::map<std::string_view, int> locals_;
    std::set<std::string_view> explicitLocals_;
    int depth_ = 0;
    int loopStart_ = 0;
    std::vector<int> breaks_;
};

/// A line of interpreter mode: either code or an error.
struct LineOutcome {
    std::unique_ptr<Bytecode> code;
    CompileError error;
};
/// Compiles statements that are added to a running program: they see its globals and outermost functions,
/// and what earlier lines defined; new variables are theirs, new globals an error.
LineOutcome compileLine(std::string_view text, const LinkedCode& surroundings);

}  // namespace tiller::simulator::urscript
