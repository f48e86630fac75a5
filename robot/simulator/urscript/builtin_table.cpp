// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/builtin_table.h"

#include <algorithm>
#include <charconv>

#include "robot/core/ascii.h"

namespace tiller::simulator::urscript {

namespace {

// Parses the literal of a default: number, bool, string, or a list of numbers.
Value literal(std::string_view text) {
    if (text == "True" || text == "False") {
        return text == "True";
    }
    if (text.front() == '"') {
        return Value(std::string(text.substr(1, text.size() - 2)));
    }
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.find_first_of(".e") == std::string_view::npos) {
        return static_cast<std::int32_t>(number);
    }
    return number;
}

Builtin parseRow(const BuiltinRow& row) {
    const std::string_view text = row.signature;
    const std::size_t open = text.find('(');
    Builtin b;
    b.name = std::string(text.substr(0, open));
    b.signature = row.signature;
    b.function = row.function;
    b.flags = row.flags;
    b.since = row.since;
    b.needs = row.needs;
    b.partly = row.partly;
    std::string_view rest = text.substr(open + 1, text.rfind(')') - open - 1);
    while (!trimmed(rest).empty() && (row.flags & kAnyArguments) == 0) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        std::string_view item = trimmed(rest.substr(0, comma));
        rest = rest.substr(std::min(comma + 1, rest.size()));
        BuiltinParameter parameter;
        const std::size_t equals = item.find('=');
        if (equals != std::string_view::npos) {
            parameter.required = false;
            parameter.defaultText = std::string(trimmed(item.substr(equals + 1)));
            parameter.defaultValue = literal(parameter.defaultText);
            item = trimmed(item.substr(0, equals));
        } else if (item.back() == '?') {
            parameter.required = false;
            item.remove_suffix(1);
        }
        const std::size_t bar = std::min(item.find('|'), item.size());
        parameter.name = std::string(item.substr(0, bar));
        parameter.alias = std::string(item.substr(std::min(bar + 1, item.size())));
        b.parameters.push_back(std::move(parameter));
    }
    return b;
}

std::vector<Builtin> allRows() {
    std::vector<Builtin> out;
    for (const auto table :
         {motionBuiltins(), forceBuiltins(), superpositionBuiltins(), stateBuiltins(), kinematicsBuiltins(),
          setupBuiltins(), programBuiltins(), stringBuiltins(), mathBuiltins(), listBuiltins(),
          poseBuiltins(), socketBuiltins(), registerBuiltins(), ioBuiltins(), worldBuiltins(),
          interpreterBuiltins(), rpcBuiltins(), modbusBuiltins(), absentBuiltins()}) {
        for (const BuiltinRow& row : table) {
            out.push_back(parseRow(row));
        }
    }
    std::sort(out.begin(), out.end(), [](const Builtin& a, const Builtin& b) { return a.name < b.name; });
    return out;
}

}  // namespace

int FirstVersions::ofSeries3() const {
    if (minor3 != kInStep || minor5 == 0) {
        return std::max(minor3, 0);
    }
    // 5.0 was released with 3.6, and 5.6 with 3.12. After that, series 3 skipped one release.
    constexpr int kLast = 10;
    return minor5 > kLast ? kNever : minor5 + (minor5 <= 6 ? 6 : 5);
}

bool FirstVersions::isIn(const SoftwareVersion& version) const {
    const int first = version.major >= 10 ? minor10 : version.major >= 5 ? minor5 : ofSeries3();
    return static_cast<int>(version.minor) >= first;
}

const std::vector<Builtin>& builtins() {
    static const std::vector<Builtin> rows = allRows();
    return rows;
}

int findBuiltin(std::string_view name) {
    const auto& rows = builtins();
    const auto it = std::lower_bound(rows.begin(), rows.end(), name,
                                     [](const Builtin& b, std::string_view n) { return b.name < n; });
    return it != rows.end() && it->name == name ? static_cast<int>(it - rows.begin()) : -1;
}

}  // namespace tiller::simulator::urscript
