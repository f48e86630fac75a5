// SPDX-License-Identifier: MIT
#pragma once

// Commands for inputs, outputs and registers of the robot, and the other clients that may use them.

#include <QString>
#include <cstdint>

#include "robot/io/outputs.h"

namespace tiller {

/// A general purpose input register, and a value that a robot program can read from it. Integers 24-34 and
/// doubles 24-41 are reserved for the control program and other channels of this interface.
struct RegisterValue {
    enum class Kind { Int, Double, Bit };
    Kind kind = Kind::Int;
    int number = 0;
    double value = 0;

    static constexpr int first(Kind kind) { return kind == Kind::Int ? 35 : kind == Kind::Double ? 42 : 64; }
    static constexpr int last(Kind kind) { return kind == Kind::Bit ? 127 : 47; }
};

/// Label of the controller terminal, e.g. "DI 0", "CO 3", "TO 1".
/// channel  0-7 standard, 8-15 configurable, 16-17 tool
QString ioTerminal(bool output, int channel);

/// Why outputs cannot be set, by group; empty if they can. Valid after connecting.
struct OutputHolders {
    QString standard;
    QString configurable;
    QString tool;
    QString analog;

    const QString& digital(int output) const {
        return output < io::kFirstConfigurable ? standard : output < io::kFirstTool ? configurable : tool;
    }
    friend bool operator==(const OutputHolders&, const OutputHolders&) = default;
};

}  // namespace tiller
