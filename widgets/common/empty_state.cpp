// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/empty_state.h"

#include <QAbstractScrollArea>
#include <QEvent>

namespace tiller {

namespace {

constexpr qsizetype kLongest = 40;  // maximum number of displayed characters of the search text
constexpr int kMargin = 16;         // [px]

}  // namespace

EmptyState::EmptyState(QAbstractScrollArea& list) : QLabel(list.viewport()), list_(list) {
    setObjectName(list.objectName() + QStringLiteral(".nothingFound"));
    setAccessibleName(tr("Nothing found"));
    setProperty("role", QStringLiteral("secondary"));
    setAlignment(Qt::AlignCenter);
    setMargin(kMargin);
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    list.viewport()->installEventFilter(this);
    hide();
}

void EmptyState::tell(bool nothing, const QString& words) {
    const QString typed = words.trimmed();
    const bool whole = typed.size() <= kLongest;
    setText(typed.isEmpty() ? tr("Nothing found with these filters.")
                            : tr("Nothing found for “%1”.\nClear the search to see everything.")
                                  .arg(whole ? typed : typed.left(kLongest) + QChar(0x2026)));
    setGeometry(list_.viewport()->rect());
    setVisible(nothing);
    if (nothing) {
        raise();
    }
}

bool EmptyState::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_.viewport() && event->type() == QEvent::Resize) {
        setGeometry(list_.viewport()->rect());
    }
    return QLabel::eventFilter(watched, event);
}

}  // namespace tiller

#include "moc_empty_state.cpp"
