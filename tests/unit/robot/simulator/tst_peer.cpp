// SPDX-License-Identifier: MIT
//
// Data that a client of the simulated controller receives and sends, over real sockets.

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <array>
#include <memory>
#include <string>

#include "robot/platform/native_socket.h"
#include "robot/simulator/net/link.h"
#include "robot/simulator/net/peer.h"

using namespace tiller;
using namespace tiller::simulator;

namespace {

struct Connected {
    QTcpServer server;
    QTcpSocket client;
    Link link{1};
    std::unique_ptr<Peer> peer;

    Connected() {
        server.listen(QHostAddress::LocalHost);
        client.connectToHost(QHostAddress::LocalHost, server.serverPort());
        server.waitForNewConnection(20'000);
        client.waitForConnected(20'000);
        const std::unique_ptr<QTcpSocket> accepted(server.nextPendingConnection());
        const auto socket = native_socket::duplicate(accepted->socketDescriptor());
        native_socket::prepare(socket);
        peer = std::make_unique<Peer>(socket, 1 << 16);
        peer->attach(&link);
    }
    /// Resets the connection as an operating system does when a program exits with unread data.
    void cut() {
        native_socket::discardOnClose(client.socketDescriptor());
        client.abort();
    }
    std::string read() {
        std::array<std::uint8_t, 512> bytes;
        std::string all;
        link.poller().poll();
        while (const std::size_t got = peer->receive(bytes)) {
            all.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(got));
        }
        return all;
    }
};

}  // namespace

class TestPeer : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// A send may detect that the connection was reset before the received data have been read.
    void dataSentBeforeTheEndOfAConnectionAreRead() {
        Connected c;
        const QByteArray program(40'000, 'p');
        QCOMPARE(c.client.write(program), qint64(program.size()));
        while (c.client.bytesToWrite() > 0) {
            QVERIFY(c.client.waitForBytesWritten(20'000));
        }
        c.cut();
        constexpr int kTries = 20;  // the system detects the reset on the first send
        for (int i = 0; i < kTries; ++i) {
            QVERIFY(c.peer->send(std::string_view("a state")));
        }
        QCOMPARE(c.read().size(), static_cast<std::size_t>(program.size()));
        QVERIFY(c.read().empty());
        QVERIFY(!c.peer->isOpen());
    }

    void closedIdleClientIsDetectedAtOnce() {
        Connected c;
        c.cut();
        QTRY_VERIFY_WITH_TIMEOUT((c.peer->send(std::string_view("a state")), !c.peer->isOpen()), 20'000);
    }
};

QTEST_GUILESS_MAIN(TestPeer)
#include "tst_peer.moc"
