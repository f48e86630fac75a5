// SPDX-License-Identifier: MIT
#include <QTest>

#include "robot/control/stop_meter.h"
#include "robot/core/clock.h"

using namespace tiller;
using namespace tiller::control;

namespace {

constexpr std::int64_t kStepNs = 2 * kNsPerMs;

// An arm that moves along X and starts to decelerate.
struct Braking {
    StopMeter& meter;
    std::int64_t now = 0;
    double x = 0;
    double speed = 0;

    bool step(double deceleration) {
        now += kStepNs;
        const double dt = 0.002;
        const double next = std::max(0.0, speed - deceleration * dt);
        x += 0.5 * (speed + next) * dt;
        speed = next;
        return meter.add({now, {x, 0, 0}, speed, 2 * speed});
    }
};

}  // namespace

class TestStopMeter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void measuresTimeAndDistanceOfAStop() {
        StopMeter meter;
        Braking arm{meter, 0, 0, 0.1};
        for (int i = 0; i < 10; ++i) {
            arm.step(0);
        }
        QVERIFY(meter.isMoving());
        const double startedAt = arm.x;
        meter.begin(StopCause::Released, arm.now);
        int steps = 0;
        while (!arm.step(2.0)) {
            QVERIFY(++steps < 1000);
        }
        QVERIFY(!meter.isMoving());
        QCOMPARE(meter.last().count, 1U);
        QCOMPARE(meter.last().cause, StopCause::Released);
        // 0.1 m/s at 2 m/s2: 50 ms and 2.5 mm. Speeds below 1 mm/s count as standstill.
        QVERIFY(std::abs(meter.last().durationMs - 50) <= 2);
        QVERIFY(std::abs(meter.last().distanceMm - (arm.x - startedAt) * 1000) < 0.01);
    }

    void oneSampleWithoutMotionIsNotYetStandstill() {
        StopMeter meter;
        meter.begin(StopCause::Space, 0);
        QVERIFY(!meter.add({kStepNs, {0, 0, 0}, 0, 0}));
        QVERIFY(!meter.add({2 * kStepNs, {0, 0, 0}, 0.01, 0}));
        QVERIFY(!meter.add({3 * kStepNs, {0, 0, 0}, 0, 0}));
        QVERIFY(!meter.add({4 * kStepNs, {0, 0, 0}, 0, 0}));
        QVERIFY(meter.add({5 * kStepNs, {0, 0, 0}, 0, 0}));
        QCOMPARE(meter.last().durationMs, 6.0);
    }

    // No data arrive during the deceleration. The time until they resume is not a stopping time.
    void unobservedStopIsNotMeasured() {
        StopMeter meter;
        Braking arm{meter, 0, 0, 0.1};
        arm.step(0);
        meter.begin(StopCause::DataStale, arm.now);
        arm.now += 3 * kNsPerSecond;
        arm.speed = 0;
        for (int i = 0; i < 20; ++i) {
            QVERIFY(!arm.step(0));
        }
        QCOMPARE(meter.last().count, 0U);
        QCOMPARE(meter.lastUnmeasured().count, 1U);
        QCOMPARE(meter.lastUnmeasured().cause, StopCause::DataStale);
        QCOMPARE(meter.lastUnmeasured().reason, UnmeasuredStop::Reason::DataGap);
        // The next stop is measured.
        arm.speed = 0.1;
        arm.step(0);
        meter.begin(StopCause::Released, arm.now);
        int steps = 0;
        while (!arm.step(2.0)) {
            QVERIFY(++steps < 1000);
        }
        QCOMPARE(meter.last().count, 1U);
    }

    void aRotatingJointIsNotStandstill() {
        StopMeter meter;
        meter.begin(StopCause::Space, 0);
        for (int i = 1; i < 20; ++i) {
            QVERIFY(!meter.add({i * kStepNs, {0, 0, 0}, 0, 0.1}));
        }
    }

    void samplesFromBeforeTheRequestDoNotCount() {
        StopMeter meter;
        meter.begin(StopCause::Space, 100 * kNsPerMs);
        for (int i = 0; i < 10; ++i) {
            QVERIFY(!meter.add({i * kStepNs, {0.001 * i, 0, 0}, 0, 0}));
        }
        QVERIFY(meter.isMeasuring());
        QCOMPARE(meter.last().count, 0U);
    }

    void countsStops() {
        StopMeter meter;
        std::int64_t now = 0;
        for (unsigned stop = 1; stop <= 3; ++stop) {
            meter.begin(StopCause::Escape, now);
            do {
                now += kStepNs;
            } while (!meter.add({now, {0, 0, 0}, 0, 0}));
            QCOMPARE(meter.last().count, stop);
        }
    }
};

QTEST_GUILESS_MAIN(TestStopMeter)
#include "tst_stop_meter.moc"
