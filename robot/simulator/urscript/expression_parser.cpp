// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/expression_parser.h"

namespace tiller::simulator::urscript {

using ast::Expr;
using ast::ExprKind;

bool ExpressionParser::startsExpression(TokenKind kind) {
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

Expr* ExpressionParser::expression() {
    const Level level(*this);
    return binary(0);
}

ExpressionParser::Operator ExpressionParser::operatorOf(TokenKind kind) {
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

Expr* ExpressionParser::binary(int weakest) {
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

Expr* ExpressionParser::unary() {
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

Expr* ExpressionParser::variable(const Token& name) {
    Expr* e = newExpr(ExprKind::Variable, name);
    e->text = name.text;
    return e;
}

Expr* ExpressionParser::primary() {
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
            if (accept(TokenKind::Comma)) {
                // python-urx sends "(x, y, z)" for a list.
                std::vector<Expr*> elements = items(TokenKind::RightParen);
                elements.insert(elements.begin(), e);
                return newExpr(ExprKind::ListLiteral, token, std::move(elements));
            }
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

// Parses the items after the opening bracket, up to and including `close`.
std::vector<Expr*> ExpressionParser::items(TokenKind close) {
    std::vector<Expr*> out;
    if (!accept(close)) {
        do {
            out.push_back(expression());
        } while (accept(TokenKind::Comma));
        expect(close);
    }
    return out;
}

// After `p[`, six elements are a pose. One or two elements are indices into a variable named p.
Expr* ExpressionParser::poseOrIndex(const Token& name) {
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

Expr* ExpressionParser::structLiteral(const Token& token) {
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

Expr* ExpressionParser::call(const Token& name) {
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
                    fail(peek());  // positional arguments must come first
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

Expr* ExpressionParser::postfix(Expr* e) {
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
}  // namespace tiller::simulator::urscript
