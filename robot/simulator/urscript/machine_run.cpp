// SPDX-License-Identifier: MIT
// Executes bytecode. The common cases (numbers, jumps, variables) are handled here; all else goes to
// operators.cpp.

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/machine.h"
#include "robot/simulator/urscript/operators.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

// What an operation on lists costs beyond one operation, so that the frame's budget bounds its time as well.
std::int64_t elementCount(const Value& v) {
    return static_cast<std::int64_t>(v.is(Type::List)     ? v.list().size()
                                     : v.is(Type::Matrix) ? v.matrix().numbers.size()
                                     : v.is(Type::Struct) ? v.structure().members.size()
                                                          : 0);
}

std::int64_t costOf(Op op, const Value& left, const Value& right) {
    const std::int64_t most = std::max(elementCount(left), elementCount(right));
    if (op == Op::Multiply && left.is(Type::Matrix)) {
        return most * static_cast<std::int64_t>(right.is(Type::Matrix) ? right.matrix().cols : 1) / 8;
    }
    return most / 8;
}

// Numbers of the same type without a call; false: not handled.
inline bool fastArithmetic(Op op, Value& left, const Value& right) {
    if (left.is(Type::Float) || right.is(Type::Float)) {
        if (!left.isNumber() || !right.isNumber()) {
            return false;
        }
        const double a = left.number();
        const double b = right.number();
        switch (op) {
            case Op::Add:
                left.setFloat(a + b);
                return true;
            case Op::Subtract:
                left.setFloat(a - b);
                return true;
            case Op::Multiply:
                left.setFloat(a * b);
                return true;
            case Op::Divide:
                left.setFloat(a / b);
                return true;
            default:
                return false;
        }
    }
    if (left.is(Type::Int) && right.is(Type::Int)) {
        const auto a = static_cast<std::uint32_t>(left.asInt());
        const auto b = static_cast<std::uint32_t>(right.asInt());
        switch (op) {
            case Op::Add:
                left.setInt(static_cast<std::int32_t>(a + b));
                return true;
            case Op::Subtract:
                left.setInt(static_cast<std::int32_t>(a - b));
                return true;
            case Op::Multiply:
                left.setInt(static_cast<std::int32_t>(a * b));
                return true;
            default:
                return false;
        }
    }
    return false;
}

inline bool fastCompare(Op op, double a, double b) {
    switch (op) {
        case Op::Equal:
            return a == b;
        case Op::NotEqual:
            return a != b;
        case Op::Less:
            return a < b;
        case Op::Greater:
            return a > b;
        case Op::LessEqual:
            return a <= b;
        default:
            return a >= b;
    }
}

inline bool quickTruth(const Value& v) {
    return v.is(Type::Bool) ? v.asBool() : truth(v);
}

}  // namespace

void Interpreter::Machine::enter(Thread& thread, int function, int arguments) {
    const FunctionCode& f = code_.functions[static_cast<std::size_t>(function)];
    if (static_cast<int>(thread.calls.size()) >= limits_.callDepth) {
        fault("Too many nested function calls");
    }
    const std::size_t base = thread.top - static_cast<std::size_t>(arguments);
    thread.top = base + static_cast<std::size_t>(f.locals);
    const std::size_t needed = thread.top + static_cast<std::size_t>(f.stack) + 1;
    if (thread.stack.size() < needed) {
        thread.stack.resize(std::max(needed, thread.stack.size() * 2));
    }
    // Everything above the top is Unset, so the other locals are already.
    thread.calls.push_back({&f, 0, base});
}

// Back to the caller with the result; false when the thread has returned from its outermost function.
bool Interpreter::Machine::leave(Thread& thread, Value result) {
    const CallFrame done = thread.calls.back();
    for (std::size_t i = done.base; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.top = done.base;
    if (thread.calls.size() == 1) {
        if (thread.id == 0) {
            state = State::Finished;
            over_ = true;
        }
        endThread(thread);
        return false;
    }
    thread.calls.pop_back();
    thread.stack[thread.top++] = std::move(result);
    return true;
}

// True: go on; false: the thread waits, or its slice is used up.
bool Interpreter::Machine::callBuiltin(Thread& thread, const Instruction& instruction) {
    const Builtin& builtin = builtins()[static_cast<std::size_t>(instruction.b)];
    const std::size_t first = thread.top - instruction.a;
    Call call(context_, builtin, thread.id, std::span(thread.stack.data() + first, instruction.a));
    if (thread.again) {
        call.first = false;
        call.state = thread.builtinState;
        call.waitedNs = (frame - thread.builtinSince) * context_.stepNs;
    }
    const Status status = builtin.function(call);
    thread.operations -= 8 + call.cost;
    const bool secondary = program->kind() == ProgramKind::Secondary;
    if (secondary && (status == Status::Again || call.consumedNs > 0 || call.endFrame)) {
        fault(kTooMuchBehind);
    }
    if (status == Status::Again) {
        if (!thread.again) {
            thread.again = true;
            thread.builtinSince = frame;
        }
        thread.builtinState = call.state;
        thread.state = Thread::State::Polling;
        --thread.calls.back().pc;
        return false;
    }
    thread.again = false;
    for (std::size_t i = first; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.stack[first] = std::move(call.result);
    thread.top = first + 1;
    thread.sliceNs -= call.consumedNs;
    if (call.endFrame) {
        thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
    }
    return thread.sliceNs > 0 && !stopRequested_;
}

void Interpreter::Machine::execute(Thread& thread) {
    // Cached copies of what the innermost call works on; `reload` after anything that calls or returns.
    const FunctionCode* function = nullptr;
    const Instruction* code = nullptr;
    Value* locals = nullptr;
    Value* sp = nullptr;  // one above the top
    int pc = 0;
    std::int64_t operations = std::min(thread.operations, frameOperations_);
    std::int64_t granted = operations;

    const auto reload = [&] {
        const CallFrame& call = thread.calls.back();
        function = call.function;
        code = function->code.data();
        pc = call.pc;
        locals = thread.stack.data() + call.base;
        sp = thread.stack.data() + thread.top;
    };
    // Makes the thread's own record true before anything that may fault, block or look at it.
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
            fault(std::string(kTooMuchBehind) + ": infinite loop without sync or sleep");
        }
        const Instruction instruction = code[pc++];
        switch (instruction.op) {
            case Op::PushConstant:
                *sp++ = constants_[static_cast<std::size_t>(instruction.b)];
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
                    store(v, std::move(*sp),
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
                storePath(thread, code_.paths[static_cast<std::size_t>(instruction.b)]);
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
                sp[-1] = !quickTruth(sp[-1]);
                break;
            case Op::ToBool:
                save();
                settle();
                sp[-1] = quickTruth(sp[-1]);
                break;
            case Op::Xor:
                save();
                settle();
                sp[-2] = quickTruth(sp[-2]) != quickTruth(sp[-1]);
                (--sp)->reset();
                break;

            case Op::MakePose:
                save();
                settle();
                sp[-6] = makePose(sp - 6);
                sp -= 5;
                for (int i = 0; i < 5; ++i) {
                    sp[i].forget();  // numbers, or makePose had refused
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
                const auto& names = code_.shapes[static_cast<std::size_t>(instruction.b)];
                StructData data;
                Value* const values = sp - names.size();
                for (std::size_t i = 0; i < names.size(); ++i) {
                    data.members.emplace_back(names[i], std::move(values[i]));
                }
                sp = values;
                *sp++ = Value::structure(std::move(data));
                checkBounds(sp[-1]);
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
                const std::string& name = constants_[static_cast<std::size_t>(instruction.b)].string();
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
                if (quickTruth(sp[-1]) == decisive) {
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
                if (!callBuiltin(thread, instruction)) {
                    return;
                }
                sp = thread.stack.data() + thread.top;
                granted = operations = std::min(thread.operations, frameOperations_);
                break;
            case Op::CallMethod:
                save();
                settle();
                callMethod(thread, code_.methods[static_cast<std::size_t>(instruction.b)]);
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
                fault(constants_[static_cast<std::size_t>(instruction.b)].string());

            case Op::Run:
                save();
                settle();
                if (program->kind() == ProgramKind::Secondary) {
                    fault(kTooMuchBehind);
                }
                if (threadCount() >= limits_.threads ||
                    threads_.size() >= 8 * static_cast<std::size_t>(limits_.threads)) {
                    fault("Too many threads");
                }
                (sp++)->setInt(start(instruction.b, thread.id).id);
                charge(50);
                break;
            case Op::Join: {
                --sp;
                save();
                settle();
                const ThreadId id = handleOf(*sp);
                sp->reset();
                if (id > 0 && find(id) != nullptr) {
                    thread.state = Thread::State::Joining;
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
                    if (thread.state == Thread::State::Ended) {
                        return;
                    }
                }
                break;
            }
            case Op::EnterCritical:
            case Op::ExitCritical:
                break;  // threads are only switched where they block, and there the language wants it
            case Op::Halt:
                save();
                settle();
                state = State::Finished;
                over_ = true;
                return;
            case Op::Pause:
                save();
                settle();
                if (program->kind() == ProgramKind::Secondary) {
                    fault(kTooMuchBehind);
                }
                pauseRequested_ = true;
                thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
                return;
            case Op::Label: {
                const auto& label = code_.labels[static_cast<std::size_t>(instruction.b)];
                save();
                settle();
                host_.programLabel(label.number, label.text);
                break;
            }
        }
    }
}

}  // namespace tiller::simulator::urscript
