// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/robotiq_gripper.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <thread>

#include "robot/io/robotiq_client.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

namespace {

using std::chrono::milliseconds;
using tiller::ErrorCode;
namespace check = tiller::urrtde::check;

constexpr milliseconds kGripperReplyTime(2000);
constexpr milliseconds kActivationTime(15000);
constexpr milliseconds kMotionTime(30000);
constexpr milliseconds kPollEvery(10);
constexpr int kDeviceMax = 255;
constexpr float kDeviceMaxReal = 255.0F;

}  // namespace

struct RobotiqGripper::Private {
    Private(const std::string& host, int port) : client(host, port) {}

    tiller::io::RobotiqClient client;

    int minPosition = 0;           ///< open end position, in device units
    int maxPosition = kDeviceMax;  ///< closed end position
    int range_mm = 40;             ///< stroke
    eUnit units[3] = {UNIT_NORMALIZED, UNIT_NORMALIZED, UNIT_NORMALIZED};
    int speed = kDeviceMax;  ///< speed preset, in device units
    int force = 0;           ///< force preset, in device units; 0: minimum force
    int requested = 0;       ///< last commanded position, in device units

    int get(const std::string& name) {
        const auto value = client.get(name, tiller::urrtde::within(kGripperReplyTime));
        if (!value && value.error().code == ErrorCode::ProtocolError) {
            throw std::runtime_error("gripper: unexpected reply \"" +
                                     value.error().controllerMessage.toStdString() + "\" to GET " + name);
        }
        if (!value) {
            tiller::urrtde::raise(value.error());
        }
        if (!value->has_value()) {
            throw std::invalid_argument("gripper: no value for " + name);
        }
        return **value;
    }

    bool set(const std::vector<std::pair<std::string, int>>& values) {
        const auto done = client.set(values, tiller::urrtde::within(kGripperReplyTime));
        if (!done && done.error().code != ErrorCode::Rejected) {
            tiller::urrtde::raise(done.error());
        }
        return done.ok();
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

    /// User positions: 1 (open) ... 0 (closed). Device units increase towards closed.
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

    /// Clamped to the range of the gripper, as in ur_rtde.
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

    /// Returns when the gripper has accepted the request. Until then, the status is that of the previous
    /// motion.
    void moveDevice(int position, int withSpeed, int withForce) {
        requested = std::clamp(position, 0, kDeviceMax);
        if (!set({{"POS", requested}, {"SPE", withSpeed}, {"FOR", withForce}, {"GTO", 1}}) ||
            !poll(kGripperReplyTime, [this] { return get("PRE") == requested; })) {
            throw std::runtime_error("the gripper did not accept the move request");
        }
    }
};

RobotiqGripper::RobotiqGripper(const std::string& Hostname, int Port, bool /*verbose*/) {
    if (Hostname.empty()) {
        throw std::invalid_argument("Hostname is empty");
    }
    check::port("Port", Port);
    d_ = std::make_unique<Private>(Hostname, Port);
}

RobotiqGripper::~RobotiqGripper() = default;

void RobotiqGripper::connect(uint32_t timeout_ms) {
    const auto connected = d_->client.connect(tiller::urrtde::within(milliseconds(timeout_ms)));
    if (!connected) {
        tiller::urrtde::raise(connected.error());
    }
}

void RobotiqGripper::disconnect() {
    d_->client.close();
}

bool RobotiqGripper::isConnected() const {
    return d_->client.isConnected();
}

// ---- activation -----------------------------------------------------------------------------------------

void RobotiqGripper::activate(bool auto_calibrate) {
    if (!isActive()) {
        d_->set({{"ACT", 0}, {"ATR", 0}});
        if (!d_->poll(kGripperReplyTime, [this] { return d_->get("ACT") == 0 && d_->get("STA") == RESET; })) {
            throw std::runtime_error("the gripper could not be reset");
        }
        d_->set({{"ACT", 1}});
        if (!d_->poll(kActivationTime, [this] { return d_->get("ACT") == 1 && d_->get("STA") == ACTIVE; })) {
            throw std::runtime_error("the gripper did not become active");
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
            throw std::runtime_error("the gripper did not reach the end of its range");
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
    if (!d_->poll(kGripperReplyTime, hasBegun)) {
        throw std::runtime_error("the gripper's emergency release did not start");
    }
    if (MoveMode == WAIT_FINISHED && !d_->poll(kMotionTime, hasEnded)) {
        throw std::runtime_error("the gripper's emergency release did not end");
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
        throw std::invalid_argument("Unit: UNIT_MM is valid only for positions");
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
