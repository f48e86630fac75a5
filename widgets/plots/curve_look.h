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
/// What each is called in the legend: "Base" among joint currents alone, "I Base" beside others.
QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal);

}  // namespace tiller
