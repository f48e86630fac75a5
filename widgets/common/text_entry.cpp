// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/text_entry.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QStyle>
#include <QTextEdit>

namespace tiller {

namespace {

constexpr char kRefused[] = "refused";  // property name in the style sheet

}  // namespace

bool takesText(const QWidget* widget) {
    if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        return !line->isReadOnly();
    }
    return qobject_cast<const QTextEdit*>(widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

bool leavesUndoToProject(QEvent& event, bool canUndo, bool canRedo) {
    if (event.type() != QEvent::ShortcutOverride) {
        return false;
    }
    const auto& key = static_cast<const QKeyEvent&>(event);
    if ((key.matches(QKeySequence::Undo) && !canUndo) || (key.matches(QKeySequence::Redo) && !canRedo)) {
        event.ignore();
        return true;
    }
    return false;
}

void markRefused(QWidget& field, bool refused) {
    if (isMarkedRefused(field) != refused) {
        field.setProperty(kRefused, refused);
        field.style()->unpolish(&field);
        field.style()->polish(&field);
    }
}

bool isMarkedRefused(const QWidget& field) {
    return field.property(kRefused).toBool();
}

}  // namespace tiller
