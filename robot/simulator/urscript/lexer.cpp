// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace tiller::simulator::urscript {

namespace {

constexpr std::array<std::pair<std::string_view, TokenKind>, 28> kKeywords{{
    {"def", TokenKind::KwDef},
    {"sec", TokenKind::KwSec},
    {"thread", TokenKind::KwThread},
    {"end", TokenKind::KwEnd},
    {"if", TokenKind::KwIf},
    {"elif", TokenKind::KwElif},
    {"else", TokenKind::KwElse},
    {"while", TokenKind::KwWhile},
    {"break", TokenKind::KwBreak},
    {"continue", TokenKind::KwContinue},
    {"return", TokenKind::KwReturn},
    {"halt", TokenKind::KwHalt},
    {"pause", TokenKind::KwPause},
    {"run", TokenKind::KwRun},
    {"join", TokenKind::KwJoin},
    {"kill", TokenKind::KwKill},
    {"enter_critical", TokenKind::KwEnterCritical},
    {"exit_critical", TokenKind::KwExitCritical},
    {"global", TokenKind::KwGlobal},
    {"local", TokenKind::KwLocal},
    {"and", TokenKind::KwAnd},
    {"or", TokenKind::KwOr},
    {"xor", TokenKind::KwXor},
    {"not", TokenKind::KwNot},
    {"True", TokenKind::KwTrue},
    {"False", TokenKind::KwFalse},
    {"None", TokenKind::KwNone},
    {"struct", TokenKind::KwStruct},
}};

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

class Lexer {
public:
    explicit Lexer(std::string_view source) : source_(source) {}

    LexOutcome run() {
        LexOutcome out;
        out.tokens.reserve(source_.size() / 5 + 1);
        while (true) {
            skipBlanksAndComments();
            Token token;
            token.line = line_;
            token.column = column();
            if (at_ == source_.size()) {
                out.tokens.push_back(token);
                return out;
            }
            if (!read(token)) {
                out.error = syntaxError(source_, token.line, token.column);
                return out;
            }
            out.tokens.push_back(token);
        }
    }

private:
    int column() const { return static_cast<int>(at_ - lineStart_) + 1; }
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
    }

    void skipBlanksAndComments() {
        while (at_ < source_.size()) {
            const char c = source_[at_];
            if (c == '\n') {
                ++at_;
                ++line_;
                lineStart_ = at_;
            } else if (c == ' ' || c == '\t' || c == '\r') {
                ++at_;
            } else if (c == '#') {
                while (at_ < source_.size() && source_[at_] != '\n') {
                    ++at_;
                }
            } else {
                return;
            }
        }
    }

    bool read(Token& token) {
        const char c = peek();
        if (isLetter(c)) {
            const std::size_t start = at_;
            while (isLetter(peek()) || isDigit(peek())) {
                ++at_;
            }
            token.text = source_.substr(start, at_ - start);
            token.kind = keywordKind(token.text);
            return true;
        }
        if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
            return readNumber(token);
        }
        if (c == '"') {
            return readString(token);
        }
        if (c == '$') {
            return readLabel(token);
        }
        return readPunctuation(token, c);
    }

    bool readNumber(Token& token) {
        const std::size_t start = at_;
        bool isFloat = false;
        const auto digits = [this] {
            while (isDigit(peek())) {
                ++at_;
            }
        };
        if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X')) {
            return readHexadecimal(token);
        }
        digits();
        if (peek() == '.') {
            isFloat = true;
            ++at_;
            digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            const std::size_t sign = (peek(1) == '+' || peek(1) == '-') ? 2 : 1;
            if (isDigit(peek(sign))) {
                isFloat = true;
                at_ += sign;
                digits();
            }
        }
        token.text = source_.substr(start, at_ - start);
        const char* first = token.text.data();
        const char* last = first + token.text.size();
        const auto result = std::from_chars(first, last, token.number);
        if (result.ec == std::errc::result_out_of_range) {
            return false;
        }
        // An integer beyond 32 bits becomes a float. 2147483648 must be accepted, because its negative is an
        // int.
        if (!isFloat && token.number <= std::numeric_limits<std::int32_t>::max()) {
            token.kind = TokenKind::Integer;
            token.integer = static_cast<std::int32_t>(token.number);
        } else {
            token.kind = TokenKind::Float;
        }
        // "12abc" is refused.
        return result.ptr == last && !isLetter(peek());
    }

    // Reads up to 32 bits, like to_num("0x...").
    bool readHexadecimal(Token& token) {
        const std::size_t start = at_;
        at_ += 2;
        while (isDigit(peek()) || isLetter(peek())) {
            ++at_;
        }
        token.text = source_.substr(start, at_ - start);
        std::uint32_t bits = 0;
        const char* last = token.text.data() + token.text.size();
        const auto result = std::from_chars(token.text.data() + 2, last, bits, 16);
        token.kind = TokenKind::Integer;
        token.integer = static_cast<std::int32_t>(bits);
        return token.text.size() > 2 && result.ec == std::errc() && result.ptr == last;
    }

    bool readString(Token& token) {
        const std::size_t start = ++at_;
        while (at_ < source_.size() && source_[at_] != '"' && source_[at_] != '\n') {
            ++at_;
        }
        if (peek() != '"') {
            return false;
        }
        token.kind = TokenKind::String;
        token.text = source_.substr(start, at_ - start);
        ++at_;
        return true;
    }

    // $ 3 "Robot Program": label for the next node of the program tree.
    bool readLabel(Token& token) {
        ++at_;
        const auto blanks = [this] {
            while (peek() == ' ' || peek() == '\t') {
                ++at_;
            }
        };
        blanks();
        const std::size_t start = at_;
        while (isDigit(peek())) {
            ++at_;
        }
        const std::string_view digits = source_.substr(start, at_ - start);
        std::int32_t number = 0;
        if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ec != std::errc()) {
            return false;
        }
        blanks();
        if (peek() == '"') {
            if (!readString(token)) {
                return false;
            }
        }
        token.kind = TokenKind::Label;
        token.integer = number;
        // Newer editors append further fields, which are ignored.
        while (at_ < source_.size() && source_[at_] != '\n') {
            ++at_;
        }
        return true;
    }

    bool readPunctuation(Token& token, char c) {
        const bool equals = peek(1) == '=';
        std::size_t length = 1;
        switch (c) {
            case '(':
                token.kind = TokenKind::LeftParen;
                break;
            case ')':
                token.kind = TokenKind::RightParen;
                break;
            case '[':
                token.kind = TokenKind::LeftBracket;
                break;
            case ']':
                token.kind = TokenKind::RightBracket;
                break;
            case ',':
                token.kind = TokenKind::Comma;
                break;
            case ':':
                token.kind = TokenKind::Colon;
                break;
            case '.':
                token.kind = TokenKind::Dot;
                break;
            case '+':
                token.kind = TokenKind::Plus;
                break;
            case '-':
                token.kind = TokenKind::Minus;
                break;
            case '*':
                token.kind = TokenKind::Star;
                break;
            case '/':
                token.kind = TokenKind::Slash;
                break;
            case '%':
                token.kind = TokenKind::Percent;
                break;
            case '=':
                token.kind = equals ? TokenKind::Equal : TokenKind::Assign;
                length = equals ? 2 : 1;
                break;
            case '!':
                token.kind = equals ? TokenKind::NotEqual : TokenKind::KwNot;
                length = equals ? 2 : 1;
                break;
            case '<':
                token.kind = equals ? TokenKind::LessEqual : TokenKind::Less;
                length = equals ? 2 : 1;
                break;
            case '>':
                token.kind = equals ? TokenKind::GreaterEqual : TokenKind::Greater;
                length = equals ? 2 : 1;
                break;
            default:
                return false;
        }
        at_ += length;
        return length > 0;
    }

    std::string_view source_;
    std::size_t at_ = 0;
    std::size_t lineStart_ = 0;
    int line_ = 1;
};

}  // namespace

TokenKind keywordKind(std::string_view word) {
    for (const auto& [spelling, kind] : kKeywords) {
        if (spelling == word) {
            return kind;
        }
    }
    return TokenKind::Identifier;
}

LexOutcome tokenize(std::string_view source) {
    return Lexer(source).run();
}

CompileError syntaxError(std::string_view source, int line, int column) {
    std::size_t start = 0;
    for (int n = 1; n < line && start < source.size(); ++n) {
        const std::size_t newline = source.find('\n', start);
        start = newline == std::string_view::npos ? source.size() : newline + 1;
    }
    std::string_view text = source.substr(start, source.find('\n', start) - start);
    if (!text.empty() && text.back() == '\r') {
        text.remove_suffix(1);
    }
    // Limit the length of the message, because corrupted input may consist of a single line.
    text = text.substr(0, 200);
    return {line, column, "syntax_error_on_line:" + std::to_string(line) + ":" + std::string(text) + ":"};
}

bool isKeyword(std::string_view word) {
    return std::any_of(kKeywords.begin(), kKeywords.end(),
                       [word](const auto& keyword) { return keyword.first == word; });
}

}  // namespace tiller::simulator::urscript
