// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A motion port that only records the calls. Each jog has a unique number and replaces the previous jog.

#include <QList>
#include <cstdint>

#include "robot/station/link/motion_port.h"

namespace tiller::test {

struct WrittenPort {
    std::uint64_t running = 0;  ///< 0: no motion
    std::uint64_t next = 0;
    QList<control::JogTarget> targets;  ///< targets of the start and of every refresh
    QList<control::StopCause> ends;
    MotionPort port{
        .beginJog = [this](const control::JogTarget& target) -> Result<MotionPort::Id> {
            targets << target;
            return running = ++next;
        },
        .beginMove = {},
        .hold = [this](MotionPort::Id id) { return id == running; },
        .endMotion =
            [this](MotionPort::Id id, control::StopCause cause) {
                running = id == running ? 0 : running;
                ends << cause;
            },
        .limits = [] { return control::MotionLimits(); },
        .holdWith =
            [this](MotionPort::Id id, const control::JogTarget& target) {
                targets << target;
                return id == running;
            },
    };

    WrittenPort() = default;
    WrittenPort(const WrittenPort&) = delete;
    WrittenPort& operator=(const WrittenPort&) = delete;
};

}  // namespace tiller::test
