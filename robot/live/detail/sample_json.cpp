// SPDX-License-Identifier: MIT
#include "robot/live/detail/sample_json.h"

#include <charconv>
#include <cmath>

namespace tiller::live {

namespace {

void appendNumber(std::string& out, double value) {
    if (!std::isfinite(value)) {
        out += "null";
        return;
    }
    char text[32];
    out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace

void writeJson(const receive::Sample& sample, const std::vector<std::string>& fields, std::string& out) {
    out = "{";
    for (const std::string& name : fields) {
        const auto values = sample.field(name);
        if (values.empty()) {
            continue;
        }
        out += out.size() > 1 ? ",\"" : "\"";
        out += name;
        out += "\":";
        if (values.size() == 1) {
            appendNumber(out, values.front());
            continue;
        }
        out += '[';
        for (const double value : values) {
            appendNumber(out, value);
            out += ',';
        }
        out.back() = ']';
    }
    out += '}';
}

}  // namespace tiller::live
