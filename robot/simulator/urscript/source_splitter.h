// SPDX-License-Identifier: MIT
#pragma once

// Cuts the text arriving on a script port into units that can be run: a `def ... end` or `sec ... end`, a
// line of bare statements, a command word ("stop program", "power on"). Works on any segmentation of the
// stream; a unit is given out only when its last line is complete.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

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
        std::string text;  ///< as received, with its newlines; what compile() counts lines in
    };

    /// Bytes of an unfinished unit kept at most; more is given out as it is, for the compiler to reject.
    static constexpr std::size_t kMaxUnit = 16u << 20;

    void feed(std::string_view bytes);
    /// The next complete unit, or nothing yet.
    std::optional<Unit> next();
    /// Bytes waiting for the rest of their unit.
    std::size_t pending() const { return text_.size() - done_; }
    void clear();

private:
    void scanLine(std::string_view line);
    void finish(Unit::Kind kind);

    std::string text_;         // bytes not given out yet
    std::size_t done_ = 0;     // given out, not yet erased
    std::size_t scanned_ = 0;  // end of the last complete line looked at
    int depth_ = 0;            // open blocks
    int brackets_ = 0;
    bool inUnit_ = false;
    bool blockStarts_ = false;
    Unit::Kind kind_ = Unit::Kind::Statements;
    std::deque<Unit> ready_;
};

}  // namespace tiller::simulator::urscript
