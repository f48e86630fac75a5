// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/execution.h"

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/fast_operators.h"
#include "robot/simulator/urscript/value_access.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

bool isRemote(const Value& v) {
    return v.is(Type::Struct) && v.structure().handle != 0;
}

}  // namespace

Execution::Execution(const Program& program, Host& host, const Limits& limits)
    : host_(host)
    , limits_(limits)
    , code_(program.code())
    , mode_(code_)
    , remote_(host)
    , context_{host, limits_, program.kind(), 0, limits.randomSeed, &mode_, &remote_} {
    context_.stepNs = std::llround(host.stepTime() * 1e9);
    globals_.resize(code_.globals.size());
}

// Executes a thread. Numbers, jumps and variables are handled here for speed, all other cases in
// operators.cpp.
void Execution::execute(ScriptThread& thread) {
    // Cached data of the current call. Use `reload` after every call or return.
    const FunctionCode* function = nullptr;
    const Bytecode* unit = nullptr;
    const Value* constants = nullptr;
    const Instruction* code = nullptr;
    Value* locals = nullptr;
    Value* sp = nullptr;  // one above the top
    int pc = 0;
    std::int64_t operations = std::min(thread.operations, frameOperations_);
    std::int64_t granted = operations;

    const auto reload = [&] {
        const CallFrame& call = thread.calls.back();
        function = call.function;
        unit = call.unit->code;
        constants = call.unit->constants.data();
        code = function->code.data();
        pc = call.pc;
        locals = thread.stack.data() + call.base;
        sp = thread.stack.data() + thread.top;
    };
    // Stores the cached data in the thread. Required before any operation that may fault, block or read them.
    const auto save = [&] {
        thread.calls.back().pc = pc;
        thread.top = static_cast<std::size_t>(sp - thread.stack.data());
    };
    const auto settle = [&] {
        thread.operations -= granted - operations;
        granted = operations;
    };
    const auto charge = [&](std::int64_t cost) { operations -= cost; };
    reload();

    while (true) {
        if (--operations < 0) {
            save();
            settle();
            throw Fault{std::string(kTooMuchBehind) + ": infinite loop without sync or sleep", true};
        }
        const Instruction instruction = code[pc++];
        switch (instruction.op) {
            case Op::PushConstant:
                *sp++ = constants[instruction.b];
                break;
            case Op::PushInt:
                (sp++)->setInt(instruction.b);
                break;
            case Op::PushTrue:
                (sp++)->setBool(true);
                break;
            case Op::PushFalse:
                (sp++)->setBool(false);
                break;
            case Op::PushNone:
                *sp++ = Value::none();
                break;
            case Op::PushUnset:
                ++sp;
                break;
            case Op::LoadLocal:
            case Op::LoadGlobal: {
                const bool global = instruction.op == Op::LoadGlobal;
                const Value& v =
                    global ? globals_[static_cast<std::size_t>(instruction.b)] : locals[instruction.b];
                if (v.isUnset()) [[unlikely]] {
                    save();
                    settle();
                    unset(thread, global, instruction.b);
                }
                (sp++)->initialize(v);
                break;
            }
            case Op::StoreLocal:
            case Op::StoreGlobal: {
                const bool global = instruction.op == Op::StoreGlobal;
                Value& v = global ? globals_[static_cast<std::size_t>(instruction.b)] : locals[instruction.b];
                --sp;
                if (sp->isPlain() &&
                    (v.isUnset() || v.type() == sp->type() || (v.isNumber() && sp->isNumber()))) {
                    v.initialize(*sp);
                    sp->forget();
                } else {
                    save();
                    settle();
                    assign(v, std::move(*sp),
                           global ? code_.globals[static_cast<std::size_t>(instruction.b)]
                                  : function->localNames[static_cast<std::size_t>(instruction.b)]);
                }
                break;
            }
            case Op::DeclareLocal:
                --sp;
                locals[instruction.b] = std::move(*sp);
                break;
            case Op::StorePath:
                save();
                settle();
                storePath(thread, unit->paths[static_cast<std::size_t>(instruction.b)]);
                sp = thread.stack.data() + thread.top;
                granted = operations = std::min(thread.operations, frameOperations_);
                break;
            case Op::Pop:
                (--sp)->reset();
                break;

            case Op::Add:
            case Op::Subtract:
            case Op::Multiply:
            case Op::Divide:
            case Op::Modulo:
                if (fastArithmetic(instruction.op, sp[-2], sp[-1])) {
                    (--sp)->forget();
                } else {
                    save();
                    charge(costOf(instruction.op, sp[-2], sp[-1]));
                    settle();
                    sp[-2] = arithmetic(instruction.op, sp[-2], sp[-1]);
                    (--sp)->reset();
                }
                break;
            case Op::Equal:
            case Op::NotEqual:
            case Op::Less:
            case Op::Greater:
            case Op::LessEqual:
            case Op::GreaterEqual:
                if (sp[-2].isNumber() && sp[-1].isNumber()) {
                    const bool outcome = fastCompare(instruction.op, sp[-2].number(), sp[-1].number());
                    sp[-2].setBool(outcome);
                    (--sp)->forget();
                } else {
                    save();
                    charge(costOf(instruction.op, sp[-2], sp[-1]));
                    settle();
                    sp[-2] = compare(instruction.op, sp[-2], sp[-1]);
                    (--sp)->reset();
                }
                break;
            case Op::Negate:
                save();
                settle();
                sp[-1] = negated(sp[-1]);
                break;
            case Op::Plus:
                save();
                settle();
                sp[-1] = negated(negated(sp[-1]));
                break;
            case Op::Not:
                save();
                settle();
                sp[-1] = !fastTruthValue(sp[-1]);
                break;
            case Op::ToBool:
                save();
                settle();
                sp[-1] = fastTruthValue(sp[-1]);
                break;
            case Op::Xor:
                save();
                settle();
                sp[-2] = fastTruthValue(sp[-2]) != fastTruthValue(sp[-1]);
                (--sp)->reset();
                break;

            case Op::MakePose:
                save();
                settle();
                sp[-6] = makePose(sp - 6);
                sp -= 5;
                for (int i = 0; i < 5; ++i) {
                    sp[i].forget();  // these are numbers, because makePose has succeeded
                }
                break;
            case Op::MakeList: {
                save();
                charge(instruction.b / 4);
                settle();
                Value list =
                    makeList(sp - instruction.b, static_cast<std::size_t>(instruction.b), limits_.listLength);
                for (int i = 0; i < instruction.b; ++i) {
                    (--sp)->reset();
                }
                *sp++ = std::move(list);
                break;
            }
            case Op::MakeStruct: {
                save();
                settle();
                const auto& names = unit->shapes[static_cast<std::size_t>(instruction.b)];
                StructData data;
                Value* const values = sp - names.size();
                for (std::size_t i = 0; i < names.size(); ++i) {
                    data.members.emplace_back(names[i], std::move(values[i]));
                }
                sp = values;
                *sp++ = Value::structure(std::move(data));
                checkBounds(sp[-1], limits_.listLength);
                break;
            }
            case Op::Index:
                save();
                settle();
                sp[-2] = indexed(sp[-2], sp[-1]);
                (--sp)->reset();
                break;
            case Op::Index2:
                save();
                settle();
                sp[-3] = indexed(sp[-3], sp[-2], sp[-1]);
                (--sp)->reset();
                (--sp)->reset();
                break;
            case Op::Member: {
                const std::string& name = constants[instruction.b].string();
                const Value* member = sp[-1].is(Type::Struct) ? sp[-1].structure().find(name) : nullptr;
                if (member == nullptr) {
                    save();
                    settle();
                    fault(std::string(sp[-1].typeName()) + " has no member '" + name + "'");
                }
                sp[-1] = Value(*member);
                break;
            }

            case Op::Jump:
                pc = instruction.b;
                break;
            case Op::JumpIfFalse: {
                --sp;
                bool go = true;
                if (sp->is(Type::Bool)) {
                    go = sp->asBool();
                    sp->forget();
                } else {
                    save();
                    settle();
                    go = truth(*sp);
                    sp->reset();
                }
                if (!go) {
                    pc = instruction.b;
                }
                break;
            }
            case Op::JumpIfFalseKeep:
            case Op::JumpIfTrueKeep: {
                save();
                settle();
                const bool decisive = instruction.op == Op::JumpIfTrueKeep;
                if (fastTruthValue(sp[-1]) == decisive) {
                    sp[-1].setBool(decisive);
                    pc = instruction.b;
                } else {
                    (--sp)->reset();
                }
                break;
            }
            case Op::JumpIfSet:
                if (!locals[instruction.a].isUnset()) {
                    pc = instruction.b;
                }
                break;

            case Op::Call:
                save();
                settle();
                enter(thread, instruction.b, instruction.a);
                reload();
                break;
            case Op::CallBuiltin:
                save();
                settle();
                switch (callBuiltin(thread, instruction)) {
                    case After::Wait:
                        return;
                    case After::Reload:
                        reload();
                        break;
                    case After::GoOn:
                        sp = thread.stack.data() + thread.top;
                        break;
                }
                granted = operations = std::min(thread.operations, frameOperations_);
                break;
            case Op::CallMethod:
                save();
                settle();
                if (!callMethod(thread, unit->methods[static_cast<std::size_t>(instruction.b)])) {
                    return;
                }
                sp = thread.stack.data() + thread.top;
                granted = operations = std::min(thread.operations, frameOperations_);
                break;
            case Op::Return:
            case Op::ReturnNone: {
                Value result = instruction.op == Op::Return ? std::move(*--sp) : Value::none();
                save();
                settle();
                if (!leave(thread, std::move(result))) {
                    return;
                }
                reload();
                break;
            }
            case Op::Throw:
                save();
                settle();
                fault(constants[instruction.b].string());

            case Op::Run:
                save();
                settle();
                if (context_.kind == ProgramKind::Secondary) {
                    fault(kTooMuchBehind);
                }
                (sp++)->setInt(startThread(instruction.b, thread.id));
                charge(50);
                break;
            case Op::Join: {
                --sp;
                save();
                settle();
                const ThreadId id = handleOf(*sp);
                sp->reset();
                if (id > 0 && isAlive(id)) {
                    thread.state = ScriptThread::State::Joining;
                    thread.joined = id;
                    return;
                }
                break;
            }
            case Op::Kill: {
                --sp;
                save();
                charge(50);
                settle();
                const ThreadId id = handleOf(*sp);
                sp->reset();
                if (id > 0) {
                    killTree(id);
                    if (thread.state == ScriptThread::State::Ended) {
                        return;
                    }
                }
                break;
            }
            case Op::EnterCritical:
            case Op::ExitCritical:
                break;  // no effect: threads switch only when they block, even in critical sections
            case Op::Halt:
                save();
                settle();
                finish();
                return;
            case Op::Pause:
                save();
                settle();
                if (context_.kind == ProgramKind::Secondary) {
                    fault(kTooMuchBehind);
                }
                requestPause();
                thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
                return;
            case Op::Label: {
                const auto& label = unit->labels[static_cast<std::size_t>(instruction.b)];
                save();
                settle();
                host_.programLabel(label.number, label.text);
                break;
            }
        }
    }
}

void Execution::enter(ScriptThread& thread, int function, int arguments) {
    push(thread, code_.functions[static_cast<std::size_t>(function)], arguments);
}

void Execution::push(ScriptThread& thread, const LinkedCode::Callee& callee, int arguments) {
    const FunctionCode& f = *callee.function;
    if (static_cast<int>(thread.calls.size()) >= limits_.callDepth) {
        fault("Too many nested function calls");
    }
    const std::size_t base = thread.top - static_cast<std::size_t>(arguments);
    thread.top = base + static_cast<std::size_t>(f.locals);
    const std::size_t needed = thread.top + static_cast<std::size_t>(f.stack) + 1;
    if (thread.stack.size() < needed) {
        thread.stack.resize(std::max(needed, thread.stack.size() * 2));
    }
    // Slots above the top are always Unset, so the other locals need no initialization.
    thread.calls.push_back({&f, callee.unit, 0, base});
}

// Runs the next interpreter mode line as a call from interpreter_mode().
void Execution::enterLine(ScriptThread& thread) {
    const Unit& unit = mode_.begin();
    globals_.resize(std::max(globals_.size(), code_.globals.size()));
    push(thread, {&unit.code->functions.front(), &unit}, 0);
}

// Returns to the caller with the result. Returns false if the outermost function has ended.
bool Execution::leave(ScriptThread& thread, Value result) {
    const CallFrame done = thread.calls.back();
    for (std::size_t i = done.base; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.top = done.base;
    if (thread.calls.size() == 1) {
        if (thread.id == 0) {
            finish();
        }
        endThread(thread);
        return false;
    }
    thread.calls.pop_back();
    if (done.unit->owned != nullptr && done.function == &done.unit->code->functions.front()) {
        mode_.lineDone();  // the line has no result
    } else {
        thread.stack[thread.top++] = std::move(result);
    }
    return true;
}

// Returns Wait if the builtin must be executed again or if the slice is used up.
Execution::After Execution::callBuiltin(ScriptThread& thread, const Instruction& instruction) {
    const Builtin& builtin = builtins()[static_cast<std::size_t>(instruction.b)];
    const std::size_t first = thread.top - instruction.a;
    Call call(context_, builtin, thread.id, std::span(thread.stack.data() + first, instruction.a));
    if (thread.again) {
        call.first = false;
        call.state = thread.builtinState;
        call.waitedNs = (frame_ - thread.builtinSince) * context_.stepNs;
    }
    const Status status = builtin.function(call);
    if (mode_.takeForget()) {
        forgetLines();
    }
    thread.operations -= 8 + call.cost;
    // End the frame after many reads, so that reading takes time even if the client always sends more data.
    call.endFrame =
        call.endFrame || (call.readSocket && limits_.threadOperationsPerFrame - thread.operations >=
                                                 limits_.readingOperationsPerFrame);
    const bool secondary = context_.kind == ProgramKind::Secondary;
    if (secondary && (status == Status::Again || call.consumedNs > 0 || call.endFrame)) {
        fault(kTooMuchBehind);
    }
    if (status == Status::Again) {
        if (!thread.again) {
            thread.again = true;
            thread.builtinSince = frame_;
        }
        thread.builtinState = call.state;
        thread.state = ScriptThread::State::Polling;
        --thread.calls.back().pc;
        return After::Wait;
    }
    thread.again = false;
    if (status == Status::Line) {
        --thread.calls.back().pc;
        enterLine(thread);
        return After::Reload;
    }
    for (std::size_t i = first; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.stack[first] = std::move(call.result);
    thread.top = first + 1;
    thread.sliceNs -= call.consumedNs;
    if (call.endFrame) {
        thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
    }
    // A thread that has used part of its slice waits, so that threads with more remaining time run first.
    return thread.sliceNs > 0 && call.consumedNs == 0 && !isStopRequested() ? After::GoOn : After::Wait;
}

// Returns false if the thread must wait and execute the same instruction again.
bool Execution::callRemote(ScriptThread& thread, std::int32_t handle, const MethodCall& call,
                           std::span<const Value> arguments, Value& result) {
    if (context_.kind == ProgramKind::Secondary) {
        fault(kTooMuchBehind);
    }
    if (call.name == "closeXMLRPCClientConnection") {
        result = Value::none();  // every call has its own connection
        return true;
    }
    if (!thread.again) {
        const Result<std::int64_t> begun = remote_.begin(handle, call.name, arguments);
        if (!begun.ok()) {
            fault(begun.error());
        }
        thread.builtinState = *begun;
        thread.builtinSince = frame_;
    } else {
        Result<std::optional<Value>> outcome = remote_.result(thread.builtinState);
        if (!outcome.ok()) {
            fault(outcome.error());
        }
        if (*outcome) {
            thread.again = false;
            result = std::move(**outcome);
            return true;
        }
    }
    thread.again = true;
    thread.state = ScriptThread::State::Polling;
    --thread.calls.back().pc;
    return false;
}

void Execution::unset(const ScriptThread& thread, bool global, int slot) const {
    const std::size_t i = static_cast<std::size_t>(slot);
    const std::string& name = global ? code_.globals[i] : thread.calls.back().function->localNames[i];
    fault("Variable '" + name + "' has no value");
}

Value& Execution::variable(ScriptThread& thread, const Path& path) {
    const std::size_t slot = static_cast<std::size_t>(path.slot);
    Value& v = path.global ? globals_[slot] : thread.stack[thread.calls.back().base + slot];
    if (v.isUnset()) {
        unset(thread, path.global, path.slot);
    }
    return v;
}

void Execution::storePath(ScriptThread& thread, const Path& path) {
    Value& root = variable(thread, path);
    Value* const end = thread.stack.data() + thread.top;
    Value* const first = end - 1 - path.indexValues;
    const Value* indices = first;
    Value element = std::move(end[-1]);
    const bool nested = element.nested();
    Value& holder = descend(root, path, path.steps.size() - 1, indices);
    // Writing to a shared list copies the list.
    thread.operations -= holder.is(Type::List) ? static_cast<std::int64_t>(holder.list().size() / 32) : 1;
    assignElement(holder, path.steps.back(), indices, std::move(element));
    if (nested) {
        checkBounds(root, limits_.listLength);
    }
    for (Value* v = first; v != end; ++v) {
        v->reset();
    }
    thread.top -= static_cast<std::size_t>(end - first);
}

// Returns false if the thread must wait for the result.
bool Execution::callMethod(ScriptThread& thread, const MethodCall& call) {
    Value* const end = thread.stack.data() + thread.top;
    Value* const arguments = end - call.arguments;
    Value* first = arguments;
    Value result;
    if (call.onPath) {
        Value& root = variable(thread, call.path);
        first = arguments - call.path.indexValues;
        const Value* indices = first;
        Value& object = descend(root, call.path, call.path.steps.size(), indices);
        if (isRemote(object)) {
            const std::int32_t handle = object.structure().handle;
            if (!callRemote(thread, handle, call, {arguments, end}, result)) {
                return false;
            }
        } else {
            result = applyMethod(object, call, arguments);
        }
        if (call.arguments > 0 && end[-1].nested() && !isRemote(object)) {
            checkBounds(root, limits_.listLength);
        }
        thread.operations -= object.is(Type::List) ? static_cast<std::int64_t>(object.list().size() / 32) : 1;
    } else {
        --first;
        if (isRemote(*first)) {
            if (!callRemote(thread, first->structure().handle, call, {arguments, end}, result)) {
                return false;
            }
        } else {
            result = applyMethod(*first, call, arguments);
        }
    }
    for (Value* v = first; v != end; ++v) {
        v->reset();
    }
    *first = std::move(result);
    thread.top = static_cast<std::size_t>(first - thread.stack.data()) + 1;
    return true;
}

}  // namespace tiller::simulator::urscript
