// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows the limit that the arm has reached and, on a second line, how to move away from it. Without a limit,
// shows another text, e.g. the measured duration and distance of the last stop. The height is constant, so
// that widgets below do not move.

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
    /// Sets the text that is shown while no limit is reached.
    void setQuietText(const QString& text);
    QString quietText() const { return quiet_; }

    /// The displayed lines from top to bottom.
    QStringList shownLines() const;

    /// Height of two lines: the limit, and below it the suggested action, which is never elided.
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
