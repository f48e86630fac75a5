// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Help: the manual, at the page that was asked for, and beside it the rules of jogging and every command with its key.

#include <QDialog>

class QTextBrowser;

namespace tiller::app {

class HelpPage : public QDialog {
    Q_OBJECT

public:
    /// longestHold  after this time a held jog needs a new press [s]; commands  as HTML
    /// manual       folder of the manual's pages; empty: there are none, and the page says how to get them
    HelpPage(int longestHold, const QString& commands, const QString& manual, QWidget* parent = nullptr);

    /// page  "window/io.html#gripper", in the folder of the manual
    void showManual(const QString& page);

Q_SIGNALS:
    /// The practice tasks are wanted; the page closes.
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
