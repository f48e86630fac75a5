// SPDX-License-Identifier: MIT
#include "tests/integration/clients/socket_client.h"

#include <QElapsedTimer>
#include <cmath>

#ifdef __linux__
#include <linux/sockios.h>
#include <sys/ioctl.h>
#endif

namespace tiller::test {

namespace {

const char* const kOutputs =
    "actual_q,actual_qd,speed_scaling,target_speed_fraction,runtime_state,actual_TCP_force,actual_TCP_pose,"
    "actual_digital_input_bits,actual_digital_output_bits,standard_analog_input0,standard_analog_input1,"
    "standard_analog_output0,standard_analog_output1,analog_io_types,tool_mode,tool_analog_input_types,"
    "tool_analog_input0,tool_analog_input1,tool_output_voltage,tool_output_current,tool_temperature,"
    "robot_mode,safety_mode,robot_status_bits,safety_status_bits,actual_current,tcp_offset,target_q,payload,"
    "timestamp";
const char* const kInputs =
    "speed_slider_mask,speed_slider_fraction,standard_digital_output_mask,standard_digital_output,"
    "configurable_digital_output_mask,configurable_digital_output,tool_digital_output_mask,"
    "tool_digital_output,standard_analog_output_mask,standard_analog_output_type,standard_analog_output_0,"
    "standard_analog_output_1";

qint32 scaled(double value) {
    return static_cast<qint32>(std::lround(value * 1e6));
}

Six sixAt(const QByteArray& bytes, qsizetype at) {
    Six six{};
    for (std::size_t i = 0; i < 6; ++i) {
        six[i] = doubleAt(bytes, at + 8 * static_cast<qsizetype>(i));
    }
    return six;
}

/// Waits until all written data have arrived in the buffer of the other end, so that script timeouts do not
/// depend on the load of the computer.
void waitArrived([[maybe_unused]] QTcpSocket& socket) {
#ifdef __linux__
    int unacknowledged = 1;
    QElapsedTimer timer;
    timer.start();
    while (unacknowledged > 0 && timer.elapsed() < kWaitTimeoutMs &&
           ioctl(static_cast<int>(socket.socketDescriptor()), SIOCOUTQ, &unacknowledged) == 0) {
    }
#endif
}

}  // namespace

void SocketClient::Server::service() {
    if (!peer && server.waitForNewConnection(0)) {
        peer.reset(server.nextPendingConnection());
        peer->setParent(nullptr);
        peer->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    }
    if (peer) {
        peer->waitForReadyRead(0);
        received += peer->readAll();
    }
}

bool SocketClient::connect(const QByteArray& ending) {
    if (!connectRtde()) {
        return false;
    }
    if (!reverse_.listen() || !trajectory_.listen() || !command_.listen()) {
        return fail("listen");
    }
    primary_ = std::make_unique<QTcpSocket>();
    primary_->connectToHost(robot_.host(), robot_.controller.ports().primary);
    if (!primary_->waitForConnected(kWaitTimeoutMs)) {
        return fail("primary");
    }
    if (!until([this] { return news_.version && news_.configuration && news_.kinematics; }, 10)) {
        return fail("version, configuration or kinematics data");
    }
    SocketPorts ports;
    ports.reverse = reverse_.server.serverPort();
    ports.trajectory = trajectory_.server.serverPort();
    ports.command = command_.server.serverPort();
    sendScript("stop program\n" + socketScript(ports, ending) + "\n");
    // The library waits half a second for the connection of the script.
    if (!until([this] { return isReverseConnected(); }, 0.5)) {
        return fail("the script does not connect back");
    }
    return order_ == std::vector<int>({3, 4, 1}) || fail("order of connections");
}

bool SocketClient::connectRtde() {
    rtde_ = std::make_unique<RawRtde>(robot_.host(), robot_.controller.ports().rtde);
    if (!rtde_->useVersion() || rtde_->request('v').payload.size() != 16) {
        return fail("protocol or version");
    }
    const QByteArray types = rtde_->setupOutputs(500, kOutputs);
    if (types.contains("NOT_FOUND") || types.count(',') != QByteArray(kOutputs).count(',')) {
        return fail("output recipe");
    }
    if (!rtde_->start()) {
        return fail("start");
    }
    // The library reads until it considers the controller booted. Until then, only data packages may arrive.
    int packages = 0;
    do {
        robot_.controller.step();
        const auto package = rtde_->next();
        if (package.type != 'U') {
            return fail("a package other than data after the start");
        }
        data_.timestamp = doubleAt(package.payload, package.payload.size() - 8);
    } while (data_.timestamp < 40 && ++packages < 1000);
    rtde_->sendPackage('P');
    auto reply = rtde_->next();
    while (reply.type == 'U') {
        reply = rtde_->next();
    }
    if (reply.type != 'P') {
        return fail("pause");
    }
    const QByteArray inputs = rtde_->setupInputs(kInputs);
    if (inputs.contains("IN_USE") || inputs.contains("NOT_FOUND") || inputs[0] == 0) {
        return fail("input recipe");
    }
    return rtde_->start() || fail("start again");
}

void SocketClient::sendScript(const QByteArray& text) {
    primary_->write(text);
    while (primary_->bytesToWrite() > 0 && primary_->waitForBytesWritten(kWaitTimeoutMs)) {
    }
    waitArrived(*primary_);
    robot_.controller.drainSockets();
}

bool SocketClient::deliver(Server& server, const QByteArray& bytes) {
    if (!server.peer || server.peer->state() != QAbstractSocket::ConnectedState) {
        return false;
    }
    server.peer->write(bytes);
    while (server.peer->bytesToWrite() > 0) {
        if (!server.peer->waitForBytesWritten(1)) {
            step();  // the script must read first
        }
    }
    return true;
}

bool SocketClient::write(const Six& values, Mode mode, int timeoutMs) {
    std::array<qint32, 6> raw{};
    for (std::size_t i = 0; i < 6; ++i) {
        raw[i] = scaled(values[i]);
    }
    return writeRaw(raw, mode, timeoutMs);
}

bool SocketClient::writeRaw(const std::array<qint32, 6>& values, Mode mode, int timeoutMs) {
    QByteArray bytes = bigEndian(qint32(timeoutMs));
    for (const qint32 v : values) {
        bytes += bigEndian(v);
    }
    bytes += bigEndian(qint32(mode));
    if (!deliver(reverse_, bytes)) {
        return false;
    }
    waitArrived(*reverse_.peer);
    return true;
}

bool SocketClient::writePoint(const Point& point) {
    QByteArray bytes;
    for (const Six* six : {&point.target, &point.second, &point.third}) {
        for (const double v : *six) {
            bytes += bigEndian(scaled(v));
        }
    }
    const bool spline = point.type == 51;
    bytes += bigEndian(scaled(point.duration));
    bytes += bigEndian(spline ? static_cast<qint32>(point.blend) : scaled(point.blend));
    bytes += bigEndian(qint32(point.type));
    return deliver(trajectory_, bytes);
}

bool SocketClient::startTrajectory(const std::vector<Point>& points) {
    if (!writeRaw({1, static_cast<qint32>(points.size()), 0, 0, 0, 0}, kForward, 0)) {
        return false;
    }
    for (const Point& point : points) {
        if (!writePoint(point)) {
            return false;
        }
    }
    waitArrived(*trajectory_.peer);
    return true;
}

std::optional<int> SocketClient::answer(Server& server, double seconds) {
    const bool came = until([&server] { return server.received.size() >= 4; }, seconds);
    if (!came || server.received.size() != 4) {
        return std::nullopt;
    }
    const int result = intAt(server.received, 0);
    server.received.clear();
    return result;
}

std::optional<int> SocketClient::trajectoryResult(double seconds) {
    return answer(trajectory_, seconds);
}

bool SocketClient::writeCommand(int command, const std::vector<double>& values, bool rawFirst) {
    QByteArray bytes = bigEndian(qint32(command));
    for (std::size_t i = 0; i < 27; ++i) {
        const double v = i < values.size() ? values[i] : 0;
        bytes += bigEndian(i == 0 && rawFirst ? static_cast<qint32>(v) : scaled(v));
    }
    if (!deliver(command_, bytes)) {
        return false;
    }
    waitArrived(*command_.peer);
    return true;
}

std::optional<int> SocketClient::commandReply(double seconds) {
    return answer(command_, seconds);
}

bool SocketClient::isReverseConnected() {
    return reverse_.peer && reverse_.peer->state() == QAbstractSocket::ConnectedState;
}

void SocketClient::step(int ticks) {
    for (int n = 0; n < ticks; ++n) {
        robot_.controller.step();
        const auto package = rtde_->next();
        const QByteArray& p = package.payload;
        if (package.type == 'U' && p.size() > 400) {
            data_.actualQ = sixAt(p, 1);
            data_.runtime = wordAt(p, 1 + 112);
            data_.force = sixAt(p, 1 + 116);
            data_.actualPose = sixAt(p, 1 + 164);
            const qsizetype end = p.size();
            data_.timestamp = doubleAt(p, end - 8);
            data_.payload = doubleAt(p, end - 16);
            data_.targetQ = sixAt(p, end - 64);
            data_.tcpOffset = sixAt(p, end - 112);
            data_.toolVoltage = intAt(p, 1 + 212 + 16 + 32 + 12 + 16);
        }
        const std::array<std::pair<Server*, int>, 3> servers{
            {{&trajectory_, 3}, {&command_, 4}, {&reverse_, 1}}};
        for (const auto& [server, number] : servers) {
            const bool had = server->peer != nullptr;
            server->service();
            if (!had && server->peer) {
                order_.push_back(number);
            }
        }
        readPrimary();
    }
}

void SocketClient::readPrimary() {
    if (!primary_) {
        return;
    }
    primary_->waitForReadyRead(0);
    primaryBytes_ += primary_->readAll();
    while (primaryBytes_.size() >= 4) {
        const qint32 size = intAt(primaryBytes_, 0);
        if (size < 5 || size >= 4092) {
            news_.malformed = primaryBytes_.left(64);
            primaryBytes_.clear();
            return;
        }
        if (primaryBytes_.size() < size) {
            return;
        }
        readPackage(primaryBytes_.left(size));
        primaryBytes_.remove(0, size);
    }
}

void SocketClient::readPackage(const QByteArray& package) {
    if (package[4] == 16) {
        readState(package);
    } else if (package[4] == 20) {
        readMessage(package);
    }
}

// The sizes of the sub-packages must add up exactly to the size of the package.
void SocketClient::readState(const QByteArray& package) {
    qsizetype at = 5;
    while (at + 5 <= package.size()) {
        const qint32 size = intAt(package, at);
        const int type = package[at + 4];
        if (size < 5 || at + size > package.size()) {
            news_.malformed = package.mid(at, 64);
            return;
        }
        const QByteArray sub = package.mid(at, size);
        if (type == 0) {
            news_.protectiveStopped = sub[17] != 0;
            news_.running = sub[18] != 0;
            news_.paused = sub[19] != 0;
            news_.robotMode = sub[20];
        } else if (type == 5) {
            news_.kinematics = size >= 225;
        } else if (type == 6) {
            news_.configuration = size >= 445;
        }
        at += size;
    }
    if (at != package.size()) {
        news_.malformed = package.mid(at, 64);
    }
}

void SocketClient::readMessage(const QByteArray& package) {
    const int type = package[14];
    const QByteArray rest = package.mid(15);
    switch (type) {
        case 0:
            news_.texts.push_back(rest);
            break;
        case 3:
            news_.version = rest.size() > 3 && rest.mid(1, rest[0]) == "URControl";
            break;
        case 5:
            news_.safetyModes.push_back(rest[8]);
            break;
        case 6:
            news_.errorCodes.push_back(intAt(rest, 0));
            news_.errorLevels.push_back(intAt(rest, 8));
            break;
        case 7: {
            const int title = rest[8];
            news_.keys.push_back(rest.mid(9, title) + ' ' + rest.mid(9 + title));
            break;
        }
        case 10:
            news_.exceptions.push_back(rest.mid(8));
            break;
        default:
            break;
    }
}

}  // namespace tiller::test
