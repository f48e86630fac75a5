// SPDX-License-Identifier: MIT
// Python module rtde_control.
#include <ur_rtde/rtde_control_interface.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "robot/python/module_support.h"
#include "robot/ur_rtde/detail/waiting.h"

using namespace tiller::python;
using ur_rtde::AsyncOperationStatus;
using ur_rtde::Path;
using ur_rtde::PathEntry;
using Control = ur_rtde::RTDEControlInterface;
using ShownControl = Shown<Control>;
using List = std::vector<double>;

namespace {

const List kZeros3(3, 0.0);
const List kZeros6(6, 0.0);

void definePaths(py::module_& module) {
    py::class_<PathEntry> entry(module, "PathEntry");
    py::enum_<PathEntry::eMoveType>(entry, "eMoveType")
        .value("MoveJ", PathEntry::MoveJ)
        .value("MoveL", PathEntry::MoveL)
        .value("MoveP", PathEntry::MoveP)
        .value("MoveC", PathEntry::MoveC)
        .export_values();
    py::enum_<PathEntry::ePositionType>(entry, "ePositionType")
        .value("PositionTcpPose", PathEntry::PositionTcpPose)
        .value("PositionJoints", PathEntry::PositionJoints)
        .export_values();
    entry
        .def(py::init<PathEntry::eMoveType, PathEntry::ePositionType, const List>(), py::arg("move_type"),
             py::arg("position_type"), py::arg("parameters"))
        .def("toScriptCode", &PathEntry::toScriptCode);
    py::class_<Path>(module, "Path")
        .def(py::init<>())
        .def("addEntry", &Path::addEntry, py::arg("entry"))
        .def("clear", &Path::clear)
        .def("size", &Path::size)
        .def("waypoints", &Path::waypoints)
        .def("appendMovelPath", &Path::appendMovelPath, py::arg("path"))
        .def("appendMovejPath", &Path::appendMovejPath, py::arg("path"))
        .def("toScriptCode", &Path::toScriptCode);
    py::class_<AsyncOperationStatus>(module, "AsyncOperationStatus")
        .def(py::init<int>(), py::arg("value") = 0)
        .def("value", &AsyncOperationStatus::value)
        .def("isAsyncOperationRunning", &AsyncOperationStatus::isAsyncOperationRunning)
        .def("operationId", &AsyncOperationStatus::operationId)
        .def("changeCount", &AsyncOperationStatus::changeCount)
        .def("progress", &AsyncOperationStatus::progress)
        .def("equals", &AsyncOperationStatus::equals, py::arg("other"))
        .def("__eq__", &AsyncOperationStatus::equals);
}

/// Objects in control. If another object cannot take control, the error message lists them. Protected by the
/// interpreter lock.
std::vector<const ShownControl*>& living() {
    static std::vector<const ShownControl*> all;
    return all;
}

struct Deleter {
    void operator()(ShownControl* control) const {
        std::erase(living(), control);
        OwnDeleter()(control);
    }
};

using Holder = std::unique_ptr<ShownControl, Deleter>;
using ControlClass = py::class_<ShownControl, Holder>;

Holder makeControl(const std::string& hostname, double frequency, uint16_t flags, int urCapPort,
                   int priority) {
    Holder made;
    try {
        const GilReleased released;
        made.reset(new ShownControl(hostname, frequency, flags, urCapPort, priority));
    } catch (const std::exception& error) {
        for (const ShownControl* other : living()) {
            const bool holds = other->host == hostname && const_cast<ShownControl*>(other)->isConnected();
            if (holds && dynamic_cast<const tiller::urrtde::Interrupted*>(&error) == nullptr) {
                std::ostringstream said;
                said << error.what() << ". An RTDEControlInterface of this program (" << other
                     << ") is still connected "
                     << "to " << hostname
                     << " and holds its registers: call disconnect() on it, or use it in a `with` block.";
                throw std::runtime_error(said.str());
            }
        }
        throw;
    }
    living().push_back(made.get());
    return made;
}

/// Creates a Python enumeration whose members are also attributes of the class.
void defineInts(ControlClass& cls, const char* kind, const char* name,
                const std::vector<std::pair<std::string, int>>& members) {
    const py::object made = py::module_::import("enum").attr(kind)(name, members);
    made.attr("__module__") = cls.attr("__module__");
    made.attr("__qualname__") = std::string("RTDEControlInterface.") + name;
    cls.attr(name) = made;
    for (const auto& [member, value] : members) {
        cls.attr(member.c_str()) = made.attr(member.c_str());
    }
}

void defineLife(ControlClass& cls) {
    defineInts(cls, "IntFlag", "Flags",
               {{"FLAG_UPLOAD_SCRIPT", Control::FLAG_UPLOAD_SCRIPT},
                {"FLAG_USE_EXT_UR_CAP", Control::FLAG_USE_EXT_UR_CAP},
                {"FLAG_VERBOSE", Control::FLAG_VERBOSE},
                {"FLAG_UPPER_RANGE_REGISTERS", Control::FLAG_UPPER_RANGE_REGISTERS},
                {"FLAG_NO_WAIT", Control::FLAG_NO_WAIT},
                {"FLAG_CUSTOM_SCRIPT", Control::FLAG_CUSTOM_SCRIPT},
                {"FLAGS_DEFAULT", Control::FLAGS_DEFAULT}});
    defineInts(cls, "IntEnum", "Feature",
               {{"FEATURE_BASE", Control::FEATURE_BASE},
                {"FEATURE_TOOL", Control::FEATURE_TOOL},
                {"FEATURE_CUSTOM", Control::FEATURE_CUSTOM}});
    for (const char* host : kHostNames) {
        cls.def(py::init(&makeControl), py::arg(host), py::arg("frequency") = -1.0,
                py::arg("flags") = static_cast<uint16_t>(Control::FLAGS_DEFAULT),
                py::arg("ur_cap_port") = 50002, py::arg("rt_priority") = RT_PRIORITY_UNDEFINED);
    }
    defineShowing(
        cls, [](ShownControl&) {},
        [](ShownControl& control) {
            if (control.isConnected()) {
                control.stopScript();
            }
            control.disconnect();
        });
    cls.def("disconnect", &Control::disconnect, py::arg("unattended") = false, Unlocked());
    cls.def("reconnect", &Control::reconnect, Unlocked());
    cls.def("isConnected", &Control::isConnected, Unlocked());
    cls.def("lastError", &Control::lastError);
    cls.def("sendCustomScriptFunction", &Control::sendCustomScriptFunction, py::arg("function_name"),
            py::arg("script"), py::arg("unattended") = false, Unlocked());
    cls.def("sendCustomScript", &Control::sendCustomScript, py::arg("script"), py::arg("unattended") = false,
            Unlocked());
    cls.def("sendCustomScriptFile", &Control::sendCustomScriptFile, py::arg("file_path"),
            py::arg("unattended") = false, Unlocked());
    cls.def("setCustomScriptFile", &Control::setCustomScriptFile, py::arg("file_path"), Unlocked());
    cls.def("stopScript", &Control::stopScript, Unlocked());
    cls.def("reuploadScript", &Control::reuploadScript, Unlocked());
    cls.def("isProgramRunning", &Control::isProgramRunning, Unlocked());
    cls.def("getRobotStatus", &Control::getRobotStatus, Unlocked());
    cls.def("initPeriod", &Control::initPeriod, Unlocked());
    cls.def("waitPeriod", &Control::waitPeriod, py::arg("t_cycle_start"), Unlocked());
}

void defineMoves(ControlClass& cls) {
    using Rows = std::vector<List>;
    cls.def("moveJ", py::overload_cast<const Rows&, bool>(&Control::moveJ), py::arg("path"),
            py::arg("asynchronous") = false, Unlocked());
    cls.def("moveL", py::overload_cast<const Rows&, bool>(&Control::moveL), py::arg("path"),
            py::arg("asynchronous") = false, Unlocked());
    defineMove(cls, "moveJ", py::overload_cast<const List&, double, double, bool>(&Control::moveJ), "q", 1.05,
               1.4);
    defineMove(cls, "moveJ_IK", &Control::moveJ_IK, "pose", 1.05, 1.4);
    defineMove(cls, "moveL", py::overload_cast<const List&, double, double, bool>(&Control::moveL), "pose",
               0.25, 1.2);
    defineMove(cls, "moveL_FK", &Control::moveL_FK, "q", 0.25, 1.2);
    cls.def("movePath", &Control::movePath, py::arg("path"), py::arg("asynchronous") = false, Unlocked());
    cls.def("moveUntilContact", &Control::moveUntilContact, py::arg("xd"), py::arg("direction") = kZeros6,
            py::arg("acceleration") = 1.2, Unlocked());
    cls.def("startContactDetection", &Control::startContactDetection, py::arg("direction") = kZeros6,
            Unlocked());
    cls.def("readContactDetection", &Control::readContactDetection, Unlocked());
    cls.def("stopContactDetection", &Control::stopContactDetection, Unlocked());
    cls.def("speedJ", &Control::speedJ, py::arg("qd"), py::arg("acceleration") = 0.5, py::arg("time") = 0.0,
            Unlocked());
    cls.def("speedL", &Control::speedL, py::arg("xd"), py::arg("acceleration") = 0.25, py::arg("time") = 0.0,
            Unlocked());
    cls.def("speedStop", &Control::speedStop, py::arg("a") = 10.0, Unlocked());
    cls.def("servoC", &Control::servoC, py::arg("pose"), py::arg("speed") = 0.25,
            py::arg("acceleration") = 1.2, py::arg("blend") = 0.0, Unlocked());
    cls.def("servoStop", &Control::servoStop, py::arg("a") = 10.0, Unlocked());
    cls.def("stopL", &Control::stopL, py::arg("a") = 10.0, py::arg("asynchronous") = false, Unlocked());
    cls.def("stopJ", &Control::stopJ, py::arg("a") = 2.0, py::arg("asynchronous") = false, Unlocked());
    cls.def("jogStart", &Control::jogStart, py::arg("speeds"),
            py::arg("feature") = static_cast<int>(Control::FEATURE_BASE), py::arg("acc") = 0.5,
            py::arg("custom_frame") = kZeros6, Unlocked());
    cls.def("servoJ", &Control::servoJ, py::arg("q"), py::arg("speed"), py::arg("acceleration"),
            py::arg("time"), py::arg("lookahead_time"), py::arg("gain"), Unlocked());
    cls.def("servoL", &Control::servoL, py::arg("pose"), py::arg("speed"), py::arg("acceleration"),
            py::arg("time"), py::arg("lookahead_time"), py::arg("gain"), Unlocked());
    cls.def("jogStop", &Control::jogStop, Unlocked());
    cls.def("getAsyncOperationProgress", &Control::getAsyncOperationProgress, Unlocked());
    cls.def("getAsyncOperationProgressEx", &Control::getAsyncOperationProgressEx, Unlocked());
    cls.def("forceMode", &Control::forceMode, py::arg("task_frame"), py::arg("selection_vector"),
            py::arg("wrench"), py::arg("type"), py::arg("limits"), Unlocked());
    cls.def("forceModeStop", &Control::forceModeStop, Unlocked());
    cls.def("forceModeSetDamping", &Control::forceModeSetDamping, py::arg("damping"), Unlocked());
    cls.def("forceModeSetGainScaling", &Control::forceModeSetGainScaling, py::arg("scaling"), Unlocked());
}

void defineRest(ControlClass& cls) {
    cls.def("setPayload", &Control::setPayload, py::arg("mass"), py::arg("cog") = List(), Unlocked());
    cls.def("getInverseKinematics", &Control::getInverseKinematics, py::arg("x"), py::arg("qnear") = List(),
            py::arg("max_position_error") = 1e-10, py::arg("max_orientation_error") = 1e-10, Unlocked());
    cls.def("getInverseKinematicsHasSolution", &Control::getInverseKinematicsHasSolution, py::arg("x"),
            py::arg("qnear") = List(), py::arg("max_position_error") = 1e-10,
            py::arg("max_orientation_error") = 1e-10, Unlocked());
    cls.def("getForwardKinematics", &Control::getForwardKinematics, py::arg("q") = List(),
            py::arg("tcp_offset") = List(), Unlocked());
    cls.def("poseTrans", &Control::poseTrans, py::arg("p_from"), py::arg("p_from_to"), Unlocked());
    cls.def("setWatchdog", &Control::setWatchdog, py::arg("min_frequency") = 10.0, Unlocked());
    cls.def("freedriveMode", &Control::freedriveMode, py::arg("free_axes") = std::vector<int>(6, 1),
            py::arg("feature") = kZeros6, Unlocked());
    cls.def("ftRtdeInputEnable", &Control::ftRtdeInputEnable, py::arg("enable"), py::arg("sensor_mass") = 0.0,
            py::arg("sensor_measuring_offset") = kZeros3, py::arg("sensor_cog") = kZeros3, Unlocked());
    cls.def("enableExternalFtSensor", &Control::enableExternalFtSensor, py::arg("enable"),
            py::arg("sensor_mass") = 0.0, py::arg("sensor_measuring_offset") = kZeros3,
            py::arg("sensor_cog") = kZeros3, Unlocked());
    cls.def("toolContact", &Control::toolContact, py::arg("direction"), Unlocked());
    cls.def("getTargetWaypoint", &Control::getTargetWaypoint, Unlocked());
    cls.def("getActualJointPositionsHistory", &Control::getActualJointPositionsHistory, py::arg("steps") = 0,
            Unlocked());
    cls.def("getStepTime", &Control::getStepTime, Unlocked());
    cls.def("teachMode", &Control::teachMode, Unlocked());
    cls.def("endTeachMode", &Control::endTeachMode, Unlocked());
    cls.def("zeroFtSensor", &Control::zeroFtSensor, Unlocked());
    cls.def("setTcp", &Control::setTcp, py::arg("tcp_offset"), Unlocked());
    cls.def("triggerProtectiveStop", &Control::triggerProtectiveStop, Unlocked());
    cls.def("kickWatchdog", &Control::kickWatchdog, Unlocked());
    cls.def("isPoseWithinSafetyLimits", &Control::isPoseWithinSafetyLimits, py::arg("pose"), Unlocked());
    cls.def("isJointsWithinSafetyLimits", &Control::isJointsWithinSafetyLimits, py::arg("q"), Unlocked());
    cls.def("getJointTorques", &Control::getJointTorques, Unlocked());
    cls.def("getTCPOffset", &Control::getTCPOffset, Unlocked());
    cls.def("isSteady", &Control::isSteady, Unlocked());
    cls.def("endFreedriveMode", &Control::endFreedriveMode, Unlocked());
    cls.def("getFreedriveStatus", &Control::getFreedriveStatus, Unlocked());
    cls.def("setExternalForceTorque", &Control::setExternalForceTorque, py::arg("external_force_torque"),
            Unlocked());
    cls.def("getActualToolFlangePose", &Control::getActualToolFlangePose, Unlocked());
    cls.def("setGravity", &Control::setGravity, py::arg("direction"), Unlocked());
}

}  // namespace

PYBIND11_MODULE(rtde_control, module) {
    prepareModule();
    module.doc() = "Moves a Universal Robots arm through RTDE.";
    definePaths(module);
    ControlClass cls(module, "RTDEControlInterface");
    defineLife(cls);
    defineMoves(cls);
    defineRest(cls);
    finishModule(module);
}
