// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Program". It shows the programs of the project, the steps of one program, the fields of the
// selected step, and a preview in the simulated controller. RunBar runs the program on a robot.

#include <Eigen/Core>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "robot/station/program/import/program_import.h"
#include "robot/station/program/preview/background_task.h"
#include "robot/station/program/preview/preview_runner.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/recover/recovery_runner.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QPushButton;

namespace tiller {

namespace program {
class ProgramRunner;
}

class ElidedLabel;
class ProgramModel;
class ProjectDocument;
class RobotSession;
class RunBar;
class SegmentedControl;
class StepForm;
class StepPalette;
class StepTree;
struct HeldSpeed;
struct HoldPolicy;

class ProgramTab : public QWidget {
    Q_OBJECT

public:
    /// document  must outlive the tab
    explicit ProgramTab(ProjectDocument& document, QWidget* parent = nullptr);

    /// Adds the buttons that run the program. Call this once. The arguments are those of RunBar.
    void setRobot(RobotSession& session, HoldPolicy& policy, std::function<HeldSpeed()> heldSpeed);
    void followSpeed();

    /// All actions, for the menus, the command list and the help page.
    QList<QAction*> commandActions() const { return actions_; }
    StepTree& tree() { return *tree_; }
    /// True while a program runs without hold-to-run.
    bool runsFreely() const;
    /// Path of the TCP in the preview, in the base frame [m]; empty without a preview.
    const std::vector<Eigen::Vector3d>& previewPath() const { return path_; }

Q_SIGNALS:
    /// A command of this tab was triggered, so the tab should be shown.
    void frontWanted();
    void previewPathChanged();
    void runEnded();
    /// Label of the running step, e.g. "Step 3 (MoveL)"; empty if no program runs.
    void runningStepChanged(const QString& label);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Panels of the right column if there is space for only one of them.
    enum Side { Palette, Form };

    const project::Program* current() const;
    QAction* addCommand(const char* name, const QString& text, const QKeySequence& keys,
                        void (ProgramTab::*run)());
    void buildLayout();
    void addCommands();
    void follow();
    void check();
    /// Highlights the steps of the current program that an edit outside of the programs has changed.
    /// before  script of the last check
    void highlightLastEdit(const program::ProgramScript& before);
    bool isSameCell(const project::Project& before) const;
    program::ScriptOptions scriptOptions() const;
    /// Script that runs the program from the beginning on the connected robot.
    program::ProgramScript completeScript() const;
    void showSelection();
    void showSides();
    void showStatus(const QString& text);
    /// Selects the step with the next problem or the next finding of the preview.
    void showNextProblem();
    void edit(const project::Program& after, const QString& text);
    /// at  position; if empty, after the selected step
    void insert(const program::Steps& steps, const std::optional<program::StepPosition>& at = std::nullopt);
    void changeSelected(project::Program (*change)(const project::Program&, const QSet<QUuid>&),
                        const QString& text);
    void addProgram();
    void renameProgram();
    void removeProgram();
    void cut();
    void copy();
    void paste();
    void duplicate();
    void remove();
    void toggleDisabled();
    void toggleBreakpoints();
    void setBreakpoints(const QSet<QUuid>& steps);
    /// Removes the breakpoints of steps that were disabled or moved into a section without pauses.
    void dropImpossibleBreakpoints(const project::Program& program);
    void moveUp();
    void moveDown();
    void nest();
    void unnest();
    void preview();
    void showPreview(const program::Preview& preview);
    void clearPreview();
    void checkRecovery();
    void showRecovery(const program::RecoveryMap& map);
    void clearRecovery();
    /// Offers the step at which the stopped program can continue.
    /// Returns  a sentence describing the recoverability of the stop; empty if the check has not been run
    QString offerContinuation();
    /// The reason why the stopped program must not continue, as a sentence; empty if it may continue.
    QString continuationObstacle() const;
    static QString changedText();
    void exportScript();
    void importProgram();
    /// Imports a program file in the background and shows the report.
    void importFile(const QString& path);
    void startImport(const program::ImportSource& source);
    void showImported(const program::ImportedProgram& imported);
    void showImportError(const Error& error);
    void showRun();
    void showEnd(const program::ProgramRunner& runner);
    void showRunningStep(const program::ProgramRunner& runner);
    QString stepLabel(int step) const;

    /// A step selected by showNextProblem().
    struct Mark {
        QUuid program;
        QUuid step;
        QString field;
    };

    ProjectDocument& document_;
    ProgramModel* model_;
    QComboBox* programs_;
    StepPalette* palette_;
    StepTree* tree_;
    StepForm* form_;
    QWidget* formArea_ = nullptr;
    RobotSession* session_ = nullptr;
    QBoxLayout* side_ = nullptr;  ///< layout of the right column
    RunBar* runBar_ = nullptr;    ///< null without a robot
    SegmentedControl* sides_;
    ElidedLabel* status_;
    QPushButton* showKey_;
    QPushButton* previewKey_;
    QList<QAction*> actions_;
    QList<QAction*> selectionActions_;  ///< actions that require selected steps
    QUuid program_;
    program::ProgramScript script_;
    QSet<QUuid> editedSteps_;               ///< highlighted steps
    bool hasEdit_ = false;                  ///< the project has changed since the last check
    project::ProgramList checkedPrograms_;  ///< programs of the project at the last check
    QUuid checkedProgram_;                  ///< program_ at the last check
    program::ProgramScript previewed_;      ///< script of the displayed or running preview
    project::Project previewedProject_;
    std::vector<Eigen::Vector3d> path_;
    std::vector<Mark> marks_;  ///< steps with problems, or with findings of the preview
    std::size_t nextMark_ = 0;
    QTimer checkTimer_;
    bool wasWaiting_ = false;  ///< true if the program waited before a step
    bool wasPausedOnRobot_ = false;
    bool mayEndOffer_ = false;  ///< an edit was made while the stopped program could continue
    QSet<QUuid> breakpoints_;   ///< step IDs, not saved with the project
    program::PreviewRunner runner_;
    QAction* recoverAction_ = nullptr;
    program::ProgramScript recovered_;  ///< script of the displayed or running recoverability check
    project::Project recoveredProject_;
    std::optional<program::RecoveryMap> recovery_;
    program::RecoveryRunner recoveryRunner_;
    program::BackgroundTask importTask_;
};

}  // namespace tiller
