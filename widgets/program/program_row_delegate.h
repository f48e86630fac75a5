// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the rows of the program and of the step palette. The rows are compact, because a program has many
// steps. With Touch density, they are tall enough for touch input.

#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/common/density.h"

namespace tiller {

class ProgramRowDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int height = rowHeight(currentDensity() == Density::Touch ? Density::Touch : Density::Compact);
        const QSize hint = QStyledItemDelegate::sizeHint(option, index);
        return {hint.width(), std::max(hint.height(), height)};
    }
};

}  // namespace tiller
