// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A pattern of places between three corners: which waypoints they are, how many places, in which order, which are left
// out, how many layers. For a new pattern, and for one that is changed later.

#include <QDialog>
#include <array>

#include "robot/project/pattern.h"

class QLabel;
class QLineEdit;
class QSpinBox;

namespace tiller {

class ChoiceBox;
class FigureBox;
class PatternGrid;
class ProjectDocument;

class PatternDialog : public QDialog {
    Q_OBJECT

public:
    /// A new pattern.
    /// corners  the waypoints it is taught at: first place, end of the first row, beginning of the last row; those that
    ///          are missing can be chosen
    PatternDialog(const ProjectDocument& document, const QVector<QUuid>& corners, QWidget* parent = nullptr);
    /// The one of the document with that id.
    PatternDialog(const ProjectDocument& document, const project::Pattern& pattern,
                  QWidget* parent = nullptr);

    /// As it is to be.
    const project::Pattern& pattern() const { return pattern_; }
    void accept() override;

private:
    void build(bool isNew);
    void takeCorner(int corner);
    QString problem() const;
    void refresh();

    const ProjectDocument& document_;
    project::Pattern pattern_;
    bool isNew_;
    QLineEdit* name_ = nullptr;
    std::array<ChoiceBox*, 3> corners_{};
    QSpinBox* columns_ = nullptr;
    QSpinBox* rows_ = nullptr;
    QSpinBox* layers_ = nullptr;
    FigureBox* layerStep_ = nullptr;
    ChoiceBox* order_ = nullptr;
    PatternGrid* grid_ = nullptr;
    QLabel* feedback_ = nullptr;
};

}  // namespace tiller
