// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/back_track.h"

#include <QCoreApplication>

namespace tiller {
namespace {

double apart(const JointPositions& a, const JointPositions& b) {
    return (a.values - b.values).cwiseAbs().maxCoeff();
}

/// True when `middle` lies on the straight way between the others, going forward: it says nothing new.
bool isBetween(const JointPositions& first, const JointPositions& middle, const JointPositions& last) {
    const Vector6 way = last.values - first.values;
    const double length = way.squaredNorm();
    if (length < 1e-12) {
        return false;
    }
    const double t = (middle.values - first.values).dot(way) / length;
    const Vector6 off = middle.values - (first.values + t * way);
    return t >= 0 && t <= 1 && off.cwiseAbs().maxCoeff() < BackTrack::kSpacing / 4;
}

}  // namespace

BackTrack::BackTrack(const JogPort& port, std::function<MoveRequest(const JointPositions&)> moveTo)
    : port_(port), moveTo_(std::move(moveTo)) {}

void BackTrack::record(const JointPositions& q) {
    now_ = q;
    if (leg_ != 0) {
        return;
    }
    if (trail_.empty()) {
        trail_.push_back(q);
        return;
    }
    if (apart(trail_.back(), q) < kSpacing) {
        return;
    }
    if (trail_.size() >= 2 && isBetween(trail_[trail_.size() - 2], trail_.back(), q)) {
        trail_.back() = q;
    } else {
        trail_.push_back(q);
    }
    while (trail_.size() > kCapacity) {
        trail_.pop_front();
    }
}

void BackTrack::clear() {
    trail_.clear();
}

bool BackTrack::isEmpty() const {
    return trail_.empty() || (trail_.size() == 1 && apart(trail_.front(), now_) < kSpacing);
}

Result<HoldMotion::Id> BackTrack::next() {
    while (!trail_.empty() && apart(trail_.back(), now_) < kSpacing) {
        if (trail_.size() == 1) {
            break;  // the beginning stays known
        }
        trail_.pop_back();
    }
    if (isEmpty()) {
        return Error{ErrorCode::Rejected,
                     QCoreApplication::translate("BackTrack", "go back: nothing left to undo"),
                     {}};
    }
    return port_.beginMove(moveTo_(trail_.back()));
}

HoldMotion BackTrack::motion() {
    return {
        .begin = [this]() -> Result<HoldMotion::Id> {
            const Result<HoldMotion::Id> first = next();
            leg_ = first ? *first : 0;
            return first;
        },
        .hold =
            [this](HoldMotion::Id) {
                if (port_.hold(leg_)) {
                    return true;
                }
                // Only an arrival leads on: whatever else ended the leg was a stop, and a stop is final.
                if (port_.completed && port_.completed(leg_)) {
                    now_ = trail_.back();
                    if (const Result<HoldMotion::Id> more = next()) {
                        leg_ = *more;
                        return true;
                    }
                }
                leg_ = 0;
                return false;
            },
        .end = [this](HoldMotion::Id,
                      control::StopCause cause) { port_.endMotion(std::exchange(leg_, 0), cause); },
        .runsToEnd = {},
    };
}

}  // namespace tiller
