// SPDX-License-Identifier: MIT
#include "robot/station/history/spectrum.h"

#include <kissfft/kiss_fftr.h>

#include <QCoreApplication>
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct SpectrumText {
    Q_DECLARE_TR_FUNCTIONS(Spectrum)
};

/// Longer segments would have a resolution that a screen cannot show.
constexpr std::size_t kMaxSegment = 8192;

struct FreePlan {
    void operator()(kiss_fftr_cfg plan) const { kiss_fftr_free(plan); }
};

}  // namespace

Result<Spectrum> spectrumOf(std::span<const double> values, double period) {
    const auto refuse = [](const QString& why) {
        return Error{ErrorCode::InvalidArgument, SpectrumText::tr("compute a spectrum"), why};
    };
    if (values.size() < kMinSpectrumSamples || !(period > 0)) {
        return refuse(SpectrumText::tr("The range contains fewer than %1 samples. Select a longer range.")
                          .arg(kMinSpectrumSamples));
    }
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
        return refuse(SpectrumText::tr("Values are missing in this range. Select a range without gaps."));
    }
    const std::size_t length = std::min(std::bit_floor(values.size()), kMaxSegment);
    std::vector<double> window(length);
    double sum = 0;
    for (std::size_t i = 0; i < length; ++i) {
        window[i] =
            0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
        sum += window[i];
    }
    const std::unique_ptr<kiss_fftr_state, FreePlan> plan(
        kiss_fftr_alloc(static_cast<int>(length), 0, nullptr, nullptr));
    if (!plan) {
        return refuse(SpectrumText::tr("Not enough memory. Select a shorter range."));
    }
    double mean = 0;
    for (const double value : values) {
        mean += value / static_cast<double>(values.size());
    }
    Spectrum spectrum;
    spectrum.resolution = 1 / (period * static_cast<double>(length));
    spectrum.segment = static_cast<int>(length);
    std::vector<double> power(length / 2 + 1, 0);
    std::vector<kiss_fft_scalar> in(length);
    std::vector<kiss_fft_cpx> out(length / 2 + 1);
    for (std::size_t at = 0; at + length <= values.size(); at += length / 2) {
        for (std::size_t i = 0; i < length; ++i) {
            in[i] = static_cast<kiss_fft_scalar>((values[at + i] - mean) * window[i]);
        }
        kiss_fftr(plan.get(), in.data(), out.data());
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double real = static_cast<double>(out[i].r);
            const double imaginary = static_cast<double>(out[i].i);
            power[i] += real * real + imaginary * imaginary;
        }
        ++spectrum.segments;
    }
    for (std::size_t i = 0; i < power.size(); ++i) {
        // Half of the power is at negative frequencies, except for the first and the last line.
        const double sides = i == 0 || i + 1 == power.size() ? 1 : 2;
        spectrum.amplitude.push_back(sides * std::sqrt(power[i] / spectrum.segments) / sum);
    }
    spectrum.amplitude.front() = std::abs(mean);
    return spectrum;
}

}  // namespace tiller
