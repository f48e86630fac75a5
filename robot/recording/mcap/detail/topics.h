// SPDX-License-Identifier: MIT
#pragma once

// What the writer and the reader of our recordings agree upon. Private to MCAP.

namespace tiller::recording::mcap {

inline constexpr const char* kFactsName = "recording";  ///< of the metadata record
inline constexpr const char* kLogTopic = "/rosout";
inline constexpr const char* kSummaryTopic = "/robot_state/summary_";  ///< and how many rows each is of
inline constexpr const char* kSummaryColumns =
    "columns";  ///< of the channel's metadata: their names, in order

}  // namespace tiller::recording::mcap
