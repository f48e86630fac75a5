// SPDX-License-Identifier: MIT
#pragma once

// Commands for inputs, outputs and registers of the robot, and the other clients that may occupy them.

#include <QString>
#include <cstdint>

#include "robot/io/outputs.h"

namespace tiller {

/// A general purpose input register and the value that a program on the robot is to read from it. The control
/// program and this interface's own channels reserve integers 24-33 and numbers 24-41.
struct RegisterValue {
    enum class Kind { Int, Double, Bit };
    Kind kind = Kind::Int;
    int number = 0;
    double value = 0;

    static constexpr int first(Kind kind) { return kind == Kind::Int ? 34 : kind == Kind::Double ? 42 : 64; }
    static constexpr int last(Kind kind) { return kind == Kind::Bit ? 127 : 47; }
};

/// "DI 0", "CO 3", "TO 1": the labels printed next to the controller's terminals.
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
