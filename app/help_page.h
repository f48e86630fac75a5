// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The help page with the manual, the rules of jogging, and all commands with their shortcuts.

#include <QDialog>

class QTextBrowser;

namespace tiller::app {

class HelpPage : public QDialog {
    Q_OBJECT

public:
    /// longestHold  maximum duration of a jog without a new press [s]
    /// commands     list of commands as HTML
    /// manual       folder of the manual; if empty, the manual is not installed and the page explains how to
    /// get it
    HelpPage(int longestHold, const QString& commands, const QString& manual, QWidget* parent = nullptr);

    /// page  relative to the folder of the manual, e.g. "window/io.html#gripper"
    void showManual(const QString& page);

Q_SIGNALS:
    /// The user wants to start the practice tasks. The help page closes.
    void practiceRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildManual();
    QWidget* buildRules(int longestHold, const QString& commands);
    void applyColours();

    QString folder_;
    QTextBrowser* manual_;
};

}  // namespace tiller::app
