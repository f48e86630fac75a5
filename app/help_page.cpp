// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_page.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

#include "widgets/common/theme.h"

namespace tiller::app {

HelpPage::HelpPage(int longestHold, const QString& commands, const QString& manual, QWidget* parent)
    : QDialog(parent), folder_(manual), manual_(new QTextBrowser) {
    setObjectName("helpPage");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Help"));
    resize(820, 620);
    auto* pages = new QTabWidget;
    pages->setObjectName("helpPages");
    pages->setAccessibleName(tr("Help"));
    pages->tabBar()->setAccessibleName(tr("Help"));
    pages->tabBar()->setDrawBase(false);
    pages->addTab(buildManual(), tr("Manual"));
    pages->addTab(buildRules(longestHold, commands), tr("Jogging and keys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* practice = buttons->addButton(tr("Practice tasks"), QDialogButtonBox::ActionRole);
    practice->setObjectName("help.practice");
    practice->setAutoDefault(false);
    connect(practice, &QPushButton::clicked, this, [this] {
        Q_EMIT practiceRequested();
        close();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(buttons);
    manual_->setFocus();
}

QWidget* HelpPage::buildManual() {
    auto* page = new QWidget;
    const auto key = [](const QString& name, const QString& text) {
        auto* made = new QPushButton(text);
        made->setObjectName(name);
        made->setAutoDefault(false);
        return made;
    };
    auto* back = key("help.back", tr("Back"));
    auto* contents = key("help.contents", tr("Contents"));
    manual_->setObjectName("help.manual");
    manual_->setAccessibleName(tr("Manual"));
    manual_->setOpenExternalLinks(true);
    applyColours();
    back->setEnabled(false);
    connect(manual_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(back, &QPushButton::clicked, manual_, &QTextBrowser::backward);
    connect(contents, &QPushButton::clicked, this, [this] { showManual(QStringLiteral("index.html")); });
    auto* keys = new QHBoxLayout;
    keys->addWidget(back);
    keys->addWidget(contents);
    keys->addStretch(1);
    auto* layout = new QVBoxLayout(page);
    layout->addLayout(keys);
    layout->addWidget(manual_);
    contents->setEnabled(!folder_.isEmpty());
    if (folder_.isEmpty()) {
        manual_->setHtml(
            tr("<h2>The manual is not installed on this PC</h2><p>The Debian package of Tiller contains the "
               "manual. To add the manual to your own build, install the package "
               "python3-sphinx:</p><pre>apt-get install python3-sphinx</pre><p>Then build again. You can "
               "also read the pages as text in the folder packaging/manual of the source code. The page "
               "“Jogging and keys” of this window contains the jogging rules and all shortcuts.</p>"));
    } else {
        showManual(QStringLiteral("index.html"));
        manual_->clearHistory();
    }
    return page;
}

QWidget* HelpPage::buildRules(int longestHold, const QString& commands) {
    auto* text = new QTextBrowser;
    text->setObjectName("helpText");
    text->setAccessibleName(tr("Jogging and keys"));
    text->setHtml(
        tr("<h2>Moving the arm</h2><p>The arm moves while you hold a jog button, and stops when you release "
           "it. It also stops when</p><ul><li>the pointer leaves the button, a different mouse button is "
           "pressed, or a second input device is used;</li><li>a modifier or an opposite key is pressed "
           "while a keyboard key is held;</li><li>the window loses focus, a dialog or menu opens, or the "
           "frame, speed, step or tab changes;</li><li>data from the robot are late, Tiller hangs, or the "
           "robot mode, the safety mode or Remote control changes;</li><li>the screen is locked, the PC goes "
           "to sleep, or the input device is unplugged or stops sending data;</li><li>the key-state check "
           "fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still "
           "pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the "
           "motion ends. If the check is not available, the header and Settings show a note;</li><li>the "
           "maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the "
           "duration of the move plus 5 s for a move to a position. The last 3 s are counted "
           "down.</li></ul><p>After a stop, press the button or key again to move the arm. While Tiller is "
           "in control, <b>Space</b> and <b>Esc</b> stop the arm from every window, dialog and text field. "
           "When Tiller is not in control, they act on the focused element; click <b>STOP</b> to stop a "
           "program from another client. This is a software stop, not an emergency stop: keep the emergency "
           "stop within reach.</p><p>Hold <b>Ctrl</b> for one-tenth of the speed, or <b>Shift</b> for three "
           "times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below "
           "refer to key positions on a US keyboard.</p><h2>Commands</h2>")
            .arg(longestHold) +
        commands);
    return text;
}

void HelpPage::showManual(const QString& page) {
    if (folder_.isEmpty()) {
        return;
    }
    const QString file = page.section(QLatin1Char('#'), 0, 0);
    QUrl url = QUrl::fromLocalFile(QDir(folder_).filePath(file));
    url.setFragment(page.section(QLatin1Char('#'), 1));
    manual_->setSource(url);
}

void HelpPage::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        applyColours();
        if (!folder_.isEmpty()) {
            manual_->reload();
        }
    }
}

void HelpPage::applyColours() {
    const Theme& theme = Theme::current();
    manual_->document()->setDefaultStyleSheet(
        QStringLiteral("a { color: %1; } pre { background-color: %2; } dt { font-weight: bold; }")
            .arg(theme.moving.name(), theme.background.name()));
}

}  // namespace tiller::app

#include "moc_help_page.cpp"
