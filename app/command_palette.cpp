// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_palette.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "app/action_table.h"
#include "widgets/common/empty_state.h"

namespace tiller::app {
namespace {

/// Returns the rank of the action, where 0 is the best match; -1 if a word does not occur in its texts.
int rank(const QAction& action, const QStringList& words) {
    const QString text = plain(action);
    const QString all =
        text + QLatin1Char(' ') + action.objectName() + QLatin1Char(' ') + ActionTable::helpOf(action);
    for (const QString& word : words) {
        if (!all.contains(word, Qt::CaseInsensitive)) {
            return -1;
        }
    }
    if (words.isEmpty() || text.startsWith(words.join(QLatin1Char(' ')), Qt::CaseInsensitive)) {
        return 0;
    }
    const bool named = std::all_of(words.begin(), words.end(), [&text](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
    const bool begins = text.startsWith(words.first(), Qt::CaseInsensitive);
    return named && begins                                     ? 1
           : named                                             ? 2
           : begins                                            ? 3
           : text.contains(words.first(), Qt::CaseInsensitive) ? 4
                                                               : 5;
}

constexpr int kPaletteWidth = 640;     // [px]
constexpr int kAroundPaletteRow = 72;  // margins and a scroll bar [px]

/// Returns the first clause of a reason, which fits in a row, e.g. "Monitor only", "Not in control". The
/// tooltip contains the complete reason.
QString firstClause(const QString& reason) {
    static const QRegularExpression kEnd(QStringLiteral("[:.](\\s|$)"));
    return reason.left(reason.indexOf(kEnd));
}

}  // namespace

CommandPalette::CommandPalette(const ActionTable& actions, QWidget* parent)
    : QDialog(parent), actions_(actions) {
    setObjectName("commandPalette");
    setWindowTitle(tr("Commands"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(kPaletteWidth, 420);
    auto* layout = new QVBoxLayout(this);
    words_ = new QLineEdit(this);
    words_->setObjectName("paletteWords");
    words_->setAccessibleName(tr("Search commands"));
    words_->setPlaceholderText(tr("Type a command or keyword"));
    words_->installEventFilter(this);
    list_ = new QListWidget(this);
    list_->setObjectName("paletteList");
    list_->setAccessibleName(tr("Commands found"));
    nothing_ = new EmptyState(*list_);
    layout->addWidget(words_);
    layout->addWidget(list_);
    connect(words_, &QLineEdit::textChanged, this, &CommandPalette::list);
    connect(words_, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
    connect(list_, &QListWidget::itemActivated, this, &CommandPalette::runCurrent);
    list({});
    words_->setFocus();
}

void CommandPalette::list(const QString& words) {
    const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    QList<QPair<int, QAction*>> found;
    for (QAction* action : actions_.all()) {
        if (const int r = rank(*action, wanted); r >= 0 && !plain(*action).isEmpty()) {
            found.append({r, action});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    list_->clear();
    listed_.clear();
    for (const auto& [r, action] : found) {
        QString text = plain(*action);
        if (const QString keys = action->shortcut().toString(QKeySequence::NativeText); !keys.isEmpty()) {
            text += QStringLiteral("   ") + keys;
        }
        auto* item = new QListWidgetItem(text, list_);
        QString tip = ActionTable::helpOf(*action);
        if (!action->isEnabled()) {
            const QString why = ActionTable::obstacleOf(*action);
            const QString whole =
                text + QStringLiteral(" – ") + (why.isEmpty() ? tr("not available now") : why);
            const QString brief = whole.left(text.size() + 3) + firstClause(whole.mid(text.size() + 3));
            item->setText(
                list_->fontMetrics().elidedText(brief, Qt::ElideRight, kPaletteWidth - kAroundPaletteRow));
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
            tip.prepend(whole + QLatin1Char('\n'));
        }
        item->setToolTip(tip);
        listed_.append(action);
    }
    list_->setCurrentRow(listed_.isEmpty() ? -1 : 0);
    nothing_->tell(listed_.isEmpty(), words);
}

void CommandPalette::runCurrent() {
    const int row = list_->currentRow();
    if (row < 0 || row >= listed_.size() || !listed_[row]->isEnabled()) {
        return;
    }
    const QPointer<QAction> action = listed_[row];
    // Close the palette first, so that the main window is active if the action opens a dialog.
    accept();
    if (action) {
        action->trigger();
    }
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == words_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up) {
            const int step = key == Qt::Key_Down ? 1 : -1;
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, std::max(0, list_->count() - 1)));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace tiller::app

#include "moc_command_palette.cpp"
