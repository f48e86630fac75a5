// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <array>
#include <future>
#include <mutex>
#include <set>

#include "robot/script/program_stopper.h"
#include "tests/support/raw_peer.h"
#include "tests/support/waiting.h"
#include "tests/unit/robot/script/primary_bytes.h"

using namespace tiller;
using namespace tiller::script;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

constexpr int kWaitTimeoutMs = 60'000;

ProgramStopperOptions to(int port) {
    ProgramStopperOptions options;
    options.port = port;
    return options;
}

QByteArray stateWith(bool running) {
    return robotState(robotModeData(7, running));
}

/// The reply "The socket is read-only" of a controller in local control.
QByteArray refusal() {
    return message(6, Wire().i32(210).i32(0).i32(3).u32(0).u32(0).text("read-only").bytes());
}

/// Data received on each connection, one line per entry, in the order of the connections.
class Heard {
public:
    void add(const QByteArray& line) {
        const std::lock_guard lock(mutex_);
        lines_.append(line);
    }
    QList<QByteArray> lines() const {
        const std::lock_guard lock(mutex_);
        return lines_;
    }

private:
    mutable std::mutex mutex_;
    QList<QByteArray> lines_;
};

/// Runs a program until the command "stop program" arrives.
RawPeer::Script obedient(Heard& heard) {
    return [&heard](RawPeer::Link& link) {
        link.send(versionMessage() + stateWith(true));
        heard.add(link.readLine());
        while (!link.isOver()) {
            link.send(stateWith(false));
            std::this_thread::sleep_for(milliseconds(5));
        }
    };
}

}  // namespace

class TestProgramStopper : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theStopIsSentOnTheOpenConnection() {
        Heard heard;
        std::promise<void> heardOne;
        RawPeer peer([&, first = true, obey = obedient(heard)](RawPeer::Link& link) mutable {
            if (std::exchange(first, false)) {
                link.send(versionMessage() + stateWith(true));
                heard.add(link.readLine());
                heardOne.set_value();
                return;
            }
            obey(link);
        });
        VirtualClock clock;  // stopped, so nothing is sent again
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        QVERIFY(heard.lines().isEmpty());
        stopper.requestStop();
        heardOne.get_future().wait();
        QCOMPARE(heard.lines().first(), QByteArray("stop program"));
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
        QVERIFY(!stopper.isUnderWay());
    }

    // A controller that has lost the connection accepts data on it but never reads them. The clock is
    // stopped, so the second connection results from the request, not from elapsed time.
    void theStopIsAlsoSentOnANewConnection() {
        Heard heard;
        native_socket::Descriptor forgotten = -1;
        RawPeer peer([&, first = true, obey = obedient(heard)](RawPeer::Link& link) mutable {
            if (std::exchange(first, false)) {
                link.send(versionMessage() + stateWith(true));
                forgotten = link.forget();
                return;
            }
            obey(link);
        });
        VirtualClock clock;
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
        QCOMPARE(heard.lines(), QList<QByteArray>{"stop program"});
        stopper.end();
        native_socket::close(forgotten);
    }

    void aSilentConnectionIsReplaced() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(versionMessage() + stateWith(false));
            link.beMute();
        });
        VirtualClock clock;
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        for (int s = 0; s < 600 && peer.clients() < 2; ++s) {
            clock.advanceNs(kNsPerSecond / 10);
            QTest::qWait(10);
        }
        QCOMPARE(peer.clients(), 2);
    }

    void nothingIsSentWithoutARequest() {
        Heard heard;
        {
            RawPeer peer(obedient(heard));
            ProgramStopper stopper(to(peer.port()));
            stopper.start();
            QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
            QTest::qWait(50);
        }
        QCOMPARE(heard.lines(), QList<QByteArray>{QByteArray()});
    }

    void afterADisconnectTheStopIsSentOnTheNextConnection() {
        Heard heard;
        std::atomic<bool> back = false;
        RawPeer peer([&, obey = obedient(heard)](RawPeer::Link& link) {
            if (back) {
                obey(link);
            }  // otherwise, the peer disconnects immediately
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(peer.clients() > 0, kWaitTimeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(!stopper.isConnected(), kWaitTimeoutMs);
        back = true;
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
        QVERIFY(heard.lines().contains("stop program"));
    }

    // A connection opened in local control stays read-only after the switch to remote control. The clock is
    // stopped. The command is sent on the open connection and on one new connection, and is not repeated.
    void aRefusalCausesANewConnection() {
        Heard heard;
        native_socket::Descriptor readOnly = -1;
        RawPeer peer([&, first = true, obey = obedient(heard)](RawPeer::Link& link) mutable {
            if (std::exchange(first, false)) {
                link.send(versionMessage() + stateWith(true));
                heard.add(link.readLine());
                link.send(refusal());
                readOnly = link.forget();
                return;
            }
            obey(link);
        });
        VirtualClock clock;
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
        const QList<QByteArray> expected(2, QByteArray("stop program"));
        QCOMPARE(heard.lines(), expected);
        QCOMPARE(peer.clients(), 2);
        stopper.end();
        QCOMPARE(heard.lines(), expected);
        native_socket::close(readOnly);
    }

    // Without a connection, the operating system keeps the command and sends it again until the connection
    // works. The reset discards it.
    void aStopThatFailedIsNotDeliveredLater() {
        VirtualClock clock;
        std::mutex mutex;
        std::vector<native_socket::Descriptor> forgotten;
        RawPeer peer([&](RawPeer::Link& link) {
            link.send(versionMessage() + stateWith(true));
            const std::lock_guard lock(mutex);
            forgotten.push_back(link.forget());
        });
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.requestStop();
        for (int i = 0; i < 600 && stopper.isUnderWay(); ++i) {
            clock.advanceNs(kNsPerSecond / 10);
            QTest::qWait(10);
        }
        QCOMPARE(stopper.error().code, ErrorCode::Timeout);
        // The system reports a reset only once.
        std::set<native_socket::Descriptor> reset;
        const auto resets = [&] {
            const std::lock_guard lock(mutex);
            for (const native_socket::Descriptor each : forgotten) {
                std::array<std::uint8_t, 256> bytes;
                native_socket::Transfer got{native_socket::Status::Ok, 0};
                while (got.status == native_socket::Status::Ok) {
                    got = native_socket::receive(each, bytes);
                }
                if (got.status == native_socket::Status::Failed) {
                    reset.insert(each);
                }
            }
            return static_cast<int>(reset.size());
        };
        QVERIFY(peer.clients() > 2);
        // Each connection that carried the command is reset. The newest connection may not have carried it.
        QTRY_VERIFY2_WITH_TIMEOUT(resets() >= peer.clients() - 1, "the stop is delivered later",
                                  kWaitTimeoutMs);
        stopper.end();
        std::for_each(forgotten.begin(), forgotten.end(), native_socket::close);
    }

    void aRobotThatStaysInLocalIsReported() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(versionMessage() + stateWith(true));
            while (!link.isOver() && !link.readLine().isNull()) {
                link.send(refusal());
            }
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        stopper.requestStop();
        QCOMPARE(stopper.waitUntilStopped(testTimeout()).error().code, ErrorCode::RemoteControlRequired);
        QCOMPARE(stopper.error().code, ErrorCode::RemoteControlRequired);
    }

    void refusalsForOtherClientsAreIgnored() {
        RawPeer peer([first = true](RawPeer::Link& link) mutable {
            const QByteArray refusals = std::exchange(first, false) ? refusal().repeated(3) : QByteArray();
            link.send(versionMessage() + refusals + stateWith(true));
            link.readLine();
            while (!link.isOver()) {
                link.send(stateWith(false));
                std::this_thread::sleep_for(milliseconds(5));
            }
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        QTest::qWait(30);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
    }

    // The command may be lost on the open connection and on the new connection. It is sent again 0.3 s later
    // on a third connection.
    void theStopIsRepeatedWhileTheProgramRuns() {
        Heard heard;
        VirtualClock clock;
        constexpr std::size_t kForgotten = 2;
        std::vector<native_socket::Descriptor> forgotten;
        RawPeer peer([&, obey = obedient(heard)](RawPeer::Link& link) {
            if (forgotten.size() < kForgotten) {
                link.send(versionMessage() + stateWith(true));
                heard.add(link.readLine());
                forgotten.push_back(link.forget());
                return;
            }
            obey(link);
        });
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.requestStop();
        QList<QByteArray> expected(2, QByteArray("stop program"));
        QTRY_COMPARE_WITH_TIMEOUT(heard.lines(), expected, kWaitTimeoutMs);
        QVERIFY(stopper.isUnderWay());
        constexpr std::int64_t kAgainNs = 300 * kNsPerMs;
        clock.advanceNs(kAgainNs);
        QTest::qWait(50);  // five polling cycles of its thread
        QCOMPARE(heard.lines(), expected);
        QVERIFY(stopper.isUnderWay());
        clock.advanceNs(kNsPerMs);
        const auto stopped = stopper.waitUntilStopped(testTimeout());
        QVERIFY2(stopped.ok(), why(stopped));
        expected.append("stop program");
        QCOMPARE(heard.lines(), expected);
        QCOMPARE(peer.clients(), 3);
        QVERIFY(!stopper.isUnderWay());
        stopper.end();
        for (const auto descriptor : forgotten) {
            native_socket::close(descriptor);
        }
    }

    void aSilentControllerTimesOutAfterTwoSeconds() {
        VirtualClock clock;
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.requestStop();
        QVERIFY(stopper.isUnderWay());
        clock.advanceNs(2 * kNsPerSecond + kNsPerMs);
        QCOMPARE(stopper.waitUntilStopped(testTimeout()).error().code, ErrorCode::Timeout);
    }

    void aRefusedConnectionIsReported() {
        VirtualClock clock;
        ProgramStopperOptions options = to(RawPeer::deadPort());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        stopper.requestStop();
        clock.advanceNs(2 * kNsPerSecond + kNsPerMs);
        QCOMPARE(stopper.waitUntilStopped(testTimeout()).error().code, ErrorCode::ConnectionRefused);
    }

    // requestStop() must not block its caller when the buffers of a peer that is not reading are full.
    void requestStopNeverBlocks() {
        std::promise<void> done;
        RawPeer peer([wait = done.get_future().share()](RawPeer::Link&) { wait.wait(); });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        for (int i = 0; i < 400'000 && stopper.isConnected(); ++i) {
            stopper.requestStop();
        }
        stopper.withdraw();
        done.set_value();
        QCOMPARE(stopper.waitUntilStopped(testTimeout()).error().code, ErrorCode::Cancelled);
    }

    // A client that takes control after the withdrawal must not lose control because of the earlier stop
    // request.
    void aWithdrawnStopIsNotSent() {
        Heard heard;
        std::atomic<bool> back = false;
        {
            RawPeer peer([&, obey = obedient(heard)](RawPeer::Link& link) {
                if (back) {
                    obey(link);
                }
            });
            ProgramStopper stopper(to(peer.port()));
            stopper.start();
            QTRY_VERIFY_WITH_TIMEOUT(peer.clients() > 0, kWaitTimeoutMs);
            QTRY_VERIFY_WITH_TIMEOUT(!stopper.isConnected(), kWaitTimeoutMs);
            stopper.requestStop();
            stopper.withdraw();
            QCOMPARE(stopper.error().code, ErrorCode::Cancelled);
            back = true;
            QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
            QTest::qWait(50);
        }
        QVERIFY(!heard.lines().contains("stop program"));
    }

    void reconnectOpensANewConnection() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
        stopper.reconnect();
        QTRY_COMPARE_WITH_TIMEOUT(peer.clients(), 2, kWaitTimeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kWaitTimeoutMs);
    }

    void isNotConnectedWithoutItsThread() {
        ProgramStopper stopper(to(RawPeer::deadPort()));
        stopper.requestStop();
        QCOMPARE(stopper.waitUntilStopped(testTimeout()).error().code, ErrorCode::NotConnected);
    }
};

QTEST_GUILESS_MAIN(TestProgramStopper)
#include "tst_program_stopper.moc"
