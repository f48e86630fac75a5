// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/installation.h"

#include <algorithm>
#include <cmath>

#include "robot/core/spatial.h"
#include "robot/simulator/pendant/xml_tree.h"

namespace tiller::simulator::pendant {

namespace {

void readTerminals(const XmlElement& ios, Installation& to) {
    for (const TerminalKind& kind : terminalKinds()) {
        const XmlElement* const names = ios.child(kind.namesElement);
        const QStringList list = names == nullptr ? QStringList() : names->attribute("value").split(',');
        for (int i = 0; i < std::min<int>(kind.count, static_cast<int>(list.size())); ++i) {
            if (const QString name = list[i].trimmed(); !name.isEmpty()) {
                to.terminals.try_emplace(name, Terminal{&kind, i});
            }
        }
    }
    if (const XmlElement* const domains = ios.child("analogOutputDomain")) {
        const QStringList list = domains->attribute("value").split(',');
        for (std::size_t i = 0; i < to.analogOutputIsVoltage.size(); ++i) {
            to.analogOutputIsVoltage[i] =
                list.value(static_cast<qsizetype>(i)).trimmed() == QLatin1String("1");
        }
    }
}

/// Adds a call for each value of a list, in the order of the list, that has an entry in the table.
void addCalls(const QString& values, const std::map<QString, QString>& table, const QString& call, int first,
              int count, Installation& to) {
    const QStringList list = values.split(',');
    for (int i = 0; i < count; ++i) {
        if (const auto found = table.find(list.value(first + i).trimmed()); found != table.end()) {
            to.setup << call.arg(i).arg(found->second);
        }
    }
}

void readTerminalSettings(const XmlElement& ios, Installation& to) {
    const auto value = [&ios](const char* element) {
        const XmlElement* const found = ios.child(element);
        return found == nullptr ? QString() : found->attribute("value");
    };
    const std::map<QString, QString> domains{{"0", "0"}, {"1", "1"}};
    addCalls(value("analogInputRange"), domains, QStringLiteral("set_standard_analog_input_domain(%1, %2)"),
             0, 2, to);
    addCalls(value("analogInputRange"), domains, QStringLiteral("set_tool_analog_input_domain(%1, %2)"), 2, 2,
             to);
    const std::map<QString, QString> actions{{"FREEDRIVE", "\"freedrive\""}};
    to.setup << QStringLiteral("set_input_actions_to_default()");
    addCalls(value("DigitalInputActions"), actions,
             QStringLiteral("set_standard_digital_input_action(%1, %2)"), 0, 8, to);
    addCalls(value("ConfigurableInputActions"), actions,
             QStringLiteral("set_configurable_digital_input_action(%1, %2)"), 0, 8, to);
    addCalls(value("ToolDigitalInputActions"), actions,
             QStringLiteral("set_tool_digital_input_action(%1, %2)"), 0, 2, to);
    addCalls(value("GeneralPurposeBooleanRegisterInputActions"), actions,
             QStringLiteral("set_gp_boolean_input_action(%1, %2)"), 0, 128, to);
    const std::map<QString, QString> states{
        {"LOW_WHEN_PROGRAM_STOPPED", "1"}, {"HIGH_WHEN_PROGRAM_STOPPED", "2"}, {"PROGRAM_RUNNING", "3"}};
    addCalls(value("DigitalOutputActions"), states,
             QStringLiteral("set_runstate_standard_digital_output_to_value(%1, %2)"), 0, 8, to);
    addCalls(value("ConfigurableOutputActions"), states,
             QStringLiteral("set_runstate_configurable_digital_output_to_value(%1, %2)"), 0, 8, to);
    addCalls(value("ToolDigitalOutputActions"), states,
             QStringLiteral("set_runstate_tool_digital_output_to_value(%1, %2)"), 0, 2, to);
    addCalls(value("AnalogOutputActions"), states,
             QStringLiteral("set_runstate_standard_analog_output_to_value(%1, %2)"), 0, 2, to);
    addCalls(value("GeneralPurposeBooleanRegisterOutputActions"), states,
             QStringLiteral("set_runstate_gp_boolean_output_to_value(%1, %2)"), 0, 128, to);
}

/// Settings with unknown values are omitted.
void readToolConnector(const XmlElement& settings, Installation& to) {
    const auto value = [&settings](const char* attribute, const std::map<QString, QString>& table) {
        const auto found = table.find(settings.attribute(attribute));
        return found == table.end() ? QString() : found->second;
    };
    const QString enabled = value("enabled", {{"true", "True"}, {"false", "False"}});
    const QString baud = settings.attribute("baudRate").section('_', 1);
    const QString parity = value("parity", {{"NONE", "0"}, {"ODD", "1"}, {"EVEN", "2"}});
    const QString stopBits = value("stopBits", {{"ONE", "1"}, {"TWO", "2"}});
    const QString rx = numberList(settings.attribute("rxIdleChars"), 1);
    const QString tx = numberList(settings.attribute("txIdleChars"), 1);
    if (!enabled.isEmpty() && !numberList(baud, 1).isEmpty() && !parity.isEmpty() && !stopBits.isEmpty() &&
        !rx.isEmpty() && !tx.isEmpty()) {
        to.setup << QStringLiteral("set_tool_communication(%1, %2, %3, %4, %5, %6)")
                        .arg(enabled, baud, parity, stopBits, rx, tx);
    }
    if (settings.attribute("toolOutputMode") == QLatin1String("OUTPUT")) {
        to.setup << QStringLiteral("set_tool_output_mode(0)");
    }
    const std::map<QString, QString> modes{{"SINKING", "1"}, {"SOURCING", "2"}, {"PUSH_PULL", "3"}};
    for (const int i : {0, 1}) {
        const QString mode = value(i == 0 ? "toolDigitalOutput0" : "toolDigitalOutput1", modes);
        if (!mode.isEmpty()) {
            to.setup << QStringLiteral("set_tool_digital_output_mode(%1, %2)").arg(i).arg(mode);
        }
    }
    const QString volts =
        value("toolOutputVoltage", {{"ZERO", "0"}, {"TWELVE", "12"}, {"TWENTY_FOUR", "24"}});
    if (!volts.isEmpty()) {
        to.setup << QStringLiteral("set_tool_voltage(%1)").arg(volts);
    }
}

/// The direction of gravity follows from the mounting. The signs were taken from exported scripts.
void readMounting(const XmlElement& mounting, Installation& to) {
    constexpr double kGravity = 9.82;  // [m/s2]
    const QString base = numberList(mounting.attribute("baseAngle"), 1);
    const QString tilt = numberList(mounting.attribute("tiltAngle"), 1);
    if (base.isEmpty() || tilt.isEmpty()) {
        return;
    }
    const double b = base.toDouble(), t = tilt.toDouble();
    const auto text = [](double value) { return QString::number(value, 'g', 12); };
    to.setup << QStringLiteral("set_gravity([%1, %2, %3])")
                    .arg(text(kGravity * std::sin(t) * std::sin(b)),
                         text(-kGravity * std::sin(t) * std::cos(b)), text(kGravity * std::cos(t)));
}

void readModbus(const XmlElement& units, Installation& to) {
    using Type = ModbusSignal::Type;
    static const std::map<QString, Type> kTypes{{"DIGITAL_INPUT", Type::DigitalInput},
                                                {"DIGITAL_OUTPUT", Type::DigitalOutput},
                                                {"REGISTER_INPUT", Type::RegisterInput},
                                                {"REGISTER_OUTPUT", Type::RegisterOutput}};
    for (const auto& unit : units.children) {
        for (const auto& signal : unit->children) {
            const auto type = kTypes.find(signal->attribute("type"));
            if (signal->is("ModbusSignal") && type != kTypes.end() && signal->has("name")) {
                to.signals_.try_emplace(
                    signal->attribute("name"),
                    ModbusSignal{unit->attribute("ipAddress"), signal->attribute("slaveAddress").toInt(),
                                 signal->attribute("signalAddress").toInt(), type->second,
                                 unit->isTrue("sequentialMode"),
                                 numberList(signal->attribute("updateFrequency"), 1),
                                 numberList(signal->attribute("modificationChoice"), 1)});
            }
        }
    }
}

/// The taught points of a plane, in the base frame.
std::vector<Pose> pointsOf(const XmlElement& plane) {
    std::vector<Pose> points;
    for (const char* const name : {"firstPoint", "secondPoint", "thirdPoint"}) {
        const XmlElement* const place = plane.child(name);
        const XmlElement* const point = place == nullptr ? nullptr : place->target("GeomPoseNode");
        const XmlElement* const position = point == nullptr ? nullptr : point->child("toolPosition");
        const XmlElement* const rotation = point == nullptr ? nullptr : point->child("toolAxisAngle");
        const auto numbers =
            position == nullptr || rotation == nullptr
                ? std::nullopt
                : sixNumbers(position->attribute("value") + ',' + rotation->attribute("value"));
        if (numbers) {
            points.push_back(Pose::fromArray(*numbers));
        }
    }
    return points;
}

/// The pose of a plane, as in exported scripts: the origin is the first point, the y axis leads to the second
/// point, and the x axis leads away from the third point. Empty if the points do not define a plane, or if its z
/// axis is opposite to that of the tool at the first point, because the manual then documents another direction.
QString poseOfPlane(const XmlElement& plane) {
    constexpr double kMinArea = 1e-9;  // [m2]
    const std::vector<Pose> points = pointsOf(plane);
    if (points.size() != 3) {
        return {};
    }
    const Eigen::Vector3d y = points[1].position - points[0].position;
    const Eigen::Vector3d z = y.cross(points[2].position - points[0].position);
    if (z.norm() < kMinArea || z.dot(rotationMatrix(points[0].rotation).col(2)) <= 0) {
        return {};
    }
    Eigen::Matrix3d axes;
    axes << y.cross(z).normalized(), y.normalized(), z.normalized();
    const Eigen::Vector3d rotation = rotationVector(axes);
    QStringList numbers;
    for (const Eigen::Vector3d& part : {points[0].position, rotation}) {
        for (const double number : part) {
            numbers << QString::number(number, 'g', 15);
        }
    }
    return numbers.join(QStringLiteral(", "));
}

/// Reads points and planes.
void readFeatures(const XmlElement& element, Installation& to) {
    if (element.is("GeomPlaneNode") && element.has("name")) {
        if (const QString pose = poseOfPlane(element); !pose.isEmpty()) {
            to.features.try_emplace(element.attribute("name"), Feature{pose, element.isTrue("isVariable")});
        }
        return;
    }
    const XmlElement* const position = element.child("toolPosition");
    const XmlElement* const rotation = element.child("toolAxisAngle");
    if (element.has("name") && position != nullptr && rotation != nullptr) {
        const QString pose = numberList(position->attribute("value") + ',' + rotation->attribute("value"), 6);
        if (!pose.isEmpty() && !element.isTrue("hiddenSubFeature")) {
            to.features.try_emplace(element.attribute("name"), Feature{pose, element.isTrue("isVariable")});
        }
        return;
    }
    if (element.is("BaseView") && element.isTrue("isVariable")) {
        to.features.try_emplace(QStringLiteral("Base"), Feature{QStringLiteral("0, 0, 0, 0, 0, 0"), true});
    }
    for (const auto& child : element.children) {
        readFeatures(*child, to);
    }
}

void readPayloads(const XmlElement& root, Installation& to) {
    if (const XmlElement* const settings = root.child("PayloadSettings")) {
        for (const auto& row : settings->children) {
            const Payload payload{row->attribute("name"), numberList(row->attribute("mass"), 1),
                                  numberList(row->attribute("centerOfGravity"), 3),
                                  numberList(row->attribute("inertiaParameters"), 6)};
            if (!payload.mass.isEmpty() && !payload.centerOfGravity.isEmpty()) {
                to.payloads.push_back(payload);
                if (row->isTrue("defaultPayload")) {
                    to.defaultPayload = payload;
                }
            }
        }
    }
    // Before software 5.10, the TCP settings contained the payload.
    const XmlElement* const tcps = root.child("TCPSettings");
    if (!to.defaultPayload && tcps != nullptr) {
        const QString mass = numberList(tcps->attribute("toolPayload"), 1);
        const QString center = numberList(tcps->attribute("centerOfGravity"), 3);
        if (!mass.isEmpty()) {
            to.defaultPayload = Payload{{}, mass, center, {}};
        }
    }
}

/// The file is XML in newer software. In older software, it is a properties file with lines `name=value` and
/// backslashes before special characters.
void readVariables(const QByteArray& content, Installation& to) {
    if (isGzip(content) || content.trimmed().startsWith('<')) {
        if (const Result<std::unique_ptr<XmlElement>> tree = readPendantFile(content)) {
            for (const auto& variable : (*tree)->children) {
                if (variable->has("name") && variable->has("value")) {
                    to.variables.emplace_back(variable->attribute("name"), variable->attribute("value"));
                }
            }
        }
        return;
    }
    for (const QByteArray& bytes : content.split('\n')) {
        const QString line = QString::fromUtf8(bytes).trimmed();
        QString text;
        qsizetype equals = -1;
        for (qsizetype i = 0; i < line.size() && !line.startsWith('#'); ++i) {
            if (line[i] == '\\' && i + 1 < line.size()) {
                ++i;
                if (line[i] == 'u' && i + 4 < line.size()) {
                    text += QChar(line.mid(i + 1, 4).toUShort(nullptr, 16));
                    i += 4;
                    continue;
                }
            } else if (line[i] == '=' && equals < 0) {
                equals = text.size();
            }
            text += line[i];
        }
        if (equals > 0 && text.size() > equals + 1) {
            to.variables.emplace_back(text.left(equals).trimmed(), text.mid(equals + 1).trimmed());
        }
    }
}

}  // namespace

QString numberList(const QString& text, int count) {
    const QStringList numbers = text.split(',');
    bool all = numbers.size() == count;
    for (const QString& number : numbers) {
        bool ok = false;
        const double value = number.trimmed().toDouble(&ok);
        all = all && ok && std::isfinite(value);
    }
    return all ? text.simplified() : QString();
}

std::optional<std::array<double, 6>> sixNumbers(const QString& text) {
    const QString list = numberList(text, 6);
    if (list.isEmpty()) {
        return std::nullopt;
    }
    std::array<double, 6> numbers{};
    std::ranges::transform(list.split(','), numbers.begin(),
                           [](const QString& number) { return number.trimmed().toDouble(); });
    return numbers;
}

QString Installation::shownName() const {
    return file.isEmpty() ? QStringLiteral("no installation file was found")
                          : QStringLiteral("the installation is '%1'").arg(file);
}

const Payload* Installation::payload(const QString& name) const {
    const auto found = std::ranges::find(payloads, name, &Payload::name);
    return found == payloads.end() ? nullptr : &*found;
}

Result<Installation> readInstallation(const QString& file, const QByteArray& content,
                                      const QByteArray& variables) {
    const Result<std::unique_ptr<XmlElement>> tree = readPendantFile(content);
    if (!tree) {
        return tree.error();
    }
    const XmlElement& root = **tree;
    Installation to;
    to.file = file;
    if (const XmlElement* const ios = root.target("IOs")) {
        readTerminals(*ios, to);
        readTerminalSettings(*ios, to);
        if (const XmlElement* const units = ios->child("ModbusUnits")) {
            readModbus(*units, to);
        }
    }
    if (const XmlElement* const settings = root.child("ToolCommSettings")) {
        readToolConnector(*settings, to);
    }
    if (const XmlElement* const mounting = root.descendant("WorldtoMarshal")) {
        readMounting(*mounting, to);
    }
    if (const XmlElement* const settings = root.child("TCPSettings")) {
        to.activeTcp = settings->attribute("activePose");
        if (const XmlElement* const poses = settings->child("availablePoses")) {
            for (const auto& tcp : poses->children) {
                if (const QString pose = numberList(tcp->attribute("offset"), 6); !pose.isEmpty()) {
                    to.tcps.try_emplace(tcp->attribute("name"), pose);
                }
            }
        }
    }
    for (const char* const container : {"Features", "GeomFeatures"}) {
        if (const XmlElement* const features = root.child(container)) {
            readFeatures(*features, to);
        }
    }
    readPayloads(root, to);
    if (const XmlElement* const home = root.child("SafeHomeSettings")) {
        to.home = home->attribute("enabled") == QLatin1String("false")
                      ? QString()
                      : numberList(home->attribute("position"), 6);
    }
    readVariables(variables, to);
    return to;
}

}  // namespace tiller::simulator::pendant
