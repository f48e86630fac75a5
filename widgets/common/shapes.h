// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The small shapes that stand in front of a state's words, drawn from paths so that they follow the theme.

#include <QRectF>

#include "widgets/common/state_chip.h"

class QPainter;

namespace tiller {

/// ink     colour of the shape
/// ground  colour behind it, for marks cut out of a filled shape
void drawShape(QPainter& painter, StateChip::Shape shape, const QRectF& box, const QColor& ink,
               const QColor& ground);

}  // namespace tiller
