// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The small shapes that stand in front of a state's words, drawn from paths so that they follow the theme.

#include <QRectF>

#include "widgets/common/state_chip.h"

class QPainter;

namespace tiller {

/// ink     colour of the shape
/// ground  colour behind it, for marks cut out of a filled shape
/// mark    up to two letters: inside an octagon in place of its exclamation mark, else at its right
void drawShape(QPainter& painter, StateChip::Shape shape, const QRectF& box, const QColor& ink,
               const QColor& ground, const QString& mark = {});

}  // namespace tiller
