// SPDX-License-Identifier: MIT
#pragma once

// The control loop without sockets and threads, for tests.

#include <QTest>

#include "robot/control/detail/control_loop.h"
#include "robot/core/clock.h"
#include "robot/kinematics/arm_kinematics.h"

namespace tiller::test {

using namespace tiller::control;

inline constexpr std::int32_t kSession = 4711;
inline constexpr double kPeriod = 0.002;
inline constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
inline constexpr double kDeg = 3.14159265358979323846 / 180;
inline const JointPositions kPose(-90 * kDeg, -100 * kDeg, -110 * kDeg, -60 * kDeg, 90 * kDeg, 0);

// Clock, mailbox, loop, and a robot that answers as control.script does, one package later.
struct LoopBench {
    VirtualClock clock;
    Mailbox mailbox;
    MotionLimits limits;
    ControlLoop loop{mailbox, limits};
    Feedback data;
    Command command;  ///< last command sent
    bool answering = true;

    LoopBench() {
        data.runtimeState = RuntimeState::Playing;
        data.robotMode = RobotMode::Running;
        data.safetyMode = SafetyMode::Normal;
        data.q = kPose;
        data.tcpPose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, kPose);
        data.timestamp = 60;
        loop.begin(kSession, kPeriod, ArmLimits::of(robotModel(RobotModelId::UR5e)), clock.nowNs());
    }

    std::int64_t now() const { return clock.nowNs(); }

    const Command& tick(int times = 1) {
        for (int i = 0; i < times; ++i) {
            clock.advanceNs(kPeriodNs);
            data.hostNs = now();
            data.timestamp += kPeriod;
            command = loop.tick(data);
            if (answering) {
                data.echo.sequence = command.sequence;
                data.echo.epoch = command.epoch;
                data.echo.session = command.session;
                data.echo.state =
                    command.kind == ScriptCommand::Idle ? ScriptState::Ready : ScriptState::Executing;
            }
        }
        return command;
    }

    void takeControl() {
        tick(3);
        QVERIFY(loop.isInControl());
    }

    MotionId startJog(double x) {
        MotionCommand jog;
        jog.kind = MotionCommand::Kind::Jog;
        jog.jog.twist.linear.x() = x;
        return mailbox.start(jog, now());
    }

    /// A stream of setpoints, as created by Motions::startSpeedL.
    MotionId startStream() {
        MotionCommand stream;
        stream.kind = MotionCommand::Kind::Program;
        stream.program = static_cast<std::int32_t>(ScriptCommand::SpeedL);
        stream.held = false;
        return mailbox.start(stream, now());
    }

    MotionId startMove(bool held) {
        MotionCommand move;
        move.kind = MotionCommand::Kind::MoveJ;
        move.held = held;
        move.target = {1, 2, 3, 4, 5, 6};
        move.speed = 0.5;
        move.acceleration = 1.4;
        return mailbox.start(move, now());
    }

    StopCause causeOf(MotionId motion) const { return mailbox.epoch().state(motion).cause; }
};

}  // namespace tiller::test
