// SPDX-License-Identifier: MIT
#pragma once

// Tokens to tree. Newlines separate nothing: an operand is extended as far as the grammar allows, and since
// no statement begins with an operator or a bracket the next statement begins where it stops.

#include <optional>
#include <string_view>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

/// How deep expressions and blocks may nest; more is a syntax error.
inline constexpr int kMaxNesting = 150;
/// Longest path through an expression tree, chains of operators included.
inline constexpr int kMaxExpressionDepth = 1500;

struct ParseOutcome {
    ast::Tree tree;
    std::optional<CompileError> error;
};

/// `source` must outlive the tree.
ParseOutcome parse(std::string_view source);
/// The same for statements alone: a `def` in them is a function, not a program.
ParseOutcome parseStatements(std::string_view source);

}  // namespace tiller::simulator::urscript
