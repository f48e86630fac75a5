// SPDX-License-Identifier: MIT
#pragma once

// Code generator: translates the syntax tree to bytecode, statement by statement. Other files include
// program.h instead.

#include <memory>
#include <string_view>
#include <vector>

#include "robot/simulator/urscript/expression_compiler.h"

namespace tiller::simulator::urscript {

class Compiler : public ExpressionCompiler {
public:
    /// surroundings  the program to which an interpreter mode line is added; null for a whole program
    Compiler(const ast::Tree& tree, const CompileOptions& options, const LinkedCode* surroundings = nullptr)
        : ExpressionCompiler(tree, options, surroundings) {}

    std::unique_ptr<Bytecode> run();

private:
    void function(const ast::Function& f);
    void defaultOf(const ast::Function& f, const ast::Parameter& parameter);
    void block(const ast::Block& statements);
    void statement(const ast::Stmt& s);
    void ifStatement(const ast::Stmt& s);
    void whileStatement(const ast::Stmt& s);
    void assign(const ast::Stmt& s);

    // the function being compiled
    int loopStart_ = 0;
    std::vector<int> breaks_;
};

/// Code of an interpreter mode line, or an error.
struct LineOutcome {
    std::unique_ptr<Bytecode> code;
    CompileError error;
};
/// Compiles statements that are added to a running program. They can use its globals and outermost functions,
/// and the definitions of earlier lines. New variables are local to the statements. New globals are an error.
LineOutcome compileLine(std::string_view text, const LinkedCode& surroundings);

}  // namespace tiller::simulator::urscript
