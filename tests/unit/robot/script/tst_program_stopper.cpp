// SPDX-License-Identifier: MIT
#include <QTest>
#include <future>
#include <mutex>

#include "robot/script/program_stopper.h"
#include "tests/support/raw_peer.h"
#include "tests/support/waiting.h"
#include "tests/unit/robot/script/primary_bytes.h"

using namespace tiller;
using namespace tiller::script;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

constexpr int kPatienceMs = 60'000;

ProgramStopperOptions to(int port) {
    ProgramStopperOptions options;
    options.port = port;
    return options;
}

QByteArray stateWith(bool running) {
    return robotState(robotModeData(7, running));
}

/// "The socket is read-only": what a controller in Local answers with.
QByteArray refusal() {
    return message(6, Wire().i32(210).i32(0).i32(3).u32(0).u32(0).text("read-only").bytes());
}

/// What each connection was sent, one line per entry, in the order of the connections.
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

/// A program runs until somebody says "stop program".
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
    void theWordLeavesOnTheConnectionThatIsOpenAlready() {
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
        VirtualClock clock;  // nothing is sent again
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        QVERIFY(heard.lines().isEmpty());
        stopper.requestStop();
        heardOne.get_future().wait();
        QCOMPARE(heard.lines().first(), QByteArray("stop program"));
        const auto stopped = stopper.waitUntilStopped(patience());
        QVERIFY2(stopped.ok(), why(stopped));
        QVERIFY(!stopper.isUnderWay());
    }

    // A controller that has forgotten the connection takes what is sent on it, and never reads it. The clock stands
    // still: the second connection is made because of the request, not because time has passed.
    void itLeavesOnANewConnectionAtOnceToo() {
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
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(patience());
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
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        for (int s = 0; s < 600 && peer.clients() < 2; ++s) {
            clock.advanceNs(kNsPerSecond / 10);
            QTest::qWait(10);
        }
        QCOMPARE(peer.clients(), 2);
    }

    void nothingIsSentUnasked() {
        Heard heard;
        {
            RawPeer peer(obedient(heard));
            ProgramStopper stopper(to(peer.port()));
            stopper.start();
            QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
            QTest::qWait(50);
        }
        QCOMPARE(heard.lines(), QList<QByteArray>{QByteArray()});
    }

    void aControllerThatHungUpIsToldOnTheNextConnection() {
        Heard heard;
        std::atomic<bool> back = false;
        RawPeer peer([&, obey = obedient(heard)](RawPeer::Link& link) {
            if (back) {
                obey(link);
            }  // else: hangs up at once
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(peer.clients() > 0, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(!stopper.isConnected(), kPatienceMs);
        back = true;
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(patience());
        QVERIFY2(stopped.ok(), why(stopped));
        QVERIFY(heard.lines().contains("stop program"));
    }

    // A connection made in Local stays read-only after the switch to Remote.
    void aRefusalIsAnsweredByANewConnection() {
        Heard heard;
        RawPeer peer([&, first = true, obey = obedient(heard)](RawPeer::Link& link) mutable {
            if (std::exchange(first, false)) {
                link.send(versionMessage() + stateWith(true));
                heard.add(link.readLine());
                link.send(refusal());
                link.beMute();
                return;
            }
            obey(link);
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(patience());
        QVERIFY2(stopped.ok(), why(stopped));
        // A stop also goes out on a second connection at once, so a slow machine may hear more than two.
        QVERIFY(heard.lines().size() >= 2);
        QCOMPARE(heard.lines().count("stop program"), heard.lines().size());
        QVERIFY(peer.clients() >= 2);
    }

    void aRobotThatStaysInLocalSaysSo() {
        RawPeer peer([](RawPeer::Link& link) {
            link.send(versionMessage() + stateWith(true));
            while (!link.isOver() && !link.readLine().isNull()) {
                link.send(refusal());
            }
        });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        stopper.requestStop();
        QCOMPARE(stopper.waitUntilStopped(patience()).error().code, ErrorCode::RemoteControlRequired);
        QCOMPARE(stopper.error().code, ErrorCode::RemoteControlRequired);
    }

    void whatTheControllerRefusedOthersIsNotForUs() {
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
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        QTest::qWait(30);
        stopper.requestStop();
        const auto stopped = stopper.waitUntilStopped(patience());
        QVERIFY2(stopped.ok(), why(stopped));
    }

    // The word may be lost on a connection that only seems to be one.
    void aProgramThatGoesOnIsToldAgain() {
        Heard heard;
        VirtualClock clock;
        RawPeer peer([&, obey = obedient(heard)](RawPeer::Link& link) {
            if (heard.lines().size() < 2) {
                link.send(versionMessage() + stateWith(true));
                heard.add(link.readLine());
                link.beMute();
                return;
            }
            obey(link);
        });
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        stopper.requestStop();
        QTRY_VERIFY_WITH_TIMEOUT(heard.lines().size() > 0, kPatienceMs);
        QVERIFY(stopper.isUnderWay());
        // The command goes out on a second connection too, so the number of received ones may pass 2 unseen. Stays below
        // the two seconds after which the request ends.
        for (int step = 0; step < 19 * 5 && heard.lines().size() < 3; ++step) {
            clock.advanceNs(20 * kNsPerMs);
            QTest::qWait(10);
        }
        const auto stopped = stopper.waitUntilStopped(patience());
        QVERIFY2(stopped.ok(), why(stopped));
        QCOMPARE(heard.lines().size(), 3);
    }

    void aMuteControllerIsGivenUpAfterTwoSeconds() {
        VirtualClock clock;
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ProgramStopperOptions options = to(peer.port());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        stopper.requestStop();
        QVERIFY(stopper.isUnderWay());
        clock.advanceNs(2 * kNsPerSecond + kNsPerMs);
        QCOMPARE(stopper.waitUntilStopped(patience()).error().code, ErrorCode::Timeout);
    }

    void whereNothingListensTheReasonIsNamed() {
        VirtualClock clock;
        ProgramStopperOptions options = to(RawPeer::deadPort());
        options.clock = &clock;
        ProgramStopper stopper(options);
        stopper.start();
        stopper.requestStop();
        clock.advanceNs(2 * kNsPerSecond + kNsPerMs);
        QCOMPARE(stopper.waitUntilStopped(patience()).error().code, ErrorCode::ConnectionRefused);
    }

    // Its buffers full, a peer that does not read must not hold up whoever presses STOP.
    void whoeverAsksNeverWaits() {
        std::promise<void> done;
        RawPeer peer([wait = done.get_future().share()](RawPeer::Link&) { wait.wait(); });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        for (int i = 0; i < 400'000 && stopper.isConnected(); ++i) {
            stopper.requestStop();
        }
        stopper.withdraw();
        done.set_value();
        QCOMPARE(stopper.waitUntilStopped(patience()).error().code, ErrorCode::Cancelled);
    }

    // Whoever takes control now must not lose it to a stop of before.
    void whatIsWithdrawnIsNotSentAnyMore() {
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
            QTRY_VERIFY_WITH_TIMEOUT(peer.clients() > 0, kPatienceMs);
            QTRY_VERIFY_WITH_TIMEOUT(!stopper.isConnected(), kPatienceMs);
            stopper.requestStop();
            stopper.withdraw();
            QCOMPARE(stopper.error().code, ErrorCode::Cancelled);
            back = true;
            QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
            QTest::qWait(50);
        }
        QVERIFY(!heard.lines().contains("stop program"));
    }

    void aNewConnectionIsMadeOnWish() {
        RawPeer peer([](RawPeer::Link& link) { link.beMute(); });
        ProgramStopper stopper(to(peer.port()));
        stopper.start();
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
        stopper.reconnect();
        QTRY_COMPARE_WITH_TIMEOUT(peer.clients(), 2, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(stopper.isConnected(), kPatienceMs);
    }

    void withoutItsThreadItIsNotConnected() {
        ProgramStopper stopper(to(RawPeer::deadPort()));
        stopper.requestStop();
        QCOMPARE(stopper.waitUntilStopped(patience()).error().code, ErrorCode::NotConnected);
    }
};

QTEST_GUILESS_MAIN(TestProgramStopper)
#include "tst_program_stopper.moc"
