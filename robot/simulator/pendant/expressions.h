// SPDX-License-Identifier: MIT
#pragma once

// Converts the expressions, variables, terminals and features used by nodes into URScript.

#include <QString>
#include <map>

#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

struct Expression {
    QString script;
    QString shown;  ///< text in the program tree
};

class Expressions {
public:
    explicit Expressions(Translation& translation) : t_(translation) {}

    /// Converts an expression from the element that contains its parts. An empty expression marks an
    /// unfinished node.
    Expression of(const XmlElement& expression);
    /// Converts the child with this name. If the child is missing or empty, reports `what` as missing.
    Expression in(const XmlElement& node, const char* child, const QString& what);

    /// The name of the variable referenced by `child` of a node; empty if the node is unfinished.
    QString variable(const XmlElement& node, const char* child = "variable");
    /// A feature pose in the base frame: the `feature` of a node or, if the node has no feature, `otherwise`.
    struct Frame {
        enum class Kind { Base, Tool, Other };
        Kind kind = Kind::Base;
        QString name;
        QString script;  ///< pose expression; empty: missing in the installation
    };
    Frame frame(const XmlElement& node, const XmlElement* otherwise = nullptr);

    struct Signal {
        QString shown;
        QString read;                        ///< expression that reads the signal
        const TerminalKind* kind = nullptr;  ///< null for a Modbus signal
        int number = 0;
        const ModbusSignal* modbus = nullptr;

        bool isBoolean() const;
        /// Returns a statement that assigns the expression to the signal; empty for an input.
        QString write(const QString& value) const;
    };
    /// Returns the signal referenced by the `pin` of a node. Refuses a node with an unknown pin.
    Signal signal(const XmlElement& node);

    /// Sets the name of a fixed waypoint, which is stored in the variables `<name>_p` and `<name>_q`.
    void nameWaypoint(const XmlElement& waypoint, const QString& name) { waypoints_[&waypoint] = name; }
    QString waypointName(const XmlElement& waypoint) const;

private:
    QString nameOfVariable(const XmlElement& reference);
    void appendPart(const XmlElement& part, Expression& to);

    Translation& t_;
    std::map<const XmlElement*, QString> waypoints_;
};

}  // namespace tiller::simulator::pendant
