// SPDX-License-Identifier: MIT
#pragma once

// A WebSocket client that can violate every rule. It writes arbitrary bytes, declares arbitrary frame
// lengths, and reads only on request. It blocks and needs no event loop, so that it can run in any thread.

#include <QDeadlineTimer>
#include <QHostAddress>
#include <QTcpSocket>
#include <QtEndian>
#include <optional>
#include <utility>

namespace tiller::test {

enum class Opcode : quint8 { Continuation = 0, Text = 1, Binary = 2, Close = 8, Ping = 9, Pong = 10 };

/// Returns a client frame that is masked with zeros.
/// declaredSize  size in the header, if it differs from that of the payload
inline QByteArray clientFrame(Opcode opcode, const QByteArray& payload, bool final = true,
                              std::optional<quint64> declaredSize = {}) {
    const quint64 size = declaredSize.value_or(static_cast<quint64>(payload.size()));
    constexpr quint8 kMasked = 0x80;
    QByteArray frame;
    frame += static_cast<char>((final ? 0x80 : 0) | static_cast<int>(opcode));
    if (size < 126) {
        frame += static_cast<char>(kMasked | size);
    } else if (size <= 0xffff) {
        frame += static_cast<char>(kMasked | 126);
        frame.resize(frame.size() + 2);
        qToBigEndian(static_cast<quint16>(size), frame.data() + 2);
    } else {
        frame += static_cast<char>(kMasked | 127);
        frame.resize(frame.size() + 8);
        qToBigEndian(size, frame.data() + 2);
    }
    return frame + QByteArray(4, '\0') + payload;
}

inline QByteArray handshakeRequest(const QByteArray& origin = {}) {
    return "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n" +
           (origin.isEmpty() ? QByteArray() : "Origin: " + origin + "\r\n") + "\r\n";
}

/// Splits the bytes of a server into frames.
class FrameReader {
public:
    struct Frame {
        Opcode opcode = Opcode::Text;
        QByteArray payload{};
    };
    void feed(const QByteArray& bytes) { bytes_ += bytes; }
    std::optional<Frame> next() {
        qsizetype head = 2;
        if (bytes_.size() < head) {
            return {};
        }
        qsizetype size = static_cast<quint8>(bytes_[1]) & 0x7f;
        if (size == 126) {
            head = 4;
            if (bytes_.size() < head) {
                return {};
            }
            size = qFromBigEndian<quint16>(bytes_.constData() + 2);
        }
        if (bytes_.size() < head + size) {
            return {};
        }
        Frame frame{static_cast<Opcode>(bytes_[0] & 0x0f), bytes_.mid(head, size)};
        bytes_.remove(0, head + size);
        return frame;
    }

private:
    QByteArray bytes_;
};

class RawViewer {
public:
    static constexpr int kTimeoutMs = 60'000;

    /// source  local address of the connection
    explicit RawViewer(quint16 port, const QHostAddress& source = QHostAddress::LocalHost) {
        socket.bind(source);
        socket.connectToHost(QHostAddress(QHostAddress::LocalHost), port);
        socket.waitForConnected(kTimeoutMs);
    }
    ~RawViewer() { socket.abort(); }

    /// Returns the status code of the reply; 0 if there was no reply.
    int upgrade(const QByteArray& origin = {}) {
        socket.write(handshakeRequest(origin));
        QByteArray answer;
        while (!answer.contains("\r\n\r\n")) {
            if (socket.bytesAvailable() == 0 && !socket.waitForReadyRead(kTimeoutMs)) {
                return 0;
            }
            answer += socket.readLine();
        }
        return answer.split(' ').value(1).toInt();
    }
    /// Writes without reading. Returns false if the server does not accept the data or has disconnected.
    bool write(const QByteArray& bytes) {
        socket.write(bytes);
        while (socket.bytesToWrite() > 0) {
            if (!socket.waitForBytesWritten(kTimeoutMs)) {
                return false;
            }
        }
        return socket.state() == QAbstractSocket::ConnectedState;
    }
    bool send(const QByteArray& text) { return write(clientFrame(Opcode::Text, text)); }
    bool subscribe(int id, int channel) {
        return send(R"({"op":"subscribe","subscriptions":[{"id":)" + QByteArray::number(id) +
                    R"(,"channelId":)" + QByteArray::number(channel) + "}]}");
    }
    /// Reads and discards until the server closes the connection.
    bool waitForClosed(int timeoutMs = kTimeoutMs) {
        QDeadlineTimer deadline(timeoutMs);
        while (socket.state() == QAbstractSocket::ConnectedState && !deadline.hasExpired()) {
            socket.waitForReadyRead(static_cast<int>(deadline.remainingTime()));
            socket.readAll();
        }
        return socket.state() != QAbstractSocket::ConnectedState;
    }

    QTcpSocket socket;
};

}  // namespace tiller::test
