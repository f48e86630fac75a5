// SPDX-License-Identifier: MIT
#include <QElapsedTimer>
#include <QTest>
#include <atomic>

#include "robot/script/primary_client.h"
#include "tests/support/raw_peer.h"
#include "tests/unit/robot/script/primary_bytes.h"

using namespace tiller;
using namespace tiller::script;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

Deadline soon() {
    return Deadline::after(milliseconds(20000));
}

PrimaryClientOptions to(int port, bool reconnect = false) {
    PrimaryClientOptions options;
    options.port = port;
    options.reconnect = reconnect;
    return options;
}

}  // namespace

class TestPrimaryClient : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void deliversStateConfigurationAndMessages() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(versionMessage() + message(0, "hello"));
            link.send(robotState(robotModeData(7, true) + configurationData()));
            link.beMute();
        });
        PrimaryClient client(to(peer.port()));
        client.start();
        QVERIFY(client.waitForState(soon()).ok());
        QVERIFY(client.isConnected());
        QCOMPARE(client.state().robotMode, RobotMode::Running);
        QCOMPARE(client.state().version.major, 5U);
        QVERIFY(client.configuration().has_value());
        const auto messages = client.takeMessages();
        QCOMPARE(messages.size(), 2U);
        QCOMPARE(messages.back().text, QStringLiteral("hello"));
        QVERIFY(client.takeMessages().empty());
    }

    void refusedPortIsReported() {
        PrimaryClient client(to(RawPeer::deadPort()));
        client.start();
        QCOMPARE(client.waitForState(soon()).error().code, ErrorCode::ConnectionRefused);
        QVERIFY(!client.isConnected());
    }

    void aSilentServerCausesATimeout() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        PrimaryClient client(to(peer.port()));
        client.start();
        QCOMPARE(client.waitForState(Deadline::after(milliseconds(50))).error().code, ErrorCode::Timeout);
    }

    void garbageIsReported() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(QByteArray(100, '\xff'));
            link.beMute();
        });
        PrimaryClient client(to(peer.port()));
        client.start();
        QTRY_COMPARE_WITH_TIMEOUT(client.connectionError().code, ErrorCode::ProtocolError, 20000);
        QCOMPARE(client.malformedPackages(), 1U);
    }

    void garbageCausesAReconnect() {
        RawPeer peer([first = true](RawPeer::Link& link) mutable {
            if (std::exchange(first, false)) {
                link.send(QByteArray(100, '\xff'));
                link.beMute();
                return;
            }
            link.send(robotState(robotModeData(5, false)));
            link.beMute();
        });
        PrimaryClient client(to(peer.port(), true));
        client.start();
        // The error itself is visible only until the next connection is established, so it cannot be checked
        // reliably.
        QTRY_COMPARE_WITH_TIMEOUT(client.malformedPackages(), 1U, 20000);
        QTRY_COMPARE_WITH_TIMEOUT(client.state().robotMode, RobotMode::Idle, 20000);
        QCOMPARE(client.connectionError().code, ErrorCode::None);
    }

    void closedConnectionIsReportedAndRestored() {
        RawPeer peer([](RawPeer::Link& link) { link.send(versionMessage()); });
        PrimaryClient client(to(peer.port(), true));
        client.start();
        QTRY_COMPARE_WITH_TIMEOUT(client.connectionError().code, ErrorCode::ConnectionClosed, 20000);
        QTRY_VERIFY_WITH_TIMEOUT(peer.clients() >= 2, 20000);
    }

    void unreadMessagesAreBounded() {
        RawPeer peer([](RawPeer::Link& link) {
            for (int i = 0; i < 100; ++i) {
                link.send(message(0, QByteArray::number(i)));
            }
            link.send(robotState(robotModeData(7, false)));
            link.beMute();
        });
        PrimaryClientOptions options = to(peer.port());
        options.maxMessages = 10;
        PrimaryClient client(options);
        client.start();
        QVERIFY(client.waitForState(soon()).ok());
        const auto messages = client.takeMessages();
        QCOMPARE(messages.size(), 10U);
        QCOMPARE(messages.back().text, QStringLiteral("99"));
        QCOMPARE(client.droppedMessages(), 90U);
    }

    // Unread data stay at the sender. A slow machine reads less data, never more.
    void aFloodIsReadAtABoundedRate() {
        std::atomic<qint64> sent{0};
        RawPeer peer([&sent](RawPeer::Link& link) {
            link.send(robotState(robotModeData(7, false)));
            const QByteArray many = message(0, "popup after popup").repeated(1000);
            while (!link.isOver()) {
                link.send(many);
                sent += many.size();
            }
        });
        PrimaryClientOptions options = to(peer.port());
        options.maxMessages = 1000;
        PrimaryClient client(options);
        QElapsedTimer time;
        client.start();
        QVERIFY(client.waitForState(soon()).ok());
        time.start();
        QTRY_VERIFY_WITH_TIMEOUT(client.droppedMessages() > 0, 60'000);
        QTest::qWait(1000);
        constexpr double kBytesPerMs = 2000;
        constexpr double kBuffers = 16e6;  // TCP buffers at both ends
        const double taken = static_cast<double>(sent);
        QVERIFY2(taken < kBuffers + kBytesPerMs * static_cast<double>(time.elapsed()),
                 qPrintable(QString::number(taken)));
        QCOMPARE(client.takeMessages().size(), 1000U);
    }

    void aLongTextIsTruncated() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(message(0, QByteArray(60'000, 'x')));
            link.send(robotState(robotModeData(7, false)));
            link.beMute();
        });
        PrimaryClient client(to(peer.port()));
        client.start();
        QVERIFY(client.waitForState(soon()).ok());
        const auto messages = client.takeMessages();
        QCOMPARE(messages.size(), 1U);
        QVERIFY2(messages.front().text.size() <= 4096,
                 qPrintable(QString::number(messages.front().text.size())));
        QVERIFY(messages.front().text.startsWith("xxx"));
    }

    void stopEndsTheWaitForASilentPeer() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        PrimaryClient client(to(peer.port()));
        client.start();
        QTRY_VERIFY_WITH_TIMEOUT(client.isConnected(), 60'000);
        client.stop();
        QVERIFY(!client.isConnected());
    }
};

QTEST_GUILESS_MAIN(TestPrimaryClient)
#include "tst_primary_client.moc"
