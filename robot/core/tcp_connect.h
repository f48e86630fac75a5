// SPDX-License-Identifier: MIT
#pragma once

// Opens all TCP connections. No application object or event loop is needed, so programs without Qt can use
// the library from any thread. The deadline and its cancel token are checked while waiting.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/platform/native_socket.h"

namespace tiller {

/// Connects to host:port. Tries all addresses of a host name, one after the other.
/// port     1 ... 65535
/// context  of the error; empty: "connect to host:port"
/// Returns  a connected descriptor, prepared by native_socket::prepare(); the caller must close it
/// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled, Internal
/// Threads  any. Blocks: until the deadline, but the duration of name resolution depends on the system
Result<native_socket::Descriptor> connectTcp(const QString& host, int port, const Deadline& deadline,
                                             QString context = {});

}  // namespace tiller
