// SPDX-License-Identifier: MIT
#pragma once

// A minimal robot in memory. Every motion takes a fixed number of frames, registers and pins are arrays, and
// sockets are two strings. Tests can inspect the recorded requests of the script.

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "robot/simulator/urscript/host.h"

namespace tiller::simulator::urscript {

class FakeHost final : public Host {
public:
    // ---- set and inspected by tests
    double step = 0.002;
    std::int64_t timeNs = 12'345'000'000;
    int moveFrames = 5;        ///< frames per move or stop
    double durationScale = 1;  ///< 4: speed slider at 25 %
    std::vector<std::string> messages;
    struct Started {
        ThreadId thread;
        MotionCommand command;
    };
    std::vector<Started> motions;
    std::vector<ThreadId> abandoned;
    std::vector<std::string> calls;  ///< calls of all functions that have no separate member
    std::vector<Popup> popups;
    bool popupAnswered = false;
    std::optional<RequestAnswer> answer;
    std::optional<std::string> motionError;
    std::optional<std::string> startError;
    int ended = 0;
    int polls = 0;
    int contact = 0;
    bool reachable = true;
    JointPositions q{0.1, -1.2, 1.3, -1.4, -1.5, 0.6};
    JointVelocities qd;
    Twist tcpVelocity{{0.5, 0, 0}, {0, 0, 0.25}};
    double inertia = 2;  ///< inertia of each joint, without coupling to other joints [kg m2]
    bool steady = true;
    std::function<JointPositions(int)> history;  ///< joint positions the given number of steps ago
    Pose tcp;
    Payload load;
    std::array<bool, 128> boolIn{}, boolOut{};
    std::array<std::int32_t, 48> intIn{}, intOut{};
    std::array<double, 48> floatIn{}, floatOut{};
    std::array<bool, 64> flags{};
    std::array<bool, 18> pins{};
    struct Socket {
        State state = State::Connecting;
        std::string in, out;
        bool connectAtOnce = true;
    };
    std::map<std::string, Socket, std::less<>> sockets;
    bool acceptSockets = true;
    std::vector<WatchdogAction> watchdogs;
    std::function<void()> onProtectiveStop;

    std::string lastMessage() const { return messages.empty() ? std::string() : messages.back(); }

    // ---- motion
    Result<void> startMotion(ThreadId thread, const MotionCommand& command) override {
        if (startError) {
            return scriptError(*startError);
        }
        motions.push_back({thread, command});
        remaining_[thread] = framesOf(command);
        return {};
    }
    Result<bool> motionFinished(ThreadId thread) override {
        ++polls;
        if (motionError) {
            return scriptError(*motionError);
        }
        return --remaining_[thread] <= 0;
    }
    void motionAbandoned(ThreadId thread) override { abandoned.push_back(thread); }
    Result<void> forceMode(const ForceMode& mode) override {
        calls.push_back("force_mode " + std::to_string(mode.type));
        return {};
    }
    void endForceMode() override { calls.push_back("end_force_mode"); }
    Result<void> setForceModeDamping(double damping) override {
        damping_ = damping;
        return {};
    }
    double forceModeDamping() const override { return damping_; }
    Result<void> setForceModeGainScaling(double scaling) override {
        gain_ = scaling;
        return {};
    }
    double forceModeGainScaling() const override { return gain_; }
    Result<void> freedrive(const Freedrive& mode) override {
        calls.push_back(mode.tool ? "freedrive tool" : "freedrive");
        return {};
    }
    void endFreedrive() override { calls.push_back("end_freedrive"); }

    // ---- state
    JointPositions jointPositions(Source) const override { return q; }
    JointVelocities jointVelocities(Source) const override { return qd; }
    JointAccelerations jointAccelerations(Source) const override { return {}; }
    Result<JointPositions> jointPositionsHistory(int steps) const override {
        if (history) {
            return history(steps);
        }
        if (steps > 100) {
            return scriptError("history is too short");
        }
        return JointPositions(q.values.array() - steps);
    }
    JointTorques externalJointTorques() const override { return JointTorques(1, 2, 3, 4, 5, 6); }
    Pose tcpPose(Source) const override { return {0.1, 0.2, 0.3, 0, 3.14, 0}; }
    Twist tcpSpeed(Source) const override { return tcpVelocity; }
    Pose flangePose() const override { return {0.1, 0.2, 0.4, 0, 3.14, 0}; }
    Pose targetWaypoint() const override { return tcpPose(Source::Target); }
    Wrench tcpForce() const override { return {{3, 4, 0}, {0, 0, 1}}; }
    bool isSteady() const override { return steady; }
    int toolContact(const Eigen::Vector3d&) const override { return contact; }
    double jointTemperature(int joint) const override { return 30 + joint; }
    double controllerTemperature() const override { return 40; }
    double toolTemperature() const override { return 35; }
    double toolCurrent() const override { return 0.1; }
    Eigen::Vector3d toolAccelerometer() const override { return {0, 0, -9.81}; }

    // ---- kinematics: the values of the pose are used as joint positions, which is sufficient to check
    // arguments
    Pose forwardKinematics(const std::optional<JointPositions>& at,
                           const std::optional<Pose>&) const override {
        return Pose::fromArray((at ? *at : q).array());
    }
    std::optional<JointPositions> inverseKinematics(const InverseRequest& request) const override {
        return reachable ? std::optional(JointPositions(request.pose.array())) : std::nullopt;
    }
    Result<Matrix6> massMatrix(const std::optional<JointPositions>&, bool) const override {
        return Matrix6(Matrix6::Identity() * inertia);
    }
    bool isWithinSafetyLimits(const MoveTarget&) const override { return reachable; }

    // ---- setup
    Pose tcpOffset() const override { return tcp; }
    Result<void> setTcpOffset(const Pose& flangeToTcp, std::string_view) override {
        tcp = flangeToTcp;
        return {};
    }
    Payload payload() const override { return load; }
    Result<void> setPayload(const Payload& payload, double, bool) override {
        load = payload;
        return {};
    }
    Eigen::Vector3d gravity() const override { return gravity_; }
    Result<void> setGravity(const Eigen::Vector3d& gravity) override {
        gravity_ = gravity;
        return {};
    }
    void zeroForceSensor() override { calls.push_back("zero_ftsensor"); }
    Result<void> setExternalForceSensor(const ExternalForceSensor& sensor) override {
        calls.push_back(sensor.viaRtde ? "ft_rtde_input" : "external_ft_sensor");
        return {};
    }
    Result<void> applySetting(std::string_view builtin, std::span<const double>) override {
        calls.emplace_back(builtin);
        return {};
    }

    // ---- registers, pins
    bool boolRegister(RegisterSide side, int a) const override {
        return (side == RegisterSide::Input ? boolIn : boolOut)[at(a)];
    }
    std::int32_t intRegister(RegisterSide side, int a) const override {
        return (side == RegisterSide::Input ? intIn : intOut)[at(a)];
    }
    double floatRegister(RegisterSide side, int a) const override {
        return (side == RegisterSide::Input ? floatIn : floatOut)[at(a)];
    }
    void setBoolOutput(int a, bool v) override { boolOut[at(a)] = v; }
    void setIntOutput(int a, std::int32_t v) override { intOut[at(a)] = v; }
    void setFloatOutput(int a, double v) override { floatOut[at(a)] = v; }
    bool flag(int n) const override { return flags[at(n)]; }
    void setFlag(int n, bool v) override { flags[at(n)] = v; }
    static std::size_t pinOf(DigitalBank bank, int n) { return 8 * static_cast<std::size_t>(bank) + at(n); }
    bool digitalInput(DigitalBank bank, int n) const override { return pins[pinOf(bank, n)]; }
    bool digitalOutput(DigitalBank bank, int n) const override { return pins[pinOf(bank, n)]; }
    void setDigitalOutput(DigitalBank bank, int n, bool v) override { pins[pinOf(bank, n)] = v; }
    double analog(AnalogPort port, int n) const override { return static_cast<double>(port) + 0.1 * n; }
    void setAnalogOutput(int n, double level) override {
        calls.push_back("analog " + std::to_string(n) + " " + std::to_string(level));
    }
    void setAnalogDomain(AnalogPort, int, int) override { calls.push_back("domain"); }
    void setToolVoltage(int volts) override { calls.push_back("voltage " + std::to_string(volts)); }
    void setToolCommunication(const ToolCommunication&) override { calls.push_back("tool communication"); }
    void setToolOutputMode(int mode) override { calls.push_back("tool output mode " + std::to_string(mode)); }
    void setToolDigitalOutputMode(int n, int mode) override {
        calls.push_back("tool digital output mode " + std::to_string(n) + " " + std::to_string(mode));
    }
    void setRunState(RuledOutput, int n, int state) override {
        calls.push_back("run state " + std::to_string(n) + " " + std::to_string(state));
    }
    void setFreedriveInput(RuledInput, int n, bool freedrive) override {
        calls.push_back("freedrive input " + std::to_string(n) + (freedrive ? " on" : " off"));
    }
    void resetInputActions() override { calls.push_back("input actions reset"); }

    // ---- sockets
    bool openSocket(std::string_view name, std::string_view, int port) override {
        calls.push_back("open " + std::string(name) + " " + std::to_string(port));
        Socket& s = sockets[std::string(name)];
        s.state = s.connectAtOnce ? State::Open : State::Connecting;
        return acceptSockets;
    }
    State socketState(std::string_view name) const override {
        const auto it = sockets.find(name);
        return it == sockets.end() ? State::Closed : it->second.state;
    }
    void closeSocket(std::string_view name) override { sockets[std::string(name)].state = State::Closed; }
    bool sendSocket(std::string_view name, std::string_view bytes) override {
        if (socketState(name) != State::Open) {
            return false;
        }
        sockets[std::string(name)].out += bytes;
        return true;
    }
    std::string_view receivedBytes(std::string_view name) const override {
        const auto it = sockets.find(name);
        return it == sockets.end() ? std::string_view() : std::string_view(it->second.in);
    }
    void consumeBytes(std::string_view name, std::size_t count) override {
        sockets[std::string(name)].in.erase(0, count);
    }

    // ---- messages, program
    void textMessage(std::string_view text) override { messages.emplace_back(text); }
    void programLabel(int number, std::string_view text) override {
        calls.push_back("label " + std::to_string(number) + " " + std::string(text));
    }
    int showPopup(const Popup& popup) override {
        popups.push_back(popup);
        return static_cast<int>(popups.size());
    }
    bool popupOpen(int) const override { return !popupAnswered; }
    Result<int> requestValue(RequestedType, std::string_view) override { return 1; }
    std::optional<RequestAnswer> requestedValue(int) override { return answer; }
    double stepTime() const override { return step; }
    std::int64_t controllerTimeNs() const override { return timeNs; }
    std::int64_t systemTimeNs() const override { return 1'700'000'000'000'000'000; }
    Result<void> protectiveStop() override {
        calls.push_back("protective_stop");
        if (onProtectiveStop) {
            onProtectiveStop();
        }
        return {};
    }
    void powerDown() override { calls.push_back("powerdown"); }
    Result<void> setWatchdog(std::string_view, double, WatchdogAction action) override {
        watchdogs.push_back(action);
        return {};
    }
    void programEnded(ProgramKind) override { ++ended; }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    int framesOf(const MotionCommand& command) const {
        std::optional<double> duration;
        if (const auto* move = std::get_if<Move>(&command); move != nullptr && move->duration > 0) {
            duration = move->duration;
        } else if (const auto* servo = std::get_if<ServoJ>(&command)) {
            duration = servo->duration;
        } else if (const auto* speedj = std::get_if<SpeedJ>(&command)) {
            duration = speedj->duration;
        } else if (const auto* speedl = std::get_if<SpeedL>(&command)) {
            duration = speedl->duration;
        } else if (std::holds_alternative<DirectTorque>(command)) {
            return 1;
        }
        return duration ? static_cast<int>(std::lround(*duration * durationScale / step)) : moveFrames;
    }

    std::map<ThreadId, int> remaining_;
    double damping_ = 0.005;
    double gain_ = 1;
    Eigen::Vector3d gravity_{0, 0, 9.82};
};

}  // namespace tiller::simulator::urscript
