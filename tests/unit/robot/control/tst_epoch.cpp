// SPDX-License-Identifier: MIT
#include <QTest>
#include <atomic>
#include <thread>
#include <vector>

#include "robot/control/detail/epoch.h"

using namespace tiller::control;

class TestEpoch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aMotionIsActiveFromStartToEnd() {
        Epoch epoch;
        QCOMPARE(epoch.activeMotion(), kNoMotion);
        const MotionId motion = epoch.beginMotion(10);
        QVERIFY(epoch.isActive(motion));
        QCOMPARE(epoch.state(motion).phase, MotionPhase::Active);
        QVERIFY(epoch.end(motion, StopCause::Released, 20));
        QVERIFY(!epoch.isActive(motion));
        QCOMPARE(epoch.state(motion).phase, MotionPhase::Ended);
        QCOMPARE(epoch.state(motion).cause, StopCause::Released);
        QCOMPARE(epoch.endedNs(motion), 20);
    }

    void everyStopAdvancesTheEpochEvenWithoutMotion() {
        Epoch epoch;
        const std::uint64_t before = epoch.current();
        epoch.stop(StopCause::Escape, 0);
        epoch.stop(StopCause::Escape, 0);
        QCOMPARE(epoch.current(), before + 2);
    }

    void aNewMotionSupersedesThePreviousOne() {
        Epoch epoch;
        const MotionId first = epoch.beginMotion(0);
        const MotionId second = epoch.beginMotion(0);
        QVERIFY(second > first);
        QCOMPARE(epoch.state(first).cause, StopCause::Superseded);
        QVERIFY(epoch.isActive(second));
    }

    void endingAnEndedMotionChangesNothing() {
        Epoch epoch;
        const MotionId first = epoch.beginMotion(0);
        epoch.stop(StopCause::Space, 0);
        const MotionId second = epoch.beginMotion(0);
        QVERIFY(!epoch.end(first, StopCause::Released, 0));
        QVERIFY(epoch.isActive(second));
        QCOMPARE(epoch.state(first).cause, StopCause::Space);
    }

    void stopCausesAreKept() {
        Epoch epoch;
        std::vector<std::pair<MotionId, StopCause>> ended;
        for (int i = 0; i < 100; ++i) {
            const MotionId motion = epoch.beginMotion(i);
            const auto cause = i % 2 == 0 ? StopCause::Released : StopCause::FocusLost;
            epoch.end(motion, cause, i);
            ended.emplace_back(motion, cause);
        }
        for (const auto& [motion, cause] : ended) {
            QCOMPARE(epoch.state(motion).cause, cause);
        }
    }

    void unknownMotionIdsCountAsEnded() {
        const Epoch epoch;
        QCOMPARE(epoch.state(12345).phase, MotionPhase::Ended);
        QCOMPARE(epoch.state(kNoMotion).phase, MotionPhase::Ended);
        QVERIFY(!epoch.isActive(kNoMotion));
    }

    // Every stop of every thread must count. Lost updates would result in a smaller epoch.
    void noStopIsLostUnderContention() {
        Epoch epoch;
        const std::uint64_t before = epoch.current();
        constexpr int kThreads = 8;
        constexpr int kStops = 20000;
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t) {
            threads.emplace_back([&] {
                for (int i = 0; i < kStops; ++i) {
                    epoch.stop(StopCause::ApiCall, i);
                }
            });
        }
        for (auto& thread : threads) {
            thread.join();
        }
        QCOMPARE(epoch.current(), before + kThreads * kStops);
    }

    // Many threads try to end each motion. Exactly one of them succeeds, and its cause is stored.
    void exactlyOneThreadEndsAMotion() {
        Epoch epoch;
        constexpr int kThreads = 4;
        for (int round = 0; round < 200; ++round) {
            const MotionId motion = epoch.beginMotion(0);
            std::atomic<int> winners{0};
            std::atomic<int> winningCause{0};
            std::vector<std::thread> threads;
            for (int t = 0; t < kThreads; ++t) {
                threads.emplace_back([&, t] {
                    const auto cause = static_cast<StopCause>(static_cast<int>(StopCause::Released) + t);
                    if (epoch.end(motion, cause, 0)) {
                        ++winners;
                        winningCause = static_cast<int>(cause);
                    }
                });
            }
            for (auto& thread : threads) {
                thread.join();
            }
            QCOMPARE(winners.load(), 1);
            QCOMPARE(static_cast<int>(epoch.state(motion).cause), winningCause.load());
        }
    }
};

QTEST_GUILESS_MAIN(TestEpoch)
#include "tst_epoch.moc"
