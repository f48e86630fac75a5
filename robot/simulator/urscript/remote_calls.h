// SPDX-License-Identifier: MIT
#pragma once

// Calls of methods on what rpc_factory() gave: each over a connection of its own, asked after once a frame.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/value.h"
#include "robot/simulator/urscript/xml_rpc.h"

namespace tiller::simulator::urscript {

/// Errors of all  ScriptError, which end the program.
class RemoteCalls {
public:
    explicit RemoteCalls(SocketHost& host) : host_(host) {}

    /// A handle of a server that need not be there yet.
    Result<std::int32_t> declare(std::string_view url);
    /// A handle, and the beginning of a look whether the server accepts connections.
    Result<std::int32_t> open(std::string_view url);
    /// True when somebody does; asked until then.
    Result<bool> opened(std::int32_t handle);

    /// Begins a call. Returns its number.
    Result<std::int64_t> begin(std::int32_t handle, std::string_view method,
                               std::span<const Value> arguments);
    /// Its result; asked until there is one.
    Result<std::optional<Value>> result(std::int64_t call);

private:
    static constexpr std::size_t kMostHandles = 100;
    static constexpr std::size_t kMostCalls = 32;  ///< under way; the oldest goes (its thread was killed)

    struct Call {
        std::string request;
        bool sent = false;
    };
    /// Not a name a script could use for its own.
    static std::string socketOf(std::int64_t call) { return "\nrpc" + std::to_string(call); }

    SocketHost& host_;
    std::map<std::int32_t, xml_rpc::Address> servers_;
    std::map<std::int64_t, Call> calls_;
    std::int64_t lastCall_ = 0;
};

}  // namespace tiller::simulator::urscript
