// SPDX-License-Identifier: MIT
#pragma once

// Method calls on the result of rpc_factory(). Each call uses a separate connection and is polled once per
// frame.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/value.h"
#include "robot/simulator/urscript/xml_rpc.h"

namespace tiller::simulator::urscript {

/// Errors  all functions: ScriptError, which ends the program
class RemoteCalls {
public:
    explicit RemoteCalls(SocketHost& host) : host_(host) {}

    /// Returns a handle without checking whether the server is reachable.
    Result<std::int32_t> declare(std::string_view url);
    /// Returns a handle and starts to check whether the server accepts connections.
    Result<std::int32_t> open(std::string_view url);
    /// Returns true when the server accepts connections. Call repeatedly until it returns true.
    Result<bool> opened(std::int32_t handle);

    /// Starts a call and returns its number.
    Result<std::int64_t> begin(std::int32_t handle, std::string_view method,
                               std::span<const Value> arguments);
    /// Returns the result of a call; empty while it is not available. Call repeatedly until the result is
    /// available.
    Result<std::optional<Value>> result(std::int64_t call);

private:
    static constexpr std::size_t kMaxHandles = 100;
    /// Beyond this number, the oldest call is dropped, which normally belongs to a killed thread.
    static constexpr std::size_t kMaxCalls = 32;

    struct Call {
        std::string request;
        bool sent = false;
    };
    /// The newline prevents conflicts, because socket names in scripts cannot contain it.
    static std::string socketOf(std::int64_t call) { return "\nrpc" + std::to_string(call); }

    SocketHost& host_;
    std::map<std::int32_t, xml_rpc::Address> servers_;
    std::map<std::int64_t, Call> calls_;
    std::int64_t lastCall_ = 0;
};

}  // namespace tiller::simulator::urscript
