// SPDX-License-Identifier: MIT
#pragma once

// The record that the realtime interface (ports 30003, 30013) sends every control period. Source: realtime
// interface manual; its size increased with newer software.

#include <cstdint>
#include <vector>

#include "robot/simulator/box/telemetry.h"

namespace tiller::simulator {

/// Size of the record [bytes] by software version, from 3.0 on.
std::size_t realtimeRecordSize(const SoftwareVersion& software);

/// Replaces `into` with the record.
void writeRealtimeRecord(const Telemetry& now, std::vector<std::uint8_t>& into);

}  // namespace tiller::simulator
