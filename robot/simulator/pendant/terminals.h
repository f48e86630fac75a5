// SPDX-License-Identifier: MIT
#pragma once

// The inputs, outputs and registers that a pendant program can use, and the script functions that read and
// set them.

#include <QString>
#include <optional>
#include <span>

namespace tiller::simulator::pendant {

enum class TerminalValue { Boolean, Integer, Float, Analog };

struct TerminalKind {
    const char* name;          ///< default name, unless the installation defines another: "digital_in[3]"
    const char* namesElement;  ///< element of the installation with the list of names
    const char* read;          ///< script function with the number as argument
    const char* write;         ///< script function with number and value as arguments; null for an input
    int count;
    TerminalValue value;
    const char* label;  ///< text in the program tree: "DI[3]"
};

/// All kinds.
std::span<const TerminalKind> terminalKinds();

struct Terminal {
    const TerminalKind* kind = nullptr;
    int number = 0;
};

/// Parses "digital_in[3]", in upper or lower case. Nothing when there is no such terminal.
std::optional<Terminal> terminalByDefaultName(const QString& name);

}  // namespace tiller::simulator::pendant
