// SPDX-License-Identifier: MIT
#include "robot/control/arm_queries.h"

#include <algorithm>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/versions.h"
#include "robot/kinematics/arm_kinematics.h"

namespace tiller::control {

namespace {

constexpr SoftwareVersion kNever{};
constexpr std::size_t kInOnePackage = 6;

std::array<double, 12> twelve(const std::array<double, 6>& first, const std::array<double, 6>& second) {
    std::array<double, 12> out{};
    std::copy(first.begin(), first.end(), out.begin());
    std::copy(second.begin(), second.end(), out.begin() + 6);
    return out;
}

Result<Pose> poseOf(const Result<Answer>& answer) {
    return answer ? Result<Pose>(Pose::fromArray(answer->numbers)) : answer.error();
}

Result<bool> yesOf(const Result<Answer>& answer) {
    return answer ? Result<bool>(answer->whole != 0) : answer.error();
}

constexpr char kCheckLimits[] = "check the safety limits";

Result<bool> isSafe(Controller& controller, RequestKind kind, const std::array<double, 6>& numbers,
                    const Deadline& deadline) {
    auto& d = ControllerAccess::of(controller);
    const QString context = QString::fromLatin1(kCheckLimits);
    if (const auto known = d.program.knows("is_within_safety_limits", context); !known) {
        return known.error();
    }
    return yesOf(d.requests.request(kind, 0, numbers, context, deadline));
}

Result<Answer> solve(Controller& controller, const Pose& pose, const InverseOptions& options,
                     const Deadline& deadline) {
    constexpr auto kContext = "inverse kinematics";
    auto& d = ControllerAccess::of(controller);
    const ArmLimits arm = d.program.arm();
    constexpr double kLargestError = 0.1;
    ArgumentCheck check =
        ArgumentCheck(kContext)
            .pose("tcpPose", pose)
            .positive("maxPositionError", options.maxPositionError, kLargestError, "m", "mm")
            .positive("maxOrientationError", options.maxOrientationError, kLargestError, "rad", "degrees");
    if (options.near) {
        check.joints("near", *options.near, arm);
    }
    if (!check.ok()) {
        return check.error();
    }
    const QString context = QString::fromLatin1(kContext);
    const ControllerStatus status = d.loop.status();
    const JointPositions near = options.near.value_or(JointPositions(status.q));
    // In older software, a query for an unreachable pose ends the program. Such a query is not sent.
    if (!d.program.needs({5, 10, 0, 0}, {3, 15, 0, 0}, context) &&
        !kinematics::inverseNearest(arm.dh, pose, Pose::fromArray(status.tcpOffset), near)) {
        return Error{ErrorCode::NoSolution, context, {}};
    }
    const InverseOptions usual;
    const bool exact = options.maxPositionError != usual.maxPositionError ||
                       options.maxOrientationError != usual.maxOrientationError;
    const std::int32_t given = (options.near ? 1 : 0) + (exact ? 2 : 0);
    const auto numbers = twelve(pose.array(), near.array());
    if (!exact) {
        const std::size_t count = options.near ? numbers.size() : kInOnePackage;
        return d.requests.request(RequestKind::InverseKinematics, given, std::span(numbers).first(count),
                                  context, deadline);
    }
    std::array<double, 14> all{};
    std::copy(numbers.begin(), numbers.end(), all.begin());
    all[12] = options.maxPositionError;
    all[13] = options.maxOrientationError;
    return d.requests.request(RequestKind::InverseKinematics, given, all, context, deadline);
}

}  // namespace

Result<JointPositions> ArmQueries::inverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                                     const Deadline& deadline) {
    const auto answer = solve(*controller_, tcpPose, options, deadline);
    return answer ? Result<JointPositions>(JointPositions(answer->numbers)) : answer.error();
}

Result<bool> ArmQueries::hasInverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                              const Deadline& deadline) {
    const auto answer = solve(*controller_, tcpPose, options, deadline);
    if (!answer && answer.error().code == ErrorCode::NoSolution) {
        return false;
    }
    return answer ? Result<bool>(true) : answer.error();
}

Result<Pose> ArmQueries::forwardKinematics(const std::optional<JointPositions>& q,
                                           const std::optional<Pose>& tcp, const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    ArgumentCheck check("forward kinematics");
    if (q) {
        check.joints("q", *q, d.program.arm());
    }
    if (tcp) {
        check.pose("tcp", *tcp);
    }
    if (!check.ok()) {
        return check.error();
    }
    const auto numbers = twelve(q.value_or(JointPositions()).array(), tcp.value_or(Pose()).array());
    return poseOf(d.requests.request(RequestKind::ForwardKinematics, (q ? 1 : 0) + (tcp ? 2 : 0),
                                     std::span(numbers).first(tcp ? numbers.size() : kInOnePackage),
                                     QStringLiteral("forward kinematics"), deadline));
}

Result<bool> ArmQueries::isWithinSafetyLimits(const Pose& tcpPose, const Deadline& deadline) {
    const ArgumentCheck check = ArgumentCheck(kCheckLimits).pose("tcpPose", tcpPose);
    return check.ok() ? isSafe(*controller_, RequestKind::PoseIsSafe, tcpPose.array(), deadline)
                      : check.error();
}

Result<bool> ArmQueries::isWithinSafetyLimits(const JointPositions& q, const Deadline& deadline) {
    // Joint positions outside their range are valid arguments; the result is false.
    const ArgumentCheck check = ArgumentCheck(kCheckLimits).finite("q", q.values.data(), 6);
    return check.ok() ? isSafe(*controller_, RequestKind::JointsAreSafe, q.array(), deadline) : check.error();
}

Result<JointTorques> ArmQueries::jointTorques(const Deadline& deadline) {
    const auto answer = ControllerAccess::of(*controller_)
                            .requests.request(RequestKind::JointTorques, 0, {},
                                              QStringLiteral("read joint torques"), deadline);
    return answer ? Result<JointTorques>(JointTorques(answer->numbers)) : answer.error();
}

Result<bool> ArmQueries::isSteady(const Deadline& deadline) {
    return yesOf(ControllerAccess::of(*controller_)
                     .requests.request(RequestKind::IsSteady, 0, {}, QStringLiteral("check for standstill"),
                                       deadline));
}

Result<int> ArmQueries::toolContact(const Twist& direction, const Deadline& deadline) {
    const Vector6 values = direction.vector();
    const ArgumentCheck check = ArgumentCheck("check for tool contact").finite("direction", values.data(), 6);
    if (!check.ok()) {
        return check.error();
    }
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("check for tool contact");
    if (const auto known = d.program.needs(kContactSince, kNever, context); !known) {
        return known.error();
    }
    const auto answer =
        d.requests.request(RequestKind::ToolContact, 0, {values.data(), 6}, context, deadline);
    return answer ? Result<int>(answer->whole) : answer.error();
}

Result<Pose> ArmQueries::targetWaypoint(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("read the target waypoint");
    if (const auto known = d.program.needs({5, 3, 0, 0}, kNever, context); !known) {
        return known.error();
    }
    return poseOf(d.requests.request(RequestKind::TargetWaypoint, 0, {}, context, deadline));
}

Result<JointPositions> ArmQueries::jointPositionsHistory(int steps, const Deadline& deadline) {
    // A query beyond the history of the controller would end the control program. The length of the history
    // is not documented.
    constexpr int kSurelyRemembered = 2000;
    const QString context = QStringLiteral("read the joint position history");
    if (steps < 0 || steps > kSurelyRemembered) {
        return Error{
            ErrorCode::LimitExceeded, context,
            QStringLiteral("steps: %1 is outside the range 0 to %2").arg(steps).arg(kSurelyRemembered)};
    }
    auto& d = ControllerAccess::of(*controller_);
    if (const auto known = d.program.needs(kContactSince, kNever, context); !known) {
        return known.error();
    }
    const auto answer = d.requests.request(RequestKind::JointHistory, steps, {}, context, deadline);
    return answer ? Result<JointPositions>(JointPositions(answer->numbers)) : answer.error();
}

Result<double> ArmQueries::stepTime(const Deadline& deadline) {
    const auto answer =
        ControllerAccess::of(*controller_)
            .requests.request(RequestKind::StepTime, 0, {}, QStringLiteral("read the step time"), deadline);
    return answer ? Result<double>(answer->numbers[0]) : answer.error();
}

Result<Pose> ArmQueries::tcpOffset(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("read the TCP offset");
    if (const auto known = d.program.needs(kESeries, {3, 6, 0, 0}, context); !known) {
        return known.error();
    }
    return poseOf(d.requests.request(RequestKind::TcpOffset, 0, {}, context, deadline));
}

Result<Pose> ArmQueries::flangePose(const Deadline& deadline) {
    return poseOf(ControllerAccess::of(*controller_)
                      .requests.request(RequestKind::FlangePose, 0, {},
                                        QStringLiteral("read the flange pose"), deadline));
}

Result<int> ArmQueries::freedriveStatus(const Deadline& deadline) {
    auto& d = ControllerAccess::of(*controller_);
    const QString context = QStringLiteral("read the freedrive status");
    if (const auto known = d.program.needs({5, 10, 0, 0}, kNever, context); !known) {
        return known.error();
    }
    const auto answer = d.requests.request(RequestKind::FreedriveStatus, 0, {}, context, deadline);
    return answer ? Result<int>(answer->whole) : answer.error();
}

}  // namespace tiller::control
