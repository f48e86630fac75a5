// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/hold_rules.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/common/stop_mark.h"
#include "widgets/common/text_entry.h"
#include "widgets/hold/hold_guard.h"
#include "widgets/hold/key_state_probe.h"
#include "widgets/hold/native_window_event.h"

namespace tiller {

using control::StopCause;
using Kind = HoldEvent::Kind;

namespace {

/// Maximum time between two refreshes, and between two replies of the key-state check. A longer gap ends the
/// motion.
constexpr std::int64_t kStallNs = std::chrono::nanoseconds(control::kHoldTime).count();

bool isEvent(const HoldEvent& news, QEvent::Type type) {
    return news.kind == Kind::Event && news.event->type() == type;
}

/// A press is delivered first to the native window and then to the widget. Evaluate it at the widget, which
/// may be a hold-to-run button.
bool isAtWidget(const HoldEvent& news) {
    return news.watched->isWidgetType();
}

/// Determines the cause of a press during a hold. A press on STOP ends the hold before STOP receives it.
StopCause causeOfPressOn(const QObject& widget) {
    return widget.property(kStopButtonProperty).toBool() ? StopCause::StopButton : StopCause::SecondButton;
}

bool isKeyPress(const HoldEvent& news, Qt::Key key) {
    if (!isEvent(news, QEvent::KeyPress) && !isEvent(news, QEvent::ShortcutOverride)) {
        return false;
    }
    const auto* pressed = static_cast<QKeyEvent*>(news.event);
    return pressed->key() == key && !pressed->isAutoRepeat();
}

bool isSignOfAWindow(const QWidget& widget) {
    return widget.isWindow() && widget.windowType() != Qt::ToolTip &&
           widget.windowType() != Qt::SplashScreen && widget.windowType() != Qt::Desktop;
}

bool isOverTheWindow(const QWidget& widget) {
    const Qt::WindowType type = widget.windowType();
    return widget.isVisible() && (type == Qt::Dialog || type == Qt::Sheet || type == Qt::Popup);
}

}  // namespace

// ---- rules -----------------------------------------------------------------------------------------------
//
// A rule checks an event and returns the cause that ends the motion, or None if the rule does not apply.

struct HoldRules::HoldRuleTable {
    using Rule = StopCause (*)(const HoldRules&, const HoldEvent&);
    using BeginRule = QString (*)(const HoldRules&, const QWidget*, const HoldSource&);
    struct Row {
        const char* name;
        Rule rule;
    };
    struct BeginRow {
        const char* name;
        BeginRule rule;
    };

    static StopCause when(bool applies, StopCause cause) { return applies ? cause : StopCause::None; }

    // actions of the operator

    static StopCause letGo(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::LetGo, StopCause::Released);
    }
    static StopCause pointerLeft(const HoldRules& h, const HoldEvent& n) {
        if (n.kind != Kind::PointerAt || h.key_ == nullptr) {
            return StopCause::None;
        }
        const int slack = kPointerSlack;
        return when(!h.key_->rect().adjusted(-slack, -slack, slack, slack).contains(n.position),
                    StopCause::PointerLeft);
    }
    static StopCause pressedAgain(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::PressedAgain, StopCause::SecondButton);
    }
    static StopCause otherKey(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::OtherKey, StopCause::SecondButton);
    }
    static StopCause modifier(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::Modifier, StopCause::SelectionChanged);
    }
    static StopCause unmatchedKey(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::Unmatched, StopCause::HoldUnproven);
    }

    // events in the application

    static StopCause escape(const HoldRules&, const HoldEvent& n) {
        return when(isKeyPress(n, Qt::Key_Escape), StopCause::Escape);
    }
    static StopCause space(const HoldRules&, const HoldEvent& n) {
        return when(isKeyPress(n, Qt::Key_Space), StopCause::Space);
    }
    static StopCause mousePressed(const HoldRules&, const HoldEvent& n) {
        const bool press = isEvent(n, QEvent::MouseButtonPress) || isEvent(n, QEvent::MouseButtonDblClick);
        return press && isAtWidget(n) ? causeOfPressOn(*n.watched) : StopCause::None;
    }
    static StopCause framePressed(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::NonClientAreaMouseButtonPress), StopCause::SecondButton);
    }
    static StopCause touched(const HoldRules&, const HoldEvent& n) {
        const bool touch = isEvent(n, QEvent::TouchBegin) && isAtWidget(n);
        return touch ? causeOfPressOn(*n.watched) : StopCause::None;
    }
    static StopCause penPressed(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::TabletPress) && isAtWidget(n), StopCause::SecondButton);
    }
    static StopCause touchCancelled(const HoldRules& h, const HoldEvent& n) {
        return when(isEvent(n, QEvent::TouchCancel) && n.watched == h.key_, StopCause::DeviceLost);
    }
    static StopCause keyDisabled(const HoldRules& h, const HoldEvent& n) {
        return when(isEvent(n, QEvent::EnabledChange) && n.watched == h.key_ && !h.key_->isEnabled(),
                    StopCause::ControlLost);
    }
    static StopCause keyHidden(const HoldRules& h, const HoldEvent& n) {
        return when(isEvent(n, QEvent::Hide) && n.watched == h.key_, h.hiddenCause());
    }
    static StopCause keyMoved(const HoldRules& h, const HoldEvent& n) {
        return when(isEvent(n, QEvent::ParentChange) && n.watched == h.key_, StopCause::WindowClosed);
    }
    static StopCause focusLost(const HoldRules& h, const HoldEvent& n) {
        if (!isEvent(n, QEvent::FocusOut) || n.watched != h.key_) {
            return StopCause::None;
        }
        // Disabling or hiding the button also removes its focus. Report the underlying reason.
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(n.event)->reason();
        if (!h.key_->isEnabled()) {
            return StopCause::ControlLost;
        }
        if (h.key_->window()->isHidden() || !h.key_->isVisible()) {
            return h.hiddenCause();
        }
        if (reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason) {
            return StopCause::DialogOpened;
        }
        return reason == Qt::ActiveWindowFocusReason ? StopCause::WindowDeactivated : StopCause::FocusLost;
    }
    static StopCause editorEntered(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::FocusIn) && takesText(qobject_cast<QWidget*>(n.watched)),
                    StopCause::FocusLost);
    }
    static StopCause windowDeactivated(const HoldRules& h, const HoldEvent& n) {
        const bool hidden = h.window_ != nullptr && h.window_->isHidden();
        return when(isEvent(n, QEvent::WindowDeactivate),
                    hidden ? StopCause::WindowClosed : StopCause::WindowDeactivated);
    }
    static StopCause windowFocusLost(const HoldRules&, const HoldEvent& n) {
        // A floating panel shares the activation state of its window, so only the focus change shows that the
        // operator switched to another window.
        return when(isEvent(n, QEvent::FocusOut) && n.watched->isWindowType(), StopCause::WindowDeactivated);
    }
    static StopCause windowMinimised(const HoldRules& h, const HoldEvent& n) {
        return when(
            isEvent(n, QEvent::WindowStateChange) && n.watched == h.window_ && h.window_->isMinimized(),
            StopCause::WindowDeactivated);
    }
    static StopCause windowHidden(const HoldRules& h, const HoldEvent& n) {
        return when(isEvent(n, QEvent::Hide) && n.watched == h.window_, StopCause::WindowClosed);
    }
    static StopCause windowClosed(const HoldRules&, const HoldEvent& n) {
        const auto* widget = qobject_cast<QWidget*>(n.watched);
        return when(isEvent(n, QEvent::Close) && widget != nullptr && isSignOfAWindow(*widget),
                    StopCause::WindowClosed);
    }
    static StopCause windowBlocked(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::WindowBlocked), StopCause::DialogOpened);
    }
    static StopCause windowOpened(const HoldRules&, const HoldEvent& n) {
        const auto* widget = qobject_cast<QWidget*>(n.watched);
        return when(isEvent(n, QEvent::Show) && widget != nullptr && isSignOfAWindow(*widget),
                    StopCause::DialogOpened);
    }
    static StopCause applicationLeft(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::ApplicationDeactivate), StopCause::WindowDeactivated);
    }
    static StopCause applicationInactive(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::Application && n.state != Qt::ApplicationActive,
                    StopCause::WindowDeactivated);
    }
    static StopCause applicationQuits(const HoldRules&, const HoldEvent& n) {
        return when(isEvent(n, QEvent::Quit), StopCause::WindowClosed);
    }

    // events of the display server; Qt reports a lost focus 100 ms later, in case the focus returns

    static StopCause nativeFocusLost(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::NativeFocus, StopCause::WindowDeactivated);
    }
    static StopCause nativeHidden(const HoldRules&, const HoldEvent& n) {
        return when(n.kind == Kind::NativeHide, StopCause::WindowDeactivated);
    }

    // timeouts

    static StopCause stalled(const HoldRules& h, const HoldEvent& n) {
        const bool clocked = n.kind == Kind::Refresh || n.kind == Kind::Input;
        return when(clocked && h.now() - h.refreshedNs_ > kStallNs, StopCause::EventLoopStalled);
    }
    static StopCause deviceTimeout(const HoldRules& h, const HoldEvent& n) {
        return when(n.kind == Kind::Refresh && h.grip_.by == HoldSource::By::Device &&
                        h.now() - h.heardNs_ > kStallNs,
                    StopCause::DeviceLost);
    }
    static StopCause fingerTimeout(const HoldRules& h, const HoldEvent& n) {
        return when(n.kind == Kind::Refresh && h.grip_.by == HoldSource::By::Touch &&
                        h.now() - h.heardNs_ > h.bounds_.holdTimeoutNs,
                    StopCause::HoldUnproven);
    }
    static StopCause seenUp(const HoldRules& h, const HoldEvent& n) {
        return when(n.kind == Kind::Refresh &&
                        h.anyKeyState([](const KeyStateProbe::Word& word, std::int64_t sinceNs) {
                            return word.askedNs > sinceNs && word.downNs < word.askedNs;
                        }),
                    StopCause::Released);
    }
    static StopCause unseen(const HoldRules& h, const HoldEvent& n) {
        return when(n.kind == Kind::Refresh &&
                        h.anyKeyState([now = h.now()](const KeyStateProbe::Word& word, std::int64_t sinceNs) {
                            return now - std::max(word.downNs, sinceNs) > kStallNs;
                        }),
                    StopCause::HoldUnproven);
    }
    static StopCause tooLong(const HoldRules& h, const HoldEvent& n) {
        return when(n.kind == Kind::Refresh && h.leftNs() <= 0, StopCause::HeldTooLong);
    }

    // conditions for starting a motion

    static QString inactiveWindow(const HoldRules&, const QWidget* key, const HoldSource&) {
        // A press that activates the window must not move the arm. Without an on-screen button, only an
        // active application may move the arm.
        if (key != nullptr) {
            return QApplication::activeWindow() == key->window()
                       ? QString()
                       : tr("The window was not active. Press again.");
        }
        return QApplication::activeWindow() != nullptr ? QString() : tr("Click in the window first.");
    }
    static QString openDialog(const HoldRules&, const QWidget*, const HoldSource& grip) {
        // Check this only for keyboard and devices, because a dialog already blocks mouse and touch input.
        if (grip.by != HoldSource::By::Keys && grip.by != HoldSource::By::Device) {
            return {};
        }
        const QWidgetList windows = QApplication::topLevelWidgets();
        const bool open = std::any_of(windows.begin(), windows.end(),
                                      [](const QWidget* window) { return isOverTheWindow(*window); });
        return open ? tr("A dialog or a menu is open. Close it first.") : QString();
    }
    static QString anotherInput(const HoldRules& h, const QWidget*, const HoldSource&) {
        return h.policy_.holding != nullptr && h.policy_.holding != &h
                   ? tr("Another button or key is already held. Release it first.")
                   : QString();
    }
    static QString probeNotResponding(const HoldRules& h, const QWidget*, const HoldSource& grip) {
        return h.hasKeyStateProbe(grip) && h.policy_.witness->waitingNs() > kStallNs
                   ? tr("The display server does not respond, so Tiller cannot detect the release of a "
                        "button or key. Release the button or key, then try again.")
                   : QString();
    }

    static const Row rows[];
    static const BeginRow beginRows[];
};

// Each rule is one line, because tests/support/without_rules.py removes one line at a time and checks that a
// test fails.
// clang-format off
const HoldRules::HoldRuleTable::Row HoldRules::HoldRuleTable::rows[] = {
    {"the key is released", &HoldRuleTable::letGo},
    {"pointer leaves the key", &HoldRuleTable::pointerLeft},
    {"the key is pressed again", &HoldRuleTable::pressedAgain},
    {"another key of the keyboard", &HoldRuleTable::otherKey},
    {"a modifier of the keyboard", &HoldRuleTable::modifier},
    {"a key that does not fit", &HoldRuleTable::unmatchedKey},
    {"Esc", &HoldRuleTable::escape},
    {"Space", &HoldRuleTable::space},
    {"a press anywhere", &HoldRuleTable::mousePressed},
    {"a press on a window's frame", &HoldRuleTable::framePressed},
    {"a touch anywhere", &HoldRuleTable::touched},
    {"a pen anywhere", &HoldRuleTable::penPressed},
    {"the touch is cancelled", &HoldRuleTable::touchCancelled},
    {"the key is disabled", &HoldRuleTable::keyDisabled},
    {"the key is hidden", &HoldRuleTable::keyHidden},
    {"the key is moved", &HoldRuleTable::keyMoved},
    {"the key loses the focus", &HoldRuleTable::focusLost},
    {"an editor gets the focus", &HoldRuleTable::editorEntered},
    {"the window is left", &HoldRuleTable::windowDeactivated},
    {"the window loses the focus", &HoldRuleTable::windowFocusLost},
    {"the window is minimised", &HoldRuleTable::windowMinimised},
    {"the window is hidden", &HoldRuleTable::windowHidden},
    {"a window is closed", &HoldRuleTable::windowClosed},
    {"the window is blocked", &HoldRuleTable::windowBlocked},
    {"a window opens", &HoldRuleTable::windowOpened},
    {"the display server moves the focus", &HoldRuleTable::nativeFocusLost},
    {"the display server hides the window", &HoldRuleTable::nativeHidden},
    {"the application is left", &HoldRuleTable::applicationLeft},
    {"the application is inactive", &HoldRuleTable::applicationInactive},
    {"the application quits", &HoldRuleTable::applicationQuits},
    {"the event loop is stalled", &HoldRuleTable::stalled},
    {"the device is not read", &HoldRuleTable::deviceTimeout},
    {"the touch is not refreshed", &HoldRuleTable::fingerTimeout},
    {"the key-state check reports a release", &HoldRuleTable::seenUp},
    {"the key-state check does not respond", &HoldRuleTable::unseen},
    {"held for too long", &HoldRuleTable::tooLong},
};
const HoldRules::HoldRuleTable::BeginRow HoldRules::HoldRuleTable::beginRows[] = {
    {"no press in an inactive window", &HoldRuleTable::inactiveWindow},
    {"no device while a dialog is open", &HoldRuleTable::openDialog},
    {"no second input", &HoldRuleTable::anotherInput},
    {"no press while the key-state check does not respond", &HoldRuleTable::probeNotResponding},
};
// clang-format on

// ---- evaluation ------------------------------------------------------------------------------------------

void HoldPolicy::stop(StopCause cause) {
    if (holding != nullptr) {
        holding->stop(cause);
    }
}

HoldRules::HoldRules(HoldPolicy& policy, std::function<void(StopCause)> stop, const Clock& clock,
                     QObject* parent)
    : QObject(parent), policy_(policy), stop_(std::move(stop)), clock_(&clock) {
    if (auto* app = qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        connect(app, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
            HoldEvent news{HoldEvent::Kind::Application};
            news.state = state;
            happen(news);
        });
    }
}

HoldRules::~HoldRules() {
    end();
}

QString HoldRules::obstacle(const QWidget* key, const HoldSource& grip) const {
    for (const HoldRuleTable::BeginRow& row : HoldRuleTable::beginRows) {
        if (const QString why = row.rule(*this, key, grip); !why.isEmpty()) {
            return why;
        }
    }
    return {};
}

void HoldRules::endOther() {
    if (policy_.holding != nullptr && policy_.holding != this) {
        policy_.holding->happen(Kind::PressedAgain);
    }
}

void HoldRules::begin(QWidget* key, const HoldSource& grip, const HoldBounds& bounds) {
    key_ = key;
    window_ = key != nullptr ? key->window() : QApplication::activeWindow();
    grip_ = grip;
    bounds_ = bounds;
    keys_.clear();
    beganNs_ = refreshedNs_ = heardNs_ = clock_->nowNs();
    setKeys(grip.keys);
    active_ = true;
    policy_.holding = this;
    if (policy_.witness != nullptr && hasKeyStateProbe(grip)) {
        policy_.witness->want(true);
    }
    qApp->installEventFilter(this);
    qApp->installNativeEventFilter(this);
}

void HoldRules::end() {
    if (!active_) {
        return;
    }
    active_ = false;
    qApp->removeEventFilter(this);
    qApp->removeNativeEventFilter(this);
    if (policy_.holding == this) {
        policy_.holding = nullptr;
    }
    if (policy_.witness != nullptr) {
        policy_.witness->want(false);
    }
}

void HoldRules::stop(StopCause cause) {
    if (active_) {
        stop_(cause);
    }
}

bool HoldRules::happen(const HoldEvent& news) {
    if (!active_) {
        return false;
    }
    for (const HoldRuleTable::Row& row : HoldRuleTable::rows) {
        if (const StopCause cause = row.rule(*this, news); cause != StopCause::None) {
            stop_(cause);
            return true;
        }
    }
    if (news.kind == Kind::Refresh) {
        refreshedNs_ = now();
    }
    return false;
}

void HoldRules::setKeys(const QList<KeyCode>& keys) {
    QList<HeldKey> now;
    for (const KeyCode code : keys) {
        const auto same =
            std::find_if(keys_.begin(), keys_.end(), [code](const HeldKey& key) { return key.code == code; });
        now.append({code, same != keys_.end() ? same->sinceNs : this->now()});
    }
    keys_ = now;
    grip_.keys = keys;
}

bool HoldRules::hasKeyStateProbe(const HoldSource& grip) const {
    return policy_.witness != nullptr && policy_.witness->isThere() &&
           (grip.by == HoldSource::By::Mouse || (grip.by == HoldSource::By::Keys && !grip.keys.isEmpty()));
}

template <class Test>
bool HoldRules::anyKeyState(const Test& test) const {
    if (!hasKeyStateProbe(grip_)) {
        return false;
    }
    const KeyStateProbe& witness = *policy_.witness;
    if (grip_.by == HoldSource::By::Mouse) {
        return test(witness.leftButton(), beganNs_);
    }
    return std::any_of(keys_.begin(), keys_.end(), [&witness, &test](const HeldKey& key) {
        return test(witness.key(key.code), key.sinceNs);
    });
}

StopCause HoldRules::hiddenCause() const {
    // If the window is hidden, its buttons are hidden as well.
    return key_ != nullptr && key_->window()->isHidden() ? StopCause::WindowClosed
                                                         : StopCause::SelectionChanged;
}

std::int64_t HoldRules::leftNs() const {
    return active_ ? beganNs_ + longestNs() - now() : std::numeric_limits<std::int64_t>::max();
}

bool HoldRules::isNearLimit() const {
    return leftNs() <= longestNs() / 4;
}

void HoldRules::extend(std::int64_t leftNs) {
    bounds_.longestNs = std::max(longestNs(), now() - beganNs_ + leftNs);
}

QStringList HoldRules::names() {
    QStringList names;
    for (const HoldRuleTable::Row& row : HoldRuleTable::rows) {
        names << QString::fromLatin1(row.name);
    }
    for (const HoldRuleTable::BeginRow& row : HoldRuleTable::beginRows) {
        names << QString::fromLatin1(row.name);
    }
    return names;
}

bool HoldRules::eventFilter(QObject* watched, QEvent* event) {
    if (!active_) {
        return false;
    }
    HoldEvent news;
    news.watched = watched;
    news.event = event;
    const bool ended = happen(news);
    // A press that stops a motion must not start another motion.
    const bool press = event->type() == QEvent::MouseButtonPress ||
                       event->type() == QEvent::MouseButtonDblClick || event->type() == QEvent::TouchBegin ||
                       event->type() == QEvent::TabletPress;
    return ended && press && HoldGuard::isHoldKey(*watched);
}

bool HoldRules::nativeEventFilter(const QByteArray& type, void* message, qintptr*) {
    const NativeWindowEvent event = nativeWindowEvent(type, message);
    if (event.kind == NativeWindowEvent::Kind::FocusLost) {
        happen(Kind::NativeFocus);
    } else if (event.kind == NativeWindowEvent::Kind::Hidden && window_ != nullptr &&
               event.window == window_->internalWinId()) {
        happen(Kind::NativeHide);
    }
    return false;
}

}  // namespace tiller

#include "moc_hold_rules.cpp"
