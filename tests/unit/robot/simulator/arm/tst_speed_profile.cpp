// SPDX-License-Identifier: MIT
#include <QTest>
#include <cmath>

#include "robot/simulator/arm/speed_profile.h"

using tiller::simulator::arm::ProfileRequest;
using tiller::simulator::arm::SpeedProfile;

class TestSpeedProfile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void trapezoidTakesDistanceOverSpeedPlusRamp();
    void shortDistanceGivesATriangularProfile();
    void positionIsTheIntegralOfSpeed_data();
    void positionIsTheIntegralOfSpeed();
    void blendZoneIsReachedAtItsSpeed();
    void stretchKeepsTheLength();
    void fastStartBrakesOverTheWholeDistance();
    void timeAndLengthAreInverse();
};

void TestSpeedProfile::trapezoidTakesDistanceOverSpeedPlusRamp() {
    const SpeedProfile p = SpeedProfile::plan({.length = 1.0, .v = 0.5, .a = 2.0});
    QCOMPARE(p.duration(), 1.0 / 0.5 + 0.5 / 2.0);
    QVERIFY(std::abs(p.length() - 1.0) < 1e-12);
    QCOMPARE(p.peakSpeed(), 0.5);
}

void TestSpeedProfile::shortDistanceGivesATriangularProfile() {
    const SpeedProfile p = SpeedProfile::plan({.length = 1.6, .v = 3.1, .a = 3.4});
    QVERIFY(std::abs(p.duration() - 2 * std::sqrt(1.6 / 3.4)) < 1e-12);
    QVERIFY(p.peakSpeed() < 3.1);
}

void TestSpeedProfile::positionIsTheIntegralOfSpeed_data() {
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("zone");
    QTest::addColumn<double>("blendTime");
    QTest::newRow("trapezoid") << 1.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("zone") << 1.0 << 0.0 << 0.2 << 0.0;
    QTest::newRow("blend in and zone") << 1.0 << 0.0 << 0.2 << 0.4;
    QTest::newRow("moving start") << 1.0 << 0.3 << 0.1 << 0.0;
    QTest::newRow("start faster than cruise") << 1.0 << 0.9 << 0.0 << 0.0;
    QTest::newRow("short with blend in") << 0.05 << 0.0 << 0.02 << 0.4;
}

void TestSpeedProfile::positionIsTheIntegralOfSpeed() {
    QFETCH(double, length);
    QFETCH(double, start);
    QFETCH(double, zone);
    QFETCH(double, blendTime);
    ProfileRequest request{.length = length, .v = 0.5, .a = 1.5, .startSpeed = start};
    request.zone = zone;
    request.zoneSpeed = 0.4;
    request.blendInTime = blendTime;
    request.blendInLength = 0.5 * length;
    const SpeedProfile p = SpeedProfile::plan(request);
    QVERIFY2(std::abs(p.length() - length) < 1e-9, qPrintable(QString::number(p.length())));
    const double dt = 1e-3;
    double before = p.sample(0).v;
    double s = 0;
    for (double t = dt; t < p.duration() + dt; t += dt) {
        const auto now = p.sample(t);
        s += 0.5 * (before + now.v) * dt;
        QVERIFY(std::abs(now.v - before) <= 1.5 * dt * 1.001 + 1e-9);
        QVERIFY(std::abs(now.s - s) < 1e-4);
        QVERIFY(now.v >= -1e-12);
        before = now.v;
    }
    QCOMPARE(p.sample(p.duration() + 1).v, 0.0);
}

void TestSpeedProfile::blendZoneIsReachedAtItsSpeed() {
    const SpeedProfile p =
        SpeedProfile::plan({.length = 1.0, .v = 0.5, .a = 2.0, .zone = 0.1, .zoneSpeed = 0.3});
    const auto at = p.sample(p.zoneTime());
    QVERIFY(std::abs(at.s - 0.9) < 1e-12);
    QVERIFY(std::abs(at.v - 0.3) < 1e-12);
    QVERIFY(std::abs(p.duration() - p.zoneTime() - 2 * 0.1 / 0.3) < 1e-12);
}

void TestSpeedProfile::stretchKeepsTheLength() {
    SpeedProfile p = SpeedProfile::plan({.length = 0.7, .v = 0.5, .a = 2.0});
    const double duration = p.duration();
    p.stretch(3.0);
    QVERIFY(std::abs(p.duration() - 3 * duration) < 1e-12);
    QVERIFY(std::abs(p.length() - 0.7) < 1e-12);
    QVERIFY(std::abs(p.sample(0.5 * p.duration()).s - 0.35) < 1e-12);
}

void TestSpeedProfile::fastStartBrakesOverTheWholeDistance() {
    // Braking from 1 m/s within 0.1 m is impossible at 1 m/s2. The profile decelerates harder and still ends
    // at the goal.
    const SpeedProfile p = SpeedProfile::plan({.length = 0.1, .v = 0.5, .a = 1.0, .startSpeed = 1.0});
    QVERIFY(std::abs(p.length() - 0.1) < 1e-12);
    QVERIFY(std::abs(p.duration() - 0.2) < 1e-12);
}

void TestSpeedProfile::timeAndLengthAreInverse() {
    const SpeedProfile p =
        SpeedProfile::plan({.length = 1.0, .v = 0.5, .a = 2.0, .zone = 0.3, .zoneSpeed = 0.2});
    for (double t = 0.01; t < p.duration() - 0.01; t += 0.05) {
        const auto at = p.sample(t);
        QVERIFY(std::abs(p.timeAtLength(at.s) - t) < 1e-9);
        QVERIFY(std::abs(p.speedAtLength(at.s) - at.v) < 1e-9);
    }
}

QTEST_GUILESS_MAIN(TestSpeedProfile)
#include "tst_speed_profile.moc"
