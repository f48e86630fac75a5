// SPDX-License-Identifier: MIT
#pragma once

// Sends URScript to the controller. The connection stays open after sending, because a controller can drop a
// program if its sender disconnects immediately. The outcome of the program is only reported on the primary
// interface, see primary_client.h; data received on this connection are discarded.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/platform/native_socket.h"

namespace tiller::script {

inline constexpr int kPrimaryPort = 30001;
inline constexpr int kSecondaryPort = 30002;

/// Threads  any, one at a time
class ScriptClient {
public:
    /// port  30001 to 30003, offset included
    explicit ScriptClient(Text host, int port = kPrimaryPort);
    ~ScriptClient();
    ScriptClient(const ScriptClient&) = delete;
    ScriptClient& operator=(const ScriptClient&) = delete;

    /// Errors   AddressInvalid, HostUnreachable, ConnectionRefused, Timeout, Cancelled
    Result<void> connect(const Deadline& deadline);
    /// Sends the text and waits until it has been transmitted. Adds the final newline that the controller
    /// requires.
    /// Errors   NotConnected, ConnectionClosed, Timeout, Cancelled, InvalidArgument (empty text)
    Result<void> send(const Text& text, const Deadline& deadline);
    void close();  ///< No effect if not connected.
    /// False after the controller has closed the connection, e.g. because its data were not read for minutes.
    bool isConnected();

private:
    QString host_;
    int port_;
    native_socket::Descriptor socket_ = -1;
};

}  // namespace tiller::script
