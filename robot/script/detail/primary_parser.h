// SPDX-License-Identifier: MIT
#pragma once

// The bytes of the primary interface made into messages and state. No socket, no thread. What it does not
// know it skips, what is cut short or lies about its size it counts and skips; nothing a peer sends can crash
// it. Source: Universal Robots client interface manual.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/script/controller_message.h"

namespace tiller::script {

class PrimaryParser {
public:
    /// Takes bytes as they came from the socket, however they were cut.
    /// Returns  false when a length field makes no sense: where the next package begins is unknown, and the
    ///          connection has to be made again (reset() first)
    bool feed(std::span<const std::uint8_t> bytes, std::int64_t hostTimeNs);
    /// Forgets a half package; for a new connection.
    void reset();

    std::vector<ControllerMessage> takeMessages();
    const PrimaryState& state() const { return state_; }
    const std::optional<RobotConfiguration>& configuration() const { return configuration_; }
    std::uint64_t malformed() const { return malformed_; }

    /// A length above this is taken for garbage [bytes]. Known packages stay below 4096.
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
    bool calibrated_ = false;  ///< its DH parameters are of KinematicsInfo
    std::uint64_t malformed_ = 0;
};

}  // namespace tiller::script
