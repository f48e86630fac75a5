// SPDX-License-Identifier: MIT
// Python module script_client.
#include <ur_rtde/script_client.h>

#include "robot/python/module_support.h"

using namespace tiller::python;
using ur_rtde::ScriptClient;
using Script = Shown<ScriptClient>;

PYBIND11_MODULE(script_client, module) {
    prepareModule();
    module.doc() = "Sends URScript to a Universal Robots controller.";
    py::class_<Script, OwnHolder<Script>> cls(module, "ScriptClient");
    for (const char* host : kHostNames) {
        cls.def(py::init<std::string, uint32_t, uint32_t, int, bool>(), py::arg(host),
                py::arg("major_control_version"), py::arg("minor_control_version"), py::arg("port") = 30002,
                py::arg("verbose") = false, Unlocked());
    }
    cls.def("sendScript", py::overload_cast<>(&ScriptClient::sendScript), Unlocked());
    cls.def("sendScript", py::overload_cast<const std::string&>(&ScriptClient::sendScript),
            py::arg("file_name"), Unlocked());
    cls.def("connect", &ScriptClient::connect, Unlocked());
    cls.def("isConnected", &ScriptClient::isConnected, Unlocked());
    cls.def("disconnect", &ScriptClient::disconnect, Unlocked());
    cls.def("setScriptFile", &ScriptClient::setScriptFile, py::arg("file_name"), Unlocked());
    cls.def("sendScriptCommand", &ScriptClient::sendScriptCommand, py::arg("cmd_str"), Unlocked());
    cls.def("getScript", &ScriptClient::getScript, Unlocked());
    defineShowing(
        cls,
        [](Script& script) {
            if (!script.isConnected()) {
                script.connect();
            }
        },
        [](Script& script) { script.disconnect(); });
    finishModule(module);
}
