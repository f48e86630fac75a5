// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_details.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStackedWidget>
#include <QStringList>
#include <QVBoxLayout>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/waypoint_uses.h"
#include "robot/station/route/action_words.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/reach_words.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/pose_editor.h"
#include "widgets/common/theme.h"
#include "widgets/waypoints/waypoint_model.h"

namespace tiller {

namespace {
constexpr int kMargin = 12;
}  // namespace

WaypointDetails::WaypointDetails(ProjectDocument& document, WaypointModel& model, QWidget* parent)
    : QWidget(parent)
    , document_(document)
    , model_(model)
    , headlines_(new QStackedWidget)
    , name_(new QLabel)
    , facts_(new ElidedLabel)
    , advice_(new QLabel)
    , frame_(new ChoiceBox)
    , pose_(new PoseEditor(QStringLiteral("waypoint.details"), tr("TCP"),
                           tr("In the waypoint frame. Press Return to apply the values. Only the waypoint "
                              "changes; the robot does not move.")))
    , place_(new QPushButton) {
    setObjectName(QStringLiteral("waypoint.details"));
    setAccessibleName(tr("Selected waypoint"));
    name_->setObjectName(QStringLiteral("waypoint.details.name"));
    name_->setProperty("role", "strong");
    name_->setTextFormat(Qt::PlainText);  // names may contain < and &
    name_->setFont(textFont(15, QFont::Bold));
    facts_->setObjectName(QStringLiteral("waypoint.details.facts"));
    facts_->setProperty("role", "secondary");
    facts_->setFont(textFont(15));
    advice_->setObjectName(QStringLiteral("waypoint.details.advice"));
    advice_->setProperty("role", "warning");
    advice_->setFont(textFont(12));
    advice_->setWordWrap(true);  // not elided, because the text contains the suggested action

    frame_->setObjectName(QStringLiteral("waypoint.details.frame"));
    frame_->setAccessibleName(tr("Waypoint frame"));
    frame_->view()->setAccessibleName(tr("Frames"));
    frame_->setToolTip(
        tr("Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no "
           "frame: the joint positions have priority."));
    frame_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    frame_->setMinimumContentsLength(5);
    connect(frame_, &QComboBox::activated, this, [this](int choice) {
        model_.setData(model_.index(row_, WaypointModel::Frame), frame_->itemText(choice), Qt::EditRole);
        refresh();
    });

    connect(&document_, &ProjectDocument::toolingChanged, this, &WaypointDetails::refresh);
    connect(pose_, &PoseEditor::poseEntered, this, [this](const Pose& pose) {
        model_.setPose(row_, pose);
        refresh();
    });

    place_->setObjectName(QStringLiteral("waypoint.details.place"));
    place_->setCheckable(true);
    place_->setFocusPolicy(Qt::TabFocus);
    place_->hide();
    // The text of the button describes the effect of a press.
    const auto name = [this](bool keysShown) {
        place_->setText(keysShown ? tr("Values") : tr("Run route"));
        place_->setToolTip(keysShown ? tr("Shows the values instead of the route controls.")
                                     : tr("Shows the route controls instead of the values."));
    };
    // Reserve the width of both texts, so that a press does not resize the button.
    name(true);
    const int valuesWidth = place_->sizeHint().width();
    name(false);
    place_->setMinimumWidth(std::max(valuesWidth, place_->sizeHint().width()));
    connect(place_, &QPushButton::toggled, this, [this, name](bool wanted) {
        name(wanted);
        Q_EMIT placeWanted();
    });

    auto* words = new QWidget;
    auto* wordsLayout = new QHBoxLayout(words);
    wordsLayout->setContentsMargins(0, 0, 0, 0);
    wordsLayout->setSpacing(6);
    wordsLayout->addWidget(name_);
    wordsLayout->addWidget(facts_, 1);
    headlines_->addWidget(words);
    headlines_->addWidget(advice_);
    headlines_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    auto* headline = new QHBoxLayout;
    headline->setSpacing(6);
    headline->addWidget(headlines_, 1);
    headline->addWidget(place_);
    headline->addWidget(frame_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    layout->setSpacing(6);
    layout->addLayout(headline);
    layout->addWidget(pose_);
    // Hidden parts keep their space, so that changed texts do not move the buttons below.
    for (QWidget* part :
         {static_cast<QWidget*>(headlines_), static_cast<QWidget*>(pose_), static_cast<QWidget*>(frame_)}) {
        QSizePolicy policy = part->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        part->setSizePolicy(policy);
    }
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

void WaypointDetails::setPathLimitText(const QString& text) {
    pathLimitText_ = text;
    refresh();
}

void WaypointDetails::setUsedIn(std::optional<int> steps) {
    usedIn_ = steps;
    refresh();
}

void WaypointDetails::offerPlace(bool offered) {
    place_->setVisible(offered);
}

bool WaypointDetails::isPlaceWanted() const {
    return place_->isChecked();
}

void WaypointDetails::setValuesVisible(bool shown) {
    if (shown == valuesVisible_) {
        return;
    }
    valuesVisible_ = shown;
    QSizePolicy policy = pose_->sizePolicy();
    policy.setRetainSizeWhenHidden(shown);
    pose_->setSizePolicy(policy);
    refresh();
    // Update the layout immediately. Otherwise, the panel would use the size of the previous content.
    layout()->activate();
}

int WaypointDetails::valuesHeight() const {
    return pose_->minimumSizeHint().height() + layout()->spacing();
}

void WaypointDetails::setValuesSlot(int height) {
    const int inner = height - layout()->spacing();
    pose_->setMinimumHeight(height > 0 ? inner : 0);
    pose_->setMaximumHeight(height > 0 ? inner : QWIDGETSIZE_MAX);
}

/// Names the TCP to which the values belong, which may not be the TCP of the robot.
QString WaypointDetails::tcpText(const Pose& offset) const {
    constexpr double kSameDistance = 1e-4;  // [m]
    constexpr double kSameAngle = 1e-3;     // [rad]
    const auto isOffset = [&offset](const Pose& tcp) {
        const project::PoseDifference by = project::poseDifference(tcp, offset);
        return by.distance <= kSameDistance && by.angle <= kSameAngle;
    };
    for (const project::Tool& tool : document_.tooling().tools) {
        if (isOffset(tool.tcpOffset)) {
            return tr("TCP “%1”").arg(tool.name);
        }
    }
    return isOffset(Pose()) ? tr("TCP at the flange")
                            : tr("TCP %1 from the flange").arg(format::length(offset.position.norm(), 1));
}

QString WaypointDetails::headline() const {
    return name_->text() + QLatin1Char(' ') + facts_->fullText();
}

void WaypointDetails::refresh() {
    const bool shown = row_ >= 0 && row_ < model_.rowCount();
    headlines_->setVisible(shown);
    pose_->setVisible(shown && valuesVisible_);
    frame_->setVisible(shown);
    if (!shown) {
        return;
    }
    const project::Waypoint& point = document_.waypoints().at(row_);
    const bool joints = point.priority == project::TargetKind::Joints;
    // With a joint target, the position results from the joint positions and the current arm model. The
    // stored pose is not used.
    const std::optional<Pose> place =
        joints ? std::optional(kinematics::forwardTcp(document_.robot().dh, point.joints, point.tcpOffset))
               : project::poseInBase(point, document_.frames());
    QStringList facts{tcpText(point.tcpOffset)};
    if (usedIn_) {
        facts << tr("used in %n steps", nullptr, *usedIn_);
    }
    if (live_.hasData() && place) {
        // Uses the TCP of the waypoint, as a move to the waypoint does.
        const Pose live = live_.tcpPose * live_.tcpOffset.inverse() * point.tcpOffset;
        const project::PoseDifference away = project::poseDifference(*place, live);
        facts << tr("%1 from the current pose").arg(format::difference(away.distance, away.angle));
    } else {
        facts << (joints ? tr("joints have priority") : tr("pose has priority"));
    }
    if (!point.group.isEmpty()) {
        facts << point.group;
    }
    for (const project::WaypointUse& use : project::usesOf(document_.project(), point)) {
        using Kind = project::WaypointUse::Kind;
        facts << (use.kind == Kind::PatternPlace    ? tr("cell of “%1”")
                  : use.kind == Kind::PatternCorner ? tr("corner of “%1”")
                  : use.kind == Kind::Home          ? tr("home position “%1”")
                                                    : tr("position “%1”"))
                     .arg(use.name);
    }
    facts << ActionWords::of(point.actions);
    if (!point.note.isEmpty()) {
        facts << QString(point.note).replace(QLatin1Char('\n'), QLatin1Char(' '));
    }
    name_->setText(point.name);
    showFrame();
    facts_->setFullText(facts.join(QStringLiteral(" · ")));
    const Pose shownPose = joints && place ? *place : point.pose;
    pose_->setPose(shownPose);
    poseLine_ = format::pose(shownPose);
    const project::Reach& reach = document_.reach(row_);
    advice_->setText(!reach.ok()                ? QStringLiteral("✕ ") + reachAdvice(reach)
                     : pathLimitText_.isEmpty() ? QString()
                                                : QStringLiteral("⚠ ") + pathLimitText_);
    headlines_->setCurrentIndex(reach.ok() && pathLimitText_.isEmpty() ? 0 : 1);
    setAccessibleDescription(headline() + QStringLiteral(", ") + poseLine());
}

void WaypointDetails::showFrame() {
    const QStringList choices = model_.frameChoices();
    QStringList offered;
    for (int i = 0; i < frame_->count(); ++i) {
        offered << frame_->itemText(i);
    }
    if (choices != offered) {
        frame_->clear();
        frame_->addItems(choices);
    }
    const QString now = model_.index(row_, WaypointModel::Frame).data(Qt::EditRole).toString();
    frame_->setCurrentIndex(static_cast<int>(choices.indexOf(now)));
}

void WaypointDetails::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && advice_ != nullptr) {
        refresh();
    }
    QWidget::changeEvent(event);
}

void WaypointDetails::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(Theme::current().border);
    painter.drawLine(0, 0, width(), 0);
}

}  // namespace tiller

#include "moc_waypoint_details.cpp"
