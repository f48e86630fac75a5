// SPDX-License-Identifier: MIT
#include "robot/station/link/gripper_choice.h"

#include <QStringList>
#include <array>
#include <optional>

namespace tiller {
namespace {

constexpr std::array<RobotiqRange, 3> kModels = {{{"2F-85", 0.085, 20, 235, 0.020, 0.150},
                                                  {"2F-140", 0.140, 10, 125, 0.030, 0.250},
                                                  {"Hand-E", 0.050, 20, 185, 0.020, 0.150}}};

std::optional<int> outputIn(const QString& text) {
    bool isNumber = false;
    const int output = text.toInt(&isNumber);
    return isNumber && output >= 0 && output < io::kDigitalOutputs ? std::optional(output) : std::nullopt;
}

}  // namespace

const RobotiqRange& robotiqRange(GripperChoice::Model model) {
    return kModels[static_cast<std::size_t>(model)];
}

QString GripperChoice::toText() const {
    switch (kind) {
        case Kind::None:
            return {};
        case Kind::Robotiq:
            return QStringLiteral("robotiq|") + QLatin1String(robotiqRange(model).name);
        case Kind::OneOutput:
            return QStringLiteral("output|%1").arg(closeOutput);
        case Kind::TwoOutputs:
            return QStringLiteral("outputs|%1|%2").arg(closeOutput).arg(openOutput);
    }
    return {};
}

GripperChoice GripperChoice::fromText(const QString& text) {
    const QStringList parts = text.split(QLatin1Char('|'));
    const std::optional<int> close = outputIn(parts.value(1));
    const std::optional<int> open = outputIn(parts.value(2));
    GripperChoice choice;
    if (parts[0] == QLatin1String("robotiq")) {
        for (std::size_t i = 0; i < kModels.size(); ++i) {
            if (parts.value(1) == QLatin1String(kModels[i].name)) {
                choice.kind = Kind::Robotiq;
                choice.model = static_cast<Model>(i);
            }
        }
    } else if (parts[0] == QLatin1String("output") && close) {
        choice.kind = Kind::OneOutput;
        choice.closeOutput = *close;
    } else if (parts[0] == QLatin1String("outputs") && close && open && *close != *open) {
        choice.kind = Kind::TwoOutputs;
        choice.closeOutput = *close;
        choice.openOutput = *open;
    }
    return choice;
}

}  // namespace tiller
