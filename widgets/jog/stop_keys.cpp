// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/stop_keys.h"

#include <QApplication>
#include <QInputMethodQueryEvent>
#include <QKeyEvent>
#include <QShortcut>
#include <algorithm>
#include <utility>

#include "robot/station/link/robot_session.h"

namespace tiller {

using control::StopCause;

namespace {

bool isStopKey(const QKeyEvent& event) {
    return event.key() == Qt::Key_Space || event.key() == Qt::Key_Escape;
}

bool isYounger(const std::optional<std::int64_t>& sinceNs, std::int64_t nowNs, int ms) {
    return sinceNs && nowNs - *sinceNs < ms * kNsPerMs;
}

/// Returns the sequences of this key with all combinations of modifiers.
QList<QKeySequence> sequencesOf(Qt::Key key) {
    constexpr Qt::KeyboardModifier kModifiers[] = {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier,
                                                   Qt::MetaModifier};
    QList<QKeySequence> sequences;
    for (unsigned mask = 0; mask < 1U << std::size(kModifiers); ++mask) {
        Qt::KeyboardModifiers modifiers;
        for (std::size_t i = 0; i < std::size(kModifiers); ++i) {
            modifiers.setFlag(kModifiers[i], (mask >> i & 1U) != 0);
        }
        sequences.append(QKeySequence(QKeyCombination(modifiers, key)));
    }
    return sequences;
}

}  // namespace

StopKeys::StopKeys(std::function<void(StopCause)> stop, std::function<Use()> use, QObject* parent)
    : QObject(parent), stop_(std::move(stop)), use_(std::move(use)) {
    // The event filter would not receive key presses in native dialogs.
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
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
          [this, &clock] { return useAt(clock.nowNs()); }, parent) {
    connect(&session, &RobotSession::stateChanged, this,
            [this, &clock](const SessionState& state) { follow(state, clock.nowNs()); });
}

void StopKeys::follow(const SessionState& state, std::int64_t nowNs) {
    const bool typed = useAt(nowNs) != Use::StopOnly;
    const bool owned = state.control == ControlState::InControl || state.control == ControlState::Taking;
    if (owned) {
        controlLostNs_.reset();
    } else if (owned_ && state.controlLoss != control::ControlLoss::Released) {
        controlLostNs_ = nowNs;
    }
    owned_ = owned;
    const bool inControl = state.keysStop();
    inControl_ = inControl;
    const bool dark = state.link == LinkState::Stale || state.link == LinkState::Lost;
    if (dark && !dark_) {
        movedBeforeDark_ = isYounger(lastMotionNs_, nowNs, kReflexMs);
        stoppedDarkNs_.reset();
    }
    dark_ = dark;
    // While Tiller takes control, an external program is being replaced and may move the arm at any time.
    const bool mayMove = state.moving || state.motionActive || state.foreignProgramRuns() ||
                         state.control == ControlState::Taking;
    if (!dark && mayMove && (inControl || controlIsJustLost(nowNs))) {
        lastMotionNs_ = nowNs;
    }
    if (const bool types = useAt(nowNs) != Use::StopOnly; types != typed) {
        // Commit the text, because input methods receive keys before the window does (see eventFilter()).
        if (!types) {
            QGuiApplication::inputMethod()->commit();
        }
        QGuiApplication::inputMethod()->update(Qt::ImEnabled);
    }
}

StopKeys::Use StopKeys::useAt(std::int64_t nowNs) const {
    if (dark_ && movedBeforeDark_) {
        // The arm may still be moving. Until kReflexMs after the stop, the keys only stop the arm.
        return !stoppedDarkNs_ || isYounger(stoppedDarkNs_, nowNs, kReflexMs) ? Use::StopOnly
                                                                              : Use::StopAndControl;
    }
    if (!inControl_ && !controlIsJustLost(nowNs)) {
        return Use::Control;
    }
    // A press up to kReflexMs after a motion is also intended as a stop, because the state is delayed and the
    // operator needs time to react.
    return isYounger(lastMotionNs_, nowNs, kReflexMs) ? Use::StopOnly : Use::StopAndControl;
}

bool StopKeys::controlIsJustLost(std::int64_t nowNs) const {
    return isYounger(controlLostNs_, nowNs, kControlLostMs);
}

StopKeys::~StopKeys() {
    qApp->removeEventFilter(this);
}

bool StopKeys::press(const QKeyEvent& key) {
    if (key.isAutoRepeat()) {
        return key.key() == claimedKey_;
    }
    const Use use = use_();
    claimedKey_ = use == Use::StopOnly ? key.key() : 0;
    if (use != Use::Control) {
        stop_(key.key() == Qt::Key_Space ? StopCause::Space : StopCause::Escape);
    }
    return use == Use::StopOnly;
}

void StopKeys::addShortcuts(QWidget& modal) {
    std::erase_if(modals_, [](const QPointer<QWidget>& each) { return each.isNull(); });
    if (std::find(modals_.begin(), modals_.end(), &modal) != modals_.end()) {
        return;
    }
    modals_.emplace_back(&modal);
    for (const auto& [key, cause] :
         {std::pair{Qt::Key_Space, StopCause::Space}, {Qt::Key_Escape, StopCause::Escape}}) {
        auto* shortcut = new QShortcut(&modal);
        shortcut->setContext(Qt::ApplicationShortcut);
        shortcut->setAutoRepeat(false);
        shortcut->setKeys(sequencesOf(key));
        const auto stop = [this, cause = cause] {
            if (use_() != Use::Control) {
                stop_(cause);
            }
        };
        connect(shortcut, &QShortcut::activated, this, stop);
        connect(shortcut, &QShortcut::activatedAmbiguously, this, stop);
    }
}

bool StopKeys::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::WindowBlocked:
            if (QWidget* modal = QApplication::activeModalWidget()) {
                addShortcuts(*modal);
            }
            return false;
        case QEvent::ShortcutOverride:
            if (!isStopKey(*static_cast<QKeyEvent*>(event))) {
                return false;
            }
            event->accept();  // deliver it as a key press instead of a shortcut
            return true;
        case QEvent::KeyPress:
            return watched->isWidgetType() && isStopKey(*static_cast<QKeyEvent*>(event)) &&
                   press(*static_cast<QKeyEvent*>(event));
        case QEvent::InputMethodQuery: {
            // Disable input methods while the keys only stop the arm, so that they do not consume the stop
            // keys.
            auto* query = static_cast<QInputMethodQueryEvent*>(event);
            if (!query->queries().testFlag(Qt::ImEnabled) || use_() != Use::StopOnly) {
                return false;
            }
            watched->event(event);
            query->setValue(Qt::ImEnabled, false);
            return true;
        }
        default:
            return false;
    }
}

}  // namespace tiller

#include "moc_stop_keys.cpp"
