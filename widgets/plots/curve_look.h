// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the curves of one plot look: told by their colours, and from the fifth on by their dashes too.

#include <QPen>
#include <vector>

namespace tiller {

class SignalStore;
struct Theme;

/// Cosmetic pens, one for each signal: the colours of the axes where all are x, y or z of one thing, those of curves
/// otherwise.
std::vector<QPen> curvePens(const SignalStore& store, const std::vector<int>& shown, const Theme& theme);
/// What each is called in the legend: "Base" among joint currents alone, "I Base" beside others.
QString curveLabel(const SignalStore& store, const std::vector<int>& shown, int signal);

}  // namespace tiller
