// SPDX-License-Identifier: MIT
#pragma once

// What came of comparing a recording with the model of its arm, in sentences.

#include <QString>

#include "robot/divergence/divergence.h"

namespace tiller {

/// "0.80°", "6.2 mm", "4.20 A", "61.0 N"
QString amountText(divergence::Quantity quantity, double amount);
/// For the mark in the plots: "Elbow 0.80°"
QString partingMark(const divergence::Difference& parting);
/// "Arm and model part at 12.348 s: Elbow is 0.80° off"
QString partingText(const divergence::Difference& parting);
/// The same for a comparison as a whole, also where they never part.
QString reportText(const divergence::Report& report);
/// What to look at, and a line for each quantity: how far they were apart at most, and since when beyond the limit.
QString reportDetails(const divergence::Report& report);
/// Why there is no comparison, and what to do.
QString comparisonError(const Error& error);

}  // namespace tiller
