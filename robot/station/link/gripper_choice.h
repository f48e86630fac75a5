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
    /// Outputs by their bit numbers. On closes; with two outputs, the other one is off meanwhile.
    int closeOutput = io::kFirstTool;
    int openOutput = io::kFirstTool + 1;

    bool usesOutputs() const { return kind == Kind::OneOutput || kind == Kind::TwoOutputs; }
    /// Bit mask of its outputs.
    std::uint32_t outputs() const {
        return 1U << closeOutput | (kind == Kind::TwoOutputs ? 1U << openOutput : 0U);
    }
    /// Levels of the outputs for closing and opening.
    std::uint32_t outputsTo(bool close) const {
        return close ? 1U << closeOutput : kind == Kind::TwoOutputs ? 1U << openOutput : 0U;
    }
    /// "robotiq|2F-85", "outputs|16|17"; empty: none
    QString toText() const;
    /// Invalid text gives no gripper.
    static GripperChoice fromText(const QString& text);
    friend bool operator==(const GripperChoice&, const GripperChoice&) = default;
};

/// Capabilities of a Robotiq model. Source: the instruction manuals of the manufacturer.
struct RobotiqRange {
    const char* name;
    double stroke;      ///< between the fingers wide open [m]
    double leastForce;  ///< [N], at 0 %
    double mostForce;   ///< [N], at 100 %
    double leastSpeed;  ///< [m/s], at 0 %
    double mostSpeed;   ///< [m/s], at 100 %
};
const RobotiqRange& robotiqRange(GripperChoice::Model model);

}  // namespace tiller
