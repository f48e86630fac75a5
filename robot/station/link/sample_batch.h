// SPDX-License-Identifier: MIT
#pragma once

// What the frame clock fetched from the receiver: every packet since the frame before, for those who draw or watch
// the full rate. SessionState is made from the last of them, so that all parts of the window show the same sample.

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
