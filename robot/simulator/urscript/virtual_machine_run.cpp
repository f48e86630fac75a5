// SPDX-License-Identifier: MIT
// Executes bytecode. The common cases (numbers, jumps, variables) are handled here; all else goes to
// operators.cpp.

#include <algorithm>
#include <cmath>

#include "robot/simulator/urscript/virtual_machine.h"
#include "robot/simulator/urscript/virtual_machine_fast.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

}  // namespace

void Interpreter::Machine::execute(Thread& thread) {
    // Cached copies of what the innermost call works on; `reload` after anything that calls or returns.
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
                const auto& names = unit->shapes[static_cast<std::size_t>(instruction.b)];
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
                const auto& label = unit->labels[static_cast<std::size_t>(instruction.b)];
                save();
                settle();
                host_.programLabel(label.number, label.text);
                break;
            }
        }
    }
}

}  // namespace tiller::simulator::urscript
