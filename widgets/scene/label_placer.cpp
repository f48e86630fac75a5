// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/label_placer.h"

#include <algorithm>
#include <array>

namespace tiller {

std::optional<QRectF> LabelPlacer::place(const QPointF& mark, const QSizeF& size) {
    constexpr double kSideDistance = 10;  // distance of the label from the centre of the mark [px]
    constexpr double kApart = 2;
    const double w = size.width();
    const double h = size.height();
    const double row = h + kApart;
    // Candidate positions. Labels at the sides leave space for a label below and a label above the mark. A
    // line connects a more distant label with the mark.
    const std::array<QPointF, 8> corners = {QPointF(-w / 2, row / 2),
                                            QPointF(kSideDistance, -h / 2),
                                            QPointF(-w - kSideDistance, -h / 2),
                                            QPointF(-w / 2, -row / 2 - h),
                                            QPointF(-w / 2, row / 2 + row),
                                            QPointF(-w / 2, -row / 2 - h - row),
                                            QPointF(-w / 2, row / 2 + 2 * row),
                                            QPointF(-w / 2, -row / 2 - h - 2 * row)};
    for (const QPointF& corner : corners) {
        const QRectF box(mark + corner, size);
        const bool free =
            area_.contains(box) &&
            std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& t) { return t.intersects(box); });
        if (free) {
            taken_.push_back(box);
            return box;
        }
    }
    return std::nullopt;
}

}  // namespace tiller
