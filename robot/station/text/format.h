// SPDX-License-Identifier: MIT
#pragma once

// Formats numbers for display. Input values are in SI units. Angles are displayed in degrees, with a true
// minus sign, a fixed number of digits and the unit. Lengths and speeds are in notation.h, because the
// operator can choose their units. The decimal separator is that of the window language instead of the
// system's locale.

#include <QString>
#include <cstdint>

namespace tiller::format {

/// Examples: "−12.40", "12.40". Never "−0.00". NaN and infinity are displayed as "–". Values of 1e15 and
/// more, which a double does not resolve to `digits` decimal places, are displayed by exponential(value, 7).
QString number(double value, int digits);
/// Examples: "−2.5e37", "0", "1e−9". Without trailing zeros.
/// significant  maximum number of significant digits, at least 1
QString exponential(double value, int significant);
/// Like number(), with '+' before positive values.
QString signedNumber(double value, int digits);

/// Example: "−88.24°".
QString degrees(double radians, int digits = 2);
QString newtons(double value);       ///< e.g. "−9.8 N"
QString newtonMetres(double value);  ///< e.g. "0.12 Nm"
QString amperes(double value);       ///< e.g. "1.204 A"
/// Example: "35 %" for 0.35.
QString percent(double fraction);
/// Example: "60 °/s".
QString degreesPerSecond(double radiansPerSecond);

/// Example: "96 000" for 96000 (thin spaces between groups of three digits).
QString grouped(std::uint64_t value);
/// Hours, minutes and seconds, e.g. "00:03:12".
QString duration(double seconds);
/// Example: "80 GB".
QString bytes(std::int64_t value);

}  // namespace tiller::format
