// SPDX-License-Identifier: MIT
#pragma once

// A controller with a simulated arm that behaves like a real controller on the network: RTDE, primary,
// secondary, realtime and dashboard interfaces over TCP, and execution of URScript. Clients need no changes.
//
// In real time, the simulator runs every control period on an absolute schedule. In virtual time, robot time
// advances only with step(), but the sockets are served continuously, so that clients can connect at any
// time. With step() and waitForInputPackages(), a test advances robot and client in lock-step, independently
// of the speed of the machine.
//
// Apart from the sockets, a program controls the simulator only through the functions below. They correspond
// to physical actions on a real robot: operator actions, buttons and cables.

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
#include "robot/simulator/options/simulator_options.h"

namespace tiller::simulator {

using tiller::operator<<;  // makes the enumerations below printable

/// The actual state of the simulated robot, to compare with the state reported by a client.
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

/// Timing accuracy in real-time mode since start() or resetTiming().
struct TickTiming {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;        ///< periods that started late and were caught up
    std::uint64_t lost = 0;        ///< dropped periods, for which robot time was paused
    realtime::Histogram lateness;  ///< delay from the due time of a period to its actual start
    realtime::Histogram work;      ///< processing time of a period
    double threadSeconds = 0;      ///< processor time of the thread [s]; 0 if the system does not report it
    double seconds = 0;            ///< elapsed time [s]
    bool priorityGranted = false;
};

/// Runs the simulator thread between start() and stop(), with the priority given in the options. Calls are
/// queued and processed by the thread between control periods.
class Simulator {
public:
    explicit Simulator(const SimulatorOptions& options = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Opens all ports and starts.
    /// Errors   AddressInvalid; Rejected if a port is in use, naming the port, the address and a solution
    /// Threads  any, but not concurrently with stop(). Blocks: until all ports accept connections
    ///
    /// Qt sockets require an application object. If the process has none, this function creates one that
    /// exists until the process exits. A program that creates its own application object must do so before
    /// calling this function. If start() is called from a thread other than the one that loaded the library,
    /// Qt prints a warning about the application object. The warning concerns only widgets.
    Result<void> start();
    /// Stops the thread and closes every connection. No effect if the simulator is not running.
    void stop();
    bool isRunning() const;  ///< True between start() and stop().

    Ports ports() const;                      ///< Ports in use; 0 before start().
    QString listenAddress() const;            ///< As in the options.
    const SimulatorOptions& options() const;  ///< As passed to the constructor.
    /// Time of one step [s].
    double stepTime() const;

    // ---- time, in virtual mode --------------------------------------------------------------------------

    /// Advances time by whole control periods. Returns when all data of the last period have been passed to
    /// the sockets. Does nothing in real time.
    /// Threads  any. Blocks: while stepping
    void step(int ticks = 1);
    void stepSeconds(double seconds);  ///< Advances time by `seconds` [s], rounded to whole periods.
    /// Runs one period. Then, without advancing time, reads until as many input packages have arrived as data
    /// packages were sent in this period, no client is connected over RTDE, or the deadline has expired. Does
    /// nothing in real time.
    /// Returns  false if input packages are missing
    bool stepAnswered(const Deadline& deadline);
    /// Reads all received data and replies to requests, without advancing time.
    void drainSockets();
    /// Number of RTDE input packages accepted from all clients since start().
    std::uint64_t inputPackages() const;
    /// Number of RTDE data packages passed to the sockets of all clients since start().
    std::uint64_t outputPackages() const;
    /// Reads until inputPackages() has reached `total` or the deadline has expired.
    /// Returns  true if the number was reached
    bool waitForInputPackages(std::uint64_t total, const Deadline& deadline);
    /// For each RTDE client, the newest data package that the client could read at the end of the last
    /// step(). Clients that have not received a package are omitted. Empty in real time.
    std::vector<RtdeDelivery> rtdeDeliveries() const;
    /// True if no link fault that delays, splits or holds back data is active.
    bool isLinkPlain() const;
    /// Number of clients connected to the RTDE port.
    int rtdeClients() const;

    /// Threads  any. Consistent within one control period
    SimulatedState truth() const;

    /// Threads  any. Blocks: up to one control period
    TickTiming timing();
    void resetTiming();  ///< Restarts the measurement.

    // ---- hooks: each takes effect in the next control period; no function blocks ------------------------

    void protectiveStop();                          ///< Same reaction as to a collision.
    void emergencyStop(bool pressed);               ///< Emergency stop button of the teach pendant.
    void systemEmergencyStop(bool active);          ///< External emergency stop input.
    void safeguardStop(bool open);                  ///< External safeguard input.
    void reducedMode(bool active);                  ///< External reduced mode input.
    void violation();                               ///< Violation reported by the safety system.
    void fault();                                   ///< Fault reported by the safety system.
    void setDigitalInput(int number, bool value);   ///< 0-7 standard, 8-15 configurable, 16-17 tool
    void setAnalogInput(int number, double value);  ///< 0, 1: control box [A or V]; 2, 3: tool
    void setRemoteControl(bool remote);             ///< Local/Remote switch of the teach pendant.
    void pressFreedriveButton(bool pressed);        ///< Freedrive button on the back of the teach pendant.
    /// Simulates a hand that pushes the tool; zero ends the push.
    /// wrench  [N, Nm] at the TCP, base frame
    void pressHand(const Wrench& wrench);
    /// Changes the environment of the arm: surfaces, boxes, the actual load, a hand, conveyors. `change` runs
    /// in the simulator thread.
    void changeWorld(std::function<void(arm::Environment&)> change);
    void setSpeedSlider(double fraction);  ///< Speed slider of the teach pendant, 0 ... 1.
    /// Answers the oldest call of request_..._from_primary_client() with a value of the requested type: bool,
    /// std::int32_t, double or std::string. Values of other types are ignored.
    void answerRequest(const std::variant<bool, std::int32_t, double, std::string>& answer);
    /// Injects a fault with a command from faults.h, e.g. "link lost" or "delay 20 5".
    /// Returns  the requested value, usually empty
    /// Errors   InvalidArgument with the reason; NotConnected if the simulator is not running
    /// Threads  any. Blocks: until the command has been executed
    Result<QString> inject(const Text& words);
    /// Simulates an unresponsive controller. Time advances, but no data are sent or read. Connections stay
    /// open.
    void silence(bool silent);
    /// Closes every connection gracefully, like a controller that restarts. Ports stay open.
    void closeClients();

private:
    class Impl;
    std::unique_ptr<Impl> d_;
};

}  // namespace tiller::simulator
