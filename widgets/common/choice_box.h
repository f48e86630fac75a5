// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QStyledItemDelegate>
#include <QWheelEvent>

namespace tiller {

/// A list to choose from that the wheel never changes.
class ChoiceBox : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr) : QComboBox(parent) {
        // This one takes the height of its rows from the style sheet, the combo box's own does not.
        setItemDelegate(new QStyledItemDelegate(this));
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace tiller
