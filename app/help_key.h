// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Makes the help shortcut of the main window available in its dialogs. While a dialog has the focus, Qt does
// not deliver the shortcuts of the main window.

#include <QObject>

class QAction;
class QWidget;

namespace tiller::app {

class HelpKey : public QObject {
public:
    /// command  help command of the window `owner`, which is also the parent
    HelpKey(QAction& command, QWidget& owner);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction& command_;
    QWidget& owner_;
};

}  // namespace tiller::app
