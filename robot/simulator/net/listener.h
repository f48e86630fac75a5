// SPDX-License-Identifier: MIT
#pragma once

// A listening port that returns plain descriptors, because the simulator bypasses Qt's socket buffers.

#include <QHostAddress>
#include <QTcpServer>
#include <vector>

#include "robot/core/result.h"
#include "robot/platform/native_socket.h"

namespace tiller::simulator {

/// Threads  the constructing thread, which must process events regularly
class Listener : public QTcpServer {
public:
    /// service  name of the service for the message, e.g. "RTDE"
    /// Errors   Rejected, naming port, address and a solution; AddressInvalid if this machine does not have
    /// the address
    Result<void> open(const QHostAddress& address, std::uint16_t port, const char* service);

    /// Returns the connections accepted since the last call, with all socket options set. The caller takes
    /// ownership.
    std::vector<native_socket::Descriptor> takeAccepted();

protected:
    void incomingConnection(qintptr descriptor) override;

private:
    std::vector<native_socket::Descriptor> accepted_;
};

}  // namespace tiller::simulator
