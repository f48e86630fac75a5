// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// If the focused element is hidden or disabled, Qt moves the focus to the next element of the window, which
// may be a control of the jog column: Return would then arm the keyboard. This class moves the focus to an
// element near the previous element instead.

#include <QList>
#include <QObject>
#include <QPointer>
#include <QWidget>

namespace tiller::app {

class FocusReturn : public QObject {
public:
    /// jogColumn  must outlive the object
    explicit FocusReturn(QWidget& jogColumn);

private:
    void follow(QWidget* old, QWidget* now);
    /// around  the previous element and the elements around it, from the inside out
    /// fell    the element that received the focus
    void leaveJogColumn(const QList<QPointer<QWidget>>& around, const QWidget* fell) const;

    QWidget& jogColumn_;
};

}  // namespace tiller::app
