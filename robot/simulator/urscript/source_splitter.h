// SPDX-License-Identifier: MIT
#pragma once

// Splits the text received on a script port into units that can be run: a `def ... end` or `sec ... end`, a
// line of bare statements, a command ("stop program", "power on"). Works with any segmentation of the stream;
// a unit is returned only when its last line is complete. A `def` or `sec` in the first column ends a program
// with indented lines in which an `end` is missing, so that the next program is not lost.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tiller::simulator::urscript {

class SourceSplitter {
public:
    struct Unit {
        enum class Kind {
            Program,     ///< def ... end
            Secondary,   ///< sec ... end
            Statements,  ///< bare statements: one line, or several when brackets or blocks span lines
            Command,     ///< words that are not URScript, trimmed: "set unlock protective stop"
        };
        Kind kind = Kind::Statements;
        std::string text;  ///< as received, with newlines; lines of compile() refer to it
    };

    /// Maximum size of an unfinished unit [bytes]; a longer one is returned as it is, so that the compiler
    /// rejects it.
    static constexpr std::size_t kMaxUnit = 16u << 20;

    void feed(std::string_view bytes);
    /// The next complete unit; nothing if none is complete.
    std::optional<Unit> next();
    /// Bytes waiting for the rest of their unit.
    std::size_t pending() const { return unit_.size() + line_.size(); }
    void clear();

private:
    void takeLine();
    void finish();
    void emitCommand(std::string_view words);
    void followIndentation(bool firstColumn, int blocks, bool beginsWithEnd);

    std::string line_;                   // begun, not ended
    std::string unit_;                   // complete lines of an unfinished unit
    int blocks_ = 0;                     // open def, if, while...
    int brackets_ = 0;                   // open ( and [
    bool begun_ = false;                 // unit_ holds more than comments
    std::optional<bool> indented_;       // the first line inside the outermost block
    std::vector<bool> openersIndented_;  // of each open block
    bool misplacedEnd_ = false;          // an `end` in the first column closed an indented block
    Unit::Kind kind_ = Unit::Kind::Statements;
    std::deque<Unit> ready_;
};

}  // namespace tiller::simulator::urscript
