// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Auto-repeat on X11. The server sends each repetition of a held key as a release and a press with the same
// time stamp. Qt marks the release as auto-repeat only if it has already received the press. On a busy
// computer, a repetition therefore looks like a release and a new press, which ends a hold or triggers a
// shortcut again.

#include <QKeyEvent>
#include <QPointer>
#include <QTimer>
#include <QWindow>
#include <cstdint>
#include <memory>

#include "robot/core/clock.h"
#include "widgets/hold/physical_keys.h"

namespace tiller {

class KeyStateProbe;

/// Delays the release of a key until the key-state check has replied, for at most `kLongestMs`. If the key is
/// still pressed, the release and the following press are delivered as auto-repeat events.
/// Threads  GUI
class KeyRepeat : public QObject {
    Q_OBJECT

public:
    explicit KeyRepeat(const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~KeyRepeat() override;

    /// Sets the key-state check. Without it, all events pass unchanged.
    void setProbe(KeyStateProbe* probe);
    /// Must be called with every event before the event is delivered. Returns true if the event must not be
    /// delivered.
    bool intercepts(QObject& receiver, QEvent& event);
    /// Evaluates the reply of the key-state check. A timer calls it every millisecond while a release is
    /// delayed.
    void poll();

    static constexpr int kLongestMs = 10;

private:
    struct Release {
        QPointer<QWindow> window;
        std::unique_ptr<QKeyEvent> event;
        KeyCode code = 0;
        std::int64_t sinceNs = 0;
        bool isRepeat = false;
    };

    bool delays(QWindow& window, const QKeyEvent& event);
    bool isRepeatOf(const Release& release, const QKeyEvent& press) const;
    void deliverRepeat(const QKeyEvent& press);
    void deliver();

    const Clock& clock_;
    KeyStateProbe* probe_ = nullptr;
    std::unique_ptr<Release> release_;
    QTimer timer_;
    bool delivering_ = false;
};

}  // namespace tiller
