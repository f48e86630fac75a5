// SPDX-License-Identifier: MIT
#pragma once

// Permanently records the last minute of robot data. On a safety stop or an alarm, an incident file is
// written with this minute, the next ten seconds of data, the log, the project and the software versions.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recording_format.h"

namespace tiller::publish {
class Publisher;
}

namespace tiller::recording {

/// Result of writing an incident file.
struct Incident {
    Text path = {};  ///< path of the file; empty on failure
    std::string
        reason{};  ///< "protective-stop", "fault", "violation", "emergency-stop", or the reason for an alarm
    std::int64_t utcNs = 0;    ///< time of the stop [ns since 1970]
    double secondsBefore = 0;  ///< time from the first row of the file to the stop
    Error error = {};          ///< error if writing failed; otherwise code None
};

struct BlackBoxOptions {
    Text folder = {};    ///< created if missing
    double before = 60;  ///< [s], 1 to 600
    double after = 10;   ///< [s], 0 to 60
    int keep = 50;       ///< maximum number of incident files in the folder; older ones are deleted
    std::map<std::string, std::string> facts{};  ///< metadata of the file: "robot", "software" ...
    /// Called for each incident, in a thread of the publisher.
    std::function<void(const Incident&)> written{};
};

/// The threads of a publisher store the samples and write the files. If no publisher is passed to the
/// constructor, each start() creates one. A mutex protects the notes, alarms and the project.
/// Threads  start() and stop(): one thread. All other functions: any
class BlackBox {
public:
    BlackBox();
    /// publisher  shared with other sinks
    explicit BlackBox(std::shared_ptr<publish::Publisher> publisher);
    ~BlackBox();  ///< calls stop()
    BlackBox(const BlackBox&) = delete;
    BlackBox& operator=(const BlackBox&) = delete;

    /// Starts recording. Calls stop() first if already running.
    /// Errors   InvalidArgument (no folder)
    Result<void> start(const BlackBoxOptions& options, const receive::Receiver& receiver);
    /// Stops recording. If an incident is in progress, its file is written with the data received so far.
    /// Blocks: until the file is written
    void stop();

    /// Also records the samples of another receiver of the same robot, with additional fields, until the next
    /// call. The rows of a file contain these fields from their first arrival. Call this function after each
    /// start(), because start() removes the subscription. Pass an invalid subscription to remove it.
    void followExtra(receive::Subscription extra);
    /// Adds a log line. The lines of the last minute are written to the incident file.
    void note(const RecordedNote& note);
    /// Writes an incident file without a stop.
    /// reason  letters, digits and hyphens of this text become part of the file name
    void alarm(const Text& reason);
    /// Sets the project attached to the next file. Empty name: no project.
    void setProject(const Text& name, std::string content);
    /// Adds metadata for the next file that are known only after the start.
    void setFact(const std::string& key, const std::string& value);
    std::uint64_t packets() const;  ///< Packets received since start(); 0 when stopped.

private:
    struct Worker;
    std::shared_ptr<Worker> worker() const;

    std::shared_ptr<publish::Publisher> publisher_;  ///< null: each start creates one
    mutable std::mutex mutex_;  ///< protects the pointer, because each start creates a new object
    std::shared_ptr<Worker> d_;
};

}  // namespace tiller::recording
