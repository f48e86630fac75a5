// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/thread_priority.h"

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
    void countAboveAThreshold();
    void mergedIsTheSameAsAddedTogether();
    void timerKeepsToItsGrid();
    void timerSkipsWhatWasMissed();
    void priorityIsReportedAsGranted();
    void noWishIsNoRefusal();
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

void TestTiming::countAboveAThreshold() {
    Histogram histogram;
    for (int i = 1; i <= 100; ++i) {
        histogram.add(i * kNsPerMs);
    }
    // To the accuracy of a bucket, a sixteenth.
    const auto above = histogram.countAbove(50 * kNsPerMs);
    QVERIFY(above <= 50 && above >= 46);
    QCOMPARE(histogram.countAbove(200 * kNsPerMs), std::uint64_t(0));
    histogram.clear();
    QCOMPARE(histogram.countAbove(0), std::uint64_t(0));
}

void TestTiming::mergedIsTheSameAsAddedTogether() {
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
    // Never early: each wake lies at or after its place on the grid. How late it is is the machine's affair.
    QVERIFY(clock.nowNs() - before >= static_cast<std::int64_t>(periods) * 2 * kNsPerMs);
}

void TestTiming::timerSkipsWhatWasMissed() {
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
    // In a thread of its own: it would stay with this one.
    std::thread([&] {
        nameThread("a name longer than the system keeps");
        report = requestThreadPriority(90);
    }).join();
    QCOMPARE(report.requested, 90);
    QCOMPARE(report.ok(), report.advice.isEmpty());
    QCOMPARE(report.granted, report.ok() ? 90 : 0);
}

void TestTiming::noWishIsNoRefusal() {
    const PriorityReport report = requestThreadPriority(0);
    QVERIFY(report.ok());
    QCOMPARE(report.granted, 0);
    QVERIFY(report.advice.isEmpty());
}

QTEST_GUILESS_MAIN(TestTiming)
#include "tst_timing.moc"
