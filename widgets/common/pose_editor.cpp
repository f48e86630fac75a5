// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/pose_editor.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <numbers>

#include "robot/core/angles.h"
#include "robot/station/text/notation.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {
namespace {

constexpr double kFarthest = 10.0;  ///< [m] maximum distance of a position from the base
constexpr std::array<const char*, 6> kNames = {"x", "y", "z", "rx", "ry", "rz"};
constexpr std::array<const char*, 6> kLetters = {"X", "Y", "Z", "RX", "RY", "RZ"};

bool asVector() {
    return Notation::current().rotation == RotationNotation::RotationVector;
}

/// Position in the display unit; rotation in degrees (roll, pitch, yaw) or rad (rotation vector).
std::array<double, 6> displayedValues(const Pose& pose) {
    const Eigen::Vector3d position = pose.position / format::metresPerUnit();
    const Eigen::Vector3d turns =
        asVector() ? pose.rotation : Eigen::Vector3d(rpyFromRotationVector(pose.rotation) * toDegrees(1));
    return {position.x(), position.y(), position.z(), turns.x(), turns.y(), turns.z()};
}

}  // namespace

PoseEditor::PoseEditor(const QString& name, const QString& spoken, const QString& advice, QWidget* parent)
    : QWidget(parent) {
    setObjectName(name + QStringLiteral(".pose"));
    const std::array<QString, 6> figures = {tr("%1 X").arg(spoken),      tr("%1 Y").arg(spoken),
                                            tr("%1 Z").arg(spoken),      tr("Rotation about X (RX)"),
                                            tr("Rotation about Y (RY)"), tr("Rotation about Z (RZ)")};
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);
    for (int i = 0; i < 6; ++i) {
        const auto at = static_cast<std::size_t>(i);
        auto* letter = new QLabel(QLatin1String(kLetters[at]));
        letter->setProperty("role", "secondary");
        boxes_[at] = new DecimalSpinBox;
        boxes_[at]->setObjectName(name + QLatin1Char('.') + QLatin1String(kNames[at]));
        boxes_[at]->setAccessibleName(figures[at]);
        boxes_[at]->setToolTip(QStringLiteral("%1. %2").arg(figures[at], advice));
        boxes_[at]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        boxes_[at]->setProperty("dense", true);
        boxes_[at]->setMinimumWidth(80);
        letter->setBuddy(boxes_[at]);
        grid->addWidget(letter, i / 3, i % 3 * 2);
        grid->addWidget(boxes_[at], i / 3, i % 3 * 2 + 1);
        grid->setColumnStretch(i % 3 * 2 + 1, 1);
        connect(boxes_[at], &DecimalSpinBox::editingFinished, this, [this, i] { take(i); });
    }
    updateValueTexts();
}

void PoseEditor::setPose(const Pose& pose) {
    if (pose == pose_) {
        return;  // do not overwrite a value that is being edited
    }
    pose_ = pose;
    updateValueTexts();
}

void PoseEditor::editFirst() {
    boxes_[0]->setFocus(Qt::ShortcutFocusReason);
    boxes_[0]->selectAll();
}

void PoseEditor::updateValueTexts() {
    shown_ = displayedValues(pose_);
    const double farthest = kFarthest / format::metresPerUnit();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const bool length = i < 3;
        DecimalSpinBox& box = *boxes_[i];
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
        // Store the value rounded by the box, so that only edited values count as changed.
        shown_[i] = box.value();
    }
}

void PoseEditor::take(int figure) {
    const auto at = static_cast<std::size_t>(figure);
    if (boxes_[at]->value() == shown_[at]) {
        return;
    }
    shown_[at] = boxes_[at]->value();
    if (figure < 3) {
        pose_.position[figure] = shown_[at] * format::metresPerUnit();
    } else if (asVector()) {
        pose_.rotation[figure - 3] = shown_[at];
        pose_.rotation = rotationVector(rotationMatrix(pose_.rotation));
    } else {
        Eigen::Vector3d rpy = rpyFromRotationVector(pose_.rotation);
        rpy[figure - 3] = toRadians(shown_[at]);
        pose_.rotation = rotationVectorFromRpy(rpy);
    }
    Q_EMIT poseEntered(pose_);
}

void PoseEditor::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && boxes_[5] != nullptr) {
        updateValueTexts();
    }
    QWidget::changeEvent(event);
}

}  // namespace tiller

#include "moc_pose_editor.cpp"
