// SPDX-License-Identifier: MIT
#pragma once

// All packets that the frame clock fetched from the receiver since the previous frame, for plots and other users of
// the full rate. SessionState is made from the last one, so that all parts of the window show the same sample.

#include <QMetaType>
#include <cstdint>
#include <span>

#include "robot/receive/sample.h"

namespace tiller {

struct SampleBatch {
    std::span<const receive::Sample> samples;  ///< oldest first; valid while the signal that carries it runs
    std::uint64_t lost = 0;                    ///< overwritten before a frame came to fetch them
};

}  // namespace tiller

Q_DECLARE_METATYPE(tiller::SampleBatch)
