// SPDX-License-Identifier: MIT
#pragma once

// Text for the comparison of a recording with the model of its arm.

#include <QString>

#include "robot/divergence/divergence.h"

namespace tiller {

/// Amount with its unit, e.g. "0.80°", "6.2 mm", "4.20 A", "61.0 N".
QString amountText(divergence::Quantity quantity, double amount);
/// Short label for the mark in the plots, e.g. "Elbow 0.80°".
QString deviationMark(const divergence::Difference& parting);
/// Example: "Arm and model diverge at 12.348 s: Elbow deviates by 0.80°".
QString deviationText(const divergence::Difference& parting);
/// Result of the whole comparison, including the case without a deviation.
QString reportText(const divergence::Report& report);
/// The suggested checks, and one line per quantity with its largest deviation and the time at which it first
/// exceeds the limit.
QString reportDetails(const divergence::Report& report);
/// Why the comparison is not possible, and the suggested action.
QString comparisonError(const Error& error);

}  // namespace tiller
