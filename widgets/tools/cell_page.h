// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The surroundings of the arm: boxes, planes, the floor and the safety distance. Objects are entered as
// numbers or taught with the TCP. Changes are displayed and checked immediately.

#include <array>
#include <optional>

#include "robot/project/cell_geometry.h"
#include "widgets/tools/part_page.h"

class QCheckBox;
class QLabel;

namespace tiller {

class DecimalSpinBox;
class PoseEditor;
class ProjectDocument;

/// Three number fields in a row: a point or size in the selected length unit, or a direction without a unit.
class VectorEditor : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Point, Size, Direction };
    /// name     the boxes have the object names name.0 ... name.2
    /// letters  labels of the boxes: "X", "Y", "Z"
    VectorEditor(Kind kind, const QString& name, const std::array<QString, 3>& letters,
                 const std::array<QString, 3>& spoken, QWidget* parent = nullptr);

    void setVector(const Eigen::Vector3d& vector);  ///< [m]; a direction has no unit

Q_SIGNALS:
    /// A value was edited. The other two values keep their full precision.
    void entered(const Eigen::Vector3d& vector);

protected:
    void changeEvent(QEvent* event) override;

private:
    void updateValueTexts();
    void take(int figure);
    double unit() const;

    Kind kind_;
    Eigen::Vector3d vector_ = Eigen::Vector3d::Zero();
    std::array<DecimalSpinBox*, 3> boxes_{};
    std::array<double, 3> shown_{};
};

class CellPage : public PartPage {
    Q_OBJECT

public:
    /// document  must outlive the object
    CellPage(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);

    void setState(const SessionState& state);

protected:
    void onSelection() override;
    void changeEvent(QEvent* event) override;

private:
    // The selected box or plane; null if the selection is of the other kind or empty. Boxes are listed before
    // planes.
    const project::CellBox* box() const;
    const project::CellPlane* plane() const;
    bool refusedWithoutData();
    void addBox(const Pose& pose, const Eigen::Vector3d& size);
    void addPlane(const Pose& pose);
    void takeCorner();
    void moveToTcp();
    void duplicate();
    void remove();
    void setEnabledInCell(bool enabled);
    void change(const project::CellBox& box, const QString& text);
    void change(const project::CellPlane& plane, const QString& text);
    void change(const project::CellGeometry& cell, const QString& text);
    void setFloor(const std::optional<double>& height);
    void takeFloor();
    void takeDistance();
    template <class Part>
    Part placed(Part part) const;
    Pose inBase(const QUuid& frame, const Pose& pose) const;
    Pose inFrame(const QUuid& frame, const Pose& T_base) const;
    void refresh();

    ProjectDocument& document_;
    SessionState state_;
    std::optional<Eigen::Vector3d> corner_;  ///< first corner of a new box, in the base frame [m]
    QPushButton* cornerKey_ = nullptr;
    QWidget* selected_;
    QLabel* facts_;
    QCheckBox* enabled_;
    PoseEditor* pose_;
    VectorEditor* size_;
    QWidget* planeValues_;
    VectorEditor* point_;
    VectorEditor* normal_;
    QCheckBox* hasFloor_;
    DecimalSpinBox* floor_;
    DecimalSpinBox* distance_;
    double shownFloor_ = 0;
    double shownDistance_ = -1;
};

}  // namespace tiller
