// SPDX-License-Identifier: MIT
#pragma once

// The inputs, outputs and registers that a pendant program can use, and the script functions to read and set
// them.

#include <QString>
#include <optional>
#include <span>

namespace tiller::simulator::pendant {

enum class TerminalValue { Boolean, Integer, Float, Analog };

struct TerminalKind {
    const char* name;          ///< default name without the index, e.g. "digital_in"
    const char* namesElement;  ///< element of the installation that contains the list of names
    const char* read;          ///< script function with the argument `number`
    const char* write;         ///< script function with the arguments `number` and `value`; null: input
    int count;
    TerminalValue value;
    const char* label;  ///< text in the program tree, e.g. "DI[3]"
};

/// All types of terminals.
std::span<const TerminalKind> terminalKinds();

struct Terminal {
    const TerminalKind* kind = nullptr;
    int number = 0;
};

/// Parses a name such as "digital_in[3]", in upper or lower case. Empty if the terminal does not exist.
std::optional<Terminal> terminalByDefaultName(const QString& name);

}  // namespace tiller::simulator::pendant
