// SPDX-License-Identifier: MIT
// Part of tiller._native: the simulated controller in the same process.
#include <memory>

#include "robot/python/native_objects.h"
#include "robot/simulator/plant/personality.h"
#include "robot/simulator/simulator.h"
#include "robot/testing/lock_step.h"

namespace tiller::python {

namespace {

/// A simulator. In virtual time, its clients use the clock of the simulator and run in lock-step with the
/// simulator.
class NativeSimulator : public ProcessOwned {
public:
    explicit NativeSimulator(const simulator::SimulatorOptions& options) {
        if (options.time == simulator::Time::Virtual) {
            bench_ = std::make_unique<virtual_time::LockStep>(options);
        } else {
            real_ = std::make_unique<simulator::Simulator>(options);
        }
    }
    ~NativeSimulator() { stop(); }

    simulator::Simulator& robot() { return bench_ ? bench_->robot() : *real_; }
    const simulator::Simulator& robot() const { return bench_ ? bench_->robot() : *real_; }
    SharedClock clock() const { return bench_ ? SharedClock(bench_->clock()) : nullptr; }
    void stop() {
        if (bench_) {
            bench_->stop();
        } else {
            real_->stop();
        }
    }
    void follow(const std::shared_ptr<NativeReceiver>& receiver) {
        bench().follow(std::shared_ptr<const receive::Receiver>(receiver, &receiver->receiver));
    }
    void follow(const std::shared_ptr<NativeController>& controller) {
        bench().follow(std::shared_ptr<const control::Controller>(controller, &controller->controller));
    }
    virtual_time::LockStep& bench() {
        if (!bench_) {
            raise({ErrorCode::InvalidArgument, QStringLiteral("advance the time of a simulator"),
                   QStringLiteral("the simulator runs in real time; use Simulator(virtual=True)")});
        }
        return *bench_;
    }

private:
    std::unique_ptr<simulator::Simulator> real_;
    std::unique_ptr<virtual_time::LockStep> bench_;
};

py::dict truthDict(const NativeSimulator& self) {
    const simulator::SimulatedState truth = self.robot().truth();
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
                     return self.robot().start();
                 }();
                 taken(started);
             })
        .def(
            "stop",
            [](NativeSimulator& self) {
                if (self.isOwn()) {
                    self.stop();
                }
            },
            Released())
        .def("is_running", [](const NativeSimulator& self) { return self.robot().isRunning(); })
        .def("clock", &NativeSimulator::clock)
        .def("follow", py::overload_cast<const std::shared_ptr<NativeReceiver>&>(&NativeSimulator::follow))
        .def("follow", py::overload_cast<const std::shared_ptr<NativeController>&>(&NativeSimulator::follow))
        .def(
            "step",
            [](NativeSimulator& self, double seconds) {
                refuseOfParent(self);
                const WaitingCall released;
                self.bench().step(seconds);
            },
            py::arg("seconds"))
        .def("begin_flow", [](NativeSimulator& self) { self.bench().beginFlow(); })
        .def("end_flow",
             [](NativeSimulator& self) {
                 const GilReleased released;
                 self.bench().endFlow();
             })
        .def("step_time", [](const NativeSimulator& self) { return self.robot().stepTime(); })
        .def("truth", &truthDict)
        .def(
            "inject",
            [](NativeSimulator& self, const std::string& words) {
                refuseOfParent(self);
                const auto answer = [&] {
                    const GilReleased released;
                    return self.robot().inject(words);
                }();
                return string(taken(answer));
            },
            py::arg("words"))
        .def("set_digital_input",
             [](NativeSimulator& self, int n, bool on) { self.robot().setDigitalInput(n, on); })
        .def("set_analog_input",
             [](NativeSimulator& self, int n, double v) { self.robot().setAnalogInput(n, v); })
        .def("press_hand",
             [](NativeSimulator& self, const Six& wrench) { self.robot().pressHand(wrenchOf(wrench)); });
}

}  // namespace tiller::python
