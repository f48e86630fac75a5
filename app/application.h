// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The application object. It passes key events to KeyRepeat before shortcuts and event filters receive them.

#include <QApplication>
#include <QPointer>

#include "widgets/hold/key_repeat.h"

namespace tiller::app {

/// Threads  GUI
class Application final : public QApplication {
public:
    using QApplication::QApplication;

    /// The KeyRepeat must be deleted before the application. Its deletion resets the pointer.
    void setKeyRepeat(KeyRepeat* keyRepeat) { keyRepeat_ = keyRepeat; }
    bool notify(QObject* receiver, QEvent* event) override {
        // Check the event type, because other threads also call notify(), and key events are only delivered
        // in the GUI thread.
        const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease ||
                           event->type() == QEvent::ShortcutOverride;
        return (isKey && keyRepeat_ != nullptr && keyRepeat_->intercepts(*receiver, *event)) ||
               QApplication::notify(receiver, event);
    }

private:
    QPointer<KeyRepeat> keyRepeat_;
};

}  // namespace tiller::app
