// SPDX-License-Identifier: MIT
#pragma once

// Connects a QTcpSocket with tiller::connectTcp(), for this folder and robot/dashboard.

#include <QString>
#include <memory>

#include "robot/core/deadline.h"
#include "robot/core/result.h"

class QTcpSocket;

namespace tiller::script {

/// Connects to host:port.
/// Returns  a socket owned by the calling thread, with Nagle's algorithm disabled
/// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled; the context is "connect to
///          host:port"
/// Threads  any. Blocks: until the deadline
Result<std::unique_ptr<QTcpSocket>> openTcpSocket(const QString& host, int port, const Deadline& deadline);

}  // namespace tiller::script
