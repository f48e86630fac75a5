// SPDX-License-Identifier: MIT
// Python module rtde_receive.
#include <ur_rtde/rtde_receive_interface.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::RTDEReceiveInterface;
using Receive = Shown<RTDEReceiveInterface>;

PYBIND11_MODULE(rtde_receive, module) {
    prepareModule();
    module.doc() = "Reads and records the RTDE data of a Universal Robots arm.";
    py::class_<Receive, OwnHolder<Receive>> cls(module, "RTDEReceiveInterface");
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, double, std::vector<std::string>, bool, bool, int>(), py::arg(host),
                py::arg("frequency") = -1.0, py::arg("variables") = std::vector<std::string>(),
                py::arg("verbose") = false, py::arg("use_upper_range_registers") = false,
                py::arg("rt_priority") = RT_PRIORITY_UNDEFINED, Unlocked());
    }
    cls.def("startFileRecording", &RTDEReceiveInterface::startFileRecording, py::arg("filename"),
            py::arg("variables") = std::vector<std::string>(), Unlocked());
    cls.def("waitPeriod", &RTDEReceiveInterface::waitPeriod, py::arg("t_cycle_start"), Unlocked());
    cls.def("disconnect", &RTDEReceiveInterface::disconnect, Unlocked());
    cls.def("reconnect", &RTDEReceiveInterface::reconnect, Unlocked());
    cls.def("stopFileRecording", &RTDEReceiveInterface::stopFileRecording, Unlocked());
    cls.def("isConnected", &RTDEReceiveInterface::isConnected, Unlocked());
    cls.def("getTimestamp", &RTDEReceiveInterface::getTimestamp, Unlocked());
    cls.def("getTargetQ", &RTDEReceiveInterface::getTargetQ, Unlocked());
    cls.def("getTargetQd", &RTDEReceiveInterface::getTargetQd, Unlocked());
    cls.def("getTargetQdd", &RTDEReceiveInterface::getTargetQdd, Unlocked());
    cls.def("getTargetCurrent", &RTDEReceiveInterface::getTargetCurrent, Unlocked());
    cls.def("getTargetMoment", &RTDEReceiveInterface::getTargetMoment, Unlocked());
    cls.def("getActualQ", &RTDEReceiveInterface::getActualQ, Unlocked());
    cls.def("getActualQd", &RTDEReceiveInterface::getActualQd, Unlocked());
    cls.def("getActualCurrent", &RTDEReceiveInterface::getActualCurrent, Unlocked());
    cls.def("getJointControlOutput", &RTDEReceiveInterface::getJointControlOutput, Unlocked());
    cls.def("getActualTCPPose", &RTDEReceiveInterface::getActualTCPPose, Unlocked());
    cls.def("getActualTCPSpeed", &RTDEReceiveInterface::getActualTCPSpeed, Unlocked());
    cls.def("getActualTCPForce", &RTDEReceiveInterface::getActualTCPForce, Unlocked());
    cls.def("getTargetTCPPose", &RTDEReceiveInterface::getTargetTCPPose, Unlocked());
    cls.def("getTargetTCPSpeed", &RTDEReceiveInterface::getTargetTCPSpeed, Unlocked());
    cls.def("getActualDigitalInputBits", &RTDEReceiveInterface::getActualDigitalInputBits, Unlocked());
    cls.def("getDigitalInState", &RTDEReceiveInterface::getDigitalInState, py::arg("input_id"), Unlocked());
    cls.def("getJointTemperatures", &RTDEReceiveInterface::getJointTemperatures, Unlocked());
    cls.def("getActualExecutionTime", &RTDEReceiveInterface::getActualExecutionTime, Unlocked());
    cls.def("getRobotMode", &RTDEReceiveInterface::getRobotMode, Unlocked());
    cls.def("getJointMode", &RTDEReceiveInterface::getJointMode, Unlocked());
    cls.def("getSafetyMode", &RTDEReceiveInterface::getSafetyMode, Unlocked());
    cls.def("getSafetyStatusBits", &RTDEReceiveInterface::getSafetyStatusBits, Unlocked());
    cls.def("getActualToolAccelerometer", &RTDEReceiveInterface::getActualToolAccelerometer, Unlocked());
    cls.def("getSpeedScaling", &RTDEReceiveInterface::getSpeedScaling, Unlocked());
    cls.def("getTargetSpeedFraction", &RTDEReceiveInterface::getTargetSpeedFraction, Unlocked());
    cls.def("getActualMomentum", &RTDEReceiveInterface::getActualMomentum, Unlocked());
    cls.def("getActualMainVoltage", &RTDEReceiveInterface::getActualMainVoltage, Unlocked());
    cls.def("getActualRobotVoltage", &RTDEReceiveInterface::getActualRobotVoltage, Unlocked());
    cls.def("getActualRobotCurrent", &RTDEReceiveInterface::getActualRobotCurrent, Unlocked());
    cls.def("getActualJointVoltage", &RTDEReceiveInterface::getActualJointVoltage, Unlocked());
    cls.def("getActualDigitalOutputBits", &RTDEReceiveInterface::getActualDigitalOutputBits, Unlocked());
    cls.def("getDigitalOutState", &RTDEReceiveInterface::getDigitalOutState, py::arg("output_id"),
            Unlocked());
    cls.def("getRuntimeState", &RTDEReceiveInterface::getRuntimeState, Unlocked());
    cls.def("getRobotStatus", &RTDEReceiveInterface::getRobotStatus, Unlocked());
    cls.def("getStandardAnalogInput0", &RTDEReceiveInterface::getStandardAnalogInput0, Unlocked());
    cls.def("getStandardAnalogInput1", &RTDEReceiveInterface::getStandardAnalogInput1, Unlocked());
    cls.def("getStandardAnalogOutput0", &RTDEReceiveInterface::getStandardAnalogOutput0, Unlocked());
    cls.def("getStandardAnalogOutput1", &RTDEReceiveInterface::getStandardAnalogOutput1, Unlocked());
    cls.def("isProtectiveStopped", &RTDEReceiveInterface::isProtectiveStopped, Unlocked());
    cls.def("isEmergencyStopped", &RTDEReceiveInterface::isEmergencyStopped, Unlocked());
    cls.def("getOutputIntRegister", &RTDEReceiveInterface::getOutputIntRegister, py::arg("output_id"),
            Unlocked());
    cls.def("getOutputDoubleRegister", &RTDEReceiveInterface::getOutputDoubleRegister, py::arg("output_id"),
            Unlocked());
    cls.def("getSpeedScalingCombined", &RTDEReceiveInterface::getSpeedScalingCombined, Unlocked());
    cls.def("getFtRawWrench", &RTDEReceiveInterface::getFtRawWrench, Unlocked());
    cls.def("getPayload", &RTDEReceiveInterface::getPayload, Unlocked());
    cls.def("getPayloadCog", &RTDEReceiveInterface::getPayloadCog, Unlocked());
    cls.def("getPayloadInertia", &RTDEReceiveInterface::getPayloadInertia, Unlocked());
    cls.def("initPeriod", &RTDEReceiveInterface::initPeriod, Unlocked());
    defineShowing(
        cls, [](Receive&) {}, [](Receive& receive) { receive.disconnect(); });
    finishModule(module);
}
