// SPDX-License-Identifier: MIT
#pragma once

// Parses the bytes of the primary interface into messages and state, without a socket or thread. Unknown
// packages are skipped. Truncated packages and packages with invalid lengths are counted and skipped. No
// input can crash the parser. Source: Universal Robots client interface manual.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/script/controller_message.h"

namespace tiller::script {

class PrimaryParser {
public:
    /// Processes received bytes, regardless of how they are segmented.
    /// Returns  false for an invalid length field. The start of the next package is then unknown: call
    /// reset() and open a new connection.
    bool feed(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs);
    /// Discards an incomplete package. Call this function for a new connection.
    void reset();

    std::vector<ControllerMessage> takeMessages();
    const PrimaryState& state() const { return state_; }
    const std::optional<RobotConfiguration>& configuration() const { return configuration_; }
    std::uint64_t malformed() const { return malformed_; }

    /// Maximum valid package length [bytes]. Known packages are shorter than 4096 bytes.
    static constexpr std::size_t kMaxPackage = 1 << 17;

private:
    void package(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs);
    bool robotState(std::span<const std::uint8_t> bytes);
    bool subPackage(std::uint8_t type, std::span<const std::uint8_t> bytes);
    bool robotMessage(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs);

    std::vector<std::uint8_t> buffer_;
    std::vector<ControllerMessage> messages_;
    PrimaryState state_;
    std::optional<RobotConfiguration> configuration_;
    bool calibrated_ = false;  ///< the DH parameters are from KinematicsInfo
    std::uint64_t malformed_ = 0;
};

}  // namespace tiller::script
