// SPDX-License-Identifier: MIT
//
// `tiller-cli serve` in a separate process under a flood of hostile connections and frames, while other
// viewers work. The memory of the process must remain small, and the working viewers must not lose a package.
// An environment variable sets the number of connections:
//   TILLER_HOSTILE_CONNECTIONS=100000 tst_live_hostile

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "robot/recording/mcap/robot_state_message.h"
#include "robot/rtde/protocol.h"
#include "tests/integration/live/raw_viewer.h"
#include "tests/support/rtde_peer.h"

using namespace tiller;
using namespace std::chrono_literals;
using test::clientFrame;
using test::Opcode;
using test::RawViewer;
using test::RtdePeer;

namespace {

constexpr int kHostileWaitMs = 60'000;

/// Returns the peak resident size of the process [MB].
double peakMemory(qint64 process) {
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    if (status.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : status.readAll().split('\n')) {
            if (line.startsWith("VmHWM:")) {
                return line.mid(6).simplified().split(' ').first().toDouble() / 1000;
            }
        }
    }
    return std::nan("");
}

/// Reads all states in a thread and checks that the robot packages are consecutive.
class WorkingViewer {
public:
    explicit WorkingViewer(quint16 port) : thread_([this, port] { run(port); }) {}
    ~WorkingViewer() { stop(); }
    void stop() {
        stopping_ = true;
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    int received() const { return received_; }
    int gaps() const { return gaps_; }
    bool wasDisconnected() const { return disconnected_; }
    double longestPause() const { return longestPause_; }  ///< longest time between two messages [s]

private:
    void run(quint16 port) {
        RawViewer viewer(port);
        disconnected_ = viewer.upgrade() != 101;
        test::FrameReader frames;
        std::optional<recording::mcap::RobotStateLayout> layout;
        double last = 0;
        auto lastTime = std::chrono::steady_clock::now();
        while (!stopping_ && !disconnected_) {
            viewer.socket.waitForReadyRead(100);
            frames.feed(viewer.socket.readAll());
            while (const auto frame = frames.next()) {
                if (frame->opcode == Opcode::Text) {
                    if (auto found = follow(viewer, frame->payload)) {
                        layout.emplace(*found, "");
                    }
                } else if (frame->opcode == Opcode::Binary && layout) {
                    const double time = timeOf(*layout, frame->payload);
                    gaps_ += received_ > 0 && std::abs(time - last - 0.002) > 0.0005 ? 1 : 0;
                    last = time;
                    const auto now = std::chrono::steady_clock::now();
                    if (received_ > 0) {
                        longestPause_ = std::max(longestPause_.load(),
                                                 std::chrono::duration<double>(now - lastTime).count());
                    }
                    lastTime = now;
                    ++received_;
                }
            }
            disconnected_ = viewer.socket.state() != QAbstractSocket::ConnectedState;
        }
    }
    /// Subscribes to the states when they are advertised, and returns their definition.
    static std::optional<std::string> follow(RawViewer& viewer, const QByteArray& text) {
        const QJsonObject message = QJsonDocument::fromJson(text).object();
        for (const QJsonValue& channel : message["channels"].toArray()) {
            if (channel["topic"].toString() == QLatin1String("/robot_state")) {
                viewer.subscribe(1, channel["id"].toInt());
                return channel["schema"].toString().toStdString();
            }
        }
        return {};
    }
    static double timeOf(const recording::mcap::RobotStateLayout& layout, const QByteArray& message) {
        const std::string_view content(message.constData() + 13,
                                       static_cast<std::size_t>(message.size() - 13));
        for (const auto& place : layout.places()) {
            if (place.column.name == "timestamp") {
                return recording::mcap::RobotStateLayout::valueAt(place, content);
            }
        }
        return std::nan("");
    }

    std::atomic<bool> stopping_{false};
    std::atomic<bool> disconnected_{false};
    std::atomic<int> received_{0};
    std::atomic<int> gaps_{0};
    std::atomic<double> longestPause_{0};
    std::thread thread_;  // last member, because it uses all others
};

/// Opens one hostile connection. Returns it if it should remain open.
std::unique_ptr<RawViewer> attack(quint16 port, int number) {
    constexpr int kSources = 200;  // a single address would have too few ports for all connections
    auto viewer = std::make_unique<RawViewer>(
        port, QHostAddress(0x7f000001U + static_cast<quint32>(number % kSources)));
    // Writes as much data as the server accepts. The server may have closed the connection.
    const auto send = [&viewer](const QByteArray& bytes) {
        viewer->socket.write(bytes);
        viewer->socket.flush();
    };
    const auto upgraded = [&send](const QByteArray& bytes) { send(test::handshakeRequest() + bytes); };
    constexpr int kKinds = 15;
    switch (number % kKinds) {
        case 0:  // sends nothing
            return viewer;
        case 1:  // half a header
            send("GET / HTTP/1.1\r\nHost: x\r\n");
            return viewer;
        case 2:  // a header that never ends
            send("GET / HTTP/1.1\r\n" + ("X: " + QByteArray(100, 'x') + "\r\n").repeated(1000));
            break;
        case 3:
            send(QByteArray(4096, '\xff'));
            break;
        case 4:
            viewer->upgrade("https://example.com");
            break;
        case 5:  // a frame too large
            upgraded(clientFrame(Opcode::Binary, QByteArray(200'000, 'x'), true, 400'000'000));
            break;
        case 6:  // a frame that never ends
            upgraded(clientFrame(Opcode::Text, QByteArray(1000, 'x'), true, 60'000));
            return viewer;
        case 7:  // endless fragments
            upgraded(clientFrame(Opcode::Text, QByteArray(1000, 'x'), false) +
                     clientFrame(Opcode::Continuation, QByteArray(1000, 'x'), false).repeated(200));
            break;
        case 8:
            upgraded(clientFrame(Opcode::Ping, QByteArray(125, 'p')).repeated(2000));
            return viewer;
        case 9:  // many requests without reading the replies
            upgraded(clientFrame(Opcode::Text, R"({"op":"nothing"})").repeated(500));
            return viewer;
        case 10:  // subscribes to all channels and reads nothing
            viewer->upgrade();
            viewer->socket.setReadBufferSize(1024);
            for (const int channel : {1, 2, 3, 11}) {
                viewer->subscribe(channel, channel);
            }
            return viewer;
        case 11:
            upgraded(clientFrame(Opcode::Text, QByteArray(30'000, '[')));
            break;
        case 12:  // invalid UTF-8, reserved bits, a reserved opcode, a control frame that is too large
            upgraded(clientFrame(Opcode::Text, "\xff\xfe\xc0"));
            upgraded(QByteArray("\xf1\x80\x00\x00\x00\x00", 6));
            upgraded(clientFrame(static_cast<Opcode>(5), {}));
            break;
        case 13:
            upgraded(clientFrame(Opcode::Close, "\x03\xe8"));
            break;
        default:  // idle
            viewer->upgrade();
            return viewer;
    }
    return {};
}

}  // namespace

class TestLiveHostile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readingViewersLoseNoData() {
        bool given = false;
        const int wanted = qEnvironmentVariableIntValue("TILLER_HOSTILE_CONNECTIONS", &given);
        const int connections = given ? wanted : 600;
        RtdePeer peer;
        std::atomic<bool> over{false};
        std::atomic<int> sent{0};
        std::thread robot([&peer, &over, &sent] {
            auto next = std::chrono::steady_clock::now();
            while (!over) {
                if (peer.isStarted()) {
                    peer.send(++sent * 0.002);
                }
                std::this_thread::sleep_until(next += 2ms);
            }
        });
        QProcess serve;
        serve.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        serve.start(QStringLiteral(TILLER_CLI),
                    {"serve", "127.0.0.1", "--port-offset", QString::number(peer.port() - rtde::kPort),
                     "--port", "0", "--quiet", "--wait", "60"});
        while (!serve.canReadLine() && serve.waitForReadyRead(kHostileWaitMs)) {
        }
        const QString ready = QString::fromUtf8(serve.readLine()).trimmed();
        const quint16 port = ready.section(':', -1).toUShort();
        QVERIFY2(ready.startsWith(QLatin1String("ready")) && port != 0, qPrintable(ready));
        const double before = peakMemory(serve.processId());
        WorkingViewer first(port);
        WorkingViewer second(port);
        QTRY_VERIFY_WITH_TIMEOUT(first.received() > 100 && second.received() > 100, kHostileWaitMs);

        std::atomic<int> next{0};
        std::vector<std::thread> attackers;
        for (int i = 0; i < 2; ++i) {
            attackers.emplace_back([&next, connections, port] {
                constexpr std::size_t kKept = 100;
                std::deque<std::unique_ptr<RawViewer>> kept;
                for (int number = next++; number < connections; number = next++) {
                    if (auto viewer = attack(port, number)) {
                        kept.push_back(std::move(viewer));
                        if (kept.size() > kKept) {
                            kept.pop_front();
                        }
                    }
                }
            });
        }
        for (std::thread& attacker : attackers) {
            attacker.join();
        }
        WorkingViewer third(port);
        QTRY_VERIFY_WITH_TIMEOUT(third.received() > 100, kHostileWaitMs);
        over = true;
        robot.join();
        first.stop();
        second.stop();
        third.stop();
        const double peak = peakMemory(serve.processId());
        qInfo(
            "%d connections, %d packages; memory %.1f MB before, %.1f MB at most; viewers: %d and %d "
            "messages, "
            "%d and %d gaps, longest pauses %.0f and %.0f ms",
            connections, sent.load(), before, peak, first.received(), second.received(), first.gaps(),
            second.gaps(), first.longestPause() * 1000, second.longestPause() * 1000);
        QVERIFY(!first.wasDisconnected() && !second.wasDisconnected() && !third.wasDisconnected());
        QCOMPARE(first.gaps(), 0);
        QCOMPARE(second.gaps(), 0);
        QVERIFY2(peak < 100, qPrintable(QString::number(peak)));
        serve.terminate();
        QVERIFY(serve.waitForFinished(kHostileWaitMs));
        QCOMPARE(serve.exitCode(), 0);
    }
};

QTEST_GUILESS_MAIN(TestLiveHostile)
#include "tst_live_hostile.moc"
