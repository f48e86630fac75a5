// SPDX-License-Identifier: MIT
#pragma once

// A controller with a simulated arm, which speaks to the world as a real one does: RTDE, primary, secondary,
// realtime and dashboard over TCP, and URScript that is really executed. Clients need not know.
//
// In real time it steps every control period on an absolute schedule. In virtual time its sockets are served
// all the time (so that a client may connect and shake hands whenever it likes), but the robot stands still
// in time until step() is called; together with waitForInputPackages() a test moves robot and client on in
// lock-step, however slow the machine is.
//
// Besides the sockets there are only the hooks below: what on a real robot is a hand, a button or a cable.

#include <QString>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "robot/core/deadline.h"
#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"
#include "robot/core/version.h"
#include "robot/realtime/histogram.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/assumptions.h"

namespace tiller::simulator {

using tiller::operator<<;  // for the enumerations below

enum class Time { Real, Virtual };

/// The start pose of the vendor's simulated UR5e [rad]. Source: its first primary package.
inline const JointPositions kHomeJoints{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

struct SimulatorOptions {
    RobotModelId model = RobotModelId::UR5e;
    SoftwareVersion software{5, 22, 1, 1214193};
    Text listenAddress = QStringLiteral("127.0.0.1");
    int portOffset = 0;         ///< added to every standard port
    bool anyFreePorts = false;  ///< the system picks the ports; ask ports() after start()
    Time time = Time::Real;
    bool poweredOn = false;  ///< start with the brakes released, in RUNNING
    JointPositions startJoints = kHomeJoints;
    std::optional<int> priority;  ///< SCHED_FIFO priority wished for the thread; none: normal
    std::uint64_t seed = 1;       ///< of measurement noise and of the scripts' random()
    bool remoteControl = true;    ///< the pendant's Local/Remote switch
    bool gateLocalControl =
        false;  ///< refuse what a robot in Local refuses (the vendor's simulator does not)
    bool gateLoopbackClients = false;  ///< refuse dashboard clients on this machine too
    bool fastTransitions = false;      ///< power on and brake release within a few control periods
    double startTime = 60.0;  ///< `timestamp` at start [s]; below 40 some clients wait for the boot to end
    double bootTime = 0;      ///< [s] from the start to POWER_OFF; more than 0 makes `timestamp` begin at 0
    bool safetyUnconfirmed = false;  ///< the start waits in CONFIRM_SAFETY for the operator
    double calibrationError = 0;     ///< the reported kinematics differ by up to so many mm and mrad
    Text programsFolder;             ///< where `load` finds programs; empty: there are none
    Text serialNumber;               ///< empty: one of its own for each model
    /// A pause this long after its last piece ends the script of an External Control node.
    std::chrono::milliseconds scriptSilence{150};
    Assumptions assumptions;  ///< how it behaves where it is not known how a real one does
};

/// Port numbers in use; 0 before start(), and for a service that this software does not have.
struct Ports {
    std::uint16_t dashboard = 29999;
    std::uint16_t primary = 30001;
    std::uint16_t secondary = 30002;
    std::uint16_t realtime = 30003;
    std::uint16_t rtde = 30004;
    std::uint16_t primaryReadOnly = 30011;
    std::uint16_t secondaryReadOnly = 30012;
    std::uint16_t realtimeReadOnly = 30013;
    std::uint16_t interpreter = 30020;  ///< 0 on software that has no interpreter mode
    std::uint16_t robotApi = 80;        ///< HTTP, PolyScope X only; 8080 where the system keeps 80 to itself
    std::uint16_t gripper = 63352;      ///< of Robotiq
    std::uint16_t faults = 29990;       ///< faults on demand, see faults.h

    static constexpr Ports none() { return {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}; }
};

/// What the simulated robot is really doing, for tests that check what a client made of it.
struct Truth {
    std::uint64_t tick = 0;
    double timestamp = 0;  ///< [s]
    RobotMode robotMode = RobotMode::PowerOff;
    SafetyMode safetyMode = SafetyMode::Normal;
    RuntimeState runtimeState = RuntimeState::Stopped;
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Twist tcpSpeed;
    double speedSlider = 1;
    std::uint64_t digitalOutputs = 0;
};

/// How regularly a controller in real time kept its periods since start() or resetTiming().
struct TickTiming {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;        ///< periods that were over before their turn came, and were made up for
    std::uint64_t lost = 0;        ///< periods dropped for good: the robot's time stood still for them
    realtime::Histogram lateness;  ///< from when a period was due to when its work began
    realtime::Histogram work;      ///< what the work of a period took
    double threadSeconds = 0;      ///< processor time of the thread [s]; 0 where the system cannot tell
    double seconds = 0;            ///< time passed [s]
    bool priorityGranted = false;
};

/// One thread, owned by this object, between start() and stop(); priority as in the options. Everything
/// crosses into it through a queue that it empties between control periods.
class Simulator {
public:
    explicit Simulator(const SimulatorOptions& options = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Opens all ports and begins.
    /// Errors   AddressInvalid; Rejected when a port is in use, naming port and address and what to do
    /// Threads  any, not at once with stop(). Blocks: until all ports accept
    Result<void> start();
    /// Ends the thread and closes every connection. Harmless when not running.
    void stop();
    bool isRunning() const;

    Ports ports() const;
    QString listenAddress() const;
    const SimulatorOptions& options() const;
    /// Time of one step [s].
    double stepTime() const;

    // ---- time, in virtual mode --------------------------------------------------------------------------

    /// Moves time on by whole control periods. Returns when all data of the last one have been handed to the
    /// sockets. Does nothing in real time.
    /// Threads  any. Blocks: while stepping
    void step(int ticks = 1);
    void stepSeconds(double seconds);
    /// One period, and then, without moving time on, reads until there is an input package for each data
    /// package that was sent, or nobody is connected to RTDE any more, or the deadline is over. Returns false
    /// when answers are missing
    bool stepAnswered(const Deadline& deadline);
    /// Reads everything that has arrived and answers requests, without moving time on.
    void drainSockets();
    /// RTDE input packages accepted since start(), of all clients.
    std::uint64_t inputPackages() const;
    /// RTDE data packages handed to sockets since start(), of all clients.
    std::uint64_t outputPackages() const;
    /// Reads until so many input packages have come, or the deadline is over.
    /// Returns  true when they have
    bool waitForInputPackages(std::uint64_t total, const Deadline& deadline);
    /// Clients connected to the RTDE port now.
    int rtdeClients() const;

    /// Threads  any. Consistent within one control period
    Truth truth() const;

    /// Threads  any. Blocks: up to one control period
    TickTiming timing();
    void resetTiming();

    // ---- hooks: each takes effect in the next control period; none waits -------------------------------

    void protectiveStop();
    void emergencyStop(bool pressed);       ///< the pendant's button
    void systemEmergencyStop(bool active);  ///< the external input
    void safeguardStop(bool open);
    void reducedMode(bool active);
    void violation();
    void fault();
    void setDigitalInput(int number, bool value);   ///< 0-7 standard, 8-15 configurable, 16-17 tool
    void setAnalogInput(int number, double value);  ///< 0, 1 [A or V]; 2, 3 are the tool's
    void setRemoteControl(bool remote);
    void pressFreedriveButton(bool pressed);
    /// A hand on the tool; zero lets go. wrench  [N, Nm] at the TCP, base frame
    void pressHand(const Wrench& wrench);
    /// Changes what is around the arm: surfaces, boxes, the load really carried, a hand, conveyors. `change`
    /// runs in the simulator's thread.
    void changeWorld(std::function<void(arm::Environment&)> change);
    void setSpeedSlider(double fraction);
    /// Answers the oldest question of request_..._from_primary_client() with a value of its type: bool,
    /// std::int32_t, double or std::string. Others are ignored.
    void answerRequest(const std::variant<bool, std::int32_t, double, std::string>& answer);
    /// Any of these and every other fault by its words, see faults.h: "link lost", "delay 20 5".
    /// Returns  what was asked for, usually nothing
    /// Errors   InvalidArgument with the reason; NotConnected when not running
    /// Threads  any. Blocks: until it is done
    Result<QString> inject(const Text& words);
    /// A mute controller: time goes on, nothing is sent, nothing is read, connections stay.
    void silence(bool silent);
    /// Ends every connection in good order, as a restarting controller does. Ports stay open.
    void closeClients();

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
