// SPDX-License-Identifier: MIT
#pragma once

#include "robot/recording/recording.h"

namespace tiller::recording {

/// What the catalogue of RTDE fields knows of a column, by its name: its unit and whether it is whole. A unit that is
/// there stays.
void addKnowledge(RecordedColumn& column);
/// Unit of one number of a field: "m" of the first three numbers of a pose, "rad" of the others.
std::string unitOf(std::string_view field, std::size_t component);

}  // namespace tiller::recording
