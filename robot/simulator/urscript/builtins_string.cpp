// SPDX-License-Identifier: MIT
// Functions for strings. Strings consist of bytes with indices from zero.

#include <charconv>
#include <cmath>
#include <limits>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

Value bounded(std::string text) {
    if (text.size() > kMaxStringLength) {
        fault("String is too long: more than 1023 characters");
    }
    return Value(std::move(text));
}

// to_str and str_cat accept string, bool, number, pose, and lists of these types.
void checkPrintable(const Call& c, std::size_t i) {
    const Value& v = c.args[i];
    const bool structs = v.is(Value::Type::List) && v.list().kind == ListData::Kind::Other &&
                         v.list().size() > 0 && v.list().values.front().is(Value::Type::Struct);
    if (v.is(Value::Type::None) || v.is(Value::Type::Struct) || v.is(Value::Type::Matrix) || structs) {
        c.badArgument(i, "a string, bool, number, pose or list of those");
    }
}

Status strCat(Call& c) {
    checkPrintable(c, 0);
    checkPrintable(c, 1);
    c.result = bounded(toStr(c.args[0]) + toStr(c.args[1]));
    return Status::Done;
}

Status toString(Call& c) {
    checkPrintable(c, 0);
    c.result = bounded(toStr(c.args[0]));
    return Status::Done;
}

Status strAt(Call& c) {
    const std::string& s = c.string(0);
    const std::int32_t i = c.integer(1);
    if (i < 0 || static_cast<std::size_t>(i) >= s.size()) {
        fault("str_at: index " + std::to_string(i) + " is out of bounds");
    }
    c.result = Value(s.substr(static_cast<std::size_t>(i), 1));
    return Status::Done;
}

Status strEmpty(Call& c) {
    c.result = c.string(0).empty();
    return Status::Done;
}

Status strFind(Call& c) {
    const std::string& s = c.string(0);
    const std::int32_t from = c.integer(2);
    if (from < 0) {
        fault("str_find: start must not be negative");
    }
    const std::size_t at = s.find(c.string(1), static_cast<std::size_t>(from));
    c.result = at == std::string::npos ? std::int32_t{-1} : static_cast<std::int32_t>(at);
    return Status::Done;
}

Status strLen(Call& c) {
    c.result = static_cast<std::int32_t>(c.string(0).size());
    return Status::Done;
}

Status strSub(Call& c) {
    const std::string& s = c.string(0);
    const std::int32_t i = c.integer(1);
    const std::int32_t count = c.given(2) ? c.integer(2) : std::numeric_limits<std::int32_t>::max();
    if (i < 0 || static_cast<std::size_t>(i) > s.size() || count < 0) {
        fault("str_sub: index or length is out of bounds");
    }
    c.result = Value(s.substr(static_cast<std::size_t>(i), static_cast<std::size_t>(count)));
    return Status::Done;
}

// Accepts leading blanks, a sign, decimal or 0x. Returns a float if there is a decimal point or an exponent.
Status toNum(Call& c) {
    std::string_view s = c.string(0);
    const std::size_t start = s.find_first_not_of(" \t");
    s.remove_prefix(start == std::string_view::npos ? s.size() : start);
    const bool negative = !s.empty() && s.front() == '-';
    if (!s.empty() && (s.front() == '-' || s.front() == '+')) {
        s.remove_prefix(1);
    }
    const auto refuse = [&] { fault("to_num: \"" + c.string(0) + "\" is not a number"); };
    const char* const end = s.data() + s.size();
    if (s.size() > 2 && s[0] == '0' && (s[1] == 'x' || s[1] == 'X')) {
        std::uint32_t bits = 0;
        if (std::from_chars(s.data() + 2, end, bits, 16).ec != std::errc()) {
            refuse();
        }
        c.result = static_cast<std::int32_t>(negative ? 0u - bits : bits);
        return Status::Done;
    }
    if (s.empty() || !((s[0] >= '0' && s[0] <= '9') || s[0] == '.')) {
        refuse();
    }
    double number = 0;
    const auto parsed = std::from_chars(s.data(), end, number);
    if (parsed.ec != std::errc()) {
        refuse();
    }
    number = negative ? -number : number;
    const std::string_view used(s.data(), static_cast<std::size_t>(parsed.ptr - s.data()));
    const bool whole = used.find_first_of(".eE") == std::string_view::npos;
    if (whole && std::abs(number) <= std::numeric_limits<std::int32_t>::max()) {
        c.result = static_cast<std::int32_t>(number);
    } else {
        c.result = number;
    }
    return Status::Done;
}

constexpr BuiltinRow kStringRows[] = {
    {"str_at(src, index)", strAt, kPlain, kStringsSince},
    {"str_cat(op1, op2)", strCat, kPlain, kStringsSince},
    {"str_empty(str)", strEmpty, kPlain, kStringsSince},
    {"str_find(src, target, start_from=0)", strFind, kPlain, kStringsSince},
    {"str_len(str)", strLen, kPlain, kStringsSince},
    {"str_sub(src, index, len?)", strSub, kPlain, kStringsSince},
    {"to_num(str)", toNum, kPlain, kAfter33},
    {"to_str(val)", toString, kPlain, kAfter33},
};

}  // namespace

std::span<const BuiltinRow> stringBuiltins() {
    return kStringRows;
}

}  // namespace tiller::simulator::urscript
