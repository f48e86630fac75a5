// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/value_format.h"

#include <cmath>
#include <cstdio>

namespace tiller::simulator::urscript {

namespace {

struct Style {
    std::string (*number)(double);
    const char* separator;
};

std::string nonFinite(double d) {
    return std::isnan(d) ? "nan" : d > 0 ? "inf" : "-inf";
}

std::string sixDecimals(double d) {
    if (!std::isfinite(d)) {
        return nonFinite(d);
    }
    char text[352];  // DBL_MAX has 309 digits before the decimal point
    const int length = std::snprintf(text, sizeof text, "%.6f", d);
    std::string s(text, static_cast<std::size_t>(length));
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') {
        s.pop_back();
    }
    return s == "-0" ? "0" : s;
}

std::string sixDigits(double d) {
    if (!std::isfinite(d)) {
        return nonFinite(d);
    }
    char text[32];
    const int length = std::snprintf(text, sizeof text, "%g", d);
    return {text, static_cast<std::size_t>(length)};
}

void append(std::string& out, const Value& v, const Style& style, std::size_t limit) {
    if (out.size() > limit) {
        return;
    }
    switch (v.type()) {
        case Value::Type::Unset:
        case Value::Type::None:
            out += "None";
            break;
        case Value::Type::Bool:
            out += v.asBool() ? "True" : "False";
            break;
        case Value::Type::Int:
            out += std::to_string(v.asInt());
            break;
        case Value::Type::Float:
            out += style.number(v.asFloat());
            break;
        case Value::Type::Pose:
            out += "p[";
            for (std::size_t i = 0; i < 6; ++i) {
                out += (i ? style.separator : "") + style.number(v.pose()[i]);
            }
            out += ']';
            break;
        case Value::Type::String:
            out += v.string();
            break;
        case Value::Type::List:
            out += '[';
            for (std::size_t i = 0; i < v.list().size() && out.size() <= limit; ++i) {
                out += i ? style.separator : "";
                append(out, v.list().at(i), style, limit);
            }
            out += ']';
            break;
        case Value::Type::Matrix: {
            const MatrixData& m = v.matrix();
            out += '[';
            for (std::size_t r = 0; r < m.rows && out.size() <= limit; ++r) {
                out += r ? style.separator : "";
                out += '[';
                for (std::size_t c = 0; c < m.cols && out.size() <= limit; ++c) {
                    out += (c ? style.separator : "") + style.number(m.numbers[r * m.cols + c]);
                }
                out += ']';
            }
            out += ']';
            break;
        }
        case Value::Type::Struct: {
            out += "struct(";
            bool first = true;
            for (const auto& [name, member] : v.structure().members) {
                out += first ? "" : style.separator;
                first = false;
                out += name + "=";
                append(out, member, style, limit);
            }
            out += ')';
            break;
        }
    }
}

}  // namespace

std::string toStr(const Value& v, std::size_t limit) {
    std::string out;
    append(out, v, {sixDecimals, ", "}, limit);
    return out;
}

std::string toMessageText(const Value& v, std::size_t limit) {
    std::string out;
    append(out, v, {sixDigits, ","}, limit);
    return out;
}

}  // namespace tiller::simulator::urscript
