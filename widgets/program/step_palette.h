// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All step kinds by group. The user drags them into a program.

#include <QTreeWidget>

#include "robot/project/program.h"

namespace tiller {

class StepPalette : public QTreeWidget {
    Q_OBJECT

public:
    explicit StepPalette(QWidget* parent = nullptr);

Q_SIGNALS:
    /// The user selected a step kind by a double click or Return.
    void stepChosen(const tiller::project::ProgramStep& step);

protected:
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override;
};

}  // namespace tiller
