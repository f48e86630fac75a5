// SPDX-License-Identifier: MIT
#pragma once

// The messages every ROS 2 tool knows, made from a sample: joint states, wrench, TCP transform, log; and ours for the
// summary of many rows. Definitions are complete, with all that they refer to. CDR by libfastcdr.
// Source: the .msg files of ROS 2

#include <cstdint>
#include <span>
#include <string>

#include "robot/receive/sample.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording::mcap {

struct MessageType {
    const char* name;        ///< "sensor_msgs/msg/JointState"
    const char* definition;  ///< ros2msg
};
const MessageType&
jointStateType();  ///< Names as the vendor's ROS driver has them; efforts are currents [A], as there.
const MessageType& wrenchType();     ///< Force and torque at the TCP, in the frame "base".
const MessageType& transformType();  ///< "base" to "tool0_controller".
const MessageType& logType();        ///< A line of the log.
const MessageType& summaryType();    ///< Least, greatest and mean value of many rows.

/// Each empties `out` first. utcNs  goes into the header. Returns  false: the sample has not what it takes.
bool writeJointState(const receive::Sample& sample, std::int64_t utcNs, std::string& out);
bool writeWrench(const receive::Sample& sample, std::int64_t utcNs, std::string& out);     ///< As above.
bool writeTransform(const receive::Sample& sample, std::int64_t utcNs, std::string& out);  ///< As above.
void writeLog(const RecordedNote& note, std::string& out);                                 ///< As above.
/// The opposite. Returns  false when it is broken
bool readLog(std::string_view message, RecordedNote& note);

/// rowsEach rows from firstRow on, of each column.
struct SummaryMessage {
    std::uint64_t firstRow = 0;
    std::uint32_t rowsEach = 0;
    std::vector<double> min{};
    std::vector<double> max{};
    std::vector<double> mean{};
};
void writeSummary(const SummaryMessage& summary, std::string& out);   ///< As above.
bool readSummary(std::string_view message, SummaryMessage& summary);  ///< Returns false when it is broken.
/// Of some columns only, which is many times as fast.
/// places  of the columns in the lists; NaN for those beyond them
bool readSummary(std::string_view message, std::span<const std::size_t> places, SummaryMessage& summary);

}  // namespace tiller::recording::mcap
