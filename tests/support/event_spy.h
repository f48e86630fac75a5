// SPDX-License-Identifier: MIT
#pragma once

// Reads the journal of a robot in tests.

#include <QObject>
#include <type_traits>
#include <utility>
#include <vector>

#include "robot/station/journal/journal.h"

namespace tiller::test {

/// Ends a connection with its scope. Declare it after the variables that the connected function uses.
class Listening {
public:
    Listening(QMetaObject::Connection connection) : connection_(std::move(connection)) {}
    ~Listening() { QObject::disconnect(connection_); }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;

private:
    QMetaObject::Connection connection_;
};

/// Calls `heard` with severity, text and origin of each later message. The origin may be omitted. If `heard`
/// uses local variables, keep the result in a Listening.
template <typename Heard>
QMetaObject::Connection onMessage(const Journal& journal, const QObject* context, Heard heard) {
    return QObject::connect(&journal, &Journal::added, context, [heard](const JournalEvent& event) mutable {
        if (!event.isMessage()) {
            return;
        }
        if constexpr (std::is_invocable_v<Heard&, Severity, const QString&, Origin>) {
            heard(event.severity, event.text, event.origin);
        } else {
            heard(event.severity, event.text);
        }
    });
}

/// Collects the events of one type that occur after its creation.
class EventSpy {
public:
    explicit EventSpy(const Journal& journal, JournalEvent::Kind kind = JournalEvent::Kind::Message) {
        QObject::connect(&journal, &Journal::added, &context_, [this, kind](const JournalEvent& event) {
            if (event.kind == kind) {
                events_.push_back(event);
            }
        });
    }

    int count() const { return static_cast<int>(events_.size()); }
    bool isEmpty() const { return events_.empty(); }
    void clear() { events_.clear(); }
    const JournalEvent& front() const { return events_.front(); }
    const JournalEvent& last() const { return events_.back(); }
    auto begin() const { return events_.begin(); }
    auto end() const { return events_.end(); }

private:
    QObject context_;
    std::vector<JournalEvent> events_;
};

}  // namespace tiller::test
