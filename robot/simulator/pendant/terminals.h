// SPDX-License-Identifier: MIT
#pragma once

// The inputs, outputs and registers that a program of the pendant can name, and how a script reads and sets them.

#include <QString>
#include <optional>
#include <span>

namespace tiller::simulator::pendant {

enum class TerminalValue { Boolean, Integer, Float, Analog };

struct TerminalKind {
    const char* name;          ///< the pendant's, until the installation gives another: "digital_in[3]"
    const char* namesElement;  ///< of the installation: the list of names
    const char* read;          ///< script function; takes the number
    const char* write;         ///< script function; takes number and value; null for an input
    int count;
    TerminalValue value;
    const char* label;  ///< in the program tree: "DI[3]"
};

/// All kinds.
std::span<const TerminalKind> terminalKinds();

struct Terminal {
    const TerminalKind* kind = nullptr;
    int number = 0;
};

/// "digital_in[3]", in any case. Nothing when there is no such terminal.
std::optional<Terminal> terminalByDefaultName(const QString& name);

}  // namespace tiller::simulator::pendant
