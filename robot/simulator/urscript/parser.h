// SPDX-License-Identifier: MIT
#pragma once

// Converts tokens to the syntax tree. Newlines are not separators: an operand is extended as far as the
// grammar allows, and since no statement begins with an operator or a bracket, the next statement begins
// after it.

#include <optional>
#include <string_view>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

/// Maximum nesting of expressions and blocks; more is a syntax error.
inline constexpr int kMaxNesting = 150;
/// Longest path through an expression tree, chains of operators included.
inline constexpr int kMaxExpressionDepth = 1500;

struct ParseOutcome {
    ast::Tree tree;
    std::optional<CompileError> error;
};

/// `source` must outlive the tree.
ParseOutcome parse(std::string_view source);
/// The same for statements alone: a `def` among them is a function, not a program.
ParseOutcome parseStatements(std::string_view source);

}  // namespace tiller::simulator::urscript
