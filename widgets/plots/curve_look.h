// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Appearance of the curves of a plot. Curves differ in colour and, from the fifth curve on, also in their
// dashes.

#include <QPen>
#include <vector>

namespace tiller {

class SignalStore;
struct Theme;

/// Returns a different cosmetic pen for each signal. The first x, y and z signals have the axis colours, and
/// other signals have curve colours. Adding a signal does not change the pens of the signals before it.
std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme);
/// Returns the recording that contains the signal if the plot also shows signals of other sources. Empty if
/// the signal is live or all signals have the same source.
QString curveSource(const SignalStore& store, const std::vector<int>& shown, int signal);
/// Returns the text in the legend, e.g. "Base" if all signals are joint currents, or "I Base" among other
/// signals.
QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal);

}  // namespace tiller
