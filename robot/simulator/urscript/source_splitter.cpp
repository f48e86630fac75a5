// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/source_splitter.h"

#include <algorithm>
#include <array>

#include "robot/core/ascii.h"
#include "robot/simulator/urscript/lexer.h"

namespace tiller::simulator::urscript {

namespace {

// Commands that end an unfinished unit, which the sender has abandoned.
constexpr std::array<std::string_view, 6> kUrgent{"stop program",  "power on",   "power off",
                                                  "set robotmode", "set unlock", "pause program"};

bool isWordCharacter(char c) {
    return isLetter(c) || (c >= '0' && c <= '9');
}

// The words and brackets of one line, without comments and strings.
struct LineShape {
    std::string_view text;  // trimmed, without the comment
    TokenKind firstWord = TokenKind::End;
    bool command = false;  // e.g. "set speed 0.8": a word followed by another word or the end of the line
    int blocks = 0;
    int brackets = 0;
};

LineShape shapeOf(std::string_view line) {
    LineShape shape;
    std::size_t end = line.size();
    bool member = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '#') {
            end = i;
            break;
        }
        if (c == '"') {
            i = std::min(line.find('"', i + 1), line.size() - 1);
        } else if (c == '(' || c == '[') {
            ++shape.brackets;
        } else if (c == ')' || c == ']') {
            --shape.brackets;
        } else if (isLetter(c)) {
            std::size_t last = i;
            while (last < line.size() && isWordCharacter(line[last])) {
                ++last;
            }
            switch (member ? TokenKind::Identifier : keywordKind(line.substr(i, last - i))) {
                case TokenKind::KwDef:
                case TokenKind::KwSec:
                case TokenKind::KwThread:
                case TokenKind::KwIf:
                case TokenKind::KwWhile:
                    ++shape.blocks;
                    break;
                case TokenKind::KwEnd:
                    --shape.blocks;
                    break;
                default:
                    break;
            }
            i = last - 1;
        } else if (c >= '0' && c <= '9') {
            while (i + 1 < line.size() && isWordCharacter(line[i + 1])) {
                ++i;
            }
        }
        member = c == '.';
    }
    shape.text = trimmed(line.substr(0, end));
    if (!shape.text.empty() && isLetter(shape.text[0])) {
        const auto wordEnd = std::find_if_not(shape.text.begin(), shape.text.end(), isWordCharacter);
        const std::size_t length = static_cast<std::size_t>(wordEnd - shape.text.begin());
        shape.firstWord = keywordKind(shape.text.substr(0, length));
        const std::string_view rest = trimmed(shape.text.substr(length));
        // "pause program" and "run program" begin with keywords of the language.
        shape.command = rest == "program" ||
                        (shape.firstWord == TokenKind::Identifier && (rest.empty() || isLetter(rest[0])));
    }
    return shape;
}

bool isUrgent(std::string_view text) {
    return std::any_of(kUrgent.begin(), kUrgent.end(),
                       [&](std::string_view words) { return text.substr(0, words.size()) == words; });
}

}  // namespace

void SourceSplitter::feed(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t newline = bytes.find('\n');
        if (newline == std::string_view::npos) {
            line_ += bytes;
            bytes = {};
        } else {
            line_ += bytes.substr(0, newline + 1);
            bytes.remove_prefix(newline + 1);
            takeLine();
        }
        if (pending() > kMaxUnit) {
            unit_ += line_;
            line_.clear();
            finish();
        }
    }
}

void SourceSplitter::takeLine() {
    std::erase(line_, '\0');  // clients written in C may send the terminating null character
    const LineShape shape = shapeOf(line_);
    const bool blank = shape.text.empty();
    const bool firstColumn = !blank && line_.front() != ' ' && line_.front() != '\t';
    if (!begun_) {
        if (blank) {
            // Comments before a unit are part of it, so that line numbers match the sender's text.
            if (!unit_.empty() || !trimmed(line_).empty()) {
                unit_ += line_;
            }
            line_.clear();
            return;
        }
        if (shape.command) {
            emitCommand(shape.text);
            return;
        }
        begun_ = true;
        kind_ = shape.firstWord == TokenKind::KwDef   ? Unit::Kind::Program
                : shape.firstWord == TokenKind::KwSec ? Unit::Kind::Secondary
                                                      : Unit::Kind::Statements;
    } else if (isUrgent(shape.text)) {
        finish();
        emitCommand(shape.text);
        return;
    } else if ((shape.firstWord == TokenKind::KwDef || shape.firstWord == TokenKind::KwSec) &&
               (blocks_ == 0 || (firstColumn && (indented_.value_or(false) || misplacedEnd_)))) {
        // An open bracket in a bare statement or a missing `end` must not absorb the next program.
        const std::string line = std::move(line_);
        line_.clear();
        finish();
        line_ = line;
        takeLine();
        return;
    }
    unit_ += line_;
    line_.clear();
    if (!blank) {
        followIndentation(firstColumn, shape.blocks, shape.firstWord == TokenKind::KwEnd);
    }
    blocks_ += shape.blocks;
    brackets_ += shape.brackets;
    if (blocks_ <= 0 && (brackets_ <= 0 || kind_ != Unit::Kind::Statements)) {
        finish();
    }
}

void SourceSplitter::followIndentation(bool firstColumn, int blocks, bool beginsWithEnd) {
    if (blocks_ == 1 && !indented_) {
        indented_ = !firstColumn;
    }
    for (; blocks > 0; --blocks) {
        openersIndented_.push_back(!firstColumn);
    }
    for (; blocks < 0 && !openersIndented_.empty(); ++blocks) {
        misplacedEnd_ = misplacedEnd_ || (beginsWithEnd && firstColumn && openersIndented_.back());
        openersIndented_.pop_back();
    }
}

void SourceSplitter::emitCommand(std::string_view words) {
    ready_.push_back({Unit::Kind::Command, std::string(words)});
    line_.clear();
    unit_.clear();
}

void SourceSplitter::finish() {
    if (!trimmed(unit_).empty()) {
        ready_.push_back({kind_, std::move(unit_)});
    }
    unit_.clear();
    blocks_ = 0;
    brackets_ = 0;
    begun_ = false;
    indented_.reset();
    openersIndented_.clear();
    misplacedEnd_ = false;
    kind_ = Unit::Kind::Statements;
}

std::optional<SourceSplitter::Unit> SourceSplitter::next() {
    if (ready_.empty()) {
        return std::nullopt;
    }
    Unit unit = std::move(ready_.front());
    ready_.pop_front();
    return unit;
}

void SourceSplitter::clear() {
    ready_.clear();
    line_.clear();
    unit_.clear();
    finish();
}

}  // namespace tiller::simulator::urscript
