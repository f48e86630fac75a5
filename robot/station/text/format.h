// SPDX-License-Identifier: MIT
#pragma once

// Formats numbers for the screen: SI units in, degrees out, a true minus sign, a fixed number of digits, and
// the unit. Lengths and speeds are in notation.h because the operator can choose their unit. The decimal
// separator is that of the window language, not of the system's locale.

#include <QString>
#include <cstdint>

namespace tiller::format {

/// "−12.40", "12.40"; never "−0.00". Not a number gives "–".
QString number(double value, int digits);
/// As number(), with '+' before positive values.
QString signedNumber(double value, int digits);

/// radians -> "−88.24°"
QString degrees(double radians, int digits = 2);
QString newtons(double value);       ///< "−9.8 N"
QString newtonMetres(double value);  ///< "0.12 Nm"
QString amperes(double value);       ///< "1.204 A"
/// fraction -> "35 %"
QString percent(double fraction);
/// radians per second -> "60 °/s"
QString degreesPerSecond(double radiansPerSecond);

/// 96000 -> "96 000" (thin spaces between groups of three)
QString grouped(std::uint64_t value);
/// seconds -> "00:03:12"
QString duration(double seconds);
/// bytes -> "80 GB"
QString bytes(std::int64_t value);

}  // namespace tiller::format
