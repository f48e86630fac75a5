// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/jog_selectors.h"

#include <QAbstractButton>
#include <QFontMetrics>
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <algorithm>

#include "robot/core/angles.h"
#include "widgets/common/format.h"
#include "widgets/common/notation.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kMargin = 12;
constexpr int kKey = 38;         // height of a key [px]
constexpr int kCompactKey = 30;  // in a low window
constexpr int kTaughtSegment = 3;
constexpr int kLongestName = 84;  // [px] of a frame, on its key
constexpr int kChoiceSegment = static_cast<int>(MotionChoice::CoarseStep);

/// "5 mm or 15°"
QString stepText(const StepSize& step) {
    return JogSelectors::tr("%1, turns %2°")
        .arg(format::shortLength(step.length))
        .arg(toDegrees(step.angle), 0, 'g', 3);
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
    // The other words follow the operator's units; see refreshTexts().
    motion_ = new SegmentedControl({tr("Hold"), {}, {}, {}}, this);
    motion_->setNames(QStringLiteral("jogMotion"), tr("Motion"));
    motion_->segment(0)->setToolTip(tr("Moves while the key is held"));
    speed_ = new SegmentedControl(QStringList(kSpeedClassCount), this);
    speed_->setNames(QStringLiteral("jogSpeed"), tr("Speed"));
    speed_->setCurrentIndex(kStartSpeedClass);
    int row = 0;
    for (const auto& [text, control] :
         {std::pair{tr("Frame"), frame_}, {tr("Motion"), motion_}, {tr("Speed"), speed_}}) {
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
    connect(motion_, &SegmentedControl::currentChanged, this, [this](int index) {
        Q_EMIT changing(StopCause::SelectionChanged);
        selection_.motion = static_cast<MotionChoice>(index);
        if (selection_.motion != MotionChoice::CoarseStep) {
            selection_.step.reset();
        }
        refreshTexts();
    });
    connect(speed_, &SegmentedControl::currentChanged, this, [this](int index) {
        Q_EMIT changing(StopCause::SelectionChanged);
        selection_.speedClass = index;
        selection_.speed.reset();
        refreshTexts();
    });
    offerChoices(motion_, static_cast<int>(MotionChoice::CoarseStep),
                 [this](QMenu& menu) { fillStepMenu(menu); });
    offerChoices(speed_, kSpeedClassCount - 1, [this](QMenu& menu) { fillSpeedMenu(menu); });
    // With several taught frames the fourth key opens the list.
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
}

void JogSelectors::showFrames() {
    frame_->setSegmentEnabled(
        static_cast<int>(FrameChoice::View), hasView_,
        hasView_ ? tr("Axes of the picture: X right, Y away from you, Z up") : tr("Needs the 3D view"));
    const bool any = !frames_.isEmpty();
    const QString name =
        any ? (selection_.taught ? selection_.taught->name : frames_.first().name) : tr("Frame");
    // A name may be longer than a key.
    const QString shown =
        QFontMetrics(textFont(15, QFont::Bold)).elidedText(name, Qt::ElideRight, kLongestName);
    frame_->setText(kTaughtSegment, frames_.size() > 1 ? shown + QStringLiteral(" ▾") : shown);
    frame_->setSegmentEnabled(kTaughtSegment, any,
                              any ? name : tr("No frame taught yet. Teach one in the tab Frames."));
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
}

void JogSelectors::setTaughtFrames(const QVector<TaughtFrame>& frames) {
    if (selection_.frame == FrameChoice::Taught) {
        Q_EMIT changing(StopCause::SelectionChanged);
    }
    frames_ = frames;
    const TaughtFrame* same = nullptr;
    for (const TaughtFrame& taught : frames_) {
        // By its id: a frame with another name is the same frame.
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
}

void JogSelectors::chooseTaughtFrame(const QUuid& frame) {
    for (const TaughtFrame& taught : frames_) {
        if (taught.id == frame) {
            Q_EMIT changing(StopCause::SelectionChanged);
            selection_.taught = taught;
            frame_->setCurrentIndex(kTaughtSegment);
            showFrames();
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

void JogSelectors::setFreeStep(const StepSize& step) {
    Q_EMIT changing(StopCause::SelectionChanged);
    motion_->setCurrentIndex(kChoiceSegment);
    selection_.motion = MotionChoice::CoarseStep;
    selection_.step = step;
    refreshTexts();
}

void JogSelectors::setUntilContact(double force) {
    Q_EMIT changing(StopCause::SelectionChanged);
    motion_->setCurrentIndex(kChoiceSegment);
    selection_.motion = MotionChoice::UntilContact;
    selection_.contactForce = std::clamp(force, kLeastContactForce, kMostContactForce);
    refreshTexts();
}

void JogSelectors::setCompact(bool compact) {
    for (SegmentedControl* control : {frame_, motion_, speed_}) {
        control->setFixedHeight(compact ? kCompactKey : kKey);
    }
}

int JogSelectors::heightWhen(bool compact) const {
    int height = minimumSizeHint().height();
    for (const SegmentedControl* control : {frame_, motion_, speed_}) {
        height += (compact ? kCompactKey : kKey) - control->minimumHeight();
    }
    return height;
}

void JogSelectors::refreshTexts() {
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

void JogSelectors::offerChoices(SegmentedControl* control, int segment, std::function<void(QMenu&)> fill) {
    QAbstractButton* key = control->segment(segment);
    const auto open = [this, key, fill = std::move(fill)] {
        Q_EMIT changing(StopCause::SelectionChanged);
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

void JogSelectors::fillStepMenu(QMenu& menu) {
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

void JogSelectors::fillSpeedMenu(QMenu& menu) {
    menu.addAction(format::speed(kSlowestJog), this, [this] { setFreeSpeed(kSlowestJog); });
    menu.addAction(format::speed(speedClasses().back().tcp), this,
                   [this] { setSpeedClass(kSpeedClassCount - 1); });
    menu.addAction(tr("Other speed…"), this, [this] { askFor(Entry::Speed); });
}

void JogSelectors::askFor(Entry entry) {
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
                         chosenSpeed(selection_).tcp / unit, 0.0005 / unit, limits_().tcpSpeed / unit,
                         coarse ? 3 : 1, [this, unit](double value) { setFreeSpeed(value * unit); });
            break;
        case Entry::ContactForce:
            askForNumber(tr("Force that ends the motion, in N"), selection_.contactForce, kLeastContactForce,
                         kMostContactForce, 0, [this](double value) { setUntilContact(value); });
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
