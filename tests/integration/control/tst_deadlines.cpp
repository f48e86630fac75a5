// SPDX-License-Identifier: MIT
// A peer that does not respond must not block anything. Every waiting call ends at its deadline or when it is
// cancelled, and destroyed objects release all resources. The test does not measure time: if a call does not
// end, the test hangs. tests/benchmarks/backend_performance measures the timing.
#include <QDir>

#include "tests/integration/control/blocking_calls.h"
#include "tests/support/asked_clock.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;
using std::chrono::milliseconds;

namespace {

int openFiles() {
    return static_cast<int>(QDir(QStringLiteral("/proc/self/fd")).entryList(QDir::NoFilter).size());
}

int threads() {
    return static_cast<int>(
        QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size());
}

}  // namespace

class TestDeadlines : public QObject {
    Q_OBJECT

private:
    const std::vector<BlockingCall> calls_ = blockingCalls();

private Q_SLOTS:
    void everyCallReturnsAtItsDeadline_data() {
        QTest::addColumn<int>("which");
        for (std::size_t i = 0; i < calls_.size(); ++i) {
            QTest::newRow(calls_[i].name) << static_cast<int>(i);
        }
    }
    void everyCallReturnsAtItsDeadline() {
        QFETCH(int, which);
        MuteWorld world;
        const auto begun = world.begin();
        QVERIFY2(begun.ok(), why(begun));
        const BlockingCall& call = calls_[static_cast<std::size_t>(which)];
        const Error error = call.run(world, Deadline::after(milliseconds(40)));
        QVERIFY2(error.code == ErrorCode::Timeout, qPrintable(error.toString()));
    }

    void everyCallReturnsWhenCancelled_data() { everyCallReturnsAtItsDeadline_data(); }
    void everyCallReturnsWhenCancelled() {
        QFETCH(int, which);
        MuteWorld world;
        const auto begun = world.begin();
        QVERIFY2(begun.ok(), why(begun));
        const CancelToken token;
        std::thread impatient([&] {
            std::this_thread::sleep_for(milliseconds(20));
            token.cancel();
        });
        const BlockingCall& call = calls_[static_cast<std::size_t>(which)];
        const Error error = call.run(world, Deadline::never(token));
        impatient.join();
        QVERIFY2(error.code == ErrorCode::Cancelled, qPrintable(error.toString()));
    }

    // release() must not wait for the deadline of another call.
    void releasingControlEndsAWaitingCall() {
        RawPeer mute([](RawPeer::Link& link) { link.beMute(); });
        ControllerOptions options;
        options.host = QStringLiteral("127.0.0.1");
        options.primaryPort = mute.port();
        options.rtdePort = mute.port();
        options.priority = 0;
        Controller controller(options);
        Result<void> taken;
        std::atomic<bool> begun{false};
        std::thread taking([&] {
            begun = true;
            taken = controller.takeControl(Deadline::never());
        });
        while (!begun || mute.clients() == 0) {
            std::this_thread::sleep_for(milliseconds(1));
        }
        controller.release();
        taking.join();
        QCOMPARE(taken.error().code, ErrorCode::Cancelled);
    }

    void aMotionContinuesAfterAWaitTimedOut() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        JointPositions target = cell.robot.truth().q;
        target[5] += 10 * kDeg;
        const auto move = Motions(*cell.controller).moveJ(target, {0.5, 1.4, Holding::Free});
        QVERIFY(move.ok());
        QCOMPARE(move->wait(Deadline::after(milliseconds(5))).error().code, ErrorCode::Timeout);
        QVERIFY(move->isActive());
        QVERIFY(cell.during([&] { return move->wait(Deadline::never()); }).ok());
    }

    // 100 disconnections of 0.1 to 10 s of virtual time. Data resume, and control does not resume
    // automatically. At the end, there are as many threads and descriptors as at the start.
    void dataResumeAfterHundredCutsButControlDoesNot() {
        Cell cell;
        receive::ReceiverOptions options;
        options.host = cell.robot.listenAddress();
        options.port = static_cast<std::uint16_t>(cell.robot.ports().rtde);
        const AskedClock clock(cell.clock);
        options.clock = &clock;
        options.priority = 0;
        receive::Receiver receiver(options);  // with the default delays
        receiver.start().value();
        using receive::ReceiverState;
        // Advances time and lets the receiver react.
        const auto pass = [&](int ticks) {
            const ReceiverState state = receiver.state();
            const std::uint64_t packets = receiver.latest().sequence;
            cell.stepAlone(ticks);
            const std::uint64_t asked = clock.asked();
            while (receiver.state() == state && receiver.latest().sequence == packets &&
                   clock.asked() < asked + 2) {
                std::this_thread::sleep_for(std::chrono::microseconds(50));
            }
        };
        // True if data resume within 2 s of robot time. Time spent in the sockets does not count.
        const auto flows = [&] {
            const std::uint64_t before = receiver.latest().sequence;
            cell.stepAlone();  // the robot responds again
            for (int ticks = 0; ticks < 1000;) {
                if (receiver.latest().sequence > before + 5) {
                    return true;
                }
                if (receiver.state() == ReceiverState::Connecting) {
                    cell.robot.drainSockets();
                    std::this_thread::sleep_for(std::chrono::microseconds(200));
                    continue;
                }
                const int step = receiver.state() == ReceiverState::Receiving ? 1 : 10;
                pass(step);
                ticks += step;
            }
            return false;
        };
        QVERIFY(flows());
        QVERIFY(cell.takeControl().ok());
        auto speed = Motions(*cell.controller).startSpeedL({0.5, 0}, Holding::Free);
        Twist up;
        up.linear.z() = 0.02;
        QVERIFY(speed->send(up).ok());
        QVERIFY(cell.stepMs(100));
        const int filesBefore = openFiles();
        const int threadsBefore = threads();
        constexpr int kAtOnce = 50;
        for (int cut = 0; cut < 100; ++cut) {
            const int ticks = 50 + cut * cut / 2;  // 0.1 s ... 10 s
            if (cut % 3 == 0) {
                cell.robot.closeClients();
            }
            cell.robot.silence(true);
            for (int done = 0; done < ticks; done += kAtOnce) {
                cell.clock.advanceNs(kAtOnce * 2 * kNsPerMs);
                cell.robot.step(kAtOnce);
                std::this_thread::sleep_for(milliseconds(1));
            }
            cell.robot.silence(false);
            QVERIFY2(flows(), qPrintable(QStringLiteral("after cut %1").arg(cut)));
            QTRY_VERIFY_WITH_TIMEOUT(!speed->isActive(), 60'000);  // the control thread has detected it
            QCOMPARE(speed->send(up).error().code, ErrorCode::Stopped);
        }
        QVERIFY(cell.isStanding());
        QVERIFY(!cell.controller->status().inControl);
        QTRY_VERIFY_WITH_TIMEOUT(openFiles() <= filesBefore, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(threads() <= threadsBefore, 60'000);
        const auto again = cell.takeControl();
        QVERIFY2(again.ok(), qPrintable(again.error().toString()));
    }
};

QTEST_GUILESS_MAIN(TestDeadlines)
#include "tst_deadlines.moc"
