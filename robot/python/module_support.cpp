// SPDX-License-Identifier: MIT
#include "robot/python/module_support.h"

#include <cstdlib>
#include <cstring>
#include <regex>
#include <string_view>
#include <vector>

#include "robot/python/docstrings.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::python {

namespace {

// Python handles signals in its main thread only, and only when asked; what it found is raised already then.
bool userLostPatience() {
    if (isParked()) {
        return true;
    }
    const py::gil_scoped_acquire locked;
    return PyErr_CheckSignals() != 0;
}

/// "self: X, q: List[float], speed: float = 1.05" -> "self, q, speed=1.05".
std::string bareArguments(std::string_view arguments) {
    std::string bare;
    std::string argument;
    int depth = 0;
    const auto take = [&] {
        static const std::regex kArgument(R"(\s*(\*{0,2}\w+)\s*(?::.*?)?\s*(?:=\s*(.*))?)");
        static const std::regex kEnumerator(R"(<[^<>]*:\s*(-?\d+)>)");
        std::smatch parts;
        if (std::regex_match(argument, parts, kArgument)) {
            bare += (bare.empty() ? "" : ", ") + parts[1].str();
            if (parts[2].matched) {
                bare += "=" + std::regex_replace(parts[2].str(), kEnumerator, "$1");
            }
        }
        argument.clear();
    };
    for (const char c : arguments) {
        depth += c == '[' || c == '(' || c == '<' ? 1 : c == ']' || c == ')' || c == '>' ? -1 : 0;
        if (c == ',' && depth == 0) {
            take();
        } else {
            argument += c;
        }
    }
    take();
    return bare;
}

/// The signatures pybind11 wrote, bare; without those that only use another name for the same argument.
std::vector<std::string> signaturesOf(const std::string& name, const std::string& doc) {
    std::vector<std::string> signatures;
    const std::regex line("(?:^|\n)(?:\\d+\\. )?" + name + "\\((.*)\\) -> [^\n]*");
    for (std::sregex_iterator it(doc.begin(), doc.end(), line), end; it != end; ++it) {
        const std::string bare = bareArguments((*it)[1].str());
        static const std::regex kOtherName(R"(\b(ip|vel|acc)=|\bip\b|\bHostname\b)");
        const bool repeats = std::regex_search(bare, kOtherName) && !signatures.empty();
        if (!repeats && bare != "*args, **kwargs") {
            signatures.push_back(bare);
        }
    }
    return signatures;
}

void finishFunction(const std::string& className, const std::string& name, py::handle function) {
    PyObject* bare = py::detail::get_function(function).ptr();
    if (bare == nullptr || !PyCFunction_Check(bare)) {
        return;
    }
    PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(bare)->m_ml;
    const auto signatures = signaturesOf(name, definition->ml_doc == nullptr ? "" : definition->ml_doc);
    if (signatures.empty()) {
        return;
    }
    const auto longest =
        std::max_element(signatures.begin(), signatures.end(), [](const auto& a, const auto& b) {
            return std::count(a.begin(), a.end(), ',') < std::count(b.begin(), b.end(), ',');
        });
    // Python takes the first line as __text_signature__ and shows the rest as __doc__.
    std::string text = name + "(" + *longest + ")\n--\n\n" + docstring(className + "." + name);
    for (const std::string& other : signatures) {
        if (other != *longest) {
            text += "\n\nAlso: " + name + "(" + other + ")";
        }
    }
    std::free(const_cast<char*>(definition->ml_doc));  // pybind11 made it with strdup(), and will free ours
    definition->ml_doc = strdup(text.c_str());
}

}  // namespace

void prepareModule() {
    watchProcess();
    urrtde::setInterruptCheck(&userLostPatience);
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const urrtde::Interrupted&) {
            if (PyErr_Occurred() == nullptr) {
                PyErr_SetNone(PyExc_KeyboardInterrupt);
            }
        }
    });
}

void finishModule(py::module_& module) {
    module.attr("__version__") = TILLER_VERSION;
    if (std::getenv("TILLER_STUBS") != nullptr) {
        return;  // make_stub.py reads the signatures with their types
    }
    for (const auto& [key, value] : py::dict(module.attr("__dict__"))) {
        if (!py::isinstance<py::type>(value)) {
            continue;
        }
        const auto className = py::cast<std::string>(key);
        if (const char* text = docstring(className); *text != '\0') {
            value.attr("__doc__") = text;
        }
        for (const auto& [name, member] : py::dict(value.attr("__dict__"))) {
            if (py::isinstance<py::function>(member) || PyInstanceMethod_Check(member.ptr())) {
                finishFunction(className, py::cast<std::string>(name), member);
            }
        }
    }
}

}  // namespace tiller::python
