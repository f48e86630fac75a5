// SPDX-License-Identifier: MIT
// Passes arbitrary bytes with arbitrary segmentation to the parser of the primary interface. The bytes must
// be parsed or refused, without a crash and with limited memory.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/script/detail/primary_parser.h"

using namespace tiller::script;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    // The first byte selects the segmentation.
    const std::size_t step = 1 + data[0];
    std::span<const std::uint8_t> rest(data + 1, size - 1);
    PrimaryParser parser;
    std::size_t messages = 0;
    while (!rest.empty()) {
        const auto piece = rest.first(std::min(step, rest.size()));
        rest = rest.subspan(piece.size());
        if (!parser.feed(piece, 0)) {
            parser.reset();
        }
        for (const ControllerMessage& message : parser.takeMessages()) {
            messages += message.text.size() >= 0 && message.codeName().size() >= 0 ? 1U : 0U;
        }
    }
    // A message has at least a header.
    if (messages > size) {
        __builtin_trap();
    }
    return 0;
}
