// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/receiver_source.h"

namespace tiller {

ReceiverSource::ReceiverSource(const receive::Receiver& receiver)
    : subscription_(receiver.subscribe()), sample_(receiver.layout()) {
    const receive::SampleLayout& layout = *receiver.layout();
    timestamp_ = layout.indexOfComponent("timestamp").value_or(kNone);
    for (int i = 0; i < kPlotSignalCount; ++i) {
        values_[static_cast<std::size_t>(i)] =
            layout.indexOfComponent(plot_signals::column(static_cast<PlotSignal>(i))).value_or(kNone);
    }
}

std::uint64_t ReceiverSource::drain(const std::function<void(const PlotRow&)>& take) {
    while (subscription_.next(sample_)) {
        PlotRow row;
        row.robotTime = sample_.at(timestamp_);
        row.sequence = sample_.sequence;
        row.gapBefore = sample_.lostBefore > 0 || (connection_ != 0 && sample_.connection != connection_);
        connection_ = sample_.connection;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            row.values[i] = static_cast<float>(sample_.at(values_[i]));
        }
        take(row);
    }
    const std::uint64_t lost = subscription_.lost() - lostBefore_;
    lostBefore_ = subscription_.lost();
    return lost;
}

}  // namespace tiller
