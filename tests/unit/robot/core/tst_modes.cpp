// SPDX-License-Identifier: MIT
#include <QTest>

#include "robot/core/modes.h"
#include "robot/core/version.h"

using namespace tiller;

class TestModes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void modesHaveTheControllersSpelling() {
        QCOMPARE(robotModeName(RobotMode::NoController), QString("NO_CONTROLLER"));
        QCOMPARE(robotModeName(static_cast<RobotMode>(7)), QString("RUNNING"));
        QCOMPARE(robotModeName(static_cast<RobotMode>(3)), QString("POWER_OFF"));
        QCOMPARE(safetyModeName(static_cast<SafetyMode>(3)), QString("PROTECTIVE_STOP"));
        QCOMPARE(safetyModeName(static_cast<SafetyMode>(13)), QString("SYSTEM_THREE_POSITION_ENABLING_STOP"));
        QCOMPARE(runtimeStateName(static_cast<RuntimeState>(2)), QString("PLAYING"));
    }

    void unknownNumbersAreShownAsNumbers() {
        QCOMPARE(robotModeName(static_cast<RobotMode>(77)), QString("UNKNOWN_77"));
        QCOMPARE(safetyModeName(static_cast<SafetyMode>(-4)), QString("UNKNOWN_-4"));
        QCOMPARE(runtimeStateName(static_cast<RuntimeState>(9)), QString("UNKNOWN_9"));
    }

    void motionIsAllowedInNormalAndReducedOnly() {
        for (int mode = -1; mode < 40; ++mode) {
            QCOMPARE(allowsMotion(static_cast<SafetyMode>(mode)), mode == 1 || mode == 2);
        }
    }

    void versionsCompareFieldByField() {
        QVERIFY((SoftwareVersion{5, 22, 0, 0} > SoftwareVersion{5, 9, 4, 1031232}));
        QVERIFY((SoftwareVersion{5, 22, 0, 1} > SoftwareVersion{5, 22, 0, 0}));
        QVERIFY((SoftwareVersion{10, 7, 0, 0} > SoftwareVersion{5, 22, 0, 0}));
    }

    void versionIdentifiesTheController() {
        QVERIFY((SoftwareVersion{3, 15, 8, 0}.isCb3()));
        QVERIFY(!(SoftwareVersion{5, 0, 0, 0}.isCb3()));
        QVERIFY(!SoftwareVersion{}.isCb3());
        QVERIFY((SoftwareVersion{10, 9, 0, 0}.isPolyScopeX()));
        QCOMPARE((SoftwareVersion{3, 15, 8, 0}.controlPeriod()), 0.008);
        QCOMPARE((SoftwareVersion{5, 22, 0, 0}.maxFrequency()), 500.0);
    }
};

QTEST_GUILESS_MAIN(TestModes)
#include "tst_modes.moc"
