// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPushButton>

namespace tiller {

/// For keys that set something going: Enter presses it, once for each press; Space stops the arm everywhere and
/// presses nothing.
/// Returns  true where the event was one of these keys, and has been dealt with
inline bool pressByEnter(QAbstractButton& button, QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!event.isAutoRepeat()) {
                button.click();
            }
            return true;
        case Qt::Key_Space:
            event.ignore();
            return true;
        default:
            return false;
    }
}

/// A key with words on it that Space does not press.
class EnterKey : public QPushButton {
public:
    using QPushButton::QPushButton;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (!pressByEnter(*this, *event)) {
            QPushButton::keyPressEvent(event);
        }
    }
};

}  // namespace tiller
