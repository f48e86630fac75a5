// SPDX-License-Identifier: MIT
//
// Hostile and broken viewers of the live server. The memory and time of each viewer are limited, and the
// other viewers lose no data.

#include <QDeadlineTimer>
#include <QTest>
#include <vector>

#include "robot/live/live_output.h"
#include "tests/integration/live/raw_viewer.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace std::chrono_literals;
using test::clientFrame;
using test::Opcode;
using test::RawViewer;
using test::RtdePeer;

namespace {

constexpr int kLimitWaitMs = 60'000;
constexpr int kJointStateChannel = 1;
constexpr int kStateChannel = 11;
#define WAIT_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kLimitWaitMs)
#define WAIT_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kLimitWaitMs)

/// A robot that sends on request, a receiver, and the output under test.
struct LimitBench {
    explicit LimitBench(live::LiveOptions options = {}) {
        receive::ReceiverOptions wanted;
        wanted.host = QStringLiteral("127.0.0.1");
        wanted.port = peer.port();
        wanted.priority = 0;
        wanted.connectTimeout = 1h;
        wanted.silenceLimit = 1h;
        receiver.emplace(wanted);
        receiver->start().value();
        options.port = 0;
        output.start(options, *receiver).value();
        send(1);
    }
    void send(int count) {
        for (int i = 0; i < count; ++i) {
            peer.send(++sent * 0.002);
        }
        WAIT_COMPARE(output.progress().packets, static_cast<std::uint64_t>(sent));
    }
    std::uint16_t port() const { return output.port(); }

    RtdePeer peer;
    std::optional<receive::Receiver> receiver;
    live::LiveOutput output;
    int sent = 0;
};

/// Reads until `count` binary messages were received, or until the timeout. Returns their number.
int readMessages(RawViewer& viewer, int count, test::FrameReader& frames) {
    int messages = 0;
    QDeadlineTimer deadline(kLimitWaitMs);
    while (messages < count && !deadline.hasExpired()) {
        frames.feed(viewer.socket.readAll());
        while (const auto frame = frames.next()) {
            messages += frame->opcode == Opcode::Binary ? 1 : 0;
        }
        if (messages < count) {
            viewer.socket.waitForReadyRead(10);
        }
    }
    return messages;
}

}  // namespace

class TestLiveLimits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aFrameThatIsTooLargeIsRefusedByItsHeader();
    void unterminatedFragmentsAreBounded();
    void requestsOfMaximumSizeAreServed();
    void anUnterminatedHeaderIsBounded();
    void aSilentConnectionIsClosed_data();
    void aSilentConnectionIsClosed();
    void aViewerThatDoesNotReadLosesTheOldestMessages();
    void aViewerThatDoesNotReadIsDisconnected();
    void answersAreBounded_data();
    void answersAreBounded();
    void aFloodOfRequestsEndsTheConnection();
    void idleViewersDoNotLockOutOthers();
    void subscribedViewersAreLimited();
    void requestsFromOtherOriginsAreRefused_data();
    void requestsFromOtherOriginsAreRefused();
    void malformedOriginsAreRejected();
};

void TestLiveLimits::aFrameThatIsTooLargeIsRefusedByItsHeader() {
    LimitBench bench;
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    constexpr quint64 kDeclared = 400'000'000;
    bool open = viewer.write(clientFrame(Opcode::Text, {}, true, kDeclared));
    // The server must not read data that it will refuse.
    const QByteArray chunk(1 << 20, 'x');
    int taken = 0;
    while (open && taken < 64) {
        open = viewer.write(chunk);
        ++taken;
    }
    QVERIFY2(!open, "64 MiB of a single frame were accepted");
    WAIT_COMPARE(bench.output.progress().viewers, 0);
}

void TestLiveLimits::unterminatedFragmentsAreBounded() {
    LimitBench bench;
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    bool open = viewer.write(clientFrame(Opcode::Text, QByteArray(1000, 'x'), false));
    int fragments = 0;
    while (open && fragments < 10'000) {
        open = viewer.write(clientFrame(Opcode::Continuation, QByteArray(1000, 'x'), false));
        ++fragments;
    }
    QVERIFY2(!open, "10 MB of fragments were accepted");
    WAIT_COMPARE(bench.output.progress().viewers, 0);
}

// The read buffer of a connection holds one frame. The next frame must still arrive.
void TestLiveLimits::requestsOfMaximumSizeAreServed() {
    live::LiveOptions options;
    options.limits.maxRequestRate = 1 << 30;
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    QByteArray many;
    for (const qint64 size :
         {options.limits.maxRequestBytes - 1, options.limits.maxRequestBytes, qint64(30'000)}) {
        many += clientFrame(Opcode::Binary, QByteArray(size, 'x'));
    }
    QVERIFY(viewer.write(many.repeated(5)));
    QVERIFY(viewer.subscribe(1, kJointStateChannel));
    bench.peer.set("actual_q", {1, 2, 3, 4, 5, 6});
    test::FrameReader frames;
    WAIT_VERIFY((bench.send(1), bench.output.progress().messages > 0));
    QVERIFY(readMessages(viewer, 1, frames) >= 1);
}

void TestLiveLimits::anUnterminatedHeaderIsBounded() {
    LimitBench bench;
    RawViewer viewer(bench.port());
    const QByteArray line = "X-Header: " + QByteArray(1000, 'x') + "\r\n";
    constexpr qint64 kAll = 64 << 20;
    qint64 taken = 0;
    QObject::connect(&viewer.socket, &QTcpSocket::bytesWritten, [&taken](qint64 bytes) { taken += bytes; });
    viewer.socket.write("GET / HTTP/1.1\r\n" + line.repeated(static_cast<int>(kAll / line.size())));
    while (viewer.socket.bytesToWrite() > 0 && viewer.socket.waitForBytesWritten(RawViewer::kTimeoutMs)) {
    }
    // The TCP buffers hold a few megabytes that the server never reads.
    QVERIFY2(taken < kAll / 2, qPrintable(QString::number(taken)));
}

void TestLiveLimits::aSilentConnectionIsClosed_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("part of a header") << QByteArray("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n");
    QTest::newRow("another protocol") << QByteArray("\x16\x03\x01\x02\x00\x01\x00\x01", 8);
}

void TestLiveLimits::aSilentConnectionIsClosed() {
    QFETCH(QByteArray, bytes);
    live::LiveOptions options;
    options.limits.handshakeTimeout = 50ms;
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    viewer.write(bytes);
    // Qt's own handshake timeout is 10 s.
    QVERIFY(viewer.waitForClosed(8'000));
}

void TestLiveLimits::aViewerThatDoesNotReadLosesTheOldestMessages() {
    live::LiveOptions options;
    options.limits.maxQueueBytes = 1024 * 1024;
    options.limits.stallTimeout = 1h;
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    viewer.socket.setReadBufferSize(1024);
    QVERIFY(viewer.subscribe(1, kStateChannel));
    RawViewer other(bench.port());
    QCOMPARE(other.upgrade(), 101);
    QVERIFY(other.subscribe(1, kStateChannel));
    WAIT_VERIFY((bench.send(1), bench.output.progress().messages >= 2));
    // Sends until the buffers of both ends are full.
    test::FrameReader frames;
    const int begin = bench.sent;
    int got = 0;
    while (bench.output.progress().dropped < 500 && bench.sent < 200'000) {
        bench.send(100);
        got += readMessages(other, 100, frames);
    }
    QVERIFY(bench.output.progress().dropped >= 500);
    QVERIFY(got >= bench.sent - begin);  // the other viewer lost no data
    // After the pause, the viewer receives the newest message, not only the oldest messages that still fit in
    // the buffers.
    constexpr double kLast = 123.5;
    bench.peer.set("actual_q", {kLast, 0, 0, 0, 0, 0});
    bench.send(1);
    viewer.socket.setReadBufferSize(0);
    QByteArray bytes;
    QByteArray wanted(8, '\0');
    qToLittleEndian(kLast, wanted.data());
    QDeadlineTimer deadline(kLimitWaitMs);
    while (!bytes.contains(wanted) && !deadline.hasExpired()) {
        viewer.socket.waitForReadyRead(10);
        bytes = bytes.right(8) + viewer.socket.readAll();
    }
    QVERIFY(bytes.contains(wanted));
}

void TestLiveLimits::aViewerThatDoesNotReadIsDisconnected() {
    live::LiveOptions options;
    options.limits.maxQueueBytes = 64 * 1024;
    options.limits.stallTimeout = 100ms;
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    viewer.socket.setReadBufferSize(1024);
    QVERIFY(viewer.subscribe(1, kStateChannel));
    WAIT_VERIFY((bench.send(1), bench.output.progress().messages > 0));
    QDeadlineTimer deadline(kLimitWaitMs);
    while (bench.output.progress().viewers > 0 && !deadline.hasExpired()) {
        bench.send(100);
    }
    QCOMPARE(bench.output.progress().viewers, 0);
    WAIT_VERIFY(bench.output.progress().disconnected >= 1);
}

void TestLiveLimits::answersAreBounded_data() {
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("unknown operation") << clientFrame(Opcode::Text, R"({"op":"nothing"})");
    QTest::newRow("ping") << clientFrame(Opcode::Ping, QByteArray(125, 'p'));
    QByteArray subscriptions;
    for (int i = 0; i < 1000; ++i) {
        subscriptions += "{},";
    }
    subscriptions.chop(1);
    QTest::newRow("many errors in one request")
        << clientFrame(Opcode::Text, R"({"op":"subscribe","subscriptions":[)" + subscriptions + "]}");
}

// The client makes the server write data, but does not read them.
void TestLiveLimits::answersAreBounded() {
    QFETCH(QByteArray, request);
    live::LiveOptions options;
    options.limits.maxRequestRate = 1 << 30;
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    viewer.socket.setReadBufferSize(1024);
    const QByteArray many = request.repeated(static_cast<int>(100'000 / request.size()) + 1);
    qint64 written = 0;
    while (viewer.write(many) && written < 256'000'000) {
        written += many.size();
    }
    QVERIFY2(written < 256'000'000, "the replies to 256 MB of requests were buffered in memory");
    WAIT_COMPARE(bench.output.progress().viewers, 0);
}

void TestLiveLimits::aFloodOfRequestsEndsTheConnection() {
    LimitBench bench;
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    const QByteArray many = clientFrame(Opcode::Pong, {}).repeated(10'000);
    qint64 written = 0;
    while (viewer.write(many) && written < 512'000'000) {
        written += many.size();
    }
    QVERIFY2(written < 512'000'000, "512 MB of unnecessary frames were processed");
    WAIT_VERIFY(bench.output.progress().disconnected >= 1);
}

void TestLiveLimits::idleViewersDoNotLockOutOthers() {
    LimitBench bench;
    std::vector<std::unique_ptr<RawViewer>> idle;
    for (int i = 0; i < 100; ++i) {
        idle.push_back(std::make_unique<RawViewer>(bench.port()));
        if (i % 2 == 0) {
            idle.back()->upgrade();
        }
    }
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(), 101);
    QVERIFY(viewer.subscribe(1, kStateChannel));
    WAIT_VERIFY((bench.send(1), bench.output.progress().messages > 0));
    // The viewer remains connected, regardless of the number of other connections.
    for (int i = 0; i < 100; ++i) {
        idle.push_back(std::make_unique<RawViewer>(bench.port()));
        idle.back()->upgrade();
    }
    const auto before = bench.output.progress().messages;
    bench.send(100);
    WAIT_COMPARE(bench.output.progress().messages, before + 100);
    WAIT_VERIFY(bench.output.progress().viewers <= 1 + live::LiveLimits().maxIdleConnections);
}

void TestLiveLimits::subscribedViewersAreLimited() {
    live::LiveOptions options;
    options.limits.maxViewers = 3;
    LimitBench bench(options);
    std::vector<std::unique_ptr<RawViewer>> viewers;
    for (int i = 0; i < 5; ++i) {
        viewers.push_back(std::make_unique<RawViewer>(bench.port()));
        QCOMPARE(viewers.back()->upgrade(), 101);
        QVERIFY(viewers.back()->subscribe(1, kStateChannel));
        QVERIFY(viewers.back()->send(R"({"op":"nothing"})"));
        QByteArray answer;
        WAIT_VERIFY((viewers.back()->socket.waitForReadyRead(1), answer += viewers.back()->socket.readAll(),
                     answer.contains("\"nothing\\\"")));
        QCOMPARE(answer.contains("too many viewers"), i >= 3);
    }
    bench.send(10);
    WAIT_COMPARE(bench.output.progress().messages, std::uint64_t(30));
    // A viewer that disconnects frees a slot.
    viewers.front().reset();
    WAIT_COMPARE(bench.output.progress().viewers, 4);
    QVERIFY(viewers.back()->subscribe(2, kStateChannel));
    WAIT_VERIFY((bench.send(1), bench.output.progress().messages % 3 == 0));
}

void TestLiveLimits::requestsFromOtherOriginsAreRefused_data() {
    QTest::addColumn<QByteArray>("origin");
    QTest::addColumn<bool>("allowed");
    QTest::newRow("no page") << QByteArray() << true;
    QTest::newRow("localhost") << QByteArray("http://localhost:8080") << true;
    QTest::newRow("loopback") << QByteArray("http://127.0.0.1") << true;
    QTest::newRow("loopback IPv6") << QByteArray("https://[::1]:8443") << true;
    QTest::newRow("listed") << QByteArray("https://app.foxglove.dev") << true;
    QTest::newRow("listed, capitals") << QByteArray("HTTPS://App.Foxglove.dev") << true;
    QTest::newRow("foreign") << QByteArray("https://example.com") << false;
    QTest::newRow("foreign, named like the host") << QByteArray("http://localhost.example.com") << false;
    QTest::newRow("foreign, begins with an address") << QByteArray("http://127.0.0.1.example.com") << false;
    QTest::newRow("foreign, user name") << QByteArray("http://localhost@example.com") << false;
    QTest::newRow("listed with another scheme") << QByteArray("http://app.foxglove.dev") << false;
    QTest::newRow("listed with another port") << QByteArray("https://app.foxglove.dev:444") << false;
    QTest::newRow("below the listed") << QByteArray("https://x.app.foxglove.dev") << false;
    QTest::newRow("sandboxed page") << QByteArray("null") << false;
    QTest::newRow("file") << QByteArray("file://") << false;
    QTest::newRow("another machine") << QByteArray("http://192.0.2.7") << false;
    QTest::newRow("extension") << QByteArray("chrome-extension://localhost") << false;
    QTest::newRow("garbage") << QByteArray("%%%") << false;
}

void TestLiveLimits::requestsFromOtherOriginsAreRefused() {
    QFETCH(QByteArray, origin);
    QFETCH(bool, allowed);
    live::LiveOptions options;
    options.allowedOrigins = {"https://app.foxglove.dev/"};
    LimitBench bench(options);
    RawViewer viewer(bench.port());
    QCOMPARE(viewer.upgrade(origin), allowed ? 101 : 403);
    WAIT_COMPARE(bench.output.progress().viewers, allowed ? 1 : 0);
    WAIT_COMPARE(bench.output.progress().refused, std::uint64_t(allowed ? 0 : 1));
    if (!allowed) {
        QCOMPARE(bench.output.progress().refusedOrigin, QString::fromLatin1(origin));
    }
}

void TestLiveLimits::malformedOriginsAreRejected() {
    LimitBench bench;
    for (const char* origin :
         {"", "*", "example.com", "https://", "https://a/b", "https://a?b", "https://u@a"}) {
        live::LiveOptions options;
        options.allowedOrigins = {origin};
        live::LiveOutput other;
        const auto started = other.start(options, *bench.receiver);
        QVERIFY2(!started && started.error().code == ErrorCode::AddressInvalid, origin);
    }
    for (const char* origin : {"null", "file://", "https://a.example:8443", "http://[2001:db8::1]"}) {
        live::LiveOptions options;
        options.port = 0;
        options.allowedOrigins = {origin};
        live::LiveOutput other;
        QVERIFY2(other.start(options, *bench.receiver).ok(), origin);
    }
}

QTEST_GUILESS_MAIN(TestLiveLimits)
#include "tst_live_limits.moc"
