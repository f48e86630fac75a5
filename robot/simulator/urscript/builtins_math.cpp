// SPDX-License-Identifier: MIT
// urmath: functions for numbers.

#include <cmath>
#include <limits>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

#include "robot/core/angles.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

template <double (*function)(double)>
Status unary(Call& c) {
    c.result = function(c.number(0));
    return Status::Done;
}

template <double (*function)(double)>
Status arc(Call& c) {
    const double f = c.number(0);
    if (!(f >= -1 && f <= 1)) {
        fault("Domain error: " + c.name() + "(" + toStr(f) + ")");
    }
    c.result = function(f);
    return Status::Done;
}

template <double (*function)(double)>
Status rounded(Call& c) {
    const double f = function(c.number(0));
    if (!(f >= std::numeric_limits<std::int32_t>::min() && f <= std::numeric_limits<std::int32_t>::max())) {
        fault("Range error: " + c.name() + "(" + toStr(c.args[0]) + ") does not fit in an integer");
    }
    c.result = static_cast<std::int32_t>(f);
    return Status::Done;
}

Status atan2(Call& c) {
    c.result = std::atan2(c.number(0), c.number(1));
    return Status::Done;
}

Status sqrt(Call& c) {
    const double f = c.number(0);
    if (f < 0) {
        fault("Domain error: sqrt(" + toStr(f) + ")");
    }
    c.result = std::sqrt(f);
    return Status::Done;
}

Status log(Call& c) {
    const double base = c.number(0);
    const double f = c.number(1);
    if (base <= 0 || f <= 0 || base == 1) {
        fault("Domain error: log(" + toStr(base) + ", " + toStr(f) + ")");
    }
    c.result = std::log(f) / std::log(base);
    return Status::Done;
}

Status pow(Call& c) {
    const double base = c.number(0);
    const double exponent = c.number(1);
    if ((base < 0 && exponent != std::floor(exponent)) || (base == 0 && exponent < 0)) {
        fault("Domain error: pow(" + toStr(base) + ", " + toStr(exponent) + ")");
    }
    c.result = std::pow(base, exponent);
    return Status::Done;
}

Status d2r(Call& c) {
    c.result = toRadians(c.number(0));
    return Status::Done;
}
Status r2d(Call& c) {
    c.result = toDegrees(c.number(0));
    return Status::Done;
}

Status random(Call& c) {
    c.result = c.random();
    return Status::Done;
}

constexpr BuiltinRow kMathRows[] = {
    {"acos(f)", arc<std::acos>},
    {"asin(f)", arc<std::asin>},
    {"atan(f)", unary<std::atan>},
    {"atan2(x, y)", atan2},
    {"cos(f)", unary<std::cos>},
    {"sin(f)", unary<std::sin>},
    {"tan(f)", unary<std::tan>},
    {"ceil(f)", rounded<std::ceil>},
    {"floor(f)", rounded<std::floor>},
    {"sqrt(f)", sqrt},
    {"log(b, f)", log},
    {"pow(base, exponent)", pow},
    {"d2r(d)", d2r},
    {"r2d(r)", r2d},
    {"random()", random},
};

}  // namespace

std::span<const BuiltinRow> mathBuiltins() {
    return kMathRows;
}

}  // namespace tiller::simulator::urscript
