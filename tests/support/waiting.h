// SPDX-License-Identifier: MIT
#pragma once

// For calls that wait: how long a test lets them, and what they say when they fail.

#include <QByteArray>
#include <chrono>

#include "robot/core/deadline.h"

namespace tiller::test {

/// Longer than anything takes on a machine that works: a test that waits so long has failed.
inline Deadline patience() {
    return Deadline::after(std::chrono::seconds(60));
}

/// Of a result that is an error.
template <class Result>
QByteArray why(const Result& result) {
    return result.error().toString().toUtf8();
}

}  // namespace tiller::test
