// SPDX-License-Identifier: MIT
#pragma once

// Checks of what users pass, before anything is sent. All throw std::invalid_argument (wrong number of
// values, not a number) or std::range_error (too small, too large), naming the argument. Private to this
// room.

#include <limits>
#include <string>
#include <vector>

#include "robot/control/motion_types.h"

namespace tiller::urrtde::check {

using List = std::vector<double>;

void number(const char* name, double value, double lowest, double highest, const char* unit = "");
void integer(const char* name, int value, int lowest, int highest);
/// A list of this many numbers, whatever they are.
void list(const std::string& name, const List& values, std::size_t size);
void listWithin(const std::string& name, const List& values, std::size_t size, double limit, const char* unit,
                const char* hint = "");
/// Wide enough for every arm: where none is known yet.
control::JointLimits anyArm();
/// 6 angles within what the arm can [rad]; a value above is probably in degrees.
void joints(const std::string& name, const List& q, const control::JointLimits& arm);
/// 3 lengths within 10 m and a rotation vector within two turns; values above are probably millimetres or
/// degrees.
void pose(const std::string& name, const List& pose);
void jointSpeeds(const std::string& name, const List& qd, const control::JointLimits& arm);
/// 3 speeds [m/s] and 3 rotational speeds [rad/s].
void twist(const std::string& name, const List& xd);
/// Both above 0, as nothing would move otherwise.
void jointMove(double speed, double acceleration, const control::JointLimits& arm);
void toolMove(double speed, double acceleration);
void flags(const char* name, const std::vector<int>& values, std::size_t size);
/// A port of TCP.
void port(const char* name, int value);
/// -1 (as many as there are) or 1 ... 500 Hz.
void frequency(double value);
/// Up to 99; below 1 is no wish.
void priority(int value);

}  // namespace tiller::urrtde::check
