// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/parser.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robot/simulator/urscript/lexer.h"

namespace tiller::simulator::urscript {

namespace {

using ast::AssignScope;
using ast::Block;
using ast::Expr;
using ast::ExprKind;
using ast::Function;
using ast::FunctionKind;
using ast::Stmt;
using ast::StmtKind;

// Thrown and caught inside this file only: every production would otherwise hand a failure upwards by hand.
struct Failure {
    CompileError error;
};

class Parser {
public:
    Parser(std::string_view source, const std::vector<Token>& tokens, ast::Tree& tree)
        : source_(source), tokens_(tokens), tree_(tree) {}

    void unit() {
        while (peek().kind == TokenKind::Label) {
            ++at_;
        }
        if (peek().kind == TokenKind::KwDef || peek().kind == TokenKind::KwSec) {
            definition(nullptr);
            while (peek().kind == TokenKind::Label) {
                ++at_;
            }
            if (peek().kind != TokenKind::End) {
                fail(peek());
            }
            return;
        }
        Function& raw = newFunction(FunctionKind::Raw, peek(), nullptr);
        raw.body = block(raw);
        if (peek().kind != TokenKind::End) {
            fail(peek());
        }
    }

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
        throw Failure{syntaxError(source_, token.line, token.column)};
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
    Expr* newExpr(ExprKind kind, const Token& token, std::vector<Expr*> children = {}) {
        int depth = 0;
        for (const Expr* child : children) {
            depth = std::max(depth, child->depth);
        }
        if (++depth > kMaxExpressionDepth) {
            fail(token);
        }
        Expr& e = tree_.exprs.emplace_back();
        e.kind = kind;
        e.at = {token.line, token.column};
        e.depth = depth;
        e.children = std::move(children);
        return &e;
    }
    Stmt* newStmt(StmtKind kind, const Token& token) {
        Stmt& s = tree_.stmts.emplace_back();
        s.kind = kind;
        s.at = {token.line, token.column};
        return &s;
    }
    Function& newFunction(FunctionKind kind, const Token& token, Function* parent) {
        Function& f = tree_.functions.emplace_back();
        f.kind = kind;
        f.at = {token.line, token.column};
        f.parent = parent;
        f.index = static_cast<int>(tree_.functions.size()) - 1;
        return f;
    }

    // ---- definitions
    Function* definition(Function* parent) {
        const Level level(*this);
        const Token& keyword = take();
        const FunctionKind kind = keyword.kind == TokenKind::KwDef   ? FunctionKind::Def
                                  : keyword.kind == TokenKind::KwSec ? FunctionKind::Sec
                                                                     : FunctionKind::Thread;
        if (kind == FunctionKind::Sec && parent != nullptr) {
            fail(keyword);
        }
        Function& f = newFunction(kind, keyword, parent);
        f.name = expect(TokenKind::Identifier).text;
        expect(TokenKind::LeftParen);
        if (peek().kind != TokenKind::RightParen) {
            do {
                ast::Parameter parameter;
                const Token& name = expect(TokenKind::Identifier);
                parameter.name = name.text;
                if (std::any_of(f.parameters.begin(), f.parameters.end(),
                                [&](const auto& p) { return p.name == name.text; })) {
                    fail(name);
                }
                if (accept(TokenKind::Assign)) {
                    parameter.defaultValue = expression();
                }
                f.parameters.push_back(parameter);
            } while (accept(TokenKind::Comma));
        }
        const Token& close = expect(TokenKind::RightParen);
        if (!f.parameters.empty() && kind != FunctionKind::Def) {
            fail(close);
        }
        expect(TokenKind::Colon);
        const int enclosingLoops = std::exchange(loops_, 0);
        f.body = block(f);
        loops_ = enclosingLoops;
        expect(TokenKind::KwEnd);
        return &f;
    }

    // ---- statements
    Block block(Function& owner) {
        const Level level(*this);
        Block out;
        while (true) {
            switch (peek().kind) {
                case TokenKind::End:
                case TokenKind::KwEnd:
                case TokenKind::KwElif:
                case TokenKind::KwElse:
                    return out;
                default:
                    out.push_back(statement(owner));
            }
        }
    }

    Stmt* statement(Function& owner) {
        const Token& token = peek();
        switch (token.kind) {
            case TokenKind::KwDef:
            case TokenKind::KwSec:
            case TokenKind::KwThread: {
                Stmt* s = newStmt(StmtKind::Definition, token);
                s->definition = definition(&owner);
                owner.nested.push_back(s->definition);
                return s;
            }
            case TokenKind::KwIf:
                return ifStatement(owner);
            case TokenKind::KwWhile: {
                Stmt* s = newStmt(StmtKind::While, take());
                s->conditions.push_back(expression());
                expect(TokenKind::Colon);
                ++loops_;
                s->blocks.push_back(block(owner));
                --loops_;
                expect(TokenKind::KwEnd);
                return s;
            }
            case TokenKind::KwBreak:
                return loopStatement(StmtKind::Break);
            case TokenKind::KwContinue:
                return loopStatement(StmtKind::Continue);
            case TokenKind::KwReturn: {
                Stmt* s = newStmt(StmtKind::Return, take());
                // A value stands on the line of its `return`; a bare one is followed by another statement.
                if (peek().line == token.line && startsExpression(peek().kind)) {
                    s->value = expression();
                }
                return s;
            }
            case TokenKind::KwHalt:
                return newStmt(StmtKind::Halt, take());
            case TokenKind::KwPause:
                return newStmt(StmtKind::Pause, take());
            case TokenKind::KwEnterCritical:
                return newStmt(StmtKind::EnterCritical, take());
            case TokenKind::KwExitCritical:
                return newStmt(StmtKind::ExitCritical, take());
            case TokenKind::KwJoin:
            case TokenKind::KwKill: {
                Stmt* s = newStmt(token.kind == TokenKind::KwJoin ? StmtKind::Join : StmtKind::Kill, take());
                s->value = expression();
                return s;
            }
            case TokenKind::Label: {
                Stmt* s = newStmt(StmtKind::Label, take());
                s->number = token.integer;
                s->text = token.text;
                return s;
            }
            case TokenKind::KwGlobal:
            case TokenKind::KwLocal: {
                take();
                Stmt* s = assignment(expect(TokenKind::Identifier));
                s->scope = token.kind == TokenKind::KwGlobal ? AssignScope::Global : AssignScope::Local;
                return s;
            }
            default:
                return simpleStatement();
        }
    }

    Stmt* loopStatement(StmtKind kind) {
        if (loops_ == 0) {
            fail(peek());
        }
        return newStmt(kind, take());
    }

    Stmt* ifStatement(Function& owner) {
        Stmt* s = newStmt(StmtKind::If, peek());
        do {
            take();
            s->conditions.push_back(expression());
            expect(TokenKind::Colon);
            s->blocks.push_back(block(owner));
        } while (peek().kind == TokenKind::KwElif);
        if (accept(TokenKind::KwElse)) {
            expect(TokenKind::Colon);
            s->blocks.push_back(block(owner));
        }
        expect(TokenKind::KwEnd);
        return s;
    }

    Stmt* assignment(const Token& name) {
        Expr* target = variable(name);
        target = postfix(target);
        const Token& sign = expect(TokenKind::Assign);
        Stmt* s = newStmt(StmtKind::Assign, name);
        checkTarget(target, sign);
        s->target = target;
        s->value = expression();
        return s;
    }

    // An assignment, or a call whose result is dropped.
    Stmt* simpleStatement() {
        const Token& first = peek();
        if (first.kind != TokenKind::Identifier && first.kind != TokenKind::KwRun) {
            fail(first);
        }
        Expr* e = first.kind == TokenKind::KwRun ? primary() : postfix(primary());
        if (peek().kind == TokenKind::Assign) {
            const Token& sign = take();
            checkTarget(e, sign);
            Stmt* s = newStmt(StmtKind::Assign, first);
            s->target = e;
            s->value = expression();
            return s;
        }
        if (e->kind != ExprKind::Call && e->kind != ExprKind::Method && e->kind != ExprKind::Run) {
            fail(first);
        }
        Stmt* s = newStmt(StmtKind::Expression, first);
        s->value = e;
        return s;
    }

    void checkTarget(const Expr* target, const Token& at) const {
        while (target->kind == ExprKind::Index || target->kind == ExprKind::Member) {
            target = target->children[0];
        }
        if (target->kind != ExprKind::Variable) {
            fail(at);
        }
    }

    // ---- expressions, weakest operator first
    static bool startsExpression(TokenKind kind) {
        switch (kind) {
            case TokenKind::Identifier:
            case TokenKind::Integer:
            case TokenKind::Float:
            case TokenKind::String:
            case TokenKind::LeftParen:
            case TokenKind::LeftBracket:
            case TokenKind::Minus:
            case TokenKind::Plus:
            case TokenKind::KwNot:
            case TokenKind::KwTrue:
            case TokenKind::KwFalse:
            case TokenKind::KwNone:
            case TokenKind::KwStruct:
            case TokenKind::KwRun:
                return true;
            default:
                return false;
        }
    }

    Expr* expression() {
        const Level level(*this);
        return binary(0);
    }

    struct Operator {
        int strength;
        ExprKind kind;
    };
    static constexpr int kNotStrength = 2;  // between `and` and the comparisons

    static Operator operatorOf(TokenKind kind) {
        switch (kind) {
            case TokenKind::KwOr:
                return {0, ExprKind::Or};
            case TokenKind::KwXor:
                return {0, ExprKind::Xor};
            case TokenKind::KwAnd:
                return {1, ExprKind::And};
            case TokenKind::Equal:
                return {3, ExprKind::Equal};
            case TokenKind::NotEqual:
                return {3, ExprKind::NotEqual};
            case TokenKind::Less:
                return {3, ExprKind::Less};
            case TokenKind::Greater:
                return {3, ExprKind::Greater};
            case TokenKind::LessEqual:
                return {3, ExprKind::LessEqual};
            case TokenKind::GreaterEqual:
                return {3, ExprKind::GreaterEqual};
            case TokenKind::Plus:
                return {4, ExprKind::Add};
            case TokenKind::Minus:
                return {4, ExprKind::Subtract};
            case TokenKind::Star:
                return {5, ExprKind::Multiply};
            case TokenKind::Slash:
                return {5, ExprKind::Divide};
            case TokenKind::Percent:
                return {5, ExprKind::Modulo};
            default:
                return {-1, ExprKind::None};
        }
    }

    Expr* binary(int weakest) {
        Expr* left = nullptr;
        if (peek().kind == TokenKind::KwNot) {
            const Level level(*this);
            const Token& token = take();
            left = newExpr(ExprKind::Not, token, {binary(kNotStrength)});
        } else {
            left = unary();
        }
        while (true) {
            const Token& token = peek();
            const Operator op = operatorOf(token.kind);
            if (op.strength < weakest) {
                return left;
            }
            take();
            Expr* right = binary(op.strength + 1);
            left = newExpr(op.kind, token, {left, right});
        }
    }

    Expr* unary() {
        const Token& token = peek();
        if (token.kind != TokenKind::Minus && token.kind != TokenKind::Plus) {
            return postfix(primary());
        }
        const Level level(*this);
        take();
        const bool minus = token.kind == TokenKind::Minus;
        if (minus && peek().kind == TokenKind::Float && peek().number == 2147483648.0 &&
            peek().text == "2147483648") {
            take();
            Expr* e = newExpr(ExprKind::Int, token);
            e->integer = std::numeric_limits<std::int32_t>::min();
            return e;
        }
        return newExpr(minus ? ExprKind::Negate : ExprKind::Plus, token, {unary()});
    }

    Expr* variable(const Token& name) {
        Expr* e = newExpr(ExprKind::Variable, name);
        e->text = name.text;
        return e;
    }

    Expr* primary() {
        const Token& token = take();
        switch (token.kind) {
            case TokenKind::Integer: {
                Expr* e = newExpr(ExprKind::Int, token);
                e->integer = token.integer;
                return e;
            }
            case TokenKind::Float: {
                Expr* e = newExpr(ExprKind::Float, token);
                e->number = token.number;
                return e;
            }
            case TokenKind::KwTrue:
            case TokenKind::KwFalse: {
                Expr* e = newExpr(ExprKind::Bool, token);
                e->integer = token.kind == TokenKind::KwTrue;
                return e;
            }
            case TokenKind::KwNone:
                return newExpr(ExprKind::None, token);
            case TokenKind::String: {
                Expr* e = newExpr(ExprKind::String, token);
                e->text = token.text;
                return e;
            }
            case TokenKind::LeftParen: {
                Expr* e = expression();
                expect(TokenKind::RightParen);
                return e;
            }
            case TokenKind::LeftBracket:
                return newExpr(ExprKind::ListLiteral, token, items(TokenKind::RightBracket));
            case TokenKind::KwStruct:
                return structLiteral(token);
            case TokenKind::KwRun: {
                const Token& name = expect(TokenKind::Identifier);
                expect(TokenKind::LeftParen);
                expect(TokenKind::RightParen);
                Expr* e = newExpr(ExprKind::Run, name);
                e->text = name.text;
                return e;
            }
            case TokenKind::Identifier:
                if (peek().kind == TokenKind::LeftParen) {
                    return call(token);
                }
                if (token.text == "p" && peek().kind == TokenKind::LeftBracket) {
                    return poseOrIndex(token);
                }
                return variable(token);
            default:
                fail(token);
        }
    }

    // After the opening bracket, up to and including `close`.
    std::vector<Expr*> items(TokenKind close) {
        std::vector<Expr*> out;
        if (!accept(close)) {
            do {
                out.push_back(expression());
            } while (accept(TokenKind::Comma));
            expect(close);
        }
        return out;
    }

    // `p[`: six elements make a pose; one or two index a variable of that name.
    Expr* poseOrIndex(const Token& name) {
        const Token& bracket = take();
        std::vector<Expr*> elements = items(TokenKind::RightBracket);
        if (elements.size() == 6) {
            return newExpr(ExprKind::PoseLiteral, name, std::move(elements));
        }
        if (elements.empty() || elements.size() > 2) {
            fail(bracket);
        }
        elements.insert(elements.begin(), variable(name));
        return newExpr(ExprKind::Index, bracket, std::move(elements));
    }

    Expr* structLiteral(const Token& token) {
        expect(TokenKind::LeftParen);
        std::vector<Expr*> values;
        std::vector<std::string_view> names;
        if (!accept(TokenKind::RightParen)) {
            do {
                const Token& name = memberName();
                if (std::find(names.begin(), names.end(), name.text) != names.end()) {
                    fail(name);
                }
                names.push_back(name.text);
                expect(TokenKind::Assign);
                values.push_back(expression());
            } while (accept(TokenKind::Comma));
            expect(TokenKind::RightParen);
        }
        Expr* e = newExpr(ExprKind::StructLiteral, token, std::move(values));
        e->names = std::move(names);
        return e;
    }

    Expr* call(const Token& name) {
        take();
        std::vector<Expr*> values;
        std::vector<std::string_view> names;
        if (!accept(TokenKind::RightParen)) {
            do {
                if (peek().kind == TokenKind::Identifier && peek(1).kind == TokenKind::Assign) {
                    names.push_back(take().text);
                    take();
                } else {
                    if (!names.empty() && !names.back().empty()) {
                        fail(peek());  // positional arguments come first
                    }
                    names.emplace_back();
                }
                values.push_back(expression());
            } while (accept(TokenKind::Comma));
            expect(TokenKind::RightParen);
        }
        Expr* e = newExpr(ExprKind::Call, name, std::move(values));
        e->text = name.text;
        e->names = std::move(names);
        return e;
    }

    Expr* postfix(Expr* e) {
        while (true) {
            const Token& token = peek();
            if (token.kind == TokenKind::LeftBracket) {
                take();
                std::vector<Expr*> parts = items(TokenKind::RightBracket);
                if (parts.empty() || parts.size() > 2) {
                    fail(token);
                }
                parts.insert(parts.begin(), e);
                e = newExpr(ExprKind::Index, token, std::move(parts));
            } else if (token.kind == TokenKind::Dot) {
                take();
                const Token& name = memberName();
                if (accept(TokenKind::LeftParen)) {
                    std::vector<Expr*> parts = items(TokenKind::RightParen);
                    parts.insert(parts.begin(), e);
                    e = newExpr(ExprKind::Method, name, std::move(parts));
                } else {
                    e = newExpr(ExprKind::Member, name, {e});
                }
                e->text = name.text;
            } else {
                return e;
            }
        }
    }

    std::string_view source_;
    const std::vector<Token>& tokens_;
    ast::Tree& tree_;
    std::size_t at_ = 0;
    int level_ = 0;
    int loops_ = 0;
};

}  // namespace

ParseOutcome parse(std::string_view source) {
    ParseOutcome out;
    LexOutcome lexed = tokenize(source);
    if (lexed.error) {
        out.error = std::move(lexed.error);
        return out;
    }
    try {
        Parser(source, lexed.tokens, out.tree).unit();
    } catch (Failure& failure) {
        out.error = std::move(failure.error);
    }
    return out;
}

}  // namespace tiller::simulator::urscript
