// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/simulator/plant/power_system.h"

using namespace tiller;
using simulator::PowerSystem;

class TestPowerSystem : public QObject {
    Q_OBJECT

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
    void powerOnPassesBootingBeforeIdle() {
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

    void powerOnChangesNothingWhenPowered() {
        PowerSystem power(true);
        power.powerOn();
        QCOMPARE(modes(power, 3), QList<int>{7});
    }

    void powerOffTakesTimeAndHasPriority() {
        PowerSystem power(false);
        power.releaseBrakes();
        modes(power, 1);
        power.powerOff();
        power.step(0.002);
        QVERIFY(power.isPowered());
        QCOMPARE(modes(power, 5).back(), 3);
    }

    void powerOnDuringPowerOffIsNotLost() {
        PowerSystem power(true);
        power.powerOff();
        power.step(0.002);
        power.powerOn();
        QCOMPARE(modes(power, 5), (QList<int>{7, 3, 4, 2, 5}));
        power.powerOff();
        power.releaseBrakes();
        QCOMPARE(modes(power, 5), (QList<int>{5, 3, 4, 2, 5, 7}));
        power.powerOff();
        power.powerOn();
        power.powerOff();
        QCOMPARE(modes(power, 5), (QList<int>{7, 3}));
    }

    void aControllerStartsDisconnectedUntilConfirmed() {
        PowerSystem power(false);
        power.boot(2, false);
        QVERIFY(!power.isPowered());
        QCOMPARE(modes(power, 3), (QList<int>{0, 2, 3}));
        power.boot(2, true);
        power.powerOn();
        QCOMPARE(modes(power, 10), (QList<int>{0, 1}));
        power.confirmSafety();
        QCOMPARE(modes(power, 5), (QList<int>{1, 2, 3}));
    }

    void backdriveIsEnteredFromIdleOnly() {
        PowerSystem power(true);
        power.setBackdrive(true);
        QCOMPARE(static_cast<int>(power.mode()), 7);
        power.powerOff();
        power.powerOn();
        modes(power, 5);
        power.setBackdrive(true);
        QCOMPARE(modes(power, 1), QList<int>{6});
        QVERIFY(power.isPowered());
        power.setBackdrive(false);
        QCOMPARE(modes(power, 1), QList<int>{5});
    }

    void powerOffWithoutPowerIsHarmless() {
        PowerSystem power(false);
        power.powerOff();
        QCOMPARE(modes(power, 1), QList<int>{3});
        power.powerOn();
        QCOMPARE(modes(power, 3).back(), 5);
    }

    void powerCutIsImmediateAndCancelsTransitions() {
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
