// SPDX-License-Identifier: MIT
#pragma once

// Splits the text received on a script port into units that can be run: a `def ... end` or `sec ... end`, a
// line of bare statements, or a command ("stop program", "power on"). Works with any segmentation of the
// stream. A unit is returned when its last line is complete. If an `end` is missing in a program with
// indented lines, the next `def` or `sec` in the first column ends this program, so that the following
// program is not lost.

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
            Statements,  ///< bare statements: one line, or several if brackets or blocks span lines
            Command,     ///< command that is not URScript, trimmed, e.g. "set unlock protective stop"
        };
        Kind kind = Kind::Statements;
        std::string text;  ///< as received, with newlines; compile() counts lines in this text
    };

    /// Maximum size of an unfinished unit [bytes]. A larger unit is returned incomplete, and the compiler
    /// refuses it.
    static constexpr std::size_t kMaxUnit = 16u << 20;

    void feed(std::string_view bytes);
    /// Returns the next complete unit; empty if no unit is complete.
    std::optional<Unit> next();
    /// Number of buffered bytes of incomplete units.
    std::size_t pending() const { return unit_.size() + line_.size(); }
    void clear();

private:
    void takeLine();
    void finish();
    void emitCommand(std::string_view words);
    void followIndentation(bool firstColumn, int blocks, bool beginsWithEnd);

    std::string line_;                   // incomplete line
    std::string unit_;                   // complete lines of an unfinished unit
    int blocks_ = 0;                     // number of open blocks: def, if, while ...
    int brackets_ = 0;                   // number of open ( and [
    bool begun_ = false;                 // unit_ contains more than comments
    std::optional<bool> indented_;       // whether the first line in the outermost block is indented
    std::vector<bool> openersIndented_;  // for each open block: true if its first line is indented
    bool misplacedEnd_ = false;          // an `end` in the first column has closed an indented block
    Unit::Kind kind_ = Unit::Kind::Statements;
    std::deque<Unit> ready_;
};

}  // namespace tiller::simulator::urscript
