// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/recording/recording.h"

namespace tiller::recording {

/// Adds the unit and the integer flag of a column from the catalogue of RTDE fields, by column name. An
/// existing unit is kept.
void addKnowledge(RecordedColumn& column);
/// Unit of one component of a field: "m" for the first three numbers of a pose, "rad" for the others.
std::string unitOf(std::string_view field, std::size_t component);
/// True for an RTDE field or one of its components, and for the number of lost packets, but not for
/// `timestamp`, which other programs use too.
bool isOfRobot(const RecordedColumn& column);
/// The column `timestamp`, or the first column named time, seconds or t; empty if no such column exists.
std::optional<std::size_t> timeColumnOf(const std::vector<RecordedColumn>& columns);

}  // namespace tiller::recording
