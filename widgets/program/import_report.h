// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report of an import: each node or statement of the program file with the step that it became.
// Activating a row selects the step.

#include <QDialog>
#include <QUuid>

#include "robot/station/program/import/program_import.h"

namespace tiller {

class ImportReport : public QDialog {
    Q_OBJECT

public:
    explicit ImportReport(const program::ImportedProgram& imported, QWidget* parent = nullptr);

Q_SIGNALS:
    void stepChosen(const QUuid& step);
};

}  // namespace tiller
