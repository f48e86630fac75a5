// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/undoable_document.h"

#include <QUndoCommand>
#include <functional>

#include "robot/station/document/project_edits.h"

namespace tiller {
namespace {

class EditCommand : public QUndoCommand {
public:
    EditCommand(ProjectDocument& document, std::unique_ptr<ProjectEdit> edit)
        : QUndoCommand(edit->text()), document_(document), edit_(std::move(edit)) {}
    void redo() override { edit_->apply(document_); }
    void undo() override { edit_->revert(document_); }
    const ProjectEdit& edit() const { return *edit_; }

private:
    ProjectDocument& document_;
    std::unique_ptr<ProjectEdit> edit_;
};

/// Calls `visit` for each edit of the undo step until it returns true.
bool anyEdit(const QUndoCommand& command, const std::function<bool(const ProjectEdit&)>& visit) {
    const auto* own = dynamic_cast<const EditCommand*>(&command);
    bool found = own != nullptr && visit(own->edit());
    for (int i = 0; i < command.childCount() && !found; ++i) {
        found = anyEdit(*command.child(i), visit);
    }
    return found;
}

}  // namespace

void UndoableDocument::push(std::unique_ptr<ProjectEdit> edit) {
    undo_.push(new EditCommand(*this, std::move(edit)));
}

void UndoableDocument::step(bool undone) {
    if (!(undone ? undo_.canUndo() : undo_.canRedo())) {
        return;
    }
    const QUndoCommand* command = undo_.command(undone ? undo_.index() - 1 : undo_.index());
    const bool loses = anyEdit(*command, [&](const ProjectEdit& edit) {
        const project::ProgramList* programs = edit.programs(undone);
        return programs != nullptr && losesProgram(*programs);
    });
    if (loses) {
        Q_EMIT removalRefused();
        return;
    }
    const QString text = undone ? undo_.undoText() : undo_.redoText();
    const project::Project before = project();
    undone ? undo_.undo() : undo_.redo();
    finishStep(before, undone, text);
}

}  // namespace tiller

#include "moc_undoable_document.cpp"
