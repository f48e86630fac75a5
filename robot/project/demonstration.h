// SPDX-License-Identifier: MIT
#pragma once

// A motion that was shown by hand: joint positions over time, and the few of them that are worth keeping as waypoints.
// Written as a table with the columns timestamp and actual_q_0 ... actual_q_5, as a recording has them, so that what
// learns from demonstrations reads it as it is.

#include <QByteArray>
#include <array>
#include <vector>

#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"

namespace tiller::project {

struct Demonstration {
    std::vector<double> times;      ///< [s], growing
    std::vector<JointPositions> q;  ///< [rad], as many

    std::size_t size() const { return q.size(); }            ///< Number of samples.
    void append(double time, const JointPositions& place) {  ///< At the end.
        times.push_back(time);
        q.push_back(place);
    }
};

/// How far a shown place may be from the kept path, both at once. Between two kept places the path is straight in joint
/// space, as MoveJ goes.
struct PathTolerance {
    double joints = 0.0087;  ///< of each joint [rad], 0.5 deg
    double tcp = 0.001;      ///< of the TCP [m]
};

struct KeptPlace {
    double time = 0;  ///< [s]
    JointPositions q;
};

/// The same without the standing still at its beginning and end.
Demonstration withoutPauses(const Demonstration& shown);

/// The path that is kept: smoothed over some hundredths of a second and with as few places as it takes, so that every
/// shown place is within the tolerance of it. It begins and ends where the demonstration does.
/// tcpOffset  with which it was shown
/// Threads    any. Real-time: no (a millisecond or two per thousand samples)
std::vector<KeptPlace> keptPath(const Demonstration& shown, const DhParameters& dh, const Pose& tcpOffset,
                                const PathTolerance& tolerance);

/// The largest distance of a shown place from a path of these places [rad, m].
struct PathDeviation {
    double joints = 0;
    double tcp = 0;
};
/// Each place is compared with the part of the path of its own time; which place there is the nearest, the tolerance weighs.
PathDeviation deviation(const Demonstration& shown, const std::vector<KeptPlace>& kept,
                        const DhParameters& dh, const Pose& tcpOffset, const PathTolerance& tolerance = {});

/// The motion along these places, a sample every `period` [s], and one at each place.
Demonstration alongPath(const std::vector<KeptPlace>& places, double period);

/// "timestamp,actual_q_0,...,actual_q_5" and a line per sample, with numbers that lose nothing.
QByteArray demonstrationCsv(const Demonstration& shown);
/// From the columns of such a table, whoever wrote it; other columns do not matter.
/// times, joints  one after the other, of equal length
/// Errors         FileCorrupt naming the row (counted from 1, without the heading) and what is wrong with it: not a
///                number, time that does not grow, a joint beyond what any can turn; fewer than two rows
Result<Demonstration> demonstrationFrom(const std::vector<double>& times,
                                        const std::array<const std::vector<double>*, 6>& joints);

}  // namespace tiller::project
