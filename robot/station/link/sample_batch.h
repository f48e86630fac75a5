// SPDX-License-Identifier: MIT
#pragma once

// All packets that the frame timer has fetched from the receiver since the previous frame, for plots and
// other clients that need the full rate. SessionState is created from the last packet, so that all parts of
// the window show the same sample.

#include <QMetaType>
#include <cstdint>
#include <span>

#include "robot/receive/sample.h"

namespace tiller {

struct SampleBatch {
    std::span<const receive::Sample> samples;  ///< oldest first; valid only during the signal
    std::uint64_t lost = 0;                    ///< samples lost because the ring buffer was full
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::SampleBatch)
