// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPushButton>

namespace tiller {

/// For buttons that trigger an action. Return or Enter clicks the button once per press. Space is reserved
/// for stopping the arm.
/// Returns  true if the event was handled, i.e. the key is Return or Enter
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

/// A push button that ignores Space, which stops the arm.
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
