// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/expression_compiler.h"

namespace tiller::simulator::urscript {

using ast::AssignScope;
using ast::Block;
using ast::Expr;
using ast::ExprKind;
using ast::Function;
using ast::FunctionKind;
using ast::Position;
using ast::Stmt;
using ast::StmtKind;

namespace {

Method methodOf(std::string_view name) {
    static constexpr std::pair<std::string_view, Method> kMethods[] = {
        {"append", Method::Append},
        {"pop", Method::Pop},
        {"insert", Method::Insert},
        {"clear", Method::Clear},
        {"length", Method::Length},
        {"capacity", Method::Capacity},
        {"to_string", Method::ToString},
        {"extend", Method::Extend},
        {"remove", Method::Remove},
        {"slice", Method::Slice},
        {"excess_capacity", Method::ExcessCapacity},
    };
    for (const auto& [spelling, method] : kMethods) {
        if (spelling == name) {
            return method;
        }
    }
    return Method::Unknown;
}

}  // namespace

// Emits the index expressions of an element or member, outermost first.
Path ExpressionCompiler::pathOf(const Expr* target, bool global) {
    std::vector<const Expr*> chain;
    while (target->kind != ExprKind::Variable) {
        chain.push_back(target);
        target = target->children[0];
    }
    Path path;
    const Slot slot = global ? Slot{true, globalSlot(target->text)} : resolve(target->text);
    if (slot.index < 0) {
        nameNotFound(target->at, target->text);
    }
    path.global = slot.global;
    path.slot = std::max(slot.index, 0);
    for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
        const Expr* e = *it;
        if (e->kind == ExprKind::Member) {
            path.steps.emplace_back(Path::Step::Member, std::string(e->text));
            continue;
        }
        const std::size_t indices = e->children.size() - 1;
        path.steps.emplace_back(indices == 1 ? Path::Step::Index : Path::Step::Index2, std::string());
        path.indexValues += static_cast<int>(indices);
        for (std::size_t i = 1; i <= indices; ++i) {
            expression(e->children[i]);
        }
    }
    return path;
}

bool ExpressionCompiler::isPath(const Expr* e) {
    while (e->kind == ExprKind::Index || e->kind == ExprKind::Member) {
        e = e->children[0];
    }
    return e->kind == ExprKind::Variable;
}

void ExpressionCompiler::expression(const Expr* e) {
    switch (e->kind) {
        case ExprKind::Int:
            emit(Op::PushInt, e->at, e->integer, 0, 1);
            return;
        case ExprKind::Float:
            emit(Op::PushConstant, e->at, constant(e->number), 0, 1);
            return;
        case ExprKind::Bool:
            emit(e->integer ? Op::PushTrue : Op::PushFalse, e->at, 0, 0, 1);
            return;
        case ExprKind::None:
            emit(Op::PushNone, e->at, 0, 0, 1);
            return;
        case ExprKind::String:
            emit(Op::PushConstant, e->at, text(e->text), 0, 1);
            return;
        case ExprKind::Variable: {
            const Slot slot = resolve(e->text);
            if (slot.index < 0) {
                nameNotFound(e->at, e->text);
            }
            emit(slot.global ? Op::LoadGlobal : Op::LoadLocal, e->at, std::max(slot.index, 0), 0, 1);
            return;
        }
        case ExprKind::And:
        case ExprKind::Or: {
            expression(e->children[0]);
            const int skip =
                emit(e->kind == ExprKind::And ? Op::JumpIfFalseKeep : Op::JumpIfTrueKeep, e->at, 0, 0, -1);
            expression(e->children[1]);
            emit(Op::ToBool, e->at);
            land(skip);
            return;
        }
        case ExprKind::Call:
            call(e);
            return;
        case ExprKind::Method:
            method(e);
            return;
        case ExprKind::Run: {
            const Callee f = findFunction(e->text);
            if (!f || f.kind != FunctionKind::Thread) {
                nameNotFound(e->at, e->text);
            }
            emit(Op::Run, e->at, std::max(f.index, 0), 0, 1);
            return;
        }
        default:
            break;
    }
    for (const Expr* child : e->children) {
        expression(child);
    }
    const int count = static_cast<int>(e->children.size());
    switch (e->kind) {
        case ExprKind::PoseLiteral:
            emit(Op::MakePose, e->at, 0, 0, -5);
            break;
        case ExprKind::ListLiteral:
            emit(Op::MakeList, e->at, count, 0, 1 - count);
            break;
        case ExprKind::StructLiteral:
            if (options_.version && !kStructSince.availableIn(*options_.version, options_.isListed)) {
                nameNotFound(e->at, "struct");
            }
            out_->shapes.emplace_back(e->names.begin(), e->names.end());
            emit(Op::MakeStruct, e->at, static_cast<int>(out_->shapes.size()) - 1, 0, 1 - count);
            break;
        case ExprKind::Index:
            emit(count == 2 ? Op::Index : Op::Index2, e->at, 0, 0, 1 - count);
            break;
        case ExprKind::Member:
            emit(Op::Member, e->at, text(e->text));
            break;
        default:
            emit(operatorOf(e->kind), e->at, 0, 0, 1 - count);
            break;
    }
}

Op ExpressionCompiler::operatorOf(ExprKind kind) {
    switch (kind) {
        case ExprKind::Negate:
            return Op::Negate;
        case ExprKind::Plus:
            return Op::Plus;
        case ExprKind::Not:
            return Op::Not;
        case ExprKind::Subtract:
            return Op::Subtract;
        case ExprKind::Multiply:
            return Op::Multiply;
        case ExprKind::Divide:
            return Op::Divide;
        case ExprKind::Modulo:
            return Op::Modulo;
        case ExprKind::Equal:
            return Op::Equal;
        case ExprKind::NotEqual:
            return Op::NotEqual;
        case ExprKind::Less:
            return Op::Less;
        case ExprKind::Greater:
            return Op::Greater;
        case ExprKind::LessEqual:
            return Op::LessEqual;
        case ExprKind::GreaterEqual:
            return Op::GreaterEqual;
        case ExprKind::Xor:
            return Op::Xor;
        default:
            return Op::Add;
    }
}

void ExpressionCompiler::method(const Expr* e) {
    MethodCall call;
    call.name = std::string(e->text);
    call.method = methodOf(e->text);
    call.arguments = static_cast<int>(e->children.size()) - 1;
    call.onPath = isPath(e->children[0]);
    int operands = call.arguments;
    if (call.onPath) {
        call.path = pathOf(e->children[0]);
        operands += call.path.indexValues;
    } else {
        expression(e->children[0]);
        ++operands;
    }
    for (std::size_t i = 1; i < e->children.size(); ++i) {
        expression(e->children[i]);
    }
    out_->methods.push_back(std::move(call));
    emit(Op::CallMethod, e->at, static_cast<int>(out_->methods.size()) - 1, 0, 1 - operands);
}

void ExpressionCompiler::call(const Expr* e) {
    if (e->children.size() > 255) {
        report(e->at, "Too many arguments: " + std::string(e->text));
        return;
    }
    std::vector<Formal> formals;
    const Callee f = findFunction(e->text);
    int builtin = -1;
    if (f && f.kind != FunctionKind::Thread && f.here != nullptr) {
        for (const auto& parameter : f.here->parameters) {
            formals.push_back({parameter.name, {}, parameter.defaultValue == nullptr, nullptr});
        }
    } else if (f && f.kind != FunctionKind::Thread) {
        for (std::size_t i = 0; i < f.elsewhere->optional.size(); ++i) {
            formals.push_back({f.elsewhere->localNames[i], {}, !f.elsewhere->optional[i], nullptr});
        }
    } else {
        if (!isAvailable(e->text, options_)) {
            nameNotFound(e->at, e->text);
        } else {
            builtin = findBuiltin(e->text);
            out_->commandsMotion |= (row(builtin).flags & kMotion) != 0;
            out_->clearsInterpreter |= (row(builtin).flags & kClearsInterpreter) != 0;
            for (const auto& parameter : row(builtin).parameters) {
                formals.push_back(
                    {parameter.name, parameter.alias, parameter.required, &parameter.defaultValue});
            }
        }
    }
    int pushed = 0;
    if (builtin >= 0 && (row(builtin).flags & kAnyArguments) != 0) {
        for (const Expr* argument : e->children) {
            expression(argument);
        }
        pushed = static_cast<int>(e->children.size());
    } else {
        pushed = arguments(e, formals);
    }
    emit(builtin >= 0 ? Op::CallBuiltin : Op::Call, e->at, builtin >= 0 ? builtin : std::max(f.index, 0),
         pushed, 1 - pushed);
}

// Emits one value per parameter, in parameter order. Wrong arguments are reported when the call is executed.
int ExpressionCompiler::arguments(const Expr* e, const std::vector<Formal>& formals) {
    std::vector<const Expr*> given(formals.size(), nullptr);
    std::string problem;
    for (std::size_t i = 0; i < e->children.size(); ++i) {
        std::size_t place = i;
        if (!e->names[i].empty()) {
            place = static_cast<std::size_t>(std::find_if(formals.begin(), formals.end(),
                                                          [&](const Formal& formal) {
                                                              return formal.name == e->names[i] ||
                                                                     formal.alias == e->names[i];
                                                          }) -
                                             formals.begin());
        }
        if (place >= formals.size()) {
            problem = e->names[i].empty() ? "takes at most " + std::to_string(formals.size()) + " arguments"
                                          : "has no argument named '" + std::string(e->names[i]) + "'";
            expression(e->children[i]);  // reports unknown names in the argument
            emit(Op::Pop, e->at, 0, 0, -1);
        } else if (given[place] != nullptr) {
            problem = "got argument '" + std::string(formals[place].name) + "' twice";
            expression(e->children[i]);
            emit(Op::Pop, e->at, 0, 0, -1);
        } else {
            given[place] = e->children[i];
        }
    }
    for (std::size_t i = 0; i < formals.size(); ++i) {
        if (given[i] != nullptr) {
            expression(given[i]);
        } else if (formals[i].value != nullptr && !formals[i].value->isUnset()) {
            const Value& v = *formals[i].value;
            emit(Op::PushConstant, e->at,
                 v.is(Value::Type::String) ? text(v.string()) : constant(v.detached()), 0, 1);
        } else {
            emit(Op::PushUnset, e->at, 0, 0, 1);
            if (formals[i].required && problem.empty()) {
                problem = "is missing argument '" + std::string(formals[i].name) + "'";
            }
        }
    }
    if (!problem.empty()) {
        emit(Op::Throw, e->at, text("Type error: " + std::string(e->text) + " " + problem));
    }
    return static_cast<int>(formals.size());
}

}  // namespace tiller::simulator::urscript
