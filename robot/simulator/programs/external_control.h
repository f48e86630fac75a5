// SPDX-License-Identifier: MIT
#pragma once

// The program node "External Control", with which the pendant runs a script from another computer. When the
// program is played, the robot requests the script from that computer and inserts it in place of the node.
// The request is one line of text; the end of the script is not marked. The part between the header marks of
// the script is placed at the beginning of the program and runs first.

#include <QByteArray>
#include <QElapsedTimer>
#include <QString>
#include <QTcpSocket>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace tiller::simulator {

/// Address of the computer that provides the script, with the defaults of a new installation.
struct ScriptProvider {
    QString host = QStringLiteral("192.168.56.1");
    std::uint16_t port = 50002;
};

/// Reads the address from an installation file (gzipped XML). Empty if the file contains none.
std::optional<ScriptProvider> scriptProviderOf(const QByteArray& installation);

/// Inserts the script in place of the External Control nodes of the program.
std::string withControlScript(std::string program, std::string script);

/// Threads  one that processes events. No function blocks.
class ControlScriptRequest {
public:
    /// silence  pause in the data after which the script is considered complete
    ControlScriptRequest(const ScriptProvider& provider, std::chrono::milliseconds silence);

    /// The script; an empty text if it could not be read, no value while it is being received.
    std::optional<std::string> poll();

private:
    QTcpSocket socket_;
    std::chrono::milliseconds silence_;
    QElapsedTimer asked_, lastData_;
    QByteArray received_;
};

}  // namespace tiller::simulator
