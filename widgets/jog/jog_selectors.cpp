// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/jog_selectors.h"

#include <QAbstractButton>
#include <QFontMetrics>
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kMargin = 12;
constexpr int kTaughtSegment = 3;
constexpr int kMaxNameLength = 84;  // maximum width of a frame name on its button [px]
/// Segments of the length and angle rows: Hold, three sizes, and a user-defined size.
constexpr int kHoldSegment = 0;
constexpr int kOtherSegment = 4;
constexpr std::array kSizes = {MotionChoice::FineStep, MotionChoice::Step, MotionChoice::CoarseStep};

bool isSame(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

int lengthSegment(double length) {
    for (const MotionChoice size : kSizes) {
        if (isSame(stepSize(size).length, length)) {
            return static_cast<int>(size);
        }
    }
    return kOtherSegment;
}

int angleSegment(double angle) {
    for (const MotionChoice size : kSizes) {
        if (isSame(stepSize(size).angle, angle)) {
            return static_cast<int>(size);
        }
    }
    return kOtherSegment;
}

/// Returns a sentence for the tooltip that explains whether the step continues after the release.
QString stepNote(MotionChoice motion, const std::optional<StepSize>& other, bool turns) {
    JogSelection selection;
    selection.motion = motion;
    selection.step = other;
    return QLatin1Char('\n') +
           (stepRunsToEnd(selection, turns)
                ? JogSelectors::tr(
                      "The step continues after the button is released. Space, Esc and STOP end the step.")
                : JogSelectors::tr("Hold the button until the step is complete."));
}

/// Formats an angle in degrees with as few digits as possible, e.g. "0.1", "45".
QString angleNumber(double angle) {
    const double degrees = toDegrees(angle);
    const bool whole = std::abs(degrees - std::round(degrees)) < 1e-6;
    return format::number(degrees, whole ? 0 : degrees < 0.095 ? 2 : 1);
}

QString angleText(double angle) {
    return angleNumber(angle) + QStringLiteral("°");
}

}  // namespace

JogSelectors::JogSelectors(std::function<control::MotionLimits()> limits, QWidget* parent)
    : QWidget(parent), limits_(std::move(limits)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(kMargin, 0, kMargin, 6);
    grid->setHorizontalSpacing(0);
    grid->setVerticalSpacing(10);
    grid->setColumnMinimumWidth(0, 62);
    frame_ = new SegmentedControl({tr("Base"), tr("Tool"), tr("View"), tr("Frame")}, this);
    frame_->setNames(QStringLiteral("jogFrame"), tr("Frame"));
    // refreshTexts() sets the other texts, which depend on the user's units.
    motion_ = new SegmentedControl({tr("Hold"), {}, {}, {}, {}}, this);
    motion_->setNames(QStringLiteral("jogMotion"), tr("Motion"));
    motion_->segment(kHoldSegment)->setToolTip(tr("Moves while the button is held"));
    turn_ = new SegmentedControl({tr("Hold"), {}, {}, {}, {}}, this);
    turn_->setNames(QStringLiteral("jogTurn"), tr("Rotation"));
    turn_->segment(kHoldSegment)->setToolTip(tr("Rotates while the button is held"));
    speed_ = new SegmentedControl(QStringList(kSpeedClassCount), this);
    speed_->setNames(QStringLiteral("jogSpeed"), tr("Speed"));
    speed_->setCurrentIndex(kStartSpeedClass);
    int row = 0;
    for (const auto& [text, control] : {std::pair{tr("Frame"), frame_},
                                        {tr("Motion"), motion_},
                                        {tr("Rotation"), turn_},
                                        {tr("Speed"), speed_}}) {
        auto* label = new QLabel(text, this);
        label->setFont(textFont(15));
        label->setProperty("role", QStringLiteral("secondary"));
        grid->addWidget(label, row, 0);
        grid->addWidget(control, row, 1);
        ++row;
    }
    grid->setColumnStretch(1, 1);
    connectControls();
    showFrames();
    refreshTexts();
}

void JogSelectors::connectControls() {
    connect(frame_, &SegmentedControl::currentChanged, this, &JogSelectors::chooseFrame);
    connect(motion_, &SegmentedControl::currentChanged, this,
            [this](int segment) { chooseStep(&StepSize::length, segment); });
    connect(turn_, &SegmentedControl::currentChanged, this,
            [this](int segment) { chooseStep(&StepSize::angle, segment); });
    connect(speed_, &SegmentedControl::currentChanged, this, [this](int index) {
        Q_EMIT changing(StopCause::SelectionChanged);
        selection_.speedClass = index;
        selection_.speed.reset();
        refreshTexts();
    });
    offerChoices(motion_, kOtherSegment, [this](QMenu& menu) { fillLengthMenu(menu); });
    offerChoices(turn_, kOtherSegment, [this](QMenu& menu) { fillAngleMenu(menu); });
    offerChoices(speed_, kSpeedClassCount - 1, [this](QMenu& menu) { fillSpeedMenu(menu); });
    // With several taught frames, the fourth button opens a list.
    connect(frame_->segment(kTaughtSegment), &QAbstractButton::clicked, this, [this] {
        if (frames_.size() < 2) {
            return;
        }
        Q_EMIT changing(StopCause::SelectionChanged);
        QMenu menu(this);
        for (const TaughtFrame& taught : frames_) {
            menu.addAction(taught.name, this, [this, id = taught.id] { chooseTaughtFrame(id); });
        }
        const QWidget* key = frame_->segment(kTaughtSegment);
        menu.exec(key->mapToGlobal(QPoint(0, key->height())));
    });
}

void JogSelectors::chooseFrame(int segment) {
    Q_EMIT changing(StopCause::SelectionChanged);
    selection_.frame = static_cast<FrameChoice>(segment);
    if (selection_.frame == FrameChoice::Taught && !selection_.taught && !frames_.isEmpty()) {
        selection_.taught = frames_.first();
        showFrames();
    }
    Q_EMIT changed();
}

void JogSelectors::showFrames() {
    frame_->setSegmentEnabled(
        static_cast<int>(FrameChoice::View), hasView_,
        hasView_ ? tr("View axes: X right, Y away from you, Z up") : tr("Requires the 3D view"));
    const bool any = !frames_.isEmpty();
    const QString name =
        any ? (selection_.taught ? selection_.taught->name : frames_.first().name) : tr("Frame");
    // Elide the name, because it may be wider than the button.
    const QString shown =
        QFontMetrics(textFont(15, QFont::Bold)).elidedText(name, Qt::ElideRight, kMaxNameLength);
    frame_->setText(kTaughtSegment, frames_.size() > 1 ? shown + QStringLiteral(" ▾") : shown);
    frame_->setSegmentEnabled(kTaughtSegment, any,
                              any ? name : tr("No frame taught yet. Teach a frame on the Frames tab."));
}

void JogSelectors::setViewRotation(const Eigen::Matrix3d& R_base_view) {
    if (selection_.frame == FrameChoice::View && !selection_.R_base_view.isApprox(R_base_view, 1e-9)) {
        Q_EMIT changing(StopCause::SelectionChanged);
    }
    selection_.R_base_view = R_base_view;
    if (!hasView_) {
        hasView_ = true;
        showFrames();
    }
    if (selection_.frame == FrameChoice::View) {
        Q_EMIT changed();
    }
}

void JogSelectors::setTaughtFrames(const QVector<TaughtFrame>& frames) {
    if (selection_.frame == FrameChoice::Taught) {
        Q_EMIT changing(StopCause::SelectionChanged);
    }
    frames_ = frames;
    const TaughtFrame* same = nullptr;
    for (const TaughtFrame& taught : frames_) {
        // Compare IDs, because a frame may have been renamed.
        if (selection_.taught && taught.id == selection_.taught->id) {
            same = &taught;
        }
    }
    if (same != nullptr) {
        selection_.taught = *same;
    } else {
        selection_.taught.reset();
        if (selection_.frame == FrameChoice::Taught) {
            frame_->setCurrentIndex(static_cast<int>(FrameChoice::Base));
        }
    }
    showFrames();
    Q_EMIT changed();
}

void JogSelectors::chooseTaughtFrame(const QUuid& frame) {
    for (const TaughtFrame& taught : frames_) {
        if (taught.id == frame) {
            Q_EMIT changing(StopCause::SelectionChanged);
            selection_.taught = taught;
            frame_->setCurrentIndex(kTaughtSegment);
            showFrames();
            Q_EMIT changed();
            return;
        }
    }
}

void JogSelectors::setSpeedClass(int index) {
    Q_EMIT changing(StopCause::SelectionChanged);
    selection_.speed.reset();
    speed_->setCurrentIndex(index);
    refreshTexts();
}

void JogSelectors::setFreeSpeed(double tcpSpeed) {
    Q_EMIT changing(StopCause::SelectionChanged);
    const double speed = std::clamp(tcpSpeed, 0.0005, limits_().tcpSpeed);
    speed_->setCurrentIndex(kSpeedClassCount - 1);
    selection_.speed = speedFor(speed);
    refreshTexts();
}

void JogSelectors::chooseStep(double StepSize::*size, int segment) {
    if (following_) {
        return;
    }
    Q_EMIT changing(StopCause::SelectionChanged);
    if (segment == kHoldSegment) {
        choose(MotionChoice::Hold);
        return;
    }
    step_.*size =
        segment == kOtherSegment ? other_.*size : stepSize(static_cast<MotionChoice>(segment)).*size;
    choose(MotionChoice::CoarseStep);
}

void JogSelectors::choose(MotionChoice motion) {
    selection_.motion = motion;
    selection_.step.reset();
    if (!isHeld(motion)) {
        selection_.step = step_;
    }
    const bool contact = motion == MotionChoice::UntilContact;
    following_ = true;
    motion_->setCurrentIndex(contact          ? kOtherSegment
                             : isHeld(motion) ? kHoldSegment
                                              : lengthSegment(step_.length));
    turn_->setCurrentIndex(isHeld(motion) ? kHoldSegment : angleSegment(step_.angle));
    following_ = false;
    refreshTexts();
}

void JogSelectors::setFreeStep(const StepSize& step) {
    Q_EMIT changing(StopCause::SelectionChanged);
    step_ = step;
    if (lengthSegment(step.length) == kOtherSegment) {
        other_.length = step.length;
    }
    if (angleSegment(step.angle) == kOtherSegment) {
        other_.angle = step.angle;
    }
    choose(MotionChoice::CoarseStep);
}

void JogSelectors::setStepLength(double length) {
    setFreeStep({length, step_.angle});
}

void JogSelectors::setStepAngle(double angle) {
    setFreeStep({step_.length, angle});
}

void JogSelectors::setUntilContact(double force) {
    Q_EMIT changing(StopCause::SelectionChanged);
    selection_.contactForce = std::clamp(force, kMinContactForce, kMaxContactForce);
    choose(MotionChoice::UntilContact);
}

void JogSelectors::setRowHeight(int height, int spacing) {
    for (SegmentedControl* control : {frame_, motion_, turn_, speed_}) {
        control->setFixedHeight(height);
    }
    auto* grid = static_cast<QGridLayout*>(layout());
    if (grid->verticalSpacing() != spacing) {
        grid->setVerticalSpacing(spacing);
    }
}

int JogSelectors::heightWhen(int height, int spacing) const {
    const auto* grid = static_cast<const QGridLayout*>(layout());
    int whole = minimumSizeHint().height() + (grid->rowCount() - 1) * (spacing - grid->verticalSpacing());
    for (const SegmentedControl* control : {frame_, motion_, turn_, speed_}) {
        whole += height - control->minimumHeight();
    }
    return whole;
}

void JogSelectors::refreshTexts() {
    for (const MotionChoice choice : kSizes) {
        const StepSize step = stepSize(choice);
        const int segment = static_cast<int>(choice);
        motion_->setText(segment, format::shortLengthNumber(step.length));
        motion_->segment(segment)->setToolTip(
            tr("Moves by %1 per press.").arg(format::shortLength(step.length)) + stepNote(choice, {}, false));
        turn_->setText(segment, angleNumber(step.angle));
        turn_->segment(segment)->setToolTip(
            tr("Rotates the tool or joint by %1 per press.").arg(angleText(step.angle)) +
            stepNote(choice, {}, true));
    }
    const bool contact = selection_.motion == MotionChoice::UntilContact;
    // Only the last button of each row shows the unit.
    motion_->setText(kOtherSegment, contact
                                        ? tr("≤ %1").arg(format::number(selection_.contactForce, 0) + " N")
                                        : format::shortLength(other_.length));
    motion_->segment(kOtherSegment)
        ->setToolTip(contact ? tr("Moves slowly while the button is held, until the contact force reaches %1 "
                                  "N. Click again to select a different step.")
                                   .arg(selection_.contactForce, 0, 'f', 0)
                             : tr("Moves by %1 per press. Click again to select a different step.")
                                       .arg(format::shortLength(other_.length)) +
                                   stepNote(MotionChoice::Step, other_, false));
    turn_->setText(kOtherSegment, angleText(other_.angle));
    turn_->segment(kOtherSegment)
        ->setToolTip(tr("Rotates the tool or joint by %1 per press. Click again to select a different angle.")
                         .arg(angleText(other_.angle)) +
                     stepNote(MotionChoice::Step, other_, true));
    for (int i = 0; i < kSpeedClassCount; ++i) {
        const SpeedClass& speed = speedClasses()[static_cast<std::size_t>(i)];
        speed_->setText(i, format::speedNumber(speed.tcp));
        speed_->segment(i)->setToolTip(tr("%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3")
                                           .arg(format::speed(speed.tcp),
                                                format::degreesPerSecond(speed.rotation),
                                                format::degreesPerSecond(speed.joint)));
    }
    constexpr double kWidestSpeed = 0.25;  // [m/s]
    speed_->reserve(kSpeedClassCount - 1, format::speed(kWidestSpeed));
    const double speed = selection_.speed ? selection_.speed->tcp : speedClasses().back().tcp;
    speed_->setText(kSpeedClassCount - 1, format::speed(speed));
    Q_EMIT changed();
}

void JogSelectors::offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill) {
    QAbstractButton* key = control->segment(segment);
    const auto open = [this, key, fill = std::move(fill)] {
        Q_EMIT changing(StopCause::SelectionChanged);
        QMenu menu(this);
        menu.setObjectName(key->objectName() + QStringLiteral(".menu"));
        fill(menu);
        menu.exec(key->mapToGlobal(QPoint(0, key->height())));
    };
    // The first click selects the button. A click on the selected button opens its menu.
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

void JogSelectors::fillAngleMenu(QMenu& menu) {
    for (const StepPreset& preset : kStepPresets) {
        const double angle = preset.size().angle;
        menu.addAction(angleText(angle), this, [this, angle] { setStepAngle(angle); });
    }
    menu.addAction(tr("Other angle…"), this, [this] { askFor(Entry::Turn); });
}

void JogSelectors::fillLengthMenu(QMenu& menu) {
    for (const StepPreset& preset : kStepPresets) {
        const double length = preset.size().length;
        menu.addAction(format::shortLength(length), this, [this, length] { setStepLength(length); });
    }
    menu.addAction(tr("Other step…"), this, [this] { askFor(Entry::Step); });
    menu.addSeparator();
    menu.addAction(tr("Until contact, %1 N").arg(selection_.contactForce, 0, 'f', 0), this,
                   [this] { setUntilContact(selection_.contactForce); });
    menu.addAction(tr("Other contact force…"), this, [this] { askFor(Entry::ContactForce); });
}

void JogSelectors::fillSpeedMenu(QMenu& menu) {
    menu.addAction(format::speed(kSlowestJog), this, [this] { setFreeSpeed(kSlowestJog); });
    menu.addAction(format::speed(speedClasses().back().tcp), this,
                   [this] { setSpeedClass(kSpeedClassCount - 1); });
    menu.addAction(tr("Other speed…"), this, [this] { askFor(Entry::Speed); });
}

void JogSelectors::askFor(Entry entry) {
    const double unit = format::metresPerUnit();
    const bool coarse = unit > 1e-3;  // lengths in inches need two more digits
    switch (entry) {
        case Entry::Step:
            askForNumber(tr("Step in %1").arg(format::lengthUnit()), 0.002 / unit, 1e-5 / unit, 0.5 / unit,
                         coarse ? 4 : 2, [this, unit](double value) { setStepLength(value * unit); });
            break;
        case Entry::Turn:
            askForNumber(tr("Angle in degrees"), 2, 0.01, 179, 2,
                         [this](double value) { setStepAngle(toRadians(value)); });
            break;
        case Entry::Speed:
            askForNumber(tr("TCP speed in %1").arg(format::speedUnit()), chosenSpeed(selection_).tcp / unit,
                         0.0005 / unit, limits_().tcpSpeed / unit, coarse ? 3 : 1,
                         [this, unit](double value) { setFreeSpeed(value * unit); });
            break;
        case Entry::ContactForce:
            askForNumber(tr("Contact force that ends the motion, in N"), selection_.contactForce,
                         kMinContactForce, kMaxContactForce, 0,
                         [this](double value) { setUntilContact(value); });
            break;
    }
}

void JogSelectors::askForNumber(const QString& text, double value, double least, double most, int digits,
                                std::function<void(double)> use) {
    Q_EMIT changing(StopCause::DialogOpened);
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

#include "moc_jog_selectors.cpp"
