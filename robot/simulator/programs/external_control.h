// SPDX-License-Identifier: MIT
#pragma once

// The program node by which the pendant hands a program to a computer ("External Control"): when the program
// is played, the robot asks that computer for its script and puts it where the node stands. The request is
// one line of text; the script comes with no mark of its end. What stands between its header marks belongs at
// the beginning of the program, before anything runs.

#include <QByteArray>
#include <QElapsedTimer>
#include <QString>
#include <QTcpSocket>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace tiller::simulator {

/// The computer that has the script; what a fresh installation has.
struct ScriptProvider {
    QString host = QStringLiteral("192.168.56.1");
    std::uint16_t port = 50002;
};

/// What an installation file (XML, gzipped) says of it. Nothing when it says nothing.
std::optional<ScriptProvider> scriptProviderOf(const QByteArray& installation);

/// The program with the script in place of its nodes.
std::string withControlScript(std::string program, std::string script);

/// Threads  one that processes events. Blocks: never.
class ControlScriptRequest {
public:
    /// silence  a pause this long after the last piece means that there is no more
    ControlScriptRequest(const ScriptProvider& provider, std::chrono::milliseconds silence);

    /// The script, empty when it could not be had; nothing as long as it is under way.
    std::optional<std::string> poll();

private:
    QTcpSocket socket_;
    std::chrono::milliseconds silence_;
    QElapsedTimer asked_, lastData_;
    QByteArray received_;
};

}  // namespace tiller::simulator
