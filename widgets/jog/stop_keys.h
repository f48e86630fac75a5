// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Esc and Space stop the arm from anywhere in the application, whatever has the focus: what moves through us,
// and a program that is not ours. One object serves the whole application; while it lives, it sees every key
// first.

#include <QObject>
#include <functional>
#include <optional>

#include "robot/control/motion_types.h"
#include "robot/core/clock.h"

namespace tiller {

class RobotSession;
struct SessionState;

class StopKeys : public QObject {
    Q_OBJECT

public:
    /// moving  true while something moves or may be about to
    StopKeys(std::function<void(control::StopCause)> stop, std::function<bool()> moving,
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
    void follow(const SessionState& state, std::int64_t nowNs);
    bool isReflex(std::int64_t sinceNs, std::int64_t nowNs) const;

    std::function<void(control::StopCause)> stop_;
    std::function<bool()> moving_;
    std::optional<std::int64_t> lastMotionNs_;
    bool dark_ = false;                          ///< no data come: what the arm does is not known
    bool movedBeforeDark_ = false;               ///< it moved when they ended, or a moment before
    std::optional<std::int64_t> stoppedDarkNs_;  ///< the first stop since
};

}  // namespace tiller
