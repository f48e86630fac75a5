// SPDX-License-Identifier: MIT
#pragma once

// Parser for expressions, with access to tokens and creation of nodes. The statement parser (parser.cpp) also
// uses these functions.

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/simulator/urscript/ast.h"
#include "robot/simulator/urscript/lexer.h"
#include "robot/simulator/urscript/parser.h"

namespace tiller::simulator::urscript {

// Thrown and caught only in the parser, so that the parse functions need no error return value.
struct ParseFailure {
    CompileError error;
};

/// Reads tokens sequentially and creates the nodes of the tree.
class TreeBuilder {
protected:
    TreeBuilder(std::string_view source, const std::vector<Token>& tokens, ast::Tree& tree)
        : source_(source), tokens_(tokens), tree_(tree) {}

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
    // Member names may be keywords: time() returns a struct with `sec`.
    const Token& memberName() {
        if (peek().kind < TokenKind::KwDef && peek().kind != TokenKind::Identifier) {
            fail(peek());
        }
        return take();
    }
    [[noreturn]] void fail(const Token& token) const {
        // If an `end` is missing, the last `end` in the first column has closed an inner block. Report the
        // error there.
        if (token.kind == TokenKind::End && tokens_.size() > 1) {
            const Token& last = tokens_[tokens_.size() - 2];
            if (last.kind == TokenKind::KwEnd && last.column == 1) {
                throw ParseFailure{syntaxError(source_, last.line, last.column)};
            }
        }
        throw ParseFailure{syntaxError(source_, token.line, token.column)};
    }

    /// True if the text contains an assignment to a variable with this name.
    bool isAssigned(std::string_view name) const {
        const auto assigns = [name](const Token& token, const Token& next) {
            return token.kind == TokenKind::Identifier && token.text == name &&
                   next.kind == TokenKind::Assign;
        };
        return std::adjacent_find(tokens_.begin(), tokens_.end(), assigns) != tokens_.end();
    }

    // Limits the recursion depth of the parse functions, and therefore the stack size.
    class Level {
    public:
        explicit Level(TreeBuilder& builder) : builder_(builder) {
            if (++builder_.level_ > kMaxNesting) {
                builder_.fail(builder_.peek());
            }
        }
        ~Level() { --builder_.level_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        TreeBuilder& builder_;
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

private:
    std::string_view source_;
    const std::vector<Token>& tokens_;
    ast::Tree& tree_;
    std::size_t at_ = 0;
    int level_ = 0;
};

class ExpressionParser : protected TreeBuilder {
protected:
    using TreeBuilder::TreeBuilder;

    static bool startsExpression(TokenKind kind);
    ast::Expr* expression();
    ast::Expr* variable(const Token& name);
    ast::Expr* primary();
    ast::Expr* postfix(ast::Expr* e);

private:
    struct Operator {
        int strength;  ///< 0 is the lowest precedence
        ast::ExprKind kind;
    };
    static constexpr int kNotStrength = 2;  // between `and` and the comparison operators
    static Operator operatorOf(TokenKind kind);
    ast::Expr* binary(int weakest);
    ast::Expr* unary();
    std::vector<ast::Expr*> items(TokenKind close);
    ast::Expr* poseOrIndex(const Token& name);
    ast::Expr* structLiteral(const Token& token);
    ast::Expr* call(const Token& name);
};

}  // namespace tiller::simulator::urscript
