// SPDX-License-Identifier: MIT
#include "robot/dashboard/robot_api_client.h"

#include <QJsonDocument>
#include <QTcpSocket>
#include <QUrl>
#include <memory>
#include <optional>

#include "robot/script/tcp_socket.h"

namespace tiller::dashboard {

namespace {

constexpr qsizetype kMaxBytes = 4 * 1024 * 1024;
constexpr int kMaxRedirects = 3;
const QByteArray kBase = "/universal-robots/robot-api";

struct Reply {
    int status = 0;
    QByteArray location;
    QByteArray body;
};

QByteArray header(const QByteArray& head, const QByteArray& name) {
    for (const QByteArray& line : head.split('\n')) {
        const qsizetype colon = line.indexOf(':');
        if (colon > 0 && line.left(colon).trimmed().toLower() == name) {
            return line.mid(colon + 1).trimmed();
        }
    }
    return {};
}

/// Removes chunk lengths and line ends. Returns an empty value while the data are incomplete.
std::optional<QByteArray> unchunked(const QByteArray& chunks) {
    QByteArray body;
    for (qsizetype at = 0;;) {
        const qsizetype end = chunks.indexOf("\r\n", at);
        bool good = end >= 0;
        const qsizetype size =
            good ? chunks.mid(at, end - at).split(';').first().trimmed().toLongLong(&good, 16) : 0;
        if (!good || size < 0 || size > kMaxBytes || end + 2 + size > chunks.size()) {
            return {};
        }
        if (size == 0) {
            return body;
        }
        body += chunks.mid(end + 2, size);
        at = end + 2 + size + 2;
    }
}

/// Parses the received bytes as a reply, if complete.
/// over  true if the peer has closed the connection
std::optional<Reply> parsed(const QByteArray& bytes, bool over) {
    const qsizetype end = bytes.indexOf("\r\n\r\n");
    if (end < 0 || !bytes.startsWith("HTTP/1.")) {
        return {};
    }
    const QByteArray head = bytes.left(end);
    const QByteArray rest = bytes.mid(end + 4);
    Reply reply;
    reply.status = head.split(' ').value(1).toInt();
    reply.location = header(head, "location");
    if (header(head, "transfer-encoding").toLower().contains("chunked")) {
        auto body = unchunked(rest);
        if (!body) {
            return {};
        }
        reply.body = *body;
        return reply;
    }
    bool hasLength = false;
    const qsizetype length = header(head, "content-length").toLongLong(&hasLength);
    if (hasLength ? rest.size() < length : !over) {
        return {};
    }
    reply.body = hasLength ? rest.left(length) : rest;
    return reply;
}

Result<Reply> exchange(const QString& host, int port, const QByteArray& message, const QString& context,
                       const Deadline& deadline) {
    auto connected = script::openTcpSocket(host, port, deadline);
    if (!connected) {
        return connected.error();
    }
    QTcpSocket& socket = **connected;
    socket.write(message);
    socket.flush();
    QByteArray bytes;
    while (true) {
        const bool over = socket.state() != QAbstractSocket::ConnectedState;
        bytes += socket.readAll();
        if (auto reply = parsed(bytes, over)) {
            return *reply;
        }
        if (over || bytes.size() > kMaxBytes) {
            return Error{bytes.isEmpty() ? ErrorCode::ConnectionClosed : ErrorCode::ProtocolError, context,
                         QString::fromLatin1(bytes.left(80))};
        }
        if (deadline.hasExpired()) {
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context, {}};
        }
        socket.waitForReadyRead(static_cast<int>(deadline.nextPoll().count()));
    }
}

}  // namespace

Result<QJsonObject> RobotApiClient::request(const QByteArray& method, const QString& path,
                                            const QJsonObject& body, const Deadline& deadline) const {
    const QString context =
        QStringLiteral("%1 %2 at %3:%4").arg(QString::fromLatin1(method), path, host_).arg(port_);
    const QByteArray content =
        body.isEmpty() ? QByteArray() : QJsonDocument(body).toJson(QJsonDocument::Compact);
    QByteArray target = kBase + QUrl(path).toEncoded();
    Reply reply;
    for (int redirects = 0; redirects <= kMaxRedirects; ++redirects) {
        QByteArray message = method + ' ' + target + " HTTP/1.1\r\nHost: " + host_.trimmed().toLatin1() +
                             "\r\nAccept: application/json\r\nConnection: close\r\n";
        if (!content.isEmpty()) {
            message +=
                "Content-Type: application/json\r\nContent-Length: " + QByteArray::number(content.size()) +
                "\r\n";
        }
        auto got = exchange(host_, port_, message + "\r\n" + content, context, deadline);
        if (!got) {
            return got.error();
        }
        reply = *got;
        if (reply.status < 300 || reply.status >= 400 || reply.location.isEmpty()) {
            break;
        }
        // Redirects are only followed within the same robot.
        target = QUrl::fromEncoded(reply.location).path(QUrl::FullyEncoded).toLatin1();
    }
    const QJsonObject object = QJsonDocument::fromJson(reply.body).object();
    if (reply.status == 200) {
        return object;
    }
    QStringList words{QString::number(reply.status), object["message"].toString(),
                      object["details"].toString()};
    words.removeAll(QString());
    const ErrorCode code = reply.status == 403                          ? ErrorCode::RemoteControlRequired
                           : reply.status == 404 && method == "GET"     ? ErrorCode::VersionUnsupported
                           : reply.status == 408 || reply.status == 504 ? ErrorCode::Timeout
                           : reply.status >= 400                        ? ErrorCode::Rejected
                                                                        : ErrorCode::ProtocolError;
    return Error{code, context, words.join(QStringLiteral(": "))};
}

Result<QString> RobotApiClient::apiVersion(const Deadline& deadline) const {
    const QString path = QStringLiteral("/openapi.json");
    const auto description = request("GET", path, {}, deadline);
    if (!description) {
        return description.error();
    }
    const QString version = (*description)["info"].toObject()["version"].toString();
    if (version.isEmpty()) {
        return Error{ErrorCode::ProtocolError, QStringLiteral("GET %1 at %2:%3").arg(path, host_).arg(port_),
                     QStringLiteral("the reply does not describe a Robot API")};
    }
    return version;
}

Result<void> RobotApiClient::act(const char* action, const Deadline& deadline) {
    const auto done = request("PUT", QStringLiteral("/robotstate/v1/state"),
                              {{QStringLiteral("action"), QLatin1String(action)}}, deadline);
    return done ? Result<void>() : Result<void>(done.error());
}

Result<void> RobotApiClient::powerOn(const Deadline& deadline) {
    return act("POWER_ON", deadline);
}
Result<void> RobotApiClient::powerOff(const Deadline& deadline) {
    return act("POWER_OFF", deadline);
}
Result<void> RobotApiClient::brakeRelease(const Deadline& deadline) {
    return act("BRAKE_RELEASE", deadline);
}
Result<void> RobotApiClient::unlockProtectiveStop(const Deadline& deadline) {
    return act("UNLOCK_PROTECTIVE_STOP", deadline);
}
Result<void> RobotApiClient::restartSafety(const Deadline& deadline) {
    return act("RESTART_SAFETY", deadline);
}

Result<QString> RobotApiClient::modeAt(const QString& path, const Deadline& deadline) const {
    const auto reply = request("GET", path, {}, deadline);
    if (!reply) {
        return reply.error();
    }
    const QString mode = (*reply)["mode"].toString();
    if (mode.isEmpty()) {
        return Error{ErrorCode::ProtocolError, QStringLiteral("GET %1 at %2:%3").arg(path, host_).arg(port_),
                     QStringLiteral("the reply contains no mode")};
    }
    return mode;
}

Result<RobotMode> RobotApiClient::robotMode(const Deadline& deadline) const {
    const auto name = modeAt(QStringLiteral("/robotstate/v1/robotmode"), deadline);
    if (!name) {
        return name.error();
    }
    if (*name == QLatin1String("UPDATING")) {
        return RobotMode::UpdatingFirmware;
    }
    constexpr int kLast = static_cast<int>(RobotMode::UpdatingFirmware);
    for (int mode = static_cast<int>(RobotMode::NoController); mode <= kLast; ++mode) {
        if (robotModeName(static_cast<RobotMode>(mode)) == *name) {
            return static_cast<RobotMode>(mode);
        }
    }
    return Error{ErrorCode::ProtocolError, QStringLiteral("robot mode of %1").arg(host_), *name};
}

Result<SafetyMode> RobotApiClient::safetyMode(const Deadline& deadline) const {
    const auto name = modeAt(QStringLiteral("/robotstate/v1/safetymode"), deadline);
    if (!name) {
        return name.error();
    }
    if (*name == QLatin1String("EMERGENCY_STOP")) {
        return SafetyMode::RobotEmergencyStop;  // the API does not report which emergency stop is active
    }
    for (int mode = static_cast<int>(SafetyMode::Normal); mode <= static_cast<int>(SafetyMode::Fault);
         ++mode) {
        if (safetyModeName(static_cast<SafetyMode>(mode)) == *name) {
            return static_cast<SafetyMode>(mode);
        }
    }
    return Error{ErrorCode::ProtocolError, QStringLiteral("safety mode of %1").arg(host_), *name};
}

Result<bool> RobotApiClient::isInRemoteControl(const Deadline& deadline) const {
    const auto name = modeAt(QStringLiteral("/system/v1/controlmode"), deadline);
    return name ? Result<bool>(*name == QLatin1String("REMOTE")) : Result<bool>(name.error());
}

Result<void> RobotApiClient::loadProgram(const Text& name, const Deadline& deadline) {
    const auto done =
        request("PUT", QStringLiteral("/program/v1/loaded"), {{QStringLiteral("name"), name}}, deadline);
    return done ? Result<void>() : Result<void>(done.error());
}

Result<void> RobotApiClient::runProgram(const Text& action, const Deadline& deadline) {
    const auto done =
        request("PUT", QStringLiteral("/program/v1/state"), {{QStringLiteral("action"), action}}, deadline);
    return done ? Result<void>() : Result<void>(done.error());
}

Result<ProgramState::Run> RobotApiClient::programState(const Deadline& deadline) const {
    const auto reply = request("GET", QStringLiteral("/program/v1/state"), {}, deadline);
    if (!reply) {
        return reply.error();
    }
    const QString state = (*reply)["state"].toString();
    if (state == QLatin1String("PLAYING")) {
        return ProgramState::Run::Playing;
    }
    if (state == QLatin1String("PAUSED")) {
        return ProgramState::Run::Paused;
    }
    if (state == QLatin1String("STOPPED")) {
        return ProgramState::Run::Stopped;
    }
    return Error{ErrorCode::ProtocolError, QStringLiteral("program state of %1").arg(host_), state};
}

}  // namespace tiller::dashboard
