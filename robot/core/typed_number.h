// SPDX-License-Identifier: MIT
#pragma once

// Reads numbers entered by the operator. Point, comma and the separator of the window language are decimal
// separators, and hyphen and minus sign are equivalent. Digits are not grouped.

#include <QString>
#include <optional>

namespace tiller {

/// The text with a hyphen as minus sign and a decimal point. Spaces are kept, because a suffix may begin with
/// a space.
/// Threads  any
QString plainNumber(QString typed);
/// Empty if the text is not a number.
/// Threads  any
std::optional<double> typedNumber(const QString& typed);

}  // namespace tiller
