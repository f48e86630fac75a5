// SPDX-License-Identifier: MIT
#pragma once

// A controller with a simulated arm that behaves like a real one on the network: RTDE, primary, secondary,
// realtime and dashboard interfaces over TCP, and executed URScript. Clients need no changes.
//
// In real time it runs every control period on an absolute schedule. In virtual time its sockets are served
// continuously (so that a client can connect at any time), but robot time advances only with step(); together
// with waitForInputPackages() a test advances robot and client in lock-step, however slow the machine is.
//
// Apart from the sockets the only interface is the functions below, which correspond to actions on a real
// robot: of operators, buttons and cables.

#include <QString>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/core/text.h"
#include "robot/realtime/histogram.h"
#include "robot/simulator/arm/environment.h"
#include "robot/simulator/simulator_options.h"

namespace tiller::simulator {

using tiller::operator<<;  // for the enumerations below

/// The actual state of the simulated robot, for tests of what a client reports about it.
struct SimulatedState {
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

/// The newest RTDE data package that a client can read.
struct RtdeDelivery {
    std::uint16_t port = 0;  ///< of the client side of the connection
    double timestamp = 0;    ///< of the package [s]
};

/// Timing accuracy of a controller in real time since start() or resetTiming().
struct TickTiming {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;        ///< periods that started too late and were caught up
    std::uint64_t lost = 0;        ///< dropped periods: robot time was paused for them
    realtime::Histogram lateness;  ///< from the due time of a period to its actual start
    realtime::Histogram work;      ///< duration of the work of a period
    double threadSeconds = 0;      ///< processor time of the thread [s]; 0 if the system does not report it
    double seconds = 0;            ///< elapsed time [s]
    bool priorityGranted = false;
};

/// One thread, owned by this object, between start() and stop(); priority as in the options. All calls are
/// passed to it through a queue that it processes between control periods.
class Simulator {
public:
    explicit Simulator(const SimulatorOptions& options = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Opens all ports and starts.
    /// Errors   AddressInvalid; Rejected when a port is in use, naming port, address and a solution
    /// Threads  any, not at the same time as stop(). Blocks: until all ports accept connections
    ///
    /// Sockets of Qt require an application object. If there is none, this function creates one that exists
    /// until the process exits; a program that creates its own must do so before. In a thread other than the
    /// one that loaded the library, Qt prints a warning about it, which concerns only widgets.
    Result<void> start();
    /// Ends the thread and closes every connection. Has no effect when not running.
    void stop();
    bool isRunning() const;  ///< Between start() and stop().

    Ports ports() const;                      ///< Ports in use; 0 before start().
    QString listenAddress() const;            ///< As in the options.
    const SimulatorOptions& options() const;  ///< As passed to the constructor.
    /// Time of one step [s].
    double stepTime() const;

    // ---- time, in virtual mode --------------------------------------------------------------------------

    /// Advances time by whole control periods. Returns when all data of the last one have been passed to the
    /// sockets. Does nothing in real time.
    /// Threads  any. Blocks: while stepping
    void step(int ticks = 1);
    void stepSeconds(double seconds);  ///< [s], rounded to whole periods
    /// Runs one period and then, without advancing time, reads until an input package has arrived for each
    /// data package sent, no client is connected over RTDE, or the deadline has expired. Returns false when
    /// answers are missing
    bool stepAnswered(const Deadline& deadline);
    /// Reads all received data and answers requests, without advancing time.
    void drainSockets();
    /// RTDE input packages accepted since start(), of all clients.
    std::uint64_t inputPackages() const;
    /// RTDE data packages passed to sockets since start(), of all clients.
    std::uint64_t outputPackages() const;
    /// Reads until this number of input packages has arrived or the deadline has expired.
    /// Returns  true if they have arrived
    bool waitForInputPackages(std::uint64_t total, const Deadline& deadline);
    /// The newest package that each RTDE client can read since the last step(). Clients without a new package
    /// are omitted.
    std::vector<RtdeDelivery> rtdeDeliveries() const;
    /// True if no link fault is set that delays, splits or holds back data.
    bool isLinkPlain() const;
    /// Number of clients connected to the RTDE port.
    int rtdeClients() const;

    /// Threads  any. Consistent within one control period
    SimulatedState truth() const;

    /// Threads  any. Blocks: up to one control period
    TickTiming timing();
    void resetTiming();  ///< Restarts the measurement.

    // ---- hooks: each takes effect in the next control period; none waits -------------------------------

    void protectiveStop();                          ///< As after a collision.
    void emergencyStop(bool pressed);               ///< the pendant's button
    void systemEmergencyStop(bool active);          ///< the external input
    void safeguardStop(bool open);                  ///< The external input.
    void reducedMode(bool active);                  ///< The external input.
    void violation();                               ///< Of the safety system.
    void fault();                                   ///< Of the safety system.
    void setDigitalInput(int number, bool value);   ///< 0-7 standard, 8-15 configurable, 16-17 tool
    void setAnalogInput(int number, double value);  ///< 0, 1 [A or V]; 2, 3 are the tool's
    void setRemoteControl(bool remote);             ///< The switch on the pendant.
    void pressFreedriveButton(bool pressed);        ///< On the back of the pendant.
    /// A hand pushes the tool; zero ends it. wrench  [N, Nm] at the TCP, base frame
    void pressHand(const Wrench& wrench);
    /// Changes the surroundings of the arm: surfaces, boxes, the actual load, a hand, conveyors. `change` runs in
    /// the thread of the simulator.
    void changeWorld(std::function<void(arm::Environment&)> change);
    void setSpeedSlider(double fraction);  ///< 0 ... 1, on the pendant
    /// Answers the oldest request_..._from_primary_client() call with a value of its type: bool,
    /// std::int32_t, double or std::string. Other types are ignored.
    void answerRequest(const std::variant<bool, std::int32_t, double, std::string>& answer);
    /// Injects a fault by its command, see faults.h: "link lost", "delay 20 5".
    /// Returns  the requested value, usually empty
    /// Errors   InvalidArgument with the reason; NotConnected when not running
    /// Threads  any. Blocks: until it is done
    Result<QString> inject(const Text& words);
    /// Simulates an unresponsive controller: time advances, but nothing is sent or read, and connections stay
    /// open.
    void silence(bool silent);
    /// Closes every connection gracefully, as a restarting controller does. Ports stay open.
    void closeClients();

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
