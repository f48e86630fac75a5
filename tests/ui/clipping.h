// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds clipped text on labels, buttons, fields, tabs and table headers, and widgets that extend beyond their
// parent. A text may be elided only if the tooltip contains the full text.

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStyleOptionFrame>
#include <QTabBar>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/common/state_chip.h"

namespace tiller::test {

namespace clipping {

inline QString nameOf(const QWidget& widget) {
    return QStringLiteral("%1 \"%2\" in \"%3\"")
        .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(),
             widget.parentWidget() != nullptr ? widget.parentWidget()->objectName() : QString());
}

inline int widthOf(const QWidget& widget, const QString& text) {
    return static_cast<int>(std::ceil(QFontMetricsF(widget.font()).horizontalAdvance(text)));
}

/// Returns true if every single word of the label fits in the width `room` [px].
inline bool wordsFit(const QLabel& label, int room) {
    QString text = label.text();
    if (Qt::mightBeRichText(text)) {
        QTextDocument document;
        document.setHtml(text);
        text = document.toPlainText();
    }
    // Chinese and Japanese lines can break between any two characters.
    static const QRegularExpression kBreaks(
        QStringLiteral("[\\s/-]+|(?<=[\\x{3000}-\\x{9FFF}\\x{FF00}-\\x{FFEF}])"));
    const QStringList words = text.split(kBreaks);
    return std::all_of(words.begin(), words.end(),
                       [&](const QString& word) { return widthOf(label, word) <= room; });
}

inline QString problemOfLabel(const QLabel& label) {
    if (label.text().isEmpty() || label.toolTip().contains(label.text())) {
        return {};
    }
    const int room = label.contentsRect().width();
    if (label.wordWrap()) {
        const int needed = label.heightForWidth(label.width());
        return needed > label.height() + 1
                   ? QStringLiteral("needs a height of %1, has %2").arg(needed).arg(label.height())
               : !wordsFit(label, room) ? QStringLiteral("a word is longer than %1").arg(room)
                                        : QString();
    }
    const QSize hint = label.sizeHint();
    const bool shortened = label.text().contains(QChar(0x2026)) && !label.toolTip().isEmpty();
    return !shortened && (hint.width() > label.width() + 1 || hint.height() > label.height() + 1)
               ? QStringLiteral("needs %1 x %2, has %3 x %4")
                     .arg(hint.width())
                     .arg(hint.height())
                     .arg(label.width())
                     .arg(label.height())
               : QString();
}

inline QString problemOfButton(const QAbstractButton& button) {
    // Custom-painted buttons return their own minimum size.
    const bool ordinary = button.inherits("QPushButton") || button.inherits("QToolButton") ||
                          button.inherits("QCheckBox") || button.inherits("QRadioButton");
    const QSize needed = ordinary ? button.sizeHint() : button.minimumSizeHint();
    const bool inTip = !button.text().isEmpty() && button.toolTip().contains(button.text());
    return !inTip && (needed.width() > button.width() + 1 || needed.height() > button.height() + 1)
               ? QStringLiteral("\"%1\" needs %2 x %3, has %4 x %5")
                     .arg(button.text())
                     .arg(needed.width())
                     .arg(needed.height())
                     .arg(button.width())
                     .arg(button.height())
               : QString();
}

inline QString problemOfField(const QString& text, const QWidget& field, int room) {
    return widthOf(field, text) > room
               ? QStringLiteral("\"%1\" needs %2, has %3").arg(text).arg(widthOf(field, text)).arg(room)
               : QString();
}

/// The width available for text inside the border, padding and margins of a line edit [px].
inline int roomIn(const QLineEdit& field) {
    QStyleOptionFrame option;
    option.initFrom(&field);
    option.lineWidth =
        field.hasFrame() ? field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field) : 0;
    constexpr int kQtsOwnMargin = 2;
    return field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field).width() -
           2 * kQtsOwnMargin;
}

inline QString problemOfTabs(const QTabBar& bar) {
    for (int i = 0; i < bar.count(); ++i) {
        const QRect tab = bar.tabRect(i);
        if (!bar.rect().contains(tab) || widthOf(bar, bar.tabText(i)) > tab.width()) {
            return QStringLiteral("tab \"%1\"").arg(bar.tabText(i));
        }
    }
    return {};
}

class Header : public QHeaderView {
public:
    using QHeaderView::sectionSizeFromContents;
};

inline QString problemOfHeader(const QHeaderView& header) {
    if (header.orientation() != Qt::Horizontal || header.model() == nullptr) {
        return {};
    }
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        const QString tip = header.model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString();
        if (!header.isSectionHidden(i) && !tip.contains(text) &&
            widthOf(header, text) > header.sectionSize(i)) {
            return QStringLiteral("column \"%1\" is %2 wide").arg(text).arg(header.sectionSize(i));
        }
    }
    return {};
}

inline QString problemOfList(const QListWidget& list) {
    for (int i = 0; i < list.count(); ++i) {
        const QListWidgetItem* item = list.item(i);
        if (widthOf(list, item->text()) + 20 > list.viewport()->width() &&
            !item->toolTip().contains(item->text())) {
            return QStringLiteral("item \"%1\"").arg(item->text());
        }
    }
    return {};
}

/// Describes the problem with this widget; empty if there is no problem.
inline QString problemOf(const QWidget& widget) {
    if (const auto* chip = qobject_cast<const StateChip*>(&widget)) {
        return chip->width() < chip->sizeHint().width() && !chip->toolTip().contains(chip->text())
                   ? QStringLiteral("\"%1\" is shortened, and the tool tip does not contain it")
                         .arg(chip->text())
                   : QString();
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return problemOfLabel(*label);
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return problemOfButton(*button);
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect field =
            box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        return problemOfField(box->currentText(), *box, field.width());
    }
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget)) {
        const auto* field = box->findChild<QLineEdit*>();
        return field == nullptr ? QString() : problemOfField(box->text(), *field, roomIn(*field));
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) {
        if (qobject_cast<const QKeySequenceEdit*>(field->parentWidget()) != nullptr) {
            const QString words = field->text().isEmpty() ? field->placeholderText() : field->text();
            return problemOfField(words, *field, roomIn(*field));
        }
        return problemOfField(field->placeholderText(), *field, field->width() - 8);
    }
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
        return problemOfTabs(*bar);
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
        return problemOfHeader(*header);
    }
    if (const auto* list = qobject_cast<const QListWidget*>(&widget)) {
        return problemOfList(*list);
    }
    return {};
}

/// True for internal parts of Qt widgets, which Qt lays out itself.
inline bool isInner(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return (widget.objectName().startsWith(QLatin1String("qt_")) &&
            qobject_cast<const QKeySequenceEdit*>(parent) == nullptr) ||
           widget.inherits("QScrollBar") || widget.inherits("QLineEditIconButton") ||
           widget.inherits("QTableCornerButton") || qobject_cast<const QTabBar*>(parent) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
           qobject_cast<const QComboBox*>(parent) != nullptr;
}

inline bool isViewport(const QWidget& widget) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
    return area != nullptr && area->viewport() == &widget;
}

/// Finds widgets of one box layout whose rectangles overlap because the layout has too little height.
inline QStringList overlaps(const QWidget& parent) {
    QStringList found;
    for (const QBoxLayout* layout : parent.findChildren<QBoxLayout*>(Qt::FindDirectChildrenOnly)) {
        const QWidget* before = nullptr;
        for (int i = 0; i < layout->count(); ++i) {
            const QWidget* widget = layout->itemAt(i)->widget();
            if (widget == nullptr || !widget->isVisible()) {
                continue;
            }
            if (before != nullptr && before->geometry().intersects(widget->geometry())) {
                found << nameOf(*before) + QStringLiteral(" overlaps ") + nameOf(*widget);
            }
            before = widget;
        }
    }
    return found;
}

}  // namespace clipping

/// Returns all problems in a visible window.
inline QStringList clipped(const QWidget& window) {
    if (!window.isWindow()) {
        return {clipping::nameOf(window) + QStringLiteral(" is not a window: its contents were not checked")};
    }
    QStringList found = clipping::overlaps(window);
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(&window) || widget->window() != &window || clipping::isInner(*widget)) {
            continue;
        }
        const QWidget* parent = widget->parentWidget();
        // The content of a scroll area may be taller than its viewport, but not wider.
        const QRect place = clipping::isViewport(*parent)
                                ? QRect(widget->x(), 0, widget->width(), std::min(1, parent->height()))
                                : widget->geometry();
        const bool cell = parent->parentWidget() != nullptr && parent->parentWidget()->inherits("QTableView");
        // In right-to-left layouts Qt places the parts of a splitter one pixel too far to the right.
        const int outside = parent->inherits("QSplitter") && parent->isRightToLeft() ? 1 : 0;
        if (!cell && !place.isEmpty() && !parent->rect().adjusted(0, 0, outside, 0).contains(place)) {
            found << clipping::nameOf(*widget) +
                         QStringLiteral(" reaches out of it: %1 to %2 x %3 to %4 in %5 x %6")
                             .arg(place.left())
                             .arg(place.right())
                             .arg(place.top())
                             .arg(place.bottom())
                             .arg(parent->width())
                             .arg(parent->height());
        }
        if (const QString problem = clipping::problemOf(*widget); !problem.isEmpty()) {
            found << clipping::nameOf(*widget) + QStringLiteral(": ") + problem;
        }
        found << clipping::overlaps(*widget);
    }
    return found;
}

/// Returns the problems that remain after the layouts of a visible window have settled. A search takes a long
/// time, and QTRY_VERIFY2 would repeat it five times.
inline QStringList stillClipped(const QWidget& window) {
    QStringList found;
    (void)QTest::qWaitFor(
        [&] {
            found = clipped(window);
            return found.isEmpty();
        },
        60'000);
    return found;
}

}  // namespace tiller::test
