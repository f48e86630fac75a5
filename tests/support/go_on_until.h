// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QTest>
#include <chrono>
#include <functional>

#include "tests/support/virtual_cell.h"

namespace tiller::test {

/// Advances the cell until the condition is true, while real time passes as well, because workers and other
/// threads need real time. Returns false after a minute of real time; even a busy machine needs less.
inline bool goOnUntil(VirtualCell& cell, const std::function<bool()>& condition, int stepMs = 4) {
    const QDeadlineTimer hangs(std::chrono::minutes(1));
    while (!condition()) {
        if (hangs.hasExpired()) {
            return false;
        }
        cell.advanceMs(stepMs);
        QTest::qWait(1);
    }
    return true;
}

}  // namespace tiller::test
