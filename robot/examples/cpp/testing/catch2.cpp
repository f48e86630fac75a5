// SPDX-License-Identifier: MIT
// Catch2: each test case uses a separate robot, in virtual time.
#include <catch2/catch_test_macros.hpp>

#include "robot/testing/robot_fixture.h"

using namespace tiller;

TEST_CASE_METHOD(virtual_time::RobotFixture, "a move reaches its target") {
    JointPositions target = q();
    target[5] += 0.2;
    const auto move = motions().moveJ(target).value();
    REQUIRE(finish(move).ok());
    CHECK(std::abs(q()[5] - target[5]) < 1e-3);
}

TEST_CASE_METHOD(virtual_time::RobotFixture, "a protective stop ends a move") {
    JointPositions target = q();
    target[0] += 1;
    const auto move = motions().moveJ(target).value();
    bench.step(0.5);
    bench.robot().inject("protective-stop").value();
    CHECK((finish(move).error().code == ErrorCode::UnsafeState));
}
