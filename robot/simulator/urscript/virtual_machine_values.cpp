// SPDX-License-Identifier: MIT
// Variables: what may be assigned to what, and the way down to an element or member.

#include <algorithm>

#include "robot/simulator/urscript/operators.h"
#include "robot/simulator/urscript/virtual_machine.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

// The type of a variable is fixed by its first value, as far as these families go: numbers mix, and so do
// poses and lists, because scripts in the field assign one to the other.
int family(const Value& v) {
    switch (v.type()) {
        case Type::Bool:
        case Type::Int:
        case Type::Float:
            return 1;
        case Type::String:
            return 2;
        case Type::Pose:
        case Type::List:
        case Type::Matrix:
            return 3;
        case Type::Struct:
            return 4;
        default:
            return 0;
    }
}

bool isRemote(const Value& v) {
    return v.is(Type::Struct) && v.structure().handle != 0;
}

}  // namespace

void Interpreter::Machine::store(Value& variable, Value v, const std::string& name) const {
    if (!variable.isUnset()) {
        const int before = family(variable);
        const int after = family(v);
        if (before != after && before != 0 && after != 0) {
            fault("Type error: variable '" + name + "' is a " + variable.typeName() +
                  " and cannot become a " + v.typeName());
        }
        if (variable.is(Type::List) && v.is(Type::List)) {
            const std::size_t capacity = variable.list().capacity;
            if (v.list().size() > capacity) {
                fault("Resizing of 'List' is not supported");
            }
            if (v.list().capacity != capacity) {
                v.ownList().capacity = capacity;
            }
        }
    }
    variable = std::move(v);
}

void Interpreter::Machine::unset(const Thread& thread, bool global, int slot) const {
    const std::size_t i = static_cast<std::size_t>(slot);
    const std::string& name = global ? code_.globals[i] : thread.calls.back().function->localNames[i];
    fault("Variable '" + name + "' has no value");
}

Value& Interpreter::Machine::variable(Thread& thread, const Path& path) {
    const std::size_t slot = static_cast<std::size_t>(path.slot);
    Value& v = path.global ? globals_[slot] : thread.stack[thread.calls.back().base + slot];
    if (v.isUnset()) {
        unset(thread, path.global, path.slot);
    }
    return v;
}

// The value `steps` steps down, as this holder's own. Moves `indices` past those used.
Value& Interpreter::Machine::descend(Value& root, const Path& path, std::size_t steps,
                                     const Value*& indices) const {
    Value* v = &root;
    for (std::size_t i = 0; i < steps; ++i) {
        const auto& [step, name] = path.steps[i];
        if (step == Path::Step::Member) {
            Value* member = v->is(Type::Struct) ? v->ownStructure().find(name) : nullptr;
            if (member == nullptr) {
                fault(std::string(v->typeName()) + " has no member '" + name + "'");
            }
            v = member;
        } else if (step == Path::Step::Index && v->is(Type::List) &&
                   v->list().kind == ListData::Kind::Other) {
            const std::size_t index = checkedIndex(*indices++, v->list().size());
            v = &v->ownList().values[index];
        } else {
            fault(std::string("Type error: an element of this ") + v->typeName() + " has no parts to assign");
        }
    }
    return *v;
}

void Interpreter::Machine::checkBounds(const Value& root) const {
    std::size_t budget = limits_.listLength;
    if (!root.withinBounds(kMaxValueDepth, budget)) {
        fault("Value is nested too deep or too large");
    }
}

void Interpreter::Machine::storePath(Thread& thread, const Path& path) {
    Value& root = variable(thread, path);
    Value* const end = thread.stack.data() + thread.top;
    Value* const first = end - 1 - path.indexValues;
    const Value* indices = first;
    Value element = std::move(end[-1]);
    const bool nested = element.nested();
    Value& holder = descend(root, path, path.steps.size() - 1, indices);
    // Writing to a shared list copies it.
    thread.operations -= holder.is(Type::List) ? static_cast<std::int64_t>(holder.list().size() / 32) : 1;
    const auto& [step, name] = path.steps.back();
    switch (step) {
        case Path::Step::Index:
            assignIndexed(holder, indices[0], element);
            break;
        case Path::Step::Index2:
            assignIndexed(holder, indices[0], indices[1], element);
            break;
        case Path::Step::Member: {
            Value* member = holder.is(Type::Struct) ? holder.ownStructure().find(name) : nullptr;
            if (member == nullptr) {
                fault(std::string(holder.typeName()) + " has no member '" + name + "'");
            }
            store(*member, std::move(element), name);
            break;
        }
    }
    if (nested) {
        checkBounds(root);
    }
    for (Value* v = first; v != end; ++v) {
        v->reset();
    }
    thread.top -= static_cast<std::size_t>(end - first);
}

// False: the thread waits for the result.
bool Interpreter::Machine::callMethod(Thread& thread, const MethodCall& call) {
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
            checkBounds(root);
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

Value Interpreter::Machine::applyMethod(Value& object, const MethodCall& call, const Value* arguments) const {
    const auto takes = [&](int least, int most) {
        if (call.arguments < least || call.arguments > most) {
            fault("Type error: wrong number of arguments for method '" + call.name + "'");
        }
    };
    const auto unknown = [&] {
        fault(std::string("Type error: ") + object.typeName() + " has no method '" + call.name + "'");
    };
    if (call.method == Method::ToString) {
        takes(0, 0);
        std::string text = toStr(object);
        if (text.size() > kMaxStringLength) {
            fault("String is too long");
        }
        return Value(std::move(text));
    }
    if (!object.is(Type::List)) {
        unknown();
    }
    const std::size_t size = object.list().size();
    const auto grow = [&](std::size_t at, const Value& element) {
        if (size >= object.list().capacity) {
            fault("List is full: its capacity is " + std::to_string(object.list().capacity));
        }
        if (!object.ownList().insert(at, element)) {
            fault(std::string("Type error: a ") + element.typeName() + " cannot be an element of this list");
        }
        return Value::none();
    };
    switch (call.method) {
        case Method::Append:
            takes(1, 1);
            return grow(size, arguments[0]);
        case Method::Insert:
            takes(2, 2);
            return grow(checkedIndex(arguments[0], size + 1), arguments[1]);
        case Method::Pop: {
            takes(0, 0);
            if (size == 0) {
                fault("Index out of bounds: pop from an empty list");
            }
            Value last = object.list().at(size - 1);
            object.ownList().erase(size - 1);
            return last;
        }
        case Method::Clear:
            takes(0, 0);
            object.ownList().clear();
            return Value::none();
        case Method::Length:
            takes(0, 0);
            return static_cast<std::int32_t>(size);
        case Method::Capacity:
            takes(0, 0);
            return static_cast<std::int32_t>(object.list().capacity);
        default:
            unknown();
    }
    return Value::none();
}

}  // namespace tiller::simulator::urscript
