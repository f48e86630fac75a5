// SPDX-License-Identifier: MIT
#pragma once

// Names used by the writer and the reader of Tiller's recordings. Private to robot/recording/mcap.

namespace tiller::recording::mcap {

inline constexpr const char* kFactsName = "recording";  ///< name of the metadata record
inline constexpr const char* kLogTopic = "/rosout";
inline constexpr const char* kSummaryTopic =
    "/robot_state/summary_";  ///< followed by the number of rows per summary
inline constexpr const char* kSummaryColumns =
    "columns";  ///< key in the channel metadata: names of the columns in order

}  // namespace tiller::recording::mcap
