// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/list_typing.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <algorithm>

namespace tiller {

namespace {

/// A letter that is typed within this time after the previous letter continues the search. Longer than Qt's
/// default, for slow typists.
constexpr qint64 kMinPauseMs = 1000;

bool isLetter(const QKeyEvent& key) {
    const QString text = key.text();
    return (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0 &&
           !text.isEmpty() && text.front().isPrint() && !text.front().isSpace();
}

}  // namespace

ListTyping::ListTyping(QAbstractItemView& list) : QObject(&list) {
    list.installEventFilter(this);
    list.viewport()->installEventFilter(this);
}

bool ListTyping::isAt(const QWidget* widget) {
    const auto* typing = widget == nullptr
                             ? nullptr
                             : widget->findChild<const ListTyping*>(QString(), Qt::FindDirectChildrenOnly);
    return typing != nullptr && typing->isGoingOn();
}

bool ListTyping::isGoingOn() const {
    return lastLetter_.isValid() &&
           lastLetter_.elapsed() < std::max<qint64>(kMinPauseMs, QApplication::keyboardInputInterval());
}

bool ListTyping::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride:
            if (isLetter(*static_cast<QKeyEvent*>(event)) && isGoingOn()) {
                event->accept();
                return true;
            }
            break;
        case QEvent::KeyPress:
            if (isLetter(*static_cast<QKeyEvent*>(event))) {
                lastLetter_.start();
            }
            break;
        case QEvent::FocusOut:
        case QEvent::MouseButtonPress:
            lastLetter_.invalidate();
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace tiller

#include "moc_list_typing.cpp"
