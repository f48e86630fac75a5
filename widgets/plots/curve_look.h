// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Appearance of the curves of a plot: distinguished by colour, and from the fifth on also by dashes.

#include <QPen>
#include <vector>

namespace tiller {

class SignalStore;
struct Theme;

/// Cosmetic pens, one per signal: the axis colours if all are x, y or z of one quantity, otherwise curve colours.
std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme);
/// The text in the legend: "Base" if all signals are joint currents, "I Base" among other signals.
QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal);

}  // namespace tiller
