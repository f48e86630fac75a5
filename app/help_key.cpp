// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_key.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>

namespace tiller::app {

HelpKey::HelpKey(QAction& command, QWidget& owner) : QObject(&owner), command_(command), owner_(owner) {
    qApp->installEventFilter(this);
}

bool HelpKey::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) {
        return false;
    }
    auto* focus = static_cast<QWidget*>(watched);
    const auto& press = *static_cast<QKeyEvent*>(event);
    // Search the parents of the focus widget, because the event does not identify the dialog.
    bool ours = false;
    for (const QWidget* at = focus; at != nullptr && !ours; at = at->parentWidget()) {
        ours = at == &owner_;
    }
    if (!ours || qobject_cast<QDialog*>(focus->window()) == nullptr || press.isAutoRepeat() ||
        !command_.shortcuts().contains(QKeySequence(press.keyCombination()))) {
        return false;
    }
    // Ask the focus widget first, as for every shortcut, because the shortcut editor needs all keys.
    QKeyEvent question(QEvent::ShortcutOverride, press.key(), press.modifiers(), press.text());
    question.ignore();
    QApplication::sendEvent(focus, &question);
    if (question.isAccepted()) {
        return false;
    }
    command_.trigger();
    return true;
}

}  // namespace tiller::app
