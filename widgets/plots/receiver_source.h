// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rows for the plots out of the receiver's ring.

#include <array>
#include <cstddef>
#include <limits>

#include "robot/receive/receiver.h"
#include "widgets/plots/sample_pump.h"

namespace tiller {

/// Threads  GUI. Stays valid after the receiver is gone
class ReceiverSource : public PlotSource {
public:
    explicit ReceiverSource(const receive::Receiver& receiver);

    std::uint64_t drain(const std::function<void(const PlotRow&)>& take) override;

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    receive::Subscription subscription_;
    receive::Sample sample_;
    std::size_t timestamp_ = kNone;
    std::array<std::size_t, kPlotSignalCount> values_{};  // where in the sample
    std::uint64_t connection_ = 0;
    std::uint64_t lostBefore_ = 0;
};

}  // namespace tiller
