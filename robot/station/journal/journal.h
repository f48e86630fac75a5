// SPDX-License-Identifier: MIT
#pragma once

// The events of one robot, in order: messages, notes, program steps and recordings of incidents. The log, the
// status line, recordings and incident files read the events from the journal. When there are more than
// kCapacity events, the oldest are removed.

#include <QObject>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

#include "robot/station/journal/journal_event.h"

namespace tiller {

/// Threads  any. A function connected with a context object is called in the thread of that object.
class Journal : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t kCapacity = 5000;

    /// Adds a message for the log.
    /// detail  explanation and suggested action, as sentences; may be empty
    void add(Severity severity, const QString& text, Origin origin = Origin::Tiller,
             const QString& detail = {});
    /// Adds a message about an event that occurred `agoNs` ago. The entry has the time of the event.
    void addLate(Severity severity, const QString& text, Origin origin, std::int64_t agoNs);
    /// utcNs  the time that the note describes [ns since 1970]
    void addNote(const QString& text, std::int64_t utcNs);
    void addStep(const QString& text, bool isFirstRun);
    /// Adds a message about a recording.
    /// path    path of the file; empty if it could not be written
    /// moment  position in the file [s]; empty: time of the incident
    void addRecording(Severity severity, const QString& text, const QString& detail, const QString& path,
                      std::optional<double> moment = {});

    /// The events so far, oldest first.
    std::vector<JournalEvent> events() const;

    /// Sets the robot and the time on its controller's clock for later events.
    void setRobot(const QString& name, std::optional<double> controllerSeconds);
    /// Replaces the system clock in tests.
    /// utcNs  returns the time [ns since 1970]
    void setWallClock(std::function<std::int64_t()> utcNs);

Q_SIGNALS:
    void added(const tiller::JournalEvent& event);

private:
    void append(JournalEvent event, std::int64_t agoNs = 0);

    mutable std::mutex mutex_;  ///< protects the following members
    std::deque<JournalEvent> events_;
    QString robot_;
    std::optional<double> controllerSeconds_;
    std::function<std::int64_t()> wallClock_;  ///< empty: the system clock
};

}  // namespace tiller
