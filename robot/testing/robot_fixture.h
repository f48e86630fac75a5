// SPDX-License-Identifier: MIT
#pragma once

// A fixture for any test framework: a simulated UR5e in virtual time, and a controller that has taken control.
//
//     class Arm : public ::testing::Test, protected tiller::virtual_time::RobotFixture {};  // GoogleTest
//     TEST_CASE_METHOD(tiller::virtual_time::RobotFixture, "a protective stop ends the move")  // Catch2
//     std::optional<tiller::virtual_time::RobotFixture> robot;  // Qt Test: emplace() in init(), reset() in cleanup()

#include <chrono>
#include <memory>
#include <utility>

#include "robot/control/motions.h"
#include "robot/testing/lock_step.h"

namespace tiller::virtual_time {

/// Threads  one
struct RobotFixture {
    /// Starts the robot and takes control. Throws ResultError on failure.
    explicit RobotFixture(simulator::SimulatorOptions options = LockStep::defaultOptions())
        : bench(std::move(options)) {
        bench.start().value();
        controller = bench.makeController();
        bench.whileTimePasses([this] { return controller->takeControl(limit()); }).value();
    }
    ~RobotFixture() {
        if (controller) {
            bench.whileTimePasses([this] { controller->release(); });
        }
    }
    RobotFixture(const RobotFixture&) = delete;
    RobotFixture& operator=(const RobotFixture&) = delete;

    /// Waits for the end of a motion while the time advances, and returns the result.
    Result<void> finish(const control::Motion& motion) {
        return bench.whileTimePasses([&] { return motion.wait(limit()); });
    }
    /// Timeout in case of a hang; a test in virtual time never reaches it.
    static Deadline limit() { return Deadline::after(std::chrono::seconds(60)); }
    /// Motion commands of the controller.
    control::Motions motions() { return control::Motions(*controller); }
    /// Actual joint positions [rad].
    JointPositions q() const { return bench.robot().truth().q; }

    LockStep bench;
    std::shared_ptr<control::Controller> controller;
};

}  // namespace tiller::virtual_time
