// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Space and Esc stop everything while we are in control, from every window of the application and whatever has the
// focus: the arm that moves through us, and a program that is not ours. While we only monitor, both keys belong to the
// focused control. One object serves the whole application; while it lives, it sees every key first.
//
// Qt drops the key events of a window that a modal dialog blocks before any event filter, and window managers let such
// a window keep the keyboard. Qt still looks up shortcuts there: each modal dialog gets application-wide shortcuts for
// the stop keys. They fire in blocked windows only, because a window that is not blocked claims the keys beforehand
// (ShortcutOverride) and gets them as plain key presses.

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <vector>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"

class QKeyEvent;
class QWidget;

namespace tiller {

class RobotSession;
struct SessionState;

class StopKeys : public QObject {
    Q_OBJECT

public:
    enum class Use {
        Control,         ///< the key belongs to the focused control
        StopAndControl,  ///< nothing moves: it stops, and the focused control gets it as well
        StopOnly,        ///< something moves or may be about to: the key means stop and nothing else
    };

    /// use  asked at each press
    StopKeys(std::function<void(control::StopCause)> stop, std::function<Use()> use,
             QObject* parent = nullptr);
    /// clock  for the reflex after a motion
    explicit StopKeys(RobotSession& session, const Clock& clock = SteadyClock::shared(),
                      QObject* parent = nullptr);
    ~StopKeys() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// How long after a motion the keys still mean nothing but stop [ms].
    static constexpr int kReflexMs = 1000;
    /// How long they still stop after control was lost: the operator has to notice it first [ms].
    static constexpr int kControlLostMs = 3000;
    void follow(const SessionState& state, std::int64_t nowNs);
    Use useAt(std::int64_t nowNs) const;
    bool controlIsJustLost(std::int64_t nowNs) const;
    bool press(const QKeyEvent& key);
    void addShortcuts(QWidget& modal);

    std::function<void(control::StopCause)> stop_;
    std::function<Use()> use_;
    std::vector<QPointer<QWidget>> modals_;  ///< those that have the shortcuts
    int claimedKey_ = 0;                     ///< pressed last as a stop key that means nothing else; 0: none

    bool owned_ = false;  ///< in control, or taking it, at the last state
    bool inControl_ = false;
    std::optional<std::int64_t> controlLostNs_;  ///< not by giving it back
    std::optional<std::int64_t> lastMotionNs_;   ///< while in control, or shortly after
    bool dark_ = false;                          ///< no data come: the arm's motion is not known
    bool movedBeforeDark_ = false;               ///< it moved when they ended, or a moment before
    std::optional<std::int64_t> stoppedDarkNs_;  ///< the first stop since
};

}  // namespace tiller
