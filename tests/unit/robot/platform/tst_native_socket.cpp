// SPDX-License-Identifier: MIT
#include <QElapsedTimer>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <array>
#include <thread>
#include <vector>

#include "robot/platform/native_socket.h"

using namespace tiller;
using namespace std::chrono_literals;
using native_socket::Status;

namespace {

/// Returns the descriptor of the connection, like the servers of this project.
class DescriptorServer : public QTcpServer {
public:
    qintptr taken = -1;

protected:
    void incomingConnection(qintptr descriptor) override { taken = descriptor; }
};

}  // namespace

class TestNativeSocket : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        server_ = std::make_unique<DescriptorServer>();
        QVERIFY(server_->listen(QHostAddress::LocalHost));
        client_ = std::make_unique<QTcpSocket>();
        client_->connectToHost(QHostAddress::LocalHost, server_->serverPort());
        QVERIFY(client_->waitForConnected(60'000));
        QVERIFY(server_->waitForNewConnection(60'000) || server_->taken != -1);
        QVERIFY(server_->taken != -1);
        native_socket::prepare(server_->taken);
    }

    void cleanup() {
        client_.reset();
        if (server_->taken != -1) {
            native_socket::close(server_->taken);
        }
        server_.reset();
    }

    void emptySocketDoesNotBlock() {
        std::array<std::uint8_t, 16> buffer{};
        const auto got = native_socket::receive(server_->taken, buffer);
        QVERIFY(got.status == Status::WouldBlock);
        QCOMPARE(got.bytes, std::size_t(0));
        QVERIFY(!native_socket::waitReadable(server_->taken, 0ns));
        QVERIFY(!native_socket::waitReadable(server_->taken, -1ns));
    }

    void bytesArriveInOrder() {
        client_->write("tiller");
        QVERIFY(client_->waitForBytesWritten(60'000));
        QVERIFY(native_socket::waitReadable(server_->taken, 60s));
        std::array<std::uint8_t, 16> buffer{};
        const auto got = native_socket::receive(server_->taken, buffer);
        QVERIFY(got.status == Status::Ok);
        QCOMPARE(QByteArray(reinterpret_cast<const char*>(buffer.data()), static_cast<int>(got.bytes)),
                 QByteArray("tiller"));
    }

    void bytesLeaveInOrder() {
        const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
        const auto sent = native_socket::send(server_->taken, bytes);
        QVERIFY(sent.status == Status::Ok);
        QCOMPARE(sent.bytes, std::size_t(3));
        QVERIFY(client_->waitForReadyRead(60'000));
        QCOMPARE(client_->readAll(), QByteArray("\x01\x02\x03"));
    }

    void aClosedPeerIsDetected() {
        client_->disconnectFromHost();
        QVERIFY(native_socket::waitReadable(server_->taken, 60s));
        std::array<std::uint8_t, 16> buffer{};
        QVERIFY(native_socket::receive(server_->taken, buffer).status == Status::Closed);
    }

    void aFullPipeReportsWouldBlockWithoutASignal() {
        const std::vector<std::uint8_t> block(1 << 20, 0x55);
        Status status = Status::Ok;
        for (int n = 0; n < 1000 && status == Status::Ok; ++n) {
            status = native_socket::send(server_->taken, block).status;
        }
        QVERIFY(status == Status::WouldBlock);
    }

    void brokenPipeIsAnErrorNotASignal() {
        client_->abort();
        client_.reset();
        const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
        QTRY_VERIFY_WITH_TIMEOUT(native_socket::send(server_->taken, bytes).status == Status::Failed, 60'000);
    }

    // A stop must not wait for the next package or for the timeout.
    void aWakerEndsTheWaitOfAnotherThread() {
        const native_socket::EventFd waker;
        if (waker.descriptor() < 0) {
            QSKIP("not supported on this system");
        }
        QVERIFY(!waker.take());
        std::thread other([&waker] {
            std::this_thread::sleep_for(20ms);
            waker.wake();
        });
        QElapsedTimer time;
        time.start();
        QVERIFY(!native_socket::waitReadable(server_->taken, 60s, &waker));
        QVERIFY(time.elapsed() < 30'000);
        other.join();
        waker.wake();
        QVERIFY(!native_socket::waitReadable(server_->taken, 60s, &waker));
        QVERIFY(waker.take());
        QVERIFY(!waker.take());
    }

    void dataArriveDuringTheWaitWithAWaker() {
        const native_socket::EventFd waker;
        client_->write("tiller");
        QVERIFY(client_->waitForBytesWritten(60'000));
        QVERIFY(native_socket::waitReadable(server_->taken, 60s, &waker));
    }

    void aPortCanBeListenedToOnce() {
        const auto taken = native_socket::listen(0, 1);
        QVERIFY(taken >= 0);
        const int port = native_socket::localPort(taken);
        QVERIFY(port > 0);
        QVERIFY(native_socket::listen(port, 1) < 0);
        QVERIFY(native_socket::accept(taken) < 0);
        const auto attempt = connectTo(port);
        QVERIFY(native_socket::waitWritable(attempt.socket, 60s));
        QCOMPARE(native_socket::connectError(attempt.socket), 0);
        QVERIFY(native_socket::waitReadable(taken, 60s));
        const auto accepted = native_socket::accept(taken);
        QVERIFY(accepted >= 0);
        QCOMPARE(native_socket::peerPort(accepted), native_socket::localPort(attempt.socket));
        for (const auto socket : {accepted, attempt.socket, taken}) {
            native_socket::close(socket);
        }
    }

    void aRefusedConnectionIsReported() {
        const auto taken = native_socket::listen(0, 1);
        const int port = native_socket::localPort(taken);
        native_socket::close(taken);
        const auto attempt = connectTo(port);
        QVERIFY(attempt.socket >= 0);
        if (attempt.isPending) {
            QVERIFY(native_socket::waitWritable(attempt.socket, 60s));
        }
        QVERIFY(native_socket::isRefusal(attempt.isPending ? native_socket::connectError(attempt.socket)
                                                           : attempt.error));
        native_socket::close(attempt.socket);
    }

    void aSecondDescriptorOutlivesTheFirst() {
        const auto copy = native_socket::duplicate(server_->taken);
        QVERIFY(copy >= 0);
        native_socket::close(server_->taken);
        server_->taken = copy;
        client_->write("x");
        QVERIFY(client_->waitForBytesWritten(60'000));
        QVERIFY(native_socket::waitReadable(copy, 60s));
    }

private:
    static native_socket::Attempt connectTo(int port) {
        const auto addresses = native_socket::resolve("127.0.0.1", port);
        return addresses.empty() ? native_socket::Attempt() : native_socket::connect(addresses.front());
    }

    std::unique_ptr<DescriptorServer> server_;
    std::unique_ptr<QTcpSocket> client_;
};

QTEST_GUILESS_MAIN(TestNativeSocket)
#include "tst_native_socket.moc"
