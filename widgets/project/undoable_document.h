// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project of a window. Every edit is one step of an undo stack.

#include <QUndoStack>

#include "robot/station/document/project_document.h"

namespace tiller {

/// Threads  GUI
class UndoableDocument : public ProjectDocument {
    Q_OBJECT

public:
    using ProjectDocument::ProjectDocument;

    QUndoStack& undoStack() { return undo_; }
    /// Like undo() and redo() of the stack, but the change is also reported by stepTaken().
    void undo() { step(true); }
    void redo() { step(false); }

    void beginGroup(const QString& text) override { undo_.beginMacro(text); }
    void endGroup() override { undo_.endMacro(); }

protected:
    void push(std::unique_ptr<ProjectEdit> edit) override;
    void clearHistory() override { undo_.clear(); }
    int historyIndex() const override { return undo_.index(); }

private:
    void step(bool undone);

    QUndoStack undo_;
};

}  // namespace tiller
