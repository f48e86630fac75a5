// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the TCP went in the last minutes, with no more points than its bends need.

#include <Eigen/Core>
#include <deque>
#include <vector>

namespace tiller {

class SceneTrace {
public:
    struct Point {
        double time = 0;                                  ///< of the robot [s]
        Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< base frame [m]
    };

    static constexpr double kSeconds = 180;       ///< as long it is kept
    static constexpr double kTolerance = 0.0005;  ///< how far the line may run beside where the TCP went [m]

    /// The TCP is here now. A time before the last one begins a new trace: the controller started anew.
    /// Returns  true when the line is another one than before
    bool extend(double time, const Eigen::Vector3d& place);
    void clear();

    /// When what is shown of the way begins, by the robot's time; 0 when there is nothing.
    double begins() const { return points_.empty() ? 0 : points_.front().time; }
    /// The corners of the line, oldest first; the last one is where the TCP was last.
    const std::deque<Point>& points() const { return points_; }

private:
    bool fits(const Eigen::Vector3d& end) const;

    std::deque<Point> points_;
    std::vector<Eigen::Vector3d>
        passed_;  ///< since the last corner but one: what the last stretch stands for
};

}  // namespace tiller
