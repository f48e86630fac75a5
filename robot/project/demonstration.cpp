// SPDX-License-Identifier: MIT
#include "robot/project/demonstration.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::project {
namespace {

/// Half width of the smoothing window [s]. Hand tremor has a frequency of about 10 Hz.
constexpr double kSmoothedOver = 0.05;
/// Maximum joint motion at standstill [rad].
constexpr double kStandstillTolerance = 0.0005;
/// Fraction of the tolerance available for smoothing.
constexpr double kSmoothingShare = 0.5;

struct Offset {
    double joints = 0;
    double tcp = 0;
    double share(const PathTolerance& tolerance) const {
        return std::max(joints / tolerance.joints, tcp / tolerance.tcp);
    }
};

class Ruler {
public:
    Ruler(const DhParameters& dh, const Pose& tcpOffset) : dh_(dh), tcpOffset_(tcpOffset) {}

    Offset between(const JointPositions& a, const JointPositions& b) const {
        return {(a.values - b.values).cwiseAbs().maxCoeff(), (tcp(a) - tcp(b)).norm()};
    }
    /// Distance of a position from the straight line between two other positions in joint space.
    Offset fromPath(const JointPositions& place, const JointPositions& from, const JointPositions& to,
                    const PathTolerance& tolerance) const {
        const Vector6 way = to.values - from.values;
        const double length = way.squaredNorm();
        const double at =
            length > 0 ? std::clamp((place.values - from.values).dot(way) / length, 0.0, 1.0) : 0.0;
        Offset best = between(place, JointPositions(Vector6(from.values + at * way)));
        // The position nearest in joint space need not be the nearest for the TCP. Near an end, the end
        // itself may be nearer.
        for (const JointPositions* end : {&from, &to}) {
            if (const Offset off = between(place, *end); off.share(tolerance) < best.share(tolerance)) {
                best = off;
            }
        }
        return best;
    }

private:
    Eigen::Vector3d tcp(const JointPositions& q) const {
        return kinematics::forwardTcp(dh_, q, tcpOffset_).position;
    }
    const DhParameters& dh_;
    const Pose& tcpOffset_;
};

/// Replaces each sample by the mean of its neighbourhood if the mean is within the tolerance.
std::vector<JointPositions> smoothed(const Demonstration& shown, const Ruler& ruler,
                                     const PathTolerance& tolerance) {
    std::vector<JointPositions> out = shown.q;
    std::size_t first = 0;
    std::size_t behind = 0;
    Vector6 sum = Vector6::Zero();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        while (behind < shown.size() && shown.times[behind] <= shown.times[i] + kSmoothedOver) {
            sum += shown.q[behind++].values;
        }
        while (shown.times[first] < shown.times[i] - kSmoothedOver) {
            sum -= shown.q[first++].values;
        }
        const JointPositions mean(Vector6(sum / static_cast<double>(behind - first)));
        const bool isEnd = i == 0 || i + 1 == shown.size();
        if (!isEnd && ruler.between(mean, shown.q[i]).share(tolerance) <= kSmoothingShare) {
            out[i] = mean;
        }
    }
    return out;
}

Error inRow(std::size_t row, const QString& what) {
    return {ErrorCode::FileCorrupt, QStringLiteral("row %1: %2").arg(row + 1).arg(what), {}};
}

}  // namespace

Demonstration withoutPauses(const Demonstration& shown) {
    const auto stands = [](const JointPositions& a, const JointPositions& b) {
        return (a.values - b.values).cwiseAbs().maxCoeff() < kStandstillTolerance;
    };
    std::size_t first = 0;
    std::size_t behind = shown.size();
    while (first + 1 < behind && stands(shown.q[first + 1], shown.q.front())) {
        ++first;
    }
    while (behind > first + 2 && stands(shown.q[behind - 2], shown.q.back())) {
        --behind;
    }
    Demonstration moving;
    for (std::size_t i = first; i < behind; ++i) {
        moving.append(shown.times[i], shown.q[i]);
    }
    return moving;
}

std::vector<KeptPlace> keptPath(const Demonstration& shown, const DhParameters& dh, const Pose& tcpOffset,
                                const PathTolerance& tolerance) {
    if (shown.size() == 0) {
        return {};
    }
    const Ruler ruler(dh, tcpOffset);
    const std::vector<JointPositions> smooth = smoothed(shown, ruler, tolerance);
    // Split the segment between two kept positions at the sample with the largest deviation until all
    // deviations are within the tolerance. Adjacent samples need no split, because each is close to its
    // smoothed position.
    std::vector<bool> kept(shown.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> ways{{0, shown.size() - 1}};
    while (!ways.empty()) {
        const auto [from, to] = ways.back();
        ways.pop_back();
        double furthest = 1;
        std::size_t at = from;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double share =
                ruler.fromPath(shown.q[i], smooth[from], smooth[to], tolerance).share(tolerance);
            if (share > furthest) {
                furthest = share;
                at = i;
            }
        }
        if (at != from) {
            kept[at] = true;
            ways.push_back({from, at});
            ways.push_back({at, to});
        }
    }
    std::vector<KeptPlace> places;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (kept[i]) {
            places.push_back({shown.times[i], smooth[i]});
        }
    }
    return places;
}

PathDeviation deviation(const Demonstration& shown, const std::vector<KeptPlace>& kept,
                        const DhParameters& dh, const Pose& tcpOffset, const PathTolerance& tolerance) {
    PathDeviation largest;
    if (kept.empty()) {
        return largest;
    }
    const Ruler ruler(dh, tcpOffset);
    std::size_t way = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        while (way + 2 < kept.size() && kept[way + 1].time < shown.times[i]) {
            ++way;
        }
        const JointPositions& to = kept[std::min(way + 1, kept.size() - 1)].q;
        const Offset off = ruler.fromPath(shown.q[i], kept[way].q, to, tolerance);
        largest.joints = std::max(largest.joints, off.joints);
        largest.tcp = std::max(largest.tcp, off.tcp);
    }
    return largest;
}

Demonstration alongPath(const std::vector<KeptPlace>& places, double period) {
    Demonstration along;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0) {
            const KeptPlace& from = places[i - 1];
            const double seconds = places[i].time - from.time;
            const int steps = static_cast<int>(std::ceil(seconds / period - 1e-9));
            for (int step = 1; step < steps; ++step) {
                const double at = step * period;
                along.append(from.time + at,
                             JointPositions(Vector6(from.q.values +
                                                    (places[i].q.values - from.q.values) * (at / seconds))));
            }
        }
        along.append(places[i].time, places[i].q);
    }
    return along;
}

QByteArray demonstrationCsv(const Demonstration& shown) {
    constexpr int kDigits = 17;  // full precision of a double
    QByteArray csv = "timestamp";
    for (int joint = 0; joint < 6; ++joint) {
        csv += ",actual_q_" + QByteArray::number(joint);
    }
    csv += '\n';
    for (std::size_t i = 0; i < shown.size(); ++i) {
        csv += QByteArray::number(shown.times[i], 'g', kDigits);
        for (int joint = 0; joint < 6; ++joint) {
            csv += ',' + QByteArray::number(shown.q[i][joint], 'g', kDigits);
        }
        csv += '\n';
    }
    return csv;
}

Result<Demonstration> demonstrationFrom(const std::vector<double>& times,
                                        const std::array<const std::vector<double>*, 6>& joints) {
    constexpr double kMaxJointTurn = 2 * std::numbers::pi;  // limit of all joints
    Demonstration shown;
    for (std::size_t row = 0; row < times.size(); ++row) {
        JointPositions q;
        for (int joint = 0; joint < 6; ++joint) {
            const std::vector<double>& column = *joints[static_cast<std::size_t>(joint)];
            q[joint] = row < column.size() ? column[row] : std::nan("");
        }
        if (!std::isfinite(times[row]) || !q.values.allFinite()) {
            return inRow(row, QStringLiteral("a cell is not a number"));
        }
        if (row > 0 && times[row] <= shown.times.back()) {
            return inRow(row, QStringLiteral("the time is not later than in the previous row"));
        }
        if (q.values.cwiseAbs().maxCoeff() > kMaxJointTurn + 1e-6) {
            return inRow(
                row, QStringLiteral(
                         "a joint position exceeds 360 degrees; positions must be in radians, not degrees"));
        }
        shown.append(times[row], q);
    }
    if (shown.size() < 2) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("the file contains fewer than two rows of numbers"), {}};
    }
    return shown;
}

}  // namespace tiller::project
