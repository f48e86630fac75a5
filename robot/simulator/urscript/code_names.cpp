// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/code_names.h"

#include <utility>

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

void CodeNames::enter(const Function& f) {
    function_ = &f;
    code_ = &out_->functions[static_cast<std::size_t>(f.index)];
    locals_.clear();
    explicitLocals_.clear();
}

void CodeNames::collectGlobals() {
    for (const auto& parameter : tree_.functions.front().parameters) {
        globalSlot(parameter.name);
    }
    for (const Function& f : tree_.functions) {
        collectGlobals(f.body, f.index == 0);
    }
}

void CodeNames::collectGlobals(const Block& block, bool outermost) {
    for (const Stmt* s : block) {
        if (s->kind == StmtKind::Assign && (outermost || s->scope == AssignScope::Global)) {
            const Expr* target = rootOf(s->target);
            // An element assignment does not declare a variable, unless it is marked `global`.
            if (target == s->target || s->scope == AssignScope::Global) {
                if (surroundings_ != nullptr && s->scope == AssignScope::Global &&
                    findGlobal(target->text) < 0) {
                    report(s->at, "new globals cannot be created in interpreter mode");
                }
                globalSlot(target->text);
            }
        }
        for (const Block& inner : s->blocks) {
            collectGlobals(inner, outermost);
        }
    }
}

void CodeNames::collectLocals(const Block& block) {
    for (const Stmt* s : block) {
        if (s->kind == StmtKind::Assign && s->target->kind == ExprKind::Variable) {
            const std::string_view name = s->target->text;
            if (s->scope == AssignScope::Local) {
                explicitLocals_.insert(name);
            } else if (s->scope == AssignScope::Unqualified && findGlobal(name) < 0) {
                localSlot(name);
            }
        }
        for (const Block& inner : s->blocks) {
            collectLocals(inner);
        }
    }
}

const Expr* CodeNames::rootOf(const Expr* target) {
    while (target->kind != ExprKind::Variable) {
        target = target->children[0];
    }
    return target;
}

int CodeNames::findGlobal(std::string_view name) const {
    if (const auto it = globals_.find(name); it != globals_.end()) {
        return it->second;
    }
    if (surroundings_ != nullptr) {
        if (const auto it = surroundings_->slots.find(name); it != surroundings_->slots.end()) {
            return it->second;
        }
    }
    return -1;
}

int CodeNames::globalSlot(std::string_view name) {
    if (const int slot = findGlobal(name); slot >= 0) {
        return slot;
    }
    const std::size_t before = surroundings_ == nullptr ? 0 : surroundings_->globals.size();
    const int slot = static_cast<int>(before + out_->globals.size());
    globals_.emplace(name, slot);
    out_->globals.emplace_back(name);
    return slot;
}

int CodeNames::localSlot(std::string_view name) {
    const auto [it, added] = locals_.try_emplace(name, static_cast<int>(code_->localNames.size()));
    if (added) {
        code_->localNames.emplace_back(name);
    }
    return it->second;
}

CodeNames::Slot CodeNames::resolve(std::string_view name) {
    if (const auto it = locals_.find(name); it != locals_.end()) {
        return {false, it->second};
    }
    if (const int slot = findGlobal(name); slot >= 0) {
        return {true, slot};
    }
    // `local x` appears later in the text. In a loop, the variable may already have a value at this point.
    if (explicitLocals_.contains(name)) {
        return {false, localSlot(name)};
    }
    return {};
}

CodeNames::Callee CodeNames::findFunction(std::string_view name) const {
    const auto here = [this](const Function* f) { return Callee{indexOf(*f), f->kind, f, nullptr}; };
    for (const Function* scope = function_; scope != nullptr; scope = scope->parent) {
        for (const Function* f : scope->nested) {
            if (f->name == name) {
                return here(f);
            }
        }
        if (scope->name == name && scope->parent == nullptr && scope->kind == FunctionKind::Def) {
            return here(scope);
        }
    }
    // Use the newest function with this name, because interpreter mode lines can redefine functions.
    for (std::size_t i = surroundings_ == nullptr ? 0 : surroundings_->functions.size(); i > 1; --i) {
        const FunctionCode* f = surroundings_->functions[i - 1].function;
        if (f->outermost && f->name == name) {
            return {static_cast<int>(i) - 1, f->kind, nullptr, f};
        }
    }
    return {};
}

// Functions of a line are numbered after all existing functions.
int CodeNames::indexOf(const Function& f) const {
    return surroundings_ == nullptr || f.index == 0
               ? f.index
               : static_cast<int>(surroundings_->functions.size()) + f.index - 1;
}

bool CodeNames::isOutermost(const Function& f) const {
    return f.parent != nullptr && f.parent->index == 0;
}

void CodeNames::report(Position at, std::string text) {
    // Keep the error that is first in the text, because functions are not compiled in the order of the text.
    if (!error_ || std::pair(at.line, at.column) < std::pair(error_->line, error_->column)) {
        error_ = CompileError{at.line, at.column, std::move(text)};
    }
}

void CodeNames::nameNotFound(Position at, std::string_view name) {
    report(at, "compile_error_name_not_found:" + std::string(name) + ":");
}

}  // namespace tiller::simulator::urscript
