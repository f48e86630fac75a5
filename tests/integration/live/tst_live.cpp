// SPDX-License-Identifier: MIT
//
// Forwards robot data through real sockets to a test viewer, to a Node.js viewer that only uses the published
// protocol, and as datagrams.

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTest>
#include <QUdpSocket>
#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <QtEndian>

#include "robot/live/live_output.h"
#include "robot/recording/mcap/robot_state_message.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace std::chrono_literals;
using test::RtdePeer;

namespace {

constexpr int kWaitTimeoutMs = 60'000;
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kWaitTimeoutMs)
#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kWaitTimeoutMs)

receive::ReceiverOptions to(std::uint16_t port) {
    receive::ReceiverOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = port;
    options.priority = 0;
    options.connectTimeout = 1h;
    options.silenceLimit = 1h;
    return options;
}

struct Bench {
    Bench() : receiver(to(peer.port())) { receiver.start().value(); }
    void send(int count) {
        for (int i = 0; i < count; ++i) {
            peer.send(++sent * 0.002);
        }
        TRY_COMPARE(receiver.counters().packets, static_cast<std::uint64_t>(sent));
    }
    /// Starts the output and waits for the state channel, which needs a package to determine the fields of
    /// the robot.
    void start(live::LiveOptions options = {}) {
        options.port = 0;
        QVERIFY(output.start(options, receiver).ok());
        send(1);
        TRY_COMPARE(output.progress().packets, std::uint64_t(1));
    }
    RtdePeer peer;
    receive::Receiver receiver;
    live::LiveOutput output;
    int sent = 0;
};

/// A minimal viewer.
class Viewer {
public:
    explicit Viewer(std::uint16_t port) {
        QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [this](const QString& text) {
            const QJsonObject message = QJsonDocument::fromJson(text.toUtf8()).object();
            reported << message;
            for (const QJsonValue& channel : message["channels"].toArray()) {
                channels[channel["topic"].toString()] = channel.toObject();
            }
        });
        QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                         [this](const QByteArray& bytes) { messages << bytes; });
        QWebSocketHandshakeOptions options;
        options.setSubprotocols({"foxglove.sdk.v1"});
        socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(port)), options);
    }
    void say(const QJsonObject& message) {
        socket.sendTextMessage(QString::fromUtf8(QJsonDocument(message).toJson(QJsonDocument::Compact)));
    }
    void subscribe(const QString& topic, int id) {
        say({{"op", "subscribe"},
             {"subscriptions", QJsonArray{QJsonObject{{"id", id}, {"channelId", channels[topic]["id"]}}}}});
    }
    QStringList statuses() const {
        QStringList out;
        for (const QJsonObject& message : reported) {
            if (message["op"].toString() == "status") {
                out << message["message"].toString();
            }
        }
        return out;
    }
    QWebSocket socket;
    QList<QJsonObject> reported;
    QHash<QString, QJsonObject> channels;
    QList<QByteArray> messages;
};

}  // namespace

class TestLive : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aViewerGetsEveryPackage();
    void onlySubscribedTopicsAreSent();
    void invalidRequestsAreAnsweredAndHarmless();
    void aViewerInNodeGetsEveryPackage();
    void plotJugglerReceivesDatagrams();
    void startFailuresAreReported();
    void serverListensOnTheLocalMachineOnly();
};

void TestLive::aViewerGetsEveryPackage() {
    Bench bench;
    bench.peer.set("actual_q", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
    bench.start();
    Viewer viewer(bench.output.port());
    TRY_VERIFY(viewer.channels.contains("/robot_state"));
    QCOMPARE(viewer.socket.subprotocol(), QStringLiteral("foxglove.sdk.v1"));
    QCOMPARE(viewer.reported.front()["op"].toString(), QStringLiteral("serverInfo"));
    const QJsonObject channel = viewer.channels["/robot_state"];
    QCOMPARE(channel["encoding"].toString(), QStringLiteral("cdr"));
    QCOMPARE(channel["schemaEncoding"].toString(), QStringLiteral("ros2msg"));
    viewer.subscribe("/robot_state", 7);
    viewer.subscribe("/tf", 8);
    viewer.say({{"op", "nothing"}});
    TRY_COMPARE(viewer.statuses().size(), 1);  // the earlier requests have therefore been processed
    bench.send(1000);
    TRY_COMPARE(viewer.messages.size(), 2000);
    const recording::mcap::RobotStateLayout layout(channel["schema"].toString().toStdString(), "");
    int expected = 2;
    for (const QByteArray& message : viewer.messages) {
        QCOMPARE(message[0], char(1));
        if (qFromLittleEndian<quint32>(message.constData() + 1) != 7) {
            continue;
        }
        const std::string_view content(message.constData() + 13,
                                       static_cast<std::size_t>(message.size() - 13));
        for (const auto& place : layout.places()) {
            const double value = recording::mcap::RobotStateLayout::valueAt(place, content);
            if (place.column.name == "timestamp") {
                QCOMPARE(value, expected * 0.002);
            } else if (place.column.name == "actual_q_4") {
                QCOMPARE(value, 0.5);
            }
        }
        ++expected;
    }
    QCOMPARE(expected, 1002);
    TRY_COMPARE(bench.output.progress().viewers, 1);
    QCOMPARE(bench.output.progress().dropped, std::uint64_t(0));
    bench.output.stop();
    TRY_COMPARE(viewer.socket.state(), QAbstractSocket::UnconnectedState);
}

void TestLive::onlySubscribedTopicsAreSent() {
    Bench bench;
    bench.start();
    Viewer viewer(bench.output.port());
    TRY_VERIFY(viewer.channels.contains("/robot_state"));
    viewer.subscribe("/wrench", 1);
    viewer.say({{"op", "nothing"}});
    TRY_COMPARE(viewer.statuses().size(), 1);
    bench.send(10);
    TRY_COMPARE(viewer.messages.size(), 10);
    viewer.say({{"op", "unsubscribe"}, {"subscriptionIds", QJsonArray{1}}});
    viewer.say({{"op", "nothing"}});
    TRY_COMPARE(viewer.statuses().size(), 2);
    bench.send(10);
    TRY_COMPARE(bench.output.progress().packets, std::uint64_t(21));
    QCOMPARE(viewer.messages.size(), 10);
    TRY_COMPARE(bench.output.progress().messages, std::uint64_t(10));
}

void TestLive::invalidRequestsAreAnsweredAndHarmless() {
    Bench bench;
    bench.start();
    Viewer viewer(bench.output.port());
    Viewer other(bench.output.port());
    TRY_VERIFY(viewer.channels.contains("/robot_state") && other.channels.contains("/wrench"));
    other.subscribe("/wrench", 1);
    other.say({{"op", "nothing"}});
    TRY_COMPARE(other.statuses().size(), 1);
    for (const char* text : {"", "{", "[]", "null", "{\"op\":5}",
                             "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":999}]}",
                             "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":-1,\"channelId\":1e99}]}",
                             "{\"op\":\"advertise\",\"channels\":[]}"}) {
        viewer.socket.sendTextMessage(text);
    }
    viewer.socket.sendBinaryMessage(QByteArray("\x01garbage"));
    viewer.subscribe("/wrench", 3);
    viewer.subscribe("/wrench", 3);  // the number is already in use
    TRY_COMPARE(viewer.statuses().size(), 9);
    QVERIFY(viewer.statuses().contains("channel 999 does not exist"));
    bench.send(5);
    TRY_COMPARE(other.messages.size(), 5);
    TRY_COMPARE(viewer.messages.size(), 5);
    // A viewer that sends a request that is too large is disconnected.
    viewer.socket.sendTextMessage(QString(1 << 20, QLatin1Char('x')));
    TRY_COMPARE(viewer.socket.state(), QAbstractSocket::UnconnectedState);
    bench.send(5);
    TRY_COMPARE(other.messages.size(), 10);
}

void TestLive::aViewerInNodeGetsEveryPackage() {
    const QString modules = QStringLiteral(TILLER_NODE_MODULES);
    const QString node = QStandardPaths::findExecutable("node");
    if (node.isEmpty() || !QFileInfo::exists(modules + "/ws") ||
        !QFileInfo::exists(modules + "/@foxglove/rosmsg")) {
        QSKIP(
            "Node.js or its packages are not installed (packaging/test installs the packages in build/npm)");
    }
    Bench bench;
    bench.peer.set("actual_TCP_pose", {0.4, -0.2, 0.3, 0, 3.14, 0});
    bench.start();
    QProcess viewer;
    viewer.start(node, {QStringLiteral(TILLER_SOURCE_DIR "/tests/integration/live/viewer.mjs"), modules,
                        QStringLiteral("ws://127.0.0.1:%1").arg(bench.output.port()), "2000", "50"});
    viewer.setReadChannel(QProcess::StandardError);
    TRY_VERIFY(viewer.canReadLine());
    QCOMPARE(viewer.readLine().trimmed(), QByteArray("subscribed"));
    // The request of the viewer is in transit, so the viewer receives nothing until the request arrives.
    while (bench.output.progress().messages == 0 && bench.sent < 1000) {
        bench.send(1);
        QTest::qWait(1);
    }
    const int before = bench.sent;
    bench.send(2000);
    QVERIFY(viewer.waitForFinished(kWaitTimeoutMs));
    const QJsonObject found = QJsonDocument::fromJson(viewer.readAllStandardOutput()).object();
    QCOMPARE(found["protocol"].toString(), QStringLiteral("foxglove.sdk.v1"));
    QCOMPARE(found["name"].toString(), QStringLiteral("Tiller"));
    QCOMPARE(found["topics"]["/robot_state"]["count"].toInt(), 2000);
    QCOMPARE(found["gaps"].toInt(), 0);
    QCOMPARE(found["lost"].toInt(), 0);
    QCOMPARE(found["last"]["actual_tcp_pose"][1].toDouble(), -0.2);
    QVERIFY(found["last"]["timestamp"].toDouble() <= (before + 2000) * 0.002);
    QVERIFY(found["topics"]["/joint_states"]["count"].toInt() >= 1999);
    QVERIFY(found["topics"]["/tf"]["count"].toInt() == 2000);
}

void TestLive::plotJugglerReceivesDatagrams() {
    Bench bench;
    bench.peer.set("actual_q", {1, 2, 3, 4, 5, 6.5});
    bench.peer.set("robot_mode", {7});
    QUdpSocket plotJuggler;
    QVERIFY(plotJuggler.bind(QHostAddress::LocalHost, 0));
    live::LiveOptions options;
    options.listenAddress = QString();
    options.udpAddress = QStringLiteral("127.0.0.1");
    options.udpPort = plotJuggler.localPort();
    options.fields = {"timestamp", "actual_q", "robot_mode"};
    QVERIFY(bench.output.start(options, bench.receiver).ok());
    QCOMPARE(bench.output.port(), std::uint16_t(0));
    for (int i = 1; i <= 20; ++i) {
        bench.send(1);
        TRY_VERIFY(plotJuggler.hasPendingDatagrams());
        QByteArray bytes(65536, Qt::Uninitialized);
        bytes.resize(plotJuggler.readDatagram(bytes.data(), bytes.size()));
        const QJsonObject packet = QJsonDocument::fromJson(bytes).object();
        QCOMPARE(packet.size(), 3);
        QCOMPARE(packet["timestamp"].toDouble(), i * 0.002);
        QCOMPARE(packet["actual_q"][5].toDouble(), 6.5);
        QCOMPARE(packet["robot_mode"].toInt(), 7);
    }
    TRY_COMPARE(bench.output.progress().datagrams, std::uint64_t(20));
}

void TestLive::startFailuresAreReported() {
    Bench bench;
    live::LiveOptions options;
    options.listenAddress = QStringLiteral("robot.local");
    QCOMPARE(bench.output.start(options, bench.receiver).error().code, ErrorCode::AddressInvalid);
    QTcpServer taken;
    QVERIFY(taken.listen(QHostAddress::LocalHost));
    options = {};
    options.port = taken.serverPort();
    const Error error = bench.output.start(options, bench.receiver).error();
    QCOMPARE(error.code, ErrorCode::Rejected);
    QVERIFY(error.context.contains(QString::number(taken.serverPort())));
    options = {};
    options.fields = {"actual_qq"};
    QCOMPARE(bench.output.start(options, bench.receiver).error().code, ErrorCode::FieldUnknown);
    options = {};
    options.listenAddress = QString();
    options.udpAddress = QStringLiteral("here");
    QCOMPARE(bench.output.start(options, bench.receiver).error().code, ErrorCode::AddressInvalid);
    QCOMPARE(bench.output.progress().packets, std::uint64_t(0));
}

void TestLive::serverListensOnTheLocalMachineOnly() {
    QCOMPARE(live::LiveOptions().listenAddress, QStringLiteral("127.0.0.1"));
    QVERIFY(live::LiveOptions().udpAddress.isEmpty());
}

QTEST_GUILESS_MAIN(TestLive)
#include "tst_live.moc"
