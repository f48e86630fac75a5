// SPDX-License-Identifier: MIT
#pragma once

// Code generation for expressions, calls and the paths of nested assignments.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/code_names.h"

namespace tiller::simulator::urscript {

class ExpressionCompiler : public CodeNames {
protected:
    ExpressionCompiler(const ast::Tree& tree, const CompileOptions& options, const LinkedCode* surroundings)
        : CodeNames(tree, surroundings), options_(options) {}

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

    // ---- expressions
    void expression(const ast::Expr* e);
    Path pathOf(const ast::Expr* target, bool global = false);

    const CompileOptions& options_;
    int depth_ = 0;  ///< stack depth at the current position of the function

private:
    static bool isPath(const ast::Expr* e);
    static Op operatorOf(ast::ExprKind kind);
    void method(const ast::Expr* e);

    // ---- calls
    struct Formal {
        std::string_view name;
        std::string_view alias;
        bool required;
        const Value* value;  // default value of a builtin parameter
    };
    void call(const ast::Expr* e);
    static const Builtin& row(int builtin) { return builtins()[static_cast<std::size_t>(builtin)]; }
    int arguments(const ast::Expr* e, const std::vector<Formal>& formals);

    std::map<std::string, int, std::less<>> texts_;
};

}  // namespace tiller::simulator::urscript
