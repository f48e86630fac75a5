// SPDX-License-Identifier: MIT
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "robot/platform/socket_poller.h"

using namespace tiller;

class TestSocketPoller : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void reportsClientsAndData() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        SocketPoller poller;
        poller.addPort(server.socketDescriptor());
        QVERIFY(!poller.poll());
        QTcpSocket client;
        client.connectToHost(QHostAddress::LocalHost, server.serverPort());
        QTRY_VERIFY_WITH_TIMEOUT(poller.poll(), 60'000);
        QVERIFY(client.waitForConnected(60'000));
        QTRY_VERIFY_WITH_TIMEOUT(server.hasPendingConnections(), 60'000);
        QTcpSocket* accepted = server.nextPendingConnection();
        QVERIFY(!poller.poll());

        bool rung = false;
        QVERIFY(poller.add(accepted->socketDescriptor(), &rung));
        poller.poll();
        QVERIFY(!rung);
        client.write("x");
        QVERIFY(client.waitForBytesWritten(60'000));
        QTRY_VERIFY_WITH_TIMEOUT((poller.poll(), rung), 60'000);
        poller.remove(accepted->socketDescriptor());
        rung = false;
        poller.poll();
        QVERIFY(!rung);
    }

    void reportsTheEndOfAConnection() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        QTcpSocket client;
        client.connectToHost(QHostAddress::LocalHost, server.serverPort());
        QVERIFY(client.waitForConnected(60'000));
        QTRY_VERIFY_WITH_TIMEOUT(server.hasPendingConnections(), 60'000);
        QTcpSocket* accepted = server.nextPendingConnection();
        SocketPoller poller;
        bool rung = false;
        QVERIFY(poller.add(accepted->socketDescriptor(), &rung));
        client.abort();
        QTRY_VERIFY_WITH_TIMEOUT((poller.poll(), rung), 60'000);
        poller.remove(accepted->socketDescriptor());
    }

    void forgetsAClosedPort() {
        SocketPoller poller;
        {
            QTcpServer server;
            QVERIFY(server.listen(QHostAddress::LocalHost));
            poller.addPort(server.socketDescriptor());
        }
        for (int n = 0; n < 3; ++n) {
            QVERIFY(!poller.poll());
        }
    }
};

QTEST_GUILESS_MAIN(TestSocketPoller)
#include "tst_socket_poller.moc"
