// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/axis_jog.h"

#include <algorithm>
#include <utility>

#include "robot/station/text/texts.h"

namespace tiller {

using control::StopCause;

control::JogTarget deflectionTarget(const JogSelection& selection, const Deflection& deflection,
                                    double factor, const control::MotionLimits& limits) {
    const SpeedClass speed = chosenSpeed(selection);
    factor = selection.motion == MotionChoice::UntilContact ? std::min(factor, 1.0) : factor;
    if (deflection.axes.isZero()) {
        control::JogTarget target = jointJog(selection, 0, 1, factor, limits);
        for (int joint = 0; joint < kJointCount; ++joint) {
            target.qd[joint] = std::min(speed.joint * factor, limits.jointSpeed) *
                               std::clamp(deflection.joints[joint], -1.0, 1.0);
        }
        return target;
    }
    // Use the frame and the speeds of a pad button, and replace the direction with that of the device.
    control::JogTarget target = cartesianJog(selection, {0, 1}, factor, limits);
    const auto held = [](const Eigen::Vector3d& wish, double most) -> Eigen::Vector3d {
        // Diagonal motion is not faster than motion along an axis.
        return wish * (most / std::max(1.0, wish.norm()));
    };
    target.twist.linear = held(deflection.axes.head<3>(), std::min(speed.tcp * factor, limits.tcpSpeed));
    target.twist.angular =
        held(deflection.axes.tail<3>(), std::min(speed.rotation * factor, limits.tcpRotationSpeed));
    return target;
}

std::int64_t jogTimeoutNs(const control::JogTarget& target) {
    return target.kind == control::JogTarget::Kind::Joint
               ? HoldBounds::holdTimeoutAt(0, target.qd.values.cwiseAbs().maxCoeff())
               : HoldBounds::holdTimeoutAt(target.twist.linear.norm(), target.twist.angular.norm());
}

AxisJog::AxisJog(const MotionPort& port, const JogSelection& selection, HoldPolicy& policy,
                 std::function<QString()> obstacle, QObject* parent)
    : QObject(parent)
    , port_(port)
    , selection_(selection)
    , obstacle_(std::move(obstacle))
    , rules_(policy, [this](StopCause cause) { stop(cause); }) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(HoldRules::kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &AxisJog::pump);
}

AxisJog::~AxisJog() {
    stop(StopCause::WindowClosed);
}

void AxisJog::setClock(const Clock& clock) {
    stop(StopCause::SelectionChanged);
    rules_.setClock(clock);
}

control::JogTarget AxisJog::target() const {
    return deflectionTarget(selection_, input_, factor_, port_.limits());
}

void AxisJog::setInput(const Deflection& deflection, double factor) {
    const bool released = deflection.isNeutral() || !deflection.deadMan;
    if (isActive() && deflection.grip.by != input_.grip.by) {
        // Another source holds the motion. Ignore this source unless it is deflected.
        neutralOf(deflection.grip.by) = deflection.isNeutral();
        if (!released) {
            rules_.happen(HoldEvent::Kind::PressedAgain);
        }
        return;
    }
    input_ = deflection;
    factor_ = factor;
    if (isActive()) {
        rules_.happen(HoldEvent::Kind::Input);
        rules_.heard();
    }
    if (released) {
        rules_.happen(HoldEvent::Kind::LetGo);
        // Releasing the enabling button is not sufficient. The stick must also be at its centre.
        neutralOf(deflection.grip.by) = deflection.isNeutral();
        return;
    }
    if (!isActive() && neutralOf(deflection.grip.by)) {
        begin();
    } else if (isActive()) {
        rules_.setKeys(deflection.grip.keys);
        if (port_.holdWith && !port_.holdWith(id_, target()) && isActive()) {
            finish();
        } else if (isActive()) {
            Q_EMIT turned();
        }
    }
}

void AxisJog::begin() {
    neutralOf(input_.grip.by) = false;  // require a neutral position before the next motion
    QString why = rules_.obstacle(nullptr, input_.grip);
    if (why.isEmpty()) {
        why = obstacle_();
    } else {
        rules_.endOther();  // rule: keyboard or stick input while a button is held
    }
    if (!why.isEmpty()) {
        Q_EMIT refused(why);
        return;
    }
    const auto motion = port_.beginJog(target());
    if (!motion) {
        Q_EMIT refused(texts::errorText(motion.error()));
        return;
    }
    id_ = *motion;
    rules_.begin(nullptr, input_.grip, {});
    timer_.start();
    Q_EMIT began();
}

void AxisJog::tell(HoldEvent::Kind kind) {
    if (input_.grip.by == HoldSource::By::Keys) {
        rules_.happen(kind);
    } else if (kind == HoldEvent::Kind::OtherKey) {
        rules_.happen(HoldEvent::Kind::PressedAgain);  // rule: a motion key in addition to a stick
    }
}

std::int64_t AxisJog::holdTimeoutNs() const {
    return jogTimeoutNs(target());
}

void AxisJog::stop(StopCause cause) {
    if (!isActive()) {
        return;
    }
    rules_.end();
    timer_.stop();
    neutralOf(input_.grip.by) = false;
    port_.endMotion(std::exchange(id_, 0), cause);
    Q_EMIT ended(cause);
}

/// Cleans up after the session or the robot has ended the motion.
void AxisJog::finish() {
    rules_.end();
    timer_.stop();
    id_ = 0;
    neutralOf(input_.grip.by) = false;
    Q_EMIT ended(StopCause::None);
}

void AxisJog::pump() {
    if (!isActive() || rules_.happen(HoldEvent::Kind::Refresh)) {
        return;
    }
    if (!port_.hold(id_) && isActive()) {
        finish();
    }
}

}  // namespace tiller

#include "moc_axis_jog.cpp"
