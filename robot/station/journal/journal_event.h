// SPDX-License-Identifier: MIT
#pragma once

// One journal entry: a message for the log, a note by the operator, a step of a program, or a
// message with a recording of the event.

#include <QString>
#include <cstdint>
#include <optional>

namespace tiller {

enum class Severity { Info, Warning, Error };
/// Origin of the action described by an event.
enum class Origin { Tiller, Operator, Robot };

struct JournalEvent {
    enum class Kind {
        Message,
        Note,      ///< note by the operator about a point in time, at which recordings store it
        Step,      ///< a step of a program has begun. Recordings store every step
        Recording  ///< a message about a recording, e.g. of an incident. Not part of recordings
    };

    Kind kind = Kind::Message;
    Severity severity = Severity::Info;
    Origin origin = Origin::Tiller;
    QString text{};
    QString detail{};                ///< explanation and suggested action, as sentences; may be empty
    std::int64_t noteUtcNs = 0;      ///< notes: the time that the note describes [ns since 1970]
    bool isFirstRun = false;         ///< steps: the first run of this step
    QString recording{};             ///< recordings: path of the file; empty if it could not be written
    std::optional<double> moment{};  ///< recordings: position in the file [s]; empty: time of the incident

    // Set by the journal:
    std::int64_t utcNs = 0;                     ///< time of the event [ns since 1970]
    QString robot{};                            ///< name of the connected robot; empty if there is none
    std::optional<double> controllerSeconds{};  ///< time of the newest data on the controller's clock [s]

    bool isMessage() const { return kind == Kind::Message; }
};

}  // namespace tiller
