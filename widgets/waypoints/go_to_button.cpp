// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/go_to_button.h"

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

#include "robot/station/link/move_time.h"
#include "robot/station/text/texts.h"
#include "widgets/common/list_typing.h"
#include "widgets/common/text_entry.h"

namespace tiller {
namespace {

bool typingSomewhere() {
    const QWidget* focus = QApplication::focusWidget();
    return takesText(focus) || ListTyping::isAt(focus) || qobject_cast<const QLineEdit*>(focus) != nullptr ||
           qobject_cast<const QComboBox*>(focus) != nullptr;
}

}  // namespace

GoToButton::GoToButton(MotionPort port, HoldPolicy& policy, Target target, QWidget* parent)
    : HoldToRunButton(tr("Go to (hold)  G"), policy, parent)
    , port_(std::move(port))
    , target_(std::move(target)) {
    setObjectName(QStringLiteral("waypoint.goTo"));
    setAccessibleName(tr("Go to, hold"));
    setToolTip(
        tr("Moves the arm to the selected waypoint while the button or G is held, no faster than the jog "
           "speed"));
    setWidestDetail(QStringLiteral("000 mm/s"));
    setMotion({
        .begin = [this] { return begin(); },
        .hold = [this](HoldMotion::Id id) { return port_.hold(id); },
        .end = [this](HoldMotion::Id id, control::StopCause cause) { port_.endMotion(id, cause); },
        .runsToEnd = {},
        .bounds = [this] { return bounds_; },
    });
    connect(&guard(), &HoldGuard::refused, this, [this](const Error& error) {
        const bool said = error.code == ErrorCode::NoSolution || error.code == ErrorCode::Cancelled;
        Q_EMIT refused(said ? error.context : texts::errorText(error), error.code == ErrorCode::Cancelled);
    });
}

GoToButton::~GoToButton() {
    stop(control::StopCause::WindowClosed);
}

void GoToButton::setState(const SessionState& state) {
    state_ = state;
    setConfirmed(isHolding() && state.moving);
}

Result<MotionPort::Id> GoToButton::begin() {
    const Result<MoveRequest> request = target_();
    if (!request) {
        return request.error();
    }
    const bool linear = request->kind == MoveRequest::Kind::MoveL;
    bounds_ = {HoldBounds::longestOf(moveSeconds(*request, state_)),
               HoldBounds::holdTimeoutAt(linear ? request->speed : 0, linear ? 0 : request->speed)};
    return port_.beginMove(*request);
}

bool GoToButton::takeKey(const QKeyEvent& key) {
    const KeyCode code = PhysicalKeys::codeOf(key);
    const bool press = key.type() == QEvent::KeyPress;
    if (!key_.isEmpty() && !key_.isDown(code)) {
        // Another key was pressed or released in addition to the held key. Pressing two keys does not count
        // as holding. A release without a matching press may have been the release of the held key.
        if (!key.isAutoRepeat()) {
            guard().tell(press ? HoldEvent::Kind::OtherKey : HoldEvent::Kind::Unmatched);
        }
        return false;
    }
    if (key_.isDown(code)) {
        // The key code identifies the held key independently of modifiers and layout.
        switch (key_.take(key, Qt::Key_G)) {
            case PhysicalKeys::Change::Up:
                guard().release();
                break;
            case PhysicalKeys::Change::DownAgain:
                guard().tell(HoldEvent::Kind::Unmatched);
                break;
            default:
                break;
        }
        return true;
    }
    if (!press || PhysicalKeys::keyOf(key) != Qt::Key_G || key.modifiers() != Qt::NoModifier ||
        !window()->isActiveWindow() || QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr || typingSomewhere()) {
        return false;
    }
    if (key_.take(key, Qt::Key_G) == PhysicalKeys::Change::Down) {
        guard().press({HoldSource::By::Keys, {code}});
    }
    return true;
}

bool GoToButton::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    // A key event is delivered to the native window and then to the widget. Process it only once.
    if (isKey && watched->isWidgetType() && takeKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    // Check every window, because the panel of this button may have moved to another window since the press.
    if (event->type() == QEvent::WindowDeactivate && !key_.isEmpty() && watched->isWidgetType() &&
        static_cast<QWidget*>(watched)->isWindow()) {
        key_.clear();  // the release of the key will not be received
        if (watched != window()) {
            guard().stop(control::StopCause::WindowDeactivated);
        }
    }
    return HoldToRunButton::eventFilter(watched, event);
}

void GoToButton::showEvent(QShowEvent* event) {
    qApp->installEventFilter(this);
    HoldToRunButton::showEvent(event);
}

void GoToButton::hideEvent(QHideEvent* event) {
    qApp->removeEventFilter(this);
    key_.clear();
    HoldToRunButton::hideEvent(event);
}

}  // namespace tiller

#include "moc_go_to_button.cpp"
