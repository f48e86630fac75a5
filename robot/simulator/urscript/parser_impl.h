// SPDX-License-Identifier: MIT
#pragma once

// The parser itself; parser.cpp holds definitions and statements, parser_expressions.cpp the rest. Others
// include parser.h.

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/simulator/urscript/lexer.h"
#include "robot/simulator/urscript/parser.h"

namespace tiller::simulator::urscript {

// Thrown and caught inside the parser only: every production would otherwise hand a failure upwards by hand.
struct ParseFailure {
    CompileError error;
};

class Parser {
public:
    Parser(std::string_view source, const std::vector<Token>& tokens, ast::Tree& tree)
        : source_(source), tokens_(tokens), tree_(tree) {}

    void unit();
    void statements();

private:
    // ---- tokens
    const Token& peek(std::size_t ahead = 0) const {
        return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
    }
    const Token& take() {
        const Token& token = peek();
        if (token.kind != TokenKind::End) {
            ++at_;
        }
        return token;
    }
    bool accept(TokenKind kind) {
        if (peek().kind != kind) {
            return false;
        }
        ++at_;
        return true;
    }
    const Token& expect(TokenKind kind) {
        if (peek().kind != kind) {
            fail(peek());
        }
        return take();
    }
    // Members may be called like keywords: time() gives `sec`.
    const Token& memberName() {
        if (peek().kind < TokenKind::KwDef && peek().kind != TokenKind::Identifier) {
            fail(peek());
        }
        return take();
    }
    [[noreturn]] void fail(const Token& token) const {
        throw ParseFailure{syntaxError(source_, token.line, token.column)};
    }

    // Recursion of productions is bounded here, and with it the stack.
    class Level {
    public:
        explicit Level(Parser& parser) : parser_(parser) {
            if (++parser_.level_ > kMaxNesting) {
                parser_.fail(parser_.peek());
            }
        }
        ~Level() { --parser_.level_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        Parser& parser_;
    };

    // ---- nodes
    ast::Expr* newExpr(ast::ExprKind kind, const Token& token, std::vector<ast::Expr*> children = {}) {
        int depth = 0;
        for (const ast::Expr* child : children) {
            depth = std::max(depth, child->depth);
        }
        if (++depth > kMaxExpressionDepth) {
            fail(token);
        }
        ast::Expr& e = tree_.exprs.emplace_back();
        e.kind = kind;
        e.at = {token.line, token.column};
        e.depth = depth;
        e.children = std::move(children);
        return &e;
    }
    ast::Stmt* newStmt(ast::StmtKind kind, const Token& token) {
        ast::Stmt& s = tree_.stmts.emplace_back();
        s.kind = kind;
        s.at = {token.line, token.column};
        return &s;
    }
    ast::Function& newFunction(ast::FunctionKind kind, const Token& token, ast::Function* parent) {
        ast::Function& f = tree_.functions.emplace_back();
        f.kind = kind;
        f.at = {token.line, token.column};
        f.parent = parent;
        f.index = static_cast<int>(tree_.functions.size()) - 1;
        return f;
    }

    // ---- definitions
    ast::Function* definition(ast::Function* parent);

    // ---- statements
    ast::Block block(ast::Function& owner);
    ast::Stmt* statement(ast::Function& owner);
    ast::Stmt* loopStatement(ast::StmtKind kind);
    ast::Stmt* ifStatement(ast::Function& owner);
    ast::Stmt* assignment(const Token& name);
    ast::Stmt* simpleStatement();
    void checkTarget(const ast::Expr* target, const Token& at) const;

    // ---- expressions, weakest operator first
    static bool startsExpression(TokenKind kind);
    ast::Expr* expression();
    struct Operator {
        int strength;
        ast::ExprKind kind;
    };
    static constexpr int kNotStrength = 2;  // between `and` and the comparisons
    static Operator operatorOf(TokenKind kind);
    ast::Expr* binary(int weakest);
    ast::Expr* unary();
    ast::Expr* variable(const Token& name);
    ast::Expr* primary();
    std::vector<ast::Expr*> items(TokenKind close);
    ast::Expr* poseOrIndex(const Token& name);
    ast::Expr* structLiteral(const Token& token);
    ast::Expr* call(const Token& name);
    ast::Expr* postfix(ast::Expr* e);

    std::string_view source_;
    const std::vector<Token>& tokens_;
    ast::Tree& tree_;
    std::size_t at_ = 0;
    int level_ = 0;
    int loops_ = 0;
};

}  // namespace tiller::simulator::urscript
