// SPDX-License-Identifier: MIT
#pragma once

// Checks arguments before they are sent. All functions throw std::invalid_argument (wrong number of values,
// NaN) or std::range_error (too small, too large), with the name of the argument. Private to robot/ur_rtde.

#include <limits>
#include <string>
#include <vector>

#include "robot/control/motion_types.h"

namespace tiller::urrtde::check {

using List = std::vector<double>;

void number(const char* name, double value, double lowest, double highest, const char* unit = "");
void integer(const char* name, int value, int lowest, int highest);
/// Checks that the list has this number of values.
void list(const std::string& name, const List& values, std::size_t size);
void listWithin(const std::string& name, const List& values, std::size_t size, double limit, const char* unit,
                const char* hint = "");
/// The widest limits of all arms, until the connected arm is known.
control::JointLimits anyArm();
/// Checks 6 angles against the limits of the arm [rad]; larger values are probably in degrees.
void joints(const std::string& name, const List& q, const control::JointLimits& arm);
/// Checks 3 lengths (within 10 m) and a rotation vector (within two turns); larger values are probably in
/// millimetres or degrees.
void pose(const std::string& name, const List& pose);
void jointSpeeds(const std::string& name, const List& qd, const control::JointLimits& arm);
/// Checks 3 velocities [m/s] and 3 angular velocities [rad/s].
void twist(const std::string& name, const List& xd);
/// Both must be above 0.
void jointMove(double speed, double acceleration, const control::JointLimits& arm);
void toolMove(double speed, double acceleration);
void flags(const char* name, const std::vector<int>& values, std::size_t size);
void port(const char* name, int value);
/// Checks for -1 (maximum) or 1 ... 500 Hz.
void frequency(double value);
/// Checks a real-time priority: at most 99; below 1: unchanged.
void priority(int value);

}  // namespace tiller::urrtde::check
