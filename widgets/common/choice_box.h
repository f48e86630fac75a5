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
        // This delegate uses the row height of the style sheet, unlike the default delegate of the combo box.
        setItemDelegate(new QStyledItemDelegate(this));
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace tiller
