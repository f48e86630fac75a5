// SPDX-License-Identifier: MIT
// Parses arbitrary bytes as a stream of HTTP requests that is received in two pieces, and as an uploaded
// form. The parsers must not crash or buffer more data than their limits.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "robot/simulator/net/http_message.h"

using namespace tiller::simulator;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    HttpParser parser;
    const auto take = [&parser] {
        while (const auto request = parser.next()) {
            if (request->path.empty() || request->path.front() != '/' ||
                request->body.size() > HttpParser::kLargestBody) {
                std::abort();
            }
            fileOfForm(request->header("content-type"), request->body, "file");
        }
        parser.takeContinue();
    };
    parser.feed(text.substr(0, size / 2));
    take();
    parser.feed(text.substr(size / 2));
    take();
    if (parser.fault() != 0 && parser.next()) {
        std::abort();  // nothing may be parsed after a fault
    }
    percentDecoded(text);
    fileOfForm("multipart/form-data; boundary=x", text, "file");
    return 0;
}
