// SPDX-License-Identifier: MIT
#include "robot/control/stop_meter.h"

#include <algorithm>
#include <utility>

#include "robot/core/clock.h"
#include "robot/receive/data_age.h"

namespace tiller::control {

namespace {

/// After a longer gap in the data, the time of standstill is unknown.
constexpr std::int64_t kBlindNs = std::chrono::nanoseconds(receive::kMaxDataAge).count();

}  // namespace

void StopMeter::begin(StopCause cause, std::int64_t requestNs) {
    measuring_ = true;
    cause_ = cause;
    requestNs_ = requestNs;
    path_ = 0;
    stillSamples_ = 0;
}

void StopMeter::abandon(UnmeasuredStop::Reason reason) {
    if (std::exchange(measuring_, false)) {
        unmeasured_ = {cause_, reason, unmeasured_.count + 1};
    }
}

bool StopMeter::add(const Sample& sample) {
    const bool still = sample.tcpSpeed < kStillTcpSpeed && sample.jointSpeed < kStillJointSpeed;
    moving_ = !still;
    // Ignore samples received before the request, even if they show standstill.
    if (measuring_ && hasSample_ && sample.hostNs - previous_.hostNs > kBlindNs) {
        abandon(UnmeasuredStop::Reason::DataGap);  // standstill was reached within the gap
    }
    const bool counts = measuring_ && sample.hostNs >= requestNs_;
    if (counts && hasSample_) {
        path_ += (sample.tcpPosition - previous_.tcpPosition).norm();
    }
    previous_ = sample;
    hasSample_ = true;
    if (!counts) {
        return false;
    }
    constexpr int kStillSamples = 3;
    if (!still) {
        stillSamples_ = 0;
        return false;
    }
    if (stillSamples_++ == 0) {
        stillSinceNs_ = sample.hostNs;
        pathAtStill_ = path_;
    }
    if (stillSamples_ < kStillSamples) {
        return false;
    }
    measuring_ = false;
    constexpr double kMmPerM = 1000.0;
    last_.cause = cause_;
    last_.durationMs = static_cast<double>(stillSinceNs_ - requestNs_) / static_cast<double>(kNsPerMs);
    last_.distanceMm = pathAtStill_ * kMmPerM;
    ++last_.count;
    return true;
}

}  // namespace tiller::control
