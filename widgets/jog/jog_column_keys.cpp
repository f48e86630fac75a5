// SPDX-License-Identifier: GPL-3.0-or-later

// The keys of the column and what a press on each begins.

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/hold_button.h"
#include "widgets/jog/axis_jog.h"
#include "widgets/jog/back_track.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/keyboard_jog.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/reasons.h"
#include "widgets/session/move_time.h"
#include "widgets/session/texts.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kMargin = 12;

double heldFactor() {
    return modifierFactor(QGuiApplication::keyboardModifiers());
}

}  // namespace

void JogColumn::buildBottom(QVBoxLayout* layout) {
    const auto make = [this](const QString& text, const char* name, const QString& tip) {
        auto* key = new HoldButton(text, this);
        key->setObjectName(QLatin1String(name));
        key->setToolTip(tip);
        key->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        return key;
    };
    freedrive_ = make(tr("Freedrive"), "freedriveKey", {});
    homeKey_ = make(tr("Home"), "homeKey", tr("Moves every joint to the home position while held"));
    align_ = make(tr("Align"), "alignKey",
                  tr("Turns the tool to the nearest axis of the chosen frame while held"));
    back_ =
        make(QStringLiteral("↶ ") + tr("Back"), "backKey", tr("Goes back the way the arm came while held"));
    back_->setAccessibleName(tr("Back"));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kMargin, 8, kMargin, 0);
    row->setSpacing(8);
    for (HoldButton* key : {freedrive_, homeKey_, align_, back_}) {
        row->addWidget(key);
    }
    layout->addLayout(row);
}

void JogColumn::guardMotion(HoldButton* key, HoldMotion motion) {
    motion.begin = [this, begin = std::move(motion.begin)]() -> Result<RobotSession::MotionId> {
        if (!state_.canMove()) {
            return Error{ErrorCode::NotInControl, cannotMoveReason(state_), {}};
        }
        return begin();
    };
    key->setMotion(std::move(motion));
    connect(&key->guard(), &HoldGuard::began, this, [this, key] {
        refusal_.clear();
        pose_->pressedHere();
        showGhost(key);
        showReason();
    });
    connect(&key->guard(), &HoldGuard::ended, this, [this, key] {
        if (ghosts_.contains(key)) {
            Q_EMIT ghostGone();
        }
    });
    connect(&key->guard(), &HoldGuard::refused, this, [this](const Error& error) {
        // Our own refusal is a whole sentence already.
        const bool own =
            !state_.canMove() || error.code == ErrorCode::UnsafeState || error.code == ErrorCode::Cancelled;
        refusal_ = !state_.canMove() ? cannotMoveReason(state_)
                   : own             ? error.context
                                     : texts::errorText(error);
        refusalTimer_->start();
        showReason();
        Q_EMIT refused(refusal_);
    });
}

void JogColumn::guardKey(HoldButton* key, const Begin& begin, bool steps) {
    guardMotion(key, {
                         .begin = begin,
                         .hold = port_.hold,
                         .end = port_.endMotion,
                         .runsToEnd = [this, steps] { return steps && stepRunsToEnd(selection_); },
                         .bounds = [this] { return bounds_; },
                     });
}

void JogColumn::connectKeys() {
    for (JogKey* key : pad_->keys()) {
        const CartesianKey axis = key->key();
        const auto step = [this, axis] {
            return cartesianStep(selection_, axis, heldFactor(), state_.tcpPose, port_.limits());
        };
        guardKey(
            key,
            [this, axis, step] {
                return isHeld(selection_.motion)
                           ? beginJog(cartesianJog(selection_, axis, heldFactor(), port_.limits()))
                           : beginMove(step());
            },
            true);
        offerGhost(key, key->text(), [this, step]() -> std::optional<MoveRequest> {
            const bool far = !isHeld(selection_.motion) && !stepRunsToEnd(selection_);
            return far ? std::optional(step()) : std::nullopt;
        });
    }
    for (JointRow* row : joints_->rows()) {
        for (const auto& [key, direction] : {std::pair{row->minusKey(), -1}, {row->plusKey(), 1}}) {
            const auto step = [this, joint = row->joint(), direction = direction] {
                return jointStep(selection_, joint, direction, heldFactor(), state_.q, port_.limits());
            };
            guardKey(
                key,
                [this, joint = row->joint(), direction = direction, step] {
                    return isHeld(selection_.motion) ? beginJog(jointJog(selection_, joint, direction,
                                                                         heldFactor(), port_.limits()))
                                                     : beginMove(step());
                },
                true);
            offerGhost(key, key->accessibleName(), [this, step]() -> std::optional<MoveRequest> {
                const bool far = !isHeld(selection_.motion) && !stepRunsToEnd(selection_);
                return far ? std::optional(step()) : std::nullopt;
            });
        }
    }
}

void JogColumn::connectBottom() {
    const auto home = [this] {
        return homeMove(selection_, state_.q, home_, robotModel(state_.model), state_.tcpOffset,
                        port_.limits());
    };
    guardKey(
        homeKey_, [this, home] { return beginMove(home()); }, false);
    offerGhost(homeKey_, tr("home"), home);
    const auto align = [this] { return alignMove(selection_, state_.tcpPose, port_.limits()); };
    guardKey(
        align_, [this, align] { return beginMove(align()); }, false);
    offerGhost(align_, tr("aligned"), align);
    guardKey(
        freedrive_, [this] { return beginFreedrive(); }, false);
    setFreedriveAxes(freedriveAxes_);
    freedrive_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(freedrive_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        stopMotion(StopCause::DialogOpened);
        QMenu menu(this);
        fillFreedriveMenu(menu);
        menu.exec(freedrive_->mapToGlobal(at));
    });

    track_ = std::make_unique<BackTrack>(
        port_, [this] { return std::min(chosenSpeed(selection_).joint, port_.limits().jointSpeed); });
    guardMotion(back_, track_->motion());
}

void JogColumn::addHoldKeys(KeyboardJog& keyboard) {
    keyboard.addHoldKey(Qt::Key_F, freedrive_->guard());
    keyboard.addHoldKey(Qt::Key_Home, homeKey_->guard());
    keyboard.addHoldKey(Qt::Key_End, align_->guard());
    keyboard.addHoldKey(Qt::Key_Backspace, back_->guard());
}

Result<RobotSession::MotionId> JogColumn::beginJog(const control::JogTarget& target) {
    bounds_ = {0, jogSilenceNs(target)};
    return port_.beginJog(target);
}

Result<RobotSession::MotionId> JogColumn::beginMove(const MoveRequest& request) {
    const bool linear = request.kind == MoveRequest::Kind::MoveL;
    bounds_ = {HoldBounds::longestOf(moveSeconds(request, state_)),
               HoldRules::silenceAt(linear ? request.speed : 0, linear ? 0 : request.speed)};
    return port_.beginMove(request);
}

/// Said in the last seconds of the longest hold of a motion that has no other end.
QString JogColumn::countdown() const {
    constexpr std::int64_t kSaidNs = 3 * kNsPerSecond;
    std::int64_t left = axisJog_->leftNs();
    for (const HoldButton* key : holdKeys()) {
        left = std::min(left, key->holdLeftNs());
    }
    if (left > kSaidNs || !isHolding()) {
        return {};
    }
    return tr("Ends in %1 s").arg(std::max<std::int64_t>(0, (left + kNsPerSecond - 1) / kNsPerSecond));
}

Result<RobotSession::MotionId> JogColumn::beginFreedrive() {
    if (payloadChecked_) {
        if (const QString doubt = payloadDoubt(state_); !doubt.isEmpty()) {
            return Error{ErrorCode::UnsafeState, doubt, {}};
        }
    }
    constexpr std::int64_t kLongestFreedriveNs = 5 * 60 * kNsPerSecond;
    bounds_ = {kLongestFreedriveNs, HoldRules::kLongestSilenceNs};
    return port_.beginFreedrive(
        freedriveOf(freedriveAxes_, frameAxes(selection_, state_.tcpPose), state_.tcpPose));
}

QString JogColumn::deviceObstacle() const {
    if (const QString reason = cannotMoveReason(state_); !reason.isEmpty()) {
        return reason;
    }
    // One hand at a time.
    return isHolding() ? tr("Another key is held.") : QString();
}

void JogColumn::offerGhost(HoldButton* key, const QString& name,
                           std::function<std::optional<MoveRequest>()> target) {
    ghosts_.insert(key, {name, std::move(target)});
    key->installEventFilter(this);
}

void JogColumn::showGhost(HoldButton* key) {
    const auto offer = ghosts_.constFind(key);
    if (offer == ghosts_.constEnd() || !state_.canMove()) {
        return;
    }
    const std::optional<MoveRequest> target = offer->target();
    if (!target) {
        return;
    }
    JogGhost ghost{offer->name, target->q,     target->kind == MoveRequest::Kind::MoveL,
                   true,        target->speed, target->acceleration};
    if (ghost.linear) {
        const auto q =
            kinematics::inverseNearest(robotModel(state_.model).dh, target->pose, state_.tcpOffset, state_.q);
        ghost.reachable = q.has_value();
        ghost.q = q.value_or(state_.q);
    }
    Q_EMIT ghostWanted(ghost);
}

bool JogColumn::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) {
        auto* key = qobject_cast<HoldButton*>(watched);
        if (key != nullptr && ghosts_.contains(key) && !key->isHolding()) {
            if (event->type() == QEvent::Enter) {
                showGhost(key);
            } else {
                Q_EMIT ghostGone();
            }
        }
    }
    return Panel::eventFilter(watched, event);
}

}  // namespace tiller
