// SPDX-License-Identifier: MIT
// The cycles of a packet loop go on in step with the robot when packets come late or not at all, for a while.
#include <thread>

#include "robot/control/packet_loop.h"
#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
constexpr std::int64_t kLateNs = 200'000;
constexpr std::int64_t kOverdueNs = 300'000;
constexpr int kSettled = 400;  ///< packages after which the pace is known

/// A packet loop at work, in which the arm stands. Each cycle is noted.
class StandingLoop {
public:
    StandingLoop(Cell& cell, Pacing pacing) : cell_(cell) {
        // The pace is known before the loop begins. Some packages come late: without a margin the test could
        // not say what comes before the next is due.
        for (int packages = 0; packages < kSettled; packages += 10) {
            packetAfter(kPeriodNs + kLateNs);
            packetAfter(kPeriodNs - kLateNs);
            cell_.step(8);
        }
        thread_ = std::thread([this, pacing] {
            const JointPositions here = cell_.robot.truth().q;
            ended = PacketLoop(*cell_.controller, pacing)
                        .servoJ(
                            [&](const CycleState& state) -> std::optional<JointPositions> {
                                cell_.clock.count(std::this_thread::get_id());
                                if (quit_) {
                                    return std::nullopt;
                                }
                                lastTime = state.time;
                                stale = stale + (state.fresh ? 0 : 1);
                                cycles = cycles + 1;
                                return here;
                            },
                            {}, Deadline::never(), &report);
            over_ = true;
        });
        while (!over_ && cycles < 2 && cell_.step()) {
        }
    }
    ~StandingLoop() { end(); }
    StandingLoop(const StandingLoop&) = delete;
    StandingLoop& operator=(const StandingLoop&) = delete;

    /// Asks the loop to end at its next cycle. Where none comes any more the arm is stopped, which ends it too:
    /// a test that has failed must not wait for it for ever.
    void end() {
        if (thread_.joinable()) {
            quit_ = true;
            constexpr int kMost = 100;  // packages; those whose cycles have been run already bring none
            for (int i = 0; i < kMost && !over_ && cell_.step(); ++i) {
            }
            if (!over_) {
                cell_.controller->stop(StopCause::ApiCall);
            }
            thread_.join();
        }
    }

    /// Time goes on, and nothing comes from the robot.
    bool silenceFor(std::int64_t ns) {
        const std::uint64_t inputs = cell_.robot.inputPackages();
        cell_.clock.advanceNs(ns);
        return cell_.robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::seconds(20)));
    }
    /// A packet comes that should have come before; no time goes on.
    bool latePacket() {
        const Cell::Answers before = cell_.answers();
        cell_.robot.step();
        return cell_.waitForAnswer(before);
    }

    bool packetAfter(std::int64_t ns) {
        cell_.clock.advanceNs(ns);
        return latePacket();
    }

    std::atomic<int> cycles{0};
    std::atomic<int> stale{0};
    std::atomic<double> lastTime{0};
    Result<void> ended;
    CycleReport report;

private:
    Cell& cell_;
    std::atomic<bool> quit_{false};
    std::atomic<bool> over_{false};
    std::thread thread_;
};

}  // namespace

class TestPacketPacing : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsSentBetweenTwoPackagesIsNoAnswer() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        auto servo = Motions(*cell.controller).startServoJ();
        QVERIFY(servo.ok());
        const JointPositions here = cell.robot.truth().q;
        for (int i = 0; i < 500; ++i) {
            // It leaves at once, unless the next package is there before.
            QVERIFY(servo->send(here).ok());
            QVERIFY(cell.step());
            QCOMPARE(cell.controller->status().answeredTime, cell.robot.truth().timestamp);
        }
    }

    void everyCycleWaitsForItsMoment() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        QVERIFY(cell.step(20));
        QVERIFY(loop.cycles >= 20);
        // From the first on: late packets are waited for, and it is the last of the wait that is spun away.
        QVERIFY2(cell.clock.shortestNs() > kLateNs, qPrintable(QString::number(cell.clock.shortestNs())));
        QVERIFY2(cell.clock.longestNs() < kOverdueNs, qPrintable(QString::number(cell.clock.longestNs())));
        QCOMPARE(cell.clock.awakeNs(), kWakeUpNs);
    }

    void aLatePacketDelaysNoCycle() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        QCOMPARE(loop.stale, 0);
        const int before = loop.cycles;
        const double time = loop.lastTime;
        QVERIFY(loop.silenceFor(kPeriodNs + kOverdueNs));
        QCOMPARE(loop.cycles, before + 1);
        QCOMPARE(loop.stale, 1);
        QVERIFY(std::abs(loop.lastTime - time - 0.002) < 1e-6);
        // The packet comes after all: it is answered, and its cycle is not run again.
        QVERIFY(loop.latePacket());
        QCOMPARE(loop.cycles, before + 1);
        QVERIFY(loop.packetAfter(kPeriodNs - kOverdueNs));
        QCOMPARE(loop.cycles, before + 2);
        QCOMPARE(loop.stale, 1);
        QVERIFY(std::abs(loop.lastTime - time - 0.004) < 1e-6);
        loop.end();
        QVERIFY2(loop.ended.ok(), qPrintable(loop.ended.error().toString()));
        QCOMPARE(loop.report.stale, 1U);
        QCOMPARE(loop.report.missed, 0U);
        QCOMPARE(loop.report.cycles, static_cast<std::uint64_t>(loop.cycles) + 1);
    }

    void aRobotThatStallsIsNotOutrun() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        const int before = loop.cycles;
        for (int i = 0; i < 5; ++i) {
            QVERIFY(loop.silenceFor(i == 0 ? kPeriodNs + kOverdueNs : kPeriodNs));
        }
        QCOMPARE(loop.cycles, before + 5);
        // Nothing more: the next packet is waited for, and those after it are in time again.
        cell.clock.advanceNs(2 * kPeriodNs - kOverdueNs);
        for (int i = 0; i < 5; ++i) {
            QVERIFY(loop.latePacket());
            QCOMPARE(loop.cycles, before + 5);
        }
        QVERIFY(loop.latePacket());
        QCOMPARE(loop.cycles, before + 6);
        QVERIFY(loop.latePacket());
        QCOMPARE(loop.cycles, before + 7);
        QCOMPARE(loop.stale, 5);
        loop.end();
        QCOMPARE(loop.report.stale, 5U);
    }

    void aStoppedLoopSendsNothingWithoutPackets() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        const int before = loop.cycles;
        const std::uint64_t inputs = cell.robot.inputPackages();
        cell.controller->stop(StopCause::ApiCall);
        // A cycle would be due first; what is sent instead, to idle, may come at either of the two moments.
        cell.clock.advanceNs(kPeriodNs + kOverdueNs);
        cell.clock.advanceNs(5 * kPeriodNs);
        QVERIFY(cell.robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::seconds(20))));
        QCOMPARE(loop.cycles, before);
        loop.end();
        QCOMPARE(loop.ended.error().code, ErrorCode::Stopped);
        QCOMPARE(loop.stale, 0);
    }

    void whoWantsPacketsOnlyWaitsForThem() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::AtOnce);
        QCOMPARE(cell.clock.longestNs(), 0);
        const int before = loop.cycles;
        cell.clock.advanceNs(kPeriodNs + kOverdueNs);
        const std::uint64_t asked = cell.clock.asked();
        QTRY_VERIFY_WITH_TIMEOUT(cell.clock.asked() > asked + 20, 60000);  // the control thread has looked up
        QCOMPARE(loop.cycles, before);
        QVERIFY(loop.latePacket());
        QCOMPARE(loop.cycles, before + 1);
        QCOMPARE(loop.stale, 0);
    }
};

QTEST_GUILESS_MAIN(TestPacketPacing)
#include "tst_packet_pacing.moc"
