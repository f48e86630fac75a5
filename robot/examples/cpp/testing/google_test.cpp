// SPDX-License-Identifier: MIT
// GoogleTest: each test uses a separate robot, in virtual time.
#include <gtest/gtest.h>

#include "robot/testing/robot_fixture.h"

using namespace tiller;

class Arm : public ::testing::Test, protected virtual_time::RobotFixture {};

TEST_F(Arm, ReachesItsTarget) {
    JointPositions target = q();
    target[5] += 0.2;
    const auto move = motions().moveJ(target).value();
    ASSERT_TRUE(finish(move));
    EXPECT_NEAR(q()[5], target[5], 1e-3);
}

TEST_F(Arm, ReportsAProtectiveStop) {
    JointPositions target = q();
    target[0] += 1;
    const auto move = motions().moveJ(target).value();
    bench.step(0.5);
    bench.robot().inject("protective-stop").value();
    EXPECT_EQ(finish(move).error().code, ErrorCode::UnsafeState);
}

TEST_F(Arm, LosesControlWithTheLink) {
    bench.robot().inject("link lost").value();
    bench.step(0.2);
    EXPECT_FALSE(controller->status().inControl);
}
