// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_page.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace tiller::app {

HelpPage::HelpPage(int longestHold, const QString& commands, QWidget* parent) : QDialog(parent) {
    setObjectName("helpPage");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Help"));
    resize(760, 620);
    auto* layout = new QVBoxLayout(this);
    auto* text = new QTextBrowser(this);
    text->setObjectName("helpText");
    text->setAccessibleName(tr("Help"));
    text->setHtml(
        tr("<h2>Moving the arm</h2><p>The arm moves while a key of the pad is held, and stops when it is let "
           "go. It also stops when</p><ul>"
           "<li>the pointer leaves the key, a second button is pressed, or another hand joins in;</li>"
           "<li>a modifier, or a key that contradicts, goes down beside a held key of the keyboard;</li>"
           "<li>the window loses the focus, anything opens over it, or another frame, speed, step or tab is "
           "chosen;</li>"
           "<li>data from the robot are late, this program hangs, the robot leaves Running, or its safety "
           "mode "
           "or Remote control;</li>"
           "<li>the screen is locked, the PC goes to sleep, or the device is unplugged or falls silent;</li>"
           "<li>nobody can prove that the key is still held: on X11 the display server is asked a hundred "
           "times a second whether the button or key is down, and a “no”, or no answer for 100 ms, ends the "
           "motion. Where nobody can be asked, header and Settings say so;</li>"
           "<li>it has been held for long: a jog for %1 s (Settings), Freedrive for five minutes, a move to "
           "a "
           "place for 5 s more than it takes. The last 3 s are counted down.</li></ul>"
           "<p>A stopped motion needs a new press. <b>Space</b> and <b>Esc</b> stop from everywhere, "
           "programs "
           "of others too. This is a software stop, not an emergency stop: keep the emergency stop within "
           "reach.</p>"
           "<p><b>Ctrl</b> makes a press ten times finer, <b>Shift</b> three times faster, never above "
           "the cap. On a keyboard without Latin letters a letter below means its place on a US keyboard.</p>"
           "<h2>Commands</h2>")
            .arg(longestHold) +
        commands);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* practice = buttons->addButton(tr("Practice tasks"), QDialogButtonBox::ActionRole);
    practice->setObjectName("help.practice");
    practice->setAutoDefault(false);
    connect(practice, &QPushButton::clicked, this, [this] {
        Q_EMIT practiceRequested();
        close();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    layout->addWidget(text);
    layout->addWidget(buttons);
}

}  // namespace tiller::app

#include "moc_help_page.cpp"
