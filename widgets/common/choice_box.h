// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QStyledItemDelegate>
#include <QWheelEvent>

namespace tiller {

/// A combo box that ignores the mouse wheel.
class ChoiceBox : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr) : QComboBox(parent) {
        // The default delegate of a combo box ignores the row height of the style sheet.
        setItemDelegate(new QStyledItemDelegate(this));
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace tiller
