// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_trace.h"

#include <algorithm>

namespace tiller {

namespace {

constexpr double kMinStep = 0.0003;       // [m]; smaller steps are not visible
constexpr std::size_t kMaxStretch = 256;  // limits the computing time for each new position

}  // namespace

void SceneTrace::clear() {
    points_.clear();
    passed_.clear();
}

bool SceneTrace::fits(const Eigen::Vector3d& end) const {
    const Eigen::Vector3d from = points_[points_.size() - 2].place;
    const Eigen::Vector3d way = end - from;
    const double length = way.norm();
    if (length < 1e-9) {
        return false;
    }
    const Eigen::Vector3d along = way / length;
    return std::all_of(passed_.begin(), passed_.end(), [&](const Eigen::Vector3d& place) {
        const Eigen::Vector3d to = place - from;
        const double at = to.dot(along);
        // A position beyond `end` means that the arm has reversed its direction.
        return at <= length + kTolerance && at >= -kTolerance && (to - at * along).norm() <= kTolerance;
    });
}

bool SceneTrace::extend(double time, const Eigen::Vector3d& place) {
    if (!points_.empty() && time < points_.back().time) {
        clear();
    }
    bool changed = false;
    while (points_.size() > 2 && points_[1].time < time - kSeconds) {
        points_.pop_front();
        changed = true;
    }
    if (points_.size() == 2 && points_.back().time < time - kSeconds) {
        clear();  // the arm was at standstill for the duration of the trace
        changed = true;
    }
    if (points_.empty()) {
        points_.push_back({time, place});
        return true;
    }
    if ((points_.back().place - place).norm() < kMinStep) {
        return changed;
    }
    if (points_.size() >= 2 && passed_.size() < kMaxStretch && fits(place)) {
        passed_.push_back(place);
        points_.back() = {time, place};
        return true;
    }
    points_.push_back({time, place});
    passed_.assign(1, place);
    return true;
}

}  // namespace tiller
