// SPDX-License-Identifier: MIT
#pragma once

// The syntax tree between parser and code generator. Nodes are stored in the deques of a Tree and refer to
// each other by pointers. They are never freed individually, so no input can cause deep recursion on
// destruction.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript::ast {

struct Position {
    int line = 1;
    int column = 1;
};

enum class ExprKind : std::uint8_t {
    Int,
    Float,
    Bool,
    None,
    String,
    Variable,
    PoseLiteral,
    ListLiteral,
    StructLiteral,
    Negate,
    Plus,
    Not,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Equal,
    NotEqual,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    And,
    Or,
    Xor,
    Index,   ///< children: object, index [, column]
    Member,  ///< children: object; text = name
    Call,    ///< text = callee; children = arguments, names parallel to them ("" = positional)
    Method,  ///< children: object, arguments...; text = name
    Run,     ///< text = name of the thread
};

struct Expr {
    ExprKind kind = ExprKind::None;
    Position at;
    int depth = 1;
    std::int32_t integer = 0;
    double number = 0;
    std::string_view text;
    std::vector<Expr*> children;
    std::vector<std::string_view> names;
};

struct Function;

enum class StmtKind : std::uint8_t {
    Assign,
    Expression,
    If,
    While,
    Break,
    Continue,
    Return,
    Halt,
    Pause,
    Join,
    Kill,
    EnterCritical,
    ExitCritical,
    Label,
    Definition,
};

enum class AssignScope : std::uint8_t { Unqualified, Global, Local };

struct Stmt;
using Block = std::vector<Stmt*>;

struct Stmt {
    StmtKind kind = StmtKind::Expression;
    Position at;
    AssignScope scope = AssignScope::Unqualified;
    Expr* target = nullptr;         ///< for Assign
    Expr* value = nullptr;          ///< for Assign, Expression, Return (optional), Join, Kill
    std::vector<Expr*> conditions;  ///< for If: one per branch; for While: one
    std::vector<Block> blocks;      ///< for If: one per condition, plus one for else; for While: one
    Function* definition = nullptr;
    int number = 0;  ///< for Label
    std::string_view text;
};

struct Parameter {
    std::string_view name;
    Expr* defaultValue = nullptr;
};

enum class FunctionKind : std::uint8_t { Def, Sec, Thread, Raw };

struct Function {
    FunctionKind kind = FunctionKind::Def;
    Position at;
    std::string_view name;
    std::vector<Parameter> parameters;
    Block body;
    std::vector<Function*> nested;
    Function* parent = nullptr;
    int index = 0;  ///< index in Tree::functions
};

struct Tree {
    std::deque<Expr> exprs;
    std::deque<Stmt> stmts;
    std::deque<Function> functions;  ///< [0] is the program itself
};

}  // namespace tiller::simulator::urscript::ast
