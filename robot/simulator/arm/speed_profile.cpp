// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/speed_profile.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
constexpr double kNoDistance = 1e-12;
double square(double x) {
    return x * x;
}
}  // namespace

SpeedProfile::Start SpeedProfile::end() const {
    if (count_ == 0) {
        return origin_;
    }
    const Start& p = start_[last()];
    const double d = duration_[last()];
    const double a = acceleration_[last()];
    return {p.t + d, p.s + p.v * d + 0.5 * a * d * d, std::max(0.0, p.v + a * d)};
}

void SpeedProfile::append(double acceleration, double duration) {
    if (duration <= kNoDistance || full()) {
        return;
    }
    const Start from = end();
    start_[static_cast<std::size_t>(count_)] = from;
    acceleration_[static_cast<std::size_t>(count_)] = acceleration;
    duration_[static_cast<std::size_t>(count_)] = duration;
    ++count_;
}

// Accelerates from the current speed to vEnd over `distance`, with at most v in between.
void SpeedProfile::appendRamp(double distance, double v, double vEnd, double a) {
    const double v0 = end().v;
    if (distance <= kNoDistance) {
        return;
    }
    if (v0 > v &&
        (square(v0) - square(v)) / (2 * a) + std::abs(square(v) - square(vEnd)) / (2 * a) <= distance) {
        append(-a, (v0 - v) / a);
        const double slowing = (square(v) - square(vEnd)) / (2 * a);
        const double cruise = distance - (square(v0) - square(v)) / (2 * a) - slowing;
        append(0, cruise / v);
        append(-a, (v - vEnd) / a);
        return;
    }
    double peak = std::sqrt(std::max(0.0, a * distance + 0.5 * (square(v0) + square(vEnd))));
    peak = std::max({peak, v0, vEnd});
    if (peak <= v) {
        append(a, (peak - v0) / a);
        append(-a, (peak - vEnd) / a);
        return;
    }
    peak = std::max({v, v0, vEnd});
    const double up = (square(peak) - square(v0)) / (2 * a);
    const double down = (square(peak) - square(vEnd)) / (2 * a);
    append(a, (peak - v0) / a);
    append(0, std::max(0.0, distance - up - down) / peak);
    append(-a, (peak - vEnd) / a);
}

SpeedProfile SpeedProfile::plan(const ProfileRequest& request) {
    SpeedProfile profile;
    profile.origin_.v = request.startSpeed;
    const double L = request.length;
    if (L <= kNoDistance || request.v <= 0 || request.a <= 0) {
        return profile;
    }
    if (request.blendInTime > kNoDistance) {
        const double T = request.blendInTime;
        double a = std::min(request.a, 2 * request.blendInLength / square(T));
        a = std::min(a, request.v / T);
        // The remaining path must be long enough for a stop.
        const double feasible = L / (0.5 * square(T) * (1 + a / request.a));
        a = std::min(a, feasible);
        profile.append(a, T);
    }
    double rest = L - profile.end().s;
    const double zone = std::min(request.zone, rest);
    double main = rest - zone;
    const double v0 = profile.end().v;
    double vEnd = 0;
    if (zone > kNoDistance) {
        vEnd = std::min(request.v, request.zoneSpeed);
        vEnd = std::min(vEnd, std::sqrt(square(v0) + 2 * request.a * main));
    }
    // If the speed is too high for the remaining path, enter the zone at a higher speed, or brake harder than
    // requested at the end.
    vEnd = std::max(vEnd, std::sqrt(std::max(0.0, square(v0) - 2 * request.a * main)));
    if (zone <= kNoDistance && vEnd > 1e-9) {
        profile.append(-square(v0) / (2 * rest), 2 * rest / v0);
        profile.zoneTime_ = profile.duration();
        return profile;
    }
    if (zone <= kNoDistance) {
        vEnd = 0;
    }
    profile.appendRamp(main, request.v, vEnd, request.a);
    profile.zoneTime_ = profile.duration();
    const double entry = profile.end().v;
    if (zone > kNoDistance && entry > kNoDistance) {
        profile.append(-square(entry) / (2 * zone), 2 * zone / entry);
    }
    return profile;
}

SpeedProfile SpeedProfile::stop(double v, double duration) {
    SpeedProfile profile;
    profile.origin_.v = v;
    profile.append(duration > 0 ? -v / duration : 0, duration);
    profile.zoneTime_ = profile.duration();
    return profile;
}

SpeedProfile SpeedProfile::through(std::span<const double> s, std::span<const double> v, double zoneStart) {
    SpeedProfile profile;
    profile.origin_.v = v.front();
    double zoneTime = -1;
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        if (zoneTime < 0 && s[i] >= zoneStart) {
            zoneTime = profile.duration();
        }
        const double distance = s[i + 1] - s[i];
        const double mean = 0.5 * (v[i] + v[i + 1]);
        if (distance <= kNoDistance || mean <= kNoDistance) {
            continue;
        }
        const double duration = distance / mean;
        profile.append((v[i + 1] - v[i]) / duration, duration);
    }
    profile.zoneTime_ = zoneTime < 0 ? profile.duration() : zoneTime;
    return profile;
}

ProfileSample SpeedProfile::sample(double t) const {
    if (count_ == 0) {
        return {};
    }
    if (t <= 0) {
        return {0, start_[0].v, 0};
    }
    const auto begin = start_.begin();
    const auto finish = begin + count_;
    const auto after = std::upper_bound(begin, finish, t, [](double x, const Start& p) { return x < p.t; });
    const auto i = static_cast<std::size_t>(after - begin - 1);
    const double dt = t - start_[i].t;
    if (i == last() && dt >= duration_[i]) {
        return {length(), 0, 0};
    }
    const double a = acceleration_[i];
    return {start_[i].s + start_[i].v * dt + 0.5 * a * dt * dt, start_[i].v + a * dt, a};
}

double SpeedProfile::length() const {
    return end().s;
}

double SpeedProfile::speedAtLength(double s) const {
    for (int i = count_ - 1; i >= 0; --i) {
        const auto k = static_cast<std::size_t>(i);
        if (s >= start_[k].s) {
            return std::sqrt(std::max(0.0, square(start_[k].v) + 2 * acceleration_[k] * (s - start_[k].s)));
        }
    }
    return origin_.v;
}

double SpeedProfile::timeAtLength(double s) const {
    for (int i = count_ - 1; i >= 0; --i) {
        const auto k = static_cast<std::size_t>(i);
        if (s >= start_[k].s) {
            const double distance = s - start_[k].s;
            const double v = start_[k].v;
            const double vEnd = std::sqrt(std::max(0.0, square(v) + 2 * acceleration_[k] * distance));
            const double mean = 0.5 * (v + vEnd);
            const double t = mean > kNoDistance ? distance / mean : duration_[k];
            return start_[k].t + std::min(t, duration_[k]);
        }
    }
    return 0;
}

double SpeedProfile::peakSpeed() const {
    double peak = end().v;
    for (int i = 0; i < count_; ++i) {
        peak = std::max(peak, start_[static_cast<std::size_t>(i)].v);
    }
    return peak;
}

double SpeedProfile::peakAcceleration() const {
    double peak = 0;
    for (int i = 0; i < count_; ++i) {
        peak = std::max(peak, std::abs(acceleration_[static_cast<std::size_t>(i)]));
    }
    return peak;
}

void SpeedProfile::stretch(double factor) {
    origin_.v /= factor;
    for (int i = 0; i < count_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        start_[k].t *= factor;
        start_[k].v /= factor;
        acceleration_[k] /= factor * factor;
        duration_[k] *= factor;
    }
    zoneTime_ *= factor;
}

}  // namespace tiller::simulator::arm
