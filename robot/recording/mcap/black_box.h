// SPDX-License-Identifier: MIT
#pragma once

// Always on: keeps the last minute of what the robot sent, and when the safety system stops the arm, or somebody raises an
// alarm, writes it to an incident file, with ten seconds of what came after, the log, the project and the versions.

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

namespace tiller::recording {

/// An incident that was written, or could not be.
struct Incident {
    Text path = {};        ///< of its file; empty when there is none
    std::string reason{};  ///< "protective-stop", "fault", "violation", "emergency-stop", or that of an alarm
    std::int64_t utcNs = 0;    ///< of the stop [ns since 1970]
    double secondsBefore = 0;  ///< from the file's first row to the stop
    Error error = {};          ///< why there is no file; code None otherwise
};

struct BlackBoxOptions {
    Text folder = {};                            ///< is made when it does not exist
    double before = 60;                          ///< [s], 1 to 600
    double after = 10;                           ///< [s], 0 to 60
    int keep = 50;                               ///< incident files in the folder; older ones go
    std::map<std::string, std::string> facts{};  ///< into the file: "robot", "software" ...
    /// Told of each incident, in the thread of the box.
    std::function<void(const Incident&)> written{};
};

/// Owns the thread "tiller-box" (normal priority), which drains a subscription and writes the files. What crosses: samples
/// inward through the subscription; notes, alarms and the project through a lock.
/// Threads  start() and stop() from one, the rest from any
class BlackBox {
public:
    BlackBox();
    ~BlackBox();  ///< stops
    BlackBox(const BlackBox&) = delete;
    BlackBox& operator=(const BlackBox&) = delete;

    /// Ends what was before, as stop() does, and begins anew.
    /// Errors   InvalidArgument (no folder)
    Result<void> start(const BlackBoxOptions& options, const receive::Receiver& receiver);
    /// Writes an incident that is under way, as far as it has come. Blocks: until it is written
    void stop();

    void note(const RecordedNote& note);  ///< A line of the log; those of the last minute go into the file.
    /// Something that is no stop, and worth a file all the same. reason  letters, digits and - of it become part of the
    ///          file's name
    void alarm(const Text& reason);
    /// What goes into the next file as the project; none when the name is empty.
    void setProject(const Text& name, std::string content);
    /// Into the next file, beside those it was started with: what is known only later.
    void setFact(const std::string& key, const std::string& value);
    std::uint64_t packets() const;  ///< Taken since start(); 0 while it does not run.

private:
    struct Worker;
    std::shared_ptr<Worker> worker() const;

    mutable std::mutex mutex_;  ///< for the pointer: each start makes a new one
    std::shared_ptr<Worker> d_;
};

}  // namespace tiller::recording
