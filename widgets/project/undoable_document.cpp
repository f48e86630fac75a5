// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/undoable_document.h"

#include <QUndoCommand>

#include "robot/station/document/project_edits.h"

namespace tiller {
namespace {

class EditCommand : public QUndoCommand {
public:
    EditCommand(ProjectDocument& document, std::unique_ptr<ProjectEdit> edit)
        : QUndoCommand(edit->text()), document_(document), edit_(std::move(edit)) {}
    void redo() override { edit_->apply(document_); }
    void undo() override { edit_->revert(document_); }

private:
    ProjectDocument& document_;
    std::unique_ptr<ProjectEdit> edit_;
};

}  // namespace

void UndoableDocument::push(std::unique_ptr<ProjectEdit> edit) {
    undo_.push(new EditCommand(*this, std::move(edit)));
}

void UndoableDocument::step(bool undone) {
    if (!(undone ? undo_.canUndo() : undo_.canRedo())) {
        return;
    }
    const QString text = undone ? undo_.undoText() : undo_.redoText();
    const project::Project before = project();
    undone ? undo_.undo() : undo_.redo();
    finishStep(before, undone, text);
}

}  // namespace tiller

#include "moc_undoable_document.cpp"
