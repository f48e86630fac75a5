// SPDX-License-Identifier: MIT
#pragma once

// Sends URScript to the controller. It keeps the connection open after sending: a controller can drop a
// program whose sender hangs up at once. What became of the program is told by the primary interface only,
// see primary_client.h; the state the controller streams here is thrown away whenever the client is used.

#include <QString>

#include "robot/core/deadline.h"
#include "robot/core/native_socket.h"
#include "robot/core/result.h"
#include "robot/core/text.h"

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
    /// Sends the text and sees it off the machine. Adds the newline without which nothing is executed.
    /// Errors   NotConnected, ConnectionClosed, Timeout, Cancelled, InvalidArgument (empty text)
    Result<void> send(const Text& text, const Deadline& deadline);
    void close();  ///< Harmless when not connected.
    /// Not any more once the controller has hung up, which one does whose stream nobody reads for minutes.
    bool isConnected();

private:
    QString host_;
    int port_;
    native_socket::Descriptor socket_ = -1;
};

}  // namespace tiller::script
