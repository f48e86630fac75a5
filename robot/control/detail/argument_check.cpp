// SPDX-License-Identifier: MIT
#include "robot/control/detail/argument_check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tiller::control {

namespace {

// Larger values must be in a wrong unit, because no robot rotates or reaches that far.
constexpr double kSurelyDegrees = 25.0;                           // [rad] of a joint
constexpr double kSurelyDegreesOfRotation = 6.2831853072 * 1.05;  // [rad] of a rotation vector
constexpr double kSurelyMillimetres = 5.0;                        // [m]
constexpr double kRounding = 1e-9;

constexpr std::array<const char*, 6> kPoseParts = {"x", "y", "z", "rx", "ry", "rz"};

QString degrees(double radians) {
    constexpr double kDegreesPerRadian = 57.29577951308232;
    return QString::number(radians * kDegreesPerRadian, 'f', 1);
}

QString text(const char* literal) {
    return QString::fromLatin1(literal);
}

QString aboveCap(const char* name, double speed, double cap) {
    const QString excess =
        cap < kHighestToolSpeed
            ? QStringLiteral("%1: %2 m/s exceeds the speed cap of %3 m/s; change the cap with setSpeedCap()")
            : QStringLiteral("%1: %2 m/s exceeds the maximum of %3 m/s");
    return excess.arg(text(name)).arg(speed).arg(cap);
}

}  // namespace

double highestJointSpeed(const ArmLimits& arm) {
    return *std::max_element(arm.maxSpeed.begin(), arm.maxSpeed.end());
}

void ArgumentCheck::refuse(ErrorCode code, const QString& message) {
    if (ok()) {
        error_ = {code, text(context_), message};
    }
}

bool ArgumentCheck::checkFinite(const char* name, const char* part, double value) {
    if (std::isfinite(value)) {
        return true;
    }
    refuse(ErrorCode::InvalidArgument, QStringLiteral("%1: %2 is not a number").arg(text(name), text(part)));
    return false;
}

ArgumentCheck& ArgumentCheck::joints(const char* name, const JointPositions& q, const ArmLimits& arm) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (!checkFinite(name, kJointNames[i], q[joint])) {
            return *this;
        }
        if (std::abs(q[joint]) > kSurelyDegrees) {
            refuse(ErrorCode::InvalidArgument,
                   QStringLiteral("%1: %2 is %3 rad. Was the value given in degrees?")
                       .arg(text(name), text(kJointNames[i]))
                       .arg(q[joint]));
            return *this;
        }
    }
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (q[joint] < arm.minPosition[i] || q[joint] > arm.maxPosition[i]) {
            refuse(ErrorCode::LimitExceeded,
                   QStringLiteral("%1: %2 at %3 deg is outside the range %4 to %5 deg")
                       .arg(text(name), text(kJointNames[i]), degrees(q[joint]), degrees(arm.minPosition[i]),
                            degrees(arm.maxPosition[i])));
            return *this;
        }
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::pose(const char* name, const Pose& pose) {
    const auto values = pose.array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!checkFinite(name, kPoseParts[i], values[i])) {
            return *this;
        }
    }
    if (pose.rotation.norm() > kSurelyDegreesOfRotation) {
        refuse(
            ErrorCode::InvalidArgument,
            QStringLiteral("%1: the length of the rotation vector is %2 rad. Was the value given in degrees?")
                .arg(text(name))
                .arg(pose.rotation.norm()));
    }
    return offset(name, pose.position, kSurelyMillimetres);
}

ArgumentCheck& ArgumentCheck::jointSpeeds(const char* name, const JointVelocities& qd, const ArmLimits& arm) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (!checkFinite(name, kJointNames[i], qd[joint])) {
            return *this;
        }
        if (std::abs(qd[joint]) > arm.maxSpeed[i] + kRounding) {
            refuse(ErrorCode::LimitExceeded,
                   QStringLiteral("%1: %2 at %3 rad/s exceeds the maximum of %4 rad/s")
                       .arg(text(name), text(kJointNames[i]))
                       .arg(qd[joint])
                       .arg(arm.maxSpeed[i]));
            return *this;
        }
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::torques(const char* name, const JointTorques& torques, const ArmLimits& arm) {
    for (int joint = 0; joint < kJointCount; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (!checkFinite(name, kJointNames[i], torques[joint])) {
            return *this;
        }
        if (std::abs(torques[joint]) > arm.maxTorque[i] + kRounding) {
            refuse(ErrorCode::LimitExceeded, QStringLiteral("%1: %2 at %3 Nm exceeds the maximum of %4 Nm")
                                                 .arg(text(name), text(kJointNames[i]))
                                                 .arg(torques[joint])
                                                 .arg(arm.maxTorque[i]));
            return *this;
        }
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::twist(const char* name, const Twist& twist, double cap) {
    const Vector6 values = twist.vector();
    for (int i = 0; i < kJointCount; ++i) {
        if (!checkFinite(name, kPoseParts[static_cast<std::size_t>(i)], values[i])) {
            return *this;
        }
    }
    if (twist.linear.norm() > kSurelyMillimetres) {
        refuse(ErrorCode::InvalidArgument,
               QStringLiteral("%1: %2 m/s exceeds the maximum of %3 m/s. Was the value given in mm/s?")
                   .arg(text(name))
                   .arg(twist.linear.norm())
                   .arg(cap));
    } else if (twist.linear.norm() > cap + kRounding) {
        refuse(ErrorCode::LimitExceeded, aboveCap(name, twist.linear.norm(), cap));
    }
    constexpr double kFastestRotation = 12.0;  // [rad/s], above the speed of all wrist joints
    if (twist.angular.norm() > kFastestRotation) {
        refuse(ErrorCode::InvalidArgument,
               QStringLiteral("%1: the angular speed is %2 rad/s. Was the value given in deg/s?")
                   .arg(text(name))
                   .arg(twist.angular.norm()));
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::offset(const char* name, const Eigen::Vector3d& metres, double largest) {
    for (int i = 0; i < 3; ++i) {
        if (!checkFinite(name, kPoseParts[static_cast<std::size_t>(i)], metres[i])) {
            return *this;
        }
    }
    if (metres.norm() > largest) {
        refuse(ErrorCode::InvalidArgument,
               QStringLiteral("%1: the distance is %2 m. Was the value given in millimetres?")
                   .arg(text(name))
                   .arg(metres.norm()));
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::finite(const char* name, const double* values, int count) {
    for (int i = 0; i < count; ++i) {
        if (!std::isfinite(values[i])) {
            refuse(
                ErrorCode::InvalidArgument,
                QStringLiteral("%1: value %2 of %3 is not a number").arg(text(name)).arg(i + 1).arg(count));
        }
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::range(const char* name, double value, double low, double high,
                                    const char* unit) {
    if (!checkFinite(name, "the value", value)) {
        return *this;
    }
    if (value < low - kRounding || value > high + kRounding) {
        refuse(ErrorCode::LimitExceeded, QStringLiteral("%1: %2 is outside the range %3 to %4 %5")
                                             .arg(text(name))
                                             .arg(value)
                                             .arg(low)
                                             .arg(high)
                                             .arg(text(unit))
                                             .trimmed());
    }
    return *this;
}

ArgumentCheck& ArgumentCheck::toolSpeed(const char* name, double speed, double cap) {
    const double highest = std::min(cap, kHighestToolSpeed);
    if (speed > highest + kRounding && speed <= kHighestToolSpeed) {
        refuse(ErrorCode::LimitExceeded, aboveCap(name, speed, highest));
        return *this;
    }
    return positive(name, speed, kHighestToolSpeed, "m/s", "mm/s");
}

ArgumentCheck& ArgumentCheck::positive(const char* name, double value, double high, const char* unit,
                                       const char* hint) {
    if (!checkFinite(name, "the value", value)) {
        return *this;
    }
    if (value <= 0) {
        refuse(ErrorCode::InvalidArgument,
               QStringLiteral("%1: %2 %3 is not allowed; the value must be greater than 0")
                   .arg(text(name))
                   .arg(value)
                   .arg(text(unit)));
    } else if (value > high + kRounding) {
        constexpr double kFar = 5.0;
        const bool otherUnit = hint != nullptr && value > kFar * high;
        refuse(ErrorCode::LimitExceeded,
               QStringLiteral("%1: %2 exceeds the maximum of %3 %4%5")
                   .arg(text(name))
                   .arg(value)
                   .arg(high)
                   .arg(text(unit), otherUnit ? QStringLiteral(". Was the value given in %1?").arg(text(hint))
                                              : QString()));
    }
    return *this;
}

bool isFinite(const JogTarget& target) {
    return target.twist.linear.allFinite() && target.twist.angular.allFinite() && target.qd.allFinite() &&
           target.T_base_frame.allFinite() && std::isfinite(target.contactForce) &&
           !std::isnan(target.speedCap);
}

Error checkLimits(const MotionLimits& limits, const char* context) {
    constexpr double kHighestTurn = 12.0;  // [rad/s], above the speed of all wrist joints
    ArgumentCheck check(context);
    const auto speed = [&check](const char* name, double value, double high, const char* unit,
                                const char* hint) {
        if (value != kNoCap) {
            check.positive(name, value, high, unit, hint);
        }
    };
    speed("limits.tcpSpeed", limits.tcpSpeed, kHighestToolSpeed, "m/s", "mm/s");
    speed("limits.tcpRotationSpeed", limits.tcpRotationSpeed, kHighestTurn, "rad/s", "deg/s");
    speed("limits.jointSpeed", limits.jointSpeed, kHighestTurn, "rad/s", "deg/s");
    return check
        .positive("limits.jogAcceleration", limits.jogAcceleration, kHighestToolAcceleration, "m/s2", "mm/s2")
        .positive("limits.jogDeceleration", limits.jogDeceleration, kHighestToolAcceleration, "m/s2", "mm/s2")
        .positive("limits.jointAcceleration", limits.jointAcceleration, kJointAccelerationLimit, "rad/s2",
                  "deg/s2")
        .positive("limits.jointDeceleration", limits.jointDeceleration, kJointAccelerationLimit, "rad/s2",
                  "deg/s2")
        .error();
}

}  // namespace tiller::control
