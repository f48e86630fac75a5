// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_details.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStringList>
#include <QVBoxLayout>

#include "robot/project/waypoint_list.h"
#include "robot/station/text/notation.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/pose_editor.h"
#include "widgets/common/theme.h"

namespace tiller {

FrameDetails::FrameDetails(QWidget* parent) : QWidget(parent), name_(new QLabel), facts_(new ElidedLabel) {
    setObjectName(QStringLiteral("frame.details"));
    setAccessibleName(tr("Selected frame"));
    name_->setObjectName(QStringLiteral("frame.details.name"));
    name_->setProperty("role", "strong");
    name_->setFont(textFont(15, QFont::Bold));
    facts_->setObjectName(QStringLiteral("frame.details.facts"));
    facts_->setProperty("role", "secondary");
    facts_->setFont(textFont(15));
    pose_ = new PoseEditor(QStringLiteral("frame.details"), tr("Origin"),
                           tr("In the base frame. Press Return to apply the values. Only the frame changes; "
                              "the robot does not move."));
    connect(pose_, &PoseEditor::poseEntered, this, [this](const Pose& pose) {
        if (frame_) {
            Q_EMIT placeEntered(pose);
        }
    });
    auto* headline = new QHBoxLayout;
    headline->setSpacing(6);
    headline->addWidget(name_);
    headline->addWidget(facts_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(8);
    layout->addLayout(headline);
    layout->addWidget(pose_);
    setFrame(std::nullopt, 0);
}

void FrameDetails::setFrame(const std::optional<project::Frame>& frame, int waypoints) {
    frame_ = frame;
    waypoints_ = waypoints;
    setEnabled(frame.has_value());
    pose_->setPose(frame ? frame->T_base_frame : Pose());
    showFacts();
}

void FrameDetails::setTcp(const std::optional<Pose>& T_base_tcp) {
    tcp_ = T_base_tcp;
    showFacts();
}

void FrameDetails::editValues() {
    pose_->editFirst();
}

QString FrameDetails::headline() const {
    return name_->text() + QLatin1Char(' ') + facts_->fullText();
}

void FrameDetails::showFacts() {
    if (!frame_) {
        name_->clear();
        facts_->setFullText({});
        return;
    }
    QStringList facts = {waypoints_ == 0 ? tr("not used by any waypoint")
                                         : tr("used by %n waypoints", nullptr, waypoints_)};
    if (tcp_) {
        const project::PoseDifference away = project::poseDifference(frame_->T_base_frame, *tcp_);
        facts << tr("%1 from the TCP").arg(format::difference(away.distance, away.angle));
    }
    name_->setText(frame_->name);
    facts_->setFullText(facts.join(QStringLiteral(" · ")));
    setAccessibleDescription(headline() + QStringLiteral(", ") + format::pose(frame_->T_base_frame));
}

void FrameDetails::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && facts_ != nullptr) {
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

#include "moc_frame_details.cpp"
