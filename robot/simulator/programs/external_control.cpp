// SPDX-License-Identifier: MIT
#include "robot/simulator/programs/external_control.h"

#include <QXmlStreamReader>

#include "robot/simulator/pendant/urcaps.h"
#include "robot/simulator/pendant/xml_tree.h"

namespace tiller::simulator {

using pendant::gunzip;
using pendant::kControlNode;
using pendant::kControlNodeOwner;

namespace {

constexpr qsizetype kLargestInstallation = 64 << 20;
constexpr qsizetype kLargestScript = 4 << 20;
constexpr qint64 kWaitTimeoutMs = 2000;

/// Moves the lines between the two header marks out of the script. The marks are comments, so they may
/// remain.
std::string takeHeader(std::string& script) {
    constexpr std::string_view kBegin = "# HEADER_BEGIN";
    constexpr std::string_view kEnd = "# HEADER_END";
    const std::size_t begin = script.find(kBegin);
    const std::size_t end = script.find(kEnd);
    if (begin == std::string::npos || end == std::string::npos || end < begin) {
        return {};
    }
    const std::string header = script.substr(begin, end - begin);
    script.erase(begin, end - begin);
    return header;
}

}  // namespace

std::optional<ScriptProvider> scriptProviderOf(const QByteArray& installation) {
    QXmlStreamReader xml(gunzip(installation, kLargestInstallation).value_or(installation));
    ScriptProvider provider;
    bool found = false, inside = false;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.name() == QLatin1String("Contributed")) {
            inside =
                xml.isStartElement() &&
                xml.attributes().value(QLatin1String("ownerId")).contains(QLatin1String(kControlNodeOwner));
            found = found || inside;
        } else if (inside && xml.isStartElement() && xml.name() == QLatin1String("data")) {
            const auto key = xml.attributes().value(QLatin1String("key"));
            const QString value = xml.attributes().value(QLatin1String("value")).toString();
            bool isPort = false;
            const std::uint16_t port = value.toUShort(&isPort);
            if (key == QLatin1String("host_ip") && !value.isEmpty()) {
                provider.host = value;
            } else if (key == QLatin1String("port_nr") && isPort) {
                provider.port = port;
            }
        }
    }
    return found && !xml.hasError() ? std::optional(provider) : std::nullopt;
}

std::string withControlScript(std::string program, std::string script) {
    const std::string header = takeHeader(script);
    script += '\n';
    for (std::size_t at = program.find(kControlNode); at != std::string::npos;
         at = program.find(kControlNode, at + script.size())) {
        program.replace(at, kControlNode.size(), script);
    }
    const std::size_t body = program.find('\n') + 1;  // start of the line after the `def` of the program
    return program.insert(body, header);
}

ControlScriptRequest::ControlScriptRequest(const ScriptProvider& provider, std::chrono::milliseconds silence)
    : silence_(silence) {
    socket_.connectToHost(provider.host, provider.port);
    socket_.write("request_program\n");  // sent once the connection is established
    asked_.start();
}

std::optional<std::string> ControlScriptRequest::poll() {
    if (const QByteArray piece = socket_.readAll(); !piece.isEmpty()) {
        received_ += piece;
        lastData_.start();
    }
    if (received_.size() > kLargestScript) {
        return std::string();
    }
    const bool over =
        socket_.state() == QAbstractSocket::UnconnectedState ||
        (lastData_.isValid() ? lastData_.hasExpired(silence_.count()) : asked_.hasExpired(kWaitTimeoutMs));
    return over ? std::optional(received_.toStdString()) : std::nullopt;
}

}  // namespace tiller::simulator
