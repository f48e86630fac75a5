// SPDX-License-Identifier: MIT
// All names are resolved at compile time, so a program that calls an unknown function does not start.

#include "robot/simulator/urscript/compiler.h"

#include <utility>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/lexer.h"
#include "robot/simulator/urscript/parser.h"

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

std::unique_ptr<Bytecode> Compiler::run() {
    const Function& main = tree_.functions.front();
    out_->raw = main.kind == FunctionKind::Raw;
    out_->kind = main.kind == FunctionKind::Sec ? ProgramKind::Secondary : ProgramKind::Main;
    out_->name = out_->raw ? options_.rawName : std::string(main.name);
    out_->options = options_;
    collectGlobals();
    out_->functions.resize(tree_.functions.size());
    for (const Function& f : tree_.functions) {
        function(f);
    }
    return std::move(out_);
}

void Compiler::function(const Function& f) {
    enter(f);
    code_->name = std::string(f.name);
    code_->kind = f.kind;
    code_->outermost = isOutermost(f);
    for (const auto& parameter : f.parameters) {
        code_->optional.push_back(parameter.defaultValue != nullptr);
    }
    depth_ = 0;
    const bool outermost = f.index == 0;
    if (!outermost) {
        for (const auto& parameter : f.parameters) {
            localSlot(parameter.name);
        }
        code_->parameters = static_cast<int>(f.parameters.size());
        collectLocals(f.body);
        for (const auto& parameter : f.parameters) {
            defaultOf(f, parameter);
        }
    } else {
        for (const auto& parameter : f.parameters) {
            if (parameter.defaultValue != nullptr) {
                expression(parameter.defaultValue);
                emit(Op::StoreGlobal, f.at, globalSlot(parameter.name), 0, -1);
            }
        }
    }
    block(f.body);
    emit(Op::ReturnNone, f.at);
    code_->locals = static_cast<int>(code_->localNames.size());
}

void Compiler::defaultOf(const Function& f, const ast::Parameter& parameter) {
    const int slot = localSlot(parameter.name);
    if (parameter.defaultValue == nullptr) {
        return;  // the caller must pass a parameter without a default
    }
    const int skip = emit(Op::JumpIfSet, f.at, 0, slot);
    expression(parameter.defaultValue);
    emit(Op::DeclareLocal, f.at, slot, 0, -1);
    land(skip);
}

void Compiler::block(const Block& statements) {
    for (const Stmt* s : statements) {
        statement(*s);
    }
}

void Compiler::statement(const Stmt& s) {
    switch (s.kind) {
        case StmtKind::Assign:
            assign(s);
            break;
        case StmtKind::Expression:
            expression(s.value);
            emit(Op::Pop, s.at, 0, 0, -1);
            break;
        case StmtKind::If:
            ifStatement(s);
            break;
        case StmtKind::While:
            whileStatement(s);
            break;
        case StmtKind::Break:
            breaks_.push_back(emit(Op::Jump, s.at));
            break;
        case StmtKind::Continue:
            emit(Op::Jump, s.at, loopStart_);
            break;
        case StmtKind::Return:
            if (s.value != nullptr) {
                expression(s.value);
                emit(Op::Return, s.at, 0, 0, -1);
            } else {
                emit(Op::ReturnNone, s.at);
            }
            break;
        case StmtKind::Halt:
            emit(Op::Halt, s.at);
            break;
        case StmtKind::Pause:
            emit(Op::Pause, s.at);
            break;
        case StmtKind::Join:
        case StmtKind::Kill:
            expression(s.value);
            emit(s.kind == StmtKind::Join ? Op::Join : Op::Kill, s.at, 0, 0, -1);
            break;
        case StmtKind::EnterCritical:
            emit(Op::EnterCritical, s.at);
            break;
        case StmtKind::ExitCritical:
            emit(Op::ExitCritical, s.at);
            break;
        case StmtKind::Label:
            out_->labels.push_back({s.number, std::string(s.text)});
            emit(Op::Label, s.at, static_cast<int>(out_->labels.size()) - 1);
            break;
        case StmtKind::Definition:
            break;  // compiled separately
    }
}

void Compiler::ifStatement(const Stmt& s) {
    std::vector<int> exits;
    for (std::size_t i = 0; i < s.blocks.size(); ++i) {
        int skip = -1;
        if (i < s.conditions.size()) {
            expression(s.conditions[i]);
            skip = emit(Op::JumpIfFalse, s.conditions[i]->at, 0, 0, -1);
        }
        block(s.blocks[i]);
        if (i + 1 < s.blocks.size()) {
            exits.push_back(emit(Op::Jump, s.at));
        }
        if (skip >= 0) {
            land(skip);
        }
    }
    for (const int exit : exits) {
        land(exit);
    }
}

void Compiler::whileStatement(const Stmt& s) {
    const int outerStart = std::exchange(loopStart_, here());
    std::vector<int> outerBreaks = std::exchange(breaks_, {});
    expression(s.conditions[0]);
    const int leave = emit(Op::JumpIfFalse, s.at, 0, 0, -1);
    block(s.blocks[0]);
    emit(Op::Jump, s.at, loopStart_);
    land(leave);
    for (const int jump : breaks_) {
        land(jump);
    }
    loopStart_ = outerStart;
    breaks_ = std::move(outerBreaks);
}

void Compiler::assign(const Stmt& s) {
    const bool outermost = function_->index == 0;
    const Expr* root = rootOf(s.target);
    if (root != s.target && root->text == "digital_out" && s.target->kind == ExprKind::Index &&
        s.target->children.size() == 2 && s.scope == AssignScope::Unqualified &&
        resolve(root->text).index < 0) {
        // `digital_out[n] = True` sets an output on old controllers. python-urx still uses it.
        expression(s.target->children[1]);
        expression(s.value);
        emit(Op::CallBuiltin, s.at, findBuiltin("set_digital_out"), 2, -1);
        emit(Op::Pop, s.at, 0, 0, -1);
        return;
    }
    if (root != s.target) {
        Path path = pathOf(s.target, s.scope == AssignScope::Global);
        expression(s.value);
        out_->paths.push_back(std::move(path));
        emit(Op::StorePath, s.at, static_cast<int>(out_->paths.size()) - 1, 0,
             -1 - out_->paths.back().indexValues);
        return;
    }
    expression(s.value);
    if (s.scope == AssignScope::Local && !outermost) {
        emit(Op::DeclareLocal, s.at, localSlot(root->text), 0, -1);
        return;
    }
    Slot slot = s.scope == AssignScope::Global ? Slot{true, globalSlot(root->text)} : resolve(root->text);
    if (slot.index < 0) {
        slot = {false, localSlot(root->text)};
    }
    emit(slot.global ? Op::StoreGlobal : Op::StoreLocal, s.at, slot.index, 0, -1);
}

Program::Program(std::unique_ptr<const Bytecode> code) : code_(std::move(code)) {}
Program::~Program() = default;
const std::string& Program::name() const {
    return code_->name;
}
ProgramKind Program::kind() const {
    return code_->kind;
}
bool Program::isRaw() const {
    return code_->raw;
}
bool Program::commandsMotion() const {
    return code_->commandsMotion;
}

LineOutcome compileLine(std::string_view text, const LinkedCode& surroundings) {
    LineOutcome out;
    ParseOutcome parsed = parseStatements(text);
    if (parsed.error) {
        out.error = *parsed.error;
        return out;
    }
    Compiler compiler(parsed.tree, surroundings.program.code->options, &surroundings);
    out.code = compiler.run();
    if (compiler.error()) {
        out.error = *compiler.error();
        out.code.reset();
    }
    return out;
}

CompileOutcome compile(std::string_view source, const CompileOptions& options) {
    CompileOutcome out;
    ParseOutcome parsed = parse(source);
    if (parsed.error) {
        out.error = *parsed.error;
        return out;
    }
    Compiler compiler(parsed.tree, options);
    std::unique_ptr<Bytecode> code = compiler.run();
    if (compiler.error()) {
        out.error = *compiler.error();
        return out;
    }
    out.program = std::make_shared<const Program>(std::move(code));
    return out;
}

bool isAvailable(std::string_view builtin, const CompileOptions& options) {
    const int index = findBuiltin(builtin);
    const bool isMissing = std::ranges::find(options.missing, builtin) != options.missing.end();
    return index >= 0 && !isMissing &&
           (!options.version || builtins()[static_cast<std::size_t>(index)].since.availableIn(
                                    *options.version, options.isListed));
}

bool isReservedName(std::string_view name) {
    return isKeyword(name) || findBuiltin(name) >= 0;
}

}  // namespace tiller::simulator::urscript
