// SPDX-License-Identifier: MIT
#pragma once

// Expressions, variables, terminals and features that nodes refer to, as URScript.

#include <QString>
#include <map>

#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

struct Expression {
    QString script;
    QString shown;  ///< in the program tree
};

class Expressions {
public:
    explicit Expressions(Translation& translation) : t_(translation) {}

    /// Of an element with the parts of an expression. An empty one is the sign of an unfinished node.
    Expression of(const XmlElement& expression);
    /// Of the child of that name; `what` is missing when there is no such child, or it is empty.
    Expression in(const XmlElement& node, const char* child, const QString& what);

    /// The name of the variable that `child` of a node leads to; empty when the node is unfinished.
    QString variable(const XmlElement& node, const char* child = "variable");
    /// A pose in the base frame, of the `feature` of a node or, without one, of `otherwise`.
    struct Frame {
        enum class Kind { Base, Tool, Other };
        Kind kind = Kind::Base;
        QString name;
        QString script;  ///< a pose; empty: the installation does not have it
    };
    Frame frame(const XmlElement& node, const XmlElement* otherwise = nullptr);

    struct Signal {
        QString shown;
        QString read;                        ///< an expression
        const TerminalKind* kind = nullptr;  ///< null for a Modbus signal
        int number = 0;
        const ModbusSignal* modbus = nullptr;

        bool isBoolean() const;
        /// A statement that sets it to the value of an expression; empty for an input.
        QString write(const QString& value) const;
    };
    /// What the `pin` of a node leads to. Refuses a node whose pin is not known.
    Signal signal(const XmlElement& node);

    /// Names of the variables `<name>_p` and `<name>_q` that hold a fixed waypoint.
    void nameWaypoint(const XmlElement& waypoint, const QString& name) { waypoints_[&waypoint] = name; }
    QString waypointName(const XmlElement& waypoint) const;

private:
    QString nameOfVariable(const XmlElement& reference);
    void appendPart(const XmlElement& part, Expression& to);

    Translation& t_;
    std::map<const XmlElement*, QString> waypoints_;
};

}  // namespace tiller::simulator::pendant
