// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_details.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "robot/core/angles.h"
#include "robot/project/waypoint_list.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/figure_box.h"
#include "widgets/common/notation.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

constexpr double kFarthest = 10.0;  ///< [m] no frame of a cell is further from the base
constexpr std::array<const char*, 6> kNames = {"x", "y", "z", "rx", "ry", "rz"};
constexpr std::array<const char*, 6> kLetters = {"X", "Y", "Z", "RX", "RY", "RZ"};

bool asVector() {
    return Notation::current().rotation == RotationNotation::RotationVector;
}

/// The six figures as they are shown.
std::array<double, 6> figuresOf(const Pose& pose) {
    const Eigen::Vector3d position = pose.position / format::metresPerUnit();
    const Eigen::Vector3d turns =
        asVector() ? pose.rotation : Eigen::Vector3d(rpyFromRotationVector(pose.rotation) * toDegrees(1));
    return {position.x(), position.y(), position.z(), turns.x(), turns.y(), turns.z()};
}

}  // namespace

FrameDetails::FrameDetails(QWidget* parent) : QWidget(parent), name_(new QLabel), facts_(new ElidedLabel) {
    setObjectName(QStringLiteral("frame.details"));
    setAccessibleName(tr("Selected frame"));
    name_->setObjectName(QStringLiteral("frame.details.name"));
    name_->setProperty("role", "strong");
    name_->setFont(textFont(15, QFont::Bold));
    facts_->setObjectName(QStringLiteral("frame.details.facts"));
    facts_->setProperty("role", "secondary");
    facts_->setFont(textFont(15));
    const std::array<QString, 6> spoken = {tr("Origin X"),
                                           tr("Origin Y"),
                                           tr("Origin Z"),
                                           tr("Rotation about X (RX)"),
                                           tr("Rotation about Y (RY)"),
                                           tr("Rotation about Z (RZ)")};
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);
    for (int i = 0; i < 6; ++i) {
        const auto at = static_cast<std::size_t>(i);
        auto* letter = new QLabel(QLatin1String(kLetters[at]));
        letter->setProperty("role", "secondary");
        boxes_[at] = new FigureBox;
        boxes_[at]->setObjectName(QStringLiteral("frame.details.") + QLatin1String(kNames[at]));
        boxes_[at]->setAccessibleName(spoken[at]);
        boxes_[at]->setToolTip(
            tr("%1, in Base. Enter applies it; nothing moves but the frame.").arg(spoken[at]));
        boxes_[at]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        boxes_[at]->setProperty("dense", true);
        boxes_[at]->setMinimumWidth(80);
        letter->setBuddy(boxes_[at]);
        grid->addWidget(letter, i / 3, i % 3 * 2);
        grid->addWidget(boxes_[at], i / 3, i % 3 * 2 + 1);
        grid->setColumnStretch(i % 3 * 2 + 1, 1);
        connect(boxes_[at], &FigureBox::editingFinished, this, [this, i] { take(i); });
    }
    auto* headline = new QHBoxLayout;
    headline->setSpacing(6);
    headline->addWidget(name_);
    headline->addWidget(facts_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(8);
    layout->addLayout(headline);
    layout->addLayout(grid);
    setFrame(std::nullopt, 0);
}

void FrameDetails::setFrame(const std::optional<project::Frame>& frame, int waypoints) {
    frame_ = frame;
    waypoints_ = waypoints;
    setEnabled(frame.has_value());
    showFigures();
    showFacts();
}

void FrameDetails::setTcp(const std::optional<Pose>& T_base_tcp) {
    tcp_ = T_base_tcp;
    showFacts();
}

void FrameDetails::editFigures() {
    boxes_[0]->setFocus(Qt::ShortcutFocusReason);
    boxes_[0]->selectAll();
}

QString FrameDetails::headline() const {
    return name_->text() + QLatin1Char(' ') + facts_->fullText();
}

void FrameDetails::showFigures() {
    shown_ = figuresOf(frame_ ? frame_->T_base_frame : Pose());
    const double farthest = kFarthest / format::metresPerUnit();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const bool length = i < 3;
        FigureBox& box = *boxes_[i];
        const QSignalBlocker quiet(box);
        box.setDecimals(length ? (Notation::current().length == LengthUnit::Inches ? 3 : 2)
                               : (asVector() ? 4 : 2));
        const double most = length ? farthest : asVector() ? 2 * std::numbers::pi : 360;
        box.setRange(-most, most);
        box.setSingleStep(length ? 1 : asVector() ? 0.01 : 1);
        box.setSuffix(length       ? QLatin1Char(' ') + format::lengthUnit()
                      : asVector() ? QStringLiteral(" rad")
                                   : QStringLiteral("°"));
        box.setValue(shown_[i]);
        // Rounded to what can be seen: only what was typed counts as a change.
        shown_[i] = box.value();
    }
}

void FrameDetails::showFacts() {
    if (!frame_) {
        name_->clear();
        facts_->setFullText({});
        return;
    }
    QStringList facts = {waypoints_ == 0 ? tr("no waypoint uses it")
                                         : tr("%n waypoints move with it", nullptr, waypoints_)};
    if (tcp_) {
        const project::PoseDifference away = project::poseDifference(frame_->T_base_frame, *tcp_);
        facts << tr("%1 from the TCP").arg(format::difference(away.distance, away.angle));
    }
    name_->setText(frame_->name);
    facts_->setFullText(facts.join(QStringLiteral(" · ")));
    setAccessibleDescription(headline() + QStringLiteral(", ") + format::pose(frame_->T_base_frame));
}

void FrameDetails::take(int figure) {
    const auto at = static_cast<std::size_t>(figure);
    if (!frame_ || boxes_[at]->value() == shown_[at]) {
        return;
    }
    shown_[at] = boxes_[at]->value();
    // The other figures keep the digits that are not shown.
    Pose pose = frame_->T_base_frame;
    if (figure < 3) {
        pose.position[figure] = shown_[at] * format::metresPerUnit();
    } else if (asVector()) {
        pose.rotation[figure - 3] = shown_[at];
        pose.rotation = rotationVector(rotationMatrix(pose.rotation));
    } else {
        Eigen::Vector3d rpy = rpyFromRotationVector(pose.rotation);
        rpy[figure - 3] = toRadians(shown_[at]);
        pose.rotation = rotationVectorFromRpy(rpy);
    }
    Q_EMIT placeEntered(pose);
}

void FrameDetails::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && boxes_[5] != nullptr) {
        showFigures();
        showFacts();
    }
    QWidget::changeEvent(event);
}

void FrameDetails::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(Theme::current().border);
    painter.drawLine(0, 0, width(), 0);
}

}  // namespace tiller
