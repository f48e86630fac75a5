// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits a new or existing pattern defined by three corner waypoints: corners, number of positions, order,
// skipped positions, and layers.

#include <QDialog>
#include <array>

#include "robot/project/pattern.h"

class QLabel;
class QLineEdit;
class QSpinBox;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;
class PatternGrid;
class ProjectDocument;

class PatternDialog : public QDialog {
    Q_OBJECT

public:
    /// Creates a new pattern.
    /// corners  waypoints of the first position, of the end of the first row, and of the start of the last
    /// row; the user selects missing corners
    PatternDialog(const ProjectDocument& document, const QVector<QUuid>& corners, QWidget* parent = nullptr);
    /// Edits an existing pattern of the document.
    PatternDialog(const ProjectDocument& document, const project::Pattern& pattern,
                  QWidget* parent = nullptr);

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
    DecimalSpinBox* layerStep_ = nullptr;
    ChoiceBox* order_ = nullptr;
    PatternGrid* grid_ = nullptr;
    QLabel* feedback_ = nullptr;
};

}  // namespace tiller
