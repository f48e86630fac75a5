// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/payload_estimator.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "robot/kinematics/speed_bounds.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {
namespace {

/// Rotations of wrist 1, wrist 2 and wrist 3 from the initial position [rad].
constexpr double kProposals[][3] = {{0, 0, 0},      {0.6, 0, 0},     {-0.4, 0.7, 0.8},
                                    {0, -0.7, 1.6}, {0.5, 0.5, 2.4}, {-0.5, -0.5, -0.8}};
constexpr double kProposedSpeed = 0.5;         ///< [rad/s]
constexpr double kProposedAcceleration = 1.0;  ///< [rad/s2]
/// Minimum differences of the forces and torques between the poses [N, Nm]. They must exceed the sensor
/// noise.
constexpr double kPoorForce = 1.0;
constexpr double kPoorTorque = 0.1;

}  // namespace

PayloadEstimator::PayloadEstimator(MotionPort port, HoldPolicy& policy, QWidget* parent)
    : QWidget(parent)
    , port_(std::move(port))
    , take_(new QPushButton)
    , again_(new QPushButton)
    , next_(new HoldToRunButton(tr("Next pose (hold)"), policy))
    , feedback_(new QLabel)
    , poses_(new QLabel)
    , keep_(new QPushButton(tr("Keep payload"))) {
    setObjectName(QStringLiteral("payload.estimator"));
    setAccessibleName(tr("Measure payload"));
    auto* title = new QLabel(tr("Measure the payload in several poses"));
    title->setObjectName(QStringLiteral("payload.estimator.title"));
    title->setProperty("role", "strong");
    title->setWordWrap(true);
    take_->setObjectName(QStringLiteral("payload.estimator.take"));
    take_->setProperty("primary", true);
    again_->setObjectName(QStringLiteral("payload.estimator.again"));
    next_->setObjectName(QStringLiteral("payload.estimator.next"));
    next_->setAccessibleName(tr("Next pose, hold"));
    next_->setToolTip(
        tr("Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make "
           "sure that the tool has space to rotate."));
    feedback_->setObjectName(QStringLiteral("payload.estimator.feedback"));
    feedback_->setWordWrap(true);
    poses_->setObjectName(QStringLiteral("payload.estimator.poses"));
    poses_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    poses_->setFont(numberFont(13));
    keep_->setObjectName(QStringLiteral("payload.estimator.keep"));
    keep_->setAccessibleName(keep_->text());
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(QStringLiteral("payload.estimator.cancel"));
    cancel->setAccessibleName(tr("Cancel payload measurement"));

    auto* keys = new QHBoxLayout;
    keys->addWidget(take_, 2);
    keys->addWidget(again_, 2);
    keys->addWidget(next_, 2);
    auto* end = new QHBoxLayout;
    end->addWidget(cancel);
    end->addStretch();
    end->addWidget(keep_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(title);
    layout->addLayout(keys);
    layout->addWidget(feedback_);
    layout->addWidget(poses_, 1);
    layout->addLayout(end);

    next_->setMotion({
        .begin = [this] { return beginMove(); },
        .hold = [this](HoldMotion::Id id) { return port_.hold(id); },
        .end = [this](HoldMotion::Id id, control::StopCause cause) { port_.endMotion(id, cause); },
        .runsToEnd = {},
        .bounds = [this] { return bounds_; },
    });
    connect(&next_->guard(), &HoldGuard::refused, this, [this](const Error& error) {
        problem_ = error.context;
        refresh();
    });
    connect(take_, &QPushButton::clicked, this, &PayloadEstimator::take);
    connect(again_, &QPushButton::clicked, this, [this] {
        if (!readings_.empty()) {
            const int row = estimate_.ok() ? estimate_.worst : static_cast<int>(readings_.size()) - 1;
            readings_.erase(readings_.begin() + row);
            estimate_ = kinematics::estimatePayload(readings_);
            refresh();
        }
    });
    connect(cancel, &QPushButton::clicked, this, [this] {
        next_->guard().stop(control::StopCause::SelectionChanged);
        Q_EMIT cancelled();
    });
    connect(keep_, &QPushButton::clicked, this, [this] {
        next_->guard().stop(control::StopCause::SelectionChanged);
        Q_EMIT found(estimate_.mass, estimate_.centre);
    });
    begin();
}

PayloadEstimator::~PayloadEstimator() {
    next_->guard().stop(control::StopCause::WindowClosed);
}

void PayloadEstimator::begin() {
    readings_.clear();
    estimate_ = {};
    taking_ = false;
    problem_.clear();
    start_ = state_.q;
    refresh();
}

JointPositions PayloadEstimator::nextPose() const {
    JointPositions q = start_;
    const auto& turns = kProposals[readings_.size() % std::size(kProposals)];
    for (int i = 0; i < 3; ++i) {
        const double there = q[3 + i] + turns[i];
        // Rotate in the opposite direction if the joint would leave its position range.
        q[3 + i] = std::abs(there) <= kJointPositionLimit ? there : q[3 + i] - turns[i];
    }
    return q;
}

Result<MotionPort::Id> PayloadEstimator::beginMove() {
    if (!state_.canMove()) {
        return Error{ErrorCode::NoSolution,
                     state_.controlReason.isEmpty() ? tr("Tiller is not in control. Take control first.")
                                                    : state_.controlReason,
                     {}};
    }
    problem_.clear();
    MoveRequest request;
    request.kind = MoveRequest::Kind::MoveJ;
    request.q = nextPose();
    const control::MotionLimits limits = port_.limits();
    request.speed = std::min(
        {kProposedSpeed, limits.jointSpeed,
         kinematics::jointSpeedBound(state_.dh, state_.q, request.q, state_.tcpOffset, limits.tcpSpeed)
             .speed});
    request.acceleration = kProposedAcceleration;
    request = slowedTo(heldSpeed_(), request, state_);
    bounds_ = {HoldBounds::longestOf(moveSeconds(request, state_)),
               HoldBounds::holdTimeoutAt(0, request.speed)};
    return port_.beginMove(request);
}

void PayloadEstimator::take() {
    if (!state_.hasData()) {
        return;
    }
    taking_ = true;
    problem_.clear();
    mean_.begin();
    refresh();
}

void PayloadEstimator::setState(const SessionState& state) {
    const bool hadData = state_.hasData();
    state_ = state;
    if (readings_.empty() && !taking_ && !next_->isHolding()) {
        start_ = state.q;
    }
    next_->setUnavailable(state.canMove() ? QString()
                          : state.controlReason.isEmpty()
                              ? tr("Tiller is not in control. Take control first.")
                              : state.controlReason);
    next_->setConfirmed(next_->isHolding() && state.moving);
    if (taking_) {
        switch (mean_.add(state)) {
            case StandstillMean::Outcome::Collecting:
                break;
            case StandstillMean::Outcome::Moved:
                taking_ = false;
                problem_ =
                    tr("The arm moved. Wait for standstill, keep the tool free of contact, and record the "
                       "pose again.");
                break;
            case StandstillMean::Outcome::NoForce:
                taking_ = false;
                problem_ = tr(
                    "The robot is not sending force data. Enter the mass and the centre of gravity instead.");
                break;
            case StandstillMean::Outcome::Done:
                taking_ = false;
                readings_.push_back(mean_.reading());
                estimate_ = kinematics::estimatePayload(readings_);
                break;
        }
        refresh();
    } else if (hadData != state.hasData()) {
        refresh();
    }
}

QString PayloadEstimator::feedback() const {
    using Problem = kinematics::PayloadEstimate::Problem;
    if (taking_) {
        return tr("Measuring payload… Keep the tool free of contact.");
    }
    if (!problem_.isEmpty()) {
        return problem_;
    }
    switch (estimate_.problem) {
        case Problem::None: {
            const QString result =
                tr("%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.")
                    .arg(format::number(estimate_.mass, 3), format::position(estimate_.centre),
                         format::newtons(estimate_.forceResidual),
                         format::newtonMetres(estimate_.torqueResidual));
            return estimate_.forceResidual > kPoorForce || estimate_.torqueResidual > kPoorTorque
                       ? tr("%1 The accuracy is low: pose %2 deviates most. Remove this pose and record "
                            "another pose.")
                             .arg(result)
                             .arg(estimate_.worst + 1)
                       : result;
        }
        case Problem::TooAlike:
            return tr(
                "The tool orientations are too similar. Record one more pose with the tool rotated in a "
                "different direction.");
        case Problem::NoWeight:
            return tr("The load of %1 kg is too light to measure the centre of gravity. Enter the payload "
                      "manually.")
                .arg(format::number(estimate_.mass, 3));
        case Problem::NotFinite:
            return tr(
                "The robot is not sending force data. Enter the mass and the centre of gravity instead.");
        case Problem::TooFew:
            break;
    }
    return readings_.empty()
               ? tr("Wait for standstill, keep the tool free of contact, and record the pose. Then rotate "
                    "the wrist by jogging or with “Next pose (hold)”, and record three more poses.")
               : tr("Rotate the wrist in a different direction and record the pose. Poses still needed: %n.",
                    nullptr, kinematics::kMinPayloadPoses - static_cast<int>(readings_.size()));
}

void PayloadEstimator::refresh() {
    const QString take = tr("Record pose %1").arg(readings_.size() + 1);
    take_->setText(take);
    take_->setAccessibleName(take);
    take_->setEnabled(state_.hasData() && !taking_);
    const QString again = estimate_.ok() ? tr("Remove least accurate pose") : tr("Remove last pose");
    again_->setText(again);
    again_->setAccessibleName(again);
    again_->setEnabled(!readings_.empty() && !taking_);
    feedback_->setText(feedback());
    QStringList lines;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
        QString line = tr("Pose %1  %2").arg(i + 1).arg(format::newtons(readings_[i].felt.force.norm()));
        if (estimate_.ok() && static_cast<int>(i) == estimate_.worst) {
            line += tr("  ◀ least accurate");
        }
        lines << line;
    }
    poses_->setText(lines.join(QLatin1Char('\n')));
    keep_->setEnabled(estimate_.ok() && !taking_);
}

}  // namespace tiller

#include "moc_payload_estimator.cpp"
