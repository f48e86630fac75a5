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

/// What is worked on when.
struct Cycle {
    std::int64_t arrivedNs;
    std::int64_t dueNs;
    std::int64_t heldNs() const { return dueNs - arrivedNs; }
};

/// Sends packages that come `delay(i)` [ns] after they were made.
std::vector<Cycle> follow(ArrivalPace& pace, int packages, const std::function<double(int)>& delay,
                          double drift = 0) {
    std::vector<Cycle> cycles;
    for (int i = 0; i < packages; ++i) {
        const double made = 5e12 + i * kPeriodNs * (1 + drift);
        const auto arrived = static_cast<std::int64_t>(made + delay(i));
        cycles.push_back({arrived, pace.due(arrived, 777 + i * kPeriod)});
    }
    return cycles;
}

/// Furthest that neighbours from `first` on are from a period apart [ns].
double unevenness(const std::vector<Cycle>& cycles, std::size_t first) {
    double most = 0;
    for (std::size_t i = std::max<std::size_t>(first, 1); i < cycles.size(); ++i) {
        most =
            std::max(most, std::abs(static_cast<double>(cycles[i].dueNs - cycles[i - 1].dueNs) - kPeriodNs));
    }
    return most;
}

/// Between nothing and `most` [ns], the same in every run.
std::function<double(int)> jitter(double most) {
    return [random = std::mt19937(4711), most](int /*package*/) mutable {
        return most * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
}

}  // namespace

class TestArrivalPace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void unevenArrivalsAreLaidOutEvenly() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 5000, jitter(300'000));
        QVERIFY2(unevenness(cycles, 1000) < 25'000, qPrintable(QString::number(unevenness(cycles, 1000))));
        // No more than the jitter asks for: on the average half of it.
        double held = 0;
        for (const Cycle& cycle : cycles) {
            QVERIFY(cycle.heldNs() >= 0);
            held += static_cast<double>(cycle.heldNs()) / static_cast<double>(cycles.size());
        }
        QVERIFY2(held > 120'000 && held < 250'000, qPrintable(QString::number(held)));
    }

    void whatComesEvenlyIsHardlyHeld() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 5000, [](int) { return 0.0; });
        for (std::size_t i = 2000; i < cycles.size(); ++i) {
            QVERIFY(cycles[i].heldNs() < 75'000);
        }
    }

    void noneIsHeldForMoreThanHalfAPeriod() {
        ArrivalPace pace(kPeriod);
        for (const Cycle& cycle : follow(pace, 20'000, jitter(kPeriodNs * 3))) {
            QVERIFY(cycle.heldNs() >= 0);
            QVERIFY(static_cast<double>(cycle.heldNs()) <= kPeriodNs / 2);
        }
    }

    // Clocks differ: by 100 ppm either way at most in any machine that is well.
    void theOtherClockIsFollowed_data() {
        QTest::addColumn<double>("drift");
        QTest::newRow("fast") << 1e-4;
        QTest::newRow("slow") << -1e-4;
        QTest::newRow("a clock that is being set") << 2e-4;
    }
    void theOtherClockIsFollowed() {
        QFETCH(double, drift);
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 30'000, jitter(100'000), drift);
        QVERIFY(unevenness(cycles, 1000) < 25'000);
        for (std::size_t i = 1000; i < cycles.size(); ++i) {
            QVERIFY2(cycles[i].heldNs() < 250'000, qPrintable(QString::number(cycles[i].heldNs())));
        }
    }

    void aStallChangesNothingAfterIt() {
        ArrivalPace pace(kPeriod);
        const auto cycles = follow(pace, 3000, [](int i) {
            return i >= 2000 && i < 2010 ? (2010 - i) * kPeriodNs : 0.0;  // ten packages at once
        });
        for (std::size_t i = 2000; i < 2010; ++i) {
            QCOMPARE(cycles[i].heldNs(), 0);
        }
        QVERIFY(unevenness(cycles, 2012) < 25'000);
        for (std::size_t i = 2010; i < cycles.size(); ++i) {
            QVERIFY(cycles[i].heldNs() < 350'000);
        }
    }

    void lostPackagesLeaveTheOthersInTheirPlace() {
        ArrivalPace pace(kPeriod);
        std::int64_t last = 0;
        for (int i = 0; i < 3000; ++i) {
            if (i > 1000 && i % 7 == 0) {
                continue;
            }
            const std::int64_t due = pace.due(kNsPerMs * 2 * i, i * kPeriod);
            const std::int64_t apart = due - last;
            last = due;
            if (i > 1000) {
                const double off = std::remainder(static_cast<double>(apart), kPeriodNs);
                QVERIFY(std::abs(off) < 25'000);
            }
        }
    }

    void aLateFirstPackageIsForgotten() {
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
