// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The step tree of a program. The selection and the expanded sections are restored by step ID after the
// program has changed.

#include <QSet>
#include <QTimer>
#include <QTreeView>
#include <QUuid>

namespace tiller {

class ProgramModel;

class StepTree : public QTreeView {
    Q_OBJECT

public:
    explicit StepTree(ProgramModel& model, QWidget* parent = nullptr);

    QSet<QUuid> selectedIds() const;
    QUuid currentId() const;  ///< null if there is no current step
    void selectIds(const QList<QUuid>& ids);

Q_SIGNALS:
    void selectionMoved();

protected:
    void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Distributes the width. If there is not enough, the step column has priority, then the result column.
    void fitColumns();
    /// Shows the running step, unless the user has scrolled away from it.
    void followRun(const QModelIndex& before, const QModelIndex& now);
    /// The step, or the outermost collapsed section that contains it.
    QModelIndex shownRowOf(const QModelIndex& step) const;

    ProgramModel& model_;
    QTimer fitTimer_;
    QSet<QUuid> collapsed_;
    QSet<QUuid> selected_;
    QUuid current_;
    bool isRestoring_ = false;
};

}  // namespace tiller
