// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/value_access.h"

#include <algorithm>
#include <optional>

#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/operators.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

// The first value of a variable determines its type family. Within a family, types can be mixed: bools, ints
// and floats; poses, lists and matrices. Existing scripts assign values of such types to the same variable.
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

/// Returns the values of a struct as a list; empty if their types differ.
std::optional<Value> asList(const StructData& structure) {
    ListData out;
    for (const auto& [name, value] : structure.members) {
        if (!out.insert(out.size(), value)) {
            return std::nullopt;
        }
    }
    out.capacity = out.size();
    return Value::list(std::move(out));
}

}  // namespace

void assign(Value& variable, Value v, const std::string& name) {
    if (!variable.isUnset()) {
        if (variable.is(Type::List) && v.is(Type::Struct)) {
            if (auto list = asList(v.structure())) {
                v = std::move(*list);
            }
        }
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

Value& descend(Value& root, const Path& path, std::size_t steps, const Value*& indices) {
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
        } else if (step == Path::Step::Index && v->is(Type::Struct)) {
            auto& members = v->ownStructure().members;
            v = &members[checkedIndex(*indices++, members.size())].second;
        } else {
            fault(std::string("Type error: an element of this ") + v->typeName() +
                  " has no elements to assign");
        }
    }
    return *v;
}

void checkBounds(const Value& root, std::size_t listLength) {
    std::size_t budget = listLength;
    if (!root.withinBounds(kMaxValueDepth, budget)) {
        fault("Value is nested too deeply or too large");
    }
}

void assignElement(Value& holder, const Path::Part& part, const Value* indices, Value element) {
    const auto& [step, name] = part;
    switch (step) {
        case Path::Step::Index:
            if (holder.is(Type::Struct)) {
                auto& [memberName, member] =
                    holder.ownStructure()
                        .members[checkedIndex(indices[0], holder.structure().members.size())];
                assign(member, std::move(element), memberName);
            } else {
                assignIndexed(holder, indices[0], element);
            }
            break;
        case Path::Step::Index2:
            assignIndexed(holder, indices[0], indices[1], element);
            break;
        case Path::Step::Member: {
            Value* member = holder.is(Type::Struct) ? holder.ownStructure().find(name) : nullptr;
            if (member == nullptr) {
                fault(std::string(holder.typeName()) + " has no member '" + name + "'");
            }
            assign(*member, std::move(element), name);
            break;
        }
    }
}

Value applyMethod(Value& object, const MethodCall& call, const Value* arguments) {
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
        case Method::Extend: {
            takes(1, 1);
            if (!arguments[0].is(Type::List)) {
                fault("Type error: the argument of method 'extend' must be a list, not a " +
                      std::string(arguments[0].typeName()));
            }
            const ListData added = arguments[0].list();  // a copy: may be the same list as `object`
            if (added.size() > object.list().capacity - size) {
                fault("List is full: its capacity is " + std::to_string(object.list().capacity));
            }
            ListData whole = object.list();
            for (std::size_t i = 0; i < added.size(); ++i) {
                if (!whole.insert(whole.size(), added.at(i))) {
                    fault(std::string("Type error: a ") + added.at(i).typeName() +
                          " cannot be an element of this list");
                }
            }
            whole.count = 1;
            object = Value::list(std::move(whole));
            return Value::none();
        }
        case Method::Remove:
            takes(1, 1);
            object.ownList().erase(checkedIndex(arguments[0], size));
            return Value::none();
        case Method::Slice: {
            takes(1, 2);
            const std::size_t begin = checkedIndex(arguments[0], size + 1);
            const std::size_t end = call.arguments == 2 ? checkedIndex(arguments[1], size + 1) : size;
            if (end < begin) {
                fault("Index out of bounds: slice from " + std::to_string(begin) + " to " +
                      std::to_string(end));
            }
            ListData part;
            part.kind = object.list().kind;
            for (std::size_t i = begin; i < end; ++i) {
                part.insert(part.size(), object.list().at(i));
            }
            part.capacity = part.size();
            return Value::list(std::move(part));
        }
        case Method::ExcessCapacity:
            takes(0, 0);
            return static_cast<std::int32_t>(object.list().capacity - size);
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
