// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/tcp_teacher.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/theme.h"

namespace tiller {
namespace {

QLabel* wrapped(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    return label;
}

QPushButton* keyNamed(const char* name, const QString& text) {
    auto* key = new QPushButton(text);
    key->setObjectName(QLatin1String(name));
    key->setAccessibleName(text);
    return key;
}

}  // namespace

TcpTeacher::TcpTeacher(QWidget* parent)
    : QWidget(parent)
    , title_(wrapped("tcp.teacher.title"))
    , take_(keyNamed("tcp.teacher.take", tr("Record pose")))
    , again_(keyNamed("tcp.teacher.again", tr("Redo least accurate pose")))
    , poses_(wrapped("tcp.teacher.poses"))
    , feedback_(wrapped("tcp.teacher.feedback"))
    , turning_(new ChoiceBox)
    , takeTurn_(keyNamed("tcp.teacher.takeTurn", tr("Record")))
    , turnFeedback_(wrapped("tcp.teacher.turnFeedback"))
    , make_(keyNamed("tcp.teacher.make", tr("Keep TCP"))) {
    setObjectName(QStringLiteral("tcp.teacher"));
    setAccessibleName(tr("Teach the TCP"));
    title_->setProperty("role", "strong");
    poses_->setFont(numberFont(13));
    take_->setProperty("primary", true);
    takeTurn_->setAccessibleName(tr("Record pose for the tool orientation"));
    turning_->setObjectName(QStringLiteral("tcp.teacher.turning"));
    turning_->setAccessibleName(tr("Tool orientation"));
    turning_->addItems({tr("Keep current orientation"), tr("Orientation from one pose: tool straight down"),
                        tr("Orientation from three poses: along +Z, towards +X")});
    auto* cancel = keyNamed("tcp.teacher.cancel", tr("Cancel"));

    auto* tipRow = new QHBoxLayout;
    tipRow->addWidget(take_, 2);
    tipRow->addWidget(again_, 2);
    auto* turnRow = new QHBoxLayout;
    turnRow->addWidget(turning_, 3);
    turnRow->addWidget(takeTurn_, 1);
    auto* endRow = new QHBoxLayout;
    endRow->addWidget(cancel);
    endRow->addStretch();
    endRow->addWidget(make_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(title_);
    layout->addLayout(tipRow);
    layout->addWidget(feedback_);
    layout->addWidget(poses_, 1);
    layout->addLayout(turnRow);
    layout->addWidget(turnFeedback_);
    layout->addLayout(endRow);

    connect(take_, &QPushButton::clicked, this, &TcpTeacher::takeTip);
    connect(again_, &QPushButton::clicked, this, &TcpTeacher::takeTipAgain);
    connect(takeTurn_, &QPushButton::clicked, this, &TcpTeacher::takeTurn);
    connect(turning_, &QComboBox::activated, this, [this] {
        turns_.clear();
        refresh();
    });
    connect(cancel, &QPushButton::clicked, this, &TcpTeacher::cancelled);
    connect(make_, &QPushButton::clicked, this, &TcpTeacher::finish);
    begin({}, Eigen::Vector3d::Zero());
}

void TcpTeacher::begin(const QString& title, const Eigen::Vector3d& rotation) {
    title_->setText(title);
    before_ = rotation;
    tips_.clear();
    turns_.clear();
    fit_ = {};
    turning_->setCurrentIndex(AsItIs);
    refresh();
}

void TcpTeacher::setLive(const SessionState& state) {
    const bool could = flange().has_value();
    state_ = state;
    if (could != flange().has_value()) {
        refresh();
    }
}

std::optional<Eigen::Isometry3d> TcpTeacher::flange() const {
    if (state_.link != LinkState::Live) {
        return std::nullopt;
    }
    return kinematics::forward(state_.dh, state_.q);
}

void TcpTeacher::takeNext() {
    fit_.ok() && turning_->currentIndex() != AsItIs ? takeTurn() : takeTip();
}

void TcpTeacher::takeTip() {
    if (const auto T = flange()) {
        tips_.push_back(*T);
        fit_ = kinematics::fitTip(tips_);
        refresh();
    }
}

void TcpTeacher::takeTipAgain() {
    if (const auto T = flange(); T && !tips_.empty()) {
        tips_[fit_.ok() ? static_cast<std::size_t>(fit_.worst) : tips_.size() - 1] = *T;
        fit_ = kinematics::fitTip(tips_);
        refresh();
    }
}

void TcpTeacher::takeTurn() {
    const auto T = flange();
    if (!T) {
        return;
    }
    const std::size_t needed = turning_->currentIndex() == ThreePoses ? 3 : 1;
    if (turns_.size() == needed) {
        turns_.clear();  // start again with the poses for the orientation
    }
    turns_.push_back(*T);
    refresh();
}

std::optional<Eigen::Vector3d> TcpTeacher::rotation() const {
    switch (turning_->currentIndex()) {
        case StraightDown:
            if (turns_.size() == 1) {
                // Z points down, and X is parallel to X of the base frame.
                const Eigen::Matrix3d R_base_tool = rotationMatrix({M_PI, 0, 0});
                return rotationVector(kinematics::toolRotation(turns_[0].linear(), R_base_tool));
            }
            return std::nullopt;
        case ThreePoses:
            if (turns_.size() == 3) {
                const auto fit = kinematics::fitToolRotation({turns_[0], turns_[1], turns_[2]});
                return fit.ok() ? std::optional(rotationVector(fit.R_flange_tool)) : std::nullopt;
            }
            return std::nullopt;
        default:
            return before_;
    }
}

std::optional<Pose> TcpTeacher::tcp() const {
    const std::optional<Eigen::Vector3d> turned = rotation();
    if (!fit_.ok() || !turned) {
        return std::nullopt;
    }
    return Pose(fit_.tip, *turned);
}

void TcpTeacher::finish() {
    if (const std::optional<Pose> result = tcp()) {
        Q_EMIT made(*result);
    }
}

QString TcpTeacher::tipFeedback() const {
    using Problem = kinematics::TipFit::Problem;
    const auto taken = static_cast<int>(tips_.size());
    switch (fit_.problem) {
        case Problem::None:
            return tr("Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.")
                .arg(format::position(fit_.tip), format::length(fit_.rms, 2))
                .arg(fit_.worst + 1)
                .arg(format::length(fit_.residuals[static_cast<std::size_t>(fit_.worst)], 2));
        case Problem::TooAlike:
            return tr(
                "The tool orientations are too similar. Record one more pose with the tool tilted by at "
                "least 30° in a different direction.");
        case Problem::NotFinite:
            return tr("The robot sent an invalid position. Record the poses again.");
        case Problem::TooFew:
            break;
    }
    return taken == 0
               ? tr("Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, "
                    "each with the tip on the same point and the tool tilted in a different direction.")
               : tr("Tilt the tool in a different direction, move the tip to the same point again, and "
                    "record the pose. Poses still needed: %n.",
                    nullptr, kinematics::kMinTipPoses - taken);
}

QString TcpTeacher::turnFeedback() const {
    using Problem = kinematics::ToolRotationFit::Problem;
    if (turning_->currentIndex() == AsItIs) {
        return tr("The tool keeps the current orientation.");
    }
    if (turning_->currentIndex() == StraightDown) {
        return turns_.empty() ? tr("Rotate the tool until it points straight down and its X axis is parallel "
                                   "to the base X axis, then record the pose.")
                              : tr("Orientation recorded. Record another pose to replace the orientation.");
    }
    switch (turns_.size()) {
        case 0:
            return tr(
                "Record the pose at the current position. After that, do not rotate the tool: jog along X, Y "
                "and Z only.");
        case 1:
            return tr("Move the tool along its +Z direction, away from the flange, by at least %1, and "
                      "record the pose.")
                .arg(format::shortLength(kinematics::kMinAxisTravel));
        case 2:
            return tr("Now move the tool along its +X direction by at least %1, and record the pose.")
                .arg(format::shortLength(kinematics::kMinAxisTravel));
        default:
            break;
    }
    const auto fit = kinematics::fitToolRotation({turns_[0], turns_[1], turns_[2]});
    switch (fit.problem) {
        case Problem::None:
            return tr("Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose "
                      "%4.")
                .arg(format::length(fit.alongZ, 1), format::length(fit.offLine, 1),
                     format::degrees(fit.residual, 2))
                .arg(fit.worst + 1);
        case Problem::Turned:
            return tr("The flange rotated by up to %1 (pose %2). Record the three poses again without "
                      "rotating the tool.")
                .arg(format::degrees(fit.residual, 2))
                .arg(fit.worst + 1);
        case Problem::ZTooClose:
            return tr("The distance along +Z is only %1. Record the three poses again, at least %2 apart.")
                .arg(format::length(fit.alongZ, 1), format::shortLength(kinematics::kMinAxisTravel));
        case Problem::XTooClose:
            return tr("The distance along +X is only %1. Record the three poses again, at least %2 apart.")
                .arg(format::length(fit.towardsX, 1), format::shortLength(kinematics::kMinAxisTravel));
        case Problem::InLine:
            return tr("The three poses are collinear: the third pose is only %1 from the line. Record the "
                      "three poses again.")
                .arg(format::length(fit.offLine, 1));
        case Problem::NotFinite:
            break;
    }
    return tr("The robot sent an invalid position. Record the three poses again.");
}

void TcpTeacher::refresh() {
    const bool live = flange().has_value();
    take_->setEnabled(live);
    again_->setEnabled(live && !tips_.empty());
    again_->setText(fit_.ok() ? tr("Redo least accurate pose") : tr("Redo last pose"));
    take_->setText(tr("Record pose %1").arg(tips_.size() + 1));
    takeTurn_->setEnabled(live && turning_->currentIndex() != AsItIs);
    QStringList lines;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
        QString line = tr("Pose %1").arg(i + 1);
        if (fit_.ok()) {
            line += QStringLiteral("  ") + format::length(fit_.residuals[i], 2);
            if (static_cast<int>(i) == fit_.worst) {
                line += tr("  ◀ least accurate");
            }
        }
        lines << line;
    }
    poses_->setText(lines.join(QLatin1Char('\n')));
    feedback_->setText(!live && tips_.empty() ? tr("Poses can be recorded only while the robot sends data. "
                                                   "Connect to a robot, or wait for new data.")
                                              : tipFeedback());
    turnFeedback_->setText(turnFeedback());
    make_->setEnabled(tcp().has_value());
}

}  // namespace tiller

#include "moc_tcp_teacher.cpp"
