// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The key of a command of the window, where one of the window's dialogs has the focus: there Qt gives no shortcut to the
// window. For help, which is wanted in a dialog more than anywhere.

#include <QObject>

class QAction;
class QWidget;

namespace tiller::app {

class HelpKey : public QObject {
public:
    /// command  of the window `owner`, which is also its parent
    HelpKey(QAction& command, QWidget& owner);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction& command_;
    QWidget& owner_;
};

}  // namespace tiller::app
