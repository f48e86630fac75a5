// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names what limits the arm and, on a line of its own, the way out of it; when nothing does, the measured stop of
// the last jog. It keeps its height, so that nothing below it jumps.

#include <QFont>
#include <QList>
#include <QStringList>
#include <QWidget>

#include "robot/control/motion_types.h"
#include "widgets/session/session_state.h"

namespace tiller {

/// What limits the arm, and what to do; both empty when nothing does.
struct LimiterAdvice {
    QString what;
    QString advice;
};

/// The nearest limit worth a word: a joint within 15 deg of its range, or a singularity close by.
/// Threads  any
/// R_base_frame  the axes the keys of the pad move in, for the way out
LimiterAdvice nearestLimiter(const SessionState& state,
                             const Eigen::Matrix3d& R_base_frame = Eigen::Matrix3d::Identity());

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
