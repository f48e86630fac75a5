// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/expressions.h"

#include <algorithm>
#include <utility>

namespace tiller::simulator::pendant {

namespace {

/// The teach pendant stores some operators as single characters. Inside strings, these characters must not
/// change.
QString withOperators(const QString& text) {
    static const std::pair<char16_t, const char*> kSigns[] = {
        {0x225F, "=="}, {0x2260, "!="}, {0x2264, "<="}, {0x2265, ">="}, {0x2254, "="},
    };
    QString script;
    bool inString = false;
    for (const QChar c : text) {
        inString = c == '"' ? !inString : inString;
        const auto* const sign =
            std::ranges::find(kSigns, c.unicode(), [](const auto& s) { return s.first; });
        if (inString || sign == std::end(kSigns)) {
            script += c;
        } else {
            script += QLatin1String(sign->second);
        }
    }
    return script;
}

/// The base and the tool have internal names.
QString nameOfFeature(const QString& name) {
    return name == QLatin1String("Joint_0_name")   ? QStringLiteral("Base")
           : name == QLatin1String("Joint_6_name") ? QStringLiteral("Tool")
                                                   : name;
}

/// The teach pendant stores some keywords without surrounding spaces.
QString separated(const QString& token) {
    const bool begins = !token.isEmpty() && token.front().isLetterOrNumber();
    const bool ends = !token.isEmpty() && token.back().isLetterOrNumber();
    return (begins ? QStringLiteral(" ") : QString()) + token + (ends ? QStringLiteral(" ") : QString());
}

}  // namespace

Expression Expressions::of(const XmlElement& expression) {
    Expression all;
    for (const auto& part : expression.children) {
        appendPart(*part, all);
    }
    all.script = withOperators(all.script);
    return all;
}

Expression Expressions::in(const XmlElement& node, const char* child, const QString& what) {
    const XmlElement* const expression = node.target(child);
    Expression found = expression == nullptr ? Expression() : of(*expression);
    if (found.script.trimmed().isEmpty()) {
        t_.unfinished(node, QStringLiteral("%1 is missing").arg(what));
    }
    return found;
}

void Expressions::appendPart(const XmlElement& part, Expression& to) {
    const auto both = [&to](const QString& text) {
        to.script += text;
        to.shown += text;
    };
    if (part.is("ExpressionChar")) {
        both(part.attribute("character"));
    } else if (part.is("ExpressionToken")) {
        const QString token = part.attribute("token") + part.attribute("character");
        to.script += separated(token);
        to.shown += token;
    } else if (part.is("ExpressionVariable") && !part.children.empty()) {
        both(nameOfVariable(*part.children.front()));
    } else if (part.is("ExpressionIO")) {
        const Signal found = signal(part);
        to.script += found.read;
        to.shown += found.shown;
    } else if (part.is("ExpressionWaypoint")) {
        const XmlElement* const waypoint = part.target("Waypoint");
        const QString name = waypoint == nullptr ? QString() : waypointName(*waypoint);
        if (name.isEmpty()) {
            t_.refuse(part, QStringLiteral("the referenced element is not a waypoint with a fixed position"));
        }
        to.script += name + QStringLiteral("_p");
        to.shown += name;
    } else if (part.is("ExpressionGeomFeature")) {
        const Frame found = frame(part);
        if (found.script.isEmpty()) {
            t_.refuse(
                part,
                QStringLiteral("there is no feature '%1': %2").arg(found.name, t_.installation.shownName()));
        }
        to.script += found.script;
        to.shown += found.name;
    } else if (part.is("ExpressionBranch")) {
        for (const auto& inner : part.children) {
            appendPart(*inner, to);
        }
    } else {
        t_.refuse(part, QStringLiteral("this part of an expression is not simulated"));
    }
}

QString Expressions::variable(const XmlElement& node, const char* child) {
    const XmlElement* const reference = node.child(child);
    if (reference == nullptr) {
        t_.unfinished(node, QStringLiteral("the variable is missing"));
        return {};
    }
    return nameOfVariable(*reference);
}

QString Expressions::nameOfVariable(const XmlElement& reference) {
    const XmlElement* const variable = reference.resolved();
    if (variable == nullptr) {
        t_.refuse(reference, QStringLiteral("the referenced element is not a variable"));
        return {};
    }
    if (const QString feature = nameOfFeature(variable->attribute("featureName")); !feature.isEmpty()) {
        const auto found = t_.installation.features.find(feature);
        if (found == t_.installation.features.end() || !found->second.isVariable) {
            t_.refuse(reference, QStringLiteral("there is no variable feature '%1': %2")
                                     .arg(feature, t_.installation.shownName()));
        }
        return identifier(feature);
    }
    const QString name = variable->attribute("name");
    if (name.isEmpty()) {
        t_.refuse(reference, QStringLiteral("the referenced element is not a variable"));
    }
    if (variable->is("InstallationVariable") &&
        std::ranges::find(t_.installation.variables, name, &std::pair<QString, QString>::first) ==
            t_.installation.variables.end()) {
        t_.refuse(reference, QStringLiteral("there is no installation variable '%1': %2")
                                 .arg(name, t_.installation.shownName()));
    }
    return identifier(name);
}

Expressions::Frame Expressions::frame(const XmlElement& node, const XmlElement* otherwise) {
    const XmlElement* const own = node.child("feature");
    const XmlElement* const given = own != nullptr         ? own
                                    : otherwise == nullptr ? nullptr
                                                           : otherwise->child("feature");
    if (given == nullptr) {
        return {Frame::Kind::Base, QStringLiteral("Base"), QStringLiteral("p[0,0,0,0,0,0]")};
    }
    const XmlElement* const feature = given->resolved();
    if (feature == nullptr) {
        t_.refuse(*given, QStringLiteral("the referenced element is not a feature"));
        return {};
    }
    // A feature that is a variable has its name in another attribute.
    const bool isVariable = feature->has("featureName");
    const QString name = nameOfFeature(feature->attribute(isVariable ? "featureName" : "referencedName"));
    const auto found = t_.installation.features.find(name);
    const bool isKnownVariable = isVariable && found != t_.installation.features.end();
    if (name.isEmpty() || (name == QLatin1String("Base") && !isKnownVariable)) {
        return {Frame::Kind::Base, QStringLiteral("Base"), QStringLiteral("p[0,0,0,0,0,0]")};
    }
    if (name == QLatin1String("Tool") && !isKnownVariable) {
        return {Frame::Kind::Tool, name, QStringLiteral("tool_pose()")};
    }
    if (found == t_.installation.features.end()) {
        return {Frame::Kind::Other, name, {}};
    }
    return {Frame::Kind::Other, name,
            found->second.isVariable ? identifier(name) : "p[" + found->second.pose + ']'};
}

bool Expressions::Signal::isBoolean() const {
    return kind != nullptr ? kind->value == TerminalValue::Boolean
                           : modbus != nullptr && (modbus->type == ModbusSignal::Type::DigitalInput ||
                                                   modbus->type == ModbusSignal::Type::DigitalOutput);
}

QString Expressions::Signal::write(const QString& value) const {
    if (kind != nullptr) {
        return kind->write == nullptr
                   ? QString()
                   : QStringLiteral("%1(%2, %3)").arg(QLatin1String(kind->write)).arg(number).arg(value);
    }
    if (modbus == nullptr) {
        return {};
    }
    switch (modbus->type) {
        case ModbusSignal::Type::DigitalOutput:
            return QStringLiteral("modbus_set_output_signal(%1, %2, False)").arg(quoted(shown), value);
        case ModbusSignal::Type::RegisterOutput:
            return QStringLiteral("modbus_set_output_register(%1, %2, False)").arg(quoted(shown), value);
        case ModbusSignal::Type::DigitalInput:
        case ModbusSignal::Type::RegisterInput:
            break;
    }
    return {};
}

Expressions::Signal Expressions::signal(const XmlElement& node) {
    const XmlElement* const given = node.child("pin");
    if (given == nullptr) {
        t_.unfinished(node, QStringLiteral("the name of the pin is missing"));
        return {{}, QStringLiteral("False")};
    }
    const XmlElement* const pin = given->resolved();
    const QString name = pin == nullptr               ? QString()
                         : pin->has("referencedName") ? pin->attribute("referencedName")
                                                      : pin->text.trimmed();
    const Installation& installation = t_.installation;
    const auto named = installation.terminals.find(name);
    const std::optional<Terminal> terminal =
        named != installation.terminals.end() ? std::optional(named->second) : terminalByDefaultName(name);
    if (terminal) {
        const TerminalKind& kind = *terminal->kind;
        return {named != installation.terminals.end()
                    ? name
                    : QStringLiteral("%1[%2]").arg(QLatin1String(kind.label)).arg(terminal->number),
                QStringLiteral("%1(%2)").arg(QLatin1String(kind.read)).arg(terminal->number), &kind,
                terminal->number};
    }
    if (const auto found = installation.signals_.find(name); found != installation.signals_.end()) {
        return {name, QStringLiteral("modbus_get_signal_status(%1, False)").arg(quoted(name)), nullptr, 0,
                &found->second};
    }
    t_.refuse(node, pin == nullptr
                        ? QStringLiteral("the pin does not exist")
                        : QStringLiteral("pin '%1' is not known: %2").arg(name, installation.shownName()));
    return {name, QStringLiteral("False")};
}

QString Expressions::waypointName(const XmlElement& waypoint) const {
    const auto found = waypoints_.find(&waypoint);
    return found == waypoints_.end() ? QString() : found->second;
}

}  // namespace tiller::simulator::pendant
