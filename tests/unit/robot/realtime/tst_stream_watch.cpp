// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>

#include "robot/core/clock.h"
#include "robot/realtime/stream_watch.h"

using namespace tiller;
using tiller::realtime::StreamWatch;

class TestStreamWatch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void evenStreamIsNeitherLateNorLossy();
    void skippedPackagesAreCounted();
    void lateIsMoreThanHalfAPeriod();
    void burstAfterAStallCountsEachLatePackage();
    void driftOfTheClocksIsNotLateness();
    void aBacklogIsDatedByItsWaitingTime();
    void aLongerTransitTimeBecomesTheReference();
    void aControllerRestartIsNotAGap();
    void interruptionIsAGapInTimeStamps();
    void nothingIsReportedWithoutTimeStamps();
    void slowerStreamsUseTheirOwnPeriod();
};

void TestStreamWatch::evenStreamIsNeitherLateNorLossy() {
    StreamWatch watch;
    watch.begin(0.002);
    for (int i = 0; i < 1000; ++i) {
        const auto verdict = watch.add(100 + i * 0.002, i * 2 * kNsPerMs);
        QCOMPARE(verdict.lost, std::uint64_t(0));
        QVERIFY(!verdict.late);
        QVERIFY(std::llabs(verdict.jitterNs) < 1000);
    }
}

void TestStreamWatch::skippedPackagesAreCounted() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(1.000, 0);
    QCOMPARE(watch.add(1.002, 2 * kNsPerMs).lost, std::uint64_t(0));
    const auto verdict = watch.add(1.010, 10 * kNsPerMs);
    QCOMPARE(verdict.lost, std::uint64_t(3));
    QVERIFY(!verdict.late);
    QCOMPARE(watch.add(1.012, 12 * kNsPerMs).lost, std::uint64_t(0));
}

void TestStreamWatch::lateIsMoreThanHalfAPeriod() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(1.000, 0);
    QVERIFY(!watch.add(1.002, 2'900'000).late);
    QVERIFY(watch.add(1.004, 5'100'000).late);
    QVERIFY(!watch.add(1.006, 6'000'000).late);
}

void TestStreamWatch::burstAfterAStallCountsEachLatePackage() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(1.000, 0);
    // The host was suspended for 10 ms and then received five packages at the same time.
    int late = 0;
    for (int i = 1; i <= 5; ++i) {
        late += watch.add(1.0 + i * 0.002, 10 * kNsPerMs).late ? 1 : 0;
    }
    QCOMPARE(late, 4);
    QVERIFY(!watch.add(1.012, 12 * kNsPerMs).late);
}

void TestStreamWatch::driftOfTheClocksIsNotLateness() {
    StreamWatch watch;
    watch.begin(0.002);
    for (int i = 0; i < 500 * 60; ++i) {
        // The host's clock is 200 ppm too fast.
        const auto host = static_cast<std::int64_t>(i * 2e6 * 1.0002);
        QVERIFY(!watch.add(i * 0.002 + 1, host).late);
    }
}

void TestStreamWatch::aBacklogIsDatedByItsWaitingTime() {
    StreamWatch watch;
    watch.begin(0.002);
    for (int i = 0; i < 100; ++i) {
        watch.add(1 + i * 0.002, i * 2 * kNsPerMs);
    }
    // No packages for 2 s, then all packages within 0.4 s.
    const std::int64_t end = 198 * kNsPerMs + 2 * kNsPerSecond;
    for (int i = 0; i < 1000; ++i) {
        const std::int64_t host = end + i * 400'000;
        const std::int64_t sent = (100 + i) * 2 * kNsPerMs;
        const auto verdict = watch.add(1 + (100 + i) * 0.002, host);
        QVERIFY(std::llabs(verdict.jitterNs - (host - sent)) < 2 * kNsPerMs);
    }
}

// A simulated robot was delayed, or the network route has changed. Reporting lateness permanently would not
// be useful.
void TestStreamWatch::aLongerTransitTimeBecomesTheReference() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(1, 0);
    constexpr std::int64_t kHeldUp = 200 * kNsPerMs;
    QVERIFY(watch.add(1.002, 2 * kNsPerMs + kHeldUp).jitterNs > 190 * kNsPerMs);
    for (int i = 2; i < 490; ++i) {
        QVERIFY(watch.add(1 + i * 0.002, i * 2 * kNsPerMs + kHeldUp).jitterNs > 190 * kNsPerMs);
    }
    for (int i = 490; i < 510; ++i) {
        watch.add(1 + i * 0.002, i * 2 * kNsPerMs + kHeldUp);
    }
    QVERIFY(watch.add(2.02, 1020 * kNsPerMs + kHeldUp).jitterNs < kNsPerMs);
    QVERIFY(!watch.add(2.022, 1022 * kNsPerMs + kHeldUp).late);
}

void TestStreamWatch::aControllerRestartIsNotAGap() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(5000.0, 0);
    const auto verdict = watch.add(0.002, 30 * kNsPerSecond);
    QCOMPARE(verdict.lost, std::uint64_t(0));
    QVERIFY(!verdict.late);
    QVERIFY(!watch.add(0.004, 30 * kNsPerSecond + 2 * kNsPerMs).late);
    // A repeated timestamp does not count as a lost packet.
    QCOMPARE(watch.add(0.004, 30 * kNsPerSecond + 2 * kNsPerMs).lost, std::uint64_t(0));
}

void TestStreamWatch::interruptionIsAGapInTimeStamps() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(10.0, 0);
    watch.begin(0.002);
    const auto verdict = watch.add(11.0, kNsPerSecond + 300 * kNsPerMs);
    QCOMPARE(verdict.lost, std::uint64_t(499));
    QVERIFY(!verdict.late);
}

void TestStreamWatch::nothingIsReportedWithoutTimeStamps() {
    StreamWatch watch;
    watch.begin(0.002);
    watch.add(std::nan(""), 0);
    const auto verdict = watch.add(std::nan(""), kNsPerSecond);
    QCOMPARE(verdict.lost, std::uint64_t(0));
    QVERIFY(!verdict.late);
}

void TestStreamWatch::slowerStreamsUseTheirOwnPeriod() {
    StreamWatch watch;
    watch.begin(0.008);
    watch.add(1.0, 0);
    QCOMPARE(watch.add(1.008, 11 * kNsPerMs).lost, std::uint64_t(0));
    QVERIFY(!watch.add(1.016, 19 * kNsPerMs).late);
    QVERIFY(watch.add(1.024, 29 * kNsPerMs).late);
}

QTEST_GUILESS_MAIN(TestStreamWatch)
#include "tst_stream_watch.moc"
