// SPDX-License-Identifier: MIT
#pragma once

// Numbers as the screen shows them: SI in, degrees out, a true minus sign, a fixed number of digits, and the
// unit behind. Lengths and speeds stand in notation.h: their unit is the operator's choice. Nothing here
// depends on the system's locale: a decimal point is a point everywhere.

#include <QString>
#include <cstdint>

namespace tiller::format {

/// "−12.40", "12.40"; never "−0.00". Not a number gives "–".
QString number(double value, int digits);
/// As number(), with '+' in front of what is above zero.
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

/// 96000 -> "96 000" (thin groups of three)
QString grouped(std::uint64_t value);
/// seconds -> "00:03:12"
QString duration(double seconds);
/// bytes -> "80 GB"
QString bytes(std::int64_t value);

}  // namespace tiller::format
