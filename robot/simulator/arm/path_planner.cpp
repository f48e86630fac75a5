// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "robot/simulator/arm/path_segment.h"

namespace tiller::simulator::arm {

namespace {
constexpr double kNearlyZero = 1e-9;
constexpr double kSampleStep = 0.01;        // m
constexpr double kFirstStep = 1e-4;         // m
constexpr double kLargestTurn = 0.12;       // rad between samples
constexpr double kSmallestFraction = 1e-4;  // fraction of the path; a large rotation in it: singularity
constexpr double kMaxFollowedTurn = 5;      // m; exceeds the longest possible path across the workspace
}  // namespace

ToolPoint PathPlanner::pointAt(const Segment& segment, double s) const {
    if (segment.inToolSpace) {
        return segment.path.at(s).at;
    }
    return ToolPoint(geometry_.tcpPose(segment.from + segment.direction * s));
}

double PathPlanner::lengthWithin(const Segment& segment, double radius, bool fromEnd) const {
    const double length =
        segment.inToolSpace ? segment.path.length() : (segment.endQ - segment.from).cwiseAbs().maxCoeff();
    const double half = 0.5 * length;
    const Eigen::Vector3d corner = pointAt(segment, fromEnd ? length : 0).p;
    const auto distance = [&](double within) {
        return (pointAt(segment, fromEnd ? length - within : within).p - corner).norm();
    };
    // Find the first point of the path outside the sphere around the corner.
    constexpr int kSteps = 16;
    double inside = 0;
    for (int i = 1; i <= kSteps; ++i) {
        double outside = half * i / kSteps;
        if (distance(outside) > radius) {
            for (int k = 0; k < 30; ++k) {
                const double middle = 0.5 * (inside + outside);
                (distance(middle) > radius ? outside : inside) = middle;
            }
            return inside;
        }
        inside = outside;
    }
    return half;
}

ProfileRequest PathPlanner::profileRequest(const Segment& segment, const MoveTiming& timing) const {
    ProfileRequest profile;
    profile.v = timing.v;
    profile.a = timing.a;
    profile.startSpeed = timing.startSpeed;
    profile.blendInTime = timing.blendInTime;
    if (segment.inToolSpace) {
        profile.length = segment.path.length();
    } else {
        profile.length = (segment.endQ - segment.from).cwiseAbs().maxCoeff();
        for (int j = 0; j < kJointCount; ++j) {
            const double share = std::abs(segment.direction[j]);
            if (share > kNearlyZero) {
                profile.v = std::min(profile.v, limits_.speed[j] / share);
                profile.a = std::min(profile.a, limits_.acceleration / share);
            }
        }
    }
    if (timing.blendInTime > 0) {
        profile.blendInLength = lengthWithin(segment, timing.blendInRadius, false);
    }
    if (segment.r > 0) {
        profile.zone = lengthWithin(segment, segment.r, true);
        if (segment.inToolSpace) {
            profile.zone = std::min(profile.zone, segment.path.straightEnd());
        }
        // Deceleration within the zone uses at most half of the acceleration `a`. The other half is reserved for the
        // start of the next move. A process move keeps its speed through the corner.
        profile.zoneSpeed =
            segment.kind == Segment::Kind::Process ? profile.v : std::sqrt(profile.a * profile.zone);
    }
    return profile;
}

void PathPlanner::plan(Segment& segment, const Vector6& startQ, const MoveTiming& timing) {
    segment.q = startQ;
    int samples = 0;
    if (segment.inToolSpace) {
        samples = sampleToolPath(segment, startQ);
        segment.endPoint = segment.path.finish();
    } else {
        segment.endPoint = ToolPoint(geometry_.tcpPose(segment.endQ));
    }
    const ProfileRequest profile = profileRequest(segment, timing);
    segment.profile = SpeedProfile::plan(profile);
    double a = profile.a;
    if (timing.t > 0 && segment.profile.duration() > 0) {
        double factor = timing.t / segment.profile.duration();
        if (!segment.inToolSpace) {
            // Stretch the whole profile to stay within the joint limits.
            for (int j = 0; j < kJointCount; ++j) {
                const double share = std::abs(segment.direction[j]);
                factor = std::max(factor, share * segment.profile.peakSpeed() / limits_.speed[j]);
                factor = std::max(
                    factor, std::sqrt(share * segment.profile.peakAcceleration() / limits_.acceleration));
            }
        }
        segment.profile.stretch(factor);
        a = std::max(a / (factor * factor), segment.profile.peakAcceleration());
    }
    if (segment.inToolSpace) {
        limitSpeeds(segment, samples, a);
    }
}

// Samples the path in steps small enough for the joints. Returns the number of reachable samples.
int PathPlanner::sampleToolPath(Segment& segment, const Vector6& startQ) {
    // A target may be far out of reach. The arm then moves towards the target to the end of its reach.
    const double length =
        std::min(segment.path.length(), kMaxFollowedTurn + 2 * geometry_.tcpTransform().translation().norm());
    const double widest = std::max(length / 200, std::min(kSampleStep, length / 32));
    const bool endsWithinReach = geometry_.isReachable(segment.path.finish().transform());
    // If the path ends out of reach, the speeds are calculated from the samples, which must then be close
    // together.
    double step = endsWithinReach ? widest : std::min(widest, kFirstStep);
    std::size_t count = 1;
    s_[0] = 0;
    q_[0] = startQ;
    segment.endFault.reset();
    segment.endFaultJoint = -1;
    while (s_[count - 1] < length - kNearlyZero && count < s_.size()) {
        const double s = std::min(length, s_[count - 1] + step);
        Vector6 q = q_[count - 1];
        const bool reached = geometry_.follow(segment.path.at(s).at.transform(), q, posture_);
        const double turn = (q - q_[count - 1]).cwiseAbs().maxCoeff();
        if (!reached || turn > kLargestTurn) {
            if (step > kSmallestFraction * length && count + 20 < s_.size()) {
                step *= 0.5;
                continue;
            }
            if (!reached || turn > 5 * kLargestTurn) {
                segment.endFault = endsWithinReach ? StopReason::Singularity : StopReason::PoseUnreachable;
                break;
            }
        }
        for (int j = 0; j < kJointCount; ++j) {
            if (std::abs(q[j]) > limits_.position) {
                segment.endFault = StopReason::JointPositionLimit;
                segment.endFaultJoint = j;
            }
        }
        if (segment.endFault) {
            break;
        }
        s_[count] = s;
        q_[count] = q;
        ++count;
        step = std::min(widest, turn < 0.5 * kLargestTurn ? 2 * step : step);
    }
    if (count == s_.size() && s_[count - 1] < length - kNearlyZero) {
        segment.endFault = StopReason::Singularity;
    }
    segment.endQ = q_[count - 1];
    return static_cast<int>(count);
}

// Where the profile exceeds the joint limits, it is replaced by the fastest profile within the limits.
void PathPlanner::limitSpeeds(Segment& segment, int count, double a) {
    const auto n = static_cast<std::size_t>(count);
    if (n < 2) {
        segment.profile = {};
        return;
    }
    const double usable = limits_.plannedAcceleration();
    bool limited = segment.endFault.has_value();
    for (std::size_t i = 0; i < n; ++i) {
        double limit = 1e9;
        a_[i] = a;
        for (const std::size_t k : {i > 0 ? i - 1 : i, i}) {
            if (k + 1 >= n) {
                continue;
            }
            const Vector6 slope = (q_[k + 1] - q_[k]) / (s_[k + 1] - s_[k]);
            for (int j = 0; j < kJointCount; ++j) {
                const double rate = std::abs(slope[j]);
                limit = std::min(limit, 0.98 * limits_.speed[j] / std::max(rate, kNearlyZero));
                a_[i] = std::min(a_[i], 0.5 * usable / std::max(rate, kNearlyZero));
            }
        }
        if (i > 0 && i + 1 < n) {
            const double before = s_[i] - s_[i - 1];
            const double after = s_[i + 1] - s_[i];
            const Vector6 bend =
                ((q_[i + 1] - q_[i]) / after - (q_[i] - q_[i - 1]) / before) / (0.5 * (before + after));
            const double sharpest = bend.cwiseAbs().maxCoeff();
            limit = std::min(limit, std::sqrt(0.5 * usable / std::max(sharpest, kNearlyZero)));
        }
        const double nominal = segment.profile.speedAtLength(s_[i]);
        limited = limited || nominal > limit || a_[i] < segment.profile.peakAcceleration() * (1 - 1e-9);
        v_[i] = std::min(nominal, limit);
    }
    if (!limited) {
        return;
    }
    const double zoneStart = segment.profile.length() - segment.zoneLength();
    const bool hasZone = segment.r > 0 && !segment.endFault;
    if (segment.endFault) {
        v_[n - 1] = 0;
        segment.r = 0;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double gain = 2 * std::min(a_[i - 1], a_[i]) * (s_[i] - s_[i - 1]);
        v_[i] = std::min(v_[i], std::sqrt(v_[i - 1] * v_[i - 1] + gain));
    }
    for (std::size_t i = n - 1; i-- > 0;) {
        const double gain = 2 * std::min(a_[i + 1], a_[i]) * (s_[i + 1] - s_[i]);
        v_[i] = std::min(v_[i], std::sqrt(v_[i + 1] * v_[i + 1] + gain));
    }
    segment.profile =
        SpeedProfile::through({s_.data(), n}, {v_.data(), n}, hasZone ? zoneStart : s_[n - 1] + 1);
}

}  // namespace tiller::simulator::arm
