// SPDX-License-Identifier: MIT
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "robot/core/clock.h"
#include "robot/realtime/arrival_pace.h"

using tiller::kNsPerMs;
using tiller::realtime::ArrivalPace;

namespace {

constexpr double kPeriod = 0.002;
constexpr double kPeriodNs = kPeriod * 1e9;

/// Times at which the packages are processed.
struct Cycle {
    std::int64_t arrivedNs;
    std::int64_t dueNs;
    std::int64_t heldNs() const { return dueNs - arrivedNs; }
};

/// Sends packages that arrive `delay(i)` [ns] after they were generated.
std::vector<Cycle> follow(ArrivalPace& pace, int packages, const std::function<double(int)>& delay,
                          double drift = 0) {
    std::vector<Cycle> cycles;
    for (int i = 0; i < packages; ++i) {
        const double made = 5e12 + i * kPeriodNs * (1 + drift);
        const auto arrived = static_cast<std::int64_t>(made + delay(i));
        cycles.push_back({arrived, pace.follow(arrived, 777 + i * kPeriod)});
    }
    return cycles;
}

/// Largest deviation of the interval between consecutive packages from one period, starting with cycle
/// `first` [ns].
double unevenness(const std::vector<Cycle>& cycles, std::size_t first) {
    double most = 0;
    for (std::size_t i = std::max<std::size_t>(first, 1); i < cycles.size(); ++i) {
        most =
            std::max(most, std::abs(static_cast<double>(cycles[i].dueNs - cycles[i - 1].dueNs) - kPeriodNs));
    }
    return most;
}

/// Random delays between 0 and `most` [ns], the same in every run.
std::function<double(int)> jitter(double most) {
    return [random = std::mt19937(4711), most](int /*package*/) mutable {
        return most * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
}

}  // namespace

class TestArrivalPace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void unevenArrivalsAreSpacedEvenly() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 5000, jitter(300'000));
        // 0.2 % of a period. The remaining drift comes from the estimates, not from the arrivals.
        QVERIFY2(unevenness(cycles, 1000) < 4'000, qPrintable(QString::number(unevenness(cycles, 1000))));
        // With 0.3 ms of jitter, the mean delay that is required for a constant period is 0.15 ms.
        double held = 0;
        for (const Cycle& cycle : cycles) {
            QVERIFY(cycle.heldNs() >= 0);
            held += static_cast<double>(cycle.heldNs()) / static_cast<double>(cycles.size());
        }
        QVERIFY2(held > 120'000 && held < 250'000, qPrintable(QString::number(held)));
    }

    void evenArrivalsAreHardlyDelayed() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 5000, [](int) { return 0.0; });
        for (std::size_t i = 2000; i < cycles.size(); ++i) {
            QVERIFY(cycles[i].heldNs() < 75'000);
        }
    }

    void noPacketIsDelayedByMoreThanHalfAPeriod() {
        ArrivalPace pace(kPeriod);
        for (const Cycle& cycle : follow(pace, 20'000, jitter(kPeriodNs * 3))) {
            QVERIFY(cycle.heldNs() >= 0);
            QVERIFY(static_cast<double>(cycle.heldNs()) <= kPeriodNs / 2);
        }
    }

    // Clocks of healthy machines differ by at most 100 ppm in either direction.
    void clockDriftIsTracked_data() {
        QTest::addColumn<double>("drift");
        QTest::newRow("fast") << 1e-4;
        QTest::newRow("slow") << -1e-4;
        QTest::newRow("a clock that is being set") << 2e-4;
    }
    void clockDriftIsTracked() {
        QFETCH(double, drift);
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 30'000, jitter(100'000), drift);
        QVERIFY(unevenness(cycles, 1000) < 4'000);
        for (std::size_t i = 1000; i < cycles.size(); ++i) {
            QVERIFY2(cycles[i].heldNs() < 250'000, qPrintable(QString::number(cycles[i].heldNs())));
        }
    }

    void aStallHasNoLastingEffect() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 3000, [](int i) {
            return i >= 2000 && i < 2010 ? (2010 - i) * kPeriodNs : 0.0;  // ten packages at once
        });
        for (std::size_t i = 2000; i < 2010; ++i) {
            QCOMPARE(cycles[i].heldNs(), 0);
        }
        QVERIFY(unevenness(cycles, 2012) < 4'000);
        for (std::size_t i = 2010; i < cycles.size(); ++i) {
            QVERIFY(cycles[i].heldNs() < 350'000);
        }
    }

    void aChangeOfTransitTimeIsTracked_data() {
        QTest::addColumn<double>("longer");
        QTest::newRow("by less than the highest margin") << 300'000.0;
        QTest::newRow("by more than that") << 800'000.0;
        QTest::newRow("by more than a period") << 5'000'000.0;
        QTest::newRow("a shorter one") << -400'000.0;
        QTest::newRow("a much shorter one") << -800'000.0;
    }
    void aChangeOfTransitTimeIsTracked() {
        QFETCH(double, longer);
        ArrivalPace pace(kPeriod);
        const auto shaken = jitter(50'000);
        const auto cycles = follow(pace, 3000, [&](int i) { return shaken(i) + (i >= 1000 ? longer : 0.0); });
        constexpr std::size_t kSoon = 1100;  // 0.2 s later
        for (std::size_t i = kSoon; i < cycles.size(); ++i) {
            QVERIFY2(cycles[i].heldNs() > 0, qPrintable(QString::number(i)));
        }
        QVERIFY2(unevenness(cycles, kSoon) < 4'000, qPrintable(QString::number(unevenness(cycles, kSoon))));
        // After late packages have widened the margin, it takes time to shrink. Regular arrivals are still
        // processed immediately or after a short time.
        const std::int64_t most = longer > 0 && longer < 500'000 ? 500'000 : 250'000;
        QVERIFY2(cycles.back().heldNs() < most, qPrintable(QString::number(cycles.back().heldNs())));
    }

    // If a late consumer attributed the processing time to the network, it would become even later.
    void longProcessingDelaysNoPacket_data() {
        QTest::addColumn<double>("busy");
        QTest::addColumn<double>("drift");
        for (const double busy : {0.5, 0.8, 0.9, 0.96, 0.98, 0.995}) {
            for (const double drift : {0.0, 1e-4, -1e-4}) {
                QTest::addRow("%g of a period, drift %g", busy, drift) << busy << drift;
            }
        }
    }
    void longProcessingDelaysNoPacket() {
        QFETCH(double, busy);
        QFETCH(double, drift);
        constexpr std::int64_t kLooking = 50'000;  // minimum waiting time of the consumer [ns]
        ArrivalPace pace(kPeriod);
        const auto shaken = jitter(300'000);
        std::int64_t ready = 0;
        for (int i = 0; i < 60'000; ++i) {
            const double made = i * kPeriodNs * (1 + drift);
            const auto came = static_cast<std::int64_t>(made + shaken(i));
            const std::int64_t found = std::max(came, ready);
            const std::int64_t begun = pace.follow(found, 777 + i * kPeriod, found - ready > kLooking);
            ready = begun + static_cast<std::int64_t>(busy * kPeriodNs);
            // The lag is bounded by the jitter (0.3 ms) and the delay (0.55 ms), because errors do not
            // accumulate.
            QVERIFY2(static_cast<double>(begun) - made < kPeriodNs / 2,
                     qPrintable(QStringLiteral("%1: %2").arg(i).arg(static_cast<double>(begun) - made)));
        }
    }

    void oneLateEarlyPacketDoesNotDelayTheOthers() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 1000, [](int i) { return i == 200 ? 450'000.0 : 0.0; });
        QVERIFY2(cycles.back().heldNs() < 75'000, qPrintable(QString::number(cycles.back().heldNs())));
    }

    void aConstantTimeStampIsIgnored() {
        ArrivalPace pace(kPeriod);
        for (int i = 0; i < 1000; ++i) {
            const std::int64_t due = pace.follow(kNsPerMs * 2 * i, 200 + (i == 500 ? 499 : i) * kPeriod);
            QVERIFY(i == 500 || due - kNsPerMs * 2 * i < 75'000);
            QCOMPARE(pace.isSettled(), i >= 299);
        }
    }

    void aClockStepRestartsTheEstimate_data() {
        QTest::addColumn<double>("by");
        QTest::newRow("ahead") << 100.0;
        QTest::newRow("back") << -100.0;
    }
    void aClockStepRestartsTheEstimate() {
        QFETCH(double, by);
        ArrivalPace pace(kPeriod);
        for (int i = 0; i < 2000; ++i) {
            const std::int64_t arrived = kNsPerMs * 2 * i;
            const std::int64_t due = pace.follow(arrived, 200 + i * kPeriod + (i >= 1000 ? by : 0.0));
            QVERIFY(due >= arrived && due < arrived + 75'000);
            QCOMPARE(pace.isSettled(), i >= 1000 ? i >= 1299 : i >= 299);
        }
    }

    void lostPackagesDoNotShiftTheOthers() {
        ArrivalPace pace(kPeriod);
        std::int64_t last = 0;
        for (int i = 0; i < 3000; ++i) {
            if (i > 1000 && i % 7 == 0) {
                continue;
            }
            const std::int64_t due = pace.follow(kNsPerMs * 2 * i, i * kPeriod);
            const std::int64_t apart = due - last;
            last = due;
            if (i > 1000) {
                const double off = std::remainder(static_cast<double>(apart), kPeriodNs);
                QVERIFY(std::abs(off) < 4'000);
            }
        }
    }

    void aLateFirstPackageHasNoLastingEffect() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 200, [](int i) { return i == 0 ? 1.5 * kPeriodNs : 0.0; });
        for (std::size_t i = 1; i < cycles.size(); ++i) {
            QVERIFY(static_cast<double>(cycles[i].heldNs()) <= kPeriodNs / 4 + 160'000);
        }
        QVERIFY(unevenness(cycles, 50) < 25'000);
    }
};

QTEST_GUILESS_MAIN(TestArrivalPace)
#include "tst_arrival_pace.moc"
