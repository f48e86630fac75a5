// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// While this application is in control, Space and Esc stop all motion, in every window of the application and
// with any focus widget. They stop motions of this application and of other programs on the robot. While the
// application only monitors, the focus widget receives both keys. One object serves the whole application.
// During its lifetime, it receives every key first.
//
// If a modal dialog blocks a window, Qt discards the key events of this window before calling any event
// filter, although some window managers let the window keep the keyboard focus. Qt still evaluates shortcuts
// in the blocked window, so each modal dialog gets application-wide shortcuts for the stop keys. The
// shortcuts trigger only in blocked windows, because other windows accept the keys beforehand
// (ShortcutOverride) and receive them as plain key presses.

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
        Control,         ///< only the focus widget receives the key
        StopAndControl,  ///< no motion: the key stops the arm, and the focus widget also receives it
        StopOnly,        ///< actual or possible motion: the key only stops the arm
    };

    /// use  called at each press of a stop key
    StopKeys(std::function<void(control::StopCause)> stop, std::function<Use()> use,
             QObject* parent = nullptr);
    /// clock  measures the time since a motion
    explicit StopKeys(RobotSession& session, const Clock& clock = SteadyClock::shared(),
                      QObject* parent = nullptr);
    ~StopKeys() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Time after a motion during which the keys only stop [ms].
    static constexpr int kReflexMs = 1000;
    /// Time after a loss of control during which the keys still stop the arm, because the operator may not
    /// have noticed the loss [ms].
    static constexpr int kControlLostMs = 3000;
    void follow(const SessionState& state, std::int64_t nowNs);
    Use useAt(std::int64_t nowNs) const;
    bool controlIsJustLost(std::int64_t nowNs) const;
    bool press(const QKeyEvent& key);
    void addShortcuts(QWidget& modal);

    std::function<void(control::StopCause)> stop_;
    std::function<Use()> use_;
    std::vector<QPointer<QWidget>> modals_;  ///< modal dialogs that have the shortcuts
    int claimedKey_ = 0;  ///< last stop key that was pressed, if the focus widget did not receive it;
                          ///< otherwise 0

    bool owned_ = false;  ///< in control or taking control in the last state
    bool inControl_ = false;
    std::optional<std::int64_t>
        controlLostNs_;  ///< time of the loss of control; empty if control was released
    std::optional<std::int64_t> lastMotionNs_;  ///< time of the last motion while in control, or up to
                                                ///< kControlLostMs after a loss of control
    bool dark_ = false;             ///< robot data are stale or lost, so the motion of the arm is unknown
    bool movedBeforeDark_ = false;  ///< the arm moved less than kReflexMs before the robot data were lost
    std::optional<std::int64_t>
        stoppedDarkNs_;  ///< time of the first stop request since the robot data were lost
};

}  // namespace tiller
