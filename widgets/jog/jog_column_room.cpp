// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the column that says how much room is left, and takes sizes entered by hand.

#include <algorithm>
#include <numbers>

#include "widgets/common/format.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/travel.h"

namespace tiller {

using control::StopCause;

void JogColumn::showLimiter() {
    if (!state_.hasData()) {
        nearest_ = {};
    } else if (state_.motionActive || nearest_.what.isEmpty() ||
               (state_.q.values - limiterAt_.values).cwiseAbs().maxCoeff() > 0.005) {
        nearest_ = nearestLimiter(state_, frameAxes(selection_, state_.tcpPose));
        limiterAt_ = state_.q;
    }
    limiter_->setLimiter(nearest_);
}

void JogColumn::setFreeSpeed(double tcpSpeed) {
    stopMotion(StopCause::SelectionChanged);
    const double speed = std::clamp(tcpSpeed, 0.0005, port_.limits().tcpSpeed);
    speed_->setCurrentIndex(kSpeedClassCount - 1);
    selection_.speed = speedFor(speed);
    speed_->setText(kSpeedClassCount - 1,
                    format::number(speed * 1e3, speed < 0.01 ? 1 : 0) + QStringLiteral(" mm/s"));
}

void JogColumn::setFreeStep(const StepSize& step) {
    stopMotion(StopCause::SelectionChanged);
    motion_->setCurrentIndex(static_cast<int>(MotionChoice::CoarseStep));
    selection_.step = step;
    motion_->setText(static_cast<int>(MotionChoice::CoarseStep),
                     format::number(step.length * 1e3, step.length < 0.001 ? 2 : 0) + QStringLiteral(" mm"));
}

void JogColumn::zeroHere() {
    pose_->zeroHere();
}

void JogColumn::lookAround() {
    const QVector<JogKey*>& keys = pad_->keys();
    if (!state_.hasData() || !state_.canMove()) {
        for (JogKey* key : keys) {
            key->setTravel({}, false);
        }
        return;
    }
    JogKey* key = keys[look_++ % keys.size()];
    const bool turns = key->key().axis >= 3;
    Eigen::Matrix<double, 6, 1> direction = Eigen::Matrix<double, 6, 1>::Zero();
    direction.segment<3>(turns ? 3 : 0) =
        frameAxes(selection_, state_.tcpPose).col(key->key().axis % 3) * key->key().direction;
    const Travel travel = travelLeft(robotModel(state_.model).dh, state_.q, state_.tcpOffset, direction);
    if (travel.end == Travel::End::Open) {
        key->setTravel({}, false);
    } else if (turns) {
        key->setTravel(format::number(travel.left * 180 / std::numbers::pi, 0) + QStringLiteral("°"),
                       travel.left < 0.17);
    } else {
        key->setTravel(format::number(travel.left * 1e3, 0) + QStringLiteral(" mm"), travel.left < 0.03);
    }
}

}  // namespace tiller
