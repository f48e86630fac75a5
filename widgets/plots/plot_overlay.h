// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Elements drawn over and next to the curves: the two time cursors and the state lane.

#include <QGraphicsItem>
#include <QString>
#include <vector>

#include "robot/station/history/state_lane.h"

namespace tiller {

/// A dashed line across all plots, with its letter on top.
class CursorItem : public QGraphicsItem {
public:
    explicit CursorItem(const QString& letter);

    /// Sets the horizontal position and the vertical extent, in scene coordinates.
    void setLine(double x, double top, double bottom);
    void setActive(bool active);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

    static constexpr int kLetterHeight = 16;  ///< height above the line [px]

private:
    QString letter_;
    double height_ = 0;
    bool active_ = false;
};

/// A lane that shows states over time. Motion is blue. Wide segments contain a text.
class LaneItem : public QGraphicsItem {
public:
    /// name  shown on the left; may be empty
    explicit LaneItem(const QString& name = {});

    static constexpr int kNameWidth = 54;  ///< [px]

    void setView(const QRectF& area, double t0, double t1);
    void setSegments(std::vector<LaneSegment> segments);
    const std::vector<LaneSegment>& segments() const { return segments_; }
    const QRectF& area() const { return area_; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QString name_;
    QRectF area_;
    double t0_ = 0;
    double t1_ = 1;
    std::vector<LaneSegment> segments_;
};

}  // namespace tiller
