// SPDX-License-Identifier: MIT
// Python module rtde_io.
#include <ur_rtde/rtde_io_interface.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::RTDEIOInterface;

PYBIND11_MODULE(rtde_io, module) {
    prepareModule();
    module.doc() = "Sets outputs, the speed slider and registers of a Universal Robots arm over RTDE.";
    py::class_<RTDEIOInterface> cls(module, "RTDEIOInterface");
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, bool, bool>(), py::arg(host), py::arg("verbose") = false,
                py::arg("use_upper_range_registers") = false, Unlocked());
    }
    cls.def("reconnect", &RTDEIOInterface::reconnect, Unlocked());
    cls.def("disconnect", &RTDEIOInterface::disconnect, Unlocked());
    cls.def("setStandardDigitalOut", &RTDEIOInterface::setStandardDigitalOut, Unlocked());
    cls.def("setToolDigitalOut", &RTDEIOInterface::setToolDigitalOut, Unlocked());
    cls.def("setSpeedSlider", &RTDEIOInterface::setSpeedSlider, Unlocked());
    cls.def("setAnalogOutputVoltage", &RTDEIOInterface::setAnalogOutputVoltage, Unlocked());
    cls.def("setAnalogOutputCurrent", &RTDEIOInterface::setAnalogOutputCurrent, Unlocked());
    cls.def("setConfigurableDigitalOut", &RTDEIOInterface::setConfigurableDigitalOut, Unlocked());
    cls.def("setInputIntRegister", &RTDEIOInterface::setInputIntRegister, Unlocked());
    cls.def("setInputDoubleRegister", &RTDEIOInterface::setInputDoubleRegister, Unlocked());
}
