// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/pattern_grid.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/theme.h"

namespace tiller {

PatternGrid::PatternGrid(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("pattern.grid"));
    setAccessibleName(tr("Pattern cells"));
    setToolTip(tr("Click a cell to exclude or include it. The first cell is at the lower left."));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
}

void PatternGrid::setPattern(const project::Pattern& pattern) {
    pattern_ = pattern;
    std::erase_if(pattern_.excluded, [&](const project::PatternCell& cell) {
        return cell.column >= pattern.columns || cell.row >= pattern.rows;
    });
    marked_.column = std::min(marked_.column, pattern.columns - 1);
    marked_.row = std::min(marked_.row, pattern.rows - 1);
    update();
}

QRect PatternGrid::rectOf(const project::PatternCell& cell) const {
    const int side = std::max(4, std::min(width() / pattern_.columns, height() / pattern_.rows));
    const int left = (width() - side * pattern_.columns) / 2;
    const int top = (height() - side * pattern_.rows) / 2;
    return {left + side * cell.column, top + side * (pattern_.rows - 1 - cell.row), side, side};
}

void PatternGrid::toggle(const project::PatternCell& cell) {
    const auto found = std::find(pattern_.excluded.begin(), pattern_.excluded.end(), cell);
    if (found != pattern_.excluded.end()) {
        pattern_.excluded.erase(found);
    } else {
        pattern_.excluded.push_back(cell);
    }
    marked_ = cell;
    setAccessibleDescription(tr("Row %1, column %2").arg(cell.row + 1).arg(cell.column + 1));
    update();
    Q_EMIT excludedChanged();
}

void PatternGrid::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    for (int row = 0; row < pattern_.rows; ++row) {
        for (int column = 0; column < pattern_.columns; ++column) {
            if (rectOf({column, row}).contains(event->pos())) {
                toggle({column, row});
                return;
            }
        }
    }
}

void PatternGrid::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            marked_.column = std::max(0, marked_.column - 1);
            break;
        case Qt::Key_Right:
            marked_.column = std::min(pattern_.columns - 1, marked_.column + 1);
            break;
        case Qt::Key_Up:
            marked_.row = std::min(pattern_.rows - 1, marked_.row + 1);
            break;
        case Qt::Key_Down:
            marked_.row = std::max(0, marked_.row - 1);
            break;
        case Qt::Key_Space:
            toggle(marked_);
            return;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    setAccessibleDescription(tr("Row %1, column %2").arg(marked_.row + 1).arg(marked_.column + 1));
    update();
}

void PatternGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::current();
    const int side = rectOf({0, 0}).width();
    painter.setFont(numberFont(std::clamp(side / 3, 7, 14)));
    for (int row = 0; row < pattern_.rows; ++row) {
        for (int column = 0; column < pattern_.columns; ++column) {
            const bool out = std::find(pattern_.excluded.begin(), pattern_.excluded.end(),
                                       project::PatternCell{column, row}) != pattern_.excluded.end();
            const QRectF box = QRectF(rectOf({column, row})).adjusted(1.5, 1.5, -1.5, -1.5);
            painter.setPen(QPen(theme.border, 1, out ? Qt::DashLine : Qt::SolidLine));
            painter.setBrush(out ? QBrush(Qt::NoBrush) : QBrush(theme.raised));
            painter.drawRoundedRect(box, 3, 3);
        }
    }
    int number = 0;
    painter.setPen(theme.text);
    project::Pattern layer = pattern_;
    layer.layers = 1;
    for (const project::PatternPlace& place : project::placesOf(layer)) {
        ++number;
        if (side >= 14) {
            painter.drawText(rectOf({place.column, place.row}), Qt::AlignCenter, QString::number(number));
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(theme.moving, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rectOf(marked_)).adjusted(1.5, 1.5, -1.5, -1.5), 3, 3);
    }
}

}  // namespace tiller

#include "moc_pattern_grid.cpp"
