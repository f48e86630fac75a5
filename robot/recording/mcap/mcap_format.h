// SPDX-License-Identifier: MIT
#pragma once

// Recordings as MCAP files of the profile ros2: every package as one flat message with all its fields, as joint state,
// wrench and transform for tools that know ROS, the log, and a summary of many rows so that hours open at once. Each
// chunk is compressed and closed within half a second, so that is what a crash can cost.

#include <chrono>
#include <map>
#include <memory>
#include <string>

#include "robot/recording/recording_format.h"

namespace tiller::recording {

struct McapFormatOptions {
    /// About the recording: "model", "serial_number", "software" ... Goes into the file as metadata.
    std::map<std::string, std::string> facts{};
    /// A file to be kept inside, as the project; none when its name is empty.
    std::string attachmentName{};
    std::string attachment{};
    /// Joint state, wrench and transform beside the flat message, for ROS tools; a quarter more to write.
    bool ros = true;
    int compression = 1;  ///< of zstd, 1 to 19; 0: none
    /// A chunk this old is closed when the recorder comes next, every 100 ms.
    std::chrono::milliseconds closeAfter{400};
};

/// Threads  any
std::shared_ptr<const RecordingFormat> mcapFormat(McapFormatOptions options = {});

}  // namespace tiller::recording
