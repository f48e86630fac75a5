// SPDX-License-Identifier: MIT
#include "robot/simulator/pendant/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace tiller::simulator::pendant {

namespace {

/// Home position of a new installation: the arm upright [rad].
constexpr const char* kHome = "0, -1.5707963268, 0, -1.5707963268, 0, 0";
constexpr const char* kHomeSpeed = "1.05";         ///< [rad/s]
constexpr const char* kHomeAcceleration = "1.40";  ///< [rad/s2]
constexpr const char* kFarAway =
    "1000.0";  ///< [m] exceeds the workspace; for a direction without a distance limit
constexpr const char* kRetractSpeed = "0.1";          ///< [m/s]
constexpr const char* kForceEndDeceleration = "5.0";  ///< [m/s2]

const XmlElement& positionOf(const XmlElement& holder) {
    const XmlElement* const position = holder.child("position");
    return position == nullptr ? holder : *position;
}

/// Six joint angles, in old or new notation; empty if missing.
QString anglesOf(const XmlElement& position) {
    const XmlElement* const joints = position.child("JointAngles");
    return numberList(joints == nullptr ? position.attribute("joints") : joints->attribute("angles"), 6);
}

/// The TCP with which a position was taught; empty if not in the file.
QString tcpOf(const XmlElement& position) {
    const XmlElement* const tcp = position.child("TCPOffset");
    return tcp == nullptr ? QString() : numberList(tcp->attribute("pose"), 6);
}

QString poseLiteral(const QString& numbers) {
    return "p[" + numbers + ']';
}

bool isSamePose(const QString& a, const QString& b) {
    constexpr double kTolerance = 1e-9;  // [m, rad]
    const auto first = sixNumbers(a), second = sixNumbers(b);
    return first && second &&
           std::equal(first->begin(), first->end(), second->begin(),
                      [](double x, double y) { return std::abs(x - y) < kTolerance; });
}

/// The pose of a taught position as an expression; empty if not in the file.
QString taughtPose(const XmlElement& position, const QString& joints) {
    if (!joints.isEmpty() && !tcpOf(position).isEmpty()) {
        return QStringLiteral("get_forward_kin(%1, %2)").arg(joints, poseLiteral(tcpOf(position)));
    }
    if (const QString pose = numberList(position.attribute("pose"), 6); !pose.isEmpty()) {
        return poseLiteral(pose);
    }
    return joints.isEmpty() ? QString() : QStringLiteral("get_forward_kin(%1)").arg(joints);
}

QString withFrame(const Expressions::Frame& frame, const QString& pose) {
    return frame.kind == Expressions::Frame::Kind::Base
               ? pose
               : QStringLiteral("pose_trans(%1, %2)").arg(frame.script, pose);
}

bool isMotion(const XmlElement& node) {
    return node.is("Waypoint") || node.is("CircleMove") || node.is("gui.program.direction.MoveDirectionNode");
}

/// The first motion node or disabled node of a node and the nodes below it; null if there is none.
const XmlElement* firstMotion(const XmlElement& node) {
    if (isSuppressed(node) || isMotion(node)) {
        return &node;
    }
    const XmlElement* const children = node.child("children");
    for (std::size_t i = 0; children != nullptr && i < children->children.size(); ++i) {
        if (const XmlElement* const found = firstMotion(*children->children[i])) {
            return found;
        }
    }
    return nullptr;
}

}  // namespace

struct Motion::Definer {
    const XmlElement* node = nullptr;  ///< the Move node; null: the waypoint is not below a Move node
    QString function;
    bool ignoresTcp = false;  ///< positions refer to the flange
    bool usesJoints = false;  ///< joint angles define the target, independent of the TCP
    bool isOptimove = false;
};

struct Motion::Until {
    enum class Kind { Distance, Contact, Condition, Arrival };
    const XmlElement* node;
    Kind kind;
    QString distance;   ///< distance of a Distance condition [m]
    QString blend;      ///< blend radius of a Distance condition [m]; empty: stops
    QString condition;  ///< expression of a Condition
};

// ---- waypoints ------------------------------------------------------------------------------------------

void Motion::defineWaypoints(const XmlElement& element) {
    for (const auto& child : element.children) {
        if (isSuppressed(*child) && !keepsDisabled_) {
            continue;
        }
        const QString type = child->attribute("type");
        const XmlElement& position = positionOf(*child);
        const QString angles = child->is("Waypoint") ? anglesOf(position) : QString();
        if (child->is("Waypoint") && type == QLatin1String("Fixed")) {
            const auto [name, isNew] =
                nameFor(*child, QStringList{angles, tcpOf(position), position.attribute("pose")}.join(';'));
            const QString pose = taughtPose(position, angles.isEmpty() ? QString() : name + "_q");
            if (isNew && !angles.isEmpty()) {
                t_.out->line(QStringLiteral("global %1_q = [%2]").arg(name, angles));
            }
            if (isNew && !pose.isEmpty()) {
                t_.out->line(QStringLiteral("global %1_p = %2").arg(name, pose));
            }
            if (!pose.isEmpty()) {
                x_.nameWaypoint(*child, name);
            }
        } else if (child->is("Waypoint") && type == QLatin1String("Relative")) {
            const XmlElement* const from = child->child("relativeFromPosition");
            const QString fromAngles = from == nullptr ? QString() : anglesOf(*from);
            const QString start =
                from == nullptr
                    ? QString()
                    : taughtPose(*from, fromAngles.isEmpty() ? QString() : '[' + fromAngles + ']');
            const QString end = taughtPose(position, angles.isEmpty() ? QString() : '[' + angles + ']');
            if (!start.isEmpty() && !end.isEmpty()) {
                const auto [name, isNew] = nameFor(*child, start + ';' + end);
                if (isNew) {
                    t_.out->line(QStringLiteral("global %1_from_p = %2").arg(name, start));
                    t_.out->line(QStringLiteral("global %1_to_p = %2").arg(name, end));
                }
                x_.nameWaypoint(*child, name);
            }
        }
        defineWaypoints(*child);
    }
}

/// Waypoints with the same name and position share their variables, so that a program can move all of them.
std::pair<QString, bool> Motion::nameFor(const XmlElement& waypoint, const QString& position) {
    const QString wanted = waypoint.has("name") ? waypoint.attribute("name") : QStringLiteral("Waypoint");
    const auto known = names_.find({wanted, position});
    return known != names_.end()
               ? std::pair(known->second, false)
               : std::pair(names_.emplace(std::pair(wanted, position), t_.uniqueName(wanted)).first->second,
                           true);
}

Motion::Definer Motion::definerOf(const XmlElement& node) {
    static const std::map<QString, QString> kFunctions{
        {"MoveJ", "movej"}, {"MoveL", "movel"}, {"MoveP", "movep"}};
    const XmlElement* at = &t_.placeOf(node);
    while (at != nullptr && !at->has("motionType")) {
        at = at->parent;
    }
    Definer found;
    found.node = at;
    if (at != nullptr) {
        const auto function = kFunctions.find(at->attribute("motionType"));
        found.isOptimove = at->isTrue("optimoveEnabled");
        if (function != kFunctions.end() &&
            !(found.isOptimove && function->second == QLatin1String("movep"))) {
            found.function = (found.isOptimove ? QStringLiteral("opti") : QString()) + function->second;
        }
        found.ignoresTcp =
            at->attribute("useActiveTCP") == QLatin1String("false") && at->child("tcp") == nullptr;
        found.usesJoints = at->attribute("positionType") == QLatin1String("JointAngles");
    }
    return found;
}

QString Motion::number(const XmlElement& node, const char* attribute) {
    const QString value = numberList(node.attribute(attribute), 1);
    if (value.isEmpty()) {
        t_.refuse(node, QStringLiteral("%1 is not a number").arg(QLatin1String(attribute)));
        return QStringLiteral("0");
    }
    return value;
}

/// The target of a waypoint as an expression; empty if the node is unfinished or refused.
/// joints  whether the motion accepts joint angles
QString Motion::targetOf(const XmlElement& waypoint, const Definer& move, bool joints) {
    const QString type = waypoint.attribute("type");
    const XmlElement& position = positionOf(waypoint);
    const QString name = x_.waypointName(waypoint);
    if (type == QLatin1String("Relative")) {
        if (name.isEmpty()) {
            t_.unfinished(waypoint, QStringLiteral("the positions are missing"));
            return {};
        }
        return QStringLiteral("pose_add(get_target_tcp_pose(), pose_sub(%1_to_p, %1_from_p))").arg(name);
    }
    const Expressions::Frame frame = move.node == nullptr ? Expressions::Frame() : x_.frame(*move.node);
    if (type == QLatin1String("Variable")) {
        const QString variable = x_.variable(waypoint);
        if (frame.kind != Expressions::Frame::Kind::Base && frame.script.isEmpty()) {
            t_.refuse(
                waypoint,
                QStringLiteral("there is no feature '%1': %2").arg(frame.name, t_.installation.shownName()));
        }
        const QString pose =
            frame.kind == Expressions::Frame::Kind::Base ? variable : withFrame(frame, variable);
        return move.ignoresTcp ? QStringLiteral("pose_trans(%1, get_tcp_offset())").arg(pose) : pose;
    }
    if (type != QLatin1String("Fixed")) {
        t_.refuse(waypoint, QStringLiteral("waypoints of type '%1' are not simulated").arg(type));
        return {};
    }
    if (name.isEmpty()) {
        t_.unfinished(waypoint, QStringLiteral("the position is missing"));
        return {};
    }
    const bool hasJoints = !anglesOf(position).isEmpty();
    // The feature may have been moved since the waypoint was taught. The file contains the feature pose at
    // that time. Without an installation, the feature is assumed to be unchanged.
    const XmlElement* const taughtFrame = waypoint.child("BaseToFeature");
    const QString then = taughtFrame == nullptr ? QString() : numberList(taughtFrame->attribute("pose"), 6);
    const auto feature = t_.installation.features.find(frame.name);
    const bool isMoved = frame.kind == Expressions::Frame::Kind::Other && !frame.script.isEmpty() &&
                         !then.isEmpty() &&
                         (feature->second.isVariable || !isSamePose(feature->second.pose, then));
    // Files of PolyScope 3 contain the pose with the TCP at that time, which is one of the TCPs of the
    // installation.
    const bool isPoseOfInstallation = position.has("pose") && !t_.installation.tcps.empty();
    const bool directly =
        hasJoints && !isMoved && joints &&
        (move.usesJoints || (!move.ignoresTcp && tcpOf(position).isEmpty() && !isPoseOfInstallation));
    if (directly) {
        return name + "_q";
    }
    // If the file does not contain a TCP, the joint angles define the target. Its pose then refers to the
    // current TCP.
    QString pose = name + "_p";
    if (hasJoints && move.ignoresTcp) {
        pose = QStringLiteral("get_forward_kin(%1_q, p[0,0,0,0,0,0])").arg(name);
    } else if (hasJoints && tcpOf(position).isEmpty() && !position.has("pose")) {
        pose = QStringLiteral("get_forward_kin(%1_q)").arg(name);
    }
    if (isMoved) {
        pose =
            QStringLiteral("pose_trans(%1, pose_trans(pose_inv(p[%2]), %3))").arg(frame.script, then, pose);
    }
    if (move.ignoresTcp) {
        pose = QStringLiteral("pose_trans(%1, get_tcp_offset())").arg(pose);
    }
    return joints && move.function.endsWith(QLatin1String("movej")) && hasJoints
               ? QStringLiteral("get_inverse_kin(%1, qnear=%2_q)").arg(pose, name)
               : pose;
}

/// Parameters such as ", a=1.2, v=0.25, r=0.01". A waypoint can override the speed, time and blend of its
/// move.
QString Motion::parametersOf(const XmlElement& waypoint, const Definer& move) {
    const XmlElement* const own = waypoint.child("motionParameters");
    const bool joints = move.function == QLatin1String("movej");
    const auto value = [&](const char* ownName, const char* common) {
        return own != nullptr && own->has(ownName) ? number(*own, ownName) : number(*move.node, common);
    };
    QString text;
    if (move.isOptimove) {
        text = QStringLiteral(", a=%1, v=%2")
                   .arg(value("optiMoveAcceleration", "optiMoveAcceleration"),
                        value("optiMoveSpeed", "optiMoveSpeed"));
    } else if (own != nullptr && own->has("nextMotionTime") && move.function != QLatin1String("movep")) {
        text = QStringLiteral(", t=%1").arg(number(*own, "nextMotionTime"));
    } else {
        text = QStringLiteral(", a=%1, v=%2")
                   .arg(value(joints ? "jointAcceleration" : "cartesianAcceleration", "acceleration"),
                        value(joints ? "jointSpeed" : "cartesianSpeed", "speed"));
    }
    if (own != nullptr && own->has("blendRadius")) {
        text += QStringLiteral(", r=%1").arg(number(*own, "blendRadius"));
    } else if (move.function == QLatin1String("movep")) {
        text += QStringLiteral(", r=%1").arg(processBlend(waypoint, move));
    }
    return text;
}

/// The first motion node or disabled node after a node in the order of the program tree; null if its part of the
/// program ends. A part that repeats continues at its beginning.
const XmlElement* Motion::nextMotion(const XmlElement& node) const {
    for (const XmlElement* at = &t_.placeOf(node); at->parent != nullptr; at = at->parent) {
        const auto& siblings = at->parent->children;
        auto sibling = std::ranges::find(siblings, at, &std::unique_ptr<XmlElement>::get);
        while (++sibling != siblings.end()) {
            if (const XmlElement* const found = firstMotion(**sibling)) {
                return found;
            }
        }
        if (at->is("MainProgram") || at->is("Thread")) {
            return at->attribute("runOnlyOnce") == QLatin1String("false") ? firstMotion(*at) : nullptr;
        }
        if (at->is("SubProgram") || at->is("subprogram")) {
            break;
        }
    }
    return nullptr;
}

/// As in the scripts that the pendant exports, a process move stops at its end if the next motion is the waypoint
/// of a move of another type. Otherwise, it blends, also before a disabled node. At the end of a program, it stops:
/// exported scripts differ, but the arm must reach the last waypoint.
QString Motion::processBlend(const XmlElement& node, const Definer& move) {
    const XmlElement* const next = nextMotion(node);
    const bool stops =
        next == nullptr || (next->is("Waypoint") && definerOf(*next).function != QLatin1String("movep"));
    return !stops && move.node->has("blendRadius") ? number(*move.node, "blendRadius")
                                                   : QStringLiteral("0.0");
}

void Motion::applyTcp(const Definer& move) {
    const XmlElement* const tcp = move.node == nullptr ? nullptr : move.node->child("tcp");
    if (tcp == nullptr || move.node->attribute("useActiveTCP") == QLatin1String("true")) {
        return;
    }
    const XmlElement* const target = tcp->resolved();
    const QString name = target == nullptr ? QString() : target->attribute("referencedName");
    const auto found = t_.installation.tcps.find(name);
    if (found == t_.installation.tcps.end()) {
        t_.refuse(*tcp, QStringLiteral("there is no TCP '%1': %2").arg(name, t_.installation.shownName()));
        return;
    }
    t_.out->line(QStringLiteral("set_tcp(%1)").arg(poseLiteral(found->second)));
}

void Motion::writeMove(const XmlElement& node) {
    t_.label(node, node.attribute("motionType"));
    if (definerOf(node).function.isEmpty()) {
        t_.refuse(node, QStringLiteral("motion '%1' is not simulated").arg(node.attribute("motionType")));
        return;
    }
    writeChildren_(node);
}

void Motion::labelWaypoint(const XmlElement& waypoint) {
    const bool isVariable = waypoint.attribute("type") == QLatin1String("Variable");
    const XmlElement* const variable = isVariable ? waypoint.target("variable") : nullptr;
    const XmlElement& named = variable == nullptr ? waypoint : *variable;
    t_.label(waypoint, named.attribute(named.has("featureName") ? "featureName" : "name"));
}

void Motion::writeWaypoint(const XmlElement& node) {
    const Definer move = definerOf(node);
    if (move.function.isEmpty()) {
        t_.refuse(node, QStringLiteral("this waypoint is not inside a Move node that can be simulated"));
        return;
    }
    labelWaypoint(node);
    const QString target = targetOf(node, move, true);
    if (target.isEmpty()) {
        return;
    }
    applyTcp(move);
    const QString statement = move.function + '(' + target + parametersOf(node, move) + ')';
    if (const std::vector<Until> untils = untilsOf(node, true); untils.empty()) {
        t_.out->line(statement);
    } else {
        writeWatchedMove(node, statement, untils);
    }
}

void Motion::writeCircle(const XmlElement& node) {
    static const std::map<QString, int> kModes{{"UNCONSTRAINED", 0}, {"FIXED", 1}};
    const Definer move = definerOf(node);
    const auto mode = kModes.find(node.attribute("OrientationMode"));
    std::vector<const XmlElement*> points;
    if (const XmlElement* const children = node.child("children")) {
        for (const auto& child : children->children) {
            if (child->is("Waypoint")) {
                points.push_back(&t_.nodeAt(*child));
            } else if (!isSuppressed(*child) && !child->is("Comment")) {
                t_.refuse(*child, QStringLiteral("this node is not simulated inside a Circle node"));
            }
        }
    }
    t_.label(node, QStringLiteral("CircleMove"));
    if (move.function.isEmpty() || move.isOptimove || mode == kModes.end()) {
        t_.refuse(node, QStringLiteral("this kind of circle is not simulated"));
        return;
    }
    if (points.size() != 2) {
        t_.unfinished(node, QStringLiteral("a circle must contain exactly two waypoints"));
        return;
    }
    applyTcp(move);
    for (const XmlElement* const point : points) {
        labelWaypoint(*point);
    }
    const QString via = targetOf(*points[0], move, false);
    const QString end = targetOf(*points[1], move, false);
    t_.out->line(QStringLiteral("movec(%1, %2, a=%3, v=%4, r=%5, mode=%6)")
                     .arg(via, end, number(*move.node, "acceleration"), number(*move.node, "speed"),
                          processBlend(node, move))
                     .arg(mode->second));
}

/// Uses the home position of the node, of the installation, or of a new installation, in this order.
void Motion::writeHome(const XmlElement& node) {
    t_.label(node, QStringLiteral("Home"));
    QString angles = anglesOf(positionOf(node));
    if (angles.isEmpty()) {
        angles = t_.installation.home.isEmpty() ? QLatin1String(kHome) : t_.installation.home;
    }
    const auto value = [&](const char* attribute, const char* otherwise) {
        return node.has(attribute) ? number(node, attribute) : QLatin1String(otherwise);
    };
    const QString how = node.attribute("positionOptionType") == QLatin1String("TIME")
                            ? QStringLiteral("t=%1").arg(number(node, "nextMotionTime"))
                            : QStringLiteral("a=%1, v=%2")
                                  .arg(value("acceleration", kHomeAcceleration), value("speed", kHomeSpeed));
    t_.out->line(QStringLiteral("movej([%1], %2)").arg(angles, how));
}

// ---- directions and Until nodes -------------------------------------------------------------------------

void Motion::defineDirections(ScriptText& out) {
    for (const char* const line : {
             "def tiller_towards(frame, direction, distance):",
             "  local size = norm([direction[0], direction[1], direction[2]])",
             "  local from_p = get_target_waypoint()",
             "  if size < 1e-6:",
             "    return from_p",
             "  end",
             "  local step = distance / size",
             "  local turn = p[0, 0, 0, frame[3], frame[4], frame[5]]",
             "  local way = pose_trans(turn, p[step * direction[0], step * direction[1], step * "
             "direction[2], "
             "0, 0, 0])",
             "  return p[from_p[0] + way[0], from_p[1] + way[1], from_p[2] + way[2], from_p[3], from_p[4], "
             "from_p[5]]",
             "end",
             "def tiller_back(pose, speed, distance):",
             "  local size = norm([speed[0], speed[1], speed[2]])",
             "  if size < 1e-6:",
             "    return pose",
             "  end",
             "  local step = distance / size",
             "  return p[pose[0] - step * speed[0], pose[1] - step * speed[1], pose[2] - step * speed[2], "
             "pose[3], "
             "pose[4], pose[5]]",
             "end",
         }) {
        out.line(QLatin1String(line));
    }
}

std::vector<Motion::Until> Motion::untilsOf(const XmlElement& node, bool ofWaypoint) {
    std::vector<Until> untils;
    const XmlElement* const children = node.child("children");
    if (children == nullptr) {
        return untils;
    }
    for (const auto& child : children->children) {
        const QString type = child->attribute("type");
        if (isSuppressed(*child) || child->is("Comment")) {
            t_.out->mark(NodeMark::Kind::Omitted, t_.numberOf(*child),
                         QStringLiteral("disabled nodes and comments are not imported at this position"));
            continue;
        }
        if (!child->is("Until")) {
            t_.refuse(*child,
                      QStringLiteral("this node is not simulated inside a Direction or Waypoint node"));
        } else if (type == QLatin1String("DISTANCE") && !ofWaypoint) {
            const XmlElement* const distance = child->child("Distance");
            const QString metres = distance == nullptr ? QString() : numberList(distance->text, 1);
            const bool blends = child->attribute("distanceNodeType") == QLatin1String("BLEND");
            const XmlElement* const parameters = child->child("motionParameters");
            if (metres.isEmpty()) {
                t_.unfinished(*child, QStringLiteral("the distance is missing"));
            }
            untils.push_back(
                {child.get(),
                 Until::Kind::Distance,
                 metres,
                 blends && parameters != nullptr ? number(*parameters, "blendRadius") : QString(),
                 {}});
        } else if (type == QLatin1String("TOOL_CONTACT_DETECTION")) {
            untils.push_back({child.get(), Until::Kind::Contact, {}, {}, {}});
        } else if (type == QLatin1String("REACHED_WAYPOINT") && ofWaypoint) {
            untils.push_back({child.get(), Until::Kind::Arrival, {}, {}, {}});
        } else if (type == QLatin1String("EXPRESSION") || (type.isEmpty() && child->child("expression"))) {
            untils.push_back({child.get(),
                              Until::Kind::Condition,
                              {},
                              {},
                              x_.in(*child, "expression", QStringLiteral("the condition")).script});
        } else if (child->child("pin") != nullptr && child->child("digitalValue") != nullptr) {
            const Expressions::Signal signal = x_.signal(*child);
            const bool high = child->child("digitalValue")->text.trimmed() == QLatin1String("1");
            untils.push_back({child.get(),
                              Until::Kind::Condition,
                              {},
                              {},
                              QStringLiteral("%1 == %2").arg(signal.read, high ? "True" : "False")});
        } else if (type == QLatin1String("NONE")) {
            t_.unfinished(*child, QStringLiteral("the condition is missing"));
        } else {
            t_.refuse(*child, QStringLiteral("the Until condition '%1' is not simulated").arg(type));
        }
    }
    return untils;
}

void Motion::writeDirection(const XmlElement& node) {
    static const std::map<QString, std::pair<const char*, const char*>> kAxes{
        {"XPlus", {"[1,0,0]", "X+"}},   {"XMinus", {"[-1,0,0]", "X-"}}, {"YPlus", {"[0,1,0]", "Y+"}},
        {"YMinus", {"[0,-1,0]", "Y-"}}, {"ZPlus", {"[0,0,1]", "Z+"}},   {"ZMinus", {"[0,0,-1]", "Z-"}}};
    const Definer move = definerOf(node);
    if (move.node == nullptr) {
        t_.refuse(node, QStringLiteral("this node must be inside a Move node"));
        return;
    }
    const Expressions::Frame frame = x_.frame(node, move.node);
    if (frame.script.isEmpty()) {
        t_.refuse(
            node,
            QStringLiteral("there is no feature '%1': %2").arg(frame.name, t_.installation.shownName()));
        return;
    }
    const auto axis = kAxes.find(node.attribute("selectedDirection"));
    QString direction, shown;
    if (axis != kAxes.end()) {
        direction = QLatin1String(axis->second.first);
        shown = ' ' + QLatin1String(axis->second.second);
    } else {
        direction = x_.in(node, "expression", QStringLiteral("the direction")).script;
    }
    t_.label(node, QStringLiteral("Direction: %1%2").arg(frame.name, shown));
    // The node can override the tool speed and acceleration of its move.
    const QStringList own = node.attribute("toolParams").split(',');
    const bool hasOwn = own.size() == 2;
    const QString speed = hasOwn ? numberList(own[0], 1) : number(*move.node, "speed");
    const QString acceleration = hasOwn ? numberList(own[1], 1) : number(*move.node, "acceleration");
    if (speed.isEmpty() || acceleration.isEmpty()) {
        t_.refuse(node, QStringLiteral("the tool speed or the tool acceleration is not a number"));
        return;
    }
    const std::vector<Until> untils = untilsOf(node, false);
    if (untils.empty()) {
        t_.unfinished(node, QStringLiteral("there is no Until node"));
        return;
    }
    QString distance = QLatin1String(kFarAway), blend;
    bool onlyDistance = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Until& until : untils) {
        onlyDistance = onlyDistance && until.kind == Until::Kind::Distance;
        if (until.kind == Until::Kind::Distance && until.distance.toDouble() < nearest) {
            nearest = until.distance.toDouble();
            distance = until.distance;
            blend = until.blend;
        }
    }
    usesDirections_ = true;
    applyTcp(move);
    const QString statement = QStringLiteral("movel(tiller_towards(%1, %2, %3), a=%4, v=%5%6)")
                                  .arg(frame.script, direction, distance, acceleration, speed,
                                       blend.isEmpty() ? QString() : QStringLiteral(", r=%1").arg(blend));
    if (onlyDistance && untils.size() == 1) {
        t_.out->line(statement);
        writeActions(untils.front());
        return;
    }
    writeWatchedMove(node, statement, untils);
}

/// A thread moves the arm. The first condition that becomes true stops the thread.
void Motion::writeWatchedMove(const XmlElement& node, const QString& statement,
                              const std::vector<Until>& untils) {
    const QString name = t_.uniqueName(QStringLiteral("until_%1").arg(t_.nextNumber()));
    const QString arrived = name + "_arrived", thread = name + "_thread";
    ScriptText& out = *t_.out;
    out.line(QStringLiteral("global %1 = False").arg(arrived));
    out.line(QStringLiteral("thread %1():").arg(name));
    out.indent();
    out.line(statement);
    out.line(arrived + QStringLiteral(" = True"));
    out.outdent();
    out.line(QStringLiteral("end"));
    out.line(QStringLiteral("%1 = run %2()").arg(thread, name));
    out.line(QStringLiteral("while True:"));
    out.indent();
    bool endsByArrival = false;
    for (const Until& until : untils) {
        writeUntil(until, thread, arrived);
        endsByArrival =
            endsByArrival || until.kind == Until::Kind::Distance || until.kind == Until::Kind::Arrival;
    }
    if (node.is("Waypoint") && !endsByArrival) {
        out.line(QStringLiteral("if %1:").arg(arrived));
        out.line(QStringLiteral("  break"));
        out.line(QStringLiteral("end"));
    }
    out.line(QStringLiteral("sync()"));
    out.outdent();
    out.line(QStringLiteral("end"));
}

void Motion::writeUntil(const Until& until, const QString& thread, const QString& arrived) {
    ScriptText& out = *t_.out;
    const auto deceleration = [&](const char* attribute) {
        return until.node->has(attribute) ? number(*until.node, attribute) : QStringLiteral("3.0");
    };
    switch (until.kind) {
        case Until::Kind::Distance:
        case Until::Kind::Arrival:
            out.line(QStringLiteral("if %1:").arg(arrived));
            out.indent();
            break;
        case Until::Kind::Condition:
            out.line(QStringLiteral("if (%1):").arg(until.condition));
            out.indent();
            out.line(QStringLiteral("kill %1").arg(thread));
            out.line(QStringLiteral("stopl(%1)").arg(deceleration("deceleration")));
            break;
        case Until::Kind::Contact: {
            const QString speed = thread + "_speed", steps = thread + "_steps", contact = thread + "_contact";
            const QString a = deceleration("decelerationAcceleration");
            out.line(QStringLiteral("%1 = get_target_tcp_speed()").arg(speed));
            out.line(QStringLiteral("%1 = tool_contact(direction=%2)").arg(steps, speed));
            out.line(QStringLiteral("if (%1 > 0):").arg(steps));
            out.indent();
            out.line(QStringLiteral("kill %1").arg(thread));
            out.line(QStringLiteral("stopl(%1)").arg(a));
            out.line(QStringLiteral("%1 = get_forward_kin(get_actual_joint_positions_history(%2))")
                         .arg(contact, steps));
            if (until.node->has("retraction") && number(*until.node, "retraction").toDouble() != 0) {
                // Move back along the approach path.
                out.line(QStringLiteral("%1 = tiller_back(%1, %2, %3)")
                             .arg(contact, speed, number(*until.node, "retraction")));
                usesDirections_ = true;
            }
            out.line(QStringLiteral("movel(%1, a=%2, v=%3)").arg(contact, a, QLatin1String(kRetractSpeed)));
            break;
        }
    }
    writeActions(until);
    out.line(QStringLiteral("break"));
    out.outdent();
    out.line(QStringLiteral("end"));
}

void Motion::writeActions(const Until& until) {
    QString kind = until.node->attribute("type").toLower();
    t_.label(*until.node,
             QStringLiteral("Until (%1)").arg(kind.isEmpty() ? QStringLiteral("expression") : kind));
    if (until.node->attribute("allowActions") != QLatin1String("false")) {
        writeChildren_(*until.node);
    }
}

// ---- force ----------------------------------------------------------------------------------------------

void Motion::writeForce(const XmlElement& node) {
    static const std::map<QString, int> kTypes{{"Simple", 2}, {"Frame", 2}, {"Point", 1}, {"Motion", 3}};
    const auto type = kTypes.find(node.attribute("type"));
    t_.label(node, QStringLiteral("Force"));
    if (type == kTypes.end()) {
        t_.refuse(node, QStringLiteral("force of type '%1' is not simulated").arg(node.attribute("type")));
        return;
    }
    const auto list = [&](const char* child) {
        const XmlElement* const element = node.child(child);
        const QString numbers = element == nullptr ? QString() : numberList(element->attribute("value"), 6);
        if (numbers.isEmpty()) {
            t_.unfinished(node, QStringLiteral("%1 is missing").arg(QLatin1String(child)));
        }
        return numbers.isEmpty() ? QStringLiteral("0,0,0,0,0,0").split(',') : numbers.split(',');
    };
    const QStringList selection = list("selection"), wrench = list("wrench");
    const QStringList speeds = list("limitsForce"), deviations = list("limitsMotion");
    const Expressions::Frame frame = x_.frame(node);
    if (frame.script.isEmpty()) {
        t_.refuse(
            node,
            QStringLiteral("there is no feature '%1': %2").arg(frame.name, t_.installation.shownName()));
        return;
    }
    QStringList limits;  // speed for compliant axes, deviation for the other axes
    for (qsizetype i = 0; i < 6; ++i) {
        limits << (selection[i].toDouble() != 0 ? speeds[i] : deviations[i]).trimmed();
    }
    ScriptText& out = *t_.out;
    out.line(QStringLiteral("sleep(0.02)"));
    if (!t_.software.isCb3()) {
        out.line(QStringLiteral("zero_ftsensor()"));
    }
    out.line(QStringLiteral("force_mode(%1, [%2], [%3], %4, [%5])")
                 .arg(frame.script, selection.join(','), wrench.join(','))
                 .arg(type->second)
                 .arg(limits.join(QStringLiteral(", "))));
    writeChildren_(node);
    out.line(QStringLiteral("end_force_mode()"));
    out.line(QStringLiteral("stopl(%1)").arg(QLatin1String(kForceEndDeceleration)));
}

}  // namespace tiller::simulator::pendant
