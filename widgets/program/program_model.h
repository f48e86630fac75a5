// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The steps of one program as a tree: number and kind, values, and the problem or the simulated time. The
// model only reports dropped steps. The edit of the project then updates the model.

#include <QAbstractItemModel>
#include <QSet>
#include <memory>

#include "robot/station/program/execution/step_log.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/recover/recovery_map.h"

namespace tiller {

class ProgramModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Step, Values, Result };
    static constexpr char kStepsMime[] = "application/x-tiller-steps";

    explicit ProgramModel(QObject* parent = nullptr);
    ~ProgramModel() override;

    /// project  must outlive the model, or remain valid until the next call
    /// program  if null, the tree is empty
    void setProgram(const project::Project& project, const project::Program* program);
    void setProblems(const std::vector<program::ProgramProblem>& problems);
    /// script  script of the preview; null: no preview
    void setPreview(const program::ProgramScript* script, const program::Preview* preview);

    /// Sets the marks of the recoverability check.
    /// script  script of the check; null: no marks
    void setRecovery(const program::ProgramScript* script, const program::RecoveryMap* map);

    /// Marks the steps before which a run pauses.
    void setBreakpoints(const QSet<QUuid>& steps);

    /// Highlights the steps that an edit outside of the program has changed.
    void setChanged(const QSet<QUuid>& steps);

    /// Shows the steps of a run: the running step, and the number of runs and the mean time of each step.
    /// isActive  false after the end of the run: no step is running
    void setRun(const program::ProgramScript& script, const program::StepLog& log, bool isActive);

    QUuid idAt(const QModelIndex& index) const;  ///< null for an invalid index
    QModelIndex indexOf(const QUuid& id) const;
    /// A problem with the step, or the preview's finding for the step; empty if there is neither.
    QString noteAt(const QUuid& id) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    Qt::DropActions supportedDropActions() const override;
    bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

Q_SIGNALS:
    /// The tree was reset. Views must restore the selection and the expanded sections by step ID.
    void treeChanged();
    void stepsDropped(const tiller::program::StepPosition& at,
                      const std::vector<tiller::project::ProgramStep>& steps);
    /// The running step has changed.
    /// before, now  invalid if no step of this program was or is running
    void runningStepMoved(const QModelIndex& before, const QModelIndex& now);
    void stepsMoved(const tiller::program::StepPosition& at, const QSet<QUuid>& ids);

private:
    struct Node;
    Node* nodeAt(const QModelIndex& index) const;
    void changed();
    bool isRunning(const Node& node) const;
    void showTimings(const program::ProgramScript& script, const std::vector<program::StepTiming>& timings);

    const project::Project* project_ = nullptr;
    project::Program program_;
    std::unique_ptr<Node> root_;
    QHash<QUuid, Node*> nodes_;
    QUuid running_;  ///< null if no step is running
    QSet<QUuid> breakpoints_;
    QSet<QUuid> changed_;
};

}  // namespace tiller
