// SPDX-License-Identifier: MIT
// Tree to bytecode: resolves every name, so that a text that calls something unknown anywhere never starts.

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "robot/simulator/urscript/builtin.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/parser.h"
#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

namespace {

using ast::AssignScope;
using ast::Block;
using ast::Expr;
using ast::ExprKind;
using ast::Function;
using ast::FunctionKind;
using ast::Position;
using ast::Stmt;
using ast::StmtKind;

Method methodOf(std::string_view name) {
    static constexpr std::pair<std::string_view, Method> kMethods[] = {
        {"append", Method::Append},      {"pop", Method::Pop},       {"insert", Method::Insert},
        {"clear", Method::Clear},        {"length", Method::Length}, {"capacity", Method::Capacity},
        {"to_string", Method::ToString},
    };
    for (const auto& [spelling, method] : kMethods) {
        if (spelling == name) {
            return method;
        }
    }
    return Method::Unknown;
}

class Compiler {
public:
    Compiler(const ast::Tree& tree, const CompileOptions& options) : tree_(tree), options_(options) {}

    std::unique_ptr<Bytecode> run() {
        const Function& main = tree_.functions.front();
        out_->raw = main.kind == FunctionKind::Raw;
        out_->kind = main.kind == FunctionKind::Sec ? ProgramKind::Secondary : ProgramKind::Main;
        out_->name = out_->raw ? options_.rawName : std::string(main.name);
        collectGlobals();
        out_->functions.resize(tree_.functions.size());
        for (const Function& f : tree_.functions) {
            function(f);
        }
        return std::move(out_);
    }

    const std::optional<CompileError>& error() const { return error_; }

private:
    // ---- names
    struct Slot {
        bool global = false;
        int index = -1;
    };

    void collectGlobals() {
        for (const auto& parameter : tree_.functions.front().parameters) {
            globalSlot(parameter.name);
        }
        for (const Function& f : tree_.functions) {
            collectGlobals(f.body, f.index == 0);
        }
    }

    void collectGlobals(const Block& block, bool outermost) {
        for (const Stmt* s : block) {
            if (s->kind == StmtKind::Assign && (outermost || s->scope == AssignScope::Global)) {
                const Expr* target = rootOf(s->target);
                // An element assignment declares nothing, unless it says `global`.
                if (target == s->target || s->scope == AssignScope::Global) {
                    globalSlot(target->text);
                }
            }
            for (const Block& inner : s->blocks) {
                collectGlobals(inner, outermost);
            }
        }
    }

    void collectLocals(const Block& block) {
        for (const Stmt* s : block) {
            if (s->kind == StmtKind::Assign && s->target->kind == ExprKind::Variable) {
                const std::string_view name = s->target->text;
                if (s->scope == AssignScope::Local) {
                    explicitLocals_.insert(name);
                } else if (s->scope == AssignScope::Unqualified && !globals_.contains(name)) {
                    localSlot(name);
                }
            }
            for (const Block& inner : s->blocks) {
                collectLocals(inner);
            }
        }
    }

    static const Expr* rootOf(const Expr* target) {
        while (target->kind != ExprKind::Variable) {
            target = target->children[0];
        }
        return target;
    }

    int globalSlot(std::string_view name) {
        const auto [it, added] = globals_.try_emplace(name, static_cast<int>(out_->globals.size()));
        if (added) {
            out_->globals.emplace_back(name);
        }
        return it->second;
    }

    int localSlot(std::string_view name) {
        const auto [it, added] = locals_.try_emplace(name, static_cast<int>(code_->localNames.size()));
        if (added) {
            code_->localNames.emplace_back(name);
        }
        return it->second;
    }

    Slot resolve(std::string_view name) {
        if (const auto it = locals_.find(name); it != locals_.end()) {
            return {false, it->second};
        }
        if (const auto it = globals_.find(name); it != globals_.end()) {
            return {true, it->second};
        }
        // `local x` further down, read here: in a loop it may have a value by now.
        if (explicitLocals_.contains(name)) {
            return {false, localSlot(name)};
        }
        return {};
    }

    const Function* findFunction(std::string_view name) const {
        for (const Function* scope = function_; scope != nullptr; scope = scope->parent) {
            for (const Function* f : scope->nested) {
                if (f->name == name) {
                    return f;
                }
            }
            if (scope->name == name && scope->parent == nullptr && scope->kind == FunctionKind::Def) {
                return scope;
            }
        }
        return nullptr;
    }

    void report(Position at, std::string text) {
        // The first in the text, whatever the order of the functions.
        if (!error_ || std::pair(at.line, at.column) < std::pair(error_->line, error_->column)) {
            error_ = CompileError{at.line, at.column, std::move(text)};
        }
    }
    void nameNotFound(Position at, std::string_view name) {
        report(at, "compile_error_name_not_found:" + std::string(name) + ":");
    }

    // ---- code
    int emit(Op op, Position at, int b = 0, int a = 0, int stackChange = 0) {
        code_->code.push_back({op, static_cast<std::uint16_t>(a), b});
        code_->positions.push_back(at);
        depth_ += stackChange;
        code_->stack = std::max(code_->stack, depth_);
        return static_cast<int>(code_->code.size()) - 1;
    }
    int here() const { return static_cast<int>(code_->code.size()); }
    void land(int jump) { code_->code[static_cast<std::size_t>(jump)].b = here(); }

    int constant(Value v) {
        out_->constants.push_back(std::move(v));
        return static_cast<int>(out_->constants.size()) - 1;
    }
    int text(std::string_view s) {
        const auto [it, added] = texts_.try_emplace(std::string(s), static_cast<int>(out_->constants.size()));
        if (added) {
            out_->constants.emplace_back(std::string(s));
        }
        return it->second;
    }

    void function(const Function& f) {
        function_ = &f;
        code_ = &out_->functions[static_cast<std::size_t>(f.index)];
        code_->name = std::string(f.name);
        code_->kind = f.kind;
        locals_.clear();
        explicitLocals_.clear();
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

    void defaultOf(const Function& f, const ast::Parameter& parameter) {
        const int slot = localSlot(parameter.name);
        if (parameter.defaultValue == nullptr) {
            return;  // the call has been checked
        }
        const int skip = emit(Op::JumpIfSet, f.at, 0, slot);
        expression(parameter.defaultValue);
        emit(Op::DeclareLocal, f.at, slot, 0, -1);
        land(skip);
    }

    void block(const Block& statements) {
        for (const Stmt* s : statements) {
            statement(*s);
        }
    }

    void statement(const Stmt& s) {
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
                break;  // compiled on its own
        }
    }

    void ifStatement(const Stmt& s) {
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

    void whileStatement(const Stmt& s) {
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

    void assign(const Stmt& s) {
        const bool outermost = function_->index == 0;
        const Expr* root = rootOf(s.target);
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

    // Emits the index expressions of an element or member, outermost first.
    Path pathOf(const Expr* target, bool global = false) {
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

    static bool isPath(const Expr* e) {
        while (e->kind == ExprKind::Index || e->kind == ExprKind::Member) {
            e = e->children[0];
        }
        return e->kind == ExprKind::Variable;
    }

    void expression(const Expr* e) {
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
                const int skip = emit(e->kind == ExprKind::And ? Op::JumpIfFalseKeep : Op::JumpIfTrueKeep,
                                      e->at, 0, 0, -1);
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
                const Function* f = findFunction(e->text);
                if (f == nullptr || f->kind != FunctionKind::Thread) {
                    nameNotFound(e->at, e->text);
                }
                emit(Op::Run, e->at, f == nullptr ? 0 : f->index, 0, 1);
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

    static Op operatorOf(ExprKind kind) {
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

    void method(const Expr* e) {
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

    // ---- calls
    struct Formal {
        std::string_view name;
        bool required;
        const Value* value;  // of a builtin's default
    };

    void call(const Expr* e) {
        if (e->children.size() > 255) {
            report(e->at, "Too many arguments: " + std::string(e->text));
            return;
        }
        std::vector<Formal> formals;
        const Function* f = findFunction(e->text);
        int builtin = -1;
        if (f != nullptr && f->kind != FunctionKind::Thread) {
            for (const auto& parameter : f->parameters) {
                formals.push_back({parameter.name, parameter.defaultValue == nullptr, nullptr});
            }
        } else {
            builtin = findBuiltin(e->text);
            if (builtin < 0 || (options_.version && !row(builtin).availableIn(*options_.version))) {
                nameNotFound(e->at, e->text);
                builtin = -1;
            } else {
                out_->commandsMotion |= (row(builtin).flags & kMotion) != 0;
                for (const auto& parameter : row(builtin).parameters) {
                    formals.push_back({parameter.name, parameter.required, &parameter.defaultValue});
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
        emit(builtin >= 0 ? Op::CallBuiltin : Op::Call, e->at,
             builtin >= 0 ? builtin
             : f          ? f->index
                          : 0,
             pushed, 1 - pushed);
    }

    static const Builtin& row(int builtin) { return builtins()[static_cast<std::size_t>(builtin)]; }

    // One value per parameter, in the order of the parameters. Wrong arguments are found when the call is
    // reached.
    int arguments(const Expr* e, const std::vector<Formal>& formals) {
        std::vector<const Expr*> given(formals.size(), nullptr);
        std::string problem;
        for (std::size_t i = 0; i < e->children.size(); ++i) {
            std::size_t place = i;
            if (!e->names[i].empty()) {
                place = static_cast<std::size_t>(
                    std::find_if(formals.begin(), formals.end(),
                                 [&](const Formal& formal) { return formal.name == e->names[i]; }) -
                    formals.begin());
            }
            if (place >= formals.size()) {
                problem = e->names[i].empty()
                              ? "takes at most " + std::to_string(formals.size()) + " arguments"
                              : "has no argument named '" + std::string(e->names[i]) + "'";
                expression(e->children[i]);  // for the names in it
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

    const ast::Tree& tree_;
    const CompileOptions& options_;
    std::unique_ptr<Bytecode> out_ = std::make_unique<Bytecode>();
    std::map<std::string_view, int> globals_;
    std::map<std::string, int, std::less<>> texts_;
    std::optional<CompileError> error_;

    // of the function being compiled
    const Function* function_ = nullptr;
    FunctionCode* code_ = nullptr;
    std::map<std::string_view, int> locals_;
    std::set<std::string_view> explicitLocals_;
    int depth_ = 0;
    int loopStart_ = 0;
    std::vector<int> breaks_;
};

}  // namespace

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

}  // namespace tiller::simulator::urscript
