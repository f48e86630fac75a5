// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/key_repeat.h"

#include <QCoreApplication>
#include <utility>

#include "widgets/hold/key_state_probe.h"

namespace tiller {

namespace {

void sendAsRepeat(QWindow& window, const QKeyEvent& press, QEvent::Type type) {
    QKeyEvent repeat(type, press.key(), press.modifiers(), press.nativeScanCode(), press.nativeVirtualKey(),
                     press.nativeModifiers(), press.text(), true, static_cast<quint16>(press.count()));
    repeat.setTimestamp(press.timestamp());
    QCoreApplication::sendEvent(&window, &repeat);
}

}  // namespace

KeyRepeat::KeyRepeat(const Clock& clock, QObject* parent) : QObject(parent), clock_(clock) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(1);
    connect(&timer_, &QTimer::timeout, this, &KeyRepeat::poll);
}

KeyRepeat::~KeyRepeat() = default;

void KeyRepeat::setProbe(KeyStateProbe* probe) {
    deliver();
    probe_ = probe;
}

bool KeyRepeat::intercepts(QObject& receiver, QEvent& event) {
    const bool isKey = event.type() == QEvent::KeyPress || event.type() == QEvent::KeyRelease;
    if (delivering_ || (!isKey && event.type() != QEvent::ShortcutOverride)) {
        return false;
    }
    const auto& key = static_cast<QKeyEvent&>(event);
    if (release_ != nullptr && event.type() != QEvent::KeyRelease && isRepeatOf(*release_, key)) {
        if (event.type() == QEvent::ShortcutOverride) {
            event.accept();  // a repetition must not trigger a shortcut
            return true;
        }
        if (!receiver.isWindowType()) {
            return false;
        }
        deliverRepeat(key);
        return true;
    }
    // The press of a repetition directly follows its release. Any other key event shows that the key was
    // released. Exception: a further release of the same key, after a repetition whose press is missing.
    if (release_ != nullptr &&
        !(event.type() == QEvent::KeyRelease && PhysicalKeys::codeOf(key) == release_->code)) {
        release_->isRepeat = false;
    }
    deliver();
    return event.type() == QEvent::KeyRelease && receiver.isWindowType() &&
           delays(static_cast<QWindow&>(receiver), key);
}

bool KeyRepeat::delays(QWindow& window, const QKeyEvent& event) {
    const KeyCode code = PhysicalKeys::codeOf(event);
    if (probe_ == nullptr || !probe_->isThere() || event.isAutoRepeat() || !PhysicalKeys::hasNumber(code) ||
        probe_->waitingNs() > kLongestMs * kNsPerMs) {  // the display server does not respond
        return false;
    }
    release_ = std::make_unique<Release>();
    release_->window = &window;
    release_->event.reset(event.clone());
    release_->code = code;
    release_->sinceNs = clock_.nowNs();
    probe_->query();
    timer_.start();
    return true;
}

bool KeyRepeat::isRepeatOf(const Release& release, const QKeyEvent& press) const {
    return PhysicalKeys::codeOf(press) == release.code && press.timestamp() == release.event->timestamp();
}

void KeyRepeat::poll() {
    if (release_ == nullptr || release_->isRepeat) {
        timer_.stop();
        return;
    }
    const KeyStateProbe::Word word = probe_->key(release_->code);
    if (word.askedNs > release_->sinceNs && word.downNs > release_->sinceNs) {
        release_->isRepeat = true;  // wait for the press of the repetition
    } else if (word.askedNs > release_->sinceNs ||
               clock_.nowNs() - release_->sinceNs > kLongestMs * kNsPerMs) {
        deliver();
    }
}

void KeyRepeat::deliverRepeat(const QKeyEvent& press) {
    const std::unique_ptr<Release> release = std::exchange(release_, nullptr);
    timer_.stop();
    if (release->window == nullptr) {
        return;
    }
    delivering_ = true;
    sendAsRepeat(*release->window, press, QEvent::KeyRelease);
    if (release->window != nullptr) {
        sendAsRepeat(*release->window, press, QEvent::KeyPress);
    }
    delivering_ = false;
}

void KeyRepeat::deliver() {
    const std::unique_ptr<Release> release = std::exchange(release_, nullptr);
    timer_.stop();
    if (release == nullptr || release->isRepeat || release->window == nullptr) {
        return;
    }
    delivering_ = true;
    QCoreApplication::sendEvent(release->window, release->event.get());
    delivering_ = false;
}

}  // namespace tiller

#include "moc_key_repeat.cpp"
