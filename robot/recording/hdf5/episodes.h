// SPDX-License-Identifier: MIT
#pragma once

// Exports demonstrations as training data. Recordings are split into episodes and written to one HDF5 file in
// the layout of robomimic and similar tools: /data/demo_N with obs/, next_obs/, actions, rewards, dones.
// Source: robomimic's documentation of its datasets.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// A section of a recording.
struct Episode {
    RowRange rows;
    QString name{};  ///< origin: "program", or the text of a note
};

struct EpisodeChoice {
    enum class Cut {
        Program,  ///< from the start to the end of a program, according to runtime_state
        Notes,    ///< from one operator note to the next or to the end
        Whole,    ///< the whole recording
    };
    Cut cut = Cut::Program;
    double rate = 20;       ///< rows per second in the episodes (nearest earlier row); 0: all rows
    double shortest = 0.5;  ///< minimum duration [s]; shorter episodes are skipped
    /// Fields used as observations. A field that is missing in all recordings is an error.
    std::vector<std::string> observations = {"actual_q", "actual_qd", "actual_TCP_pose", "actual_TCP_force"};
    /// Value used as the action: a commanded value, or the value of a measured field in the next row.
    std::string action = "target_q";
};

struct EpisodeReport {
    int episodes = 0;
    std::uint64_t rows = 0;
    int tooShort = 0;
};

/// Finds the episodes of a recording.
/// Errors   FieldUnknown (no runtime_state), and read errors
Result<std::vector<Episode>> findEpisodes(const Recording& recording, EpisodeChoice::Cut cut);

/// Writes all episodes to one file.
/// Errors   FieldUnknown, FileNotWritable, DiskFull, InvalidArgument (no episodes), and read errors
/// Threads  one for the whole program, because libhdf5 is not thread-safe. Blocks: until the file is written
Result<EpisodeReport> writeEpisodes(const std::vector<const Recording*>& recordings, const Text& path,
                                    const EpisodeChoice& choice);

}  // namespace tiller::recording
