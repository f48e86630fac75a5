// SPDX-License-Identifier: MIT
#pragma once

// A list of moves that are executed as one path with blends.

#include <cstddef>
#include <string>
#include <vector>

namespace ur_rtde {

/// One move of a path.
struct PathEntry {
    enum eMoveType { MoveJ, MoveL, MoveP, MoveC };
    enum ePositionType { PositionTcpPose, PositionJoints };

    /// parameters  MoveJ, MoveL, MoveP: 6 values (a pose [m, rad] or joint positions [rad]), speed,
    ///             acceleration, blend radius [m]. MoveC: 12 values (via, to), speed, acceleration, blend
    ///             radius, and optionally the orientation mode (0 free, 1 fixed)
    /// Throws std::invalid_argument for a wrong number of parameters or NaN, std::range_error for a value out
    /// of range.
    PathEntry(eMoveType move_type, ePositionType position_type, const std::vector<double> parameters);

    /// URScript line, including the line end.
    std::string toScriptCode() const;

    eMoveType move_type_;
    ePositionType pos_type_;
    std::vector<double> param_;
};

class Path {
public:
    void addEntry(const PathEntry& entry);
    void clear();
    std::size_t size() const;
    const std::vector<PathEntry>& waypoints() const;
    /// path  rows of 9: pose [m, rad], speed [m/s], acceleration [m/s2], blend radius [m]
    void appendMovelPath(const std::vector<std::vector<double>>& path);
    /// path  rows of 9: joint positions [rad], speed [rad/s], acceleration [rad/s2], blend radius [m]
    void appendMovejPath(const std::vector<std::vector<double>>& path);
    /// One line per entry, each preceded by a line that reports the entry number as progress.
    std::string toScriptCode() const;

private:
    std::vector<PathEntry> waypoints_;
};

}  // namespace ur_rtde
