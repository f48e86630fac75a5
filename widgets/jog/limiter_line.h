// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names what limits the arm and, on a line of its own, the way out of it; when nothing does, the measured stop of
// the last jog. It keeps its height, so that nothing below it jumps.

#include <QFont>
#include <QList>
#include <QStringList>
#include <QWidget>

#include "robot/station/jog/limiter_advice.h"

namespace tiller {

class LimiterLine : public QWidget {
    Q_OBJECT

public:
    explicit LimiterLine(QWidget* parent = nullptr);

    void setLimiter(const LimiterAdvice& limiter);
    const LimiterAdvice& limiter() const { return limiter_; }
    /// Shown while nothing limits.
    void setQuietText(const QString& text);
    QString quietText() const { return quiet_; }

    /// What stands on the line now, from top to bottom, as it is drawn.
    QStringList shownLines() const;

    /// Two lines always: what limits, and below it the way out, which is never cut off.
    QSize sizeHint() const override { return {366, 38}; }
    QSize minimumSizeHint() const override { return {200, 32}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Line {
        QFont font;
        QString text;
    };
    QList<Line> lines() const;

    LimiterAdvice limiter_;
    QString quiet_;
};

}  // namespace tiller
