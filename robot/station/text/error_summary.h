// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "robot/core/error.h"

namespace tiller::texts {

/// The cause and the suggested action, without the names of internal requests and without messages of other
/// components. Program errors keep the message of the controller, and sentences for the operator are
/// unchanged.
QString errorSummary(const Error& error);

}  // namespace tiller::texts
