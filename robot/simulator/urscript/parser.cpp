// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/parser.h"

#include "robot/simulator/urscript/expression_parser.h"

namespace tiller::simulator::urscript {

using ast::AssignScope;
using ast::Block;
using ast::Expr;
using ast::ExprKind;
using ast::Function;
using ast::FunctionKind;
using ast::Stmt;
using ast::StmtKind;

namespace {

class Parser : private ExpressionParser {
public:
    Parser(std::string_view source, const std::vector<Token>& tokens, ast::Tree& tree)
        : ExpressionParser(source, tokens, tree) {}

    void unit();
    void statements();

private:
    Function* definition(Function* parent);
    Block block(Function& owner);
    Stmt* statement(Function& owner);
    Stmt* loopStatement(StmtKind kind);
    Stmt* ifStatement(Function& owner);
    Stmt* assignment(const Token& name);
    Stmt* simpleStatement();
    void checkTarget(const Expr* target, const Token& at) const;
    void skipLabels();

    int loops_ = 0;
};

void Parser::skipLabels() {
    while (peek().kind == TokenKind::Label) {
        take();
    }
}

void Parser::unit() {
    skipLabels();
    if (peek().kind == TokenKind::KwDef || peek().kind == TokenKind::KwSec) {
        definition(nullptr);
        skipLabels();
        if (peek().kind != TokenKind::End) {
            fail(peek());
        }
        return;
    }
    statements();
}

void Parser::statements() {
    Function& raw = newFunction(FunctionKind::Raw, peek(), nullptr);
    raw.body = block(raw);
    if (peek().kind != TokenKind::End) {
        fail(peek());
    }
}

Function* Parser::definition(Function* parent) {
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

Block Parser::block(Function& owner) {
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

Stmt* Parser::statement(Function& owner) {
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
            // A value must be on the same line as its `return`. Otherwise, the next line is a separate
            // statement.
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

Stmt* Parser::loopStatement(StmtKind kind) {
    if (loops_ == 0) {
        fail(peek());
    }
    return newStmt(kind, take());
}

Stmt* Parser::ifStatement(Function& owner) {
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

Stmt* Parser::assignment(const Token& name) {
    Expr* target = variable(name);
    target = postfix(target);
    const Token& sign = expect(TokenKind::Assign);
    Stmt* s = newStmt(StmtKind::Assign, name);
    checkTarget(target, sign);
    s->target = target;
    s->value = expression();
    return s;
}

// Parses an assignment, or an expression whose result is not used.
Stmt* Parser::simpleStatement() {
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
    // A variable name alone has no effect. Published programs contain such statements after `else:`.
    const bool isBareName = e->kind == ExprKind::Variable && peek().line != first.line && isAssigned(e->text);
    if (!isBareName && e->kind != ExprKind::Call && e->kind != ExprKind::Method && e->kind != ExprKind::Run) {
        fail(first);
    }
    Stmt* s = newStmt(StmtKind::Expression, first);
    s->value = e;
    return s;
}

void Parser::checkTarget(const Expr* target, const Token& at) const {
    while (target->kind == ExprKind::Index || target->kind == ExprKind::Member) {
        target = target->children[0];
    }
    if (target->kind != ExprKind::Variable) {
        fail(at);
    }
}

ParseOutcome parseBy(void (Parser::*production)(), std::string_view source) {
    ParseOutcome out;
    LexOutcome lexed = tokenize(source);
    if (lexed.error) {
        out.error = std::move(lexed.error);
        return out;
    }
    try {
        (Parser(source, lexed.tokens, out.tree).*production)();
    } catch (ParseFailure& failure) {
        out.error = std::move(failure.error);
    }
    return out;
}

}  // namespace

ParseOutcome parse(std::string_view source) {
    return parseBy(&Parser::unit, source);
}

ParseOutcome parseStatements(std::string_view source) {
    return parseBy(&Parser::statements, source);
}

}  // namespace tiller::simulator::urscript
