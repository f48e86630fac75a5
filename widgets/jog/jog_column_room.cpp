// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the column that says how much room is left, and takes sizes entered by hand.

#include <QAbstractButton>
#include <QCoreApplication>
#include <QEvent>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>

#include "robot/core/angles.h"
#include "widgets/common/format.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/notation.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_column.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/pose_view.h"
#include "widgets/session/texts.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kChoiceSegment = static_cast<int>(MotionChoice::CoarseStep);

/// "5 mm or 15°"
QString stepText(const StepSize& step) {
    return QCoreApplication::translate("JogColumn", "%1, turns %2°")
        .arg(format::shortLength(step.length))
        .arg(toDegrees(step.angle), 0, 'g', 3);
}

bool near(const JointPositions& a, const JointPositions& b, double distance) {
    return (a.values - b.values).cwiseAbs().maxCoeff() <= distance;
}

}  // namespace

// ---- limits and room -------------------------------------------------------------------------------------

void JogColumn::showLimiter() {
    // The way out is looked for along twelve directions: not at every picture of a moving arm.
    const double unchanged = state_.motionActive ? 0.02 : 0.002;
    const bool sameLimit = state_.limiter.kind == limiterSeen_.kind &&
                           std::abs(state_.limiter.scale - limiterSeen_.scale) < 0.03;
    if (!state_.hasData()) {
        nearest_ = {};
        limiterAt_ = {};
    } else if (!sameLimit || !near(state_.q, limiterAt_, unchanged)) {
        nearest_ = nearestLimiter(state_, frameAxes(selection_, state_.tcpPose));
        limiterAt_ = state_.q;
        limiterSeen_ = state_.limiter;
    }
    limiter_->setLimiter(nearest_);
}

QString JogColumn::travelText(const Travel& travel, bool turns) const {
    if (travel.end == Travel::End::Open) {
        return {};
    }
    return turns ? format::number(toDegrees(travel.left), 0) + QStringLiteral("°")
                 : format::length(travel.left, 0);
}

void JogColumn::lookAround() {
    const QVector<JogKey*>& keys = pad_->keys();
    if (!state_.hasData() || !state_.canMove()) {
        for (JogKey* key : keys) {
            key->setTravel({}, false);
        }
        room_ = {};
        lookLeft_ = 0;
        lookedIn_.setZero();
        return;
    }
    const Eigen::Matrix3d axes = frameAxes(selection_, state_.tcpPose);
    if (!near(state_.q, lookedFrom_, 0.002) || !axes.isApprox(lookedIn_, 1e-6)) {
        lookedFrom_ = state_.q;
        lookedIn_ = axes;
        lookLeft_ = static_cast<int>(keys.size());
    }
    if (lookLeft_ == 0) {
        return;
    }
    --lookLeft_;
    const auto index = static_cast<std::size_t>(look_++ % keys.size());
    JogKey* key = keys[static_cast<qsizetype>(index)];
    const bool turns = key->key().axis >= 3;
    Vector6 direction = Vector6::Zero();
    direction.segment<3>(turns ? 3 : 0) = axes.col(key->key().axis % 3) * key->key().direction;
    const Travel travel = travelLeft(robotModel(state_.model).dh, state_.q, state_.tcpOffset, direction);
    room_.at(index) = travel;
    const bool little = travel.end != Travel::End::Open && travel.left < (turns ? toRadians(10) : 0.03);
    key->setTravel(travelText(travel, turns), little);
}

QString JogColumn::quietText() const {
    // While a key is held: what is left that way, and what will end it.
    for (qsizetype i = 0; i < pad_->keys().size(); ++i) {
        const JogKey* key = pad_->keys()[i];
        const Travel& travel = room_.at(static_cast<std::size_t>(i));
        if (!key->isHolding() || key->travel().isEmpty()) {
            continue;
        }
        return travel.end == Travel::End::JointLimit
                   ? tr("%1: %2 left, then %3 is at its limit")
                         .arg(key->text(), key->travel(), jointName(travel.joint))
                   : tr("%1: %2 left, then the end of the reach or a singularity")
                         .arg(key->text(), key->travel());
    }
    const control::StopMeasurement& stop = state_.lastStop;
    if (stop.count == 0) {
        return {};
    }
    return tr("Last stop: %1, standstill after %2 ms, %3")
        .arg(texts::stopCauseText(stop.cause))
        .arg(stop.durationMs, 0, 'f', 0)
        .arg(format::length(stop.distanceMm / 1e3, 1));
}

// ---- sizes entered by hand -------------------------------------------------------------------------------

void JogColumn::setFreeSpeed(double tcpSpeed) {
    stopMotion(StopCause::SelectionChanged);
    const double speed = std::clamp(tcpSpeed, 0.0005, port_.limits().tcpSpeed);
    speed_->setCurrentIndex(kSpeedClassCount - 1);
    selection_.speed = speedFor(speed);
    showMotionTexts();
}

void JogColumn::setFreeStep(const StepSize& step) {
    stopMotion(StopCause::SelectionChanged);
    motion_->setCurrentIndex(kChoiceSegment);
    selection_.motion = MotionChoice::CoarseStep;
    selection_.step = step;
    showMotionTexts();
}

void JogColumn::setUntilContact(double force) {
    stopMotion(StopCause::SelectionChanged);
    motion_->setCurrentIndex(kChoiceSegment);
    selection_.motion = MotionChoice::UntilContact;
    selection_.contactForce = std::clamp(force, kLeastContactForce, kMostContactForce);
    showMotionTexts();
}

void JogColumn::setFreedriveAxes(FreedriveAxes axes) {
    freedrive_->guard().stop(StopCause::SelectionChanged);
    freedriveAxes_ = axes;
    freedrive_->setToolTip(
        tr("The arm follows the hand while held: %1. Right click: other axes").arg(freedriveAxesText(axes)));
    freedrive_->setAccessibleName(tr("Freedrive, %1").arg(freedriveAxesText(axes)));
    freedrive_->setText(axes == FreedriveAxes::All ? tr("Freedrive") : tr("Freedrive…"));
}

void JogColumn::zeroHere() {
    pose_->zeroHere();
}

void JogColumn::showMotionTexts() {
    for (const MotionChoice choice : {MotionChoice::FineStep, MotionChoice::Step}) {
        const StepSize step = stepSize(choice);
        const int segment = static_cast<int>(choice);
        motion_->setText(segment, format::shortLengthNumber(step.length));
        motion_->segment(segment)->setToolTip(tr("One step a press: %1").arg(stepText(step)));
    }
    const bool contact = selection_.motion == MotionChoice::UntilContact;
    const StepSize step = selection_.step.value_or(stepSize(MotionChoice::CoarseStep));
    motion_->setText(kChoiceSegment, contact
                                         ? tr("≤ %1").arg(format::number(selection_.contactForce, 0) + " N")
                                         : format::shortLength(step.length));
    motion_->segment(kChoiceSegment)
        ->setToolTip(
            contact ? tr("Slowly until the tool touches something with %1 N, while held. Click again for "
                         "other steps")
                          .arg(selection_.contactForce, 0, 'f', 0)
                    : tr("One step a press: %1. Click again for other steps").arg(stepText(step)));
    for (int i = 0; i < kSpeedClassCount; ++i) {
        const SpeedClass& speed = speedClasses()[static_cast<std::size_t>(i)];
        speed_->setText(i, format::speedNumber(speed.tcp));
        speed_->segment(i)->setToolTip(tr("%1 · turns %2 · joints %3 · Ctrl × 0.1, Shift × 3")
                                           .arg(format::speed(speed.tcp),
                                                format::degreesPerSecond(speed.rotation),
                                                format::degreesPerSecond(speed.joint)));
    }
    const double speed = selection_.speed ? selection_.speed->tcp : speedClasses().back().tcp;
    speed_->setText(kSpeedClassCount - 1, format::speed(speed));
}

void JogColumn::changeEvent(QEvent* event) {
    // Not before the column is built: back_ comes last.
    if (event->type() == QEvent::StyleChange && back_ != nullptr) {
        showMotionTexts();  // other units
        lookedIn_.setZero();
        for (JogKey* key : pad_->keys()) {
            key->setTravel({}, false);
        }
        showReason();
    }
    Panel::changeEvent(event);
}

void JogColumn::offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill) {
    QAbstractButton* key = control->segment(segment);
    const auto open = [this, key, fill = std::move(fill)] {
        stopMotion(StopCause::SelectionChanged);
        QMenu menu(this);
        menu.setObjectName(key->objectName() + QStringLiteral(".menu"));
        fill(menu);
        menu.exec(key->mapToGlobal(QPoint(0, key->height())));
    };
    // The first click chooses the key, the next one opens what else it can be.
    connect(key, &QAbstractButton::pressed, this, [control, key, segment] {
        key->setProperty("chosenBefore", control->currentIndex() == segment);
    });
    connect(key, &QAbstractButton::clicked, this, [key, open] {
        if (key->property("chosenBefore").toBool()) {
            open();
        }
    });
    key->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(key, &QWidget::customContextMenuRequested, this, open);
}

void JogColumn::fillStepMenu(QMenu& menu) {
    for (const StepPreset& preset : kStepPresets) {
        const StepSize step = preset.size();
        menu.addAction(stepText(step), this, [this, step] { setFreeStep(step); });
    }
    menu.addAction(tr("Other step…"), this, [this] { askFor(Entry::Step); });
    menu.addSeparator();
    menu.addAction(tr("Until contact, %1 N").arg(selection_.contactForce, 0, 'f', 0), this,
                   [this] { setUntilContact(selection_.contactForce); });
    menu.addAction(tr("Until contact, other force…"), this, [this] { askFor(Entry::ContactForce); });
}

void JogColumn::fillSpeedMenu(QMenu& menu) {
    menu.addAction(format::speed(kSlowestJog), this, [this] { setFreeSpeed(kSlowestJog); });
    menu.addAction(format::speed(speedClasses().back().tcp), this,
                   [this] { setSpeedClass(kSpeedClassCount - 1); });
    menu.addAction(tr("Other speed…"), this, [this] { askFor(Entry::Speed); });
}

void JogColumn::fillFreedriveMenu(QMenu& menu) {
    for (const FreedriveAxes axes : kFreedriveAxes) {
        QAction* action =
            menu.addAction(freedriveAxesText(axes), this, [this, axes] { setFreedriveAxes(axes); });
        action->setCheckable(true);
        action->setChecked(axes == freedriveAxes_);
    }
    menu.addSeparator();
    QAction* check = menu.addAction(tr("Check the payload first (until the next connection)"), this,
                                    [this] { payloadChecked_ = !payloadChecked_; });
    check->setCheckable(true);
    check->setChecked(payloadChecked_);
}

void JogColumn::askFor(Entry entry) {
    const double unit = format::metresPerUnit();
    const bool coarse = unit > 1e-3;  // two more digits in inches
    switch (entry) {
        case Entry::Step:
            askForNumber(tr("Step in %1 (turns: as many degrees as millimetres)").arg(format::lengthUnit()),
                         0.002 / unit, 1e-5 / unit, 0.5 / unit, coarse ? 4 : 2, [this, unit](double value) {
                             const double metres = value * unit;
                             setFreeStep({metres, toRadians(std::min(metres * 1e3, 180.0))});
                         });
            break;
        case Entry::Speed:
            askForNumber(tr("Speed of the TCP in %1").arg(format::speedUnit()),
                         chosenSpeed(selection_).tcp / unit, 0.0005 / unit, port_.limits().tcpSpeed / unit,
                         coarse ? 3 : 1, [this, unit](double value) { setFreeSpeed(value * unit); });
            break;
        case Entry::ContactForce:
            askForNumber(tr("Force that ends the motion, in N"), selection_.contactForce, kLeastContactForce,
                         kMostContactForce, 0, [this](double value) { setUntilContact(value); });
            break;
    }
}

void JogColumn::askForNumber(const QString& text, double value, double least, double most, int digits,
                             std::function<void(double)> use) {
    stopMotion(StopCause::DialogOpened);
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("jogNumber"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::DoubleInput);
    dialog->setLabelText(text);
    dialog->setDoubleDecimals(digits);
    dialog->setDoubleRange(least, most);
    dialog->setDoubleValue(value);
    connect(dialog, &QInputDialog::doubleValueSelected, this,
            [use = std::move(use)](double chosen) { use(chosen); });
    dialog->open();
}

}  // namespace tiller
