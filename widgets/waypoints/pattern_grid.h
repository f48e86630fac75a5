// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A top view of a pattern: one square per position, with the number of the position in execution order. A
// click, or Space on the current square, skips or includes a position.

#include <QWidget>

#include "robot/project/pattern.h"

namespace tiller {

class PatternGrid : public QWidget {
    Q_OBJECT

public:
    explicit PatternGrid(QWidget* parent = nullptr);

    /// Sets positions and order. Positions that are still in the grid remain skipped.
    void setPattern(const project::Pattern& pattern);
    const std::vector<project::PatternCell>& excluded() const { return pattern_.excluded; }
    QRect rectOf(const project::PatternCell& cell) const;

    QSize sizeHint() const override { return {260, 200}; }

Q_SIGNALS:
    void excludedChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void toggle(const project::PatternCell& cell);

    project::Pattern pattern_;
    project::PatternCell marked_;
};

}  // namespace tiller
