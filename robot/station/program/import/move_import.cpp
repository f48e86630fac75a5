// SPDX-License-Identifier: MIT
#include "robot/station/program/import/move_import.h"

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/program/import/call_steps.h"
#include "robot/station/program/import/variable_types.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

using project::ProgramStep;

namespace {

constexpr double kSameTcp = 1e-9;  ///< [m, rad]

bool isSame(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() < kSameTcp && (a.rotation - b.rotation).norm() < kSameTcp;
}

}  // namespace

std::optional<Pose> literalPose(const QString& text) {
    const auto values = listLiteral(text, QStringLiteral("p"), 6);
    return values ? std::optional(Pose::fromStdVector(*values)) : std::nullopt;
}
std::optional<Pose> literalTcp(const QString& code) {
    const auto call = parseCall(code);
    return call && call->function == QLatin1String("set_tcp") && call->arguments.size() == 1
               ? literalPose(call->arguments.front().text)
               : std::nullopt;
}

void MoveImport::clear() {
    definitions_.clear();
    used_.clear();
    tcp_ = {};
    required_.reset();
    if (const auto* tool = before_.tooling.tools.find(before_.tooling.activeTool)) {
        required_ = tool->tcpOffset;
    }
}

bool MoveImport::isMove(const ScriptCall& call) {
    static const QStringList kMoves{QStringLiteral("movej"), QStringLiteral("movel"), QStringLiteral("movep"),
                                    QStringLiteral("movec")};
    return kMoves.contains(call.function);
}

std::optional<ProgramStep> MoveImport::step(const ScriptCall& call, const QString& label, QString& reason) {
    return call.function == QLatin1String("movec") ? circleStep(call) : moveStep(call, label, reason);
}

std::optional<MoveImport::Target> MoveImport::poseTarget(const QString& expression) {
    return isExpression(expression) ? std::optional(Target{{}, {}, {}, expression}) : std::nullopt;
}

bool MoveImport::isTcp(const Pose& tcp) {
    if (tcp_.kind == ScriptTcp::Kind::Known) {
        return isSame(tcp_.value, tcp);
    }
    if (tcp_.kind == ScriptTcp::Kind::Initial) {
        // The program requires this TCP; see ProgramScript::tcp.
        required_ = required_.value_or(tcp);
        return isSame(*required_, tcp);
    }
    return false;
}
bool MoveImport::isSameTcp(const ScriptTcp& then) const {
    return tcp_.kind == then.kind && tcp_.kind != ScriptTcp::Kind::Unknown && isSame(tcp_.value, then.value);
}

std::optional<MoveImport::Target> MoveImport::jointsOf(const QString& expression) const {
    if (const auto values = listLiteral(expression, {}, 6)) {
        return Target{JointPositions(*values), {}, {}, {}};
    }
    const auto known = definitions_.constFind(expression);
    if (known == definitions_.constEnd()) {
        return std::nullopt;
    }
    const auto values = listLiteral(known->first, {}, 6);
    return values ? std::optional(Target{JointPositions(*values), expression, {expression}, {}})
                  : std::nullopt;
}

std::optional<MoveImport::Target> MoveImport::jointsOfPose(const QString& expression) {
    if (const auto known = definitions_.constFind(expression); known != definitions_.constEnd()) {
        const auto [definition, then] = *known;
        const auto call = parseCall(definition);
        if (!call || (call->arguments.size() == 1 && !isSameTcp(then))) {
            return std::nullopt;
        }
        auto target = jointsOfPose(definition);
        if (target) {
            target->name = expression;
            target->defined << expression;
        }
        return target;
    }
    const auto call = parseCall(expression);
    if (!call || call->function != QLatin1String("get_forward_kin") || call->arguments.empty() ||
        call->arguments.size() > 2) {
        return std::nullopt;
    }
    const auto values = call->bind({QStringLiteral("q"), QStringLiteral("tcp")});
    if (!values || values->front().isEmpty()) {
        return std::nullopt;
    }
    if (!values->back().isEmpty()) {
        const auto tcp = literalPose(values->back());
        if (!tcp || !isTcp(*tcp)) {
            return std::nullopt;
        }
    } else if (tcp_.kind == ScriptTcp::Kind::Unknown) {
        return std::nullopt;
    }
    return jointsOf(values->front());
}

std::optional<MoveImport::Target> MoveImport::targetOf(const QString& expression, bool joint) {
    if (const auto target = jointsOf(expression)) {
        return target;
    }
    if (const auto target = jointsOfPose(expression)) {
        return target;
    }
    const auto call = parseCall(expression);
    if (joint && call && call->function == QLatin1String("get_inverse_kin")) {
        const auto values = call->bind({QStringLiteral("x"), QStringLiteral("qnear")});
        if (!values || values->front().isEmpty()) {
            return std::nullopt;
        }
        if (values->back().isEmpty()) {
            return poseTarget(values->front());
        }
        auto target = jointsOfPose(values->front());
        const auto near = jointsOf(values->back());
        if (!target || !near || *target->joints != *near->joints) {
            return std::nullopt;
        }
        target->defined << near->defined;
        return target;
    }
    const bool isPose = typeOf(expression, types_) == QLatin1String("pose") ||
                        (definitions_.contains(expression) &&
                         typeOf(definitions_.value(expression).first, types_) == QLatin1String("pose"));
    return !joint || isPose ? poseTarget(expression) : std::nullopt;
}

QUuid MoveImport::waypointFor(const Target& target, const QString& label, const project::Waypoint& values) {
    required_ = required_.value_or(tcp_.kind == ScriptTcp::Kind::Known ? tcp_.value : Pose());
    const Pose tcp = tcp_.kind == ScriptTcp::Kind::Known ? tcp_.value : *required_;
    QString wanted = !label.isEmpty() ? label : target.name;
    if (label.isEmpty() && (wanted.endsWith(QLatin1String("_q")) || wanted.endsWith(QLatin1String("_p")))) {
        wanted.chop(2);
    }
    const auto& known = out_.project.waypoints;
    for (int i = before_.waypoints.size(); i < known.size(); ++i) {
        const project::Waypoint& point = known.at(i);
        if (point.joints == *target.joints && isSame(point.tcpOffset, tcp) &&
            (wanted.isEmpty() || point.name == wanted)) {
            return point.id;
        }
    }
    project::Waypoint point = values;
    point.id = QUuid::createUuid();
    point.name = known.uniqueName(
        wanted.isEmpty() ? QStringLiteral("%1 %2").arg(name_).arg(out_.waypoints + 1) : wanted);
    point.group = name_;
    point.priority = project::TargetKind::Joints;
    point.tcpOffset = tcp;
    point.joints = *target.joints;
    const RobotModelId model = before_.robot.value_or(RobotModelId::UR5e);
    point.pose = kinematics::forwardTcp(robotModel(model).dh, point.joints, tcp);
    out_.project.waypoints.append(point);
    ++out_.waypoints;
    return point.id;
}

void MoveImport::use(const Target& target) {
    for (const QString& name : target.defined) {
        used_.insert(name);
    }
}

std::optional<ProgramStep> MoveImport::moveStep(const ScriptCall& call, const QString& label,
                                                QString& reason) {
    const bool joint = call.function == QLatin1String("movej");
    const bool process = call.function == QLatin1String("movep");
    const QString target = joint ? QStringLiteral("q") : QStringLiteral("pose");
    const auto values = process ? call.bind({target, QStringLiteral("a"), QStringLiteral("v"),
                                             QStringLiteral("r"), QStringLiteral("t")})
                                : call.bind({target, QStringLiteral("a"), QStringLiteral("v"),
                                             QStringLiteral("t"), QStringLiteral("r")});
    if (!values || values->front().isEmpty() || (process && !values->at(4).isEmpty())) {
        return std::nullopt;
    }
    const auto numberAt = [&](qsizetype at, double initial) {
        return values->at(at).isEmpty() ? std::optional(initial) : numberLiteral(values->at(at));
    };
    // Defaults of the controller's functions.
    const auto acceleration = numberAt(1, joint ? 1.4 : 1.2);
    const auto speed = numberAt(2, joint ? 1.05 : 0.25);
    const auto time = process ? std::optional(0.0) : numberAt(3, 0);
    const auto blend = numberAt(process ? 3 : 4, 0);
    if (!acceleration || !speed || !blend || time != 0) {
        reason = ProgramText::tr("the speed, acceleration or blend is not a number, or a time is set");
        return std::nullopt;
    }
    const auto found = targetOf(values->front(), joint);
    if (!found) {
        reason = ProgramText::tr("the target cannot be stored as a waypoint or as the pose of a step");
        return std::nullopt;
    }
    ProgramStep step = makeStep(joint     ? "moveJ"
                                : process ? "moveP"
                                          : "moveL",
                                {{"acceleration", *acceleration}, {"speed", *speed}, {"blend", *blend}});
    if (found->joints) {
        project::Waypoint point;
        point.move = joint ? project::MoveKind::Joint : project::MoveKind::Linear;
        (joint ? point.jointSpeed : point.toolSpeed) = *speed;
        point.blend = *blend;
        use(*found);
        step.fields.insert(QStringLiteral("waypoint"), idOf(waypointFor(*found, label, point)));
    } else {
        step.fields.insert(QStringLiteral("pose"), found->pose);
    }
    return step;
}

std::optional<ProgramStep> MoveImport::circleStep(const ScriptCall& call) {
    const auto values = call.bind({QStringLiteral("pose_via"), QStringLiteral("pose_to"), QStringLiteral("a"),
                                   QStringLiteral("v"), QStringLiteral("r"), QStringLiteral("mode")});
    if (!values || values->at(0).isEmpty() || values->at(1).isEmpty()) {
        return std::nullopt;
    }
    const auto numberAt = [&](qsizetype at, double initial) {
        return values->at(at).isEmpty() ? std::optional(initial) : numberLiteral(values->at(at));
    };
    const auto acceleration = numberAt(2, 1.2);
    const auto speed = numberAt(3, 0.25);
    const auto blend = numberAt(4, 0);
    const auto mode = numberAt(5, 0);
    const auto via = jointsOfPose(values->at(0));
    const auto end = jointsOfPose(values->at(1));
    if (!acceleration || !speed || !blend || (mode != 0 && mode != 1) || !via || !end) {
        return std::nullopt;
    }
    project::Waypoint point;
    point.move = project::MoveKind::Linear;
    point.toolSpeed = *speed;
    use(*via);
    use(*end);
    return makeStep("moveCircle", {{"via", idOf(waypointFor(*via, {}, point))},
                                   {"waypoint", idOf(waypointFor(*end, {}, point))},
                                   {"acceleration", *acceleration},
                                   {"speed", *speed},
                                   {"blend", *blend},
                                   {"orientation", mode == 1 ? "fixed" : "free"}});
}

}  // namespace tiller::program
