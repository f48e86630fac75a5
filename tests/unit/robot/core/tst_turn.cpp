// SPDX-License-Identifier: MIT
// The mutex excludes other threads, and waits end at their timeout.
#include <QtTest>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/core/turn.h"

using namespace std::chrono_literals;
using tiller::Turn;

class TestTurn : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onlyOneThreadHoldsTheMutex() {
        Turn turn;
        int inside = 0;  // intentionally not atomic, because the mutex protects it
        int rounds = 0;
        std::atomic<bool> crowded{false};
        const auto work = [&] {
            for (int i = 0; i < 2000; ++i) {
                const std::lock_guard lock(turn);
                crowded = crowded || ++inside != 1;
                ++rounds;
                --inside;
            }
        };
        std::vector<std::thread> workers;
        for (int i = 0; i < 4; ++i) {
            workers.emplace_back(work);
        }
        for (auto& worker : workers) {
            worker.join();
        }
        QVERIFY(!crowded);
        QCOMPARE(rounds, 4 * 2000);
    }

    void lockTimesOut() {
        Turn turn;
        std::unique_lock first(turn);
        bool second = true;
        std::thread([&] { second = std::unique_lock(turn, 5ms).owns_lock(); }).join();
        QVERIFY(!second);
        first.unlock();
        std::thread([&] { second = std::unique_lock(turn, std::try_to_lock).owns_lock(); }).join();
        QVERIFY(second);
    }

    void aWaitingThreadGetsTheMutex() {
        Turn turn;
        std::unique_lock first(turn);
        std::atomic<bool> got{false};
        std::thread second([&] { got = std::unique_lock(turn, 1min).owns_lock(); });
        first.unlock();
        second.join();
        QVERIFY(got);
    }
};

QTEST_APPLESS_MAIN(TestTurn)
#include "tst_turn.moc"
