// SPDX-License-Identifier: MIT
#pragma once

// Replaces foxglove_server.h in a build without Qt WebSockets. Private to this module.

#include <QString>
#include <cstdint>
#include <string>

#include "robot/core/result.h"
#include "robot/live/detail/allowed_origins.h"
#include "robot/live/live_output.h"

namespace tiller::live {

struct LiveChannel {
    std::uint32_t id = 0;
    std::string topic{};
    std::string type{};
    std::string definition{};
};

/// A server that cannot be started.
class FoxgloveServer {
public:
    FoxgloveServer(const QString&, const AllowedOrigins&, const LiveLimits&) {}

    Result<void> listen(const QString& address, std::uint16_t port) {
        return Error{
            ErrorCode::Rejected, QStringLiteral("listen on %1 port %2").arg(address).arg(port),
            QStringLiteral("this program was built without Qt WebSockets, which the server needs; use only "
                           "UDP (--no-server --udp ADDRESS), or install a version with Qt WebSockets")};
    }
    std::uint16_t port() const { return 0; }
    int viewers() const { return 0; }
    std::uint64_t sent() const { return 0; }
    std::uint64_t dropped() const { return 0; }
    std::uint64_t disconnected() const { return 0; }
    std::uint64_t refused() const { return 0; }
    QString refusedOrigin() const { return {}; }
    void advertise(const LiveChannel&) {}
    bool isWanted(std::uint32_t) const { return false; }
    void send(std::uint32_t, std::uint64_t, const std::string&) {}
};

}  // namespace tiller::live
