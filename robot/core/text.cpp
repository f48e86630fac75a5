// SPDX-License-Identifier: MIT
#include "robot/core/text.h"

namespace tiller {

std::ostream& writeNumbers(std::ostream& out, std::span<const double> numbers) {
    out << '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out << (i == 0 ? "" : ", ") << numbers[i];
    }
    return out << ']';
}

}  // namespace tiller
