// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/back_track.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace tiller {
namespace {

/// How near to the beginning is there [rad].
constexpr double kThere = 0.001;
/// A place counts as reached this long before the arm is there, because the picture of the arm is some
/// hundredths of a second old [s].
constexpr double kAhead = 0.08;
/// Slowing down at the end of the way [rad/s per rad].
constexpr double kApproach = 4.0;

double apart(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

}  // namespace

BackTrack::BackTrack(const MotionPort& port, std::function<double()> speed)
    : port_(port), speed_(std::move(speed)) {}

void BackTrack::record(const JointPositions& q) {
    const bool jumped = !trail_.empty() && apart(now_, q) > kJump;
    now_ = q;
    if (jumped) {
        trail_.clear();
    }
    if (going_ != 0 || (!trail_.empty() && apart(trail_.back(), q) < kSpacing)) {
        return;
    }
    trail_.push_back(q);
    if (trail_.size() > kCapacity) {
        trail_.pop_front();
    }
}

void BackTrack::clear() {
    trail_.clear();
}

bool BackTrack::isEmpty() const {
    return trail_.empty() || (trail_.size() == 1 && apart(trail_.front(), now_) < kSpacing);
}

Result<control::JogTarget> BackTrack::next() {
    const double speed = speed_();
    const double reach = std::max(1.5 * kSpacing, speed * kAhead);
    while (trail_.size() > 1 && apart(trail_.back(), now_) < reach) {
        trail_.pop_back();  // the beginning stays known
    }
    const double left = trail_.empty() ? 0 : apart(trail_.back(), now_);
    if (left < kThere) {
        return Error{ErrorCode::Rejected,
                     QCoreApplication::translate("BackTrack", "go back: nothing left to undo"),
                     {}};
    }
    control::JogTarget target;
    target.kind = control::JogTarget::Kind::Joint;
    const double wanted = trail_.size() > 1 ? speed : std::min(speed, kApproach * left);
    target.qd = JointVelocities(Vector6((trail_.back().values - now_.values) * (wanted / left)));
    return target;
}

HoldBounds BackTrack::bounds() const {
    double way = 0;
    const JointPositions* from = &now_;
    for (auto place = trail_.rbegin(); place != trail_.rend(); ++place) {
        way += apart(*from, *place);
        from = &*place;
    }
    const double speed = std::max(speed_(), 1e-3);
    return {HoldBounds::longestOf(way / speed), HoldRules::silenceAt(0, speed)};
}

HoldMotion BackTrack::motion() {
    return {
        .begin = [this]() -> Result<HoldMotion::Id> {
            const Result<control::JogTarget> target = next();
            if (!target) {
                return target.error();
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
                // Whatever ended the jog was a stop, and a stop is final.
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
