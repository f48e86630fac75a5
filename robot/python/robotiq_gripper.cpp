// SPDX-License-Identifier: MIT
// Python module robotiq_gripper.
#include <ur_rtde/robotiq_gripper.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::RobotiqGripper;
using Gripper = Shown<RobotiqGripper>;

PYBIND11_MODULE(robotiq_gripper, module) {
    prepareModule();
    module.doc() = "A Robotiq gripper at the wrist of a Universal Robots arm.";
    py::class_<Gripper, OwnHolder<Gripper>> cls(module, "RobotiqGripper");
    py::enum_<RobotiqGripper::eStatus>(cls, "eStatus", py::arithmetic())
        .value("RESET", RobotiqGripper::RESET)
        .value("ACTIVATING", RobotiqGripper::ACTIVATING)
        .value("ACTIVE", RobotiqGripper::ACTIVE)
        .export_values();
    py::enum_<RobotiqGripper::eObjectStatus>(cls, "eObjectStatus", py::arithmetic())
        .value("MOVING", RobotiqGripper::MOVING)
        .value("STOPPED_OUTER_OBJECT", RobotiqGripper::STOPPED_OUTER_OBJECT)
        .value("STOPPED_INNER_OBJECT", RobotiqGripper::STOPPED_INNER_OBJECT)
        .value("AT_DEST", RobotiqGripper::AT_DEST)
        .export_values();
    py::enum_<RobotiqGripper::eMoveMode>(cls, "eMoveMode", py::arithmetic())
        .value("START_MOVE", RobotiqGripper::START_MOVE)
        .value("WAIT_FINISHED", RobotiqGripper::WAIT_FINISHED)
        .export_values();
    py::enum_<RobotiqGripper::eUnit>(cls, "eUnit", py::arithmetic())
        .value("UNIT_DEVICE", RobotiqGripper::UNIT_DEVICE)
        .value("UNIT_NORMALIZED", RobotiqGripper::UNIT_NORMALIZED)
        .value("UNIT_PERCENT", RobotiqGripper::UNIT_PERCENT)
        .value("UNIT_MM", RobotiqGripper::UNIT_MM)
        .export_values();
    py::enum_<RobotiqGripper::eMoveParameter>(cls, "eMoveParameter", py::arithmetic())
        .value("POSITION", RobotiqGripper::POSITION)
        .value("SPEED", RobotiqGripper::SPEED)
        .value("FORCE", RobotiqGripper::FORCE)
        .export_values();
    py::enum_<RobotiqGripper::ePostionId>(cls, "ePostionId", py::arithmetic())
        .value("OPEN", RobotiqGripper::OPEN)
        .value("CLOSE", RobotiqGripper::CLOSE)
        .export_values();
    cls.def(py::init<std::string, int, bool>(), py::arg("Hostname"), py::arg("Port") = 63352,
            py::arg("verbose") = false);
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, int, bool>(), py::arg(host), py::arg("port") = 63352,
                py::arg("verbose") = false);
    }
    cls.def("connect", &RobotiqGripper::connect, py::arg("timeout_ms") = 2000, Unlocked());
    cls.def("disconnect", &RobotiqGripper::disconnect, Unlocked());
    cls.def("isConnected", &RobotiqGripper::isConnected, Unlocked());
    cls.def("activate", &RobotiqGripper::activate, py::arg("auto_calibrate") = false, Unlocked());
    cls.def("autoCalibrate", &RobotiqGripper::autoCalibrate, py::arg("Speed") = -1.0F, Unlocked());
    cls.def("isActive", &RobotiqGripper::isActive, Unlocked());
    cls.def("getOpenPosition", &RobotiqGripper::getOpenPosition, Unlocked());
    cls.def("getClosedPosition", &RobotiqGripper::getClosedPosition, Unlocked());
    cls.def("getCurrentPosition", &RobotiqGripper::getCurrentPosition, Unlocked());
    cls.def("isOpen", &RobotiqGripper::isOpen, Unlocked());
    cls.def("isClosed", &RobotiqGripper::isClosed, Unlocked());
    cls.def("move", &RobotiqGripper::move, py::arg("Position"), py::arg("Speed") = -1.0F,
            py::arg("Force") = -1.0F, py::arg("MoveMode") = RobotiqGripper::START_MOVE, Unlocked());
    cls.def("open", &RobotiqGripper::open, py::arg("Speed") = -1.0F, py::arg("Force") = -1.0F,
            py::arg("MoveMode") = RobotiqGripper::START_MOVE, Unlocked());
    cls.def("close", &RobotiqGripper::close, py::arg("Speed") = -1.0F, py::arg("Force") = -1.0F,
            py::arg("MoveMode") = RobotiqGripper::START_MOVE, Unlocked());
    cls.def("emergencyRelease", &RobotiqGripper::emergencyRelease, py::arg("Direction"),
            py::arg("MoveMode") = RobotiqGripper::WAIT_FINISHED, Unlocked());
    cls.def("faultStatus", &RobotiqGripper::faultStatus, Unlocked());
    cls.def("setUnit", &RobotiqGripper::setUnit, py::arg("Param"), py::arg("Unit"), Unlocked());
    cls.def("setPositionRange_mm", &RobotiqGripper::setPositionRange_mm, py::arg("Range"), Unlocked());
    cls.def("setSpeed", &RobotiqGripper::setSpeed, py::arg("Speed"), Unlocked());
    cls.def("setForce", &RobotiqGripper::setForce, py::arg("Force"), Unlocked());
    cls.def("objectDetectionStatus", &RobotiqGripper::objectDetectionStatus, Unlocked());
    cls.def("waitForMotionComplete", &RobotiqGripper::waitForMotionComplete, Unlocked());
    cls.def("setVars", &RobotiqGripper::setVars, py::arg("Vars"), Unlocked());
    cls.def("setVar", &RobotiqGripper::setVar, py::arg("Var"), py::arg("Value"), Unlocked());
    cls.def("getVar", &RobotiqGripper::getVar, py::arg("var"), Unlocked());
    cls.def("getVars", &RobotiqGripper::getVars, py::arg("Vars"), Unlocked());
    cls.def(
        "getNativePositionRange",
        [](Gripper& gripper) {
            int lowest = 0;
            int highest = 0;
            gripper.getNativePositionRange(lowest, highest);
            return std::pair(lowest, highest);
        },
        Unlocked());
    cls.def("setNativePositionRange", &RobotiqGripper::setNativePositionRange, py::arg("MinPosition"),
            py::arg("MaxPosition"), Unlocked());
    defineShowing(
        cls,
        [](Gripper& gripper) {
            if (!gripper.isConnected()) {
                gripper.connect();
            }
        },
        [](Gripper& gripper) { gripper.disconnect(); });
    finishModule(module);
}
