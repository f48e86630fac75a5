// SPDX-License-Identifier: MIT
// The cycles of a packet loop stay synchronized with the robot when packets are late or missing for some
// time.
#include <QRegularExpression>
#include <functional>
#include <semaphore>
#include <thread>
#include <vector>

#include "robot/control/packet_loop.h"
#include "tests/integration/control/cell.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
constexpr std::int64_t kLateNs = 200'000;
constexpr std::int64_t kOverdueNs = 300'000;
constexpr int kSettled = 400;  ///< number of packages after which the packet timing is known

/// An active packet loop with the arm at standstill. It records each cycle.
class StandingLoop {
public:
    StandingLoop(Cell& cell, Pacing pacing) : cell_(cell) {
        // The packet timing must be known before the loop starts. Some packets are late, so that there is a
        // margin. Without a margin, a cycle before the next due packet could not be identified.
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

    /// Requests the end of the loop at its next cycle. If there are no more cycles, the arm is stopped, which
    /// also ends the loop. Otherwise, a failed test would wait forever.
    void end() {
        if (thread_.joinable()) {
            quit_ = true;
            constexpr int kMaxValue = 100;  // packets; a packet whose cycle has already run starts no cycle
            for (int i = 0; i < kMaxValue && !over_ && cell_.step(); ++i) {
            }
            if (!over_) {
                cell_.controller->stop(StopCause::ApiCall);
            }
            thread_.join();
        }
    }

    /// Advances time without a packet from the robot.
    bool silenceFor(std::int64_t ns) {
        const std::uint64_t inputs = cell_.robot.inputPackages();
        cell_.clock.advanceNs(ns);
        return cell_.robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::seconds(20)));
    }
    /// Delivers an overdue packet without advancing time.
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

/// A packet loop whose callback blocks until the test permits it to return. The arm is at standstill.
class SlowLoop {
public:
    SlowLoop(Cell& cell, std::function<void(const CycleState&)> note) : cell_(cell), note_(std::move(note)) {
        thread_ = std::thread([this] {
            const JointPositions here = cell_.robot.truth().q;
            ended = PacketLoop(*cell_.controller, Pacing::AtOnce)
                        .servoJ(
                            [&](const CycleState& state) -> std::optional<JointPositions> {
                                note_(state);
                                begun_.release();
                                permitted_.acquire();
                                return quit_ ? std::nullopt : std::optional(here);
                            },
                            {}, Deadline::never(), &report);
            over_ = true;
        });
        cell_.stepAlone();  // the packet of the first call
    }
    ~SlowLoop() { end(); }
    SlowLoop(const SlowLoop&) = delete;
    SlowLoop& operator=(const SlowLoop&) = delete;

    /// Waits until the next call has begun. Sends packets only while waiting for the first call.
    bool waitForCall() {
        constexpr int kAttempts = 2000;
        for (int i = 0; i < kAttempts && !over_; ++i) {
            if (begun_.try_acquire_for(std::chrono::milliseconds(10))) {
                ++calls_;
                return true;
            }
            if (calls_ == 0) {
                cell_.stepAlone();
            }
        }
        return false;
    }
    void permit() { permitted_.release(); }
    /// Lets the current call and all following calls return until the loop has ended.
    void letEnd() {
        constexpr std::ptrdiff_t kAll = 1000;
        permitted_.release(kAll);
        while (!over_ && cell_.step()) {
        }
        thread_.join();
    }
    /// Requests the end of the loop from the callback, then waits as letEnd() does.
    void end() {
        if (thread_.joinable()) {
            quit_ = true;
            letEnd();
        }
    }

    Result<void> ended;
    CycleReport report;

private:
    Cell& cell_;
    std::function<void(const CycleState&)> note_;
    std::counting_semaphore<> begun_{0};
    std::counting_semaphore<> permitted_{0};
    int calls_ = 0;
    std::atomic<bool> quit_{false};
    std::atomic<bool> over_{false};
    std::thread thread_;
};

}  // namespace

class TestPacketPacing : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void setpointsBetweenPackagesAreNotCountedAsReplies() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        auto servo = Motions(*cell.controller).startServoJ();
        QVERIFY(servo.ok());
        const JointPositions here = cell.robot.truth().q;
        for (int i = 0; i < 500; ++i) {
            // The setpoint is sent immediately unless the next packet arrives first.
            QVERIFY(servo->send(here).ok());
            QVERIFY(cell.step());
            QCOMPARE(cell.controller->status().answeredTime, cell.robot.truth().timestamp);
        }
    }

    void everyCycleStartsAtItsScheduledTime() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        QVERIFY(cell.step(20));
        QVERIFY(loop.cycles >= 20);
        // From the first cycle on, the loop waits for late packets. Only the last part of the wait is spent
        // spinning.
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
        // The late packet arrives and is answered, but its cycle is not run again.
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

    void cyclesStopWhileTheRobotStalls() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::Even);
        const int before = loop.cycles;
        for (int i = 0; i < 5; ++i) {
            QVERIFY(loop.silenceFor(i == 0 ? kPeriodNs + kOverdueNs : kPeriodNs));
        }
        QCOMPARE(loop.cycles, before + 5);
        // There are no more extra cycles. The loop waits for the next packet, and the packets after it are on
        // time again.
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
        // The stop has cancelled the cycle that would be due at the first of these times. The loop sends only
        // an idle command, at the first or the second time.
        cell.clock.advanceNs(kPeriodNs + kOverdueNs);
        cell.clock.advanceNs(5 * kPeriodNs);
        QVERIFY(cell.robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::seconds(20))));
        QCOMPARE(loop.cycles, before);
        loop.end();
        QCOMPARE(loop.ended.error().code, ErrorCode::Stopped);
        QCOMPARE(loop.stale, 0);
    }

    // Packets queue up while a callback is running. Processing them one by one would never catch up.
    void aSlowCallbackGetsTheNewestPacket() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.step(10));
        // The periods of all rounds together are longer than the robot's heartbeat timeout.
        constexpr std::size_t kRounds = 13;
        constexpr int kPeriods = 10;
        std::vector<CycleState> seen;
        SlowLoop loop(cell, [&](const CycleState& state) { seen.push_back(state); });
        for (std::size_t round = 0; round < kRounds; ++round) {
            QVERIFY(loop.waitForCall());
            cell.stepAlone(kPeriods);
            loop.permit();
        }
        QVERIFY(loop.waitForCall());
        loop.end();
        QVERIFY2(loop.ended.ok(), qPrintable(loop.ended.error().toString()));
        QCOMPARE(seen.size(), kRounds + 1);
        // Start at 2, because several packets may arrive before the first call.
        for (std::size_t i = 2; i < seen.size(); ++i) {
            QVERIFY2(std::abs(seen[i].time - seen[i - 1].time - kPeriods * 0.002) < 1e-6,
                     qPrintable(QStringLiteral("%1 s after %2 s").arg(seen[i].time).arg(seen[i - 1].time)));
            QVERIFY(seen[i].fresh);
            QVERIFY(seen[i].age < 0.001);
            QCOMPARE(seen[i].missed - seen[i - 1].missed, static_cast<std::uint64_t>(kPeriods) - 1);
        }
        QCOMPARE(loop.report.missed, seen.back().missed);
        QCOMPARE(loop.report.overruns, kRounds);
    }

    // A packet with a long transit time has just arrived, so its data are old.
    void aPacketWithALongTransitTimeIsNotFresh() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.step(10));
        std::vector<CycleState> seen;
        SlowLoop loop(cell, [&](const CycleState& state) { seen.push_back(state); });
        QVERIFY(loop.waitForCall());
        cell.clock.advanceNs(20 * kNsPerMs);
        cell.stepAlone();
        loop.permit();
        QVERIFY(loop.waitForCall());
        loop.end();
        QCOMPARE(seen.size(), 2U);
        QVERIFY(seen[0].fresh);
        QVERIFY(!seen[1].fresh);
        QVERIFY2(std::abs(seen[1].age - 0.020) < 1e-6, qPrintable(QString::number(seen[1].age)));
    }

    void aHangingCallbackIsReportedWithItsDuration() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.step(10));
        SlowLoop loop(cell, [](const CycleState&) {});
        for (int quick = 0; quick < 3; ++quick) {
            QVERIFY(loop.waitForCall());
            cell.stepAlone();
            loop.permit();
        }
        QVERIFY(loop.waitForCall());
        cell.stepAlone(60);
        loop.letEnd();
        QCOMPARE(loop.ended.error().code, ErrorCode::Stopped);
        const QString why = loop.ended.error().controllerMessage;
        const auto match =
            QRegularExpression(
                QStringLiteral("call of the callback took (\\d+)\\.\\d ms.* period of 2 ms.* \\d+ "
                               "of \\d+ calls took longer than a period"))
                .match(why);
        QVERIFY2(match.hasMatch(), qPrintable(why));
        const int tookMs = match.captured(1).toInt();
        QVERIFY2(tookMs >= 120 && tookMs < 130, qPrintable(why));
        QVERIFY(cell.controller->status().inControl);
        QVERIFY(cell.ticksToStandstill(250) >= 0);
    }

    // The thread that waits for the end of the loop may be scheduled late.
    void aHangingCallbackIsReportedWhenTheLoopEndsLate() {
        Cell cell;
        QVERIFY(cell.takeControl().ok());
        QVERIFY(cell.step(10));
        SlowLoop loop(cell, [](const CycleState&) {});
        QVERIFY(loop.waitForCall());
        cell.stepAlone();
        loop.permit();
        QVERIFY(loop.waitForCall());
        QVERIFY(cell.controller->status().motion != kNoMotion);
        cell.stepAlone(60);
        loop.permit();
        while (cell.controller->status().motion != kNoMotion) {
            std::this_thread::yield();
        }
        cell.clock.advanceNs(kNsPerSecond);
        loop.letEnd();
        QVERIFY2(loop.ended.error().controllerMessage.contains("one call of the callback took 120.0 ms"),
                 qPrintable(loop.ended.error().toString()));
    }

    void packetsOnlyModeWaitsForPackets() {
        Cell cell;
        cell.clock.pretendToRun();
        QVERIFY(cell.takeControl().ok());
        StandingLoop loop(cell, Pacing::AtOnce);
        QCOMPARE(cell.clock.longestNs(), 0);
        const int before = loop.cycles;
        cell.clock.advanceNs(kPeriodNs + kOverdueNs);
        const std::uint64_t asked = cell.clock.asked();
        // Wait until the control thread has polled.
        QTRY_VERIFY_WITH_TIMEOUT(cell.clock.asked() > asked + 20, 60000);
        QCOMPARE(loop.cycles, before);
        QVERIFY(loop.latePacket());
        QCOMPARE(loop.cycles, before + 1);
        QCOMPARE(loop.stale, 0);
    }
};

QTEST_GUILESS_MAIN(TestPacketPacing)
#include "tst_packet_pacing.moc"
