// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QEvent>

namespace tiller {

/// Ignores the second click of a double click, for buttons whose second click would do something that the person has not
/// read yet.
class SingleClick : public QObject {
public:
    explicit SingleClick(QAbstractButton& button) : QObject(&button) { button.installEventFilter(this); }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        return event->type() == QEvent::MouseButtonDblClick;
    }
};

}  // namespace tiller
