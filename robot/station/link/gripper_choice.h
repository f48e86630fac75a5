// SPDX-License-Identifier: MIT
#pragma once

// The gripper of a robot as chosen by the operator.

#include <QString>
#include <cstdint>

#include "robot/io/outputs.h"

namespace tiller {

struct GripperChoice {
    enum class Kind { None, Robotiq, OneOutput, TwoOutputs };
    enum class Model { TwoF85, TwoF140, HandE };

    Kind kind = Kind::None;
    Model model = Model::TwoF85;
    /// Bit numbers of the outputs. Output `closeOutput` closes the gripper when it is on. With two outputs,
    /// `openOutput` is then switched off, and vice versa.
    int closeOutput = io::kFirstTool;
    int openOutput = io::kFirstTool + 1;

    bool usesOutputs() const { return kind == Kind::OneOutput || kind == Kind::TwoOutputs; }
    /// Bit mask of the outputs used.
    std::uint32_t outputs() const {
        return 1U << closeOutput | (kind == Kind::TwoOutputs ? 1U << openOutput : 0U);
    }
    /// Levels of the outputs that close or open the gripper.
    std::uint32_t outputsTo(bool close) const {
        return close ? 1U << closeOutput : kind == Kind::TwoOutputs ? 1U << openOutput : 0U;
    }
    /// Text for the settings, e.g. "robotiq|2F-85", "outputs|16|17"; empty without a gripper.
    QString toText() const;
    /// Returns a choice without a gripper if the text is invalid.
    static GripperChoice fromText(const QString& text);
    friend bool operator==(const GripperChoice&, const GripperChoice&) = default;
};

/// Capabilities of a Robotiq model. Source: the instruction manuals of the manufacturer.
struct RobotiqRange {
    const char* name;
    double stroke;      ///< distance between the open fingers [m]
    double leastForce;  ///< force at 0 % [N]
    double mostForce;   ///< force at 100 % [N]
    double leastSpeed;  ///< speed at 0 % [m/s]
    double mostSpeed;   ///< speed at 100 % [m/s]
};
const RobotiqRange& robotiqRange(GripperChoice::Model model);

}  // namespace tiller
