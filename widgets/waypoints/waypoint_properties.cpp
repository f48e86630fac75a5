// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_properties.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/core/angles.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {

QStringList WaypointProperties::colourNames() {
    return {tr("None"), tr("Blue"), tr("Orange"), tr("Green"), tr("Pink"), tr("Yellow"), tr("Sky blue")};
}

QCheckBox* WaypointProperties::addRow(QGridLayout& grid, const QString& name, const QString& text,
                                      QWidget* editor) {
    const QString path = QStringLiteral("waypoint.properties.") + name;
    auto* tick = new QCheckBox(text);
    tick->setObjectName(path + QStringLiteral(".tick"));
    tick->setToolTip(tr("Only the selected properties are changed."));
    editor->setObjectName(path);
    editor->setAccessibleName(text);
    const int row = grid.rowCount();
    grid.addWidget(tick, row, 0, Qt::AlignTop);
    grid.addWidget(editor, row, 1);
    return tick;
}

DecimalSpinBox* WaypointProperties::addValue(QGridLayout& grid, const QString& name, const QString& text,
                                             const QString& unit, double least, double most,
                                             QCheckBox*& tick) {
    auto* box = new DecimalSpinBox;
    box->setDecimals(2);
    box->setRange(least, most);
    box->setSuffix(QLatin1Char(' ') + unit);
    tick = addRow(grid, name, text, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, [tick] { tick->setChecked(true); });
    return box;
}

WaypointProperties::WaypointProperties(const std::vector<project::Waypoint>& waypoints,
                                       const QStringList& groups, double mostJointSpeed, QWidget* parent)
    : QDialog(parent)
    , waypoints_(waypoints)
    , group_(new QComboBox)
    , colour_(new ChoiceBox)
    , note_(new QPlainTextEdit)
    , move_(new ChoiceBox) {
    setObjectName(QStringLiteral("waypoint.properties"));
    const auto count = static_cast<int>(waypoints.size());
    setWindowTitle(count == 1 ? tr("Properties of “%1”").arg(waypoints.front().name)
                              : tr("Properties of %n waypoints", nullptr, count));
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    group_->setEditable(true);
    group_->addItems(groups);
    groupTick_ = addRow(*grid, QStringLiteral("group"), tr("Group"), group_);
    colour_->addItems(colourNames());
    colourTick_ = addRow(*grid, QStringLiteral("colour"), tr("Colour"), colour_);
    note_->setTabChangesFocus(true);
    note_->setMinimumHeight(70);
    noteTick_ = addRow(*grid, QStringLiteral("note"), tr("Note"), note_);
    move_->addItems({QStringLiteral("MoveJ"), QStringLiteral("MoveL")});
    moveTick_ = addRow(*grid, QStringLiteral("move"), tr("Move"), move_);
    const double perUnit = format::metresPerUnit();
    jointSpeed_ = addValue(*grid, QStringLiteral("jointSpeed"), tr("MoveJ speed"), QStringLiteral("°/s"), 1,
                           toDegrees(mostJointSpeed), jointSpeedTick_);
    toolSpeed_ = addValue(*grid, QStringLiteral("toolSpeed"), tr("MoveL speed"), format::speedUnit(),
                          0.001 / perUnit, 1.0 / perUnit, toolSpeedTick_);
    blend_ = addValue(*grid, QStringLiteral("blend"), tr("Blend"), format::lengthUnit(), 0, 1.0 / perUnit,
                      blendTick_);

    // The fields show the values of the first waypoint. The check boxes mark values that differ between the
    // waypoints.
    const project::Waypoint& first = waypoints.front();
    group_->setCurrentText(first.group);
    colour_->setCurrentIndex(static_cast<int>(first.colour));
    note_->setPlainText(first.note);
    move_->setCurrentIndex(static_cast<int>(first.move));
    jointSpeed_->setValue(toDegrees(first.jointSpeed));
    toolSpeed_->setValue(first.toolSpeed / perUnit);
    blend_->setValue(first.blend / perUnit);
    for (QCheckBox* tick : findChildren<QCheckBox*>()) {
        tick->setChecked(false);
    }
    connect(group_, &QComboBox::currentTextChanged, this, [this] { groupTick_->setChecked(true); });
    connect(colour_, &QComboBox::currentIndexChanged, this, [this] { colourTick_->setChecked(true); });
    connect(note_, &QPlainTextEdit::textChanged, this, [this] { noteTick_->setChecked(true); });
    connect(move_, &QComboBox::currentIndexChanged, this, [this] { moveTick_->setChecked(true); });

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Apply"));
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("waypoint.properties.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &WaypointProperties::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(buttons);
    for (auto* tick : {&groupTick_, &colourTick_, &noteTick_, &moveTick_, &jointSpeedTick_, &toolSpeedTick_,
                       &blendTick_}) {
        (*tick)->setChecked(false);
    }
}

void WaypointProperties::accept() {
    for (DecimalSpinBox* box : {jointSpeed_, toolSpeed_, blend_}) {
        if (box->isRefused()) {
            box->setFocus();
            box->explainRefusal();
            return;
        }
    }
    QDialog::accept();
}

std::vector<project::Waypoint> WaypointProperties::changed() const {
    std::vector<project::Waypoint> result = waypoints_;
    const double perUnit = format::metresPerUnit();
    for (project::Waypoint& point : result) {
        if (groupTick_->isChecked()) {
            point.group = group_->currentText().trimmed();
        }
        if (colourTick_->isChecked()) {
            point.colour = static_cast<project::WaypointColour>(colour_->currentIndex());
        }
        if (noteTick_->isChecked()) {
            point.note = note_->toPlainText();
        }
        if (moveTick_->isChecked()) {
            point.move = static_cast<project::MoveKind>(move_->currentIndex());
        }
        if (jointSpeedTick_->isChecked()) {
            point.jointSpeed = toRadians(jointSpeed_->value());
        }
        if (toolSpeedTick_->isChecked()) {
            point.toolSpeed = toolSpeed_->value() * perUnit;
        }
        if (blendTick_->isChecked()) {
            point.blend = blend_->value() * perUnit;
        }
    }
    return result;
}

}  // namespace tiller

#include "moc_waypoint_properties.cpp"
