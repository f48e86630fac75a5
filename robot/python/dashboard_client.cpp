// SPDX-License-Identifier: MIT
// Python module dashboard_client.
#include <ur_rtde/dashboard_client.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::DashboardClient;
using Dashboard = Shown<DashboardClient>;
using ur_rtde::UserRole;

PYBIND11_MODULE(dashboard_client, module) {
    prepareModule();
    module.doc() = "The dashboard server of a Universal Robots arm.";
    py::enum_<UserRole>(module, "UserRole")
        .value("PROGRAMMER", UserRole::PROGRAMMER)
        .value("OPERATOR", UserRole::OPERATOR)
        .value("NONE", UserRole::NONE)
        .value("LOCKED", UserRole::LOCKED)
        .value("RESTRICTED", UserRole::RESTRICTED);
    py::class_<Dashboard, OwnHolder<Dashboard>> cls(module, "DashboardClient");
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, int, bool>(), py::arg(host), py::arg("port") = 29999,
                py::arg("verbose") = false, Unlocked());
    }
    cls.def("connect", &DashboardClient::connect, py::arg("timeout_ms") = 2000, Unlocked());
    cls.def("isConnected", &DashboardClient::isConnected, Unlocked());
    cls.def("disconnect", &DashboardClient::disconnect, Unlocked());
    cls.def("send", &DashboardClient::send, py::arg("str"), Unlocked());
    cls.def("receive", &DashboardClient::receive, Unlocked());
    cls.def("loadURP", &DashboardClient::loadURP, py::arg("urp_name"), Unlocked());
    cls.def("play", &DashboardClient::play, Unlocked());
    cls.def("stop", &DashboardClient::stop, Unlocked());
    cls.def("pause", &DashboardClient::pause, Unlocked());
    cls.def("quit", &DashboardClient::quit, Unlocked());
    cls.def("shutdown", &DashboardClient::shutdown, Unlocked());
    cls.def("running", &DashboardClient::running, Unlocked());
    cls.def("popup", &DashboardClient::popup, py::arg("message"), Unlocked());
    cls.def("closePopup", &DashboardClient::closePopup, Unlocked());
    cls.def("closeSafetyPopup", &DashboardClient::closeSafetyPopup, Unlocked());
    cls.def("powerOn", &DashboardClient::powerOn, Unlocked());
    cls.def("powerOff", &DashboardClient::powerOff, Unlocked());
    cls.def("brakeRelease", &DashboardClient::brakeRelease, Unlocked());
    cls.def("unlockProtectiveStop", &DashboardClient::unlockProtectiveStop, Unlocked());
    cls.def("restartSafety", &DashboardClient::restartSafety, Unlocked());
    cls.def("polyscopeVersion", &DashboardClient::polyscopeVersion, Unlocked());
    cls.def("programState", &DashboardClient::programState, Unlocked());
    cls.def("robotmode", &DashboardClient::robotmode, Unlocked());
    cls.def("getRobotModel", &DashboardClient::getRobotModel, Unlocked());
    cls.def("getLoadedProgram", &DashboardClient::getLoadedProgram, Unlocked());
    cls.def("safetymode", &DashboardClient::safetymode, Unlocked());
    cls.def("safetystatus", &DashboardClient::safetystatus, Unlocked());
    cls.def("addToLog", &DashboardClient::addToLog, py::arg("message"), Unlocked());
    cls.def("isProgramSaved", &DashboardClient::isProgramSaved, Unlocked());
    cls.def("isInRemoteControl", &DashboardClient::isInRemoteControl, Unlocked());
    cls.def("setUserRole", &DashboardClient::setUserRole, py::arg("role"), Unlocked());
    cls.def("getSerialNumber", &DashboardClient::getSerialNumber, Unlocked());
    defineShowing(
        cls,
        [](Dashboard& dashboard) {
            if (!dashboard.isConnected()) {
                dashboard.connect();
            }
        },
        [](Dashboard& dashboard) { dashboard.disconnect(); });
    finishModule(module);
}
