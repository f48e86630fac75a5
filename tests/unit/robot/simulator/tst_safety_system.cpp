// SPDX-License-Identifier: MIT

#include <QTest>

#include "robot/simulator/plant/safety_system.h"

using namespace tiller;
using simulator::SafetySystem;

class TestSafetySystem : public QObject {
    Q_OBJECT

    static void pass(SafetySystem& safety, double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / 0.002 + 0.5); ++i) {
            safety.step(0.002);
        }
    }

private Q_SLOTS:
    void aFreshSystemIsNormal() {
        const SafetySystem safety;
        QCOMPARE(safety.mode(), SafetyMode::Normal);
        QCOMPARE(safety.statusBits(), 1U);
    }

    void theDashboardMayUnlockAfterFiveSeconds() {
        SafetySystem safety;
        safety.protectiveStop();
        pass(safety, 4.998);
        QVERIFY(!safety.unlockProtectiveStop(true));
        pass(safety, 0.002);
        QVERIFY(safety.unlockProtectiveStop(true));
        QCOMPARE(safety.mode(), SafetyMode::ProtectiveStop);  // takes effect after kUnlockTime
        pass(safety, SafetySystem::kUnlockTime);
        QCOMPARE(safety.mode(), SafetyMode::Normal);
    }

    void anEarlyUnlockWithoutTheRuleIsNotLost() {
        SafetySystem safety;
        safety.protectiveStop();
        QVERIFY(safety.unlockProtectiveStop(false));
        pass(safety, 1);
        QCOMPARE(safety.mode(), SafetyMode::Normal);
    }

    void aSecondStopDuringTheUnlockIsEffective() {
        SafetySystem safety;
        safety.protectiveStop();
        pass(safety, 6);
        QVERIFY(safety.unlockProtectiveStop(true));
        safety.protectiveStop();
        pass(safety, 1);
        QCOMPARE(safety.mode(), SafetyMode::ProtectiveStop);
        QVERIFY(!safety.unlockProtectiveStop(true));
    }

    void theMostSevereCauseIsShown() {
        SafetySystem safety;
        safety.set(SafetySystem::Input::Reduced, true);
        QCOMPARE(safety.mode(), SafetyMode::Reduced);
        safety.set(SafetySystem::Input::Safeguard, true);
        QCOMPARE(safety.mode(), SafetyMode::SafeguardStop);
        safety.protectiveStop();
        QCOMPARE(safety.mode(), SafetyMode::ProtectiveStop);
        safety.set(SafetySystem::Input::SystemEmergencyStop, true);
        QCOMPARE(safety.mode(), SafetyMode::SystemEmergencyStop);
        safety.set(SafetySystem::Input::RobotEmergencyStop, true);
        QCOMPARE(safety.mode(), SafetyMode::RobotEmergencyStop);
        safety.violation();
        QCOMPARE(safety.mode(), SafetyMode::Violation);
        safety.fault();
        QCOMPARE(safety.mode(), SafetyMode::Fault);
        QCOMPARE(safety.statusBits(), 0b111'1111'0110U);
        safety.restart();
        QCOMPARE(safety.mode(), SafetyMode::RobotEmergencyStop);
        QVERIFY(safety.blocksPower());
    }

    void newerSafeguardStopsDependOnTheOperationalMode() {
        SafetySystem safety;
        safety.set(SafetySystem::Input::AutomaticModeSafeguard, true);
        safety.set(SafetySystem::Input::ThreePositionEnabling, true);
        QCOMPARE(safety.mode(), SafetyMode::Normal);
        safety.setOperationalMode(simulator::OperationalMode::Automatic);
        QCOMPARE(safety.mode(), SafetyMode::SafeguardStop);
        QCOMPARE(safety.status(), SafetyMode::AutomaticModeSafeguardStop);
        QCOMPARE(safety.statusBits(), (1U << 4) | (1U << 10));
        safety.setOperationalMode(simulator::OperationalMode::Manual);
        QCOMPARE(safety.mode(), SafetyMode::SafeguardStop);
        QCOMPARE(safety.status(), SafetyMode::SystemThreePositionEnablingStop);
        QCOMPARE(safety.statusBits(), (1U << 4) | (1U << 10) | (1U << 11));
        safety.set(SafetySystem::Input::ThreePositionEnabling, false);
        QCOMPARE(safety.status(), SafetyMode::Normal);
    }

    void releasingAnInputEndsItsStop() {
        SafetySystem safety;
        safety.set(SafetySystem::Input::RobotEmergencyStop, true);
        QCOMPARE(safety.statusBits(), (1U << 6) | (1U << 7) | (1U << 10));
        safety.set(SafetySystem::Input::RobotEmergencyStop, false);
        QCOMPARE(safety.mode(), SafetyMode::Normal);
        QVERIFY(!safety.blocksPower());
    }
};

QTEST_GUILESS_MAIN(TestSafetySystem)
#include "tst_safety_system.moc"
