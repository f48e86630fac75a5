// SPDX-License-Identifier: MIT
// Part of tiller._native: the simulated controller in this process.
#include <algorithm>
#include <thread>

#include "robot/python/native_objects.h"
#include "robot/simulator/box/personality.h"
#include "robot/simulator/simulator.h"

namespace tiller::python {

namespace {

/// The robot and, in virtual time, the clock that it shares with its clients.
class NativeSimulator : public ProcessOwned {
public:
    explicit NativeSimulator(const simulator::SimulatorOptions& options)
        : clock_(options.time == simulator::Time::Virtual ? std::make_shared<VirtualClock>() : nullptr)
        , robot(options) {}
    ~NativeSimulator() { robot.stop(); }

    SharedClock clock() const { return clock_; }
    void follow(const std::shared_ptr<NativeReceiver>& receiver) { receivers_.push_back(receiver); }
    void follow(const std::shared_ptr<NativeController>& controller) { controllers_.push_back(controller); }

    /// Advances the robot and all users of its clock by one control period: on return, all clients have processed
    /// the packet, and the controlling one has answered.
    void tick() {
        const auto receivers = living(receivers_);
        const auto controllers = living(controllers_);
        struct Awaited {
            receive::Receiver* receiver;
            std::uint64_t packets;
        };
        std::vector<Awaited> awaited;
        for (const auto& receiver : receivers) {
            if (receiver->receiver.state() == receive::ReceiverState::Receiving) {
                awaited.push_back({&receiver->receiver, receiver->receiver.counters().packets});
            }
        }
        // Also one whose data were late: it answers the packet that ends this.
        const auto isAnswering = [](const auto& controller) {
            const control::ControllerStatus status = controller->controller.status();
            return status.inControl || status.loss == control::ControlLoss::DataStale;
        };
        const auto answering =
            static_cast<std::uint64_t>(std::count_if(controllers.begin(), controllers.end(), isAnswering));
        const std::uint64_t inputs = robot.inputPackages();
        clock_->advanceNs(static_cast<std::int64_t>(robot.stepTime() * 1e9));
        robot.step();
        // In real time and with a limit: a stopped client does not answer.
        const auto end = std::chrono::steady_clock::now() + kPatience;
        const auto isPatient = [end] { return std::chrono::steady_clock::now() < end; };
        for (const Awaited& one : awaited) {
            while (one.receiver->counters().packets == one.packets &&
                   one.receiver->state() == receive::ReceiverState::Receiving && isPatient()) {
                std::this_thread::yield();
            }
        }
        const auto someAnswer = [&] {
            return std::any_of(controllers.begin(), controllers.end(), isAnswering);
        };
        while (
            answering > 0 && someAnswer() && isPatient() &&
            !robot.waitForInputPackages(inputs + answering, Deadline::after(std::chrono::milliseconds(20)))) {
        }
        // A client that is connecting needs an answer although no time passes.
        robot.drainSockets();
    }

    void step(double seconds) {
        const int ticks = static_cast<int>(std::lround(seconds / robot.stepTime()));
        for (int i = 0; i < ticks && !isEnding; ++i) {
            tick();
        }
    }

private:
    static constexpr std::chrono::milliseconds kPatience{500};

    template <class T>
    static std::vector<std::shared_ptr<T>> living(std::vector<std::weak_ptr<T>>& all) {
        std::vector<std::shared_ptr<T>> there;
        std::erase_if(all, [](const auto& one) { return one.expired(); });
        for (const auto& one : all) {
            if (auto held = one.lock()) {
                there.push_back(std::move(held));
            }
        }
        return there;
    }

    std::shared_ptr<VirtualClock> clock_;
    std::vector<std::weak_ptr<NativeReceiver>> receivers_;
    std::vector<std::weak_ptr<NativeController>> controllers_;

public:
    simulator::Simulator robot;
    std::atomic<bool> isEnding{false};
};

py::dict truthDict(const NativeSimulator& self) {
    const simulator::Truth truth = self.robot.truth();
    const auto array = [](const Six& v) { return py::array_t<double>(6, v.data()); };
    py::dict result;
    result["timestamp"] = truth.timestamp;
    result["robot_mode"] = toString(truth.robotMode);
    result["safety_mode"] = toString(truth.safetyMode);
    result["runtime_state"] = toString(truth.runtimeState);
    result["q"] = array(truth.q.array());
    result["qd"] = array(truth.qd.array());
    result["tcp_pose"] = array(truth.tcpPose.array());
    const Vector6 speed = truth.tcpSpeed.vector();
    result["tcp_speed"] = py::array_t<double>(6, speed.data());
    result["speed_slider"] = truth.speedSlider;
    result["digital_outputs"] = truth.digitalOutputs;
    return result;
}

}  // namespace

void defineSimulator(py::module_& module) {
    using Released = py::call_guard<WaitingCall>;
    py::class_<NativeSimulator, std::shared_ptr<NativeSimulator>>(module, "Simulator")
        .def(py::init([](const std::string& model, const std::string& software, const std::string& address,
                         bool inVirtualTime, bool poweredOn, const std::optional<Six>& start,
                         bool remoteControl, const std::string& programs, int priority) {
                 simulator::SimulatorOptions options;
                 options.model = modelNamed(model);
                 if (!software.empty()) {
                     options.software = taken(simulator::parseSoftware(QString::fromStdString(software)));
                 }
                 options.listenAddress = address;
                 options.time = inVirtualTime ? simulator::Time::Virtual : simulator::Time::Real;
                 options.poweredOn = poweredOn;
                 options.fastTransitions = true;
                 if (start) {
                     options.startJoints = JointPositions(*start);
                 }
                 if (priority > 0) {
                     options.priority = priority;
                 }
                 options.remoteControl = remoteControl;
                 options.gateLocalControl = !remoteControl;
                 options.programsFolder = programs;
                 return sharedOwn<NativeSimulator>(options);
             }),
             py::arg("model"), py::arg("software"), py::arg("address"), py::arg("virtual"),
             py::arg("powered_on"), py::arg("start"), py::arg("remote_control"), py::arg("programs"),
             py::arg("priority"))
        .def("start",
             [](NativeSimulator& self) {
                 const auto started = [&] {
                     const GilReleased released;
                     return self.robot.start();
                 }();
                 taken(started);
             })
        .def(
            "stop",
            [](NativeSimulator& self) {
                if (self.isOwn()) {
                    self.isEnding = true;
                    self.robot.stop();
                }
            },
            Released())
        .def("is_running", [](const NativeSimulator& self) { return self.robot.isRunning(); })
        .def("clock", &NativeSimulator::clock)
        .def("follow", py::overload_cast<const std::shared_ptr<NativeReceiver>&>(&NativeSimulator::follow))
        .def("follow", py::overload_cast<const std::shared_ptr<NativeController>&>(&NativeSimulator::follow))
        .def(
            "step",
            [](NativeSimulator& self, double seconds) {
                refuseOfParent(self);
                const WaitingCall released;
                self.step(seconds);
            },
            py::arg("seconds"))
        .def("tick",
             [](NativeSimulator& self) {
                 refuseOfParent(self);
                 const WaitingCall released;
                 self.tick();
             })
        .def("step_time", [](const NativeSimulator& self) { return self.robot.stepTime(); })
        .def("truth", &truthDict)
        .def(
            "inject",
            [](NativeSimulator& self, const std::string& words) {
                refuseOfParent(self);
                const auto answer = [&] {
                    const GilReleased released;
                    return self.robot.inject(words);
                }();
                return string(taken(answer));
            },
            py::arg("words"))
        .def("set_digital_input",
             [](NativeSimulator& self, int n, bool on) { self.robot.setDigitalInput(n, on); })
        .def("set_analog_input",
             [](NativeSimulator& self, int n, double v) { self.robot.setAnalogInput(n, v); })
        .def("press_hand",
             [](NativeSimulator& self, const Six& wrench) { self.robot.pressHand(wrenchOf(wrench)); });
}

}  // namespace tiller::python
