// SPDX-License-Identifier: MIT
// A client writes commands to a program at the maximum rate. The program continues, the newest command takes
// effect quickly, and unread data remain in the client's buffers.
#include <QDeadlineTimer>
#include <QTcpServer>
#include <QTest>
#include <atomic>
#include <thread>

#include "tests/support/primary_listener.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kNumbers = 8;  ///< numbers per command, as in the vendor's library
constexpr qsizetype kCommand = 4 * kNumbers;

QByteArray command(qint32 number) {
    return bigEndian(number).repeated(kNumbers);
}

/// A robot whose program reads commands in a loop without sync() and writes the last command to a register.
struct Cell {
    explicit Cell(const simulator::SimulatorOptions& options = VirtualRobot::options()) : robot(options) {
        server.listen(QHostAddress::LocalHost);
        primary.send("def p():\n  socket_open(\"127.0.0.1\", " + QByteArray::number(server.serverPort()) +
                     ")\n  while True:\n    c = socket_read_binary_integer(8, timeout=0)\n    if c[0] == 8:\n"
                     "      write_output_integer_register(0, c[8])\n    end\n  end\nend\n");
        rtde.useVersion();
        rtde.setupOutputs(500, "output_int_register_0");
        rtde.start();
    }
    /// The client side of the program's socket.
    QTcpSocket* client() {
        const QDeadlineTimer hangs(std::chrono::minutes(1));
        while (!server.waitForNewConnection(1) && !hangs.hasExpired()) {
            robot.controller.step();
        }
        QTcpSocket* const socket = server.nextPendingConnection();
        robot.controller.step(5);
        return socket;
    }
    /// The command in effect. Robot time does not advance during the call.
    qint32 acting() {
        for (const RawRtde::Package& package : rtde.packages()) {
            last = package.type == 'U' ? intAt(package.payload, 1) : last;
        }
        return last;
    }

    QTcpServer server;
    VirtualRobot robot;
    RawPrimary primary = robot.primary();
    RawRtde rtde = robot.rtde();
    qint32 last = 0;
};

}  // namespace

class TestScriptFlood : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theNewestOfManyCommandsActsWithinTwoPeriods() {
        Cell cell;
        QTcpSocket* const client = cell.client();
        QVERIFY(client != nullptr);
        qint32 newest = 0;
        for (int round = 0; round < 20; ++round) {
            QByteArray burst;
            for (int i = 0; i < 300; ++i) {
                burst += command(++newest);
            }
            client->write(burst);
            while (client->bytesToWrite() > 0 && client->waitForBytesWritten(kWaitTimeoutMs)) {
            }
            cell.robot.controller.drainSockets();  // the network is faster than a control period
            cell.robot.controller.step(2);
            QCOMPARE(cell.acting(), newest);
        }
        QCOMPARE(cell.robot.programState(), RuntimeState::Playing);
    }

    // While the client writes, time does not advance for the program, and TCP blocks the client.
    void unreadDataRemainAtTheClient() {
        Cell cell;
        QTcpSocket* const client = cell.client();
        QVERIFY(client != nullptr);
        // Data that are not accepted remain in the client's buffers.
        constexpr qsizetype kFlood = 64 << 20;
        client->write(command(1).repeated(kFlood / kCommand));
        for (int i = 0; i < 200; ++i) {
            client->waitForBytesWritten(5);
            cell.robot.controller.drainSockets();
        }
        QVERIFY2(client->bytesToWrite() > kFlood / 2, qPrintable(QString::number(client->bytesToWrite())));
        // The client continues to send as the program reads.
        const qint64 before = client->bytesToWrite();
        const QDeadlineTimer hangs(std::chrono::minutes(1));
        while (client->bytesToWrite() == before && !hangs.hasExpired()) {
            cell.robot.controller.step();
            client->waitForBytesWritten(1);
        }
        QVERIFY(client->bytesToWrite() < before);
        QCOMPARE(cell.robot.programState(), RuntimeState::Playing);
    }

    // Send in real time, from a thread that does nothing else.
    void aFloodDoesNotEndTheProgram() {
        auto options = VirtualRobot::options();
        options.time = simulator::Time::Real;
        Cell cell(options);
        QVERIFY(cell.server.waitForNewConnection(kWaitTimeoutMs));
        QTcpSocket* const client = cell.server.nextPendingConnection();
        QByteArray many;
        for (qint32 i = 1; i <= 1000; ++i) {
            many += command(i);
        }
        const double begin = cell.robot.controller.truth().timestamp;
        // The duration is measured in robot time, so it does not depend on the speed of the computer.
        while (cell.robot.controller.truth().timestamp < begin + 0.3) {
            client->write(many);
            while (client->bytesToWrite() > (1 << 20) && client->waitForBytesWritten(100)) {
            }
        }
        QCOMPARE(cell.robot.programState(), RuntimeState::Playing);
        QCOMPARE(cell.robot.controller.truth().safetyMode, SafetyMode::Normal);
        while (client->bytesToWrite() > 0 && client->waitForBytesWritten(kWaitTimeoutMs)) {
        }
        client->write(command(424242));
        client->waitForBytesWritten(kWaitTimeoutMs);
        // Packages arrive without a pause, so there is no end to wait for.
        QDeadlineTimer deadline(kWaitTimeoutMs);
        qint32 acting = 0;
        while (acting != 424242 && !deadline.hasExpired()) {
            const RawRtde::Package package = cell.rtde.next();
            acting = package.type == 'U' ? intAt(package.payload, 1) : acting;
        }
        QCOMPARE(acting, 424242);
        QVERIFY(!Heard(cell.primary).texts.contains("Runtime"));
    }

    // A text that is longer than the receive buffer arrives completely.
    void aLongTextArrivesComplete() {
        Cell cell;
        cell.primary.send("stop program\n");
        cell.robot.controller.drainSockets();
        cell.robot.controller.stepSeconds(0.2);
        cell.primary.send(
            "def p():\n  socket_open(\"127.0.0.1\", " + QByteArray::number(cell.server.serverPort()) +
            ")\n  n = 0\n  while n < 200:\n    s = socket_read_string(suffix=\"!\", timeout=0)\n"
            "    n = n + 1\n  end\n  textmsg(socket_read_line(timeout=0))\nend\n");
        while (cell.server.hasPendingConnections()) {
            delete cell.server.nextPendingConnection();
        }
        QTcpSocket* const client = cell.client();
        QVERIFY(client != nullptr);
        client->write(QByteArray(1023, 'x').append('!').repeated(200) + QByteArray(100'000, 'y') + "end\n");
        QByteArrayList texts;
        for (int i = 0; i < 2000 && texts.isEmpty(); ++i) {
            client->waitForBytesWritten(1);
            cell.robot.controller.step();
            texts = i % 10 == 0 ? Heard(cell.primary).texts : texts;
        }
        QCOMPARE(texts.size(), qsizetype(1));
        QVERIFY(texts[0].startsWith("yyyy"));
    }
};

QTEST_GUILESS_MAIN(TestScriptFlood)
#include "tst_script_flood.moc"
