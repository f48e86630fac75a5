// SPDX-License-Identifier: MIT
#pragma once

// The socket functions of the system, for the source files of native_socket.h.

#ifdef _WIN32
#include <winsock2.h>
// This header must be included after winsock2.h.
#include <ws2tcpip.h>
#else
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#endif

#include "robot/platform/native_socket.h"

namespace tiller::native_socket {

#ifdef _WIN32
using SystemSocket = SOCKET;
#else
using SystemSocket = int;
#endif

inline SystemSocket handle(Descriptor socket) {
    return static_cast<SystemSocket>(socket);
}

/// Sets the option of a new socket that lets one program listen on a port at a time, also shortly after another
/// program has ended.
void reservePort(Descriptor listener);

}  // namespace tiller::native_socket
