// SPDX-License-Identifier: MIT
#include "robot/control/motion_path.h"

#include <QStringList>

#include "robot/control/detail/argument_check.h"

namespace tiller::control {

namespace {

QString number(double value) {
    constexpr int kDigits = 17;  // full precision of a double
    return QString::number(value, 'g', kDigits);
}

QString list(const std::array<double, 6>& values) {
    QStringList parts;
    for (const double value : values) {
        parts.append(number(value));
    }
    return QStringLiteral("[%1]").arg(parts.join(QStringLiteral(", ")));
}

QString text(const PathEntry::Target& target) {
    if (const auto* q = std::get_if<JointPositions>(&target)) {
        return list(q->array());
    }
    return QLatin1Char('p') + list(std::get<Pose>(target).array());
}

void check(ArgumentCheck& arguments, const char* name, const PathEntry::Target& target) {
    // The widest limits of all arms. The limits of the connected arm are checked when they are known.
    static const ArmLimits kWidest = ArmLimits::of(robotModel(RobotModelId::UR3e));
    if (const auto* q = std::get_if<JointPositions>(&target)) {
        arguments.joints(name, *q, kWidest);
    } else {
        arguments.pose(name, std::get<Pose>(target));
    }
}

}  // namespace

Result<void> checkPath(const MotionPath& path) {
    const QString context = QStringLiteral("check a path");
    if (path.empty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("path: the path is empty")};
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PathEntry& entry = path[i];
        ArgumentCheck arguments("check a path");
        check(arguments, "target", entry.target);
        const bool joint = entry.kind == PathEntry::Kind::MoveJ;
        constexpr double kJointSpeed = 3.3415926;  // [rad/s], fastest arm
        arguments.positive("speed", entry.speed, joint ? kJointSpeed : kHighestToolSpeed,
                           joint ? "rad/s" : "m/s", joint ? "deg/s" : "mm/s");
        arguments.positive("acceleration", entry.acceleration,
                           joint ? kJointAccelerationLimit : kHighestToolAcceleration,
                           joint ? "rad/s2" : "m/s2", joint ? "deg/s2" : "mm/s2");
        arguments.range("blend", entry.blend, 0, kHighestBlend, "m");
        if (entry.kind == PathEntry::Kind::MoveC && entry.via) {
            check(arguments, "via", *entry.via);
        }
        Error error = arguments.error();
        if (error.code == ErrorCode::None &&
            (entry.kind == PathEntry::Kind::MoveC) != entry.via.has_value()) {
            error = {ErrorCode::InvalidArgument, context,
                     entry.via ? QStringLiteral("via: only MoveC has a via point")
                               : QStringLiteral("via: MoveC requires a via point")};
        }
        if (error.code != ErrorCode::None) {
            error.controllerMessage.prepend(QStringLiteral("entry %1, ").arg(i + 1));
            return error;
        }
    }
    return {};
}

QString pathMove(const PathEntry& entry) {
    const QString common = QStringLiteral("a=%1, v=%2, r=%3")
                               .arg(number(entry.acceleration), number(entry.speed), number(entry.blend));
    const QString target = text(entry.target);
    switch (entry.kind) {
        case PathEntry::Kind::MoveJ:
            return QStringLiteral("movej(%1, %2)").arg(target, common);
        case PathEntry::Kind::MoveL:
            return QStringLiteral("movel(%1, %2)").arg(target, common);
        case PathEntry::Kind::MoveP:
            return QStringLiteral("movep(%1, %2)").arg(target, common);
        case PathEntry::Kind::MoveC:
            return QStringLiteral("movec(%1, %2, %3, mode=%4)")
                .arg(text(entry.via.value_or(entry.target)), target, common)
                .arg(entry.fixedToArc ? 1 : 0);
    }
    return {};
}

}  // namespace tiller::control
