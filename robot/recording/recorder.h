// SPDX-License-Identifier: MIT
#pragma once

// Records robot data to a file in a selectable format, with one row per packet or per n packets.
//
// The default format is CSV. Its first column is `timestamp`, followed by one column per number with the
// names of ur_rtde recordings (actual_q_0 ... actual_q_5). The last column, `packages_lost`, is the number of
// packets missing before this row (0 in a recording without gaps). Numbers are written as the shortest text
// that converts back exactly, with a decimal point in all locales. Fields that the robot does not have are
// empty; pandas reads them as NaN. Notes, steps of programs, and warnings and errors of the log are in a
// second file, "a.notes.csv" for "a.csv", with the columns row (number of rows before the note), utc, level,
// source and text.
//
// Complete rows are written at least every half second. If the process is killed, less than a second of data
// is lost, and the file ends with a complete row.

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

namespace tiller::publish {
class Publisher;
}

namespace tiller::recording {

using tiller::operator<<;  // makes the enumerations below printable

class RecordingFile;

/// Fields recorded by ur_rtde. Default of the command-line tool for CSV files.
std::vector<std::string> defaultRecordedFields();

/// Name of the last column.
inline constexpr const char* kLostColumn = "packages_lost";

struct RecorderOptions {
    Text path = {};
    /// Field names; the receiver must have subscribed to all of these fields. Empty: all fields of the
    /// receiver. `timestamp` is always the first column.
    std::vector<std::string> fields{};
    bool asGiven = false;  ///< record exactly these fields in this order, without timestamp and packages_lost
    /// Record every n-th packet, 1 or more. Skipped packets are not lost packets.
    int every = 1;
    /// Null: CSV. A path that ends in .mcap, .h5 or .hdf5 is then refused. formatForPath() in
    /// recording/formats/open_recording.h selects the format by the file name extension.
    std::shared_ptr<const RecordingFormat> format{};
    /// If set, the recorder waits for the trigger and writes numbered files: see numberedPath(). Empty: the
    /// recorder writes one file and starts at once.
    std::optional<RecordingTrigger> trigger{};
    /// If set, the recording is divided into numbered files: see numberedPath(). No packet is lost between
    /// two files.
    double fileSeconds = 0;      ///< maximum duration of a file [s]; 0: no limit
    std::int64_t fileBytes = 0;  ///< a file is complete when it has this size [bytes]; 0: no limit
    /// Minimum free space on the disk [bytes]. Below it, the recording ends with DiskFull. 0: the recording
    /// ends when the disk is full.
    std::int64_t keepFree = 0;
};

enum class RecorderState {
    Idle,
    Recording,
    Waiting,   ///< waiting for the trigger
    Finished,  ///< stopped; the file is complete and synced
    Failed,    ///< see error(); data written earlier are kept
};

struct RecorderProgress {
    RecorderState state = RecorderState::Idle;
    std::uint64_t rows = 0;      ///< rows written to the file
    double seconds = 0;          ///< time from the first row to the last, on the receiver's clock
    std::uint64_t lost = 0;      ///< packets missing in the file, for any reason
    std::int64_t bytes = 0;      ///< size of the file
    int files = 0;               ///< number of files started
    int restarts = 0;            ///< number of controller restarts during the recording, at which the
                                 ///< controller time decreased
    std::int64_t freeBytes = 0;  ///< free space on the disk of the file, updated about once per second
};

/// Writes a subscription to the file in the thread of a publisher. By default, each recording creates a
/// publisher.
/// Threads  start() and stop(): one thread. All others: any
class Recorder {
public:
    Recorder();
    /// publisher  shared with other sinks
    explicit Recorder(std::shared_ptr<publish::Publisher> publisher);
    /// files  factory for the output file; for tests
    explicit Recorder(std::function<std::unique_ptr<RecordingFile>()> files);
    ~Recorder();  ///< calls stop()
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Creates the file (an existing file is replaced), writes the header and starts with the next packet.
    /// Errors   FileNotWritable (also while another recording writes to the file), DiskFull; FieldUnknown
    ///          with each field that the receiver does not receive (no file is created, and an existing file
    ///          is unchanged); InvalidArgument (a recording is in progress, or the path has the extension of
    ///          another format)
    /// Blocks   until the file system has created the file
    Result<void> start(const RecorderOptions& options, receive::Subscription subscription,
                       std::shared_ptr<const receive::SampleLayout> layout);
    /// Like the function above, with a new subscription.
    Result<void> start(const RecorderOptions& options, const receive::Receiver& receiver);
    /// Writes the remaining rows, then syncs and closes the file. The state is Finished only if all steps
    /// have succeeded. The state is Failed if a disk or share lost data that it had accepted.
    void stop();

    /// Adds a note to the recording or to its notes file. Threads: any
    void note(const RecordedNote& note);

    /// Reason why notes could not be written to the notes file, while the recording continues; otherwise code
    /// None. Threads: any
    Error notesError() const;

    RecorderProgress progress() const;  ///< Rows, seconds and lost are totals of all files. Threads: any
    /// Reason for a failure: DiskFull or FileNotWritable; otherwise code None.
    Error error() const;
    QString path() const;  ///< Path of the current or last file.

private:
    struct Worker;
    std::shared_ptr<Worker> worker() const;

    std::function<std::unique_ptr<RecordingFile>()> files_;
    std::shared_ptr<publish::Publisher> publisher_;  ///< null: each recording creates one
    mutable std::mutex mutex_;  ///< protects the pointer, because each recording has a new worker
    std::shared_ptr<Worker> d_;
};

}  // namespace tiller::recording
