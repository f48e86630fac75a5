// SPDX-License-Identifier: MIT
// Python module rtde_io.
#include <ur_rtde/rtde_io_interface.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::RTDEIOInterface;

namespace {

/// Stores whether the interface was disconnected, for repr().
struct Io : Shown<RTDEIOInterface> {
    using Shown::Shown;
    void disconnect() {
        connected = false;
        RTDEIOInterface::disconnect();
    }
    bool reconnect() { return connected = RTDEIOInterface::reconnect(); }
    bool isConnected() const { return connected; }
    bool connected = true;
};

}  // namespace

PYBIND11_MODULE(rtde_io, module) {
    prepareModule();
    module.doc() = "Sets outputs, the speed slider and registers of a Universal Robots arm over RTDE.";
    py::class_<Io, OwnHolder<Io>> cls(module, "RTDEIOInterface");
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, bool, bool>(), py::arg(host), py::arg("verbose") = false,
                py::arg("use_upper_range_registers") = false, Unlocked());
    }
    cls.def("reconnect", &Io::reconnect, Unlocked());
    cls.def("disconnect", &Io::disconnect, Unlocked());
    cls.def("setStandardDigitalOut", &RTDEIOInterface::setStandardDigitalOut, py::arg("output_id"),
            py::arg("signal_level"), Unlocked());
    cls.def("setToolDigitalOut", &RTDEIOInterface::setToolDigitalOut, py::arg("output_id"),
            py::arg("signal_level"), Unlocked());
    cls.def("setSpeedSlider", &RTDEIOInterface::setSpeedSlider, py::arg("speed"), Unlocked());
    cls.def("setAnalogOutputVoltage", &RTDEIOInterface::setAnalogOutputVoltage, py::arg("output_id"),
            py::arg("voltage_ratio"), Unlocked());
    cls.def("setAnalogOutputCurrent", &RTDEIOInterface::setAnalogOutputCurrent, py::arg("output_id"),
            py::arg("current_ratio"), Unlocked());
    cls.def("setConfigurableDigitalOut", &RTDEIOInterface::setConfigurableDigitalOut, py::arg("output_id"),
            py::arg("signal_level"), Unlocked());
    cls.def("setInputIntRegister", &RTDEIOInterface::setInputIntRegister, py::arg("input_id"),
            py::arg("value"), Unlocked());
    cls.def("setInputDoubleRegister", &RTDEIOInterface::setInputDoubleRegister, py::arg("input_id"),
            py::arg("value"), Unlocked());
    defineShowing(
        cls, [](Io&) {}, [](Io& io) { io.disconnect(); });
    finishModule(module);
}
