// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/rtde_path.h"

#include <cstdio>
#include <stdexcept>

#include "robot/ur_rtde/detail/arguments.h"

namespace ur_rtde {

namespace check = tiller::urrtde::check;
using List = std::vector<double>;

namespace {

constexpr std::size_t kRow = 9;
constexpr double kMaxBlend = 2.0;

// Returns the number with 12 significant digits.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

std::string position(PathEntry::ePositionType type, const List& values, std::size_t first) {
    std::string text = type == PathEntry::PositionTcpPose ? "p[" : "[";
    for (std::size_t i = 0; i < 6; ++i) {
        text += (i > 0 ? "," : "") + number(values[first + i]);
    }
    return text + "]";
}

void checkPosition(const std::string& name, PathEntry::ePositionType type, const List& values,
                   std::size_t first) {
    const List six(values.begin() + static_cast<std::ptrdiff_t>(first),
                   values.begin() + static_cast<std::ptrdiff_t>(first) + 6);
    type == PathEntry::PositionTcpPose ? check::pose(name, six) : check::joints(name, six, check::anyArm());
}

void checkRows(const std::vector<List>& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        check::list("path[" + std::to_string(i) + "]", path[i], kRow);
    }
}

}  // namespace

PathEntry::PathEntry(eMoveType move_type, ePositionType position_type, const List parameters)
    : move_type_(move_type), pos_type_(position_type), param_(parameters) {
    std::size_t speedAt = 6;
    if (move_type_ == MoveC) {
        speedAt = 12;
        if (param_.size() == kRow + 6) {
            param_.push_back(0.0);
        }
        check::list("parameters", param_, kRow + 7);
        checkPosition("parameters (via)", pos_type_, param_, 0);
        check::number("parameters[15] (mode)", param_[15], 0, 1);
    } else {
        check::list("parameters", param_, kRow);
    }
    checkPosition("parameters", pos_type_, param_, speedAt - 6);
    if (move_type_ == MoveJ) {
        check::jointMove(param_[speedAt], param_[speedAt + 1], check::anyArm());
    } else {
        check::toolMove(param_[speedAt], param_[speedAt + 1]);
    }
    check::number("blend", param_[speedAt + 2], 0, kMaxBlend, "m");
}

std::string PathEntry::toScriptCode() const {
    static constexpr const char* kNames[] = {"movej", "movel", "movep", "movec"};
    const std::size_t speedAt = move_type_ == MoveC ? 12 : 6;
    std::string text = "\t" + std::string(kNames[move_type_]) + "(" + position(pos_type_, param_, 0);
    if (move_type_ == MoveC) {
        text += "," + position(pos_type_, param_, 6);
    }
    text += ",a=" + number(param_[speedAt + 1]) + ",v=" + number(param_[speedAt]) +
            ",r=" + number(param_[speedAt + 2]);
    if (move_type_ == MoveC) {
        text += ",mode=" + number(param_[speedAt + 3]);
    }
    return text + ")\n";
}

void Path::addEntry(const PathEntry& entry) {
    waypoints_.push_back(entry);
}

void Path::clear() {
    waypoints_.clear();
}

std::size_t Path::size() const {
    return waypoints_.size();
}

const std::vector<PathEntry>& Path::waypoints() const {
    return waypoints_;
}

void Path::appendMovelPath(const std::vector<List>& path) {
    checkRows(path);
    for (const List& row : path) {
        addEntry(PathEntry(PathEntry::MoveL, PathEntry::PositionTcpPose, row));
    }
}

void Path::appendMovejPath(const std::vector<List>& path) {
    checkRows(path);
    for (const List& row : path) {
        addEntry(PathEntry(PathEntry::MoveJ, PathEntry::PositionJoints, row));
    }
}

std::string Path::toScriptCode() const {
    std::string text;
    for (std::size_t i = 0; i < waypoints_.size(); ++i) {
        text += "\tsignal_async_progress(" + std::to_string(i) + ")\n" + waypoints_[i].toScriptCode();
    }
    return text;
}

}  // namespace ur_rtde
