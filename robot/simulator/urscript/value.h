// SPDX-License-Identifier: MIT
#pragma once

// A URScript value. Numbers, bools and poses are stored in the object. Strings, lists, matrices and structs
// are shared until one owner writes to them (copy on write), which implements the by-value semantics of the
// language at the cost of a pointer. All values of a program must be used in the same host thread, because
// the reference counts are not atomic.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/spatial.h"

namespace tiller::simulator::urscript {

/// Maximum length of a string returned by an operation.
inline constexpr std::size_t kMaxStringLength = 1023;
/// Maximum nesting of structs and lists.
inline constexpr int kMaxValueDepth = 16;

struct StringData;
struct ListData;
struct MatrixData;
struct StructData;

class Value {
public:
    enum class Type : std::uint8_t { Unset, None, Bool, Int, Float, Pose, String, List, Matrix, Struct };

    Value() noexcept = default;
    Value(bool b) noexcept : type_(Type::Bool) { u_.b = b; }         // NOLINT: implicit by intent
    Value(std::int32_t i) noexcept : type_(Type::Int) { u_.i = i; }  // NOLINT: implicit by intent
    Value(double d) noexcept : type_(Type::Float) { u_.d = d; }      // NOLINT: implicit by intent
    Value(const std::array<double, 6>& pose) noexcept : type_(Type::Pose) { u_.pose = pose; }  // NOLINT
    Value(const Pose& pose) noexcept : Value(pose.array()) {}  // NOLINT: implicit by intent
    explicit Value(std::string text);
    explicit Value(const char*) = delete;  // the argument would be converted to bool

    static Value none() noexcept {
        Value v;
        v.type_ = Type::None;
        return v;
    }
    static Value list(ListData data);
    static Value floats(const double* values, std::size_t count);
    static Value ints(const std::int32_t* values, std::size_t count);
    static Value matrix(MatrixData data);
    static Value structure(StructData data);

    Value(const Value& other) noexcept { copyFrom(other); }
    Value(Value&& other) noexcept { takeFrom(other); }
    Value& operator=(const Value& other) noexcept {
        if (this != &other) {
            Value keep(other);  // `other` may be part of the data released here
            release();
            takeFrom(keep);
        }
        return *this;
    }
    Value& operator=(Value&& other) noexcept {
        if (this != &other) {
            Value keep(std::move(other));
            release();
            takeFrom(keep);
        }
        return *this;
    }
    ~Value() { release(); }

    Type type() const noexcept { return type_; }
    bool isUnset() const noexcept { return type_ == Type::Unset; }
    bool isNumber() const noexcept { return type_ == Type::Int || type_ == Type::Float; }
    bool is(Type t) const noexcept { return type_ == t; }

    // These functions do not check the type. The caller must check type() first.
    bool asBool() const noexcept { return u_.b; }
    std::int32_t asInt() const noexcept { return u_.i; }
    double asFloat() const noexcept { return u_.d; }
    double number() const noexcept { return type_ == Type::Int ? static_cast<double>(u_.i) : u_.d; }
    const std::array<double, 6>& pose() const noexcept { return u_.pose; }
    std::array<double, 6>& pose() noexcept { return u_.pose; }
    const std::string& string() const noexcept;
    const ListData& list() const noexcept { return *u_.list; }
    const MatrixData& matrix() const noexcept { return *u_.matrix; }
    const StructData& structure() const noexcept { return *u_.structure; }
    /// Returns the data for writing. Shared data are copied first.
    ListData& ownList();
    MatrixData& ownMatrix();
    StructData& ownStructure();

    void setInt(std::int32_t i) noexcept {
        release();
        type_ = Type::Int;
        u_.i = i;
    }
    void setFloat(double d) noexcept {
        release();
        type_ = Type::Float;
        u_.d = d;
    }
    void setBool(bool b) noexcept {
        release();
        type_ = Type::Bool;
        u_.b = b;
    }
    void reset() noexcept {
        release();
        type_ = Type::Unset;
    }

    // The following functions are for the interpreter's stack, where most values are numbers.
    /// True for a bool, number or pose, which needs no destructor.
    bool isPlain() const noexcept { return type_ <= Type::Pose; }
    /// Copies `other`; this value must be plain.
    void initialize(const Value& other) noexcept { copyFrom(other); }
    /// Sets to Unset; this value must be plain.
    void forget() noexcept { type_ = Type::Unset; }

    /// Returns a deep copy, for constants passed to another host thread.
    Value detached() const;
    /// Name of the type for error messages: "int", "float", "pose" ...
    const char* typeName() const noexcept;
    /// True for equal content. 2 equals 2.0, and True equals 1; other types differ. NaN differs from itself.
    bool equals(const Value& other) const;
    /// True if the value has at most `depth` levels of nesting and `budget` values. Subtracts the number of
    /// its values from `budget`. All values of a program are kept within these limits, so that copies,
    /// comparisons and destruction are fast.
    bool withinBounds(int depth, std::size_t& budget) const noexcept;
    /// True for a struct, or for a list whose elements are not numbers.
    bool nested() const noexcept;

private:
    bool shared() const noexcept { return type_ >= Type::String; }
    void copyFrom(const Value& other) noexcept {
        type_ = other.type_;
        if (type_ <= Type::Float) {
            u_.bits = other.u_.bits;
        } else if (type_ == Type::Pose) {
            u_.pose = other.u_.pose;
        } else {
            u_.counter = other.u_.counter;
            ++*u_.counter;
        }
    }
    void takeFrom(Value& other) noexcept {
        type_ = other.type_;
        if (type_ == Type::Pose) {
            u_.pose = other.u_.pose;
        } else {
            u_.bits = other.u_.bits;
        }
        other.type_ = Type::Unset;
    }
    void release() noexcept {
        if (shared()) {
            releaseShared();
        }
    }
    void releaseShared() noexcept;

    Type type_ = Type::Unset;
    union Content {
        std::uint64_t bits = 0;
        bool b;
        std::int32_t i;
        double d;
        std::array<double, 6> pose;
        std::uint32_t* counter;  // all shared data start with the reference count
        StringData* string;
        ListData* list;
        MatrixData* matrix;
        StructData* structure;
    } u_;
};

struct StringData {
    std::uint32_t count = 1;
    std::string text;
};

/// All elements of a list have the same type. Numbers and bools are stored as doubles, which represent int32
/// exactly, other types as values.
struct ListData {
    enum class Kind : std::uint8_t { Bool, Int, Float, Other };

    std::uint32_t count = 1;
    Kind kind = Kind::Int;
    std::size_t capacity = 0;     ///< fixed at creation
    std::vector<double> numbers;  ///< Bool, Int, Float
    std::vector<Value> values;    ///< Other: strings, poses, structs

    std::size_t size() const { return kind == Kind::Other ? values.size() : numbers.size(); }
    bool isNumeric() const { return kind == Kind::Int || kind == Kind::Float; }
    Value at(std::size_t i) const;
    /// Returns false if the element type does not fit. Ints and floats can be mixed; the list is then
    /// converted to floats.
    bool set(std::size_t i, const Value& v);
    bool insert(std::size_t i, const Value& v);
    void erase(std::size_t i);
    void clear();
    bool accepts(const Value& v) const;

private:
    void adopt(const Value& v);
};

struct MatrixData {
    std::uint32_t count = 1;
    std::size_t rows = 0, cols = 0;
    bool integer = true;          ///< all elements are ints
    std::vector<double> numbers;  ///< row by row
};

struct StructData {
    std::uint32_t count = 1;
    std::int32_t handle = 0;  ///< handle of a remote object with callable methods; 0: ordinary struct
    std::vector<std::pair<std::string, Value>> members;
    Value* find(std::string_view name);
    const Value* find(std::string_view name) const;
};

}  // namespace tiller::simulator::urscript
