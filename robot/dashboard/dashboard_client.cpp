// SPDX-License-Identifier: MIT
#include "robot/dashboard/dashboard_client.h"

#include <QRegularExpression>
#include <QTcpSocket>
#include <array>
#include <utility>

#include "robot/platform/native_socket.h"
#include "robot/script/tcp_socket.h"

namespace tiller::dashboard {

namespace {

native_socket::Descriptor descriptorOf(const QTcpSocket& socket) {
    return static_cast<native_socket::Descriptor>(socket.socketDescriptor());
}

// Matches only parts of the reply, because the end of the line depends on the software version.
bool isRemoteRefusal(const QString& reply) {
    return reply.contains(QLatin1String("Remote Control"), Qt::CaseInsensitive) &&
           reply.contains(QLatin1String("not allowed"), Qt::CaseInsensitive);
}

std::optional<RobotMode> robotModeByName(const QString& name) {
    for (int number = static_cast<int>(RobotMode::NoController);
         number <= static_cast<int>(RobotMode::UpdatingFirmware); ++number) {
        const auto mode = static_cast<RobotMode>(number);
        if (robotModeName(mode) == name) {
            return mode;
        }
    }
    return std::nullopt;
}

std::optional<SafetyMode> safetyModeByName(const QString& name) {
    for (int number = static_cast<int>(SafetyMode::Normal);
         number <= static_cast<int>(SafetyMode::SafetyApiSafeguardStop); ++number) {
        const auto mode = static_cast<SafetyMode>(number);
        if (safetyModeName(mode) == name) {
            return mode;
        }
    }
    return std::nullopt;
}

}  // namespace

DashboardClient::DashboardClient(Text host, int port) : host_(std::move(host)), port_(port) {}

DashboardClient::~DashboardClient() = default;

Result<void> DashboardClient::connect(const Deadline& deadline) {
    close();
    auto socket = script::openTcpSocket(host_, port_, deadline);
    if (!socket) {
        return socket.error();
    }
    socket_ = std::move(socket).value();
    const auto greeting =
        readLine(deadline, QStringLiteral("greeting of the dashboard server at %1:%2").arg(host_).arg(port_));
    return greeting ? Result<void>() : Result<void>(greeting.error());
}

void DashboardClient::close() {
    if (socket_) {
        socket_->abort();
        socket_.reset();
    }
}

bool DashboardClient::isConnected() const {
    return socket_ != nullptr;
}

bool DashboardClient::checkConnection() {
    std::array<std::uint8_t, 256> unasked;
    while (socket_) {
        const auto got = native_socket::receive(descriptorOf(*socket_), unasked);
        if (got.status == native_socket::Status::WouldBlock) {
            break;
        }
        if (got.status != native_socket::Status::Ok) {
            close();
        }
    }
    return isConnected();
}

Result<void> DashboardClient::powerOn(const Deadline& deadline) {
    return expect(QStringLiteral("power on"), QStringLiteral("Powering on"), deadline);
}

Result<void> DashboardClient::powerOff(const Deadline& deadline) {
    return expect(QStringLiteral("power off"), QStringLiteral("Powering off"), deadline);
}

Result<void> DashboardClient::brakeRelease(const Deadline& deadline) {
    return expect(QStringLiteral("brake release"), QStringLiteral("Brake releasing"), deadline);
}

Result<void> DashboardClient::unlockProtectiveStop(const Deadline& deadline) {
    return expect(QStringLiteral("unlock protective stop"), QStringLiteral("Protective stop releasing"),
                  deadline);
}

Result<void> DashboardClient::closeSafetyPopup(const Deadline& deadline) {
    return expect(QStringLiteral("close safety popup"), QStringLiteral("closing safety popup"), deadline);
}

Result<void> DashboardClient::restartSafety(const Deadline& deadline) {
    return expect(QStringLiteral("restart safety"), QStringLiteral("Restarting safety"), deadline);
}

Result<RobotMode> DashboardClient::robotMode(const Deadline& deadline) {
    const QString line = QStringLiteral("robotmode");
    const auto value = valueAfter(line, QStringLiteral("Robotmode: "), deadline);
    if (!value) {
        return value.error();
    }
    const auto mode = robotModeByName(*value);
    return mode ? Result<RobotMode>(*mode) : Result<RobotMode>(rejected(line, *value));
}

Result<SafetyMode> DashboardClient::safetyMode(const Deadline& deadline) {
    const QString line = QStringLiteral("safetymode");
    const auto value = valueAfter(line, QStringLiteral("Safetymode: "), deadline);
    if (!value) {
        return value.error();
    }
    const auto mode = safetyModeByName(*value);
    return mode ? Result<SafetyMode>(*mode) : Result<SafetyMode>(rejected(line, *value));
}

Result<bool> DashboardClient::isInRemoteControl(const Deadline& deadline) {
    const QString line = QStringLiteral("is in remote control");
    const auto reply = command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    const bool yes = reply->compare(QLatin1String("true"), Qt::CaseInsensitive) == 0;
    const bool no = reply->compare(QLatin1String("false"), Qt::CaseInsensitive) == 0;
    return yes || no ? Result<bool>(yes) : Result<bool>(rejected(line, *reply));
}

Result<SoftwareVersion> DashboardClient::polyscopeVersion(const Deadline& deadline) {
    const QString line = QStringLiteral("PolyscopeVersion");
    const auto reply = command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    static const QRegularExpression pattern(QStringLiteral(R"((\d+)\.(\d+)(?:\.(\d+))?(?:\.(\d+))?)"));
    const auto match = pattern.match(*reply);
    if (!match.hasMatch()) {
        return rejected(line, *reply);
    }
    return SoftwareVersion{match.captured(1).toUInt(), match.captured(2).toUInt(), match.captured(3).toUInt(),
                           match.captured(4).toUInt()};
}

Result<QString> DashboardClient::serialNumber(const Deadline& deadline) {
    const QString line = QStringLiteral("get serial number");
    const auto reply = command(line, deadline);
    static const QRegularExpression digits(QStringLiteral(R"(^\d+$)"));
    if (reply && !digits.match(*reply).hasMatch()) {
        return rejected(line, *reply);
    }
    return reply;
}

Result<QString> DashboardClient::robotModel(const Deadline& deadline) {
    const QString line = QStringLiteral("get robot model");
    const auto reply = command(line, deadline);
    if (reply && !reply->startsWith(QLatin1String("UR"))) {
        return rejected(line, *reply);
    }
    return reply;
}

Result<ProgramState> DashboardClient::programState(const Deadline& deadline) {
    const QString line = QStringLiteral("programState");
    const auto reply = command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    const QString word = reply->section(QLatin1Char(' '), 0, 0);
    ProgramState state;
    state.program = reply->section(QLatin1Char(' '), 1).trimmed();
    if (word == QLatin1String("STOPPED")) {
        state.run = ProgramState::Run::Stopped;
    } else if (word == QLatin1String("PLAYING")) {
        state.run = ProgramState::Run::Playing;
    } else if (word == QLatin1String("PAUSED")) {
        state.run = ProgramState::Run::Paused;
    } else {
        return rejected(line, *reply);
    }
    return state;
}

Result<void> DashboardClient::loadProgram(const Text& path, const Deadline& deadline) {
    const QString line = QStringLiteral("load ") + path;
    const auto loaded = valueAfter(line, QStringLiteral("Loading program: "), deadline);
    return loaded ? Result<void>() : Result<void>(loaded.error());
}

Result<void> DashboardClient::play(const Deadline& deadline) {
    return expect(QStringLiteral("play"), QStringLiteral("Starting program"), deadline);
}

Result<void> DashboardClient::pause(const Deadline& deadline) {
    return expect(QStringLiteral("pause"), QStringLiteral("Pausing program"), deadline);
}

Result<void> DashboardClient::stop(const Deadline& deadline) {
    return expect(QStringLiteral("stop"), QStringLiteral("Stopped"), deadline);
}

Result<void> DashboardClient::popup(const Text& text, const Deadline& deadline) {
    return expect(QStringLiteral("popup ") + text, QStringLiteral("showing popup"), deadline);
}

Result<void> DashboardClient::closePopup(const Deadline& deadline) {
    return expect(QStringLiteral("close popup"), QStringLiteral("closing popup"), deadline);
}

Result<void> DashboardClient::addToLog(const Text& text, const Deadline& deadline) {
    return expect(QStringLiteral("addToLog ") + text, QStringLiteral("Added log message"), deadline);
}

Result<QString> DashboardClient::command(const Text& line, const Deadline& deadline) {
    const QString context = contextOf(line);
    if (line.contains(QLatin1Char('\n')) || line.contains(QLatin1Char('\r'))) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("a command must be a single line")};
    }
    if (!socket_) {
        return Error{ErrorCode::NotConnected, context, {}};
    }
    if (!checkConnection()) {
        return Error{ErrorCode::ConnectionClosed, context, {}};
    }
    const QByteArray bytes = line.toUtf8() + '\n';
    std::span<const std::uint8_t> left(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                       static_cast<std::size_t>(bytes.size()));
    while (!left.empty()) {
        const auto sent = native_socket::send(descriptorOf(*socket_), left);
        if (sent.status == native_socket::Status::Ok) {
            left = left.subspan(sent.bytes);
        } else if (sent.status != native_socket::Status::WouldBlock || deadline.hasExpired()) {
            close();
            return Error{ErrorCode::ConnectionClosed, context, {}};
        }
    }
    auto reply = readLine(deadline, context);
    if (reply && isRemoteRefusal(*reply)) {
        close();
        return Error{ErrorCode::RemoteControlRequired, context, *reply};
    }
    return reply;
}

Result<QString> DashboardClient::readLine(const Deadline& deadline, const QString& context) {
    constexpr qsizetype kMaxReplyLength = 65536;
    QByteArray line;
    while (true) {
        std::uint8_t byte = 0;
        const auto got = native_socket::receive(descriptorOf(*socket_), std::span(&byte, 1));
        if (got.status == native_socket::Status::Ok) {
            if (byte == '\n') {
                return QString::fromUtf8(line).trimmed();
            }
            line.append(static_cast<char>(byte));
            if (line.size() > kMaxReplyLength) {
                close();
                return Error{ErrorCode::ProtocolError, context, QStringLiteral("the reply has no line end")};
            }
        } else if (got.status != native_socket::Status::WouldBlock) {
            close();
            return Error{ErrorCode::ConnectionClosed, context, {}};
        } else if (deadline.hasExpired()) {
            // A command that has failed must not be carried out later, when a lost connection recovers.
            native_socket::discardOnClose(descriptorOf(*socket_));
            close();
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
                         QString::fromUtf8(line)};
        } else {
            native_socket::waitReadable(descriptorOf(*socket_), deadline.nextPoll());
        }
    }
}

Result<void> DashboardClient::expect(const QString& line, const QString& reply, const Deadline& deadline) {
    const auto got = command(line, deadline);
    if (!got) {
        return got.error();
    }
    return *got == reply ? Result<void>() : Result<void>(rejected(line, *got));
}

Result<QString> DashboardClient::valueAfter(const QString& line, const QString& prefix,
                                            const Deadline& deadline) {
    const auto reply = command(line, deadline);
    if (reply && !reply->startsWith(prefix)) {
        return rejected(line, *reply);
    }
    return reply ? Result<QString>(reply->mid(prefix.size()).trimmed()) : reply;
}

Error DashboardClient::rejected(const QString& line, const QString& reply) const {
    return {ErrorCode::Rejected, contextOf(line), reply};
}

QString DashboardClient::contextOf(const QString& line) const {
    return QStringLiteral("dashboard command \"%1\" to %2:%3").arg(line, host_).arg(port_);
}

}  // namespace tiller::dashboard
