// SPDX-License-Identifier: MIT
#pragma once

// First software versions that support features used by more than one type of request. Source: the vendor's
// script manual.

#include "robot/core/version.h"

namespace tiller::control {

constexpr SoftwareVersion kESeries{5, 0, 0, 0};
constexpr SoftwareVersion kContactSince{5, 4, 0, 0};

}  // namespace tiller::control
