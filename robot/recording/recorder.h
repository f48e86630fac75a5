// SPDX-License-Identifier: MIT
#pragma once

// Writes what the robot sends to a file, one row per package (or per n packages), in any of the formats; unless told
// otherwise to a CSV file: `timestamp` first, then one column per
// number, named as ur_rtde recordings are (actual_q_0 ... actual_q_5), at last `packages_lost`: how many
// packages are missing between the row before and this one (0 in a recording without gaps). Numbers are the
// shortest that read back exactly, with a point whatever the locale; a field the robot does not have stays
// empty, which pandas reads as NaN.
//
// Rows reach the file at least every half second and only whole, so a killed process costs less than a second
// and leaves a file that ends with a complete row.

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recording_format.h"
#include "robot/recording/trigger.h"

namespace tiller::recording {

using tiller::operator<<;  // for the enumerations below

class RecordingFile;

/// The fields that ur_rtde records. The command line writes them to CSV unless others are asked for.
std::vector<std::string> defaultRecordedFields();

/// The name of the last column.
inline constexpr const char* kLostColumn = "packages_lost";

struct RecorderOptions {
    Text path = {};
    /// Field names, all of which the receiver has to follow; empty: every field that it follows. `timestamp` is always
    /// the first column.
    std::vector<std::string> fields{};
    bool asGiven = false;  ///< these fields in this order and nothing else: no timestamp, no packages_lost
    /// Every n-th package becomes a row, 1 or more. What is left out on purpose does not count as lost.
    int every = 1;
    /// Null: CSV, which is refused for a path that ends in .mcap, .h5 or .hdf5. formatForPath() in
    /// recording/formats/open_recording.h chooses by the end of the path.
    std::shared_ptr<const RecordingFormat> format{};
    /// Waits for it, and writes into numbered files: see numberedPath(). Nothing: one file, at once.
    std::optional<RecordingTrigger> trigger{};
    /// Ends in order, with DiskFull, when less would stay free on the disk [bytes]; 0: when it is full.
    std::int64_t keepFree = 0;
};

enum class RecorderState {
    Idle,
    Recording,
    Waiting,   ///< for its trigger
    Finished,  ///< stop() was called; the file is complete, and on the disk
    Failed,    ///< see error(); what was written before is kept
};

struct RecorderProgress {
    RecorderState state = RecorderState::Idle;
    std::uint64_t rows = 0;      ///< written to the file
    double seconds = 0;          ///< from the first row to the last, by the receiver's clock
    std::uint64_t lost = 0;      ///< packages missing in the file, by whatever cause
    std::int64_t bytes = 0;      ///< size of the file
    int files = 0;               ///< begun so far
    std::int64_t freeBytes = 0;  ///< on its disk, looked up about once a second
};

/// Owns the thread "tiller-record" (normal priority) that drains a subscription into the file.
/// Threads  start() and stop() from one, the rest from any
class Recorder {
public:
    Recorder();
    /// files  makes what a recording is written to; for tests
    explicit Recorder(std::function<std::unique_ptr<RecordingFile>()> files);
    ~Recorder();  ///< stops
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Creates the file (an existing one is replaced), writes the header and begins with the next package.
    /// Errors   FileNotWritable (also while another recording writes to the file), DiskFull; FieldUnknown, naming each field that the receiver does not follow
    /// (no
    ///          file is made, an existing one is left as it is); InvalidArgument (a recording is under way, or the path
    ///          ends as those of another format)
    /// Blocks   as long as the file system takes to create a file
    Result<void> start(const RecorderOptions& options, receive::Subscription subscription,
                       std::shared_ptr<const receive::SampleLayout> layout);
    /// The same with a subscription of its own.
    Result<void> start(const RecorderOptions& options, const receive::Receiver& receiver);
    /// Writes what is still waiting, has it on the disk and closes the file. Finished only if all of that
    /// went well: a disk or a share that takes the rows and loses them afterwards makes it Failed.
    void stop();

    /// Into the file, where its format has a place for it. Any thread
    void note(const RecordedNote& note);

    RecorderProgress progress() const;  ///< Any thread; rows, seconds and lost are of all files together
    /// Why it failed: DiskFull, FileNotWritable; code None otherwise.
    Error error() const;
    QString path() const;  ///< Of the file being written, or written last.

private:
    struct Worker;
    std::shared_ptr<Worker> worker() const;

    std::function<std::unique_ptr<RecordingFile>()> files_;
    mutable std::mutex mutex_;  ///< for the pointer: a new recording gets a new worker
    std::shared_ptr<Worker> d_;
};

}  // namespace tiller::recording
