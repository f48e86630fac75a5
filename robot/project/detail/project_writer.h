// SPDX-License-Identifier: MIT
#pragma once

// Writes a project to JSON. Empty fields that version 1 did not have are omitted. Private to robot/project.

#include <QJsonObject>

#include "robot/project/project_file.h"

namespace tiller::project {

inline constexpr char kProjectFormat[] = "tiller-project";

/// The complete content of the file.
QJsonObject toJson(const Project& document);

}  // namespace tiller::project
