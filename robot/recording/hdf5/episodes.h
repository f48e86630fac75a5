// SPDX-License-Identifier: MIT
#pragma once

// Demonstrations as training data: recordings are cut into episodes and written as one HDF5 file in the layout that
// robomimic and tools like it read: /data/demo_N with obs/, next_obs/, actions, rewards, dones. Source: robomimic's
// documentation of its datasets.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// A part of a recording.
struct Episode {
    RowRange rows;
    QString name{};  ///< what it was cut by: "program", or the text of a note
};

struct EpisodeChoice {
    enum class Cut {
        Program,  ///< from a start of a program to its stop, by runtime_state
        Notes,    ///< from one note of the operator to the next, the last one to the end
        Whole,    ///< the recording is one
    };
    Cut cut = Cut::Program;
    double rate = 20;       ///< rows a second in the episodes, by the nearest row before; 0: all
    double shortest = 0.5;  ///< shorter ones are left out [s]
    /// Fields that become observations; those that no recording has are refused.
    std::vector<std::string> observations = {"actual_q", "actual_qd", "actual_TCP_pose", "actual_TCP_force"};
    /// What was commanded, as the action; the next row's value of a measured field does as well.
    std::string action = "target_q";
};

struct EpisodeReport {
    int episodes = 0;
    std::uint64_t rows = 0;
    int tooShort = 0;
};

/// Where a recording is cut.
/// Errors   FieldUnknown: it has no runtime_state to cut by; and those of reading
Result<std::vector<Episode>> findEpisodes(const Recording& recording, EpisodeChoice::Cut cut);

/// Errors   FieldUnknown, FileNotWritable, DiskFull, InvalidArgument (no episode in any of them), and those of reading
/// Threads  one in the program: libhdf5 is not made for more. Blocks: until it is written
Result<EpisodeReport> writeEpisodes(const std::vector<const Recording*>& recordings, const Text& path,
                                    const EpisodeChoice& choice);

}  // namespace tiller::recording
