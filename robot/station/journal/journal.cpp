// SPDX-License-Identifier: MIT
#include "robot/station/journal/journal.h"

#include <chrono>
#include <utility>

namespace tiller {

namespace {

std::int64_t systemUtcNs() {
    using std::chrono::nanoseconds;
    return std::chrono::duration_cast<nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

}  // namespace

void Journal::add(Severity severity, const QString& text, Origin origin, const QString& detail) {
    append({.severity = severity, .origin = origin, .text = text, .detail = detail});
}

void Journal::addLate(Severity severity, const QString& text, Origin origin, std::int64_t agoNs) {
    append({.severity = severity, .origin = origin, .text = text}, agoNs);
}

void Journal::addNote(const QString& text, std::int64_t utcNs) {
    append({.kind = JournalEvent::Kind::Note, .origin = Origin::Operator, .text = text, .noteUtcNs = utcNs});
}

void Journal::addStep(const QString& text, bool isFirstRun) {
    append({.kind = JournalEvent::Kind::Step, .text = text, .isFirstRun = isFirstRun});
}

void Journal::addRecording(Severity severity, const QString& text, const QString& detail, const QString& path,
                           std::optional<double> moment) {
    append({.kind = JournalEvent::Kind::Recording,
            .severity = severity,
            .text = text,
            .detail = detail,
            .recording = path,
            .moment = moment});
}

std::vector<JournalEvent> Journal::events() const {
    const std::lock_guard lock(mutex_);
    return {events_.begin(), events_.end()};
}

void Journal::setRobot(const QString& name, std::optional<double> controllerSeconds) {
    const std::lock_guard lock(mutex_);
    robot_ = name;
    controllerSeconds_ = controllerSeconds;
}

void Journal::setWallClock(std::function<std::int64_t()> utcNs) {
    const std::lock_guard lock(mutex_);
    wallClock_ = std::move(utcNs);
}

void Journal::append(JournalEvent event, std::int64_t agoNs) {
    {
        const std::lock_guard lock(mutex_);
        event.utcNs = (wallClock_ ? wallClock_() : systemUtcNs()) - agoNs;
        event.robot = robot_;
        event.controllerSeconds = controllerSeconds_;
        if (event.controllerSeconds) {
            *event.controllerSeconds -=
                std::chrono::duration<double>(std::chrono::nanoseconds(agoNs)).count();
        }
        events_.push_back(event);
        if (events_.size() > kCapacity) {
            events_.pop_front();
        }
    }
    // Emit without holding the lock, so that a connected function can add events.
    Q_EMIT added(event);
}

}  // namespace tiller

#include "moc_journal.cpp"
