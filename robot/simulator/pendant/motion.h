// SPDX-License-Identifier: MIT
#pragma once

// Move nodes and related nodes: waypoints, circles, directions with their Until nodes, Home and Force.

#include <QString>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "robot/simulator/pendant/expressions.h"
#include "robot/simulator/pendant/translation.h"

namespace tiller::simulator::pendant {

class Motion {
public:
    /// writeChildren  writes the child nodes of a node, including referenced nodes
    /// keepsDisabled  whether disabled waypoints are translated
    Motion(Translation& translation, Expressions& expressions,
           std::function<void(const XmlElement&)> writeChildren, bool keepsDisabled)
        : t_(translation)
        , x_(expressions)
        , writeChildren_(std::move(writeChildren))
        , keepsDisabled_(keepsDisabled) {}

    /// Assigns a name to every fixed waypoint below an element and writes the variables with the waypoint
    /// positions.
    void defineWaypoints(const XmlElement& element);

    void writeMove(const XmlElement& node);
    void writeWaypoint(const XmlElement& node);
    void writeCircle(const XmlElement& node);
    void writeDirection(const XmlElement& node);
    void writeHome(const XmlElement& node);
    void writeForce(const XmlElement& node);

    /// True if the script must define the functions for directions.
    bool usesDirections() const { return usesDirections_; }
    static void defineDirections(ScriptText& out);

private:
    struct Definer;  // the node that defines motion, speed and feature of a waypoint
    struct Until;

    void labelWaypoint(const XmlElement& waypoint);
    std::pair<QString, bool> nameFor(const XmlElement& waypoint, const QString& position);
    Definer definerOf(const XmlElement& node);
    QString targetOf(const XmlElement& waypoint, const Definer& move, bool joints);
    QString parametersOf(const XmlElement& waypoint, const Definer& move);
    QString number(const XmlElement& node, const char* attribute);
    void applyTcp(const Definer& move);
    const XmlElement* nextMotion(const XmlElement& node) const;
    QString processBlend(const XmlElement& node, const Definer& move);
    std::vector<Until> untilsOf(const XmlElement& node, bool ofWaypoint);
    void writeWatchedMove(const XmlElement& node, const QString& statement, const std::vector<Until>& untils);
    void writeUntil(const Until& until, const QString& thread, const QString& arrived);
    void writeActions(const Until& until);

    Translation& t_;
    Expressions& x_;
    std::function<void(const XmlElement&)> writeChildren_;
    bool keepsDisabled_;
    bool usesDirections_ = false;
    std::map<std::pair<QString, QString>, QString> names_;  ///< waypoint variables, by name and position
};

}  // namespace tiller::simulator::pendant
