// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rules of jogging, and every command with its key.

#include <QDialog>

namespace tiller::app {

class HelpPage : public QDialog {
    Q_OBJECT

public:
    /// longestHold  after this time a held jog needs a new press [s]; commands  as HTML
    HelpPage(int longestHold, const QString& commands, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The practice tasks are wanted; the page closes.
    void practiceRequested();
};

}  // namespace tiller::app
