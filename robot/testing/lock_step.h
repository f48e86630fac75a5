// SPDX-License-Identifier: MIT
#pragma once

// For testing robot programs: a simulated robot in virtual time, with receivers and controllers that follow
// its clock in lock-step. Sockets, threads and the control program are real; only the time is simulated. A
// test runs as fast as the machine permits and has the same result on a slow machine. examples/cpp/testing
// contains fixtures for GoogleTest, Catch2 and Qt Test.
//
//     virtual_time::LockStep bench;
//     bench.start().value();
//     const auto controller = bench.makeController();
//     bench.whileTimePasses([&] { return controller->takeControl(Deadline::after(60s)); }).value();
//     const auto move = control::Motions(*controller).moveJ(target);
//     bench.step(0.5);                                  // half a second of the robot's time
//     bench.robot().inject("protective-stop").value();
//     bench.step(0.1);
//     move->wait(Deadline::after(0s)).error();          // UnsafeState

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/control/controller.h"
#include "robot/core/clock.h"
#include "robot/receive/receiver.h"
#include "robot/simulator/simulator.h"

namespace tiller::virtual_time {

/// Owns the simulated robot and its clock. Both must outlive all objects that use the clock, so declare such
/// objects after this one. While a Flow exists, this object also owns a thread that advances the time.
/// Threads  any, unless stated otherwise
class LockStep {
public:
    /// A UR5e with released brakes, at a loopback address that is unique on this machine.
    static simulator::SimulatorOptions defaultOptions();
    /// options  the time mode is set to Virtual
    explicit LockStep(simulator::SimulatorOptions options = defaultOptions());
    ~LockStep();
    LockStep(const LockStep&) = delete;
    LockStep& operator=(const LockStep&) = delete;

    /// Errors  as for Simulator::start()
    Result<void> start();
    void stop();  ///< Stops the robot and closes all connections. No effect if it is not running.

    simulator::Simulator& robot() { return robot_; }  ///< For faults, inputs and the actual state.
    const simulator::Simulator& robot() const { return robot_; }           ///< See the other robot().
    const std::shared_ptr<VirtualClock>& clock() const { return clock_; }  ///< For the caller's objects.

    /// Creates and starts a receiver of this robot that uses its clock.
    /// options  host, port and clock are overwritten
    std::shared_ptr<receive::Receiver> makeReceiver(receive::ReceiverOptions options = {});
    /// Creates a controller of this robot that uses its clock.
    /// options  host, port offset and clock are overwritten
    std::shared_ptr<control::Controller> makeController(control::ControllerOptions options = {});
    /// Makes tick() and step() wait for an object that the caller created with clock(). Destroyed objects are
    /// removed automatically.
    void follow(std::weak_ptr<const receive::Receiver> receiver);
    void follow(std::weak_ptr<const control::Controller> controller);  ///< See the other follow().

    /// Advances the time by one control period. When the function returns, each receiver and controller that
    /// follows the clock has processed the data that reached it, and each controller in control has answered.
    /// The function does not wait for data that an injected connection fault delays.
    void tick();
    void step(double seconds);  ///< Advances the time [s], rounded to control periods.
    /// Steps until the condition is true, for at most this time [s].
    /// Returns  true if the condition is true
    bool stepUntil(const std::function<bool()>& condition, double atMost);

    /// Advances the time in a separate thread while an object of this class exists. Use it for calls that
    /// wait for the robot.
    class Flow {
    public:
        explicit Flow(LockStep& bench) : bench_(bench) { bench_.beginFlow(); }
        ~Flow() { bench_.endFlow(); }
        Flow(const Flow&) = delete;
        Flow& operator=(const Flow&) = delete;

    private:
        LockStep& bench_;
    };
    /// Makes a call that waits for the robot, advances the time meanwhile, and returns the result of the
    /// call.
    template <class Call>
    auto whileTimePasses(Call call) {
        const Flow flow(*this);
        return call();
    }
    void beginFlow();  ///< Same as creating a Flow. Each call requires an endFlow().
    void endFlow();    ///< Blocks until the time has stopped, unless other flows exist.

private:
    struct Ticking {
        std::thread thread;
        std::shared_ptr<std::atomic<bool>> ends;
    };

    std::shared_ptr<VirtualClock> clock_ = std::make_shared<VirtualClock>();
    simulator::Simulator robot_;
    std::mutex stepping_;
    std::mutex followersMutex_;
    std::vector<std::weak_ptr<const receive::Receiver>> receivers_;
    std::vector<std::weak_ptr<const control::Controller>> controllers_;
    std::atomic<bool> ending_{false};
    std::mutex flowMutex_;
    int flows_ = 0;
    Ticking ticking_;
};

}  // namespace tiller::virtual_time
