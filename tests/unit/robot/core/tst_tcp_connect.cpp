// SPDX-License-Identifier: MIT
#include <QTcpServer>
#include <QTest>
#include <vector>

#ifdef __linux__
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#endif

#include "robot/core/tcp_connect.h"

using namespace tiller;
using namespace std::chrono_literals;

class TestTcpConnect : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void connectsByAddressAndByName() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        for (const char* host : {"127.0.0.1", " localhost "}) {
            const auto socket = connectTcp(host, server.serverPort(), Deadline::after(10s));
            QVERIFY2(socket.ok(), qPrintable(socket.error().toString()));
            QVERIFY(*socket >= 0);
            native_socket::close(*socket);
        }
    }

    // A peer that loses power does not close the connection. Only keep-alive detects this.
    void keepAliveIsEnabled() {
#ifdef __linux__
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const auto socket = connectTcp("127.0.0.1", server.serverPort(), Deadline::after(10s));
        QVERIFY2(socket.ok(), qPrintable(socket.error().toString()));
        const auto option = [&](int level, int name) {
            int value = 0;
            socklen_t size = sizeof value;
            return ::getsockopt(static_cast<int>(*socket), level, name, &value, &size) == 0 ? value : -1;
        };
        QCOMPARE(option(SOL_SOCKET, SO_KEEPALIVE), 1);
        QCOMPARE(option(IPPROTO_TCP, TCP_KEEPIDLE) +
                     option(IPPROTO_TCP, TCP_KEEPINTVL) * option(IPPROTO_TCP, TCP_KEEPCNT),
                 static_cast<int>(native_socket::kPeerTimeout.count() / 1000));
        QCOMPARE(option(IPPROTO_TCP, TCP_USER_TIMEOUT),
                 static_cast<int>(native_socket::kPeerTimeout.count()));
        native_socket::close(*socket);
#else
        QSKIP("the keep-alive times cannot be read on this system");
#endif
    }

    void reportsWhyTheConnectionFailed_data() {
        QTest::addColumn<QString>("host");
        QTest::addColumn<int>("port");
        QTest::addColumn<int>("code");
        QTest::newRow("empty") << "  " << 30004 << int(ErrorCode::AddressInvalid);
        QTest::newRow("port 0") << "127.0.0.1" << 0 << int(ErrorCode::AddressInvalid);
        QTest::newRow("port too large") << "127.0.0.1" << 70000 << int(ErrorCode::AddressInvalid);
        QTest::newRow("not a name") << "no such host" << 30004 << int(ErrorCode::AddressInvalid);
        QTest::newRow("nobody listens") << "127.0.0.1" << 1 << int(ErrorCode::ConnectionRefused);
    }
    void reportsWhyTheConnectionFailed() {
        QFETCH(QString, host);
        QFETCH(int, port);
        QFETCH(int, code);
        const auto socket = connectTcp(host, port, Deadline::after(10s));
        QVERIFY(!socket.ok());
        QCOMPARE(int(socket.error().code), code);
        QVERIFY(!socket.error().context.isEmpty());
    }

    // A server that accepts no more connections. Its queue is full, and the system drops packets.
    void deadlineAndCancelEndTheWait() {
        QTcpServer server;
        server.setListenBacklogSize(1);
        QVERIFY(server.listen(QHostAddress::LocalHost));
        std::vector<native_socket::Descriptor> queue;
        const auto testTimeout = Deadline::after(20s);
        ErrorCode code = ErrorCode::None;
        while (code == ErrorCode::None && !testTimeout.hasExpired()) {
            const auto socket = connectTcp("127.0.0.1", server.serverPort(), Deadline::after(50ms));
            code = socket.error().code;
            if (socket) {
                queue.push_back(*socket);
            }
        }
        QCOMPARE(code, ErrorCode::Timeout);

        const CancelToken cancelled;
        cancelled.cancel();
        QCOMPARE(connectTcp("127.0.0.1", server.serverPort(), Deadline::after(1h, cancelled)).error().code,
                 ErrorCode::Cancelled);

        int asked = 0;  // number of polls; the token cancels at the fourth
        const CancelToken polled([&asked] { return ++asked > 3; });
        QCOMPARE(connectTcp("127.0.0.1", server.serverPort(), Deadline::after(1h, polled)).error().code,
                 ErrorCode::Cancelled);
        QCOMPARE(asked, 4);
        for (const auto socket : queue) {
            native_socket::close(socket);
        }
    }
};

QTEST_GUILESS_MAIN(TestTcpConnect)
#include "tst_tcp_connect.moc"
