// SPDX-License-Identifier: MIT
#pragma once

// Since when robots know what more than one kind of request asks for. Source: the vendor's script manual.

#include "robot/core/version.h"

namespace tiller::control {

constexpr SoftwareVersion kESeries{5, 0, 0, 0};
constexpr SoftwareVersion kContactSince{5, 4, 0, 0};

}  // namespace tiller::control
