// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row of buttons that is hidden if there is not enough space, so that the row does not enlarge the panel.

#include <QWidget>

namespace tiller {

class FoldingRow : public QWidget {
public:
    explicit FoldingRow(QWidget* parent = nullptr) : QWidget(parent) {
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
    }

    QSize minimumSizeHint() const override { return {0, 0}; }
    /// Shows or hides the row. Hiding it ends a hold-to-run motion started by its buttons.
    /// room  space that the other content of the panel leaves for the row [px]
    void fitInto(const QSize& room) {
        const QSize wanted = sizeHint();
        setVisible(room.width() >= wanted.width() && room.height() >= wanted.height());
    }
};

}  // namespace tiller
