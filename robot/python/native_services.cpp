// SPDX-License-Identifier: MIT
// Part of tiller._native: outputs and registers, the dashboard and the Robot API, the doctor, offline kinematics.
#include <sstream>

#include "robot/core/robot_model.h"
#include "robot/dashboard/recovery.h"
#include "robot/dashboard/robot_service.h"
#include "robot/doctor/examination.h"
#include "robot/doctor/finding.h"
#include "robot/io/input_registers.h"
#include "robot/io/outputs.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/python/native_objects.h"

namespace tiller::python {

namespace {

struct NativeOutputs : ProcessOwned {
    NativeOutputs(std::shared_ptr<NativeReceiver> r, const std::string& host, int port)
        : receiver(std::move(r))
        , outputs({.host = host, .port = static_cast<std::uint16_t>(port)},
                  io::OutputFeedback::fromReceiver(receiver->receiver)) {}
    std::shared_ptr<NativeReceiver> receiver;
    io::Outputs outputs;
};

struct NativeRegisters : ProcessOwned {
    explicit NativeRegisters(io::InputRegistersOptions options) : registers(std::move(options)) {}
    io::InputRegisters registers;
};

void defineOutputs(py::module_& module) {
    py::class_<NativeOutputs, std::unique_ptr<NativeOutputs, OwnDeleter>>(module, "Outputs")
        .def(py::init<std::shared_ptr<NativeReceiver>, const std::string&, int>(), py::arg("receiver"),
             py::arg("host"), py::arg("port"))
        .def("set_digital",
             [](NativeOutputs& self, int output, bool on, const Seconds& seconds) {
                 refuseOfParent(self);
                 waited(seconds, [&](const Deadline& deadline) {
                     return self.outputs.setDigitalOutput(output, on, deadline);
                 });
             })
        .def("set_analog",
             [](NativeOutputs& self, int output, bool volts, double level, const Seconds& seconds) {
                 refuseOfParent(self);
                 waited(seconds, [&](const Deadline& deadline) {
                     return self.outputs.setAnalogOutput(
                         output, volts ? io::AnalogDomain::Voltage : io::AnalogDomain::Current, level,
                         deadline);
                 });
             })
        .def("set_speed_slider",
             [](NativeOutputs& self, double fraction, const Seconds& seconds) {
                 refuseOfParent(self);
                 waited(seconds, [&](const Deadline& deadline) {
                     return self.outputs.setSpeedSlider(fraction, deadline);
                 });
             })
        .def(
            "disconnect", [](NativeOutputs& self) { self.outputs.disconnect(); },
            py::call_guard<GilReleased>());
    py::class_<NativeRegisters, std::unique_ptr<NativeRegisters, OwnDeleter>>(module, "InputRegisters")
        .def(py::init([](const std::string& host, int port, std::vector<int> ints, std::vector<int> doubles,
                         std::vector<int> bits, const Seconds& seconds) {
                 std::unique_ptr<NativeRegisters, OwnDeleter> made(
                     new NativeRegisters(io::InputRegistersOptions{.host = host,
                                                                   .port = static_cast<std::uint16_t>(port),
                                                                   .ints = std::move(ints),
                                                                   .doubles = std::move(doubles),
                                                                   .bits = std::move(bits)}));
                 waited(seconds, [&](const Deadline& deadline) { return made->registers.connect(deadline); });
                 return made;
             }),
             py::arg("host"), py::arg("port"), py::arg("ints"), py::arg("doubles"), py::arg("bits"),
             py::arg("timeout"))
        .def("set_int",
             [](NativeRegisters& self, int number, std::int32_t value, const Seconds& seconds) {
                 refuseOfParent(self);
                 waited(seconds, [&](const Deadline& deadline) {
                     return self.registers.setInt(number, value, deadline);
                 });
             })
        .def("set_double",
             [](NativeRegisters& self, int number, double value, const Seconds& seconds) {
                 refuseOfParent(self);
                 waited(seconds, [&](const Deadline& deadline) {
                     return self.registers.setDouble(number, value, deadline);
                 });
             })
        .def("set_bit", [](NativeRegisters& self, int number, bool value, const Seconds& seconds) {
            refuseOfParent(self);
            waited(seconds,
                   [&](const Deadline& deadline) { return self.registers.setBit(number, value, deadline); });
        });
}

using dashboard::RobotCommand;

RobotCommand commandOf(const std::string& name) {
    for (const RobotCommand command :
         {RobotCommand::PowerOn, RobotCommand::ReleaseBrakes, RobotCommand::PowerOff,
          RobotCommand::RestartSafety, RobotCommand::ClosePopups, RobotCommand::Play, RobotCommand::Pause,
          RobotCommand::StopProgram}) {
        if (toString(command) == name) {
            return command;
        }
    }
    raise({ErrorCode::InvalidArgument, QStringLiteral("command"),
           QStringLiteral("\"%1\" is not a command").arg(QString::fromStdString(name))});
}

void defineDashboard(py::module_& module) {
    using dashboard::RobotService;
    py::class_<RobotService>(module, "Service")
        .def(py::init([](const std::string& host, int portOffset, const Seconds& seconds) {
                 return waited(seconds, [&](const Deadline& deadline) {
                     return dashboard::openService(dashboard::serviceAt(host, portOffset), deadline);
                 });
             }),
             py::arg("host"), py::arg("port_offset"), py::arg("timeout"))
        .def("kind", [](const RobotService& self) { return toString(self.kind()); })
        .def("perform",
             [](RobotService& self, const std::string& command, const Seconds& seconds) {
                 const RobotCommand wanted = commandOf(command);
                 waited(seconds, [&](const Deadline& deadline) { return self.perform(wanted, deadline); });
             })
        .def("unlock_protective_stop",
             [](RobotService& self, const Seconds& seconds) {
                 waited(seconds,
                        [&](const Deadline& deadline) { return self.unlockProtectiveStop(deadline); });
             })
        .def("load_program",
             [](RobotService& self, const std::string& name, const Seconds& seconds) {
                 waited(seconds, [&](const Deadline& deadline) { return self.loadProgram(name, deadline); });
             })
        .def("look", [](RobotService& self, const Seconds& seconds) {
            const auto report =
                waited(seconds, [&](const Deadline& deadline) { return self.look(deadline); });
            py::dict result;
            result["kind"] = toString(report.kind);
            result["remote_control"] = report.remoteControl;
            result["operational_mode"] = string(report.operationalMode);
            result["program"] = string(report.program);
            return result;
        });
    module.def(
        "recover",
        [](const std::string& host, int portOffset, bool causeInspected, bool restartSafety, bool powerOn,
           bool releaseBrakes, const py::object& progress, const Seconds& seconds) {
            const dashboard::RecoveryConsent consent{causeInspected, restartSafety, powerOn, releaseBrakes};
            const dashboard::RecoveryProgress onStep = [&](dashboard::RecoveryStep step) {
                if (isParked()) {
                    return;
                }
                const py::gil_scoped_acquire locked;
                if (!progress.is_none() && PyErr_Occurred() == nullptr) {
                    try {
                        progress(toString(step));
                    } catch (py::error_already_set& error) {
                        error.restore();  // ends the wait as Ctrl+C does
                    }
                }
            };
            const auto address = dashboard::serviceAt(host, portOffset);
            waited(seconds, [&](const Deadline& deadline) {
                return dashboard::recover(address, consent, deadline, onStep);
            });
        },
        py::arg("host"), py::arg("port_offset"), py::arg("cause_inspected"), py::arg("restart_safety"),
        py::arg("power_on"), py::arg("release_brakes"), py::arg("progress"), py::arg("timeout"));
}

void defineDoctor(py::module_& module) {
    module.def(
        "examine",
        [](const std::string& host, int portOffset, const Seconds& seconds) {
            doctor::Report report;
            waited(seconds, [&](const Deadline& deadline) -> Result<void> {
                report = doctor::examine(doctor::patientAt(host, portOffset), deadline);
                return {};
            });
            py::list findings;
            for (const doctor::Finding& finding : report) {
                findings.append(py::make_tuple(string(doctor::conditionId(finding.condition)),
                                               string(doctor::conditionTitle(finding.condition)),
                                               string(doctor::verdictName(finding.verdict)),
                                               string(finding.cause), string(finding.detail),
                                               string(finding.fix)));
            }
            return findings;
        },
        py::arg("host"), py::arg("port_offset"), py::arg("timeout"));
}

const RobotModel& modelOf(const std::string& name) {
    return robotModel(modelNamed(name));
}

void defineKinematics(py::module_& module) {
    module.def("model_names", [] {
        std::vector<std::string> names;
        for (const RobotModel& model : robotModels()) {
            names.emplace_back(model.name);
        }
        return names;
    });
    module.def("model_facts", [](const std::string& name) {
        const RobotModel& model = modelOf(name);
        py::dict result;
        result["name"] = model.name;
        result["reach"] = model.reach;
        result["max_payload"] = model.maxPayload;
        result["max_joint_speed"] = model.maxJointSpeed;
        return result;
    });
    module.def("forward", [](const std::string& model, const Six& q, const Six& tcp) {
        return kinematics::forwardTcp(modelOf(model).dh, JointPositions(q), Pose::fromArray(tcp)).array();
    });
    module.def("inverse", [](const std::string& model, const Six& pose, const Six& tcp) {
        const Pose T_base_flange = Pose::fromArray(pose) * Pose::fromArray(tcp).inverse();
        std::vector<Six> solutions;
        const kinematics::InverseSolutions found =
            kinematics::inverse(modelOf(model).dh, T_base_flange.transform());
        for (const JointPositions& q : found.span()) {
            solutions.push_back(q.array());
        }
        return solutions;
    });
    module.def(
        "inverse_nearest",
        [](const std::string& model, const Six& pose, const Six& tcp, const Six& near) -> std::optional<Six> {
            const auto q = kinematics::inverseNearest(modelOf(model).dh, Pose::fromArray(pose),
                                                      Pose::fromArray(tcp), JointPositions(near));
            return q ? std::optional(q->array()) : std::nullopt;
        });
    module.def("jacobian", [](const std::string& model, const Six& q, const Six& tcp) {
        const Matrix6 J =
            kinematics::jacobian(modelOf(model).dh, JointPositions(q), Pose::fromArray(tcp)).transpose();
        return py::array_t<double>({6, 6}, J.data());
    });
    module.def("pose_product",
               [](const Six& a, const Six& b) { return (Pose::fromArray(a) * Pose::fromArray(b)).array(); });
    module.def("pose_inverse", [](const Six& a) { return Pose::fromArray(a).inverse().array(); });
}

}  // namespace

RobotModelId modelNamed(const std::string& name) {
    const auto id = robotModelByName(name);
    if (!id) {
        QStringList known;
        for (const RobotModel& model : robotModels()) {
            known.append(QString::fromLatin1(model.name));
        }
        raise({ErrorCode::InvalidArgument, QStringLiteral("model"),
               QStringLiteral("\"%1\" is not one of %2")
                   .arg(QString::fromStdString(name), known.join(QStringLiteral(", ")))});
    }
    return *id;
}

void defineServices(py::module_& module) {
    defineOutputs(module);
    defineDashboard(module);
    defineDoctor(module);
    defineKinematics(module);
}

}  // namespace tiller::python
