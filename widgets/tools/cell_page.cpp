// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tools/cell_page.h"

#include <QAction>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "robot/station/document/project_document.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/text/notation.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/pose_editor.h"
#include "widgets/common/row_table.h"

namespace tiller {
namespace {

constexpr double kFarthestInCell = 10;  ///< [m]
constexpr double kNewEdge = 0.1;        ///< initial edge length of a box [m]

/// Returns a pose at this point with its Z axis along the normal and the smallest rotation relative to the
/// base frame.
Pose planePose(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
    Pose pose;
    pose.position = point;
    pose.rotation = rotationVector(turn.toRotationMatrix());
    return pose;
}

/// Calls `use` with the box or plane of this row.
template <class Use>
auto withRow(const project::CellGeometry& cell, int row, const Use& use) {
    const auto at = static_cast<std::size_t>(row);
    return at < cell.boxes.size() ? use(cell.boxes.at(at)) : use(cell.planes.at(at - cell.boxes.size()));
}

QString sizeText(const project::CellBox& box) {
    return format::lengthNumber(box.size.x(), 0, false) + QStringLiteral(" × ") +
           format::lengthNumber(box.size.y(), 0, false) + QStringLiteral(" × ") +
           format::lengthNumber(box.size.z(), 0, false);
}

PartModel* cellModel(ProjectDocument& document) {
    PartModel::Content content;
    content.valueHeadings = [] { return QStringList{CellPage::tr("Size %1").arg(format::lengthUnit())}; };
    content.count = [&document] {
        return static_cast<int>(document.cell().boxes.size() + document.cell().planes.size());
    };
    content.isInUse = [&document](int row) {
        return withRow(document.cell(), row, [](const auto& part) { return part.enabled; });
    };
    content.inUse = CellPage::tr("Shown and checked for collisions");
    content.name = [&document](int row) {
        return withRow(document.cell(), row, [](const auto& part) { return part.name; });
    };
    content.figures = [&document](int row) {
        const project::CellBoxList& boxes = document.cell().boxes;
        const auto at = static_cast<std::size_t>(row);
        return QStringList{at < boxes.size() ? sizeText(boxes.at(at)) : CellPage::tr("Plane")};
    };
    content.nameProblem = [&document](int, const QString& name) {
        const project::CellGeometry& cell = document.cell();
        return name.isEmpty() ? CellPage::tr("Enter a name for the box or plane.")
               : cell.boxes.findByName(name) != nullptr || cell.planes.findByName(name) != nullptr
                   ? CellPage::tr("The cell already contains “%1”. Choose a different name.").arg(name)
                   : QString();
    };
    content.rename = [&document](int row, const QString& name) {
        project::CellGeometry after = document.cell();
        const auto at = static_cast<std::size_t>(row);
        const auto rename = [&](auto& list, std::size_t index) {
            auto part = list.at(index);
            const QString text = CellPage::tr("Rename “%1” to “%2”").arg(part.name, name);
            part.name = name;
            list.replace(index, part);
            document.changeCell(after, text);
        };
        if (at < after.boxes.size()) {
            rename(after.boxes, at);
        } else {
            rename(after.planes, at - after.boxes.size());
        }
    };
    return new PartModel(content);
}

}  // namespace

// ---- vector editor ------------------------------------------------------------------------------------------

VectorEditor::VectorEditor(Kind kind, const QString& name, const std::array<QString, 3>& letters,
                           const std::array<QString, 3>& spoken, QWidget* parent)
    : QWidget(parent), kind_(kind) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        auto* letter = new QLabel(letters.at(at));
        letter->setProperty("role", "secondary");
        auto* box = new DecimalSpinBox;
        box->setObjectName(QStringLiteral("%1.%2").arg(name).arg(i));
        box->setAccessibleName(spoken.at(at));
        box->setToolTip(
            tr("%1. Press Return to apply the value. The robot does not move.").arg(spoken.at(at)));
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        box->setProperty("dense", true);
        box->setMinimumWidth(80);
        letter->setBuddy(box);
        row->addWidget(letter);
        row->addWidget(box, 1);
        boxes_.at(at) = box;
        connect(box, &QAbstractSpinBox::editingFinished, this, [this, i] { take(i); });
    }
    updateValueTexts();
}

double VectorEditor::unit() const {
    return kind_ == Kind::Direction ? 1 : format::metresPerUnit();
}

void VectorEditor::setVector(const Eigen::Vector3d& vector) {
    if (vector != vector_) {
        vector_ = vector;
        updateValueTexts();
    }
}

void VectorEditor::updateValueTexts() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        DecimalSpinBox& box = *boxes_[i];
        const QSignalBlocker quiet(box);
        box.setDecimals(kind_ == Kind::Direction                           ? 4
                        : Notation::current().length == LengthUnit::Inches ? 3
                                                                           : 2);
        const double most = kind_ == Kind::Direction ? 1 : kFarthestInCell / unit();
        constexpr double kMinEdge = 0.001;  // [m]
        box.setRange(kind_ == Kind::Size ? kMinEdge / unit() : -most, most);
        box.setSuffix(kind_ == Kind::Direction ? QString() : QLatin1Char(' ') + format::lengthUnit());
        box.setValue(vector_[static_cast<Eigen::Index>(i)] / unit());
        // Store the rounded value of the box, so that only edited values count as changed.
        shown_[i] = box.value();
    }
}

void VectorEditor::take(int figure) {
    const auto at = static_cast<std::size_t>(figure);
    if (boxes_[at]->isRefused() || boxes_[at]->value() == shown_[at]) {
        return;
    }
    shown_[at] = boxes_[at]->value();
    vector_[figure] = shown_[at] * unit();
    Q_EMIT entered(vector_);
}

void VectorEditor::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && boxes_[2] != nullptr) {
        updateValueTexts();
    }
    QWidget::changeEvent(event);
}

// ---- page
// ---------------------------------------------------------------------------------------------------

/// Returns a copy of the part. If its frame does not exist, the frame of the copy is the base frame.
template <class Part>
Part CellPage::placed(Part part) const {
    part.frame = document_.frames().pose(part.frame) ? part.frame : QUuid();
    return part;
}

CellPage::CellPage(RobotSession& session, ProjectDocument& document, QWidget* parent)
    : PartPage(
          QStringLiteral("cell"), CellPage::tr("Cell"), cellModel(document),
          CellPage::tr(
              "No boxes or planes yet.\nMove the TCP to a corner of an obstacle and press “Teach corner”."),
          new QWidget, parent)
    , document_(document)
    , state_(session.state())
    , selected_(new QWidget)
    , facts_(new QLabel)
    , enabled_(new QCheckBox(CellPage::tr("Check for collisions")))
    , pose_(new PoseEditor(QStringLiteral("cell.box"), CellPage::tr("Centre"),
                           CellPage::tr("Centre of the box. Press Return to apply the values. Only the box "
                                        "changes; the robot does not move.")))
    , size_(new VectorEditor(
          VectorEditor::Kind::Size, QStringLiteral("cell.size"),
          {CellPage::tr("LX"), CellPage::tr("LY"), CellPage::tr("LZ")},
          {CellPage::tr("Length along X"), CellPage::tr("Length along Y"), CellPage::tr("Length along Z")}))
    , planeValues_(new QWidget)
    , point_(new VectorEditor(VectorEditor::Kind::Point, QStringLiteral("cell.point"),
                              {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")},
                              {CellPage::tr("Point on the plane, X"), CellPage::tr("Point on the plane, Y"),
                               CellPage::tr("Point on the plane, Z")}))
    , normal_(new VectorEditor(
          VectorEditor::Kind::Direction, QStringLiteral("cell.normal"),
          {QStringLiteral("NX"), QStringLiteral("NY"), QStringLiteral("NZ")},
          {CellPage::tr("Normal X, towards the arm"), CellPage::tr("Normal Y, towards the arm"),
           CellPage::tr("Normal Z, towards the arm")}))
    , hasFloor_(new QCheckBox(CellPage::tr("Floor")))
    , floor_(new DecimalSpinBox)
    , distance_(new DecimalSpinBox) {
    facts_->setObjectName(QStringLiteral("cell.facts"));
    enabled_->setObjectName(QStringLiteral("cell.enabled"));
    enabled_->setToolTip(
        CellPage::tr("When off, the box or plane is neither shown nor checked for collisions."));
    hasFloor_->setObjectName(QStringLiteral("cell.hasFloor"));
    hasFloor_->setToolTip(CellPage::tr("Horizontal plane in the base frame that the arm must stay above."));
    floor_->setObjectName(QStringLiteral("cell.floor"));
    floor_->setAccessibleName(CellPage::tr("Floor height"));
    distance_->setObjectName(QStringLiteral("cell.safetyDistance"));
    distance_->setAccessibleName(CellPage::tr("Safety distance"));
    distance_->setToolTip(
        CellPage::tr("Jogging stops at this distance from objects in the cell and between parts of the arm. "
                     "Moves that would bring the arm closer are refused."));
    auto* floorHere = new QPushButton(CellPage::tr("At TCP"));
    floorHere->setObjectName(QStringLiteral("cell.floorHere"));
    floorHere->setAccessibleName(CellPage::tr("Set the floor to the TCP height"));
    for (DecimalSpinBox* box : {floor_, distance_}) {
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        box->setProperty("dense", true);
        box->setMinimumWidth(72);
    }

    auto* headline = new QHBoxLayout;
    headline->addWidget(facts_, 1);
    headline->addWidget(enabled_);
    auto* planeLayout = new QVBoxLayout(planeValues_);
    planeLayout->setContentsMargins(0, 0, 0, 0);
    planeLayout->setSpacing(6);
    planeLayout->addWidget(point_);
    planeLayout->addWidget(normal_);
    auto* selectedLayout = new QVBoxLayout(selected_);
    selectedLayout->setContentsMargins(0, 0, 0, 0);
    selectedLayout->setSpacing(6);
    selectedLayout->addLayout(headline);
    selectedLayout->addWidget(pose_);
    selectedLayout->addWidget(size_);
    selectedLayout->addWidget(planeValues_);
    selectedLayout->addStretch();
    auto* keep = new QLabel(CellPage::tr("Distance"));
    keep->setBuddy(distance_);
    auto* cellRow = new QHBoxLayout;
    cellRow->setSpacing(6);
    cellRow->addWidget(hasFloor_);
    cellRow->addWidget(floor_, 1);
    cellRow->addWidget(floorHere);
    cellRow->addWidget(keep);
    cellRow->addWidget(distance_, 1);
    // In a panel with little height, the values scroll, and the list and the row below stay in place.
    auto* figures = new NoFocusScrollArea;
    figures->setObjectName(QStringLiteral("cell.figures"));
    figures->setWidgetResizable(true);
    figures->setFrameShape(QFrame::NoFrame);
    figures->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    figures->setFocusPolicy(Qt::NoFocus);
    figures->setWidget(selected_);
    figures->viewport()->setAutoFillBackground(false);
    selected_->setAutoFillBackground(false);
    figures->setMinimumHeight(70);
    figures->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    selected_ = figures;
    auto* layout = new QVBoxLayout(&details());
    layout->setContentsMargins(12, 8, 12, 12);
    layout->setSpacing(6);
    layout->addWidget(figures);
    layout->addLayout(cellRow);
    constexpr int kSizeColumn = 150;  // width of the column for sizes [px]
    table().setColumnWidth(PartModel::FirstValue, kSizeColumn);

    cornerKey_ = addKey(QStringLiteral("corner"), CellPage::tr("Teach corner"),
                        CellPage::tr("Teach a box corner at the TCP"), 3, [this] { takeCorner(); });
    cornerKey_->setProperty("primary", true);
    const auto planeHere = [this] {
        if (!refusedWithoutData()) {
            // The tool points at the surface, so the arm is on the permitted side of the plane.
            addPlane(planePose(state_.tcpPose.position, -rotationMatrix(state_.tcpPose.rotation).col(2)));
        }
    };
    const auto newBox = [this] {
        addBox(Pose(0.5, 0, kNewEdge / 2, 0, 0, 0), Eigen::Vector3d::Constant(kNewEdge));
        pose_->editFirst();
    };
    addKey(QStringLiteral("plane"), CellPage::tr("Teach plane"),
           CellPage::tr("Add a plane through the TCP, perpendicular to the tool"), 2, planeHere);
    addKey(QStringLiteral("box"), CellPage::tr("New box"), CellPage::tr("Add a box numerically"), 2, newBox);
    addCommand(QStringLiteral("corner"), CellPage::tr("Teach a box corner at the TCP"), false,
               [this] { takeCorner(); });
    addCommand(QStringLiteral("plane"), CellPage::tr("Add a plane through the TCP"), false, planeHere);
    addCommand(QStringLiteral("box"), CellPage::tr("Add a box numerically"), false, newBox);
    addCommand(QStringLiteral("newPlane"), CellPage::tr("Add a plane numerically"), false, [this] {
        addPlane(planePose({0, 0.6, 0}, -Eigen::Vector3d::UnitY()));
    });
    addCommand(QStringLiteral("moveToTcp"), CellPage::tr("Move the box or plane to the TCP"), true,
               [this] { moveToTcp(); });
    addCommand(QStringLiteral("enable"), CellPage::tr("Turn collision check on or off"), true,
               [this] { setEnabledInCell(!enabled_->isChecked()); });
    addCommand(QStringLiteral("rename"), CellPage::tr("Rename box or plane"), true,
               [this] { table().renameCurrent(); });
    addCommand(QStringLiteral("duplicate"), CellPage::tr("Duplicate box or plane"), true,
               [this] { duplicate(); });
    addCommand(QStringLiteral("delete"), CellPage::tr("Delete box or plane"), true, [this] { remove(); });
    addCommand(QStringLiteral("floor"), CellPage::tr("Set the floor to the TCP height"), false, [this] {
        if (!refusedWithoutData()) {
            setFloor(state_.tcpPose.position.z());
        }
    });

    connect(enabled_, &QCheckBox::clicked, this, &CellPage::setEnabledInCell);
    connect(pose_, &PoseEditor::poseEntered, this, [this](const Pose& pose) {
        if (const project::CellBox* selected = box()) {
            project::CellBox after = placed(*selected);
            after.pose = pose;
            change(after, CellPage::tr("Move “%1”").arg(after.name));
        }
    });
    connect(size_, &VectorEditor::entered, this, [this](const Eigen::Vector3d& size) {
        if (const project::CellBox* selected = box()) {
            project::CellBox after = *selected;
            after.size = size;
            change(after, CellPage::tr("Resize “%1”").arg(after.name));
        }
    });
    connect(point_, &VectorEditor::entered, this, [this](const Eigen::Vector3d& point) {
        if (const project::CellPlane* selected = plane()) {
            project::CellPlane after = placed(*selected);
            after.pose.position = point;
            change(after, CellPage::tr("Move “%1”").arg(after.name));
        }
    });
    connect(normal_, &VectorEditor::entered, this, [this](const Eigen::Vector3d& normal) {
        const project::CellPlane* selected = plane();
        constexpr double kNone = 1e-3;
        if (selected == nullptr) {
            return;
        }
        if (normal.norm() < kNone) {
            showProblem(CellPage::tr("The normal must not be zero. Enter at least one nonzero component."));
            refresh();
            return;
        }
        project::CellPlane after = *selected;  // keeps the other values of the plane
        after.pose = planePose(after.pose.position, normal.normalized());
        change(after, CellPage::tr("Rotate “%1”").arg(after.name));
    });
    connect(hasFloor_, &QCheckBox::clicked, this,
            [this](bool on) { setFloor(on ? std::optional(shownFloor_) : std::nullopt); });
    connect(floor_, &QAbstractSpinBox::editingFinished, this, &CellPage::takeFloor);
    connect(distance_, &QAbstractSpinBox::editingFinished, this, &CellPage::takeDistance);
    connect(floorHere, &QPushButton::clicked, this, [this] {
        if (!refusedWithoutData()) {
            setFloor(state_.tcpPose.position.z());
        }
    });
    for (const auto changed : {&ProjectDocument::cellChanged, &ProjectDocument::framesChanged}) {
        connect(&document_, changed, this, [this] { followList(); });
    }
    keepDetails();
    followList();
}

const project::CellBox* CellPage::box() const {
    const auto row = static_cast<std::size_t>(currentRow());
    return currentRow() >= 0 && row < document_.cell().boxes.size() ? &document_.cell().boxes.at(row)
                                                                    : nullptr;
}

const project::CellPlane* CellPage::plane() const {
    const int row = currentRow() - static_cast<int>(document_.cell().boxes.size());
    const int planes = static_cast<int>(document_.cell().planes.size());
    return currentRow() >= 0 && row >= 0 && row < planes
               ? &document_.cell().planes.at(static_cast<std::size_t>(row))
               : nullptr;
}

bool CellPage::refusedWithoutData() {
    const QString why = dataObstacle(state_);
    if (!why.isEmpty()) {
        showProblem(why);
    }
    return !why.isEmpty();
}

void CellPage::change(const project::CellGeometry& cell, const QString& text) {
    document_.changeCell(cell, text);
}

void CellPage::change(const project::CellBox& box, const QString& text) {
    project::CellGeometry after = document_.cell();
    after.boxes.replace(static_cast<std::size_t>(after.boxes.indexOf(box.id)), box);
    change(after, text);
}

void CellPage::change(const project::CellPlane& plane, const QString& text) {
    project::CellGeometry after = document_.cell();
    after.planes.replace(static_cast<std::size_t>(after.planes.indexOf(plane.id)), plane);
    change(after, text);
}

void CellPage::addBox(const Pose& pose, const Eigen::Vector3d& size) {
    project::CellBox added;
    added.id = QUuid::createUuid();
    added.name = document_.cell().boxes.nextName(CellPage::tr("box"));
    added.pose = pose;
    added.size = size;
    project::CellGeometry after = document_.cell();
    after.boxes.append(added);
    change(after, CellPage::tr("Add “%1”").arg(added.name));
    selectRow(document_.cell().boxes.indexOf(added.id));
}

void CellPage::addPlane(const Pose& pose) {
    project::CellPlane added;
    added.id = QUuid::createUuid();
    added.name = document_.cell().planes.nextName(CellPage::tr("plane"));
    added.pose = pose;
    project::CellGeometry after = document_.cell();
    after.planes.append(added);
    change(after, CellPage::tr("Add “%1”").arg(added.name));
    selectRow(static_cast<int>(document_.cell().boxes.size()) + document_.cell().planes.indexOf(added.id));
}

void CellPage::takeCorner() {
    if (refusedWithoutData()) {
        return;
    }
    const Eigen::Vector3d here = state_.tcpPose.position;
    if (!corner_) {
        corner_ = here;
        notice().show(NoticeBar::Kind::Question, CellPage::tr("First corner recorded"),
                      CellPage::tr("Move the TCP to the opposite corner and press “Teach corner 2”."),
                      CellPage::tr("Discard"), [this] {
                          corner_.reset();
                          refresh();
                      });
    } else {
        constexpr double kMinEdge = 0.001;  // [m]
        const Eigen::Vector3d edges = (here - *corner_).cwiseAbs();
        if (edges.minCoeff() < kMinEdge) {
            showProblem(
                CellPage::tr("The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the "
                             "opposite corner of the box."));
            return;
        }
        const Eigen::Vector3d centre = (here + *corner_) / 2;
        corner_.reset();
        notice().dismiss();
        addBox(Pose(centre.x(), centre.y(), centre.z(), 0, 0, 0), edges);
    }
    refresh();
}

Pose CellPage::inBase(const QUuid& frame, const Pose& pose) const {
    const std::optional<Pose> T_base_frame = document_.frames().pose(frame);
    return T_base_frame ? Pose(T_base_frame->transform() * pose.transform()) : pose;
}

Pose CellPage::inFrame(const QUuid& frame, const Pose& T_base) const {
    const std::optional<Pose> T_base_frame = document_.frames().pose(frame);
    return T_base_frame ? Pose(T_base_frame->transform().inverse(Eigen::Isometry) * T_base.transform())
                        : T_base;
}

void CellPage::moveToTcp() {
    if (refusedWithoutData()) {
        return;
    }
    const auto moved = [this](auto part) {
        Pose pose = inBase(part.frame, part.pose);
        pose.position = state_.tcpPose.position;
        part.pose = inFrame(part.frame, pose);
        return placed(part);
    };
    if (const project::CellBox* selected = box()) {
        change(moved(*selected), CellPage::tr("Move “%1”").arg(selected->name));
    } else if (const project::CellPlane* wall = plane()) {
        change(moved(*wall), CellPage::tr("Move “%1”").arg(wall->name));
    }
}

void CellPage::duplicate() {
    project::CellGeometry after = document_.cell();
    const auto copy = [&](auto& list, auto part) {
        part.id = QUuid::createUuid();
        part.name = list.uniqueName(part.name);
        list.append(part);
        change(after, CellPage::tr("Duplicate “%1”").arg(part.name));
        return part.id;
    };
    if (const project::CellBox* selected = box()) {
        selectRow(document_.cell().boxes.indexOf(copy(after.boxes, *selected)));
    } else if (const project::CellPlane* wall = plane()) {
        const QUuid id = copy(after.planes, *wall);
        selectRow(static_cast<int>(document_.cell().boxes.size()) + document_.cell().planes.indexOf(id));
    }
}

void CellPage::remove() {
    project::CellGeometry after = document_.cell();
    if (const project::CellBox* selected = box()) {
        const QString text = CellPage::tr("Delete “%1”").arg(selected->name);
        after.boxes.remove(static_cast<std::size_t>(currentRow()));
        change(after, text);
    } else if (const project::CellPlane* wall = plane()) {
        const QString text = CellPage::tr("Delete “%1”").arg(wall->name);
        after.planes.remove(static_cast<std::size_t>(after.planes.indexOf(wall->id)));
        change(after, text);
    }
}

void CellPage::setEnabledInCell(bool enabled) {
    const auto set = [&](auto part) {
        part.enabled = enabled;
        change(part, enabled ? CellPage::tr("Turn on the collision check of “%1”").arg(part.name)
                             : CellPage::tr("Turn off the collision check of “%1”").arg(part.name));
    };
    if (const project::CellBox* selected = box()) {
        set(*selected);
    } else if (const project::CellPlane* wall = plane()) {
        set(*wall);
    }
}

void CellPage::setFloor(const std::optional<double>& height) {
    project::CellGeometry after = document_.cell();
    after.floor = height;
    change(after, height ? CellPage::tr("Set the floor") : CellPage::tr("Remove the floor"));
}

void CellPage::takeFloor() {
    if (!floor_->isRefused() && hasFloor_->isChecked() &&
        floor_->value() !=
            floor_->valueFromText(floor_->textFromValue(shownFloor_ / format::metresPerUnit()))) {
        setFloor(floor_->value() * format::metresPerUnit());
    }
}

void CellPage::takeDistance() {
    const double shown = shownDistance_ / format::metresPerUnit();
    if (!distance_->isRefused() &&
        distance_->value() != distance_->valueFromText(distance_->textFromValue(shown))) {
        project::CellGeometry after = document_.cell();
        after.safetyDistance = distance_->value() * format::metresPerUnit();
        change(after, CellPage::tr("Change the safety distance"));
    }
}

void CellPage::setState(const SessionState& state) {
    state_ = state;
}

void CellPage::onSelection() {
    refresh();
}

void CellPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && distance_ != nullptr) {
        shownDistance_ = -1;  // units may have changed
        refresh();
    }
    PartPage::changeEvent(event);
}

void CellPage::refresh() {
    const project::CellGeometry& cell = document_.cell();
    cornerKey_->setText(corner_ ? CellPage::tr("Teach corner 2") : CellPage::tr("Teach corner"));
    const project::CellBox* selected = box();
    const project::CellPlane* wall = plane();
    selected_->setVisible(selected != nullptr || wall != nullptr);
    pose_->setVisible(selected != nullptr);
    size_->setVisible(selected != nullptr);
    planeValues_->setVisible(wall != nullptr);
    const auto fact = [this](const auto& part, const QString& kind) {
        const project::Frame* frame = document_.frames().find(part.frame);
        facts_->setText(CellPage::tr("%1 · %2 in %3")
                            .arg(part.name, kind,
                                 frame != nullptr      ? frame->name
                                 : part.frame.isNull() ? CellPage::tr("Base")
                                                       : CellPage::tr("missing frame")));
        enabled_->setChecked(part.enabled);
    };
    if (selected != nullptr) {
        fact(*selected, CellPage::tr("box"));
        pose_->setPose(selected->pose);
        size_->setVector(selected->size);
    } else if (wall != nullptr) {
        fact(*wall, CellPage::tr("plane"));
        point_->setVector(wall->pose.position);
        normal_->setVector(rotationMatrix(wall->pose.rotation).col(2));
    }

    hasFloor_->setChecked(cell.floor.has_value());
    floor_->setEnabled(cell.floor.has_value());
    const double perUnit = format::metresPerUnit();
    const bool isNew = shownDistance_ < 0;
    if (const double height = cell.floor.value_or(shownFloor_); isNew || height != shownFloor_) {
        const QSignalBlocker quiet(floor_);
        shownFloor_ = height;
        floor_->setRange(-kFarthestInCell / perUnit, kFarthestInCell / perUnit);
        floor_->setSuffix(QLatin1Char(' ') + format::lengthUnit());
        floor_->setValue(height / perUnit);
    }
    if (isNew || cell.safetyDistance != shownDistance_) {
        const QSignalBlocker quiet(distance_);
        shownDistance_ = cell.safetyDistance;
        distance_->setRange(0, project::kMaxSafetyDistance / perUnit);
        distance_->setSuffix(QLatin1Char(' ') + format::lengthUnit());
        distance_->setValue(shownDistance_ / perUnit);
    }
}

}  // namespace tiller

#include "moc_cell_page.cpp"
