// SPDX-License-Identifier: MIT
#pragma once

// Runs control.script in the simulator's interpreter, frame by frame, with an in-memory robot.

#include <QTest>
#include <algorithm>
#include <functional>
#include <map>

#include "robot/control/detail/control_script.h"
#include "robot/control/detail/registers.h"
#include "robot/simulator/urscript/interpreter.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

namespace tiller::test {

using namespace tiller::control;

inline constexpr std::int32_t kSession = 99;
inline const ArmLimits kArm = ArmLimits::of(robotModel(RobotModelId::UR5e));

namespace urscript = tiller::simulator::urscript;

struct ScriptBench {
    urscript::FakeHost host;
    std::unique_ptr<urscript::Interpreter> program;
    int first;
    std::int32_t sequence = 1000;
    Request request;                             ///< sent with every package
    std::function<bool(std::size_t)> comesLate;  ///< parts of a package that arrive one frame later
    std::map<std::size_t, double> late;
    bool forcePermitted = false;
    bool mayFinish = false;
    std::int32_t heartbeatTimeoutMs = 0;

    explicit ScriptBench(RegisterRange range = RegisterRange::Upper, SoftwareVersion version = {5, 22, 0, 0},
                         const QString& section = {})
        : first(firstRegister(range)) {
        host.step = version.controlPeriod();
        host.moveFrames = 20;
        urscript::CompileOptions options;
        options.version = version;
        const auto compiled = urscript::compile(
            controlScript(version, range, kSession, MotionLimits{}, kArm, section).text.toStdString(),
            options);
        if (!compiled) {
            qFatal("control.script line %d, column %d: %s", compiled.error.line, compiled.error.column,
                   compiled.error.text.c_str());
        }
        program = std::make_unique<urscript::Interpreter>(compiled.program, host);
    }

    // Writes a package of the controller to the registers.
    void send(ScriptCommand kind, std::int32_t epoch, std::array<double, 6> values = {}) {
        Command command;
        command.kind = kind;
        command.epoch = epoch;
        command.values = values;
        const bool isSpeed = kind == ScriptCommand::SpeedJ || kind == ScriptCommand::SpeedL;
        command.speed = isSpeed ? 0 : 0.5;  // for speed commands: the duration
        command.acceleration = 1.4;
        command.rotationAcceleration = 2;
        send(command);
    }
    void send(Command command) {
        command.session = command.session == 0 ? kSession : command.session;
        command.request = request;
        command.forcePermitted = forcePermitted;
        command.mayFinish = mayFinish;
        command.heartbeatTimeoutMs = heartbeatTimeoutMs;
        command.sequence = ++sequence;
        const auto values = encode(command);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (comesLate && comesLate(i)) {
                late[i] = values[i];
            } else {
                put(i, values[i]);
            }
        }
    }
    void put(std::size_t i, double value) {
        constexpr std::size_t kInts = 10;
        const auto at = static_cast<std::size_t>(first);
        if (i < kInts) {
            host.intIn[at + (i == kInts - 1 ? kInts : i)] = static_cast<std::int32_t>(value);
        } else {
            host.floatIn[at + i - kInts] = value;
        }
    }
    void frame(int times = 1) {
        for (int i = 0; i < times; ++i) {
            program->runFrame();
            for (const auto& [place, value] : late) {
                put(place, value);
            }
            late.clear();
            if (program->error()) {
                qFatal("line %d: %s", program->error()->line, program->error()->text.c_str());
            }
        }
    }
    // Runs frames with a heartbeat in each frame.
    void hold(ScriptCommand kind, std::int32_t epoch, int times, std::array<double, 6> values = {}) {
        for (int i = 0; i < times; ++i) {
            send(kind, epoch, values);
            frame();
        }
    }
    // Sends a request and runs the robot until it answers the request.
    Answer ask(RequestKind kind, std::int32_t whole = 0, std::array<double, 6> numbers = {}) {
        request = {request.number + 1, kind, whole, numbers};
        // The request is executed after two frames. The first of them may arrive late.
        hold(ScriptCommand::Idle, idleEpoch, 3);
        Answer answer;
        answer.number = out(4);
        answer.outcome = static_cast<Outcome>(out(5));
        answer.whole = out(6);
        std::copy_n(host.floatOut.begin() + first, 6, answer.numbers.begin());
        return answer;
    }
    std::int32_t idleEpoch = 1;
    int out(int index) const { return host.intOut[static_cast<std::size_t>(first + index)]; }
    /// A negative number also means Expired: see AbandonedProgram.
    ScriptState state() const { return out(2) < 0 ? ScriptState::Expired : static_cast<ScriptState>(out(2)); }
    bool running() const { return !program->ended(); }
    int silentFrames() const { return static_cast<int>(0.1 / host.step + 0.5); }

    template <class T>
    int count() const {
        int n = 0;
        for (const auto& motion : host.motions) {
            n += std::holds_alternative<T>(motion.command);
        }
        return n;
    }
    template <class T>
    const T* last() const {
        return host.motions.empty() ? nullptr : std::get_if<T>(&host.motions.back().command);
    }
};

inline bool near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).norm() < 1e-9;
}

}  // namespace tiller::test
