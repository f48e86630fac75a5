// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/state_chip.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextBoundaryFinder>
#include <algorithm>
#include <cmath>

#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kPadding = 12;
constexpr int kDensePadding = 8;
constexpr int kShapeRoom = 18;
constexpr int kArrowRoom = 16;
constexpr int kMarkRoom = 12;

constexpr int kSmallestFont = 11;  // [px]
constexpr int kTwoLinesFont = 12;

/// A text on one or two lines.
struct BrokenText {
    QString text;
    int longer = 0;  ///< width of the longer line [px]
    int shorter = 0;

    int widthWith(int arrow) const { return std::max(longer, shorter + arrow); }
};

/// Splits the text at the position that minimizes the width of the longer line. Removes a separating dot at
/// the break.
BrokenText twoLines(const QString& text, const QFontMetrics& metrics) {
    const int whole = metrics.horizontalAdvance(text);
    BrokenText best{text, whole, whole};
    QTextBoundaryFinder finder(QTextBoundaryFinder::Line, text);
    for (qsizetype at = finder.toNextBoundary(); at > 0 && at < text.size(); at = finder.toNextBoundary()) {
        QString first = text.left(at).trimmed();
        const QString second = text.mid(at);
        if (first.endsWith(QStringLiteral(" ·"))) {
            first.chop(2);
        }
        const auto [shorter, longer] =
            std::minmax({metrics.horizontalAdvance(first), metrics.horizontalAdvance(second)});
        if (longer < best.longer) {
            best = {first + QLatin1Char('\n') + second, longer, shorter};
        }
    }
    return best;
}

QFont captionFont(bool strong) {
    QFont font = textFont(11, strong ? QFont::Bold : QFont::Normal);
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.4);
    return font;
}

struct Colours {
    QColor fill, border, caption, value, shape;
};

Colours coloursOf(StateChip::Emphasis emphasis, const Theme& t) {
    switch (emphasis) {
        case StateChip::Emphasis::Moving:
            return {t.moving, t.moving, t.movingText, t.movingText, t.movingText};
        case StateChip::Emphasis::Warning:
            return {t.warningBackground, t.warning, t.warning, t.warning, t.warning};
        case StateChip::Emphasis::Alarm:
            return {t.stop, t.stop, t.stopText, t.stopText, t.stopText};
        case StateChip::Emphasis::OperatorNeeded:
            return {t.operatorNeeded, t.operatorNeeded, t.operatorNeededText, t.operatorNeededText,
                    t.operatorNeededText};
        case StateChip::Emphasis::Muted:
            return {t.panel, t.border, t.secondary, t.secondary, t.secondary};
        case StateChip::Emphasis::Normal:
            break;
    }
    return {t.panel, t.border, t.secondary, t.text, t.text};
}

}  // namespace

StateChip::StateChip(const QString& caption, QWidget* parent) : QWidget(parent), caption_(caption) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(caption);
}

void StateChip::setCaption(const QString& caption, ElidedPart elidedPart) {
    if (caption != caption_ || elidedPart != elidedPart_) {
        caption_ = caption;
        elidedPart_ = elidedPart;
        updateGeometry();
        showTip();
        update();
    }
}

QString StateChip::leastCaption(const QString& caption) const {
    const QString dot = QStringLiteral(" · ");
    return elidedPart_ == ElidedPart::Behind || !caption.contains(dot) ? caption.section(dot, 0, 0)
                                                                       : caption.section(dot, 1);
}

QString StateChip::shownCaption() const {
    const QFontMetrics metrics(captionFont(isStrong()));
    const int room = width() - 2 * padding() + 1;
    if (metrics.horizontalAdvance(caption_) <= room) {
        return caption_;
    }
    return metrics.elidedText(elidedPart_ == ElidedPart::Before ? leastCaption() : caption_, Qt::ElideRight,
                              room);
}

void StateChip::setState(const QString& text, Shape shape, Emphasis emphasis, const QString& advice) {
    if (text == text_ && shape == shape_ && emphasis == emphasis_) {
        if (advice != advice_) {
            advice_ = advice;
            showTip();
        }
        return;
    }
    advice_ = advice;
    const bool resized = text.size() != text_.size() || emphasis != emphasis_ || shape != shape_ || !figures_;
    text_ = text;
    shape_ = shape;
    emphasis_ = emphasis;
    setAccessibleDescription(text);
    if (resized) {
        updateGeometry();
    }
    showTip();
    update();
}

void StateChip::showTip() {
    const bool whole = room_ > 0 ? isWhole() && shownCaption() == caption_ : width() >= sizeHint().width();
    const QString tip = whole ? advice_ : advice_.isEmpty() ? text_ : text_ + QLatin1Char('\n') + advice_;
    if (tip != toolTip()) {
        setToolTip(tip);
    }
}

void StateChip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showTip();
}

void StateChip::setMark(const QString& mark) {
    if (mark != mark_) {
        mark_ = mark;
        updateGeometry();
        showTip();
        update();
    }
}

int StateChip::roomOf(Shape shape, const QString& mark) {
    const bool beside = !mark.isEmpty() && shape != Shape::Octagon;
    return shape == Shape::None ? 0 : kShapeRoom + (beside ? kMarkRoom : 0);
}

void StateChip::setNumberFont(bool figures) {
    figures_ = figures;
    showTip();
    updateGeometry();
}

void StateChip::setDense(bool dense) {
    if (dense != dense_) {
        dense_ = dense;
        updateGeometry();
        showTip();
        update();
    }
}

int StateChip::padding() const {
    return dense_ ? kDensePadding : kPadding;
}

void StateChip::setLeastCharacters(int characters) {
    if (characters != leastCharacters_) {
        leastCharacters_ = characters;
        showTip();
        updateGeometry();
    }
}

int StateChip::leastRoom(const QString& caption) const {
    return widthFor(QString(leastCharacters_, QLatin1Char('0')) + QChar(0x2026), leastCaption(caption));
}

void StateChip::setRoom(int width) {
    if (width != room_) {
        room_ = width;
        setFixedWidth(width);
        updateGeometry();
    }
}

void StateChip::setMenuArrow(bool arrow) {
    menuArrow_ = arrow;
    setFocusPolicy(arrow ? Qt::TabFocus : Qt::NoFocus);
    setCursor(arrow ? Qt::PointingHandCursor : Qt::ArrowCursor);
    updateGeometry();
}

QFont StateChip::valueFont() const {
    const int size = dense_ ? 14 : 15;
    return figures_ ? numberFont(size) : textFont(size, isStrong() ? QFont::Bold : QFont::Normal);
}

int StateChip::widthFor(const QString& value, const QString& caption) const {
    const int captionWidth = QFontMetrics(captionFont(true)).horizontalAdvance(caption);
    // Add one pixel, because display scaling leads to fractional text widths. A width that is one pixel too
    // small would elide three letters.
    const int letters = static_cast<int>(std::ceil(QFontMetricsF(valueFont()).horizontalAdvance(value))) + 1;
    const int valueWidth = letters + shapeRoom() + (menuArrow_ ? kArrowRoom : 0);
    return std::max(captionWidth, valueWidth) + 2 * padding() + 2;
}

int StateChip::valueRoom() const {
    return width() - 2 * padding() - shapeRoom() - (menuArrow_ ? kArrowRoom : 0) + 1;
}

StateChip::FittedText StateChip::fittedText() const {
    const int room = valueRoom();
    QFont font = valueFont();
    const bool isFixed = room_ > 0 || dense_;
    const auto shrinkUntil = [&font, isFixed](int smallest, const auto& fits) {
        while (!fits(QFontMetrics(font)) && isFixed && font.pixelSize() > smallest) {
            font.setPixelSize(font.pixelSize() - 1);
        }
        return fits(QFontMetrics(font));
    };
    if (shrinkUntil(kSmallestFont,
                    [&](const QFontMetrics& m) { return m.horizontalAdvance(text_) <= room; })) {
        return {font, text_, true};
    }
    if (isFixed) {
        const int arrow = menuArrow_ ? kArrowRoom : 0;  // the arrow is next to the shorter line
        font.setPixelSize(kTwoLinesFont);
        if (shrinkUntil(kSmallestFont, [&](const QFontMetrics& m) {
                return twoLines(text_, m).widthWith(arrow) <= room + arrow;
            })) {
            return {font, twoLines(text_, QFontMetrics(font)).text, true};
        }
    }
    return {font, QFontMetrics(font).elidedText(text_, Qt::ElideRight, room), false};
}

int StateChip::minWidth(const QString& text, Shape shape, Emphasis emphasis, const QString& mark) const {
    QFont font = textFont(kSmallestFont, isStrong(emphasis) ? QFont::Bold : QFont::Normal);
    const int caption = QFontMetrics(captionFont(isStrong(emphasis))).horizontalAdvance(leastCaption());
    const int value = twoLines(text, QFontMetrics(font)).widthWith(menuArrow_ ? kArrowRoom : 0);
    return std::max(caption, value + roomOf(shape, mark)) + 2 * padding();
}

QSize StateChip::sizeHint() const {
    return {room_ > 0 ? room_ : widthFor(text_, caption_), kHeight};
}

QSize StateChip::minimumSizeHint() const {
    if (room_ > 0) {
        return {room_, kHeight};
    }
    const QString least =
        text_.size() > leastCharacters_ ? text_.left(leastCharacters_) + QChar(0x2026) : text_;
    return {widthFor(least, leastCaption()), kHeight};
}

void StateChip::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const Colours colours = coloursOf(emphasis_, theme);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    // Show the focus ring only for keyboard navigation.
    const bool ring = hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange);
    painter.setPen(ring ? QPen(theme.moving, 2) : QPen(colours.border, 1));
    painter.setBrush(colours.fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCornerRadius, kCornerRadius);

    painter.setFont(captionFont(isStrong()));
    painter.setPen(colours.caption);
    const QRect above(padding(), 7, width() - 2 * padding(), 16);
    painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, shownCaption());

    int x = padding();
    constexpr int kValueTop = 23;
    constexpr int kValueHeight = 22;
    if (shape_ != Shape::None) {
        const QRectF box(x, kValueTop + 4, 14, 14);
        drawShape(painter, shape_, box, colours.shape, colours.fill, mark_);
        x += shapeRoom();
    }
    const FittedText shown = fittedText();
    const QStringList lines = shown.text.split(QLatin1Char('\n'));
    painter.setFont(shown.font);
    painter.setPen(colours.value);
    double arrowY = kValueTop + kValueHeight / 2.0 - 2;
    int arrowX = x;
    if (lines.size() == 1) {
        painter.drawText(QRect(x, kValueTop, valueRoom(), kValueHeight), Qt::AlignLeft | Qt::AlignVCenter,
                         shown.text);
        arrowX += painter.fontMetrics().horizontalAdvance(shown.text);
    } else {
        constexpr int kLineHeight = 13;
        constexpr int kTop = kValueTop - 1;
        const int room = width() - padding() - x + 1;
        for (int i = 0; i < 2; ++i) {
            painter.drawText(QRect(x, kTop + i * kLineHeight, room, kLineHeight),
                             Qt::AlignLeft | Qt::AlignVCenter, lines.at(i));
        }
        const int first = painter.fontMetrics().horizontalAdvance(lines.at(0));
        const int second = painter.fontMetrics().horizontalAdvance(lines.at(1));
        arrowX += std::min(first, second);
        arrowY = kTop + (second <= first ? 1.5 : 0.5) * kLineHeight - 3;
    }
    if (menuArrow_) {
        const int left = arrowX + 6;
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.value);
        painter.drawPolygon(
            QPolygonF({{left + 0.0, arrowY}, {left + 9.0, arrowY}, {left + 4.5, arrowY + 6}}));
    }
}

void StateChip::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) {
        Q_EMIT clicked();
    }
}

void StateChip::keyPressEvent(QKeyEvent* event) {
    if (menuArrow_ && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        Q_EMIT clicked();
        return;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace tiller

#include "moc_state_chip.cpp"
