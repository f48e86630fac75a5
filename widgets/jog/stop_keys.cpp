// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/stop_keys.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "widgets/session/robot_session.h"

namespace tiller {

using control::StopCause;

namespace {

bool takesText(const QWidget* widget) {
    if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        return !line->isReadOnly();
    }
    return qobject_cast<const QTextEdit*>(widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

}  // namespace

StopKeys::StopKeys(std::function<void(StopCause)> stop, std::function<bool()> moving, QObject* parent)
    : QObject(parent), stop_(std::move(stop)), moving_(std::move(moving)) {
    qApp->installEventFilter(this);
}

StopKeys::StopKeys(RobotSession& session, const Clock& clock, QObject* parent)
    : StopKeys([&session](StopCause cause) { session.stop(cause); },
               [this, &session, &clock] {
                   // The state is a picture some milliseconds old, and none at all without data: a reflex
                   // just after standstill means stop as well.
                   const SessionState& state = session.state();
                   const bool unknown = state.link == LinkState::Stale || state.link == LinkState::Lost;
                   return unknown || mayMove(state) ||
                          (lastMotionNs_ && clock.nowNs() - *lastMotionNs_ < kReflexMs * kNsPerMs);
               },
               parent) {
    connect(&session, &RobotSession::stateChanged, this, [this, &clock](const SessionState& state) {
        if (mayMove(state)) {
            lastMotionNs_ = clock.nowNs();
        }
    });
}

bool StopKeys::mayMove(const SessionState& state) {
    return state.moving || state.motionActive;
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
