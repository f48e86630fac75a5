// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/simulator/power_system.h"

using namespace tiller;
using simulator::PowerSystem;

class TestPowerSystem : public QObject {
    Q_OBJECT

    /// The modes passed through in so many seconds.
    static QList<int> modes(PowerSystem& power, double seconds) {
        QList<int> seen{static_cast<int>(power.mode())};
        for (int i = 0; i < static_cast<int>(seconds / 0.002 + 0.5); ++i) {
            power.step(0.002);
            if (static_cast<int>(power.mode()) != seen.back()) {
                seen << static_cast<int>(power.mode());
            }
        }
        return seen;
    }

private Q_SLOTS:
    void powerOnGoesByWayOfBootingToIdle() {
        PowerSystem power(false);
        power.powerOn();
        QCOMPARE(modes(power, 3), (QList<int>{4, 2, 5}));
    }

    void brakeReleasePowersOnFirst() {
        PowerSystem power(false);
        power.releaseBrakes();
        QCOMPARE(modes(power, 5), (QList<int>{4, 2, 5, 7}));
    }

    void brakeReleaseWhileBootingIsRemembered() {
        PowerSystem power(false);
        power.powerOn();
        modes(power, 0.5);
        power.releaseBrakes();
        QCOMPARE(modes(power, 5).back(), 7);
    }

    void powerOnChangesNothingWhereThereIsPower() {
        PowerSystem power(true);
        power.powerOn();
        QCOMPARE(modes(power, 3), QList<int>{7});
    }

    void powerOffTakesAMomentAndWins() {
        PowerSystem power(false);
        power.releaseBrakes();
        modes(power, 1);
        power.powerOff();
        power.step(0.002);
        QVERIFY(power.isPowered());
        QCOMPARE(modes(power, 5).back(), 3);
    }

    void powerOffWithoutPowerIsHarmless() {
        PowerSystem power(false);
        power.powerOff();
        QCOMPARE(modes(power, 1), QList<int>{3});
        power.powerOn();
        QCOMPARE(modes(power, 3).back(), 5);
    }

    void aCutIsImmediateAndForgetsWhatWasUnderWay() {
        PowerSystem power(false);
        power.releaseBrakes();
        modes(power, 1);
        power.cut();
        QVERIFY(!power.isPowered());
        QCOMPARE(modes(power, 5), QList<int>{3});
    }
};

QTEST_GUILESS_MAIN(TestPowerSystem)
#include "tst_power_system.moc"
