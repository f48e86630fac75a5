// SPDX-License-Identifier: MIT
#pragma once

// Permitted commands for inputs, outputs and registers of the robot, and their other owners.

#include <QString>
#include <cstdint>

#include "robot/io/outputs.h"

namespace tiller {

/// A general purpose input register and what a program on the robot shall read from it. The control program
/// and this interface's own channels keep integers 24-33 and numbers 24-41.
struct RegisterValue {
    enum class Kind { Int, Double, Bit };
    Kind kind = Kind::Int;
    int number = 0;
    double value = 0;

    static constexpr int first(Kind kind) { return kind == Kind::Int ? 34 : kind == Kind::Double ? 42 : 64; }
    static constexpr int last(Kind kind) { return kind == Kind::Bit ? 127 : 47; }
};

/// "DI 0", "CO 3", "TO 1": the letters printed beside the controller's terminals.
/// channel  0-7 standard, 8-15 configurable, 16-17 tool
QString ioTerminal(bool output, int channel);

/// The reason why outputs cannot be set, by group; empty if they can. Known after connecting.
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
