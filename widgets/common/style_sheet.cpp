// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/style_sheet.h"

#include <QHash>
#include <algorithm>

#include "widgets/common/density.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

// styleSheet() replaces the placeholders @role by the colours of the theme.
constexpr char kTemplate[] = R"(
QMainWindow, QDialog, QMessageBox { background: @background; }
QMainWindow::separator { background: @background; width: 10px; height: 10px; }
#stage::separator { width: 9px; height: 9px; }
QSplitter::handle { background: transparent; }
QToolTip { background: @raised; color: @text; border: 1px solid @border; padding: 4px 6px; font-size: 13px; }

QLabel[role="secondary"] { color: @secondary; }
QLabel[role="caption"] { color: @secondary; font-size: 13px; }
QLabel[role="strong"] { font-weight: bold; }
QLabel[role="warning"] { color: @warning; font-weight: bold; }
QLabel[role="alarm"] { color: @alarm; font-weight: bold; }

QPushButton, QToolButton { background: @raised; color: @text; border: 1px solid @border; border-radius: 5px;
    padding: 0 14px; min-height: @keyHeight; font-size: 15px; }
QToolButton { padding: 0 10px; }
QPushButton:hover, QToolButton:hover { background: @hover; }
QPushButton:pressed, QToolButton:pressed, QToolButton:checked { background: @movingTint; }
QPushButton:focus, QToolButton:focus { border-color: @moving; }
QPushButton:disabled, QToolButton:disabled { background: @panel; color: @disabledText; }
QPushButton[primary="true"], QToolButton[primary="true"] { background: @inverse; color: @inverseText;
    border-color: @inverse; font-weight: bold; }
QPushButton[primary="true"]:disabled, QToolButton[primary="true"]:disabled { background: @border;
    color: @disabledText; border-color: @border; }
QPushButton#nextStepButton { padding: 0 8px; }
QPushButton[danger="true"] { background: @stop; color: @stopText; border-color: @stop; font-weight: bold; }
QToolButton[quiet="true"], QPushButton[quiet="true"] { background: transparent; border: 1px solid transparent;
    border-radius: 4px; padding: 0 5px; min-height: 22px; font-size: 14px; }
QToolButton[quiet="true"]:focus, QPushButton[quiet="true"]:focus { border-color: @moving; }
QToolButton[quiet="true"]:hover, QPushButton[quiet="true"]:hover { background: @hover; border-radius: 4px; }
QPushButton[dense="true"] { min-height: 28px; padding: 0 10px; }
QToolButton::menu-indicator, QPushButton::menu-indicator { image: none; width: 0; }

QLineEdit, QSpinBox, QDoubleSpinBox, QComboBox, QPlainTextEdit, QTextEdit { background: @raised; color: @text;
    border: 1px solid @border; border-radius: 5px; padding: 2px 8px; selection-background-color: @moving;
    selection-color: @movingText; }
QLineEdit, QSpinBox, QDoubleSpinBox, QComboBox { min-height: @fieldHeight; }
QLineEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QComboBox:focus { border-color: @moving; }
QLineEdit[refused="true"], QDoubleSpinBox[refused="true"] { border: 2px solid @alarm; }
QLineEdit > QToolButton { background: transparent; border: none; padding: 0; min-height: 0; }
QAbstractSpinBox QLineEdit { border: none; padding: 0; min-height: 0; background: transparent; }
QDoubleSpinBox[dense="true"] { padding: 2px 4px; font-size: 13px; min-height: @denseHeight; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/tiller/icons/drop-arrow-@scheme.svg); width: 12px; height: 12px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { border: none; width: 0; }
QComboBox QAbstractItemView { background: @raised; color: @text; border: 1px solid @border; outline: none;
    selection-background-color: @movingTint; selection-color: @text; }

QTabWidget::pane { border: none; }
QTabBar { background: transparent; border: none; }
QTabBar::tab { background: transparent; color: @secondary; border: none; border-bottom: 3px solid transparent;
    padding: 7px 12px 6px 12px; font-size: 15px; }
QTabBar::tab:selected { color: @text; font-weight: bold; border-bottom: 3px solid @text; }
QTabBar::tab:hover:!selected { color: @text; }

QTableView, QTreeView, QListView { background: transparent; alternate-background-color: transparent;
    color: @text; border: 1px solid transparent; border-radius: 3px; outline: none; gridline-color: @border; font-size: 15px;
    selection-background-color: @movingTint; selection-color: @text; }
QTableView::item, QTreeView::item, QListView::item { border: none; border-bottom: 1px solid @border;
    padding: 0 10px; }
QTableView::item:selected, QTreeView::item:selected, QListView::item:selected { background: @movingTint;
    color: @text; }
QCheckBox::indicator, QGroupBox::indicator, QTableView::indicator, QTreeView::indicator, QListView::indicator {
    background: @raised; border: 1px solid @secondary; border-radius: 3px; width: 14px; height: 14px; }
QCheckBox::indicator:checked, QGroupBox::indicator:checked, QTableView::indicator:checked,
QTreeView::indicator:checked, QListView::indicator:checked { image: url(:/tiller/icons/check-@scheme.svg); }
QCheckBox::indicator:focus { border-color: @moving; }
QCheckBox::indicator:disabled { background: transparent; border-color: @disabledText; }
QListView::item:disabled { color: @secondary; }
#paletteList::item { padding: 5px 10px; }
QTableView:focus, QTreeView:focus, QListView:focus { border-color: @moving; }
QHeaderView { background: transparent; border: none; }
QHeaderView::section { background: transparent; color: @secondary; border: none;
    border-bottom: 1px solid @border; padding: 6px 10px; font-size: 13px; font-weight: normal; }
QTableCornerButton::section { background: transparent; border: none; }

QScrollArea { background: transparent; border: none; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: @border; border-radius: 4px; margin: 1px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; }
QScrollBar::handle:hover { background: @secondary; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QMenu { background: @raised; color: @text; border: 1px solid @border; padding: 4px 0; font-size: 15px; }
QMenu::item { padding: @menuPadding 28px @menuPadding 16px; }
QMenu::item:selected { background: @movingTint; }
QMenu::item:disabled { color: @disabledText; }
QMenu::separator { height: 1px; background: @border; margin: 4px 0; }
QMenuBar { background: @raised; color: @text; }
QMenuBar::item:selected { background: @movingTint; }

QCheckBox, QRadioButton { spacing: 8px; }
QProgressBar { background: @border; border: none; border-radius: 3px; max-height: 6px; }
QProgressBar::chunk { background: @moving; border-radius: 3px; }
QGroupBox { border: 1px solid @border; border-radius: 6px; margin-top: 18px; padding: 8px; }
QGroupBox::title { subcontrol-origin: margin; left: 8px; color: @secondary; }
)";

// Larger touch targets in areas that always have enough space: scroll areas and overlays.
constexpr char kTouch[] = R"(
QCheckBox, QRadioButton { min-height: @touch; spacing: 12px; }
QCheckBox::indicator, QRadioButton::indicator { width: 24px; height: 24px; }
QListView::item, QTreeView::item { min-height: @touch; }
QComboBox QAbstractItemView::item { min-height: @touch; }
QPushButton[dense="true"] { min-height: @keyHeight; }
)";

// Larger touch targets in parts of the window that are always visible. Used only if the window is large
// enough.
constexpr char kRoomyTouch[] = R"(
QTabBar::tab { min-height: 36px; }
QToolButton[quiet="true"], QPushButton[quiet="true"] { min-height: @keyHeight; }
)";

}  // namespace

QString styleSheet(const Theme& t) {
    const QHash<QString, QColor> roles = {
        {QStringLiteral("background"), t.background}, {QStringLiteral("panel"), t.panel},
        {QStringLiteral("raised"), t.raised},         {QStringLiteral("border"), t.border},
        {QStringLiteral("hover"), t.hover},           {QStringLiteral("text"), t.text},
        {QStringLiteral("secondary"), t.secondary},   {QStringLiteral("disabledText"), t.disabledText},
        {QStringLiteral("inverse"), t.inverse},       {QStringLiteral("inverseText"), t.inverseText},
        {QStringLiteral("moving"), t.moving},         {QStringLiteral("movingText"), t.movingText},
        {QStringLiteral("movingTint"), t.movingTint}, {QStringLiteral("warning"), t.warning},
        {QStringLiteral("alarm"), t.alarm},           {QStringLiteral("stop"), t.stop},
        {QStringLiteral("stopText"), t.stopText},
    };
    const int key = keyHeight(currentDensity());
    const bool touch = currentDensity() == Density::Touch;
    const auto pixels = [](int number) { return QString::number(number) + QStringLiteral("px"); };
    const QHash<QString, QString> words = {
        {QStringLiteral("scheme"), t.isDark() ? QStringLiteral("dark") : QStringLiteral("light")},
        {QStringLiteral("keyHeight"), pixels(key)},
        {QStringLiteral("fieldHeight"),
         pixels(touchHeight() > 0 ? key - 6 : key - 10)},  // without padding and border
        {QStringLiteral("touch"), pixels(key)},
        // Six buttons of this height must fit next to a table in the smallest window.
        {QStringLiteral("denseHeight"), pixels(touchHeight() > 0 ? key - 6 : std::min(key - 10, 28))},
        {QStringLiteral("menuPadding"), pixels(touch ? 16 : (key - 24) / 2)},
    };
    QString out;
    QString source = QString::fromLatin1(kTemplate);
    if (touch) {
        source += QLatin1String(kTouch);
    }
    if (touchHeight() > 0) {
        source += QLatin1String(kRoomyTouch);
    }
    out.reserve(source.size() + 512);
    for (qsizetype i = 0; i < source.size(); ++i) {
        if (source[i] != QLatin1Char('@')) {
            out += source[i];
            continue;
        }
        qsizetype end = i + 1;
        while (end < source.size() && source[end].isLetter()) {
            ++end;
        }
        const QString role = source.mid(i + 1, end - i - 1);
        out += words.contains(role) ? words.value(role) : roles.value(role, t.text).name();
        i = end - 1;
    }
    return out;
}

}  // namespace tiller
