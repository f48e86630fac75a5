// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <chrono>
#include <vector>

#include "robot/platform/sleep.h"
#include "robot/platform/thread_priority.h"

using namespace tiller;

class TestSleep : public QObject {
    Q_OBJECT

    static std::int64_t now() {
        return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

private Q_SLOTS:
    // The control loop sleeps almost to the end of its period of 2 ms.
    void isNeverEarlyAndSeldomLate() {
        constexpr std::int64_t kPeriod = 2'000'000;
        std::vector<std::int64_t> late;
        for (int n = 0; n < 200; ++n) {
            const std::int64_t until = now() + kPeriod;
            sleepUntilNs(until);
            late.push_back(now() - until);
        }
        std::sort(late.begin(), late.end());
        QVERIFY(late.front() >= 0);
        qInfo("late: median %lld us", static_cast<long long>(late[late.size() / 2] / 1000));
        // The default timer of Windows would be 13 ms late.
        QVERIFY(late[late.size() / 2] < 10'000'000);
    }

    void aPastTimeReturnsAtOnce() {
        const std::int64_t begin = now();
        sleepUntilNs(begin - 1'000'000'000);
        QVERIFY(now() - begin < 1'000'000'000);
    }

    void countsProcessorTime() {
        const double before = realtime::threadSeconds();
        const std::int64_t begin = now();
        while (realtime::threadSeconds() - before < 0.02 && now() - begin < 60'000'000'000) {
        }
        QVERIFY(realtime::threadSeconds() - before >= 0.02);
    }
};

QTEST_GUILESS_MAIN(TestSleep)
#include "tst_sleep.moc"
