// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/hold_rules.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/common/hold_guard.h"
#include "widgets/common/hold_witness.h"
#include "widgets/common/text_entry.h"

namespace tiller {

using control::StopCause;
using Kind = HoldNews::Kind;

namespace {

constexpr std::int64_t kStallNs = HoldRules::kStallMs * kNsPerMs;

bool isEvent(const HoldNews& news, QEvent::Type type) {
    return news.kind == Kind::Event && news.event->type() == type;
}

/// A press is delivered to the native window first and to the widget afterwards. It is evaluated at the
/// widget, which may be a hold-to-run key itself.
bool isAtWidget(const HoldNews& news) {
    return news.watched->isWidgetType();
}

bool isKeyPress(const HoldNews& news, Qt::Key key) {
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

// ---- the rules -------------------------------------------------------------------------------------------
//
// A rule checks an event and returns the cause that ends the motion, or None if the rule does not apply.

struct HoldRules::Book {
    using Rule = StopCause (*)(const HoldRules&, const HoldNews&);
    using BeginRule = QString (*)(const HoldRules&, const QWidget*, const Grip&);
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

    static StopCause letGo(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::LetGo, StopCause::Released);
    }
    static StopCause pointerLeft(const HoldRules& h, const HoldNews& n) {
        if (n.kind != Kind::PointerAt || h.key_ == nullptr) {
            return StopCause::None;
        }
        const int slack = kPointerSlack;
        return when(!h.key_->rect().adjusted(-slack, -slack, slack, slack).contains(n.position),
                    StopCause::PointerLeft);
    }
    static StopCause pressedAgain(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::PressedAgain, StopCause::SecondButton);
    }
    static StopCause otherKey(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::OtherKey, StopCause::SecondButton);
    }
    static StopCause modifier(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::Modifier, StopCause::SelectionChanged);
    }
    static StopCause unmatchedKey(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::Unmatched, StopCause::HoldUnproven);
    }

    // events in the application

    static StopCause escape(const HoldRules&, const HoldNews& n) {
        return when(isKeyPress(n, Qt::Key_Escape), StopCause::Escape);
    }
    static StopCause space(const HoldRules&, const HoldNews& n) {
        return when(isKeyPress(n, Qt::Key_Space), StopCause::Space);
    }
    static StopCause mousePressed(const HoldRules&, const HoldNews& n) {
        const bool press = isEvent(n, QEvent::MouseButtonPress) || isEvent(n, QEvent::MouseButtonDblClick);
        return when(press && isAtWidget(n), StopCause::SecondButton);
    }
    static StopCause framePressed(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::NonClientAreaMouseButtonPress), StopCause::SecondButton);
    }
    static StopCause touched(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::TouchBegin) && isAtWidget(n), StopCause::SecondButton);
    }
    static StopCause penPressed(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::TabletPress) && isAtWidget(n), StopCause::SecondButton);
    }
    static StopCause touchCancelled(const HoldRules& h, const HoldNews& n) {
        return when(isEvent(n, QEvent::TouchCancel) && n.watched == h.key_, StopCause::DeviceLost);
    }
    static StopCause keyDisabled(const HoldRules& h, const HoldNews& n) {
        return when(isEvent(n, QEvent::EnabledChange) && n.watched == h.key_ && !h.key_->isEnabled(),
                    StopCause::ControlLost);
    }
    static StopCause keyHidden(const HoldRules& h, const HoldNews& n) {
        return when(isEvent(n, QEvent::Hide) && n.watched == h.key_, h.whyGone());
    }
    static StopCause keyMoved(const HoldRules& h, const HoldNews& n) {
        return when(isEvent(n, QEvent::ParentChange) && n.watched == h.key_, StopCause::WindowClosed);
    }
    static StopCause focusLost(const HoldRules& h, const HoldNews& n) {
        if (!isEvent(n, QEvent::FocusOut) || n.watched != h.key_) {
            return StopCause::None;
        }
        // A key that is disabled or hidden loses the focus first: report the actual reason.
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(n.event)->reason();
        if (!h.key_->isEnabled()) {
            return StopCause::ControlLost;
        }
        if (h.key_->window()->isHidden() || !h.key_->isVisible()) {
            return h.whyGone();
        }
        if (reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason) {
            return StopCause::DialogOpened;
        }
        return reason == Qt::ActiveWindowFocusReason ? StopCause::WindowDeactivated : StopCause::FocusLost;
    }
    static StopCause editorEntered(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::FocusIn) && takesText(qobject_cast<QWidget*>(n.watched)),
                    StopCause::FocusLost);
    }
    static StopCause windowDeactivated(const HoldRules& h, const HoldNews& n) {
        const bool hidden = h.window_ != nullptr && h.window_->isHidden();
        return when(isEvent(n, QEvent::WindowDeactivate),
                    hidden ? StopCause::WindowClosed : StopCause::WindowDeactivated);
    }
    static StopCause windowFocusLost(const HoldRules&, const HoldNews& n) {
        // A floating panel shares the activation state of its window: only the focus shows that the operator
        // switched to another window.
        return when(isEvent(n, QEvent::FocusOut) && n.watched->isWindowType(), StopCause::WindowDeactivated);
    }
    static StopCause windowMinimised(const HoldRules& h, const HoldNews& n) {
        return when(
            isEvent(n, QEvent::WindowStateChange) && n.watched == h.window_ && h.window_->isMinimized(),
            StopCause::WindowDeactivated);
    }
    static StopCause windowHidden(const HoldRules& h, const HoldNews& n) {
        return when(isEvent(n, QEvent::Hide) && n.watched == h.window_, StopCause::WindowClosed);
    }
    static StopCause windowClosed(const HoldRules&, const HoldNews& n) {
        const auto* widget = qobject_cast<QWidget*>(n.watched);
        return when(isEvent(n, QEvent::Close) && widget != nullptr && isSignOfAWindow(*widget),
                    StopCause::WindowClosed);
    }
    static StopCause windowBlocked(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::WindowBlocked), StopCause::DialogOpened);
    }
    static StopCause windowOpened(const HoldRules&, const HoldNews& n) {
        const auto* widget = qobject_cast<QWidget*>(n.watched);
        return when(isEvent(n, QEvent::Show) && widget != nullptr && isSignOfAWindow(*widget),
                    StopCause::DialogOpened);
    }
    static StopCause applicationLeft(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::ApplicationDeactivate), StopCause::WindowDeactivated);
    }
    static StopCause applicationInactive(const HoldRules&, const HoldNews& n) {
        return when(n.kind == Kind::Application && n.state != Qt::ApplicationActive,
                    StopCause::WindowDeactivated);
    }
    static StopCause applicationQuits(const HoldRules&, const HoldNews& n) {
        return when(isEvent(n, QEvent::Quit), StopCause::WindowClosed);
    }

    // timeouts

    static StopCause stalled(const HoldRules& h, const HoldNews& n) {
        const bool clocked = n.kind == Kind::Refresh || n.kind == Kind::Input;
        return when(clocked && h.now() - h.refreshedNs_ > kStallNs, StopCause::EventLoopStalled);
    }
    static StopCause deviceSilent(const HoldRules& h, const HoldNews& n) {
        return when(
            n.kind == Kind::Refresh && h.grip_.by == Grip::By::Device && h.now() - h.heardNs_ > kStallNs,
            StopCause::DeviceLost);
    }
    static StopCause fingerSilent(const HoldRules& h, const HoldNews& n) {
        return when(n.kind == Kind::Refresh && h.grip_.by == Grip::By::Touch &&
                        h.now() - h.heardNs_ > h.bounds_.silenceNs,
                    StopCause::HoldUnproven);
    }
    static StopCause seenUp(const HoldRules& h, const HoldNews& n) {
        return when(n.kind == Kind::Refresh &&
                        h.anyWitnessed([](const HoldWitness::Word& word, std::int64_t sinceNs) {
                            return word.askedNs > sinceNs && word.downNs < word.askedNs;
                        }),
                    StopCause::Released);
    }
    static StopCause unseen(const HoldRules& h, const HoldNews& n) {
        return when(n.kind == Kind::Refresh &&
                        h.anyWitnessed([now = h.now()](const HoldWitness::Word& word, std::int64_t sinceNs) {
                            return now - std::max(word.downNs, sinceNs) > kStallNs;
                        }),
                    StopCause::HoldUnproven);
    }
    static StopCause tooLong(const HoldRules& h, const HoldNews& n) {
        return when(n.kind == Kind::Refresh && h.leftNs() <= 0, StopCause::HeldTooLong);
    }

    // conditions for starting a motion

    static QString inactiveWindow(const HoldRules&, const QWidget* key, const Grip&) {
        // The press that activates a window must not move the arm, and only the active program may move it.
        if (key != nullptr) {
            return QApplication::activeWindow() == key->window()
                       ? QString()
                       : tr("The window was not active. Press again.");
        }
        return QApplication::activeWindow() != nullptr ? QString() : tr("Click in the window first.");
    }
    static QString openDialog(const HoldRules&, const QWidget*, const Grip& grip) {
        // A dialog blocks mouse and touch input, but not keyboard jogging and input devices.
        if (grip.by != Grip::By::Keys && grip.by != Grip::By::Device) {
            return {};
        }
        const QWidgetList windows = QApplication::topLevelWidgets();
        const bool open = std::any_of(windows.begin(), windows.end(),
                                      [](const QWidget* window) { return isOverTheWindow(*window); });
        return open ? tr("A dialog or a menu is open. Close it first.") : QString();
    }
    static QString anotherHand(const HoldRules& h, const QWidget*, const Grip&) {
        return h.terms_->holding != nullptr && h.terms_->holding != &h ? tr("Another key is already held.")
                                                                       : QString();
    }
    static QString muteWitness(const HoldRules& h, const QWidget*, const Grip& grip) {
        return h.isWitnessed(grip) && h.terms_->witness->waitingNs() > kStallNs
                   ? tr("The display server does not respond: the release of the key could not be detected.")
                   : QString();
    }

    static const Row rows[];
    static const BeginRow beginRows[];
};

// One line, one rule: tests/support/without_rules.py takes each away in turn and looks which test notices.
// clang-format off
const HoldRules::Book::Row HoldRules::Book::rows[] = {
    {"the key is released", &Book::letGo},
    {"pointer leaves the key", &Book::pointerLeft},
    {"the key is pressed again", &Book::pressedAgain},
    {"another key of the keyboard", &Book::otherKey},
    {"a modifier of the keyboard", &Book::modifier},
    {"a key that does not fit", &Book::unmatchedKey},
    {"Esc", &Book::escape},
    {"Space", &Book::space},
    {"a press anywhere", &Book::mousePressed},
    {"a press on a window's frame", &Book::framePressed},
    {"a touch anywhere", &Book::touched},
    {"a pen anywhere", &Book::penPressed},
    {"the touch is cancelled", &Book::touchCancelled},
    {"the key is disabled", &Book::keyDisabled},
    {"the key is hidden", &Book::keyHidden},
    {"the key is moved", &Book::keyMoved},
    {"the key loses the focus", &Book::focusLost},
    {"an editor gets the focus", &Book::editorEntered},
    {"the window is left", &Book::windowDeactivated},
    {"the window loses the focus", &Book::windowFocusLost},
    {"the window is minimised", &Book::windowMinimised},
    {"the window is hidden", &Book::windowHidden},
    {"a window is closed", &Book::windowClosed},
    {"the window is blocked", &Book::windowBlocked},
    {"a window opens", &Book::windowOpened},
    {"the application is left", &Book::applicationLeft},
    {"the application is inactive", &Book::applicationInactive},
    {"the application quits", &Book::applicationQuits},
    {"the event loop is stalled", &Book::stalled},
    {"the device is not read", &Book::deviceSilent},
    {"the touch is not refreshed", &Book::fingerSilent},
    {"the key-state check reports a release", &Book::seenUp},
    {"the key-state check does not respond", &Book::unseen},
    {"held for too long", &Book::tooLong},
};
const HoldRules::Book::BeginRow HoldRules::Book::beginRows[] = {
    {"no press in an inactive window", &Book::inactiveWindow},
    {"no device while a dialog is open", &Book::openDialog},
    {"no second input", &Book::anotherHand},
    {"no press while the key-state check does not respond", &Book::muteWitness},
};
// clang-format on

// ---- evaluation ------------------------------------------------------------------------------------------

HoldRules::HoldRules(std::function<void(StopCause)> stop, const Clock& clock, QObject* parent)
    : QObject(parent), stop_(std::move(stop)), clock_(&clock) {
    if (auto* app = qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        connect(app, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
            HoldNews news{HoldNews::Kind::Application};
            news.state = state;
            happen(news);
        });
    }
}

HoldRules::~HoldRules() {
    end();
}

QString HoldRules::obstacle(const QWidget* key, const Grip& grip) const {
    for (const Book::BeginRow& row : Book::beginRows) {
        if (const QString why = row.rule(*this, key, grip); !why.isEmpty()) {
            return why;
        }
    }
    return {};
}

void HoldRules::endOther() {
    if (terms_->holding != nullptr && terms_->holding != this) {
        terms_->holding->happen(Kind::PressedAgain);
    }
}

void HoldRules::begin(QWidget* key, const Grip& grip, const HoldBounds& bounds) {
    key_ = key;
    window_ = key != nullptr ? key->window() : QApplication::activeWindow();
    grip_ = grip;
    bounds_ = bounds;
    keys_.clear();
    beganNs_ = refreshedNs_ = heardNs_ = clock_->nowNs();
    setKeys(grip.keys);
    active_ = true;
    terms_->holding = this;
    if (terms_->witness != nullptr && isWitnessed(grip)) {
        terms_->witness->want(true);
    }
    qApp->installEventFilter(this);
}

void HoldRules::end() {
    if (!active_) {
        return;
    }
    active_ = false;
    qApp->removeEventFilter(this);
    if (terms_->holding == this) {
        terms_->holding = nullptr;
    }
    if (terms_->witness != nullptr) {
        terms_->witness->want(false);
    }
}

bool HoldRules::happen(const HoldNews& news) {
    if (!active_) {
        return false;
    }
    for (const Book::Row& row : Book::rows) {
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

bool HoldRules::isWitnessed(const Grip& grip) const {
    return terms_->witness != nullptr && terms_->witness->isThere() &&
           (grip.by == Grip::By::Mouse || (grip.by == Grip::By::Keys && !grip.keys.isEmpty()));
}

template <class Test>
bool HoldRules::anyWitnessed(const Test& test) const {
    if (!isWitnessed(grip_)) {
        return false;
    }
    const HoldWitness& witness = *terms_->witness;
    if (grip_.by == Grip::By::Mouse) {
        return test(witness.leftButton(), beganNs_);
    }
    return std::any_of(keys_.begin(), keys_.end(), [&witness, &test](const HeldKey& key) {
        return test(witness.key(key.code), key.sinceNs);
    });
}

StopCause HoldRules::whyGone() const {
    // Hiding a window also hides its keys.
    return key_ != nullptr && key_->window()->isHidden() ? StopCause::WindowClosed
                                                         : StopCause::SelectionChanged;
}

std::int64_t HoldRules::leftNs() const {
    const std::int64_t longest = bounds_.longestNs != 0 ? bounds_.longestNs : terms_->longestNs;
    return active_ ? beganNs_ + longest - now() : std::numeric_limits<std::int64_t>::max();
}

QStringList HoldRules::names() {
    QStringList names;
    for (const Book::Row& row : Book::rows) {
        names << QString::fromLatin1(row.name);
    }
    for (const Book::BeginRow& row : Book::beginRows) {
        names << QString::fromLatin1(row.name);
    }
    return names;
}

bool HoldRules::eventFilter(QObject* watched, QEvent* event) {
    if (!active_) {
        return false;
    }
    HoldNews news;
    news.watched = watched;
    news.event = event;
    const bool ended = happen(news);
    // The press that stops one motion must not start another.
    const bool press = event->type() == QEvent::MouseButtonPress ||
                       event->type() == QEvent::MouseButtonDblClick || event->type() == QEvent::TouchBegin ||
                       event->type() == QEvent::TabletPress;
    return ended && press && HoldGuard::isHoldKey(*watched);
}

}  // namespace tiller

#include "moc_hold_rules.cpp"
