// SPDX-License-Identifier: MIT
#pragma once

// A listening port that returns plain descriptors, so that the simulator's loop can read and write them
// without Qt's buffers.

#include <QHostAddress>
#include <QTcpServer>
#include <vector>

#include "robot/core/native_socket.h"
#include "robot/core/result.h"

namespace tiller::simulator {

/// Threads  the one that constructed it, which has to process events regularly.
class Listener : public QTcpServer {
public:
    /// service  name of the service for the message: "RTDE"
    /// Errors   Rejected, naming port, address and a solution; AddressInvalid when the address is not one of
    /// this machine
    Result<void> open(const QHostAddress& address, std::uint16_t port, const char* service);

    /// Connections accepted since the last call, already configured; the caller owns them.
    std::vector<native_socket::Descriptor> takeAccepted();

protected:
    void incomingConnection(qintptr descriptor) override;

private:
    std::vector<native_socket::Descriptor> accepted_;
};

}  // namespace tiller::simulator
