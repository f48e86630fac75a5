// SPDX-License-Identifier: MIT
#pragma once

// Deadlines and failure messages for waiting calls in tests.

#include <QByteArray>
#include <chrono>

#include "robot/core/deadline.h"

namespace tiller::test {

/// Timeout that exceeds the time of any operation on a working computer. Reaching it is a failure.
inline Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(60));
}

/// Returns the error text of a result.
template <class Result>
QByteArray why(const Result& result) {
    return result.error().toString().toUtf8();
}

}  // namespace tiller::test
