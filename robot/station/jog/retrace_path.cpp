// SPDX-License-Identifier: MIT
#include "robot/station/jog/retrace_path.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tiller {
namespace {

/// Distance at which the start of the trail is reached [rad].
constexpr double kThere = 0.001;
/// Positions are considered reached this time in advance, because the reported positions are delayed by a few
/// hundredths of a second [s].
constexpr double kAhead = 0.08;
/// Speed per remaining distance at the end of the trail [1/s].
constexpr double kApproach = 4.0;

double apart(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

}  // namespace

RetracePath::RetracePath(const MotionPort& port, Speed speed) : port_(port), speed_(std::move(speed)) {}

void RetracePath::record(const JointPositions& q) {
    const bool jumped = !trail_.empty() && apart(now_, q) > kJump;
    now_ = q;
    if (jumped) {
        clear();
    }
    if (going_ != 0 || (!trail_.empty() && apart(trail_.back(), q) < kSpacing)) {
        return;
    }
    trail_.push_back(q);
    ++revision_;
    if (trail_.size() > kCapacity) {
        trail_.pop_front();
    }
}

void RetracePath::clear() {
    trail_.clear();
    ++revision_;
}

bool RetracePath::isEmpty() const {
    return trail_.empty() || (trail_.size() == 1 && apart(trail_.front(), now_) < kSpacing);
}

Result<control::JogTarget> RetracePath::next() {
    const double reach =
        std::max(1.5 * kSpacing, (trail_.empty() ? 0 : speed_(now_, trail_.back())) * kAhead);
    while (trail_.size() > 1 && apart(trail_.back(), now_) < reach) {
        trail_.pop_back();  // the start of the trail is kept
        ++revision_;
    }
    const double left = trail_.empty() ? 0 : apart(trail_.back(), now_);
    if (left < kThere) {
        return Error{
            ErrorCode::Rejected,
            QCoreApplication::translate("RetracePath", "There is no path to retrace. Jog the arm first."),
            {}};
    }
    const double speed = speed_(now_, trail_.back());
    control::JogTarget target;
    target.kind = control::JogTarget::Kind::Joint;
    const double wanted = trail_.size() > 1 ? speed : std::min(speed, kApproach * left);
    target.qd = JointVelocities(Vector6((trail_.back().values - now_.values) * (wanted / left)));
    return target;
}

std::optional<JointPositions> RetracePath::nextPlace() const {
    if (isEmpty()) {
        return std::nullopt;
    }
    // Skip the newest position if the arm is already there.
    const auto place = std::find_if(trail_.rbegin(), trail_.rend(), [this](const JointPositions& q) {
        return apart(q, now_) >= kSpacing / 2;
    });
    return place == trail_.rend() ? trail_.front() : *place;
}

/// Discards the part of the trail that is no longer permitted. The cell may have changed since the arm moved
/// along the trail, or a jog may have moved the arm closer to an obstacle than is permitted for a move.
/// Returns an error if not even the newest part is permitted.
Result<void> RetracePath::keepPermitted() {
    const std::vector<JointPositions> way(trail_.rbegin(), trail_.rend());
    const auto permitted = [&](std::size_t count) { return port_.permitsPath(std::span(way).first(count)); };
    Result<void> whole = port_.permitsPath ? permitted(way.size()) : Result<void>();
    if (whole) {
        return whole;
    }
    std::size_t kept = 0;
    for (std::size_t end = way.size(); end - kept > 1;) {
        const std::size_t middle = kept + (end - kept) / 2;
        (permitted(middle) ? kept : end) = middle;
    }
    if (kept < 2) {  // the newest position may be the current position of the arm
        return whole;
    }
    trail_.erase(trail_.begin(), trail_.end() - static_cast<std::ptrdiff_t>(kept));
    ++revision_;
    return {};
}

double RetracePath::speed() const {
    const std::optional<JointPositions> place = nextPlace();
    return place ? speed_(now_, *place) : 0;
}

HoldBounds RetracePath::bounds() const {
    // The permitted speed varies along the trail, but evaluating it at thousands of positions would take too
    // long.
    constexpr std::size_t kAsked = 32;
    const std::size_t stride = trail_.size() / kAsked + 1;
    double seconds = 0;
    double fastest = 0;
    double speed = 0;
    const JointPositions* from = &now_;
    std::size_t count = 0;
    for (auto place = trail_.rbegin(); place != trail_.rend(); ++place) {
        if (count++ % stride == 0) {
            speed = std::max(speed_(*from, *place), 1e-3);
            fastest = std::max(fastest, speed);
        }
        seconds += apart(*from, *place) / speed;
        from = &*place;
    }
    return {HoldBounds::longestOf(seconds), HoldBounds::holdTimeoutAt(0, fastest)};
}

HoldMotion RetracePath::motion() {
    return {
        .begin = [this]() -> Result<HoldMotion::Id> {
            const Result<control::JogTarget> target = next();
            if (!target) {
                return target.error();
            }
            if (const Result<void> permitted = keepPermitted(); !permitted) {
                return permitted.error();
            }
            const Result<HoldMotion::Id> jog = port_.beginJog(*target);
            going_ = jog ? *jog : 0;
            return jog;
        },
        .hold =
            [this](HoldMotion::Id id) {
                const Result<control::JogTarget> target = next();
                if (!target) {
                    going_ = 0;
                    port_.endMotion(id, control::StopCause::Completed);
                    return false;
                }
                // Any end of the jog is a stop, after which the motion cannot continue.
                if (!port_.holdWith(id, *target)) {
                    going_ = 0;
                }
                return going_ != 0;
            },
        .end =
            [this](HoldMotion::Id id, control::StopCause cause) {
                going_ = 0;
                port_.endMotion(id, cause);
            },
        .runsToEnd = {},
        .bounds = [this] { return bounds(); },
    };
}

}  // namespace tiller
