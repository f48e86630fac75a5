// SPDX-License-Identifier: MIT
#pragma once

// The program node "External Control", with which the teach pendant runs a script from another PC. When the
// program is played, the robot requests the script from that PC with one line of text and inserts it in place
// of the node. The end of the script is not marked. The part between the header marks of the script is placed
// at the beginning of the program and runs first.

#include <QByteArray>
#include <QElapsedTimer>
#include <QString>
#include <QTcpSocket>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace tiller::simulator {

/// Address of the PC that provides the script. The defaults are those of a new installation.
struct ScriptProvider {
    QString host = QStringLiteral("192.168.56.1");
    std::uint16_t port = 50002;
};

/// Reads the address from an installation file (gzipped XML). Empty if the file does not contain one.
std::optional<ScriptProvider> scriptProviderOf(const QByteArray& installation);

/// Inserts the script in place of the External Control nodes of the program.
std::string withControlScript(std::string program, std::string script);

/// Threads  a thread that processes events. No function blocks.
class ControlScriptRequest {
public:
    /// silence  if no data have arrived for this time, the script is complete
    ControlScriptRequest(const ScriptProvider& provider, std::chrono::milliseconds silence);

    /// Returns the script, or an empty string if it could not be read. No value while the script is being
    /// received.
    std::optional<std::string> poll();

private:
    QTcpSocket socket_;
    std::chrono::milliseconds silence_;
    QElapsedTimer asked_, lastData_;
    QByteArray received_;
};

}  // namespace tiller::simulator
