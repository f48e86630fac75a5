// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/program_tab.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "robot/core/atomic_file.h"
#include "robot/station/document/project_document.h"
#include "robot/station/program/recover/steps_not_reached.h"
#include "robot/station/program/step_uses.h"
#include "robot/station/text/texts.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/enter_key.h"
#include "widgets/common/no_focus_scroll_area.h"
#include "widgets/common/segmented_control.h"
#include "widgets/program/import_report.h"
#include "widgets/program/program_model.h"
#include "widgets/program/run_bar.h"
#include "widgets/program/step_form.h"
#include "widgets/program/step_palette.h"
#include "widgets/program/step_tree.h"
#include "widgets/program/variable_list.h"

namespace tiller {

using program::Steps;

namespace {

constexpr int kWide = 820;  ///< minimum width for palette, tree and fields next to each other [px]
constexpr double kPathSpacing = 0.003;  ///< distance between path points in the 3D view [m]

/// Returns the path of the dragged program file; empty unless exactly one program file is dragged.
QString draggedProgram(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    const QString path = urls.size() == 1 ? urls.front().toLocalFile() : QString();
    const QString suffix = QFileInfo(path).suffix().toLower();
    return QStringList{"script", "urp", "urpx"}.contains(suffix) ? path : QString();
}

QPushButton* keyFor(const char* name, const QString& text) {
    auto* key = new EnterKey(text);
    key->setObjectName(QLatin1String(name));
    key->setAutoDefault(false);
    return key;
}

}  // namespace

ProgramTab::ProgramTab(ProjectDocument& document, QWidget* parent)
    : QWidget(parent)
    , document_(document)
    , model_(new ProgramModel(this))
    , programs_(new ChoiceBox)
    , palette_(new StepPalette)
    , tree_(new StepTree(*model_))
    , form_(new StepForm)
    , sides_(new SegmentedControl({tr("Add"), tr("Edit")}))
    , status_(new ElidedLabel)
    , showKey_(keyFor("program.showProblem", tr("Show step")))
    , previewKey_(keyFor("program.preview", tr("Preview"))) {
    setObjectName("program.tab");
    setAcceptDrops(true);
    buildLayout();
    addCommands();
    connect(previewKey_, &QPushButton::clicked, this, &ProgramTab::preview);
    connect(showKey_, &QPushButton::clicked, this, &ProgramTab::showNextProblem);
    connect(sides_, &SegmentedControl::currentChanged, this, &ProgramTab::showSides);
    connect(programs_, &QComboBox::activated, this, [this] {
        program_ = programs_->currentData().toUuid();
        follow();
    });
    connect(palette_, &StepPalette::stepChosen, this,
            [this](const project::ProgramStep& step) { insert({step}); });
    connect(model_, &ProgramModel::stepsDropped, this,
            [this](const program::StepPosition& at, const Steps& steps) { insert(steps, at); });
    connect(model_, &ProgramModel::stepsMoved, this,
            [this](const program::StepPosition& at, const QSet<QUuid>& ids) {
                if (const project::Program* program = current()) {
                    edit(program::withMovedSteps(*program, ids, at), tr("Move steps"));
                }
            });
    connect(tree_, &StepTree::selectionMoved, this, &ProgramTab::showSelection);
    connect(tree_, &StepTree::activated, this, [this] {
        sides_->setCurrentIndex(Form);
        form_->focusField({});
    });
    connect(form_, &StepForm::edited, this,
            [this](const QUuid& step, const QString& key, const QString& label, const QJsonValue& value) {
                if (const project::Program* program = current()) {
                    edit(program::withField(*program, step, key, value), tr("Change “%1”").arg(label));
                }
            });
    // Combine the changes that arrive in rapid succession when a project is opened.
    checkTimer_.setSingleShot(true);
    connect(&checkTimer_, &QTimer::timeout, this, &ProgramTab::check);
    for (const auto change : {&ProjectDocument::documentChanged, &ProjectDocument::projectReplaced}) {
        connect(&document_, change, this, &ProgramTab::follow);
    }
    follow();
}

void ProgramTab::buildLayout() {
    programs_->setObjectName("program.choice");
    programs_->setAccessibleName(tr("Program"));
    programs_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    programs_->setMinimumContentsLength(10);
    status_->setObjectName("program.status");
    status_->setTextFormat(Qt::PlainText);
    status_->setMinimumHeight(showKey_->sizeHint().height());
    auto* more = keyFor("program.more", QStringLiteral("···"));
    more->setAccessibleName(tr("More"));
    auto* menu = new QMenu(more);
    menu->setObjectName("program.menu");
    more->setMenu(menu);
    sides_->setNames("program.side", tr("Add steps, or edit the selected step"));

    auto* above = new QHBoxLayout;
    above->setSpacing(8);
    above->addWidget(programs_, 1);
    above->addWidget(previewKey_);
    above->addWidget(more);
    auto* area = new NoFocusScrollArea;
    area->setObjectName("program.fields");
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setAccessibleName(tr("Step fields"));
    area->setFrameShape(QFrame::NoFrame);
    area->setMinimumWidth(170);
    area->setWidget(form_);
    area->viewport()->setAutoFillBackground(false);
    form_->setAutoFillBackground(false);
    formArea_ = area;
    palette_->setMinimumWidth(170);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(8);
    columns->addWidget(palette_, 1);
    columns->addWidget(area, 1);
    auto* side = new QWidget;
    auto* sideLayout = new QVBoxLayout(side);
    side_ = sideLayout;
    sideLayout->setContentsMargins(0, 0, 0, 0);
    sideLayout->setSpacing(6);
    sideLayout->addWidget(sides_);
    sideLayout->addLayout(columns, 2);
    auto* parts = new QSplitter;
    parts->setObjectName("program.parts");
    parts->setChildrenCollapsible(false);
    parts->addWidget(tree_);
    parts->addWidget(side);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    tree_->setMinimumWidth(180);
    auto* below = new QHBoxLayout;
    below->setSpacing(8);
    below->addWidget(status_, 1);
    below->addWidget(showKey_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 8, 12, 8);
    layout->setSpacing(6);
    layout->addLayout(above);
    layout->addWidget(parts, 1);
    layout->addLayout(below);
    showSides();
}

void ProgramTab::setRobot(RobotSession& session, HoldPolicy& policy, std::function<HeldSpeed()> heldSpeed) {
    session_ = &session;
    runBar_ = new RunBar(session, policy, document_, std::move(heldSpeed));
    auto* rows = static_cast<QVBoxLayout*>(layout());
    rows->insertWidget(rows->count() - 1, runBar_);
    connect(runBar_, &RunBar::refused, this,
            [this](const QString& reason) { showStatus(tr("⚠ %1").arg(reason)); });
    auto* variables = new VariableList(runBar_->runner());
    side_->addWidget(variables, 1);
    connect(variables, &VariableList::edited, runBar_, &RunBar::changeVariable);
    connect(variables, &VariableList::refused, runBar_, &RunBar::refused);
    connect(&runBar_->runner(), &program::ProgramRunner::variableChanged, this,
            [this](const QString& text, bool isConfirmed) {
                session_->journal().add(isConfirmed ? Severity::Info : Severity::Warning, text);
                showStatus(isConfirmed ? text : tr("⚠ %1").arg(text));
            });
    connect(runBar_, &RunBar::runChanged, this, &ProgramTab::showRun);
    connect(runBar_, &RunBar::stepBegan, this,
            [this](int step, bool isFirst) { session_->journal().addStep(stepLabel(step), isFirst); });
    connect(runBar_, &RunBar::stopChanged, this, [this] {
        if (const QString text = offerContinuation(); !text.isEmpty()) {
            showStatus(text);
        }
    });
    connect(runBar_, &RunBar::startStepChanged, this, [this] {
        check();
        if (runBar_->startStep()) {
            preview();
        }
    });
    document_.setProgramGuard([tab = QPointer(this)] {
        return tab && tab->runsFreely() ? tab->runBar_->runner().program() : QUuid();
    });
    connect(&document_, &ProjectDocument::removalRefused, this, [this] {
        const QString text = tr("The program is running, so it cannot be deleted. Stop the program first.");
        showStatus(tr("⚠ %1").arg(text));
        session_->journal().add(Severity::Warning, text);
    });
    // The script depends on the software version of the robot.
    connect(&session, &RobotSession::connected, this, &ProgramTab::check);
    check();
}

bool ProgramTab::runsFreely() const {
    return runBar_ != nullptr && runBar_->runsFreely();
}

void ProgramTab::followSpeed() {
    runBar_->showSpeed();
}

void ProgramTab::showRun() {
    const program::ProgramRunner& runner = runBar_->runner();
    model_->setRun(runner.script(), runner.log(), runner.isActive());
    Q_EMIT runningStepChanged(runner.isActive() && runner.log().step() > 0 ? stepLabel(runner.log().step())
                                                                           : QString());
    if (runner.state() != program::ProgramRunner::State::Running) {
        wasWaiting_ = false;
        wasPausedOnRobot_ = false;
    }
    switch (runner.state()) {
        case program::ProgramRunner::State::Idle:
            break;
        case program::ProgramRunner::State::Sending:
            offerContinuation();
            showStatus(tr("Starting…"));
            break;
        case program::ProgramRunner::State::Running:
            showRunningStep(runner);
            break;
        case program::ProgramRunner::State::Stopping:
            showStatus(tr("Stopping…"));
            break;
        case program::ProgramRunner::State::Ended: {
            showEnd(runner);
            using End = program::ProgramRunner::End;
            const bool isExpected = runner.end() == End::Completed || runner.end() == End::Stopped;
            session_->journal().add(isExpected ? Severity::Info : Severity::Warning,
                                    runner.endText(document_.project()), Origin::Tiller, runner.endDetails());
            Q_EMIT runEnded();
            break;
        }
    }
}

void ProgramTab::showEnd(const program::ProgramRunner& runner) {
    QStringList texts{runner.endText(document_.project()), offerContinuation()};
    texts << runBar_->keepPlace();
    texts.removeAll(QString());
    showStatus(texts.join(QStringLiteral(" · ")));
}

QString ProgramTab::stepLabel(int step) const {
    const program::ProgramRunner& runner = runBar_->runner();
    return tr("Step %1 (%2)")
        .arg(program::rowNumber(document_.project(), runner.script(), step))
        .arg(program::stepName(runner.project(), runner.script(), step));
}

void ProgramTab::showRunningStep(const program::ProgramRunner& runner) {
    const int number = runner.log().step();
    const int step = program::rowNumber(document_.project(), runner.script(), number);
    const QString name = program::stepName(runner.project(), runner.script(), number);
    const bool isWaiting = runner.isWaiting();
    const bool isPausedOnRobot = runner.isPausedOnRobot();
    showStatus(isPausedOnRobot          ? tr("Paused on the robot in step %1 (%2)").arg(step).arg(name)
               : runner.waitsForPress() ? tr("Paused before step %1 (%2) because of the maximum hold time. "
                                             "Hold “Continue (hold)” to continue.")
                                              .arg(step)
                                              .arg(name)
               : isWaiting         ? tr("Paused before step %1 (%2)").arg(step).arg(name)
               : step == 0         ? tr("Running")
               : runner.isPaused() ? tr("Pausing after step %1 (%2)").arg(step).arg(name)
               : runBar_->isSlowed()
                   ? tr("Running step %1 (%2). Joint moves are slow because the preview did not "
                        "run the whole program from this position.")
                         .arg(step)
                         .arg(name)
                   : tr("Running step %1 (%2)").arg(step).arg(name));
    const bool isOther = std::exchange(wasWaiting_, isWaiting) != isWaiting;
    if (std::exchange(wasPausedOnRobot_, isPausedOnRobot) != isPausedOnRobot || isOther) {
        session_->journal().add(isPausedOnRobot ? Severity::Warning : Severity::Info, status_->fullText());
    }
}

void ProgramTab::addCommands() {
    auto* menu = findChild<QMenu*>("program.menu");
    menu->addActions(
        {addCommand("new", tr("New program"), {}, &ProgramTab::addProgram),
         addCommand("rename", tr("Rename program…"), {}, &ProgramTab::renameProgram),
         addCommand("remove", tr("Delete program"), {}, &ProgramTab::removeProgram),
         addCommand("import", tr("Import program…"), {}, &ProgramTab::importProgram),
         addCommand("export", tr("Export script…"), {}, &ProgramTab::exportScript),
         recoverAction_ = addCommand("recover", tr("Check recoverability"), {}, &ProgramTab::checkRecovery)});
    tree_->addAction(addCommand("paste", tr("Paste steps"), QKeySequence::Paste, &ProgramTab::paste));
    selectionActions_ = {
        addCommand("cut", tr("Cut steps"), QKeySequence::Cut, &ProgramTab::cut),
        addCommand("copy", tr("Copy steps"), QKeySequence::Copy, &ProgramTab::copy),
        addCommand("duplicate", tr("Duplicate steps"), QKeySequence(Qt::CTRL | Qt::Key_D),
                   &ProgramTab::duplicate),
        addCommand("delete", tr("Delete steps"), QKeySequence::Delete, &ProgramTab::remove),
        addCommand("disable", tr("Disable or enable steps"), QKeySequence(Qt::CTRL | Qt::Key_Slash),
                   &ProgramTab::toggleDisabled),
        addCommand("breakpoint", tr("Add or remove breakpoints"), QKeySequence(Qt::CTRL | Qt::Key_B),
                   &ProgramTab::toggleBreakpoints),
        addCommand("up", tr("Move steps up"), QKeySequence(Qt::CTRL | Qt::Key_Up), &ProgramTab::moveUp),
        addCommand("down", tr("Move steps down"), QKeySequence(Qt::CTRL | Qt::Key_Down),
                   &ProgramTab::moveDown),
        addCommand("nest", tr("Move steps into the section above"), QKeySequence(Qt::CTRL | Qt::Key_Right),
                   &ProgramTab::nest),
        addCommand("unnest", tr("Move steps out of the section"), QKeySequence(Qt::CTRL | Qt::Key_Left),
                   &ProgramTab::unnest)};
    tree_->addActions(selectionActions_);
    tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

QAction* ProgramTab::addCommand(const char* name, const QString& text, const QKeySequence& keys,
                                void (ProgramTab::*run)()) {
    auto* action = new QAction(text, this);
    action->setObjectName(QStringLiteral("program.action.%1").arg(QLatin1String(name)));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setAutoRepeat(false);
    connect(action, &QAction::triggered, this, [this, run] {
        Q_EMIT frontWanted();
        (this->*run)();
    });
    actions_.append(action);
    return action;
}

void ProgramTab::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showSides();
}

void ProgramTab::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedProgram(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void ProgramTab::dropEvent(QDropEvent* event) {
    if (const QString path = draggedProgram(*event->mimeData()); !path.isEmpty()) {
        event->acceptProposedAction();
        importFile(path);
    }
}

void ProgramTab::showSides() {
    const bool isWide = width() >= kWide;
    sides_->setVisible(!isWide);
    palette_->setVisible(isWide || sides_->currentIndex() == Palette);
    formArea_->setVisible(isWide || sides_->currentIndex() == Form);
}

void ProgramTab::showStatus(const QString& text) {
    status_->setFullText(text);
}

const project::Program* ProgramTab::current() const {
    return document_.project().programs.find(program_);
}

void ProgramTab::follow() {
    hasEdit_ = true;
    if (runBar_ != nullptr) {
        mayEndOffer_ = mayEndOffer_ || runBar_->offersContinuation();
        runBar_->clearStartStep();
    }
    const project::ProgramList& programs = document_.project().programs;
    if (current() == nullptr) {
        program_ = programs.isEmpty() ? QUuid() : programs.at(0).id;
    }
    programs_->clear();
    for (const project::Program& program : programs) {
        programs_->addItem(program.name, program.id);
        if (program.id == program_) {
            programs_->setCurrentIndex(programs_->count() - 1);
        }
    }
    programs_->setEnabled(!programs.isEmpty());
    model_->setProgram(document_.project(), current());
    showSelection();
    checkTimer_.start(0);
}

program::ScriptOptions ProgramTab::scriptOptions() const {
    if (session_ == nullptr) {
        return {};
    }
    program::ScriptOptions options = program::optionsFor(document_.project(), session_->state());
    options.from = runBar_->startStep() ? runBar_->startStep()->step : QUuid();
    return options;
}

// True if everything that affects the simulation in addition to the script is unchanged.
bool ProgramTab::isSameCell(const project::Project& before) const {
    const project::Project now = document_.project();
    return before.cell == now.cell && before.frames == now.frames && before.tooling == now.tooling &&
           before.robot == now.robot;
}

program::ProgramScript ProgramTab::completeScript() const {
    program::ScriptOptions options = scriptOptions();
    options.from = {};
    return program::writeScript(document_.project(), program_, options);
}

// Does not highlight steps after an edit of the programs, because such an edit changes the step numbers and
// is visible in the tree.
void ProgramTab::highlightLastEdit(const program::ProgramScript& before) {
    if (!std::exchange(hasEdit_, false)) {
        return;
    }
    const project::Project& now = document_.project();
    const bool isOther = checkedPrograms_ != now.programs || checkedProgram_ != program_;
    checkedPrograms_ = now.programs;
    checkedProgram_ = program_;
    editedSteps_ = isOther ? QSet<QUuid>() : program::changedSteps(before, script_);
    model_->setChanged(editedSteps_);
}

void ProgramTab::check() {
    const project::Program* program = current();
    const program::ProgramScript before = std::exchange(script_, {});
    script_ = program != nullptr ? program::writeScript(document_.project(), program_, scriptOptions())
                                 : program::ProgramScript();
    if (runBar_ != nullptr) {
        runBar_->setProgram(program_, script_);
    }
    model_->setProblems(script_.problems);
    highlightLastEdit(before);
    if (program != nullptr) {
        dropImpossibleBreakpoints(*program);
    }
    const bool isStale = !script_.ok() || previewed_.text != script_.text || !isSameCell(previewedProject_);
    if (isStale) {
        clearPreview();
        marks_.clear();
        nextMark_ = 0;
        for (const program::ProgramProblem& problem : script_.problems) {
            if (!problem.step.isNull()) {
                marks_.push_back({problem.program, problem.step, problem.field});
            }
        }
    }
    if (!recovered_.text.isEmpty() &&
        (!isSameCell(recoveredProject_) || completeScript().text != recovered_.text)) {
        clearRecovery();
    }
    previewKey_->setEnabled(script_.ok());
    recoverAction_->setEnabled(script_.ok());
    const bool endsOffer = std::exchange(mayEndOffer_, false) && !runBar_->offersContinuation();
    if (runBar_ != nullptr && runBar_->runner().isActive()) {
        // Keep showing the state of the run, with the new step numbers. Changes take effect at the next
        // start.
        if (runBar_->runner().state() == program::ProgramRunner::State::Running) {
            showRunningStep(runBar_->runner());
        }
    } else if (program == nullptr || program->steps.empty()) {
        showStatus(tr("Drag steps into the program, or double-click them."));
    } else if (!script_.problems.empty()) {
        const program::ProgramProblem& first = script_.problems.front();
        showStatus(first.number > 0 ? tr("⚠ Step %1: %2").arg(first.number).arg(first.text)
                                    : tr("⚠ %1").arg(first.text));
    } else if (isStale) {
        showStatus(endsOffer                 ? changedText()
                   : !editedSteps_.isEmpty() ? tr("%n step(s) changed because the project changed. Press "
                                                  "“Preview” to simulate the program.",
                                                  nullptr, static_cast<int>(editedSteps_.size()))
                                             : tr("The program can run. Press “Preview” to simulate it."));
    }
    showKey_->setVisible(!marks_.empty());
    showSelection();
}

void ProgramTab::showNextProblem() {
    if (marks_.empty()) {
        return;
    }
    const Mark mark = marks_[nextMark_ % marks_.size()];
    nextMark_ = (nextMark_ + 1) % marks_.size();
    if (mark.program != program_ && document_.project().programs.find(mark.program) != nullptr) {
        program_ = mark.program;
        follow();
    }
    tree_->selectIds({mark.step});
    sides_->setCurrentIndex(Form);
    if (mark.field.isEmpty()) {
        tree_->setFocus();
    } else {
        form_->focusField(mark.field);
    }
}

void ProgramTab::showSelection() {
    const project::Program* program = current();
    const QSet<QUuid> selected = tree_->selectedIds();
    const project::ProgramStep* step = program != nullptr && selected.size() == 1
                                           ? program::findStep(program->steps, *selected.begin())
                                           : nullptr;
    form_->setStep(document_.project(), step);
    if (runBar_ != nullptr) {
        runBar_->setSelectedStep(step != nullptr ? step->id : QUuid());
    }
    form_->setProblem(step != nullptr ? model_->noteAt(step->id) : QString());
    for (QAction* action : std::as_const(selectionActions_)) {
        action->setEnabled(!selected.isEmpty());
    }
}

// ---- edits ----------------------------------------------------------------------------------------------

void ProgramTab::edit(const project::Program& after, const QString& text) {
    project::ProgramList programs = document_.project().programs;
    programs.replace(static_cast<std::size_t>(programs.indexOf(after.id)), after);
    document_.changePrograms(programs, text);
}

void ProgramTab::insert(const Steps& steps, const std::optional<program::StepPosition>& at) {
    document_.beginGroup(tr("Add steps"));
    if (current() == nullptr) {
        addProgram();
    }
    const project::Program* program = current();
    const QUuid selected = tree_->selectedIds().contains(tree_->currentId()) ? tree_->currentId() : QUuid();
    edit(program::withSteps(*program, at.value_or(program::positionBehind(*program, selected)), steps),
         tr("Add steps"));
    document_.endGroup();
    QList<QUuid> ids;
    for (const project::ProgramStep& step : steps) {
        ids.append(step.id);
    }
    tree_->selectIds(ids);
}

void ProgramTab::changeSelected(project::Program (*change)(const project::Program&, const QSet<QUuid>&),
                                const QString& text) {
    if (const project::Program* program = current()) {
        edit(change(*program, tree_->selectedIds()), text);
    }
}

void ProgramTab::moveUp() {
    changeSelected(
        [](const auto& program, const auto& ids) { return program::withShifted(program, ids, -1); },
        tr("Move steps"));
}
void ProgramTab::moveDown() {
    changeSelected([](const auto& program, const auto& ids) { return program::withShifted(program, ids, 1); },
                   tr("Move steps"));
}
void ProgramTab::nest() {
    changeSelected(program::withNested, tr("Move steps"));
}
void ProgramTab::unnest() {
    changeSelected(program::withUnnested, tr("Move steps"));
}
void ProgramTab::duplicate() {
    changeSelected(program::withDuplicates, tr("Duplicate steps"));
}
void ProgramTab::remove() {
    changeSelected([](const auto& program, const auto& ids) { return program::withoutSteps(program, ids); },
                   tr("Delete steps"));
}

void ProgramTab::addProgram() {
    project::ProgramList programs = document_.project().programs;
    project::Program program;
    program.id = QUuid::createUuid();
    program.name = programs.nextName(tr("Program"));
    programs.append(program);
    program_ = program.id;
    document_.changePrograms(programs, tr("Add “%1”").arg(program.name));
}

void ProgramTab::renameProgram() {
    const project::Program* program = current();
    if (program == nullptr) {
        return;
    }
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Rename program"), tr("Name"), QLineEdit::Normal,
                                               program->name, &accepted)
                             .trimmed();
    program = current();
    if (!accepted || name.isEmpty() || program == nullptr || name == program->name) {
        return;
    }
    project::Program after = *program;
    after.name = document_.project().programs.uniqueName(name);
    edit(after, tr("Rename “%1” to “%2”").arg(program->name, after.name));
}

void ProgramTab::removeProgram() {
    project::ProgramList programs = document_.project().programs;
    const int index = programs.indexOf(program_);
    if (index >= 0) {
        const QString name = programs.at(static_cast<std::size_t>(index)).name;
        programs.remove(static_cast<std::size_t>(index));
        document_.changePrograms(programs, tr("Delete “%1”").arg(name));
        if (session_ != nullptr && document_.project().programs.size() == programs.size()) {
            session_->journal().add(Severity::Info,
                                    tr("Program “%1” deleted. Ctrl+Z restores it.").arg(name));
        }
    }
}

void ProgramTab::copy() {
    const project::Program* program = current();
    if (program != nullptr && !tree_->selectedIds().isEmpty()) {
        QApplication::clipboard()->setText(
            QString::fromUtf8(program::textOf(program::selectedSteps(*program, tree_->selectedIds()))));
    }
}

void ProgramTab::cut() {
    copy();
    remove();
}

void ProgramTab::paste() {
    if (const auto steps = program::stepsFromText(QApplication::clipboard()->text().toUtf8())) {
        insert(*steps);
    }
}

void ProgramTab::toggleDisabled() {
    const project::Program* program = current();
    const QSet<QUuid> ids = tree_->selectedIds();
    if (program == nullptr || ids.isEmpty()) {
        return;
    }
    const Steps selected = program::selectedSteps(*program, ids);
    const bool disable = std::any_of(selected.begin(), selected.end(),
                                     [](const project::ProgramStep& step) { return !step.disabled; });
    edit(program::withDisabled(*program, ids, disable), disable ? tr("Disable steps") : tr("Enable steps"));
}

void ProgramTab::toggleBreakpoints() {
    const program::ProgramScript script = completeScript();
    const QSet<QUuid> ids = tree_->selectedIds();
    const bool add = std::any_of(ids.begin(), ids.end(), [&](const QUuid& id) {
        return !breakpoints_.contains(id) && script.canPauseBefore(id);
    });
    if (!add && !breakpoints_.intersects(ids)) {
        showStatus(script.ok() ? tr("⚠ The program cannot pause before this step.")
                               : tr("⚠ Correct the problems in the program first."));
        return;
    }
    QSet<QUuid> changed = breakpoints_;
    for (const QUuid& id : ids) {
        if (!add) {
            changed.remove(id);
        } else if (script.canPauseBefore(id)) {
            changed.insert(id);
        }
    }
    setBreakpoints(changed);
    if (add && runBar_ != nullptr && runBar_->runner().isActive()) {
        showStatus(tr("New breakpoints take effect at the next start."));
    }
}

void ProgramTab::setBreakpoints(const QSet<QUuid>& steps) {
    breakpoints_ = steps;
    model_->setBreakpoints(steps);
    if (runBar_ != nullptr) {
        runBar_->setBreakpoints(steps);
    }
}

void ProgramTab::dropImpossibleBreakpoints(const project::Program& program) {
    if (breakpoints_.isEmpty() || !script_.ok()) {
        return;
    }
    const program::ProgramScript script = completeScript();
    QSet<QUuid> possible = breakpoints_;
    possible.removeIf([&](const QUuid& id) {
        return program::findStep(program.steps, id) != nullptr && !script.canPauseBefore(id);
    });
    if (possible != breakpoints_) {
        setBreakpoints(possible);
    }
}

// ---- preview and export ---------------------------------------------------------------------------------

void ProgramTab::preview() {
    check();
    if (!script_.ok()) {
        return;
    }
    clearPreview();
    previewed_ = script_;
    previewedProject_ = document_.project();
    showStatus(tr("Simulating…"));
    program::PreviewOptions options;
    if (runBar_ != nullptr && runBar_->startStep()) {
        options.start = runBar_->startStep()->q;
    }
    if (runBar_ != nullptr) {
        options.inputs = runBar_->inputs();
    }
    runner_.start(document_.project(), script_, scriptOptions(), options,
                  [this, text = script_.text](const program::Preview& done) {
                      QMetaObject::invokeMethod(this, [this, done, text] {
                          if (previewed_.text == text) {
                              showPreview(done);
                          }
                      });
                  });
}

void ProgramTab::showPreview(const program::Preview& preview) {
    model_->setPreview(&previewed_, &preview);
    path_ = program::tcpPath(preview, kPathSpacing);
    if (runBar_ != nullptr) {
        runBar_->setPreview(previewed_, preview);
    }
    marks_.clear();
    nextMark_ = 0;
    for (const program::Finding& finding : preview.findings) {
        if (finding.step >= 1 && finding.step <= static_cast<int>(previewed_.steps.size())) {
            const program::NumberedStep& at = previewed_.steps[static_cast<std::size_t>(finding.step - 1)];
            marks_.push_back({at.program, at.step, {}});
        }
    }
    showKey_->setVisible(!marks_.empty());
    const QString duration = QLocale().toString(preview.duration, 'f', 1);
    const std::vector<int> notRun = program::stepsNotRun(document_.project(), previewed_, preview);
    if (!preview.isGood()) {
        showStatus(
            tr("⚠ Simulated: %n problem(s) found. %1", nullptr, static_cast<int>(preview.findings.size()))
                .arg(program::findingText(document_.project(), previewed_, preview.findings.front())));
    } else {
        const QString good =
            preview.isEndless
                ? tr("Simulated: two cycles of the endless program take %1 s. No problems found.")
                      .arg(duration)
                : tr("Simulated: the program takes %1 s. No problems found.").arg(duration);
        showStatus(notRun.empty()
                       ? good
                       : good + QLatin1Char(' ') + tr("Not run: %1.").arg(program::stepNumbersText(notRun)));
    }
    showSelection();
    Q_EMIT previewPathChanged();
}

void ProgramTab::clearPreview() {
    runner_.cancel();
    previewed_ = {};
    model_->setPreview(nullptr, nullptr);
    if (runBar_ != nullptr) {
        runBar_->setPreview({}, std::nullopt);
    }
    if (!path_.empty()) {
        path_.clear();
        Q_EMIT previewPathChanged();
    }
}

void ProgramTab::checkRecovery() {
    if (recoveryRunner_.isRunning()) {
        clearRecovery();
        showStatus(tr("The check was cancelled."));
        return;
    }
    check();
    const program::ProgramScript script = completeScript();
    if (!script.ok()) {
        return;
    }
    clearRecovery();
    recovered_ = script;
    recoveredProject_ = document_.project();
    recoverAction_->setText(tr("Cancel check"));
    showStatus(tr("Checking recoverability…"));
    program::ScriptOptions options = scriptOptions();
    options.from = {};
    const std::vector<program::InputChange> inputs =
        runBar_ != nullptr ? runBar_->inputs() : std::vector<program::InputChange>();
    recoveryRunner_.start(document_.project(), program_, script, options, inputs,
                          [this, text = script.text](const program::RecoveryMap& map) {
                              QMetaObject::invokeMethod(this, [this, map, text] {
                                  if (recovered_.text == text) {
                                      showRecovery(map);
                                  }
                              });
                          });
}

void ProgramTab::showRecovery(const program::RecoveryMap& map) {
    recovery_ = map;
    recoverAction_->setText(tr("Check recoverability"));
    model_->setRecovery(&recovered_, &map);
    const program::RecoveryCount count = program::countRecoverable(map);
    QString text = tr("In simulation, the program can continue after a stop in %1 of %2 steps.")
                       .arg(count.recoverable)
                       .arg(count.steps);
    if (const auto missing = program::stepsNotChecked(document_.project(), recovered_, map);
        !missing.empty()) {
        text += QLatin1Char(' ') + tr("Not checked: %1.").arg(program::stepNumbersText(missing));
    }
    const QString offer = offerContinuation();
    showStatus(offer.isEmpty() ? text : offer);
}

void ProgramTab::clearRecovery() {
    recoveryRunner_.cancel();
    recovered_ = {};
    recovery_.reset();
    recoverAction_->setText(tr("Check recoverability"));
    model_->setRecovery(nullptr, nullptr);
    if (runBar_ != nullptr) {
        runBar_->setContinuation({});
    }
}

QString ProgramTab::offerContinuation() {
    if (runBar_ == nullptr) {
        return {};
    }
    const RunBar::StoppedAt stop = runBar_->stoppedAt();
    program::Continuation continuation;
    // The step number refers to the program that was started, which may have called the displayed program.
    if (recovery_ && stop.step > 0 && runBar_->runner().program() == program_) {
        continuation.text = continuationObstacle();
        if (continuation.text.isEmpty()) {
            continuation = program::chooseContinuation(document_.project(), recovered_, *recovery_,
                                                       runBar_->runner().script(), stop.step, stop.kind);
        }
    }
    runBar_->setContinuation(continuation);
    if (continuation.start) {
        tree_->selectIds({continuation.start->step});
    }
    return continuation.text;
}

QString ProgramTab::continuationObstacle() const {
    program::ScriptOptions options = scriptOptions();
    options.from = {};
    if (program::writeScript(runBar_->runner().project(), program_, options).text != recovered_.text) {
        return changedText();
    }
    return runBar_->hasOtherOutputs() ? tr("Outputs were changed after the stop, so the program cannot "
                                           "continue. Run the program from the beginning.")
                                      : QString();
}

QString ProgramTab::changedText() {
    return tr(
        "The program was changed after the stop, so it cannot continue. Run the program from the beginning.");
}

void ProgramTab::exportScript() {
    check();
    if (!script_.ok()) {
        return;
    }
    const program::ProgramScript script = script_;
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export script"), script.name + QStringLiteral(".script"), tr("URScript (*.script)"));
    if (path.isEmpty()) {
        return;
    }
    const auto written = writeFileAtomically(path, script.text.toUtf8());
    showStatus(written ? tr("Exported to %1").arg(path) : tr("⚠ %1").arg(written.error().toString()));
}

// ---- import ---------------------------------------------------------------------------------------------

void ProgramTab::importProgram() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Import program"), {}, tr("Robot programs (*.script *.urp *.urpx);;All files (*)"));
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void ProgramTab::importFile(const QString& path) {
    if (const auto source = program::readImportSource(path)) {
        startImport(*source);
    } else {
        showImportError(source.error());
    }
}

void ProgramTab::startImport(const program::ImportSource& source) {
    showStatus(tr("Importing %1…").arg(source.file));
    importTask_.start([this, before = document_.project(), source](const std::atomic<bool>& cancelled) {
        program::ImportSource named = source;
        named.programName = before.programs.uniqueName(QFileInfo(source.file).completeBaseName());
        const auto imported = program::importProgram(before, named);
        if (cancelled) {
            return;
        }
        QMetaObject::invokeMethod(this, [this, before, source, imported] {
            if (!imported) {
                showImportError(imported.error());
            } else if (document_.project() == before) {
                showImported(*imported);
            } else {
                startImport(source);  // the project has changed in the meantime
            }
        });
    });
}

void ProgramTab::showImported(const program::ImportedProgram& imported) {
    const project::Project& before = document_.project();
    const QString name = imported.project.programs.find(imported.program)->name;
    const QString text = tr("Import “%1”").arg(name);
    const auto added = imported.project.waypoints.begin() + before.waypoints.size();
    const std::vector<project::Waypoint> waypoints(added, imported.project.waypoints.end());
    document_.beginGroup(text);
    document_.insertWaypoints(before.waypoints.size(), waypoints, text);
    document_.changeTooling(imported.project.tooling, text);
    program_ = imported.program;
    document_.changePrograms(imported.project.programs, text);
    document_.endGroup();
    showStatus(tr("Imported “%1”.").arg(name));
    auto* report = new ImportReport(imported, this);
    report->setAttribute(Qt::WA_DeleteOnClose);
    connect(report, &ImportReport::stepChosen, this, [this](const QUuid& step) {
        for (const project::Program& program : document_.project().programs) {
            if (program::findStep(program.steps, step) != nullptr && program.id != program_) {
                program_ = program.id;
                follow();
            }
        }
        tree_->selectIds({step});
    });
    report->open();
}

void ProgramTab::showImportError(const Error& error) {
    showStatus(tr("⚠ The import failed. The project is unchanged."));
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Import program"), texts::errorText(error),
                                QMessageBox::Ok, this);
    box->setObjectName("program.importError");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace tiller

#include "moc_program_tab.cpp"
