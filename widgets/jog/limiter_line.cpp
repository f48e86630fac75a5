// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/limiter_line.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/common/shapes.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

constexpr int kTextLeft = 28;  // left edge of the text, to the right of the triangle [px]
constexpr int kQuietLeft = 4;
constexpr int kTextRight = 6;
constexpr int kLargest = 13;  // largest font size [px]
constexpr int kSmallest = 10;

/// The largest font with which the text fits on one line.
QFont fittingFont(const QString& text, QFont::Weight weight, int width) {
    int size = kLargest;
    while (size > kSmallest && QFontMetrics(textFont(size, weight)).horizontalAdvance(text) > width) {
        --size;
    }
    return textFont(size, weight);
}

/// Splits a text at the space that is nearest to its middle.
QStringList halves(const QString& text) {
    qsizetype best = -1;
    for (qsizetype at = text.indexOf(QLatin1Char(' ')); at >= 0;
         at = text.indexOf(QLatin1Char(' '), at + 1)) {
        if (best < 0 || std::abs(2 * at - text.size()) < std::abs(2 * best - text.size())) {
            best = at;
        }
    }
    return best < 0 ? QStringList{text} : QStringList{text.left(best), text.mid(best + 1)};
}

}  // namespace

LimiterLine::LimiterLine(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("limiterLine"));
    setAccessibleName(tr("Limiter"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void LimiterLine::setLimiter(const LimiterAdvice& limiter) {
    if (limiter.what == limiter_.what && limiter.advice == limiter_.advice) {
        return;
    }
    limiter_ = limiter;
    setAccessibleDescription(limiter.what + QLatin1Char(' ') + limiter.advice);
    setToolTip(limiter.what.isEmpty() ? QString() : limiter.what + QStringLiteral(": ") + limiter.advice);
    update();
}

QList<LimiterLine::Line> LimiterLine::lines() const {
    const int width = this->width() - (limiter_.what.isEmpty() ? kQuietLeft : kTextLeft) - kTextRight;
    const auto line = [width](const QString& text, QFont::Weight weight, Qt::TextElideMode otherwise) {
        const QFont font = fittingFont(text, weight, width);
        return Line{font, QFontMetrics(font).elidedText(text, otherwise, width)};
    };
    QList<Line> out;
    if (limiter_.what.isEmpty() && quiet_.isEmpty()) {
        return out;
    }
    if (!limiter_.advice.isEmpty()) {
        return {line(limiter_.what, QFont::Bold, Qt::ElideRight),
                line(limiter_.advice, QFont::Normal, Qt::ElideMiddle)};
    }
    // If there is no advice, the text is a sentence that ends with the suggested action.
    const bool quiet = limiter_.what.isEmpty();
    const QString& sentence = quiet ? quiet_ : limiter_.what;
    const QFont::Weight weight = quiet ? QFont::Normal : QFont::Bold;
    const bool oneLine = QFontMetrics(textFont(kLargest, weight)).horizontalAdvance(sentence) <= width;
    for (const QString& part : oneLine ? QStringList{sentence} : halves(sentence)) {
        out.append(line(part, weight, Qt::ElideMiddle));
    }
    return out;
}

QStringList LimiterLine::shownLines() const {
    QStringList out;
    for (const Line& line : lines()) {
        out << line.text;
    }
    return out;
}

void LimiterLine::setQuietText(const QString& text) {
    if (text != quiet_) {
        quiet_ = text;
        update();
    }
}

void LimiterLine::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool quiet = limiter_.what.isEmpty();
    const int left = quiet ? kQuietLeft : kTextLeft;
    if (!quiet) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.warningBackground);
        painter.drawRoundedRect(QRectF(rect()), kCornerRadius - 1, kCornerRadius - 1);
        drawShape(painter, StateChip::Shape::WarningTriangle, QRectF(9, height() / 2.0 - 7, 14, 14),
                  theme.warning, theme.warningBackground);
    }
    painter.setPen(quiet ? theme.secondary : theme.warning);
    const QList<Line> shown = lines();
    const int pitch = (height() - 2) / std::max<int>(1, static_cast<int>(shown.size()));
    for (int i = 0; i < shown.size(); ++i) {
        painter.setFont(shown[i].font);
        painter.drawText(QRect(left, 1 + i * pitch, width() - left - kTextRight, pitch),
                         Qt::AlignLeft | Qt::AlignVCenter, shown[i].text);
    }
}

}  // namespace tiller

#include "moc_limiter_line.cpp"
