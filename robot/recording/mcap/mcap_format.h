// SPDX-License-Identifier: MIT
#pragma once

// Recordings as MCAP files with the profile ros2. Each packet is stored as one flat message with all fields.
// The file also contains joint state, wrench and transform messages for ROS tools, the log, and summaries of
// many rows, so that hours of data open at once. Each chunk is compressed and completed within half a second,
// which limits the loss of data in a crash.

#include <chrono>
#include <memory>
#include <string>

#include "robot/recording/recording_format.h"

namespace tiller::recording {

struct McapFormatOptions {
    /// Metadata of the recording: "model", "serial_number", "software" ...
    Metadata facts{};
    /// An attached file, e.g. the project. Empty name: no attachment.
    std::string attachmentName{};
    std::string attachment{};
    /// Add joint state, wrench and transform messages for ROS tools. The file becomes about 25 % larger.
    bool ros = true;
    int compression = 1;  ///< zstd level, 1 to 19; 0: none
    /// A chunk of this age is completed at the next call by the recorder (every 100 ms).
    std::chrono::milliseconds closeAfter{400};
};

/// Threads  any
std::shared_ptr<const RecordingFormat> mcapFormat(McapFormatOptions options = {});

}  // namespace tiller::recording
