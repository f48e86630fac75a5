// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_details.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStringList>
#include <QVBoxLayout>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/format.h"
#include "widgets/common/notation.h"
#include "widgets/common/theme.h"
#include "widgets/waypoints/waypoint_model.h"

namespace tiller {

QString poseText(const Pose& pose) {
    std::array<QString, 3> turns = format::rotation(pose.rotation);
    if (turns[2].endsWith(QChar(0xB0))) {
        turns[0].chop(1);  // the unit once, at the end
        turns[1].chop(1);
    }
    return QStringLiteral("X %1 Y %2 Z %3 %4 RX %5 RY %6 RZ %7")
        .arg(format::lengthNumber(pose.position.x(), 2, false),
             format::lengthNumber(pose.position.y(), 2, false),
             format::lengthNumber(pose.position.z(), 2, false), format::lengthUnit(), turns[0], turns[1],
             turns[2]);
}

QString differenceText(const program::PoseDifference& difference) {
    constexpr double kDegPerRad = 180.0 / std::numbers::pi;
    return QStringLiteral("%1, %2°").arg(format::length(difference.distance, 1),
                                         format::number(difference.angle * kDegPerRad, 1));
}

WaypointDetails::WaypointDetails(const WaypointModel& model, QWidget* parent)
    : QWidget(parent)
    , model_(model)
    , name_(new QLabel)
    , facts_(new ElidedLabel)
    , pose_(new ElidedLabel)
    , advice_(new ElidedLabel) {
    setObjectName(QStringLiteral("waypoint.details"));
    setAccessibleName(tr("Selected waypoint"));
    name_->setObjectName(QStringLiteral("waypoint.details.name"));
    name_->setProperty("role", "strong");
    name_->setFont(textFont(15, QFont::Bold));
    facts_->setObjectName(QStringLiteral("waypoint.details.facts"));
    facts_->setProperty("role", "secondary");
    facts_->setFont(textFont(15));
    pose_->setObjectName(QStringLiteral("waypoint.details.pose"));
    pose_->setFont(figureFont(13));
    advice_->setObjectName(QStringLiteral("waypoint.details.advice"));
    advice_->setProperty("role", "warning");

    auto* headline = new QHBoxLayout;
    headline->setSpacing(6);
    headline->addWidget(name_);
    headline->addWidget(facts_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(6);
    layout->addLayout(headline);
    layout->addWidget(pose_);
    layout->addWidget(advice_);
    refresh();
}

void WaypointDetails::setWaypoint(int row) {
    row_ = row;
    refresh();
}

void WaypointDetails::setLive(const SessionState& state) {
    live_ = state;
    refresh();
}

void WaypointDetails::setUsedIn(std::optional<int> steps) {
    usedIn_ = steps;
    refresh();
}

QString WaypointDetails::headline() const {
    return name_->text() + QLatin1Char(' ') + facts_->fullText();
}

QString WaypointDetails::poseLine() const {
    return pose_->fullText();
}

void WaypointDetails::refresh() {
    const bool shown = row_ >= 0 && row_ < model_.rowCount();
    name_->setVisible(shown);
    facts_->setVisible(shown);
    pose_->setVisible(shown);
    advice_->setVisible(shown && !model_.reach(row_).ok());
    if (!shown) {
        return;
    }
    const program::Waypoint& point = model_.waypoints().at(row_);
    const bool joints = point.ruling == program::Ruling::Joints;
    // Where the joints rule, the place is where they bring this arm, whatever pose was remembered.
    const std::optional<Pose> place =
        joints ? std::optional(kinematics::forwardTcp(model_.robot().dh, point.joints, point.tcpOffset))
               : program::poseInBase(point, model_.frames());
    QStringList facts;
    if (usedIn_) {
        facts << (*usedIn_ == 1 ? tr("used in 1 step") : tr("used in %1 steps").arg(*usedIn_));
    }
    if (live_.hasData() && place) {
        facts << tr("%1 from the live pose")
                     .arg(differenceText(program::poseDifference(*place, live_.tcpPose)));
    } else {
        facts << (joints ? tr("joints rule") : tr("pose rules"));
    }
    name_->setText(point.name);
    facts_->setFullText(facts.join(QStringLiteral(" · ")));
    pose_->setFullText(poseText(joints && place ? *place : point.pose));
    advice_->setFullText(model_.reach(row_).ok()
                             ? QString()
                             : QStringLiteral("✕ ") + WaypointModel::reachAdvice(model_.reach(row_)));
    setAccessibleDescription(headline() + QStringLiteral(", ") + poseLine());
}

void WaypointDetails::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(Theme::current().border);
    painter.drawLine(0, 0, width(), 0);
}

}  // namespace tiller
