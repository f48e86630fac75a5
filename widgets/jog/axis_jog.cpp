// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/axis_jog.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "widgets/common/hold_guard.h"
#include "widgets/session/texts.h"

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
    // Frame and speeds as a key of the pad would have them; then the direction is the device's own.
    control::JogTarget target = cartesianJog(selection, {0, 1}, factor, limits);
    const auto held = [](const Eigen::Vector3d& wish, double most) -> Eigen::Vector3d {
        return wish * (most / std::max(1.0, wish.norm()));  // the diagonal is no faster than an axis
    };
    target.twist.linear = held(deflection.axes.head<3>(), std::min(speed.tcp * factor, limits.tcpSpeed));
    target.twist.angular =
        held(deflection.axes.tail<3>(), std::min(speed.rotation * factor, limits.tcpRotationSpeed));
    return target;
}

AxisJog::AxisJog(const JogPort& port, const JogSelection& selection, std::function<QString()> obstacle,
                 QObject* parent)
    : QObject(parent), port_(port), selection_(selection), obstacle_(std::move(obstacle)) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(HoldGuard::kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &AxisJog::pump);
}

AxisJog::~AxisJog() {
    stop(StopCause::WindowClosed);
}

void AxisJog::setClock(const Clock& clock) {
    stop(StopCause::SelectionChanged);
    clock_ = &clock;
}

void AxisJog::setInput(const Deflection& deflection, double factor) {
    input_ = deflection;
    factor_ = factor;
    inputNs_ = clock_->nowNs();
    if (id_ != 0) {
        endIfStalled(inputNs_);
    }
    if (deflection.isNeutral() || !deflection.deadMan) {
        if (id_ != 0) {
            stop(StopCause::Released);
        }
        // The dead-man alone does not count as let go: the stick has to be in the middle.
        neutral_ = deflection.isNeutral();
        return;
    }
    if (id_ == 0 && neutral_) {
        begin();
    } else if (id_ != 0 && port_.holdWith &&
               !port_.holdWith(id_, deflectionTarget(selection_, input_, factor_, port_.limits()))) {
        finish();
    }
}

void AxisJog::begin() {
    neutral_ = false;  // whatever comes of it, the next motion needs a neutral device
    // The program in front of which the operator sits is the one that may move the arm.
    const QString why =
        QApplication::activeWindow() == nullptr ? tr("Click into the window first.") : obstacle_();
    if (!why.isEmpty()) {
        Q_EMIT refused(why);
        return;
    }
    const auto motion = port_.beginJog(deflectionTarget(selection_, input_, factor_, port_.limits()));
    if (!motion) {
        Q_EMIT refused(texts::errorText(motion.error()));
        return;
    }
    id_ = *motion;
    pumpedNs_ = clock_->nowNs();
    timer_.start();
    qApp->installEventFilter(this);
    Q_EMIT began();
}

void AxisJog::stop(StopCause cause) {
    if (id_ == 0) {
        return;
    }
    port_.endMotion(std::exchange(id_, 0), cause);
    timer_.stop();
    qApp->removeEventFilter(this);
    neutral_ = false;
    Q_EMIT ended(cause);
}

void AxisJog::finish() {
    id_ = 0;
    timer_.stop();
    qApp->removeEventFilter(this);
    neutral_ = false;
    Q_EMIT ended(StopCause::None);
}

/// Nothing ran for so long: what the device asked for before it is too old to go on with.
bool AxisJog::endIfStalled(std::int64_t nowNs) {
    if (nowNs - pumpedNs_ <= HoldGuard::kStallMs * kNsPerMs) {
        return false;
    }
    stop(StopCause::EventLoopStalled);
    return true;
}

void AxisJog::pump() {
    if (id_ == 0) {
        return;
    }
    const std::int64_t now = clock_->nowNs();
    if (endIfStalled(now)) {
        return;
    }
    if (input_.polled && now - inputNs_ > HoldGuard::kStallMs * kNsPerMs) {
        stop(StopCause::DeviceLost);
        return;
    }
    pumpedNs_ = now;
    if (!port_.hold(id_)) {
        finish();
    }
}

bool AxisJog::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::TouchBegin:
        case QEvent::TabletPress:
            // A press passes the native window first and the widget then: decide at the widget.
            if (watched->isWidgetType()) {
                stop(StopCause::SecondButton);
                return HoldGuard::isHoldKey(*watched);
            }
            break;
        case QEvent::WindowDeactivate:
        case QEvent::ApplicationDeactivate:
            stop(StopCause::WindowDeactivated);
            break;
        case QEvent::WindowBlocked:
            stop(StopCause::DialogOpened);
            break;
        case QEvent::Close:
        case QEvent::Quit:
            stop(StopCause::WindowClosed);
            break;
        case QEvent::Show: {
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget != nullptr && widget->isWindow() && widget->windowType() != Qt::ToolTip) {
                stop(StopCause::DialogOpened);
            }
            break;
        }
        default:
            break;
    }
    return false;
}

}  // namespace tiller
