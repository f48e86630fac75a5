// SPDX-License-Identifier: MIT
#pragma once

// Creates standard ROS 2 messages from a sample: joint states, wrench, TCP transform and log. Also defines
// Tiller's message with summaries of many rows. Definitions include all referenced types. CDR by libfastcdr.
// Source: the .msg files of ROS 2

#include <cstdint>
#include <span>
#include <string>

#include "robot/receive/sample.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording::mcap {

struct MessageType {
    const char* name;        ///< e.g. "sensor_msgs/msg/JointState"
    const char* definition;  ///< ros2msg
};
const MessageType& jointStateType();  ///< Names and efforts (currents [A]) as in the vendor's ROS driver.
const MessageType& wrenchType();      ///< Force and torque at the TCP, in the frame "base".
const MessageType& transformType();   ///< From "base" to "tool0_controller".
const MessageType& logType();         ///< One line of the log.
const MessageType& summaryType();     ///< Minimum, maximum and mean of many rows.

/// All write functions clear `out` first.
/// utcNs    timestamp in the header
/// Returns  false if the sample does not contain the required fields
bool writeJointState(const receive::Sample& sample, std::int64_t utcNs, std::string& out);
bool writeWrench(const receive::Sample& sample, std::int64_t utcNs,
                 std::string& out);  ///< Like writeJointState().
bool writeTransform(const receive::Sample& sample, std::int64_t utcNs,
                    std::string& out);                      ///< Like writeJointState().
void writeLog(const RecordedNote& note, std::string& out);  ///< Clears `out` first.
/// Returns  false if the message is invalid
bool readLog(std::string_view message, RecordedNote& note);

/// Statistics of each column for groups of `rowsEach` rows, starting at firstRow.
struct SummaryMessage {
    std::uint64_t firstRow = 0;
    std::uint32_t rowsEach = 0;
    std::vector<double> min{};
    std::vector<double> max{};
    std::vector<double> mean{};
};
void writeSummary(const SummaryMessage& summary, std::string& out);  ///< Clears `out` first.
bool readSummary(std::string_view message,
                 SummaryMessage& summary);  ///< Returns  false if the message is invalid
/// Reads only some columns, which is much faster.
/// places  indices of the columns in the lists; missing columns are NaN
bool readSummary(std::string_view message, std::span<const std::size_t> places, SummaryMessage& summary);

}  // namespace tiller::recording::mcap
