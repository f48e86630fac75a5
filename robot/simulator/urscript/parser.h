// SPDX-License-Identifier: MIT
#pragma once

// Converts tokens to the syntax tree. Newlines are not separators: an operand extends as far as the grammar
// allows. Since no statement begins with an operator or a bracket, the next statement begins after the
// operand.

#include <optional>
#include <string_view>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

/// Maximum nesting of expressions and blocks. Deeper nesting is a syntax error.
inline constexpr int kMaxNesting = 150;
/// Maximum depth of an expression tree, including chains of operators.
inline constexpr int kMaxExpressionDepth = 1500;

struct ParseOutcome {
    ast::Tree tree;
    std::optional<CompileError> error;
};

/// `source` must outlive the tree.
ParseOutcome parse(std::string_view source);
/// Parses statements only. A `def` defines a function instead of a program.
ParseOutcome parseStatements(std::string_view source);

}  // namespace tiller::simulator::urscript
