// SPDX-License-Identifier: MIT
#pragma once

// The file format of a recorder. A format creates an encoder for each file, and the encoder converts samples
// to bytes. CSV is included here. Formats that need other libraries are in separate folders.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/text.h"
#include "robot/receive/sample.h"
#include "robot/recording/metadata.h"

namespace tiller::recording {

/// `source` of an operator's note, to distinguish it from a log line.
inline constexpr const char* kNoteSource = "note";
inline constexpr const char* kStepSource = "program";     ///< source of program steps
inline constexpr const char* kTriggerSource = "trigger";  ///< source of the cause of a triggered recording

/// A log line or a note added during a recording.
struct RecordedNote {
    std::int64_t utcNs = 0;  ///< [ns since 1970]
    int level = 20;          ///< as in rcl_interfaces/Log: 20 info, 30 warning, 40 error
    Text source = {};
    Text text = {};
};

/// Bytes for the file, and the number of rows in them.
struct RecordedPart {
    std::string bytes{};
    std::uint64_t rows = 0;
    std::uint64_t lost = 0;  ///< packets missing before these rows
};

/// Threads  one
class RecordingEncoder {
public:
    enum class Close {
        WhenDue,  ///< data up to a point where the file may end, now or within half a second
        Last,     ///< all data and the end of the file
    };
    virtual ~RecordingEncoder() = default;

    /// sample  in the layout of the setup. For MCAP, also in another layout: fields that it lacks have no
    ///         value
    /// utcNs   time of arrival [ns since 1970]
    virtual void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t utcNs) = 0;
    /// A format that does not keep notes receives only the notes of the recorder, and ignores them.
    virtual void add(const RecordedNote& note) = 0;
    /// Returns complete rows only, so that a file that ends after them is readable. The first part includes
    /// the header.
    virtual RecordedPart take(Close how) = 0;
    /// Returns the usable length of a partially written part, and the number of rows in it.
    virtual std::size_t keepOf(std::string_view written, std::uint64_t& rows) const = 0;
};

struct RecordingSetup {
    std::shared_ptr<const receive::SampleLayout> layout;
    std::vector<std::string> fields;  ///< fields to record, all in the layout
    bool asGiven = false;
};

/// Threads  any
class RecordingFormat {
public:
    virtual ~RecordingFormat() = default;
    /// Null if no field can be recorded.
    virtual std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const = 0;
    /// False: the recorder writes notes to a CSV file next to the recording.
    virtual bool keepsNotes() const { return true; }
};

/// CSV format, as described in recorder.h.
/// head  metadata that is written above the header with the start time and the units, one line each:
///       "# name: value"; empty: the header is the first line
std::shared_ptr<const RecordingFormat> csvFormat(Metadata head = {});

}  // namespace tiller::recording
