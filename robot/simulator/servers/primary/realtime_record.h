// SPDX-License-Identifier: MIT
#pragma once

// The record that the realtime interface (ports 30003 and 30013) sends in every control period. Source:
// realtime interface manual. The size of the record increased with newer software.

#include <cstdint>
#include <vector>

#include "robot/simulator/plant/telemetry.h"

namespace tiller::simulator {

/// Size of the record [bytes] by software version, from 3.0 on.
std::size_t realtimeRecordSize(const SoftwareVersion& software);

/// Writes the record to `into`, replacing its content.
void writeRealtimeRecord(const Telemetry& now, std::vector<std::uint8_t>& into);

}  // namespace tiller::simulator
