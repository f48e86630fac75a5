// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/path_motion.h"

#include <algorithm>

namespace tiller::simulator::arm {

void PathMotion::start(const Segment& segment) {
    current_ = segment;
    current_.time = 0;
    q_ = current_.q;
    active_ = true;
    tailActive_ = nextWaiting_ = false;
}

void PathMotion::start(const Segment& segment, const Segment& runOut) {
    start(segment);
    tail_ = runOut;
    tail_.time = 0;
    tailActive_ = true;
    tailIsRunOut_ = true;
    q_ = tail_.q;
}

bool PathMotion::acceptsNext() const {
    return active_ && !nextWaiting_ && current_.kind != Segment::Kind::Stop && current_.r > 0 &&
           !current_.endFault && !current_.finished();
}

void PathMotion::setNext(const Segment& segment, double switchTime) {
    next_ = segment;
    nextWaiting_ = true;
    switchTime_ = switchTime;
}

bool PathMotion::currentReturned(double timeScale) const {
    if (!active_ || current_.r <= 0 || current_.endFault) {
        return false;
    }
    return !tailActive_ && current_.time + 2 * period_ * timeScale >= current_.profile.zoneTime();
}

bool PathMotion::finished() const {
    return !active_ || (!tailActive_ && !nextWaiting_ && current_.finished());
}

void PathMotion::prepare(double dtProgramMax) {
    if (!nextWaiting_ || tailActive_ || current_.time + dtProgramMax < switchTime_) {
        return;
    }
    tail_ = current_;
    tailActive_ = true;
    tailIsRunOut_ = false;
    current_ = next_;
    // A negative time means that the segment starts within this step.
    current_.time = std::min(0.0, tail_.time - switchTime_);
    nextWaiting_ = false;
}

bool PathMotion::evaluateSegment(const Segment& segment, double time, Vector6& q, Vector6& rate) {
    const ProfileSample at = segment.profile.sample(time);
    const double v = time < 0 ? 0.0 : at.v;
    if (!segment.inToolSpace) {
        q = segment.from + segment.direction * at.s;
        rate = segment.direction * v;
        return true;
    }
    const ToolPathPoint point = segment.path.at(at.s);
    q = segment.q;
    if (!geometry_.follow(point.at.transform(), q, posture_)) {
        return false;
    }
    Vector6 twist;
    twist << point.dp * v, point.w * v;
    return v <= 0 ? (rate.setZero(), true) : geometry_.jointRates(posture_, twist, rate);
}

// Adds two tool paths in tool space, so that an orientation common to both is kept through the corner.
bool PathMotion::evaluateToolSum(double tailTime, double time, PathCandidate& candidate) {
    const ProfileSample a = tail_.profile.sample(tailTime);
    const ProfileSample b = current_.profile.sample(time);
    const double vb = time < 0 ? 0.0 : b.v;
    const ToolPathPoint from = tail_.path.at(a.s);
    const ToolPathPoint to = current_.path.at(b.s);
    const ToolPoint& corner = current_.path.start();
    const Eigen::Quaterniond left = from.at.R * corner.R.conjugate();
    const ToolPoint sum(from.at.p + to.at.p - corner.p, left * to.at.R);
    candidate.q = q_;
    if (!geometry_.follow(sum.transform(), candidate.q, posture_)) {
        return false;
    }
    Vector6 twist;
    twist << from.dp * a.v + to.dp * vb, from.w * a.v + left * Eigen::Vector3d(to.w * vb);
    candidate.currentQ = candidate.tailQ = candidate.q;
    return geometry_.jointRates(posture_, twist, candidate.rateProgram);
}

void PathMotion::evaluate(double dt, double dtProgram, PathCandidate& candidate) {
    const double time = current_.time + (current_.realTime ? dt : dtProgram);
    candidate.rateReal.setZero();
    candidate.rateProgram.setZero();
    Vector6 rate = Vector6::Zero();
    if (!tailActive_) {
        candidate.reached = evaluateSegment(current_, time, candidate.currentQ, rate);
        candidate.q = candidate.currentQ;
        (current_.realTime ? candidate.rateReal : candidate.rateProgram) = rate;
        return;
    }
    const double tailTime = tail_.time + (tail_.realTime ? dt : dtProgram);
    if (!tailIsRunOut_ && current_.path.isRounded() && current_.inToolSpace) {
        // The rounded path begins on the previous line, so the segments are executed one after the other
        // instead of simultaneously.
        const bool on = time >= 0;
        candidate.reached = evaluateSegment(on ? current_ : tail_, on ? time : tailTime, candidate.q, rate);
        candidate.currentQ = candidate.tailQ = candidate.q;
        candidate.rateProgram = rate;
        return;
    }
    if (!tailIsRunOut_ && tail_.inToolSpace && current_.inToolSpace) {
        candidate.reached = evaluateToolSum(tailTime, time, candidate);
        return;
    }
    Vector6 tailRate = Vector6::Zero();
    const bool tailReached = evaluateSegment(tail_, tailTime, candidate.tailQ, tailRate);
    candidate.reached = evaluateSegment(current_, time, candidate.currentQ, rate) && tailReached;
    const Vector6& corner = tail_.endQ;
    candidate.q = candidate.tailQ + candidate.currentQ - corner;
    (tail_.realTime ? candidate.rateReal : candidate.rateProgram) += tailRate;
    (current_.realTime ? candidate.rateReal : candidate.rateProgram) += rate;
}

void PathMotion::commit(double dt, double dtProgram, const PathCandidate& candidate) {
    current_.time += current_.realTime ? dt : dtProgram;
    current_.q = candidate.currentQ;
    q_ = candidate.q;
    if (!tailActive_) {
        return;
    }
    tail_.time += tail_.realTime ? dt : dtProgram;
    tail_.q = candidate.tailQ;
    const bool rounded = !tailIsRunOut_ && current_.inToolSpace && current_.path.isRounded();
    if (rounded ? current_.time >= 0 : tail_.finished()) {
        tailActive_ = false;
        current_.q = candidate.q;
    }
}

}  // namespace tiller::simulator::arm
