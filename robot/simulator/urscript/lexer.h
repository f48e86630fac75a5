// SPDX-License-Identifier: MIT
#pragma once

// Converts characters to tokens with positions. Newlines are not tokens; each token stores its line.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/urscript/program.h"

namespace tiller::simulator::urscript {

enum class TokenKind : std::uint8_t {
    End,  ///< end of the text
    Identifier,
    Integer,
    Float,
    String,
    Label,  ///< `$ 3 "name"`: integer = 3, text = name
    // punctuation
    LeftParen,
    RightParen,
    LeftBracket,
    RightBracket,
    Comma,
    Colon,
    Dot,
    Assign,
    Plus,
    Minus,
    Star,
    Slash,
    Percent,
    Equal,
    NotEqual,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    // keywords
    KwDef,
    KwSec,
    KwThread,
    KwEnd,
    KwIf,
    KwElif,
    KwElse,
    KwWhile,
    KwBreak,
    KwContinue,
    KwReturn,
    KwHalt,
    KwPause,
    KwRun,
    KwJoin,
    KwKill,
    KwEnterCritical,
    KwExitCritical,
    KwGlobal,
    KwLocal,
    KwAnd,
    KwOr,
    KwXor,
    KwNot,
    KwTrue,
    KwFalse,
    KwNone,
    KwStruct,
};

struct Token {
    TokenKind kind = TokenKind::End;
    int line = 1;
    int column = 1;
    std::int32_t integer = 0;
    double number = 0;
    std::string_view text;  ///< identifier or string content, inside the source
};

/// True for the first character of a name.
constexpr bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Returns the keyword with this spelling, or Identifier.
TokenKind keywordKind(std::string_view word);

struct LexOutcome {
    std::vector<Token> tokens;  ///< the last token is of kind End
    std::optional<CompileError> error;
};

/// `source` must outlive the tokens.
LexOutcome tokenize(std::string_view source);
bool isKeyword(std::string_view word);

/// Creates the error "syntax_error_on_line:<n>:<text of the line>:" for this position.
CompileError syntaxError(std::string_view source, int line, int column);

}  // namespace tiller::simulator::urscript
