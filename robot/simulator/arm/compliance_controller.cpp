// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/compliance_controller.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
// Virtual mass moved by a force. With this mass and the damping below, 10 N at half gain and the initial
// damping result in 3 cm/s, as in the published force-mode run of a UR5e, and contact with a stiff surface is
// well damped.
constexpr double kMass = 10;            // kg
constexpr double kInertia = 0.4;        // kg m2
constexpr double kDampingLinear = 150;  // N s/m
constexpr double kDampingLinearMore = 2000;
constexpr double kDampingAngular = 8;  // Nm s/rad
constexpr double kDampingAngularMore = 80;
constexpr double kPathStiffness = 10;  // 1/s: rate at which non-compliant axes return to the path
// Smaller limits are raised to these values. Otherwise, the residual position error would end force mode.
constexpr double kMinDeviation = 2e-3;  // m
constexpr double kMinTurn = 0.02;       // rad

// Constants of freedrive.
const Vector6 kJointInertia = (Vector6() << 2.0, 2.0, 1.2, 0.3, 0.3, 0.3).finished();  // kg m2
constexpr double kJointDampingRate = 4;                                                // 1/s
constexpr double kHandForce = 3;                                                       // N, dead band
constexpr double kHandTorque = 0.3;                                                    // Nm, dead band
constexpr double kNearSingular = 0.4;
constexpr double kTooCloseToSingular = 0.15;

Vector6 withoutDeadband(const Wrench& w) {
    const double f = w.force.norm();
    const double m = w.torque.norm();
    Vector6 out = Vector6::Zero();
    if (f > kHandForce) {
        out.head<3>() = w.force * ((f - kHandForce) / f);
    }
    if (m > kHandTorque) {
        out.tail<3>() = w.torque * ((m - kHandTorque) / m);
    }
    return out;
}
}  // namespace

ComplianceController::ComplianceController(const ArmGeometry& geometry, MotionGenerator& generator,
                                           double period)
    : geometry_(geometry), generator_(generator), period_(period) {
    command_ = generator.target();
}

MotionError ComplianceController::startForceMode(const ForceModeParameters& p) {
    if (!p.T_base_task.allFinite() || !p.wrench.vector().allFinite() || !p.limits.allFinite() || p.type < 1 ||
        p.type > 3 || (p.limits.array() < 0).any()) {
        return MotionError::InvalidArgument;
    }
    if (freedrive_) {
        endFreedrive();
    }
    force_ = p;
    for (int i = 0; i < 6; ++i) {
        if (!p.compliant[static_cast<std::size_t>(i)]) {
            forceVelocity_[i] = 0;
        }
    }
    if (!forceMode_) {
        forceVelocity_.setZero();
        forceMode_ = true;
    }
    return MotionError::None;
}

void ComplianceController::endForceMode() {
    if (!forceMode_) {
        return;
    }
    forceMode_ = false;
    // Brake from the speed caused by the force. The program continues from the current arm position.
    generator_.relocate(command_);
}

MotionError ComplianceController::startFreedrive(const FreedriveParameters& p) {
    if (!p.T_base_feature.allFinite()) {
        return MotionError::InvalidArgument;
    }
    free_ = p;
    if (!freedrive_) {
        if (forceMode_) {
            forceMode_ = false;
        }
        freedrive_ = true;
        generator_.relocate({command_.q, Vector6::Zero()});
        generator_.setIgnoringCommands(true);
    }
    return MotionError::None;
}

void ComplianceController::endFreedrive() {
    if (!freedrive_) {
        return;
    }
    freedrive_ = false;
    generator_.setIgnoringCommands(false);
    generator_.relocate(command_);
}

void ComplianceController::drop() {
    forceMode_ = false;
    if (freedrive_) {
        freedrive_ = false;
        generator_.setIgnoringCommands(false);
    }
}

int ComplianceController::freedriveStatus() const {
    if (!freedrive_) {
        return 0;
    }
    Posture posture;
    geometry_.evaluate(command_.q, posture);
    const double margin = geometry_.singularityMargin(command_.q, posture);
    return margin < kTooCloseToSingular ? 2 : margin < kNearSingular ? 1 : 0;
}

const JointTarget& ComplianceController::apply(const JointTarget& program, const Wrench& measured,
                                               const Wrench& external, bool operational) {
    if (!operational) {
        drop();
    } else if (forceMode_ && generator_.protectiveStop()) {
        forceMode_ = false;
        generator_.raiseFrom(command_, generator_.protectiveStop()->reason);
        command_ = generator_.target();
        return command_;
    }
    const bool holdsStill = generator_.isHeld() && !generator_.readings().compliesInPause;
    if ((forceMode_ || freedrive_) && holdsStill) {
        comeToRest();
    } else if (forceMode_) {
        stepForceMode(measured);
    } else if (freedrive_) {
        stepFreedrive(external);
    } else {
        command_ = program;
    }
    return command_;
}

Eigen::Matrix3d ComplianceController::forceFrame(const Eigen::Vector3d& tcp,
                                                 const Eigen::Vector3d& tcpVelocity) const {
    if (force_.followTool) {
        return posture_.T_base_tcp.linear();
    }
    const Eigen::Isometry3d T = force_.T_base_task.transform();
    Eigen::Matrix3d R = T.linear();
    if (force_.type == 1) {
        const Eigen::Vector3d toOrigin = T.translation() - tcp;
        if (toOrigin.norm() > 1e-6) {
            const Eigen::Vector3d y = toOrigin.normalized();
            Eigen::Vector3d x = y.cross(R.col(2));
            if (x.norm() < 1e-6) {
                x = R.col(0);
            }
            x.normalize();
            R.col(0) = x;
            R.col(1) = y;
            R.col(2) = x.cross(y);
        }
    } else if (force_.type == 3) {
        Eigen::Vector3d x = tcpVelocity - R.col(2) * R.col(2).dot(tcpVelocity);
        if (x.norm() > 1e-4) {
            x.normalize();
            const Eigen::Vector3d z = R.col(2);
            R.col(0) = x;
            R.col(1) = z.cross(x);
        }
    }
    return R;
}

// True if a non-compliant axis exceeds its limit. `way`: deviation of the axes from the program target, in
// the force frame.
bool ComplianceController::deviates(const Vector6& way) const {
    for (int i = 0; i < 6; ++i) {
        const double least = i < 3 ? kMinDeviation : kMinTurn;
        if (!force_.compliant[static_cast<std::size_t>(i)] &&
            std::abs(way[i]) > std::max(force_.limits[i], least)) {
            return true;
        }
    }
    return false;
}

void ComplianceController::stepForceMode(const Wrench& measured) {
    geometry_.evaluate(command_.q, posture_);
    const JointTarget& program = generator_.target();
    const bool onPath = generator_.followsPath();
    geometry_.evaluate(program.q, program_);
    const Vector6 programTwist = program_.jacobian * program.qd;
    const Eigen::Matrix3d R = forceFrame(posture_.T_base_tcp.translation(), programTwist.head<3>());

    Vector6 wanted;  // velocity, in the force frame
    wanted << R.transpose() * programTwist.head<3>(), R.transpose() * programTwist.tail<3>();
    if (onPath) {
        // The deviation does not include the motion of this step.
        const Vector6 covered = 0.5 * (posture_.jacobian * command_.qd + programTwist) * period_;
        const Eigen::Vector3d way =
            program_.T_base_tcp.translation() - posture_.T_base_tcp.translation() - covered.head<3>();
        const Eigen::Quaterniond turn(program_.T_base_tcp.linear() *
                                      posture_.T_base_tcp.linear().transpose());
        const Eigen::Vector3d rotation = vectorFromQuaternion(turn) - covered.tail<3>();
        Vector6 lag;
        lag << R.transpose() * way, R.transpose() * rotation;
        if (deviates(lag)) {
            forceMode_ = false;
            generator_.raiseFrom(command_, StopReason::PathDeviation);
            command_ = generator_.target();
            return;
        }
        wanted.head<3>() += kPathStiffness * (R.transpose() * way);
        wanted.tail<3>() += kPathStiffness * (R.transpose() * rotation);
    }
    Vector6 felt;
    felt << R.transpose() * measured.force, R.transpose() * measured.torque;
    const Vector6 lacking = force_.wrench.vector() + felt;
    const double linear = kDampingLinear + kDampingLinearMore * damping;
    const double angular = kDampingAngular + kDampingAngularMore * damping;
    for (int i = 0; i < 6; ++i) {
        if (!force_.compliant[static_cast<std::size_t>(i)]) {
            continue;
        }
        const double mass = i < 3 ? kMass : kInertia;
        const double drag = i < 3 ? linear : angular;
        double& v = forceVelocity_[i];
        v = (mass * v + period_ * gainScaling * lacking[i]) / (mass + period_ * drag);
        v = std::clamp(v, -force_.limits[i], force_.limits[i]);
        wanted[i] = v;
    }
    Vector6 twist;
    twist << R * wanted.head<3>(), R * wanted.tail<3>();
    if (!takeTwist(twist)) {
        forceMode_ = false;
        generator_.raiseFrom(command_, StopReason::Singularity);
        command_ = generator_.target();
        return;
    }
    generator_.rebase(command_);
}

void ComplianceController::stepFreedrive(const Wrench& external) {
    geometry_.evaluate(command_.q, posture_);
    Vector6 push = withoutDeadband(external);
    const bool allFree = std::all_of(free_.freeAxes.begin(), free_.freeAxes.end(), [](bool f) { return f; });
    Eigen::Matrix3d R = free_.followTool ? Eigen::Matrix3d(posture_.T_base_tcp.linear())
                                         : Eigen::Matrix3d(free_.T_base_feature.transform().linear());
    const auto masked = [&](const Vector6& x) {
        Vector6 local;
        local << R.transpose() * x.head<3>(), R.transpose() * x.tail<3>();
        for (int i = 0; i < 6; ++i) {
            if (!free_.freeAxes[static_cast<std::size_t>(i)]) {
                local[i] = 0;
            }
        }
        Vector6 base;
        base << R * local.head<3>(), R * local.tail<3>();
        return base;
    };
    const double slowing = 1 + period_ * kJointDampingRate;
    if (!allFree) {
        const Vector6 twist = posture_.jacobian * command_.qd;
        Vector6 body;
        body << push.head<3>() / kMass, push.tail<3>() / kInertia;
        if (!takeTwist(masked((twist + period_ * body) / slowing))) {
            comeToRest();
        }
    } else {
        const Vector6 torque = posture_.jacobian.transpose() * push;
        Vector6 qd = (command_.qd + period_ * torque.cwiseQuotient(kJointInertia)) / slowing;
        const JointLimits& limits = generator_.limits();
        qd *= limits.speedFactor(qd);
        int joint = -1;
        qd *= limits.rangeFactor(command_.q, qd, period_, joint);
        limits.cutToAcceleration(command_.qd, qd, period_);
        command_.q += 0.5 * (command_.qd + qd) * period_;
        command_.qd = qd;
    }
    if (push.isZero(0) && command_.qd.cwiseAbs().maxCoeff() < 1e-4) {
        command_.qd.setZero();
    }
    generator_.rebase(command_);
}

void ComplianceController::comeToRest() {
    Vector6 rest = Vector6::Zero();
    generator_.limits().cutToAcceleration(command_.qd, rest, period_);
    command_.q += 0.5 * (command_.qd + rest) * period_;
    command_.qd = rest;
    forceVelocity_.setZero();
    generator_.rebase(command_);
}

// Advances the command by a TCP twist. Returns false if the joint limits do not permit this motion.
bool ComplianceController::takeTwist(const Vector6& twist) {
    const JointLimits& limits = generator_.limits();
    Vector6 qd = Vector6::Zero();
    if (!geometry_.jointRates(posture_, twist, qd)) {
        return false;
    }
    double factor = limits.speedFactor(qd);
    int joint = -1;
    factor *= limits.rangeFactor(command_.q, qd * factor, period_, joint);
    qd *= factor;
    if (!limits.cutToAcceleration(command_.qd, qd, period_) && factor >= 1) {
        // Follow the commanded line. The position is calculated from the tool pose, so that the other axes do
        // not drift.
        const ToolPoint now(posture_.T_base_tcp);
        const Vector6 mean = 0.5 * (posture_.jacobian * command_.qd + twist) * period_;
        const ToolPoint next(now.p + mean.head<3>(), quaternionFromVector(mean.tail<3>()) * now.R);
        Vector6 q = command_.q;
        Vector6 there = Vector6::Zero();
        if (geometry_.follow(next.transform(), q, posture_) && geometry_.jointRates(posture_, twist, there) &&
            limits.speedFactor(there) >= 1 && !limits.cutToAcceleration(command_.qd, there, period_)) {
            command_.q = q;
            command_.qd = there;
            return true;
        }
    }
    command_.q += 0.5 * (command_.qd + qd) * period_;
    command_.qd = qd;
    return true;
}

MotionError Compliance::startForceMode(const ForceModeParameters& parameters) {
    return controller_.startForceMode(parameters);
}

void Compliance::endForceMode() {
    controller_.endForceMode();
}

bool Compliance::isForceMode() const {
    return controller_.isForceMode();
}

void Compliance::setDamping(double damping) {
    controller_.damping = std::clamp(damping, 0.0, 1.0);
}

double Compliance::damping() const {
    return controller_.damping;
}

void Compliance::setGainScaling(double scaling) {
    controller_.gainScaling = std::clamp(scaling, 0.0, 2.0);
}

double Compliance::gainScaling() const {
    return controller_.gainScaling;
}

MotionError Compliance::startFreedrive(const FreedriveParameters& parameters) {
    return controller_.startFreedrive(parameters);
}

void Compliance::endFreedrive() {
    controller_.endFreedrive();
}

bool Compliance::isFreedrive() const {
    return controller_.isFreedrive();
}

int Compliance::freedriveStatus() const {
    return controller_.freedriveStatus();
}

}  // namespace tiller::simulator::arm
