// SPDX-License-Identifier: MIT
#pragma once

// Clients at byte level, written only from the protocol documents. They share no code with the backend, so
// that one misunderstanding of the protocol cannot affect both.

#include <QByteArray>
#include <QElapsedTimer>
#include <QTcpSocket>
#include <QtEndian>
#include <cstring>
#include <optional>
#include <vector>

#include "robot/simulator/simulator.h"

namespace tiller::test {

/// Timeout that exceeds the time of any reply on a working computer. Reaching it is a failure.
inline constexpr int kWaitTimeoutMs = 20'000;

template <class Number>
QByteArray bigEndian(Number value) {
    QByteArray bytes(sizeof(Number), '\0');
    if constexpr (sizeof(Number) == 8) {
        quint64 bits = 0;
        std::memcpy(&bits, &value, 8);
        qToBigEndian(bits, bytes.data());
    } else {
        qToBigEndian(value, bytes.data());
    }
    return bytes;
}

inline double doubleAt(const QByteArray& bytes, qsizetype offset) {
    const auto bits = qFromBigEndian<quint64>(bytes.constData() + offset);
    double value = 0;
    std::memcpy(&value, &bits, 8);
    return value;
}
inline quint32 wordAt(const QByteArray& bytes, qsizetype offset) {
    return qFromBigEndian<quint32>(bytes.constData() + offset);
}
inline qint32 intAt(const QByteArray& bytes, qsizetype offset) {
    return qFromBigEndian<qint32>(bytes.constData() + offset);
}

class RawClient {
public:
    RawClient(const QString& host, quint16 port) {
        socket_.connectToHost(host, port);
        socket_.waitForConnected(kWaitTimeoutMs);
        // Otherwise, a second small package would wait for the acknowledgement of the first package.
        socket_.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    }
    virtual ~RawClient() = default;

    bool isConnected() const { return socket_.state() == QAbstractSocket::ConnectedState; }
    void send(const QByteArray& bytes) {
        socket_.write(bytes);
        while (socket_.bytesToWrite() > 0 && socket_.waitForBytesWritten(kWaitTimeoutMs)) {
        }
    }
    /// Waits for this number of bytes. Returns fewer bytes only if the connection ended or the wait timed
    /// out.
    QByteArray take(qsizetype count) {
        while (buffer_.size() < count && receive(kWaitTimeoutMs)) {
        }
        const QByteArray taken = buffer_.left(count);
        buffer_.remove(0, count);
        return taken;
    }
    QByteArray line() {
        while (!buffer_.contains('\n') && receive(kWaitTimeoutMs)) {
        }
        const qsizetype end = buffer_.indexOf('\n') + 1;
        const QByteArray taken = buffer_.left(end);
        buffer_.remove(0, end);
        return taken;
    }
    /// Returns the available bytes, including data still in transit on this computer.
    QByteArray takeAll() {
        while (receive(20)) {
        }
        return std::exchange(buffer_, {});
    }
    /// Reads until the peer closes the connection. Returns false on timeout.
    bool waitClosed() {
        QElapsedTimer timer;
        timer.start();
        while (isConnected() && timer.elapsed() < kWaitTimeoutMs) {
            receive(100);
        }
        return !isConnected();
    }
    void close() {
        socket_.disconnectFromHost();
        if (socket_.state() != QAbstractSocket::UnconnectedState) {
            socket_.waitForDisconnected(kWaitTimeoutMs);
        }
    }
    QTcpSocket& socket() { return socket_; }

protected:
    bool receive(int ms) {
        if (socket_.bytesAvailable() == 0 && !socket_.waitForReadyRead(ms)) {
            return false;
        }
        buffer_ += socket_.readAll();
        return true;
    }
    QByteArray buffer_;

private:
    QTcpSocket socket_;
};

class RawRtde : public RawClient {
public:
    using RawClient::RawClient;
    struct Package {
        char type = 0;
        QByteArray payload;
    };

    static QByteArray package(char type, const QByteArray& payload = {}) {
        return bigEndian(static_cast<quint16>(payload.size() + 3)) + type + payload;
    }
    void sendPackage(char type, const QByteArray& payload = {}) { send(package(type, payload)); }

    /// Returns the next package; type 0 if there is none.
    Package next() {
        const QByteArray head = take(3);
        if (head.size() < 3) {
            return {};
        }
        return {head[2], take(qFromBigEndian<quint16>(head.constData()) - 3)};
    }
    Package request(char type, const QByteArray& payload = {}) {
        sendPackage(type, payload);
        return next();
    }
    /// Returns the complete packages received so far. An incomplete package remains in the buffer.
    std::vector<Package> packages() {
        QByteArray bytes = takeAll();
        std::vector<Package> all;
        while (bytes.size() >= 3 && bytes.size() >= qFromBigEndian<quint16>(bytes.constData())) {
            const auto size = qFromBigEndian<quint16>(bytes.constData());
            all.push_back({bytes[2], bytes.mid(3, size - 3)});
            bytes.remove(0, size);
        }
        buffer_ = bytes;
        return all;
    }

    bool useVersion(quint16 version = 2) {
        return request('V', bigEndian(version)).payload == QByteArray(1, '\1');
    }
    QByteArray setupOutputs(double frequency, const QByteArray& names) {
        return request('O', bigEndian(frequency) + names).payload;
    }
    QByteArray setupInputs(const QByteArray& names) { return request('I', names).payload; }
    bool start() { return request('S').payload == QByteArray(1, '\1'); }
};

class RawPrimary : public RawClient {
public:
    using RawClient::RawClient;

    /// Returns the next package, including the length field.
    QByteArray next() {
        const QByteArray head = take(4);
        return head.size() < 4 ? QByteArray() : head + take(intAt(head, 0) - 4);
    }
    /// Returns all available packages.
    std::vector<QByteArray> packages() {
        QByteArray bytes = takeAll();
        std::vector<QByteArray> all;
        while (bytes.size() >= 4 && bytes.size() >= intAt(bytes, 0)) {
            all.push_back(bytes.left(intAt(bytes, 0)));
            bytes.remove(0, intAt(bytes, 0));
        }
        buffer_ = bytes;
        return all;
    }
    /// Returns the available robot messages of one type. The content starts after the message type.
    std::vector<QByteArray> messages(int kind) {
        std::vector<QByteArray> found;
        for (const QByteArray& package : packages()) {
            if (package[4] == 20 && package[14] == kind) {
                found.push_back(package.mid(15));
            }
        }
        return found;
    }
};

class RawDashboard : public RawClient {
public:
    RawDashboard(const QString& host, quint16 port) : RawClient(host, port), greeting(line()) {}
    QByteArray ask(const QByteArray& command) {
        send(command + '\n');
        return line();
    }
    const QByteArray greeting;
};

/// A controller in virtual time on free ports, with the arm powered and running.
struct VirtualRobot {
    static simulator::SimulatorOptions options() {
        simulator::SimulatorOptions options;
        options.anyFreePorts = true;
        options.time = simulator::Time::Virtual;
        options.poweredOn = true;
        return options;
    }
    static simulator::SimulatorOptions poweredOff() {
        auto options = VirtualRobot::options();
        options.poweredOn = false;
        return options;
    }
    explicit VirtualRobot(const simulator::SimulatorOptions& given = options()) : controller(given) {
        started = controller.start().ok();
    }
    QString host() const { return controller.listenAddress(); }
    RawRtde rtde() const { return RawRtde(host(), controller.ports().rtde); }
    RawPrimary primary() const { return RawPrimary(host(), controller.ports().primary); }
    RawDashboard dashboard() const { return RawDashboard(host(), controller.ports().dashboard); }

    /// Steps until the condition is true, but at most for this virtual time.
    template <class Condition>
    bool stepUntil(Condition condition, double atMostSeconds = 10) {
        const int ticks = static_cast<int>(atMostSeconds / controller.stepTime());
        for (int i = 0; i < ticks && !condition(); ++i) {
            controller.step();
        }
        return condition();
    }
    /// Steps until the dashboard reports this mode, but at most for five seconds.
    bool untilMode(RawDashboard& dashboard, const QByteArray& robotMode) {
        return stepUntil([&] { return dashboard.ask("robotmode") == "Robotmode: " + robotMode + '\n'; }, 5);
    }
    RuntimeState programState() const { return controller.truth().runtimeState; }

    simulator::Simulator controller;
    bool started = false;
};

}  // namespace tiller::test
