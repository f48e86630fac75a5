// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row of keys that is there only where there is room for it: it never makes a panel larger.

#include <QWidget>

namespace tiller {

class FoldingRow : public QWidget {
public:
    explicit FoldingRow(QWidget* parent = nullptr) : QWidget(parent) {
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Maximum);
    }

    QSize minimumSizeHint() const override { return {0, 0}; }
    /// room  in the panel, without what else it has to show [px]. What is held in a row that goes away ends.
    void fitInto(const QSize& room) {
        const QSize wanted = sizeHint();
        setVisible(room.width() >= wanted.width() && room.height() >= wanted.height());
    }
};

}  // namespace tiller
