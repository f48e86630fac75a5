// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/key_ghosts.h"

#include <QEvent>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {

void KeyGhosts::offer(HoldToRunButton& key, const QString& name, Target target) {
    offers_.insert(&key, {name, std::move(target)});
    key.installEventFilter(this);
    connect(&key.guard(), &HoldGuard::began, this, [this, &key] { show(offers_.value(&key)); });
    connect(&key.guard(), &HoldGuard::ended, this, &KeyGhosts::hide);
}

void KeyGhosts::setState(const SessionState& state) {
    state_ = state;
    if (shown_ && !state.canMove()) {
        hide();  // without the permission to move, there is no target
    }
}

void KeyGhosts::hide() {
    shown_ = false;
    Q_EMIT gone();
}

void KeyGhosts::show(const Offer& offer) {
    const std::optional<MoveRequest> target = state_.canMove() ? offer.target() : std::nullopt;
    if (!target) {
        return;
    }
    Ghost ghost{.name = offer.name,
                .q = target->q,
                .linear = target->kind == MoveRequest::Kind::MoveL,
                .reachable = true,
                .speed = target->speed,
                .acceleration = target->acceleration};
    if (ghost.linear) {
        const auto q = kinematics::inverseNearest(state_.dh, target->pose, state_.tcpOffset, state_.q);
        ghost.reachable = q.has_value();
        ghost.q = q.value_or(state_.q);
    }
    shown_ = true;
    Q_EMIT wanted(ghost);
}

bool KeyGhosts::eventFilter(QObject* watched, QEvent* event) {
    const bool enter = event->type() == QEvent::Enter;
    if (enter || event->type() == QEvent::Leave) {
        const auto offer = offers_.constFind(watched);
        const auto* key = qobject_cast<const HoldToRunButton*>(watched);
        if (offer != offers_.constEnd() && key != nullptr && !key->isHolding()) {
            if (enter) {
                show(*offer);
            } else {
                hide();
            }
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace tiller

#include "moc_key_ghosts.cpp"
