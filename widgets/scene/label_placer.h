// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds places for names beside the marks of a picture, so that no name covers another name or a mark.

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <optional>
#include <vector>

namespace tiller {

/// A name where it is drawn.
struct PlacedLabel {
    QString text;
    QPointF mark;  ///< what it is the name of [px]
    QRectF box;
    bool selected = false;
};

class LabelPlacer {
public:
    /// area  names stay inside it
    explicit LabelPlacer(const QRectF& area) : area_(area) {}

    /// Nothing is written there.
    void block(const QRectF& box) { taken_.push_back(box); }
    /// Below the mark; where that is taken beside it, above it, or a row further away. The place is taken from
    /// then on.
    /// Returns  nothing when there is no free place
    std::optional<QRectF> place(const QPointF& mark, const QSizeF& size);

private:
    QRectF area_;
    std::vector<QRectF> taken_;
};

}  // namespace tiller
