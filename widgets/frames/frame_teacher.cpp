// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_teacher.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/station/text/notation.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"

namespace tiller {

using Problem = project::FramePointsCheck::Problem;

FrameTeacher::FrameTeacher(QWidget* parent)
    : QWidget(parent)
    , title_(new QLabel)
    , feedback_(new QLabel)
    , cancel_(new QPushButton(tr("Cancel")))
    , make_(new QPushButton) {
    setObjectName(QStringLiteral("frame.teacher"));
    setAccessibleName(tr("Frame from three points"));
    title_->setObjectName(QStringLiteral("frame.teacher.title"));
    title_->setProperty("role", "strong");
    title_->setWordWrap(true);
    feedback_->setObjectName(QStringLiteral("frame.teacher.feedback"));
    feedback_->setWordWrap(true);
    feedback_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    cancel_->setObjectName(QStringLiteral("frame.teacher.cancel"));
    cancel_->setAccessibleName(tr("Cancel frame teaching"));
    make_->setObjectName(QStringLiteral("frame.teacher.make"));
    make_->setProperty("primary", true);

    static constexpr std::array<const char*, 3> kNames = {"origin", "onX", "towardsY"};
    const std::array<QString, 3> texts = {tr("Origin"), tr("On +X"), tr("Towards +Y")};
    const std::array<QString, 3> spoken = {tr("Record the origin at the TCP"),
                                           tr("Record the point on +X at the TCP"),
                                           tr("Record the point towards +Y at the TCP")};
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        auto* text = new QLabel(texts[at]);
        places_[at] = new ElidedLabel;
        places_[at]->setObjectName(QStringLiteral("frame.teacher.%1.place").arg(QLatin1String(kNames[at])));
        places_[at]->setFont(numberFont(13));
        keys_[at] = new QPushButton(tr("Record"));
        keys_[at]->setObjectName(QStringLiteral("frame.teacher.") + QLatin1String(kNames[at]));
        keys_[at]->setAccessibleName(spoken[at]);
        grid->addWidget(text, i, 0);
        grid->addWidget(places_[at], i, 1);
        grid->addWidget(keys_[at], i, 2);
        connect(keys_[at], &QPushButton::clicked, this, [this, i] { take(i); });
    }
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(cancel_);
    row->addWidget(make_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(8);
    layout->addWidget(title_);
    layout->addLayout(grid);
    layout->addWidget(feedback_, 1);
    layout->addLayout(row);
    connect(cancel_, &QPushButton::clicked, this, &FrameTeacher::cancelled);
    connect(make_, &QPushButton::clicked, this, &FrameTeacher::finish);
    begin({}, tr("Create frame"));
}

void FrameTeacher::begin(const QString& title, const QString& make) {
    points_ = {};
    title_->setText(title);
    make_->setText(make);
    make_->setAccessibleName(make);
    refresh();
    Q_EMIT previewChanged();
}

void FrameTeacher::setTip(const std::optional<Eigen::Vector3d>& tip, const QString& obstacle) {
    if (tip == tip_ && obstacle == obstacle_) {
        return;
    }
    tip_ = tip;
    obstacle_ = obstacle;
    refresh();
    Q_EMIT previewChanged();
}

std::optional<Eigen::Vector3d>& FrameTeacher::point(int index) {
    return index == 0 ? points_.origin : index == 1 ? points_.onX : points_.towardsY;
}

int FrameTeacher::nextMissing() const {
    return !points_.origin ? 0 : !points_.onX ? 1 : !points_.towardsY ? 2 : -1;
}

void FrameTeacher::takeNext() {
    const Problem problem = project::check(points_).problem;
    // If the second point is too close to the origin, record it again first.
    take(problem == Problem::XTooClose ? 1 : nextMissing() < 0 ? 2 : nextMissing());
}

void FrameTeacher::take(int index) {
    Q_EMIT tipWanted();
    if (!tip_) {
        return;
    }
    point(index) = tip_;
    refresh();
    Q_EMIT previewChanged();
}

void FrameTeacher::finish() {
    if (const std::optional<Pose> frame = project::frameThrough(points_)) {
        Q_EMIT made(*frame);
    }
}

std::optional<Pose> FrameTeacher::preview() const {
    project::FramePoints points = points_;
    const int missing = nextMissing();
    if (missing == 2) {
        points.towardsY = tip_;
    }
    return project::frameThrough(points);
}

QString FrameTeacher::feedback() const {
    const QString arm = format::shortLength(project::kMinFrameArm);
    const QString offset = format::shortLength(project::kMinFrameOffset);
    const auto found = project::check(points_);
    switch (found.problem) {
        case Problem::NotFinite:
            return tr("The robot sent an invalid position. Record the point again.");
        case Problem::XTooClose:
            return tr("The point on +X is only %1 from the origin. Record it again at least %2 away. A "
                      "larger distance gives more accurate axes.")
                .arg(format::length(found.alongX, 1), arm);
        case Problem::YTooClose:
            return tr("The third point is only %1 from the origin. Record the point again at least %2 away.")
                .arg(format::length(found.towardsY, 1), arm);
        case Problem::InLine:
            return tr("The three points are collinear: the third point is only %1 from the X axis. Record "
                      "the point again at least %2 towards +Y.")
                .arg(format::length(found.offLine, 1), offset);
        case Problem::None:
            return tr("Ready: the point on +X is %1 from the origin, and the third point is %2 from the X "
                      "axis.")
                .arg(format::length(found.alongX, 1), format::length(found.offLine, 1));
        case Problem::Incomplete:
            break;
    }
    if (!obstacle_.isEmpty()) {
        return obstacle_;
    }
    project::FramePoints with = points_;
    switch (nextMissing()) {
        case 0:
            return tr("Jog the tip to the origin of the frame and record the point (P).");
        case 1:
            with.onX = tip_;
            return tr("Now jog to a point on +X: %1 from the origin (minimum %2).")
                .arg(format::length(project::check(with).alongX, 1), arm);
        default:
            with.towardsY = tip_;
            return tr("Now jog towards +Y: %1 from the X axis (minimum %2).")
                .arg(format::length(project::check(with).offLine, 1), offset);
    }
}

void FrameTeacher::refresh() {
    const auto found = project::check(points_);
    const int next = found.problem == Problem::XTooClose ? 1 : nextMissing();
    const std::array<const std::optional<Eigen::Vector3d>*, 3> taken = {&points_.origin, &points_.onX,
                                                                        &points_.towardsY};
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        places_[i]->setFullText(*taken[i] ? format::position(**taken[i]) : QStringLiteral("–"));
        keys_[i]->setEnabled(tip_.has_value());
        keys_[i]->setText(static_cast<int>(i) == next ? tr("Record  P")
                          : *taken[i]                 ? tr("Redo")
                                                      : tr("Record"));
        keys_[i]->setToolTip(tip_ ? keys_[i]->accessibleName() : obstacle_);
    }
    const bool wrong = found.problem != Problem::None && found.problem != Problem::Incomplete;
    const QString words = feedback();
    feedback_->setText(wrong ? QStringLiteral("▲ ") + words : words);
    const char* const role = wrong ? "warning" : "";
    if (feedback_->property("role") != QLatin1String(role)) {
        feedback_->setProperty("role", QLatin1String(role));
        feedback_->setStyleSheet(feedback_->styleSheet());  // makes Qt apply the changed role
    }
    make_->setEnabled(found.ok());
    make_->setToolTip(found.ok() ? QString() : words);
}

void FrameTeacher::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Reserve a height that does not depend on the text, so that changed feedback does not move the buttons.
    constexpr int kLongest = 850;  // width of the longest feedback text on one line [px]
    const int lines = std::clamp(kLongest / std::max(1, feedback_->width()) + 1, 2, 5);
    feedback_->setMinimumHeight(lines * QFontMetrics(textFont(15)).lineSpacing());
}

void FrameTeacher::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && keys_[2] != nullptr) {
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace tiller

#include "moc_frame_teacher.cpp"
