// SPDX-License-Identifier: MIT
#pragma once

// For tests of programs: a simulated robot in virtual time, with receivers and controllers that follow its clock in lock-step.
// Real sockets, real threads and the real control program, but no real time: a test runs as fast as the machine can, and
// gives the same result on a slow one. examples/cpp/testing has fixtures for GoogleTest, Catch2 and Qt Test.
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

/// Owns the simulated robot and its clock, which have to outlive what follows them: members that are declared after this
/// one do. While a Flow exists, it owns a thread that moves time on.
/// Threads  any, unless said otherwise
class LockStep {
public:
    /// A UR5e with its brakes released, at a loopback address that no other LockStep of this machine uses.
    static simulator::SimulatorOptions defaultOptions();
    /// options  time is always virtual
    explicit LockStep(simulator::SimulatorOptions options = defaultOptions());
    ~LockStep();
    LockStep(const LockStep&) = delete;
    LockStep& operator=(const LockStep&) = delete;

    /// Errors  as Simulator::start()
    Result<void> start();
    void stop();  ///< Ends the robot and every connection; harmless when it does not run.

    simulator::Simulator& robot() { return robot_; }  ///< For faults, inputs and its actual state.
    const simulator::Simulator& robot() const { return robot_; }           ///< The same.
    const std::shared_ptr<VirtualClock>& clock() const { return clock_; }  ///< For objects made elsewhere.

    /// A receiver of this robot, started, by its clock. options  host, port and clock are set here
    std::shared_ptr<receive::Receiver> makeReceiver(receive::ReceiverOptions options = {});
    /// A controller of this robot, by its clock. options  host, port offset and clock are set here
    std::shared_ptr<control::Controller> makeController(control::ControllerOptions options = {});
    /// Has step() wait for one that was made elsewhere with clock(). What has been destroyed is forgotten.
    void follow(std::weak_ptr<const receive::Receiver> receiver);
    void follow(std::weak_ptr<const control::Controller> controller);  ///< The same.

    /// One control period. When it returns, each receiver and controller that follows has taken in what reached it, and who
    /// is in control has answered. What a fault of the link holds back is not waited for.
    void tick();
    void step(double seconds);  ///< [s], in whole control periods
    /// Steps until the condition holds, for at most so long [s]. Returns  whether it does
    bool stepUntil(const std::function<bool()>& condition, double atMost);

    /// Moves time on in a thread of its own while one exists: around calls that wait for the robot.
    class Flow {
    public:
        explicit Flow(LockStep& bench) : bench_(bench) { bench_.beginFlow(); }
        ~Flow() { bench_.endFlow(); }
        Flow(const Flow&) = delete;
        Flow& operator=(const Flow&) = delete;

    private:
        LockStep& bench_;
    };
    /// The result of a call that waits for the robot; time moves on meanwhile.
    template <class Call>
    auto whileTimePasses(Call call) {
        const Flow flow(*this);
        return call();
    }
    void beginFlow();  ///< As a Flow; each call needs an endFlow().
    void endFlow();    ///< Blocks: until time is at standstill, unless other flows go on.

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
