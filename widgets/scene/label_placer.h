// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Places the labels of marks in an image, without covering other labels or marks.

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <optional>
#include <vector>

namespace tiller {

/// A label and its rectangle in the image.
struct PlacedLabel {
    QString text;
    QPointF mark;  ///< position of the labelled mark [px]
    QRectF box;
    bool selected = false;
};

class LabelPlacer {
public:
    /// area  labels are placed within this rectangle [px]
    explicit LabelPlacer(const QRectF& area) : area_(area) {}

    /// Keeps this rectangle free.
    void block(const QRectF& box) { taken_.push_back(box); }
    /// Finds a free position below the mark, otherwise next to it, above it, or farther away, and marks the
    /// returned rectangle as occupied.
    /// Returns  empty if there is no free position
    std::optional<QRectF> place(const QPointF& mark, const QSizeF& size);

private:
    QRectF area_;
    std::vector<QRectF> taken_;
};

}  // namespace tiller
