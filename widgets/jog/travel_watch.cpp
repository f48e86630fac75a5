// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/travel_watch.h"

#include "robot/core/angles.h"
#include "robot/station/jog/travel.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/move_words.h"
#include "robot/station/text/notation.h"
#include "widgets/jog/jog_pad.h"

namespace tiller {
namespace {

constexpr int kLookMs = 40;
constexpr int kTicksMoving = 3;       ///< ticks between computations while the arm moves
constexpr double kSamePlace = 0.002;  ///< [rad]; joint changes up to this value are ignored

bool isOpen(const control::JogReach& travel) {
    return travel.end.kind == control::LimiterKind::None;
}

QString textOf(const control::JogReach& travel, bool turns) {
    if (isOpen(travel)) {
        return {};
    }
    return turns ? format::number(toDegrees(travel.distance), 0) + QStringLiteral("°")
                 : format::length(travel.distance, 0);
}

}  // namespace

TravelWatch::TravelWatch(JogPad& pad, const JogSelection& selection, QObject* parent)
    : QObject(parent), pad_(pad), selection_(selection) {
    timer_.setInterval(kLookMs);
    connect(&timer_, &QTimer::timeout, this, &TravelWatch::tick);
    timer_.start();
}

void TravelWatch::tick() {
    const bool moves = (state_.q.values - tickedAt_.values).cwiseAbs().maxCoeff() > kSamePlace / kTicksMoving;
    tickedAt_ = state_.q;
    if (++ticks_ >= kTicksMoving || !moves) {
        ticks_ = 0;
        look();
    }
}

std::optional<qsizetype> TravelWatch::heldKey() const {
    for (qsizetype i = 0; i < pad_.keys().size(); ++i) {
        if (pad_.keys()[i]->isHolding()) {
            return i;
        }
    }
    return {};
}

void TravelWatch::reset() {
    for (qsizetype i = 0; i < pad_.keys().size(); ++i) {
        write(i);
    }
}

/// Marks all directions for a new computation. Until then, the buttons show the old values as outdated.
void TravelWatch::setOutdated() {
    for (JogKey* key : pad_.keys()) {
        key->setTravelOutdated(true);
    }
    left_ = static_cast<int>(pad_.keys().size());
}

void TravelWatch::write(qsizetype index) {
    JogKey* key = pad_.keys()[index];
    const bool turns = key->key().axis >= 3;
    const control::JogReach& travel = travel_.at(static_cast<std::size_t>(index));
    const bool little = !isOpen(travel) && travel.distance < (turns ? toRadians(10) : 0.03);
    key->setTravel(textOf(travel, turns), little);
}

void TravelWatch::look() {
    const QVector<JogKey*>& keys = pad_.keys();
    if (!state_.hasData()) {
        travel_ = {};
        reset();
    }
    if (!state_.canMove()) {
        setOutdated();  // the next valid state may belong to another arm or position
        return;
    }
    const Eigen::Matrix3d axes = frameAxes(selection_, state_.tcpPose);
    // A large change of the axes means that a different frame was selected, except during a motion, in which
    // the tool frame rotates.
    const bool otherFrame = !state_.motionActive && !axes.isApprox(lookedIn_, 2e-2);
    if (otherFrame || state_.check != lookedWith_) {
        setOutdated();
    } else if ((state_.q.values - lookedFrom_.values).cwiseAbs().maxCoeff() > kSamePlace ||
               !axes.isApprox(lookedIn_, 1e-6)) {
        left_ = static_cast<int>(keys.size());
    }
    if (left_ == static_cast<int>(keys.size())) {
        lookedFrom_ = state_.q;
        lookedWith_ = state_.check;
        lookedIn_ = axes;
    }
    if (left_ == 0) {
        return;
    }
    const auto held = heldKey();
    lookedAtHeld_ = held && !lookedAtHeld_;
    if (!lookedAtHeld_) {
        --left_;
    }
    const qsizetype index = lookedAtHeld_ ? *held : next_++ % keys.size();
    JogKey* key = keys[index];
    const bool turns = key->key().axis >= 3;
    Vector6 direction = Vector6::Zero();
    direction.segment<3>(turns ? 3 : 0) = axes.col(key->key().axis % 3) * key->key().direction;
    const control::JogReach travel = travelLeft(state_, direction);
    travel_.at(static_cast<std::size_t>(index)) = travel;
    write(index);
    key->setTravelOutdated(false);
}

QString TravelWatch::heldText() const {
    const auto held = heldKey();
    if (held && !pad_.keys()[*held]->travel().isEmpty()) {
        const JogKey* key = pad_.keys()[*held];
        const control::Limiter& end = travel_.at(static_cast<std::size_t>(*held)).end;
        switch (end.kind) {
            case control::LimiterKind::JointLimit:
                return tr("%1: %2 left until the %3 joint limit")
                    .arg(key->text(), key->travel(), jointName(end.joint));
            case control::LimiterKind::SelfCollision:
            case control::LimiterKind::Obstacle:
            case control::LimiterKind::Border:
                return tr("%1: %2 left until %3 is %4 from %5")
                    .arg(key->text(), key->travel(), linkText(end.link), format::length(end.distance, 0),
                         limiterText(end, state_.check->surroundings()));
            default:
                return tr("%1: %2 left until the reach limit or a singularity")
                    .arg(key->text(), key->travel());
        }
    }
    return {};
}

}  // namespace tiller

#include "moc_travel_watch.cpp"
