// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/arguments.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "robot/ur_rtde/rtde_control_interface.h"

namespace tiller::urrtde::check {

namespace {

constexpr double kTwoTurns = 4 * 3.14159265358979323846 + 0.01;
constexpr double kJointRange = 2 * 3.14159265358979323846 + 0.1;
constexpr double kRounding = 1e-6;
// Maximum velocity of a single axis [rad/s]. Exceeds the fastest wrist (2 pi).
constexpr double kMaxTurn = 6.3;
constexpr double kMaxTravel = 5.0;
constexpr double kMinValue = 1e-6;  // minimum speed and acceleration, because a move with 0 would never end
constexpr double kReach = 10.0;  // [m]; more than five times the reach of the largest arm. Values in mm are
                                 // usually larger
constexpr const char* kDegrees = "; angles are in radians. Was the value given in degrees?";
constexpr const char* kMillimetres = "; lengths are in metres. Was the value given in millimetres?";

std::string at(const std::string& name, std::size_t index) {
    return name + "[" + std::to_string(index) + "]";
}

void finite(const std::string& name, double value) {
    if (!std::isfinite(value)) {
        throw std::invalid_argument(name + " is not a number");
    }
}

void inRange(const std::string& name, double value, double lowest, double highest, const std::string& unit,
             const char* hint) {
    finite(name, value);
    if (value < lowest || value > highest) {
        std::ostringstream text;
        text << name << " = " << value << " is outside the range " << lowest << " to " << highest;
        if (!unit.empty()) {
            text << " " << unit;
        }
        text << hint;
        throw std::range_error(text.str());
    }
}

}  // namespace

void number(const char* name, double value, double lowest, double highest, const char* unit) {
    inRange(name, value, lowest, highest, unit, "");
}

void integer(const char* name, int value, int lowest, int highest) {
    inRange(name, value, lowest, highest, "", "");
}

void list(const std::string& name, const List& values, std::size_t size) {
    if (values.size() != size) {
        throw std::invalid_argument(name + " has " + std::to_string(values.size()) + " values instead of " +
                                    std::to_string(size));
    }
    for (std::size_t i = 0; i < size; ++i) {
        finite(at(name, i), values[i]);
    }
}

void listWithin(const std::string& name, const List& values, std::size_t size, double limit, const char* unit,
                const char* hint) {
    list(name, values, size);
    for (std::size_t i = 0; i < size; ++i) {
        inRange(at(name, i), values[i], -limit, limit, unit, hint);
    }
}

control::JointLimits anyArm() {
    control::JointLimits limits;
    limits.minPosition.fill(-kJointRange);
    limits.maxPosition.fill(kJointRange);
    limits.maxSpeed.fill(kMaxTurn);
    return limits;
}

void joints(const std::string& name, const List& q, const control::JointLimits& arm) {
    list(name, q, 6);
    for (std::size_t i = 0; i < 6; ++i) {
        inRange(at(name, i), q[i], arm.minPosition[i] - kRounding, arm.maxPosition[i] + kRounding, "rad",
                kDegrees);
    }
}

void pose(const std::string& name, const List& pose) {
    list(name, pose, 6);
    for (std::size_t i = 0; i < 3; ++i) {
        inRange(at(name, i), pose[i], -kReach, kReach, "m", kMillimetres);
        inRange(at(name, i + 3), pose[i + 3], -kTwoTurns, kTwoTurns, "rad", kDegrees);
    }
}

void jointSpeeds(const std::string& name, const List& qd, const control::JointLimits& arm) {
    list(name, qd, 6);
    for (std::size_t i = 0; i < 6; ++i) {
        const double most = arm.maxSpeed[i] + kRounding;
        inRange(at(name, i), qd[i], -most, most, "rad/s", kDegrees);
    }
}

void twist(const std::string& name, const List& xd) {
    list(name, xd, 6);
    for (std::size_t i = 0; i < 3; ++i) {
        inRange(at(name, i), xd[i], -kMaxTravel, kMaxTravel, "m/s", kMillimetres);
        inRange(at(name, i + 3), xd[i + 3], -kMaxTurn, kMaxTurn, "rad/s", kDegrees);
    }
}

void jointMove(double speed, double acceleration, const control::JointLimits& arm) {
    const double fastest = *std::max_element(arm.maxSpeed.begin(), arm.maxSpeed.end());
    inRange("speed", speed, kMinValue, fastest, "rad/s", kDegrees);
    inRange("acceleration", acceleration, kMinValue, UR_JOINT_ACCELERATION_MAX, "rad/s2", kDegrees);
}

void toolMove(double speed, double acceleration) {
    inRange("speed", speed, kMinValue, UR_TOOL_VELOCITY_MAX, "m/s", kMillimetres);
    inRange("acceleration", acceleration, kMinValue, UR_TOOL_ACCELERATION_MAX, "m/s2", kMillimetres);
}

void flags(const char* name, const std::vector<int>& values, std::size_t size) {
    if (values.size() != size) {
        throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                                    " values instead of " + std::to_string(size));
    }
    for (std::size_t i = 0; i < size; ++i) {
        inRange(at(name, i), values[i], 0, 1, "", "");
    }
}

void port(const char* name, int value) {
    integer(name, value, 1, 65535);
}

void priority(int value) {
    integer("rt_priority", std::max(value, 0), 0, 99);
}

void frequency(double value) {
    if (value != -1.0) {
        number("frequency", value, 1, 500, "Hz");
    }
}

}  // namespace tiller::urrtde::check
