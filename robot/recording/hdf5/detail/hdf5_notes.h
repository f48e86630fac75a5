// SPDX-License-Identifier: MIT
#pragma once

// The notes, warnings and errors of an HDF5 recording: a group with one data set per property, which h5py,
// MATLAB and Octave read. Private to robot/recording/hdf5.

#include <string_view>
#include <vector>

#include "robot/recording/detail/exported_events.h"
#include "robot/recording/hdf5/detail/hdf5_handle.h"

namespace tiller::recording::hdf5 {

/// Writes no group if there are no notes.
bool writeNotes(hid_t file, const std::vector<ExportedEvent>& events);
/// True if the file has a group written by writeNotes().
bool hasNotes(hid_t file);
/// True for the group and its data sets.
bool isOfNotes(std::string_view name);
/// Times are those in the file. Empty if the group is damaged.
std::vector<RecordedEvent> readNotes(hid_t file);

}  // namespace tiller::recording::hdf5
