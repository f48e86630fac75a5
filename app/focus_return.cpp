// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/focus_return.h"

#include <QApplication>

namespace tiller::app {

namespace {

bool canReturnTo(const QWidget* widget) {
    return widget != nullptr && widget->isVisible() && widget->isEnabled();
}

/// Returns the first element in `area` that Tab can reach, or null.
QWidget* firstIn(const QWidget& area) {
    for (QWidget* each = area.nextInFocusChain(); each != nullptr && each != &area;
         each = each->nextInFocusChain()) {
        if (area.isAncestorOf(each) && canReturnTo(each) && (each->focusPolicy() & Qt::TabFocus) != 0 &&
            each->focusProxy() == nullptr) {
            return each;
        }
    }
    return nullptr;
}

}  // namespace

FocusReturn::FocusReturn(QWidget& jogColumn) : jogColumn_(jogColumn) {
    connect(qApp, &QApplication::focusChanged, this, &FocusReturn::follow);
}

void FocusReturn::follow(QWidget* old, QWidget* now) {
    if (old == nullptr || now == nullptr || !jogColumn_.isAncestorOf(now) || jogColumn_.isAncestorOf(old)) {
        return;
    }
    // Only an element that is reached by Tab and not by a click can have received the focus from Qt. A press
    // on a hold button also moves the focus, and a further change would stop the arm.
    if ((now->focusPolicy() & Qt::StrongFocus) != Qt::TabFocus ||
        (QGuiApplication::mouseButtons() != Qt::NoButton && now->underMouse())) {
        return;
    }
    QList<QPointer<QWidget>> around{old};
    for (QWidget* up = old->parentWidget(); up != nullptr && !up->isAncestorOf(&jogColumn_);
         up = up->parentWidget()) {
        around.append(up);
    }
    // Call leaveJogColumn() later, because the element is hidden or disabled only after the focus has moved.
    QMetaObject::invokeMethod(
        this, [this, around, fell = QPointer<QWidget>(now)] { leaveJogColumn(around, fell); },
        Qt::QueuedConnection);
}

void FocusReturn::leaveJogColumn(const QList<QPointer<QWidget>>& around, const QWidget* fell) const {
    QWidget* now = QApplication::focusWidget();
    if (now == nullptr || now != fell || canReturnTo(around.first())) {
        return;  // the user moved the focus, or holds a button
    }
    for (const QPointer<QWidget>& area : around) {
        if (QWidget* next = canReturnTo(area) ? firstIn(*area) : nullptr; next != nullptr) {
            next->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
    now->clearFocus();
}

}  // namespace tiller::app
