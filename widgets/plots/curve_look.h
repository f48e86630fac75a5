// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Appearance of the curves of a plot: distinguished by colour, and from the fifth on also by dashes.

#include <QPen>
#include <vector>

namespace tiller {

class SignalStore;
struct Theme;

/// Cosmetic pens, one per signal, all different. The first x, y and z have the axis colours, other signals curve
/// colours. Adding a signal does not change the pens of those before it.
std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme);
/// The recording of a signal if signals of other sources are shown as well; empty: live, or the same for all.
QString curveSource(const SignalStore& store, const std::vector<int>& shown, int signal);
/// The text in the legend: "Base" if all signals are joint currents, "I Base" among other signals.
QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal);

}  // namespace tiller
