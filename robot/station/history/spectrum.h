// SPDX-License-Identifier: MIT
#pragma once

// How strong each frequency is in a stretch of samples, by Welch's method: neighbouring segments that overlap by half,
// each through a Hann window, and the mean of their powers.

#include <span>
#include <vector>

#include "robot/core/result.h"

namespace tiller {

struct Spectrum {
    double resolution = 0;          ///< between two lines [Hz]
    int segment = 0;                ///< samples in each
    int segments = 0;               ///< the mean of so many
    std::vector<double> amplitude;  ///< peak value of each line, from 0 Hz on, in the signal's unit
};

/// values  one every `period` seconds, without a gap; what is constant in them is left out but for the first line
/// Errors  InvalidArgument, saying what to do: fewer than kLeast samples, no period, a value that is none
Result<Spectrum> spectrumOf(std::span<const double> values, double period);
inline constexpr int kLeastForSpectrum = 16;

}  // namespace tiller
