// SPDX-License-Identifier: MIT
#pragma once

// A motion taught by hand: joint positions over time, and the reduction to a few waypoints. Stored as a table
// with the columns timestamp and actual_q_0 ... actual_q_5 as in a recording, so that tools for learning from
// demonstration can read it directly.

#include <QByteArray>
#include <array>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::project {

struct Demonstration {
    std::vector<double> times;      ///< [s], increasing
    std::vector<JointPositions> q;  ///< [rad], same size

    std::size_t size() const { return q.size(); }
    void append(double time, const JointPositions& place) {
        times.push_back(time);
        q.push_back(place);
    }
};

/// Permitted deviation of the taught positions from the reduced path. Both limits apply. Between two kept
/// positions, the path is linear in joint space, as with MoveJ.
struct PathTolerance {
    double joints = 0.0087;  ///< deviation of each joint [rad], 0.5 deg
    double tcp = 0.001;      ///< deviation of the TCP [m]
};

struct KeptPlace {
    double time = 0;  ///< [s]
    JointPositions q;
};

/// Removes standstill at the beginning and the end.
Demonstration withoutPauses(const Demonstration& shown);

/// The reduced path: smoothed over up to 0.1 s, with as few positions as possible while all taught positions
/// are within the tolerance. The first and the last position are those of the demonstration.
/// tcpOffset  flange to TCP during teaching [m, rad]
/// Threads    any. Real-time: no (one or two milliseconds per thousand samples)
std::vector<KeptPlace> keptPath(const Demonstration& shown, const DhParameters& dh, const Pose& tcpOffset,
                                const PathTolerance& tolerance);

/// Maximum deviation of the taught positions from a path [rad, m].
struct PathDeviation {
    double joints = 0;
    double tcp = 0;
};
/// Compares each sample with the path segment at its time. The ratio of the tolerances weights joint and TCP
/// distances when searching for the nearest position on the segment.
PathDeviation deviation(const Demonstration& shown, const std::vector<KeptPlace>& kept,
                        const DhParameters& dh, const Pose& tcpOffset, const PathTolerance& tolerance = {});

/// Samples of the motion along these positions: one at each position and one every `period` [s].
Demonstration alongPath(const std::vector<KeptPlace>& places, double period);

/// Returns the header "timestamp,actual_q_0,...,actual_q_5" and one line per sample, with full precision.
QByteArray demonstrationCsv(const Demonstration& shown);
/// Converts the columns of a table with the quantities of demonstrationCsv(), e.g. of a recording, to a
/// demonstration.
/// times, joints  columns of equal length
/// Errors         FileCorrupt with the row (counted from 1, without the header) and the reason: not a number,
///                time not increasing, a joint beyond the limits of all arms; fewer than two rows
Result<Demonstration> demonstrationFrom(const std::vector<double>& times,
                                        const std::array<const std::vector<double>*, 6>& joints);

}  // namespace tiller::project
