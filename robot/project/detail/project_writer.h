// SPDX-License-Identifier: MIT
#pragma once

// From a project to JSON. What a version 1 did not have is left out where there is nothing to say. Private to
// robot/project.

#include <QJsonObject>

#include "robot/project/project_file.h"

namespace tiller::project {

inline constexpr char kProjectFormat[] = "tiller-project";

/// Everything of the file.
QJsonObject toJson(const Project& document);

}  // namespace tiller::project
