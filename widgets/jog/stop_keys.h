// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Space and Esc stop all motion while this program is in control, in every window of the application and with any
// focus: motions of this program, and other programs on the robot. While only monitoring, both keys belong to the
// focus widget. One object serves the whole application; during its lifetime it receives every key first.
//
// Qt drops the key events of a window that is blocked by a modal dialog before any event filter, and window
// managers let such a window keep the keyboard. Qt still looks up shortcuts there: each modal dialog gets
// application-wide shortcuts for the stop keys. They trigger in blocked windows only, because other windows claim
// the keys beforehand (ShortcutOverride) and receive them as plain key presses.

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
        Control,         ///< the key belongs to the focus widget
        StopAndControl,  ///< no motion: the key stops, and the focus widget receives it as well
        StopOnly,        ///< actual or possible motion: the key only stops
    };

    /// use  called at each press
    StopKeys(std::function<void(control::StopCause)> stop, std::function<Use()> use,
             QObject* parent = nullptr);
    /// clock  for the time after a motion
    explicit StopKeys(RobotSession& session, const Clock& clock = SteadyClock::shared(),
                      QObject* parent = nullptr);
    ~StopKeys() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Time after a motion during which the keys only stop [ms].
    static constexpr int kReflexMs = 1000;
    /// Time after a loss of control during which the keys still stop, because the operator has to notice it first
    /// [ms].
    static constexpr int kControlLostMs = 3000;
    void follow(const SessionState& state, std::int64_t nowNs);
    Use useAt(std::int64_t nowNs) const;
    bool controlIsJustLost(std::int64_t nowNs) const;
    bool press(const QKeyEvent& key);
    void addShortcuts(QWidget& modal);

    std::function<void(control::StopCause)> stop_;
    std::function<Use()> use_;
    std::vector<QPointer<QWidget>> modals_;  ///< modal dialogs with the shortcuts
    int claimedKey_ = 0;                     ///< last pressed stop key without another function; 0: none

    bool owned_ = false;  ///< true if in control or taking control at the last state
    bool inControl_ = false;
    std::optional<std::int64_t> controlLostNs_;  ///< time of the loss; not set if control was released
    std::optional<std::int64_t> lastMotionNs_;   ///< last motion while in control, or shortly after
    bool dark_ = false;                          ///< no data: the motion of the arm is unknown
    bool movedBeforeDark_ = false;               ///< the arm moved when the data ended, or shortly before
    std::optional<std::int64_t> stoppedDarkNs_;  ///< time of the first stop since the data ended
};

}  // namespace tiller
