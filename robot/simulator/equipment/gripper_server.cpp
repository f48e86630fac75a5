// SPDX-License-Identifier: MIT
#include "robot/simulator/equipment/gripper_server.h"

#include <algorithm>
#include <charconv>

namespace tiller::simulator {

namespace {

/// Removes the first word from the line and returns it.
std::string_view takeWord(std::string_view& line) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t begin = std::min(line.find_first_not_of(kBlank), line.size());
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBlank), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

std::optional<int> numberIn(std::string_view word) {
    int value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == word.data() + word.size() ? std::optional(value)
                                                                               : std::nullopt;
}

/// Number of digits that the manufacturer's script reads; 0 if the script uses complete lines only.
std::size_t digitsOf(std::string_view name) {
    constexpr std::string_view kOne[] = {"ACT", "GTO", "ATR", "ARD", "STA", "OBJ", "MOD"};
    constexpr std::string_view kThree[] = {"POS", "PRE", "SPE", "FOR", "COU", "MSC"};
    if (std::ranges::find(kOne, name) != std::end(kOne)) {
        return 1;
    }
    return name == "FLT" ? 2 : std::ranges::find(kThree, name) != std::end(kThree) ? 3 : 0;
}

}  // namespace

void GripperServer::step(double dt, bool powered) {
    powered_ = powered;
    if (powered) {
        gripper_.step(dt);
    } else {
        gripper_.set("ACT", 0);  // the gripper must be activated again
    }
}

LineServer::LineAnswer GripperServer::answer(std::string_view line, std::uint64_t) {
    const std::string_view verb = takeWord(line);
    if (verb == "GET") {
        const std::string name(takeWord(line));
        const std::optional<int> value = powered_ ? gripper_.get(name) : std::nullopt;
        return {name + ' ' + (value ? std::to_string(*value) : "?") + '\n'};
    }
    if (verb != "SET") {
        return {"nack"};
    }
    bool good = true;
    std::string_view name = takeWord(line);
    do {
        const std::optional<int> value = numberIn(takeWord(line));
        good = value && gripper_.set(name, *value) && good;
        name = takeWord(line);
    } while (!name.empty() && good);
    return {good ? "ack" : "nack"};
}

std::optional<LineServer::LineAnswer> GripperServer::answerUnfinished(std::string_view line) {
    constexpr std::size_t kAddresses = 17;
    if (takeWord(line) != "GET") {
        return std::nullopt;
    }
    const std::string_view name = takeWord(line);
    const std::optional<int> value = powered_ ? gripper_.get(name) : std::nullopt;
    std::string number = "?";
    if (value) {
        number = std::to_string(*value);
    }
    if (name == "SID") {
        std::string addresses = "[" + number + "]";
        addresses.resize(kAddresses, ' ');
        return LineAnswer{addresses};
    }
    const std::size_t digits = digitsOf(name);
    if (digits == 0) {
        return std::nullopt;
    }
    return LineAnswer{std::string(digits - std::min(digits, number.size()), '0') + number};
}

}  // namespace tiller::simulator
