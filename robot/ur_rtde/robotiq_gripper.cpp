// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/robotiq_gripper.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <thread>

#include "robot/core/tcp_connect.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

namespace {

using std::chrono::milliseconds;
using tiller::ErrorCode;
using tiller::native_socket::Status;
namespace check = tiller::urrtde::check;
namespace socket = tiller::native_socket;

constexpr milliseconds kReplyTime(2000);
constexpr milliseconds kActivationTime(15000);
constexpr milliseconds kMotionTime(30000);
constexpr milliseconds kPollEvery(10);
constexpr int kDeviceMax = 255;
constexpr float kDeviceMaxReal = 255.0F;

}  // namespace

struct RobotiqGripper::Private {
    QString host;
    int port = 0;
    bool verbose = false;
    socket::Descriptor descriptor = -1;
    std::string received;

    int minPosition = 0;           ///< open, device units
    int maxPosition = kDeviceMax;  ///< closed
    int range_mm = 40;             ///< stroke
    eUnit units[3] = {UNIT_NORMALIZED, UNIT_NORMALIZED, UNIT_NORMALIZED};
    int speed = kDeviceMax;  ///< presets, device units
    int force = 0;           // as gentle as can be
    int requested = 0;       ///< the last position commanded, device units

    void close() {
        if (descriptor >= 0) {
            socket::close(descriptor);
            descriptor = -1;
        }
        received.clear();
    }

    [[noreturn]] void fail(ErrorCode code, const std::string& line) {
        close();  // a late reply would be taken for the answer to the next line
        tiller::urrtde::raise(
            {code,
             QStringLiteral("gripper at %1:%2, \"%3\"").arg(host).arg(port).arg(QString::fromStdString(line)),
             {}});
    }

    std::string ask(const std::string& line) {
        if (descriptor < 0) {
            fail(ErrorCode::NotConnected, line);
        }
        const std::string text = line + "\n";
        const auto deadline = tiller::urrtde::within(kReplyTime);
        for (std::size_t at = 0; at < text.size();) {
            const auto sent = socket::send(
                descriptor,
                std::span(reinterpret_cast<const std::uint8_t*>(text.data()) + at, text.size() - at));
            at += sent.bytes;
            if (sent.status == Status::Failed || sent.status == Status::Closed) {
                fail(ErrorCode::ConnectionClosed, line);
            }
            if (deadline.hasExpired()) {
                fail(deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, line);
            }
        }
        return readReply(line, deadline);
    }

    // "ack" comes without a line end from the real URCap, other replies with one.
    std::string readReply(const std::string& line, const tiller::Deadline& deadline) {
        for (;;) {
            const std::size_t end = received.find('\n');
            if (end != std::string::npos || received == "ack") {
                std::string reply = received.substr(0, std::min(end, received.size()));
                received.erase(0, end == std::string::npos ? received.size() : end + 1);
                if (!reply.empty() && reply.back() == '\r') {
                    reply.pop_back();
                }
                if (reply.empty()) {
                    continue;
                }
                return reply;
            }
            std::uint8_t bytes[256];
            const auto got = socket::receive(descriptor, bytes);
            if (got.status == Status::Ok) {
                received.append(reinterpret_cast<const char*>(bytes), got.bytes);
            } else if (got.status != Status::WouldBlock) {
                fail(ErrorCode::ConnectionClosed, line);
            } else if (deadline.hasExpired()) {
                fail(deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, line);
            } else {
                socket::waitReadable(descriptor, deadline.nextPoll());
            }
        }
    }

    int get(const std::string& name) {
        const std::string reply = ask("GET " + name);
        const std::string prefix = name + " ";
        if (reply.compare(0, prefix.size(), prefix) != 0) {
            throw std::runtime_error("gripper: unexpected answer \"" + reply + "\" to GET " + name);
        }
        return std::stoi(reply.substr(prefix.size()));
    }

    bool set(const std::vector<std::pair<std::string, int>>& values) {
        std::string line = "SET";
        for (const auto& [name, value] : values) {
            line += " " + name + " " + std::to_string(value);
        }
        return ask(line) == "ack";
    }

    template <class Done>
    bool poll(milliseconds atMost, Done done) {
        const auto end = std::chrono::steady_clock::now() + atMost;
        while (!done()) {
            if (std::chrono::steady_clock::now() >= end) {
                return false;
            }
            tiller::urrtde::sleepUntil(std::chrono::steady_clock::now() + kPollEvery);
        }
        return true;
    }

    /// Position: 1 open ... 0 closed, seen from the user; device units rise towards closed.
    float fromDevice(eMoveParameter param, int device) const {
        const auto value = static_cast<float>(device);
        float part = value / kDeviceMaxReal;
        if (param == POSITION) {
            const auto span = static_cast<float>(std::max(maxPosition - minPosition, 1));
            part = std::clamp(1.0F - (value - static_cast<float>(minPosition)) / span, 0.0F, 1.0F);
        }
        switch (units[param]) {
            case UNIT_DEVICE:
                return value;
            case UNIT_NORMALIZED:
                return part;
            case UNIT_PERCENT:
                return part * 100.0F;
            case UNIT_MM:
                return part * static_cast<float>(range_mm);
        }
        return value;
    }

    float highest(eMoveParameter param) const {
        switch (units[param]) {
            case UNIT_DEVICE:
                return kDeviceMaxReal;
            case UNIT_NORMALIZED:
                return 1.0F;
            case UNIT_PERCENT:
                return 100.0F;
            case UNIT_MM:
                return static_cast<float>(range_mm);
        }
        return 1.0F;
    }

    /// Held to what the gripper can, as programs count on.
    int toDevice(eMoveParameter param, const char* name, float wanted) const {
        const double limit = std::numeric_limits<float>::max();
        check::number(name, static_cast<double>(wanted), -limit, limit);
        const float value = std::clamp(wanted, 0.0F, highest(param));
        if (units[param] == UNIT_DEVICE) {
            return static_cast<int>(std::lround(value));
        }
        const float part = value / highest(param);
        if (param != POSITION) {
            return static_cast<int>(std::lround(part * kDeviceMaxReal));
        }
        const auto span = static_cast<float>(maxPosition - minPosition);
        return minPosition + static_cast<int>(std::lround((1.0F - part) * span));
    }

    /// Returns when the gripper has taken the request: before that its status is that of an earlier one.
    void moveDevice(int position, int withSpeed, int withForce) {
        requested = std::clamp(position, 0, kDeviceMax);
        if (!set({{"POS", requested}, {"SPE", withSpeed}, {"FOR", withForce}, {"GTO", 1}}) ||
            !poll(kReplyTime, [this] { return get("PRE") == requested; })) {
            throw std::runtime_error("the gripper does not take the request to move");
        }
    }
};

RobotiqGripper::RobotiqGripper(const std::string& Hostname, int Port, bool verbose) {
    if (Hostname.empty()) {
        throw std::invalid_argument("Hostname is empty");
    }
    check::port("Port", Port);
    d_ = std::make_unique<Private>();
    d_->host = QString::fromStdString(Hostname);
    d_->port = Port;
    d_->verbose = verbose;
}

RobotiqGripper::~RobotiqGripper() {
    d_->close();
}

void RobotiqGripper::connect(uint32_t timeout_ms) {
    d_->close();
    const auto connected =
        tiller::connectTcp(d_->host, d_->port, tiller::urrtde::within(milliseconds(timeout_ms)));
    if (!connected) {
        tiller::urrtde::raise(connected.error());
    }
    d_->descriptor = *connected;
}

void RobotiqGripper::disconnect() {
    d_->close();
}

bool RobotiqGripper::isConnected() const {
    return d_->descriptor >= 0;
}

// ---- activation -----------------------------------------------------------------------------------------

void RobotiqGripper::activate(bool auto_calibrate) {
    if (!isActive()) {
        d_->set({{"ACT", 0}, {"ATR", 0}});
        if (!d_->poll(kReplyTime, [this] { return d_->get("ACT") == 0 && d_->get("STA") == RESET; })) {
            throw std::runtime_error("the gripper cannot be reset");
        }
        d_->set({{"ACT", 1}});
        if (!d_->poll(kActivationTime, [this] { return d_->get("ACT") == 1 && d_->get("STA") == ACTIVE; })) {
            throw std::runtime_error("the gripper does not become active");
        }
    }
    if (auto_calibrate) {
        autoCalibrate();
    }
}

bool RobotiqGripper::isActive() {
    return d_->get("STA") == ACTIVE;
}

void RobotiqGripper::autoCalibrate(float Speed) {
    constexpr int kGentle = 64;
    const int speed = Speed < 0 ? kGentle : d_->toDevice(SPEED, "Speed", Speed);
    const auto reach = [&](int position) {
        d_->moveDevice(position, speed, 1);
        const eObjectStatus status = waitForMotionComplete();
        if (status != AT_DEST && status != STOPPED_INNER_OBJECT && status != STOPPED_OUTER_OBJECT) {
            throw std::runtime_error("the gripper does not reach the end of its range");
        }
        return d_->get("POS");
    };
    reach(0);
    const int closed = reach(kDeviceMax);
    const int open = reach(0);
    setNativePositionRange(open, closed);
}

// ---- positions and moves --------------------------------------------------------------------------------

float RobotiqGripper::getOpenPosition() const {
    return d_->fromDevice(POSITION, d_->minPosition);
}

float RobotiqGripper::getClosedPosition() const {
    return d_->fromDevice(POSITION, d_->maxPosition);
}

float RobotiqGripper::getCurrentPosition() {
    return d_->fromDevice(POSITION, d_->get("POS"));
}

bool RobotiqGripper::isOpen() {
    return d_->get("POS") <= d_->minPosition;
}

bool RobotiqGripper::isClosed() {
    return d_->get("POS") >= d_->maxPosition;
}

int RobotiqGripper::move(float Position, float Speed, float Force, eMoveMode MoveMode) {
    const int position = d_->toDevice(POSITION, "Position", Position);
    const int speed = Speed < 0 ? d_->speed : d_->toDevice(SPEED, "Speed", Speed);
    const int force = Force < 0 ? d_->force : d_->toDevice(FORCE, "Force", Force);
    d_->moveDevice(position, speed, force);
    return MoveMode == WAIT_FINISHED ? waitForMotionComplete() : objectDetectionStatus();
}

int RobotiqGripper::open(float Speed, float Force, eMoveMode MoveMode) {
    return move(getOpenPosition(), Speed, Force, MoveMode);
}

int RobotiqGripper::close(float Speed, float Force, eMoveMode MoveMode) {
    return move(getClosedPosition(), Speed, Force, MoveMode);
}

void RobotiqGripper::emergencyRelease(ePostionId Direction, eMoveMode MoveMode) {
    constexpr milliseconds kBetween(100);
    d_->set({{"ATR", 0}});
    d_->set({{"ARD", Direction == OPEN ? 1 : 0}});
    d_->set({{"ACT", 1}});
    tiller::urrtde::sleepUntil(std::chrono::steady_clock::now() + kBetween);
    d_->set({{"ATR", 1}});
    const auto hasEnded = [this] { return faultStatus() == FAULT_EMCY_RELEASE_FINISHED; };
    const auto hasBegun = [&] { return faultStatus() == FAULT_EMCY_RELEASE_ACTIVE || hasEnded(); };
    if (!d_->poll(kReplyTime, hasBegun)) {
        throw std::runtime_error("the gripper's emergency release does not begin");
    }
    if (MoveMode == WAIT_FINISHED && !d_->poll(kMotionTime, hasEnded)) {
        throw std::runtime_error("the gripper's emergency release does not end");
    }
}

int RobotiqGripper::faultStatus() {
    return d_->get("FLT");
}

RobotiqGripper::eObjectStatus RobotiqGripper::objectDetectionStatus() {
    return static_cast<eObjectStatus>(d_->get("OBJ"));
}

RobotiqGripper::eObjectStatus RobotiqGripper::waitForMotionComplete() {
    eObjectStatus status = MOVING;
    d_->poll(kMotionTime, [&] {
        status = objectDetectionStatus();
        return status != MOVING;
    });
    return status;
}

// ---- units and presets ----------------------------------------------------------------------------------

void RobotiqGripper::setUnit(eMoveParameter Param, eUnit Unit) {
    if (Unit == UNIT_MM && Param != POSITION) {
        throw std::invalid_argument("Unit: only positions are in millimetres");
    }
    d_->units[Param] = Unit;
}

void RobotiqGripper::setPositionRange_mm(int Range) {
    check::integer("Range", Range, 1, 1000);
    d_->range_mm = Range;
}

float RobotiqGripper::setSpeed(float Speed) {
    d_->speed = d_->toDevice(SPEED, "Speed", std::clamp(Speed, 0.0F, d_->highest(SPEED)));
    return d_->fromDevice(SPEED, d_->speed);
}

float RobotiqGripper::setForce(float Force) {
    d_->force = d_->toDevice(FORCE, "Force", std::clamp(Force, 0.0F, d_->highest(FORCE)));
    return d_->fromDevice(FORCE, d_->force);
}

// ---- the URCap's variables ------------------------------------------------------------------------------

bool RobotiqGripper::setVars(const std::vector<std::pair<std::string, int>> Vars) {
    if (Vars.empty()) {
        throw std::invalid_argument("Vars is empty");
    }
    return d_->set(Vars);
}

bool RobotiqGripper::setVar(const std::string& Var, int Value) {
    return d_->set({{Var, Value}});
}

int RobotiqGripper::getVar(const std::string& var) {
    return d_->get(var);
}

std::vector<int> RobotiqGripper::getVars(const std::vector<std::string>& Vars) {
    std::vector<int> values;
    for (const std::string& name : Vars) {
        values.push_back(d_->get(name));
    }
    return values;
}

void RobotiqGripper::getNativePositionRange(int& MinPosition, int& MaxPosition) {
    MinPosition = d_->minPosition;
    MaxPosition = d_->maxPosition;
}

void RobotiqGripper::setNativePositionRange(int MinPosition, int MaxPosition) {
    check::integer("MinPosition", MinPosition, 0, kDeviceMax);
    check::integer("MaxPosition", MaxPosition, MinPosition + 1, kDeviceMax);
    d_->minPosition = MinPosition;
    d_->maxPosition = MaxPosition;
}

}  // namespace ur_rtde
