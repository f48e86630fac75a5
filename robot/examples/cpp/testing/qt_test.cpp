// SPDX-License-Identifier: MIT
// Qt Test: each test function uses a separate robot, in virtual time.
#include <QTest>
#include <optional>

#include "robot/testing/robot_fixture.h"

using namespace tiller;

class ArmTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { robot_.emplace(); }
    void cleanup() { robot_.reset(); }

    void reachesItsTarget() {
        JointPositions target = robot_->q();
        target[5] += 0.2;
        const auto move = robot_->motions().moveJ(target).value();
        QVERIFY(robot_->finish(move).ok());
        QVERIFY(std::abs(robot_->q()[5] - target[5]) < 1e-3);
    }

    void reportsAProtectiveStop() {
        JointPositions target = robot_->q();
        target[0] += 1;
        const auto move = robot_->motions().moveJ(target).value();
        robot_->bench.step(0.5);
        robot_->bench.robot().inject("protective-stop").value();
        QCOMPARE(robot_->finish(move).error().code, ErrorCode::UnsafeState);
    }

private:
    std::optional<virtual_time::RobotFixture> robot_;
};

QTEST_GUILESS_MAIN(ArmTest)
#include "qt_test.moc"
