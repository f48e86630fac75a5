// SPDX-License-Identifier: MIT
#pragma once

// The one place that opens TCP connections. It needs neither an application object nor an event loop, so that
// programs without Qt can use the backend from any thread, and it looks at the deadline and its cancel flag
// while it waits.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/native_socket.h"
#include "robot/core/result.h"

namespace tiller {

/// Connects to host:port, trying the addresses of the name one after the other.
/// port     1 ... 65535
/// context  for the error; empty: "connect to host:port"
/// Returns  a connected descriptor, prepared (native_socket::prepare); the caller closes it
/// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled, Internal
/// Threads  any. Blocks: until the deadline (looking a name up, not an address, takes as long as the system
///          does)
Result<native_socket::Descriptor> connectTcp(const QString& host, int port, const Deadline& deadline,
                                             QString context = {});

}  // namespace tiller
