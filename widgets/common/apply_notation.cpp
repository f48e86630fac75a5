// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/apply_notation.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace tiller {

void applyNotation(QApplication& application, const Notation& notation) {
    setNotation(application, notation);
    const QWidgetList widgets = QApplication::allWidgets();
    for (QWidget* widget : widgets) {
        QEvent change(QEvent::StyleChange);
        QApplication::sendEvent(widget, &change);
        widget->update();
    }
}

}  // namespace tiller
