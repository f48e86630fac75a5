// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small symbols in front of the text of a state, drawn as paths in the colours of the theme.

#include <QRectF>

#include "widgets/common/state_chip.h"

class QPainter;

namespace tiller {

/// ink     colour of the symbol
/// ground  background colour, for cutouts in a filled symbol
/// mark    up to two letters, drawn in an octagon instead of the exclamation mark, or to the right of any
///         other symbol
void drawShape(QPainter& painter, StateChip::Shape shape, const QRectF& box, const QColor& ink,
               const QColor& ground, const QString& mark = {});

}  // namespace tiller
