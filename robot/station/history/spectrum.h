// SPDX-License-Identifier: MIT
#pragma once

// Amplitude spectrum of a range of samples by Welch's method: 50 % overlapping segments, Hann window,
// averaged power.

#include <span>
#include <vector>

#include "robot/core/result.h"

namespace tiller {

struct Spectrum {
    double resolution = 0;          ///< distance between two lines [Hz]
    int segment = 0;                ///< samples per segment
    int segments = 0;               ///< number of averaged segments
    std::vector<double> amplitude;  ///< peak value of each line from 0 Hz, in the signal's unit
};

/// values  one every `period` seconds, without gaps; their mean is removed and appears only in the first line
/// Errors  InvalidArgument with the suggested action: fewer than kMinSpectrumSamples samples, no period, a
///         value that is not finite
Result<Spectrum> spectrumOf(std::span<const double> values, double period);
inline constexpr int kMinSpectrumSamples = 16;

}  // namespace tiller
