// SPDX-License-Identifier: MIT
#pragma once

// What a recorder writes, apart from when and where: a format makes an encoder for each file, and the encoder turns
// samples into bytes. CSV is here; others, which need more than this library, are in rooms of their own.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/text.h"
#include "robot/receive/sample.h"

namespace tiller::recording {

/// What is said while recording: a line of the log, or a note.
struct RecordedNote {
    std::int64_t utcNs = 0;  ///< [ns since 1970]
    int level = 20;          ///< as in rcl_interfaces/Log: 20 info, 30 warning, 40 error
    Text source = {};
    Text text = {};
};

/// Bytes for the file, and what is in them.
struct RecordedPart {
    std::string bytes{};
    std::uint64_t rows = 0;
    std::uint64_t lost = 0;  ///< packages missing before those rows
};

/// Threads  one
class RecordingEncoder {
public:
    enum class Close {
        WhenDue,  ///< what can be cut behind without harm, now or in half a second
        Last,     ///< everything, and the end of the file
    };
    virtual ~RecordingEncoder() = default;

    /// utcNs  when it was received [ns since 1970]
    virtual void add(const receive::Sample& sample, std::uint64_t lost, std::int64_t utcNs) = 0;
    virtual void add(const RecordedNote& note) = 0;  ///< Formats without a place for it leave it out.
    /// Whole rows only: a file that ends behind them can be read. The first part begins the file.
    virtual RecordedPart take(Close how) = 0;
    /// How much of a part that was written up to here is worth keeping, with its rows.
    virtual std::size_t keepOf(std::string_view written, std::uint64_t& rows) const = 0;
};

struct RecordingSetup {
    std::shared_ptr<const receive::SampleLayout> layout;
    std::vector<std::string> fields;  ///< all of which the layout has, or had
    bool asGiven = false;
};

/// Threads  any
class RecordingFormat {
public:
    virtual ~RecordingFormat() = default;
    /// Null when there is nothing to record among the fields.
    virtual std::unique_ptr<RecordingEncoder> encoder(const RecordingSetup& setup) const = 0;
};

/// Text, as described in recorder.h.
std::shared_ptr<const RecordingFormat> csvFormat();

}  // namespace tiller::recording
