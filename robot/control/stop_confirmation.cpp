// SPDX-License-Identifier: MIT
#include "robot/control/stop_confirmation.h"

#include "robot/control/stop_meter.h"
#include "robot/core/clock.h"

namespace tiller::control {

namespace {

// Time after which the arm must be decelerating. A stop takes about 20 ms to reach the arm.
constexpr std::int64_t kBrakesAfterNs = 100 * kNsPerMs;
constexpr std::int64_t kCompareEveryNs = 50 * kNsPerMs;
// At standstill, the control program confirms a stop within this time.
constexpr std::int64_t kConfirmedAfterNs = 200 * kNsPerMs;
constexpr std::int64_t kMaxBrakingNs = 1000 * kNsPerMs;

}  // namespace

StopConfirmation::StopConfirmation(std::uint64_t epoch, const StopEvidence& evidence)
    : epoch_(epoch)
    , requestNs_(evidence.nowNs)
    , lookNs_(evidence.nowNs + kBrakesAfterNs)
    , tcpSpeed_(evidence.tcpSpeed)
    , jointSpeed_(evidence.jointSpeed) {}

bool StopConfirmation::isConfirmed(const StopEvidence& evidence) const {
    if (evidence.inControl && evidence.executedEpoch > epoch_) {
        return true;  // the control program executes a motion that was started after the stop
    }
    const bool still = evidence.fresh && !evidence.moving && evidence.dataNs > requestNs_;
    return still && (evidence.stopped || (evidence.inControl && evidence.restingEpoch >= epoch_));
}

bool StopConfirmation::isSlower(const StopEvidence& evidence) const {
    return evidence.tcpSpeed < tcpSpeed_ - kStillTcpSpeed ||
           evidence.jointSpeed < jointSpeed_ - kStillJointSpeed;
}

StopConfirmation::Verdict StopConfirmation::look(const StopEvidence& evidence) {
    if (isConfirmed(evidence)) {
        return Verdict::Confirmed;
    }
    if (!evidence.inControl) {
        return Verdict::EveryRoute;
    }
    const std::int64_t since = evidence.nowNs - requestNs_;
    if (!evidence.fresh || !evidence.moving) {
        return since < kConfirmedAfterNs ? Verdict::Waiting : Verdict::EveryRoute;
    }
    if (evidence.nowNs < lookNs_) {
        return Verdict::Waiting;
    }
    if (!isSlower(evidence) || since >= kMaxBrakingNs) {
        return Verdict::EveryRoute;
    }
    lookNs_ = evidence.nowNs + kCompareEveryNs;
    tcpSpeed_ = evidence.tcpSpeed;
    jointSpeed_ = evidence.jointSpeed;
    return Verdict::Waiting;
}

}  // namespace tiller::control
