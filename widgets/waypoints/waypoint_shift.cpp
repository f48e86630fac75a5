// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_shift.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "robot/core/angles.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"

namespace tiller {
namespace {

enum ShiftKind { kOffset, kTurn, kMirror };
constexpr int kToolAxes = 1;  ///< index in the list of axes, after the base frame
constexpr int kFirstFrameAxes = 2;

}  // namespace

WaypointShift::WaypointShift(const ProjectDocument& document, std::vector<project::Waypoint> waypoints,
                             QWidget* parent)
    : QDialog(parent)
    , document_(document)
    , waypoints_(std::move(waypoints))
    , kind_(new ChoiceBox)
    , axes_(new ChoiceBox)
    , axis_(new ChoiceBox)
    , angle_(new DecimalSpinBox)
    , feedback_(new QLabel) {
    setObjectName(QStringLiteral("waypoint.shift"));
    setWindowTitle(tr("Offset, rotate or mirror %n waypoints", nullptr, static_cast<int>(waypoints_.size())));
    kind_->setObjectName(QStringLiteral("waypoint.shift.kind"));
    kind_->setAccessibleName(tr("Transformation type"));
    kind_->addItems({tr("Offset"), tr("Rotation"), tr("Mirror")});
    axes_->setObjectName(QStringLiteral("waypoint.shift.axes"));
    axes_->setAccessibleName(tr("Axes"));
    axes_->addItems({tr("Base"), tr("Tool of each waypoint")});
    for (const project::Frame& frame : document.frames()) {
        axes_->addItem(frame.name);
    }
    axis_->setObjectName(QStringLiteral("waypoint.shift.axis"));
    axis_->setAccessibleName(tr("Axis"));
    axis_->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
    axis_->setCurrentIndex(2);
    auto* grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("Type")), 0, 0);
    grid->addWidget(kind_, 0, 1, 1, 3);
    grid->addWidget(new QLabel(tr("Axes")), 1, 0);
    grid->addWidget(axes_, 1, 1, 1, 3);
    grid->addWidget(new QLabel(tr("Offset X, Y, Z")), 2, 0);
    static constexpr const char* kLetters[] = {"x", "y", "z"};
    const double most = 10 / format::metresPerUnit();
    for (int i = 0; i < 3; ++i) {
        auto* box = new DecimalSpinBox;
        box->setObjectName(QStringLiteral("waypoint.shift.") + QLatin1String(kLetters[i]));
        box->setAccessibleName(tr("Offset %1").arg(QLatin1String(kLetters[i]).toString().toUpper()));
        box->setRange(-most, most);
        box->setSuffix(QLatin1Char(' ') + format::lengthUnit());
        box->setKeyboardTracking(true);  // update the text below while the user types
        grid->addWidget(box, 2, 1 + i);
        offset_[static_cast<std::size_t>(i)] = box;
        connect(box, &QDoubleSpinBox::valueChanged, this, &WaypointShift::refresh);
    }
    grid->addWidget(new QLabel(tr("Rotation axis or mirror normal")), 3, 0);
    grid->addWidget(axis_, 3, 1);
    angle_->setObjectName(QStringLiteral("waypoint.shift.angle"));
    angle_->setAccessibleName(tr("Angle"));
    angle_->setRange(-360, 360);
    angle_->setSuffix(QStringLiteral("°"));
    angle_->setKeyboardTracking(true);
    grid->addWidget(angle_, 3, 2, 1, 2);
    feedback_->setObjectName(QStringLiteral("waypoint.shift.feedback"));
    feedback_->setWordWrap(true);
    feedback_->setMinimumWidth(420);
    feedback_->setMinimumHeight(3 * fontMetrics().height());
    feedback_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Move"));
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("waypoint.shift.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &WaypointShift::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(feedback_);
    layout->addWidget(buttons);
    for (ChoiceBox* box : {kind_, axes_, axis_}) {
        connect(box, &QComboBox::currentIndexChanged, this, &WaypointShift::refresh);
    }
    connect(angle_, &QDoubleSpinBox::valueChanged, this, &WaypointShift::refresh);
    refresh();
}

project::RelativeMove WaypointShift::move() const {
    project::RelativeMove move;
    using Kind = project::RelativeMove::Kind;
    move.kind = kind_->currentIndex() == kOffset ? Kind::Offset
                : kind_->currentIndex() == kTurn ? Kind::Turn
                                                 : Kind::Mirror;
    if (axes_->currentIndex() == kToolAxes && move.kind != Kind::Mirror) {
        move.axes = project::RelativeMove::Axes::Tool;
    } else if (axes_->currentIndex() >= kFirstFrameAxes) {
        move.frame =
            document_.frames().at(static_cast<std::size_t>(axes_->currentIndex() - kFirstFrameAxes)).id;
    }
    for (int i = 0; i < 3; ++i) {
        move.offset[i] = offset_[static_cast<std::size_t>(i)]->value() * format::metresPerUnit();
    }
    move.axis = axis_->currentIndex();
    move.angle = toRadians(angle_->value());
    return move;
}

Result<std::vector<project::Waypoint>> WaypointShift::moved() const {
    return project::movedBy(waypoints_, move(), document_.robot(), document_.frames());
}

void WaypointShift::refresh() {
    const int kind = kind_->currentIndex();
    for (DecimalSpinBox* box : offset_) {
        box->setEnabled(kind == kOffset);
    }
    axis_->setEnabled(kind != kOffset);
    angle_->setEnabled(kind == kTurn);
    const Result<std::vector<project::Waypoint>> result = moved();
    findChild<QPushButton*>(QStringLiteral("waypoint.shift.accept"))->setEnabled(result.ok());
    if (!result) {
        feedback_->setText(result.error().code == ErrorCode::NoSolution
                               ? tr("The arm cannot reach these waypoints after the move: %1. Choose a "
                                    "different offset, rotation or mirror plane. No waypoint will be moved.")
                                     .arg(result.error().context)
                               : tr("The frame of a selected waypoint is not in the project. Choose a "
                                    "different frame for the waypoint first."));
        return;
    }
    int far = 0;
    for (const project::Waypoint& point : *result) {
        far += project::reach(document_.robot(), point, document_.frames()).ok() ? 0 : 1;
    }
    feedback_->setText(
        far > 0 ? tr("%n of the moved waypoints will be out of reach. They will be kept and marked.", nullptr,
                     far)
        : kind == kMirror ? tr("Mirrors across the plane through the origin that is perpendicular to the "
                               "axis. The tool approaches from the mirrored side.")
                          : tr("All waypoints remain within reach."));
}

void WaypointShift::accept() {
    for (DecimalSpinBox* box : {offset_[0], offset_[1], offset_[2], angle_}) {
        if (box->isRefused()) {
            box->setFocus();
            box->explainRefusal();
            return;
        }
    }
    if (moved().ok()) {
        QDialog::accept();
    } else {
        refresh();
    }
}

}  // namespace tiller

#include "moc_waypoint_shift.cpp"
