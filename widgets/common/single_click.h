// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QEvent>

namespace tiller {

/// Ignores the second press of a double click, for buttons that have a different effect after the first
/// click, e.g. the button for the next step, or that must not act twice.
class SingleClick : public QObject {
public:
    explicit SingleClick(QAbstractButton& button) : QObject(&button) { button.installEventFilter(this); }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        return event->type() == QEvent::MouseButtonDblClick;
    }
};

}  // namespace tiller
