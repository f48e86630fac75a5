// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The trace of the TCP during the last 180 s. The number of points depends on the curvature.

#include <Eigen/Core>
#include <deque>
#include <vector>

namespace tiller {

class SceneTrace {
public:
    struct Point {
        double time = 0;                                  ///< time of the robot [s]
        Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< base frame [m]
    };

    static constexpr double kSeconds = 180;       ///< duration of the trace [s]
    static constexpr double kTolerance = 0.0005;  ///< maximum deviation of the line from the real path [m]

    /// Adds the current TCP position. If `time` is before the last time, the controller was restarted and a
    /// new trace starts.
    /// Returns  true if the line has changed
    bool extend(double time, const Eigen::Vector3d& place);
    void clear();

    /// Robot time at the start of the trace; 0 if empty.
    double begins() const { return points_.empty() ? 0 : points_.front().time; }
    /// The corners of the line, oldest first. The last corner is the current TCP position.
    const std::deque<Point>& points() const { return points_; }

private:
    bool fits(const Eigen::Vector3d& end) const;

    std::deque<Point> points_;
    std::vector<Eigen::Vector3d>
        passed_;  ///< positions since the second-to-last corner; the last segment represents them
};

}  // namespace tiller
