// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small symbols before the text of a state, drawn as paths so that they follow the theme.

#include <QRectF>

#include "widgets/common/state_chip.h"

class QPainter;

namespace tiller {

/// ink     colour of the symbol
/// ground  background colour, for cutouts in a filled symbol
/// mark    up to two letters: inside an octagon instead of the exclamation mark, otherwise to its right
void drawShape(QPainter& painter, StateChip::Shape shape, const QRectF& box, const QColor& ink,
               const QColor& ground, const QString& mark = {});

}  // namespace tiller
