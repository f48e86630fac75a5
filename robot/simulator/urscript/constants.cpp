// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/constants.h"

#include <string>
#include <vector>

#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/operators.h"
#include "robot/simulator/urscript/parser.h"

namespace tiller::simulator::urscript {

namespace {

constexpr std::size_t kMaxConstants = 10'000;

Value constantOf(const ast::Expr& e) {
    std::vector<Value> children;
    for (const ast::Expr* child : e.children) {
        children.push_back(constantOf(*child));
    }
    switch (e.kind) {
        case ast::ExprKind::Int:
            return e.integer;
        case ast::ExprKind::Bool:
            return e.integer != 0;
        case ast::ExprKind::Float:
            return e.number;
        case ast::ExprKind::String:
            return Value(std::string(e.text));
        case ast::ExprKind::Negate:
            return negated(children.front());
        case ast::ExprKind::PoseLiteral:
            return makePose(children.data());
        case ast::ExprKind::ListLiteral:
            return makeList(children.data(), children.size(), kMaxConstants);
        case ast::ExprKind::StructLiteral: {
            StructData data;
            for (std::size_t i = 0; i < children.size(); ++i) {
                data.members.emplace_back(std::string(e.names[i]), children[i]);
            }
            return Value::structure(std::move(data));
        }
        default:
            fault("the value is not constant");
    }
}

}  // namespace

Result<Value> constantValue(std::string_view text) {
    const std::string source = "x = " + std::string(text);
    const ParseOutcome parsed = parseStatements(source);
    if (parsed.error) {
        return scriptError(parsed.error->text);
    }
    const ast::Block& body = parsed.tree.functions.front().body;
    if (body.size() != 1 || body.front()->kind != ast::StmtKind::Assign) {
        return scriptError("not a single value");
    }
    try {
        return constantOf(*body.front()->value);
    } catch (const Fault& f) {
        return scriptError(f.text);
    }
}

}  // namespace tiller::simulator::urscript
