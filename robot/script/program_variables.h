// SPDX-License-Identifier: MIT
#pragma once

// The global variables of the program on the robot, as the controller publishes them on the primary interface.

#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

namespace tiller::script {

struct ProgramVariable {
    enum class Type : std::uint8_t {
        None,  ///< no value yet, or a value that the controller does not publish, e.g. a struct
        Flag,
        Whole,
        Number,  ///< published in single precision
        Text,
        Pose,
        List,
        Matrix,
    };
    QString name;
    Type type = Type::None;
    QString text = {};  ///< the value as URScript, e.g. "p[0.1, 0, 0, 0, 0, 0]"; empty for None
    double number = 0;  ///< the value of a Number, Whole or Flag (0 or 1)

    friend bool operator==(const ProgramVariable&, const ProgramVariable&) = default;
};

/// The variables in the order of the controller. Null: no program has published variables. The list is
/// immutable.
using ProgramVariables = std::shared_ptr<const std::vector<ProgramVariable>>;

}  // namespace tiller::script
