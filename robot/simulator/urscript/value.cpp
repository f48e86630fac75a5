// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/value.h"

#include <algorithm>
#include <cstddef>

namespace tiller::simulator::urscript {

namespace {

// The count is accessed through a pointer to the object, so it must be the first member.
static_assert(offsetof(StringData, count) == 0 && offsetof(ListData, count) == 0 &&
              offsetof(MatrixData, count) == 0 && offsetof(StructData, count) == 0);

template <class Data>
Data* clone(const Data& data) {
    auto* copy = new Data(data);
    copy->count = 1;
    return copy;
}

template <class Data>
Data& own(Data*& data) {
    if (data->count > 1) {
        Data* copy = clone(*data);
        --data->count;
        data = copy;
    }
    return *data;
}

}  // namespace

Value::Value(std::string text) : type_(Type::String) {
    u_.string = new StringData{1, std::move(text)};
}

Value Value::list(ListData data) {
    data.count = 1;
    data.capacity = std::max(data.capacity, data.size());
    Value v;
    v.u_.list = new ListData(std::move(data));
    v.type_ = Type::List;
    return v;
}

Value Value::floats(const double* values, std::size_t count) {
    ListData data;
    data.kind = ListData::Kind::Float;
    data.numbers.assign(values, values + count);
    return list(std::move(data));
}

Value Value::ints(const std::int32_t* values, std::size_t count) {
    ListData data;
    data.kind = ListData::Kind::Int;
    data.numbers.assign(values, values + count);
    return list(std::move(data));
}

Value Value::matrix(MatrixData data) {
    data.count = 1;
    Value v;
    v.u_.matrix = new MatrixData(std::move(data));
    v.type_ = Type::Matrix;
    return v;
}

Value Value::structure(StructData data) {
    data.count = 1;
    Value v;
    v.u_.structure = new StructData(std::move(data));
    v.type_ = Type::Struct;
    return v;
}

const std::string& Value::string() const noexcept {
    return u_.string->text;
}

ListData& Value::ownList() {
    return own(u_.list);
}
MatrixData& Value::ownMatrix() {
    return own(u_.matrix);
}
StructData& Value::ownStructure() {
    return own(u_.structure);
}

void Value::releaseShared() noexcept {
    if (--*u_.counter != 0) {
        return;
    }
    switch (type_) {
        case Type::String:
            delete u_.string;
            break;
        case Type::List:
            delete u_.list;
            break;
        case Type::Matrix:
            delete u_.matrix;
            break;
        case Type::Struct:
            delete u_.structure;
            break;
        default:
            break;
    }
}

Value Value::detached() const {
    switch (type_) {
        case Type::String:
            return Value(string());
        case Type::List: {
            ListData data = list();
            for (Value& v : data.values) {
                v = v.detached();
            }
            return Value::list(std::move(data));
        }
        case Type::Matrix:
            return Value::matrix(matrix());
        case Type::Struct: {
            StructData data = structure();
            for (auto& member : data.members) {
                member.second = member.second.detached();
            }
            return Value::structure(std::move(data));
        }
        default:
            return *this;
    }
}

const char* Value::typeName() const noexcept {
    switch (type_) {
        case Type::Unset:
            return "undefined";
        case Type::None:
            return "None";
        case Type::Bool:
            return "bool";
        case Type::Int:
            return "int";
        case Type::Float:
            return "float";
        case Type::Pose:
            return "pose";
        case Type::String:
            return "string";
        case Type::List:
            return "list";
        case Type::Matrix:
            return "matrix";
        case Type::Struct:
            return "struct";
    }
    return "?";
}

bool Value::equals(const Value& other) const {
    if (isNumber() && other.isNumber()) {
        return number() == other.number();
    }
    if (type_ != other.type_) {
        // A bool equals the numbers 0 and 1. Other values of different types are unequal.
        if (type_ == Type::Bool && other.isNumber()) {
            return (u_.b ? 1.0 : 0.0) == other.number();
        }
        if (isNumber() && other.type_ == Type::Bool) {
            return other.equals(*this);
        }
        return false;
    }
    switch (type_) {
        case Type::Bool:
            return u_.b == other.u_.b;
        case Type::Pose:
            return u_.pose == other.u_.pose;
        case Type::String:
            return string() == other.string();
        case Type::List: {
            const ListData& a = list();
            const ListData& b = other.list();
            if (a.size() != b.size()) {
                return false;
            }
            if (a.kind != ListData::Kind::Other && b.kind != ListData::Kind::Other) {
                return a.numbers == b.numbers;
            }
            return a.kind == b.kind && std::equal(a.values.begin(), a.values.end(), b.values.begin(),
                                                  [](const Value& x, const Value& y) { return x.equals(y); });
        }
        case Type::Matrix:
            return matrix().rows == other.matrix().rows && matrix().numbers == other.matrix().numbers;
        case Type::Struct: {
            const auto& a = structure().members;
            const auto& b = other.structure().members;
            return a.size() == b.size() && structure().handle == other.structure().handle &&
                   std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
                       return x.first == y.first && x.second.equals(y.second);
                   });
        }
        default:
            return true;
    }
}

bool Value::withinBounds(int depth, std::size_t& budget) const noexcept {
    const std::size_t own = type_ == Type::String   ? 1 + string().size() / 16
                            : type_ == Type::List   ? 1 + list().numbers.size()
                            : type_ == Type::Matrix ? 1 + matrix().numbers.size()
                                                    : 1;
    if (own > budget) {
        return false;
    }
    budget -= own;
    if (nested()) {
        if (depth == 0) {
            return false;
        }
        if (type_ == Type::List) {
            for (const Value& v : list().values) {
                if (!v.withinBounds(depth - 1, budget)) {
                    return false;
                }
            }
        } else {
            for (const auto& member : structure().members) {
                if (!member.second.withinBounds(depth - 1, budget)) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool Value::nested() const noexcept {
    return type_ == Type::Struct || (type_ == Type::List && list().kind == ListData::Kind::Other);
}

// ---- lists

Value ListData::at(std::size_t i) const {
    switch (kind) {
        case Kind::Bool:
            return numbers[i] != 0;
        case Kind::Int:
            return static_cast<std::int32_t>(numbers[i]);
        case Kind::Float:
            return numbers[i];
        case Kind::Other:
            break;
    }
    return values[i];
}

bool ListData::accepts(const Value& v) const {
    if (size() == 0) {
        // Lists of lists are matrices. Other lists cannot be nested, which limits the depth of every value.
        return !v.isUnset() && !v.is(Value::Type::None) && !v.is(Value::Type::List) &&
               !v.is(Value::Type::Matrix);
    }
    switch (kind) {
        case Kind::Bool:
            return v.is(Value::Type::Bool);
        case Kind::Int:
        case Kind::Float:
            return v.isNumber();
        case Kind::Other:
            return v.type() == values.front().type();
    }
    return false;
}

void ListData::adopt(const Value& v) {
    if (size() == 0) {
        kind = v.is(Value::Type::Bool)    ? Kind::Bool
               : v.is(Value::Type::Int)   ? Kind::Int
               : v.is(Value::Type::Float) ? Kind::Float
                                          : Kind::Other;
    } else if (kind == Kind::Int && v.is(Value::Type::Float)) {
        kind = Kind::Float;
    }
}

bool ListData::set(std::size_t i, const Value& v) {
    if (!accepts(v)) {
        return false;
    }
    adopt(v);
    if (kind == Kind::Other) {
        values[i] = v;
    } else {
        numbers[i] = v.is(Value::Type::Bool) ? (v.asBool() ? 1.0 : 0.0) : v.number();
    }
    return true;
}

bool ListData::insert(std::size_t i, const Value& v) {
    if (!accepts(v)) {
        return false;
    }
    adopt(v);
    if (kind == Kind::Other) {
        const Value copy(v);
        values.insert(values.begin() + static_cast<std::ptrdiff_t>(i), copy);
    } else {
        numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(i),
                       v.is(Value::Type::Bool) ? (v.asBool() ? 1.0 : 0.0) : v.number());
    }
    return true;
}

void ListData::erase(std::size_t i) {
    if (kind == Kind::Other) {
        values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
        numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void ListData::clear() {
    numbers.clear();
    values.clear();
}

Value* StructData::find(std::string_view name) {
    for (auto& member : members) {
        if (member.first == name) {
            return &member.second;
        }
    }
    return nullptr;
}

const Value* StructData::find(std::string_view name) const {
    for (const auto& member : members) {
        if (member.first == name) {
            return &member.second;
        }
    }
    return nullptr;
}

}  // namespace tiller::simulator::urscript
