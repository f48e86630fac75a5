// SPDX-License-Identifier: MIT
#pragma once

// Path parameter over time, as segments of constant acceleration: trapezoids, blends of trapezoids, and
// slowed-down variants. Fixed capacity, no allocation.

#include <array>
#include <span>

namespace tiller::simulator::arm {

struct ProfileSample {
    double s = 0;  ///< path parameter
    double v = 0;  ///< ds/dt
    double a = 0;  ///< d2s/dt2
};

/// Request for a profile, in the unit of the path (m or rad).
struct ProfileRequest {
    double length = 0;
    double v = 0;  ///< cruise speed, > 0
    double a = 0;  ///< acceleration and deceleration, > 0
    double startSpeed = 0;
    double blendInTime = 0;    ///< duration of the limited acceleration at the start
    double blendInLength = 0;  ///< maximum length of this part
    double zone = 0;           ///< length before the end within which a blend may begin
    double zoneSpeed = 0;      ///< maximum speed at the beginning of the zone
};

class SpeedProfile {
public:
    static constexpr int kMaxPhases = 420;

    static SpeedProfile plan(const ProfileRequest& request);
    /// Decelerates from speed v to rest in `duration`.
    static SpeedProfile stop(double v, double duration);
    /// Passes through points with given speeds at path parameters s (ascending, at least two), with constant
    /// acceleration between the points. `zoneStart` is the path parameter where the blend zone begins.
    static SpeedProfile through(std::span<const double> s, std::span<const double> v, double zoneStart);

    ProfileSample sample(double t) const;
    double duration() const { return count_ == 0 ? 0.0 : start_[last()].t + duration_[last()]; }
    double length() const;
    double zoneTime() const { return zoneTime_; }  ///< duration() if there is no blend zone
    double speedAtLength(double s) const;          ///< speed when the path parameter is s
    double timeAtLength(double s) const;           ///< time when the path parameter is s
    double peakSpeed() const;
    double peakAcceleration() const;
    /// Stretches time: speeds decrease by the factor, accelerations by its square.
    void stretch(double factor);
    bool full() const { return count_ >= kMaxPhases; }

private:
    struct Start {
        double t = 0, s = 0, v = 0;
    };
    std::size_t last() const { return static_cast<std::size_t>(count_ - 1); }
    void append(double acceleration, double duration);
    void appendRamp(double distance, double v, double vEnd, double a);
    Start end() const;

    std::array<Start, kMaxPhases> start_{};
    std::array<double, kMaxPhases> acceleration_{};
    std::array<double, kMaxPhases> duration_{};
    int count_ = 0;
    Start origin_{};
    double zoneTime_ = 0;
};

}  // namespace tiller::simulator::arm
