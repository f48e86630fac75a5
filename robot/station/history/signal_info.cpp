// SPDX-License-Identifier: MIT
#include "robot/station/history/signal_info.h"

#include <QCoreApplication>
#include <QSet>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/mode_words.h"

namespace tiller {

namespace {

using receive::FieldInfo;
using receive::FieldKind;
using receive::FieldModes;

/// Translation context of this file for lupdate.
struct SignalText {
    Q_DECLARE_TR_FUNCTIONS(SignalInfo)
};

enum class Axes { None, Cartesian, Joints };

/// Components of a field that are displayed together.
struct Family {
    const char* field;
    int first;
    int count;
    const char* group;
    const char* title;
    const char* symbol;
    Axes axes;
};

constexpr const char* kTcp = QT_TRANSLATE_NOOP("SignalInfo", "TCP");
constexpr const char* kJoints = QT_TRANSLATE_NOOP("SignalInfo", "Joints");
constexpr const char* kIo = QT_TRANSLATE_NOOP("SignalInfo", "Inputs and outputs");
constexpr const char* kModes = QT_TRANSLATE_NOOP("SignalInfo", "Modes and states");
constexpr const char* kPower = QT_TRANSLATE_NOOP("SignalInfo", "Power and temperature");
constexpr const char* kProgram = QT_TRANSLATE_NOOP("SignalInfo", "Speed and program");
constexpr const char* kPayload = QT_TRANSLATE_NOOP("SignalInfo", "Payload and tool");
constexpr const char* kMore = QT_TRANSLATE_NOOP("SignalInfo", "Other");
constexpr const char* kRegisters = QT_TRANSLATE_NOOP("SignalInfo", "Registers");
constexpr std::array kGroups = {kTcp, kJoints, kIo, kModes, kPower, kProgram, kPayload, kMore, kRegisters};

// The families in display order. Other signals are listed under "Other" with their RTDE names.
constexpr Family kFamilies[] = {
    {"actual_TCP_force", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP force"), "F", Axes::Cartesian},
    {"actual_TCP_force", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP torque"), "T", Axes::Cartesian},
    {"actual_TCP_pose", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP position"), "p", Axes::Cartesian},
    {"actual_TCP_pose", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP rotation vector"), "r",
     Axes::Cartesian},
    {"actual_TCP_speed", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP speed"), "v", Axes::Cartesian},
    {"actual_TCP_speed", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP angular speed"), "ω",
     Axes::Cartesian},
    {"actual_TCP_acceleration", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP acceleration"), "a",
     Axes::Cartesian},
    {"target_TCP_pose", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Target TCP position"), "p*",
     Axes::Cartesian},
    {"target_TCP_pose", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Target TCP rotation vector"), "r*",
     Axes::Cartesian},
    {"target_TCP_speed", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Target TCP speed"), "v*",
     Axes::Cartesian},
    {"target_TCP_speed", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Target TCP angular speed"), "ω*",
     Axes::Cartesian},
    {"ft_raw_wrench", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Raw sensor force"), "Fraw ",
     Axes::Cartesian},
    {"ft_raw_wrench", 3, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Raw sensor torque"), "Traw ",
     Axes::Cartesian},
    {"tcp_force_scalar", 0, 1, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "TCP force, norm"), "|F|", Axes::None},
    {"actual_tool_accelerometer", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Tool accelerometer"), "g",
     Axes::Cartesian},
    {"elbow_position", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Elbow position"), "elbow ",
     Axes::Cartesian},
    {"elbow_velocity", 0, 3, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Elbow speed"), "elbow v",
     Axes::Cartesian},
    {"actual_momentum", 0, 1, kTcp, QT_TRANSLATE_NOOP("SignalInfo", "Momentum"), "Momentum", Axes::None},

    {"actual_q", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint positions"), "q", Axes::Joints},
    {"actual_qd", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint speeds"), "qd", Axes::Joints},
    {"actual_current", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint currents"), "I", Axes::Joints},
    {"joint_temperatures", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint temperatures"), "T",
     Axes::Joints},
    {"actual_joint_voltage", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint voltages"), "U",
     Axes::Joints},
    {"target_q", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Target joint positions"), "q*",
     Axes::Joints},
    {"target_qd", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Target joint speeds"), "qd*", Axes::Joints},
    {"target_qdd", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Target joint accelerations"), "qdd*",
     Axes::Joints},
    {"target_current", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Target joint currents"), "I*",
     Axes::Joints},
    {"target_moment", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Target joint torques"), "M*",
     Axes::Joints},
    {"joint_control_output", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Joint control currents"),
     "Ictrl", Axes::Joints},
    {"actual_current_window", 0, 6, kJoints, QT_TRANSLATE_NOOP("SignalInfo", "Allowed current deviation"),
     "Iwin", Axes::Joints},
    {"joint_position_deviation_ratio", 0, 1, kJoints,
     QT_TRANSLATE_NOOP("SignalInfo", "Position deviation, ratio to limit"), "Deviation", Axes::None},
    {"collision_detection_ratio", 0, 1, kJoints,
     QT_TRANSLATE_NOOP("SignalInfo", "Collision detection, ratio to limit"), "Collision", Axes::None},
    {"joint_mode", 0, 6, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Joint modes"), "Mode", Axes::Joints},

    {"actual_digital_input_bits", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Digital inputs"),
     "Digital inputs", Axes::None},
    {"actual_digital_output_bits", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Digital outputs"),
     "Digital outputs", Axes::None},
    {"standard_analog_input0", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Analog input 0"), "AI 0",
     Axes::None},
    {"standard_analog_input1", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Analog input 1"), "AI 1",
     Axes::None},
    {"standard_analog_output0", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Analog output 0"), "AO 0",
     Axes::None},
    {"standard_analog_output1", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Analog output 1"), "AO 1",
     Axes::None},
    {"tool_analog_input0", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Tool analog input 0"), "TAI 0",
     Axes::None},
    {"tool_analog_input1", 0, 1, kIo, QT_TRANSLATE_NOOP("SignalInfo", "Tool analog input 1"), "TAI 1",
     Axes::None},

    {"robot_mode", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Robot mode"), "Robot mode", Axes::None},
    {"safety_mode", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Safety mode"), "Safety mode", Axes::None},
    {"safety_status", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Safety status"), "Safety status",
     Axes::None},
    {"runtime_state", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Program state"), "Program", Axes::None},
    {"robot_status_bits", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Robot status"), "Robot status",
     Axes::None},
    {"safety_status_bits", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Safety bits"), "Safety bits",
     Axes::None},
    {"tool_mode", 0, 1, kModes, QT_TRANSLATE_NOOP("SignalInfo", "Tool mode"), "Tool mode", Axes::None},

    {"actual_main_voltage", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Main voltage"), "U main",
     Axes::None},
    {"actual_robot_voltage", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Arm voltage"), "U arm",
     Axes::None},
    {"actual_robot_current", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Arm current"), "I arm",
     Axes::None},
    {"io_current", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "I/O current"), "I I/O", Axes::None},
    {"tool_temperature", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Tool temperature"), "T tool",
     Axes::None},
    {"tool_output_voltage", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Tool voltage"), "U tool",
     Axes::None},
    {"tool_output_current", 0, 1, kPower, QT_TRANSLATE_NOOP("SignalInfo", "Tool current"), "I tool",
     Axes::None},

    {"speed_scaling", 0, 1, kProgram, QT_TRANSLATE_NOOP("SignalInfo", "Speed scaling"), "Scaling",
     Axes::None},
    {"target_speed_fraction", 0, 1, kProgram, QT_TRANSLATE_NOOP("SignalInfo", "Speed slider"), "Slider",
     Axes::None},
    {"actual_execution_time", 0, 1, kProgram, QT_TRANSLATE_NOOP("SignalInfo", "Control step time"),
     "Step time", Axes::None},
    {"script_control_line", 0, 1, kProgram, QT_TRANSLATE_NOOP("SignalInfo", "Script line"), "Line",
     Axes::None},
    {"timestamp", 0, 1, kProgram, QT_TRANSLATE_NOOP("SignalInfo", "Controller time"), "Time", Axes::None},

    {"payload", 0, 1, kPayload, QT_TRANSLATE_NOOP("SignalInfo", "Payload"), "Payload", Axes::None},
    {"payload_cog", 0, 3, kPayload, QT_TRANSLATE_NOOP("SignalInfo", "Payload centre of gravity"), "cog ",
     Axes::Cartesian},
    {"tcp_offset", 0, 3, kPayload, QT_TRANSLATE_NOOP("SignalInfo", "TCP offset"), "tcp ", Axes::Cartesian},
    {"tcp_offset", 3, 3, kPayload, QT_TRANSLATE_NOOP("SignalInfo", "TCP rotation"), "tcp r", Axes::Cartesian},
};

struct UnitLook {
    const char* unit;
    int digits;
    double step;
};
constexpr UnitLook kUnits[] = {
    {"N", 1, 5},        {"Nm", 2, 0.5},     {"A", 3, 0.5},       {"rad", 4, 0.02}, {"rad/s", 4, 0.05},
    {"rad/s2", 3, 0.5}, {"m", 5, 0.005},    {"m/s", 4, 0.01},    {"m/s2", 3, 0.5}, {"degC", 1, 1},
    {"V", 2, 1},        {"mA", 1, 5},       {"mA or V", 3, 0.5}, {"kg", 3, 0.1},   {"s", 3, 0.5},
    {"ms", 3, 0.1},     {"kg m/s", 3, 0.5}, {"kg m2", 4, 0.01},  {"J", 1, 5},
};

QString bitName(const FieldInfo& field, int bit) {
    if (field.name == "actual_digital_input_bits" || field.name == "actual_digital_output_bits") {
        const bool in = field.name == "actual_digital_input_bits";
        const QString way = in ? QStringLiteral("I") : QStringLiteral("O");
        return bit < 8    ? QStringLiteral("D%1 %2").arg(way).arg(bit)
               : bit < 16 ? QStringLiteral("C%1 %2").arg(way).arg(bit - 8)
                          : QStringLiteral("T%1 %2").arg(way).arg(bit - 16);
    }
    if (field.name == "robot_status_bits") {
        const QStringList names{SignalText::tr("Power on"), SignalText::tr("Program running"),
                                SignalText::tr("Freedrive button"), SignalText::tr("Power button")};
        return names.value(bit);
    }
    if (field.name == "safety_status_bits") {
        const QStringList names{SignalText::tr("Normal"),
                                SignalText::tr("Reduced"),
                                SignalText::tr("Protective stop"),
                                SignalText::tr("Recovery"),
                                SignalText::tr("Safeguard stop"),
                                SignalText::tr("System emergency stop"),
                                SignalText::tr("Robot emergency stop"),
                                SignalText::tr("Emergency stop"),
                                SignalText::tr("Violation"),
                                SignalText::tr("Fault"),
                                SignalText::tr("Stopped due to safety"),
                                SignalText::tr("Enabling device")};
        return names.value(bit);
    }
    if (field.name.find("bit_registers32") != std::string_view::npos) {
        return SignalText::tr("Bit %1").arg(bit + 32);
    }
    return field.bits == 1 ? QString() : SignalText::tr("Bit %1").arg(bit);
}

QString toText(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

class Catalogue {
public:
    QVector<SignalInfo> all() {
        for (const Family& family : kFamilies) {
            if (const FieldInfo* field = receive::findField(family.field)) {
                addFamily(*field, family);
            }
        }
        for (const FieldInfo& field : receive::fieldInfos()) {
            addRest(field);
        }
        std::stable_sort(signals_.begin(), signals_.end(), [](const SignalInfo& a, const SignalInfo& b) {
            return placeOf(a.group) < placeOf(b.group);
        });
        return std::move(signals_);
    }

private:
    static qsizetype placeOf(const QString& group) {
        for (std::size_t i = 0; i < kGroups.size(); ++i) {
            if (SignalText::tr(kGroups[i]) == group) {
                return static_cast<qsizetype>(i);
            }
        }
        return static_cast<qsizetype>(kGroups.size());
    }

    static SignalInfo ofField(const FieldInfo& field, int component) {
        SignalInfo info;
        info.key = QString::fromStdString(field.componentName(component));
        info.field = toText(field.name);
        info.component = component;
        info.meaning = toText(field.meaning);
        info.kind = field.kind;
        info.modes = field.modes;
        setUnit(info, QString::fromStdString(field.units[static_cast<std::size_t>(component)]));
        return info;
    }

    void addFamily(const FieldInfo& field, const Family& family) {
        for (int i = family.first; i < family.first + family.count; ++i) {
            SignalInfo info = ofField(field, i);
            info.group = SignalText::tr(family.group);
            info.family = SignalText::tr(family.title);
            const QString symbol = QString::fromUtf8(family.symbol);
            switch (family.axes) {
                case Axes::Cartesian:
                    info.label = symbol + QLatin1Char("xyz"[i % 3]);
                    info.longLabel = info.label;
                    info.axis = i % 3;
                    break;
                case Axes::Joints:
                    info.label = jointName(i);
                    info.longLabel = symbol + QLatin1Char(' ') + info.label;
                    break;
                case Axes::None:
                    info.label = info.longLabel = symbol;
                    break;
            }
            addWithBits(field, info);
        }
    }

    void addRest(const FieldInfo& field) {
        const bool isRegister = field.name.find("_register") != std::string_view::npos;
        for (int i = 0; i < field.components; ++i) {
            SignalInfo info = ofField(field, i);
            if (seen_.contains(info.key)) {
                continue;
            }
            info.group = SignalText::tr(isRegister ? kRegisters : kMore);
            info.family = isRegister ? registerFamily(info.field) : info.field;
            info.label = info.longLabel = info.key;
            addWithBits(field, info);
        }
    }

    static QString registerFamily(const QString& field) {
        const bool output = field.startsWith(QLatin1String("output"));
        if (field.contains(QLatin1String("double"))) {
            return output ? SignalText::tr("Output registers, floats")
                          : SignalText::tr("Input registers, floats");
        }
        if (field.contains(QLatin1String("int"))) {
            return output ? SignalText::tr("Output registers, integers")
                          : SignalText::tr("Input registers, integers");
        }
        return output ? SignalText::tr("Output registers, bits") : SignalText::tr("Input registers, bits");
    }

    void addWithBits(const FieldInfo& field, SignalInfo info) {
        seen_.insert(info.key);
        if (field.kind != FieldKind::Bits) {
            signals_.append(std::move(info));
            return;
        }
        for (int bit = 0; bit < field.bits; ++bit) {
            SignalInfo one = info;
            one.bit = bit;
            if (field.bits > 1) {
                one.key += QStringLiteral(".%1").arg(bit);
                one.label = bitName(field, bit);
                one.longLabel = field.name.find("bit_registers") != std::string_view::npos
                                    ? one.family + QLatin1Char(' ') + one.label
                                    : one.label;
            }
            signals_.append(std::move(one));
        }
    }

    QVector<SignalInfo> signals_;
    QSet<QString> seen_;
};

}  // namespace

void setUnit(SignalInfo& info, const QString& unit) {
    info.unit = unit == QLatin1String("degC") ? QStringLiteral("°C") : unit;
    for (const UnitLook& look : kUnits) {
        if (unit == QLatin1String(look.unit)) {
            info.digits = look.digits;
            info.step = look.step;
        }
    }
    if (info.kind != FieldKind::Number) {
        info.digits = 0;
        info.step = 1;
    }
}

QString SignalInfo::stateName(double value) const {
    if (std::isnan(value)) {
        return {};
    }
    if (bit >= 0) {
        return value != 0 ? SignalText::tr("on") : SignalText::tr("off");
    }
    const auto number = static_cast<std::int32_t>(value);
    switch (modes) {
        case FieldModes::Robot:
            return robotModeWords(static_cast<RobotMode>(number)).text;
        case FieldModes::Safety:
        case FieldModes::SafetyStatus:
            return safetyWords(static_cast<SafetyStatus>(number)).text;
        case FieldModes::Runtime:
            return runtimeWords(static_cast<RuntimeState>(number)).text;
        case FieldModes::Joint:
        case FieldModes::Tool:
            return jointModeName(static_cast<JointMode>(number));
        case FieldModes::None:
            break;
    }
    return QString::number(value, 'f', 0);
}

QString SignalInfo::valueText(double value, bool withSign) const {
    if (isState()) {
        const QString name = stateName(value);
        return name.isEmpty() ? QStringLiteral("–") : name;
    }
    const QString number = withSign ? format::signedNumber(value, digits) : format::number(value, digits);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

QVector<SignalInfo> robotSignals() {
    return Catalogue().all();
}

}  // namespace tiller
