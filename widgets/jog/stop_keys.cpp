// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/stop_keys.h"

#include <QApplication>
#include <QKeyEvent>

#include "widgets/common/text_entry.h"
#include "widgets/session/robot_session.h"

namespace tiller {

using control::StopCause;

StopKeys::StopKeys(std::function<void(StopCause)> stop, std::function<bool()> moving, QObject* parent)
    : QObject(parent), stop_(std::move(stop)), moving_(std::move(moving)) {
    qApp->installEventFilter(this);
}

StopKeys::StopKeys(RobotSession& session, const Clock& clock, QObject* parent)
    : StopKeys(
          [this, &session, &clock](StopCause cause) {
              if (dark_ && !stoppedDarkNs_) {
                  stoppedDarkNs_ = clock.nowNs();
              }
              session.stop(cause);
          },
          [this, &clock] {
              const std::int64_t now = clock.nowNs();
              if (dark_) {
                  // What moved then may move on: until the stop has had its time the keys mean nothing else.
                  return movedBeforeDark_ && (!stoppedDarkNs_ || isReflex(*stoppedDarkNs_, now));
              }
              // The state is a picture some milliseconds old: a reflex just after standstill means stop as
              // well.
              return lastMotionNs_ && isReflex(*lastMotionNs_, now);
          },
          parent) {
    connect(&session, &RobotSession::stateChanged, this,
            [this, &clock](const SessionState& state) { follow(state, clock.nowNs()); });
}

void StopKeys::follow(const SessionState& state, std::int64_t nowNs) {
    const bool dark = state.link == LinkState::Stale || state.link == LinkState::Lost;
    if (dark && !dark_) {
        movedBeforeDark_ = lastMotionNs_ && isReflex(*lastMotionNs_, nowNs);
        stoppedDarkNs_.reset();
    }
    dark_ = dark;
    // A program of others, and one that is being replaced by ours, may move the arm any moment.
    const bool mayMove = state.moving || state.motionActive || state.foreignProgramRuns() ||
                         state.control == ControlState::Taking;
    if (!dark && mayMove) {
        lastMotionNs_ = nowNs;
    }
}

bool StopKeys::isReflex(std::int64_t sinceNs, std::int64_t nowNs) const {
    return nowNs - sinceNs < kReflexMs * kNsPerMs;
}

StopKeys::~StopKeys() {
    qApp->removeEventFilter(this);
}

bool StopKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) {
        return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool space = key->key() == Qt::Key_Space;
    if ((!space && key->key() != Qt::Key_Escape) || key->isAutoRepeat()) {
        return false;
    }
    const bool moving = moving_();
    if (space && !moving && takesText(QApplication::focusWidget())) {
        return false;  // a space in a name is a space
    }
    stop_(space ? StopCause::Space : StopCause::Escape);
    // While something moves the key means stop and nothing else: it must not press a focused button as well.
    return moving;
}

}  // namespace tiller

#include "moc_stop_keys.cpp"
