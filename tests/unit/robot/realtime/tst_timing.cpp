// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/platform/thread_priority.h"
#include "robot/realtime/cpu_latency.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/punctual_wait.h"

using namespace tiller;
using namespace tiller::realtime;
using namespace std::chrono_literals;

class TestTiming : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void emptyHistogramIsAllZero();
    void percentilesAreWithinABucket();
    void extremesAndMeanAreExact();
    void negativeAndHugeValuesAreCounted();
    void valuesAboveAThresholdAreCounted();
    void mergingEqualsAddingAllValues();
    void timerKeepsToItsGrid();
    void timerSkipsMissedPeriods();
    void priorityIsReportedAsGranted();
    void requestingNoPriorityIsNotARefusal();
    void aWaitLearnsTheWakeUpLatency();
    void aWaitDoesNotSpinWhenSpinningCannotHelp();
    void noWaitSpinsOnASingleCpu();
    void aPunctualWaitIsNeverEarlyAndReportsItsCost();
    void aWaitInVirtualTimeReturnsAtOnce();
    void fastWakeUpsAreGrantedOrExplained();
};

void TestTiming::emptyHistogramIsAllZero() {
    const Histogram histogram;
    QCOMPARE(histogram.count(), std::uint64_t(0));
    QCOMPARE(histogram.percentileNs(99), std::int64_t(0));
    QCOMPARE(histogram.maxNs(), std::int64_t(0));
    QCOMPARE(histogram.meanNs(), 0.0);
}

void TestTiming::percentilesAreWithinABucket() {
    std::mt19937 random(3);
    std::lognormal_distribution<double> spread(14, 1.5);
    std::vector<std::int64_t> values;
    Histogram histogram;
    for (int i = 0; i < 20000; ++i) {
        values.push_back(static_cast<std::int64_t>(spread(random)));
        histogram.add(values.back());
    }
    std::sort(values.begin(), values.end());
    for (const double percent : {1.0, 10.0, 50.0, 90.0, 99.0, 99.9, 100.0}) {
        const auto rank = static_cast<std::size_t>(std::ceil(percent / 100 * 20000)) - 1;
        const auto exact = static_cast<double>(values[rank]);
        const auto got = static_cast<double>(histogram.percentileNs(percent));
        QVERIFY2(got >= exact && got <= exact * (1 + 1.0 / 16) + 1, qPrintable(QString::number(percent)));
    }
    QCOMPARE(histogram.percentileNs(100), values.back());
}

void TestTiming::extremesAndMeanAreExact() {
    Histogram histogram;
    for (const std::int64_t ns : {2'000'001, 1'999'999, 2'500'000}) {
        histogram.add(ns);
    }
    QCOMPARE(histogram.minNs(), std::int64_t(1'999'999));
    QCOMPARE(histogram.maxNs(), std::int64_t(2'500'000));
    QCOMPARE(histogram.meanNs(), 6'500'000.0 / 3);
}

void TestTiming::negativeAndHugeValuesAreCounted() {
    Histogram histogram;
    histogram.add(-5);
    QCOMPARE(histogram.percentileNs(100), std::int64_t(0));
    histogram.add(std::numeric_limits<std::int64_t>::max());
    QCOMPARE(histogram.count(), std::uint64_t(2));
    QCOMPARE(histogram.percentileNs(100), std::numeric_limits<std::int64_t>::max());
}

void TestTiming::valuesAboveAThresholdAreCounted() {
    Histogram histogram;
    for (int i = 1; i <= 100; ++i) {
        histogram.add(i * kNsPerMs);
    }
    // Accurate to one bucket (1/16 of the value).
    const auto above = histogram.countAbove(50 * kNsPerMs);
    QVERIFY(above <= 50 && above >= 46);
    QCOMPARE(histogram.countAbove(200 * kNsPerMs), std::uint64_t(0));
    histogram.clear();
    QCOMPARE(histogram.countAbove(0), std::uint64_t(0));
}

void TestTiming::mergingEqualsAddingAllValues() {
    Histogram first;
    Histogram second;
    Histogram both;
    for (int i = 1; i < 1000; ++i) {
        (i % 3 == 0 ? first : second).add(i * 777);
        both.add(i * 777);
    }
    first.merge(second);
    first.merge(Histogram());
    QCOMPARE(first.count(), both.count());
    QCOMPARE(first.minNs(), both.minNs());
    QCOMPARE(first.maxNs(), both.maxNs());
    QCOMPARE(first.meanNs(), both.meanNs());
    QCOMPARE(first.percentileNs(50), both.percentileNs(50));
}

void TestTiming::timerKeepsToItsGrid() {
    const SteadyClock clock;
    const std::int64_t before = clock.nowNs();
    PeriodicTimer timer(2ms);
    std::uint64_t periods = 0;
    for (int i = 0; i < 5; ++i) {
        periods += 1 + timer.wait();
    }
    // No wake-up is early: each wake-up is at or after its grid point. The delay depends on the machine.
    QVERIFY(clock.nowNs() - before >= static_cast<std::int64_t>(periods) * 2 * kNsPerMs);
}

void TestTiming::timerSkipsMissedPeriods() {
    const SteadyClock clock;
    PeriodicTimer timer(1ms);
    timer.wait();
    const std::int64_t until = clock.nowNs() + 10 * kNsPerMs;
    while (clock.nowNs() < until) {
        std::this_thread::yield();
    }
    QVERIFY(timer.wait() >= 9);
}

void TestTiming::priorityIsReportedAsGranted() {
    PriorityReport report;
    // Runs in a separate thread, because the setting would otherwise remain in this thread.
    std::thread([&] {
        nameThread("a name longer than the system keeps");
        report = requestThreadPriority(90);
    }).join();
    QCOMPARE(report.requested, 90);
    QCOMPARE(report.ok(), report.advice.isEmpty());
    QCOMPARE(report.granted, report.ok() ? 90 : 0);
}

void TestTiming::requestingNoPriorityIsNotARefusal() {
    const PriorityReport report = requestThreadPriority(0);
    QVERIFY(report.ok());
    QCOMPARE(report.granted, 0);
    QVERIFY(report.advice.isEmpty());
}

void TestTiming::aWaitLearnsTheWakeUpLatency() {
    // 99 of 100 wake-ups are at most 60 us late. The wait adapts to wake up slightly early, regardless of
    // its initial value.
    std::mt19937 random(7);
    std::uniform_int_distribution<std::int64_t> usual(10'000, 60'000);
    PunctualWait wait(true);
    int later = 0;
    constexpr int kSettles = 4000;
    constexpr int kLooks = 20'000;
    for (int i = 0; i < kSettles + kLooks; ++i) {
        const std::int64_t late = i % 200 == 0 ? 250'000 : usual(random);
        later += i >= kSettles && late > wait.awakeNs() ? 1 : 0;
        wait.learn(late);
    }
    QVERIFY2(wait.awakeNs() > 40'000 && wait.awakeNs() < 120'000,
             qPrintable(QString::number(wait.awakeNs())));
    QVERIFY2(later < kLooks / 50, qPrintable(QString::number(later)));
}

void TestTiming::aWaitDoesNotSpinWhenSpinningCannotHelp() {
    PunctualWait wait(true);
    for (int i = 0; i < 1000; ++i) {
        wait.learn(2'000'000);
        QVERIFY(wait.awakeNs() <= PunctualWait::kMaxAwakeNs);
    }
    QCOMPARE(wait.awakeNs(), std::int64_t(0));
    for (int i = 0; i < 1000; ++i) {
        wait.learn(20'000);  // the cause of the delays has ended
    }
    QVERIFY(wait.awakeNs() > 0);
}

void TestTiming::noWaitSpinsOnASingleCpu() {
    PunctualWait wait(false);
    wait.learn(100'000);
    QCOMPARE(wait.awakeNs(), std::int64_t(0));
    const Clock& clock = SteadyClock::shared();
    wait.until(clock, clock.nowNs() + kNsPerMs);
    QCOMPARE(wait.spentNs(), std::int64_t(0));
}

void TestTiming::aPunctualWaitIsNeverEarlyAndReportsItsCost() {
    const Clock& clock = SteadyClock::shared();
    PunctualWait wait(true);
    std::int64_t due = clock.nowNs();
    for (int i = 0; i < 20; ++i) {
        due += 2 * kNsPerMs;
        wait.until(clock, due);
        QVERIFY(clock.nowNs() >= due);
    }
    QVERIFY(wait.spentNs() >= 0);
    const std::int64_t spent = wait.spentNs();
    wait.until(clock, clock.nowNs() - 1);  // already in the past
    QCOMPARE(wait.spentNs(), spent);
}

void TestTiming::aWaitInVirtualTimeReturnsAtOnce() {
    VirtualClock clock;
    PunctualWait wait(true);
    const std::int64_t awake = wait.awakeNs();
    wait.until(clock, clock.nowNs() + 1000 * kNsPerSecond);
    QCOMPARE(wait.awakeNs(), awake);
}

void TestTiming::fastWakeUpsAreGrantedOrExplained() {
    const CpuLatency one;
    const CpuLatency two;
    QCOMPARE(one.isGranted(), two.isGranted());
    QCOMPARE(one.isGranted(), CpuLatency::advice().isEmpty());
}

QTEST_GUILESS_MAIN(TestTiming)
#include "tst_timing.moc"
