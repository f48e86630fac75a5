// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/script_client.h"

#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "robot/control/programs.h"
#include "robot/core/file_reading.h"
#include "robot/script/script_client.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

using tiller::urrtde::within;

namespace {

constexpr std::chrono::milliseconds kScriptConnectTime(2000);
constexpr std::chrono::milliseconds kSendTime(5000);

std::optional<std::string> contentOf(const std::string& path) {
    const auto content = tiller::readWholeFile(QString::fromStdString(path), tiller::kMaxScriptBytes);
    return content ? std::optional(content->toStdString()) : std::nullopt;
}

}  // namespace

struct ScriptClient::Private {
    Private(const std::string& host, int port) : client(QString::fromStdString(host), port) {}

    std::recursive_mutex mutex;
    tiller::script::ScriptClient client;
    unsigned major = 0;
    unsigned minor = 0;
    bool verbose = false;
    std::string file;
    std::vector<std::pair<std::string, std::string>> injections;

    bool send(const std::string& text) {
        const std::lock_guard lock(mutex);
        const auto sent = client.send(QString::fromStdString(text), within(kSendTime));
        if (!sent && verbose) {
            std::cerr << "ScriptClient: " << sent.error().toString().toStdString() << std::endl;
        }
        if (!sent && sent.error().code == tiller::ErrorCode::Cancelled) {
            throw tiller::urrtde::Interrupted();
        }
        return sent.ok();
    }

    /// Evaluates a version mark, e.g. "5.10" or "3.15".
    /// Returns  true if the software has at least this version; empty for an invalid mark
    std::optional<bool> fits(const std::string& mark) const {
        std::istringstream text(mark);
        unsigned markMajor = 0;
        unsigned markMinor = 0;
        char dot = 0;
        if (!(text >> markMajor >> dot >> markMinor) || dot != '.') {
            return std::nullopt;
        }
        return major == markMajor && minor >= markMinor;
    }
};

ScriptClient::ScriptClient(std::string hostname, uint32_t major_control_version,
                           uint32_t minor_control_version, int port, bool verbose) {
    if (hostname.empty()) {
        throw std::invalid_argument("hostname is empty");
    }
    tiller::urrtde::check::port("port", port);
    d_ = std::make_unique<Private>(hostname, port);
    d_->major = major_control_version;
    d_->minor = minor_control_version;
    d_->verbose = verbose;
}

ScriptClient::~ScriptClient() = default;

void ScriptClient::connect() {
    const std::lock_guard lock(d_->mutex);
    if (const auto connected = d_->client.connect(within(kScriptConnectTime)); !connected) {
        tiller::urrtde::raise(connected.error());
    }
}

void ScriptClient::disconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->client.close();
}

bool ScriptClient::isConnected() {
    const std::lock_guard lock(d_->mutex);
    return d_->client.isConnected();
}

void ScriptClient::setScriptFile(const std::string& file_name) {
    const std::lock_guard lock(d_->mutex);
    d_->file = file_name;
}

bool ScriptClient::sendScript() {
    try {
        return sendScriptCommand(getScript());
    } catch (const tiller::urrtde::Interrupted&) {
        throw;
    } catch (const std::runtime_error&) {
        return false;
    }
}

bool ScriptClient::sendScript(const std::string& file_name) {
    const auto text = contentOf(file_name);
    return text && sendScriptCommand(*text);
}

bool ScriptClient::sendScriptCommand(const std::string& cmd_str) {
    return d_->send(cmd_str);
}

void ScriptClient::setScriptInjection(const std::string& search_string, const std::string& inject_string) {
    if (search_string.empty()) {
        throw std::invalid_argument("search_string is empty");
    }
    const std::lock_guard lock(d_->mutex);
    for (auto& [place, code] : d_->injections) {
        if (place == search_string) {
            code = inject_string;
            return;
        }
    }
    d_->injections.emplace_back(search_string, inject_string);
}

std::string ScriptClient::getScript() {
    const std::lock_guard lock(d_->mutex);
    std::string text;
    if (d_->file.empty()) {
        // Uses the program name of ur_rtde.
        text = tiller::control::Programs::controlProgram({d_->major, d_->minor, 0, 0},
                                                         tiller::control::RegisterRange::Lower)
                   .replace(QStringLiteral("def tiller_control()"), QStringLiteral("def rtde_control()"))
                   .toStdString();
    } else if (auto content = contentOf(d_->file)) {
        text = std::move(*content);
    } else {
        throw std::runtime_error("cannot read the script " + d_->file);
    }
    if (!removeUnsupportedFunctions(text) || !scanAndInjectAdditionalScriptCode(text)) {
        throw std::runtime_error(
            "the script contains an invalid version marker, or an injection marker is missing");
    }
    return text;
}

bool ScriptClient::removeUnsupportedFunctions(std::string& ur_script) {
    std::istringstream lines(ur_script);
    std::string kept;
    bool understood = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() != '$') {
            kept += line + "\n";
            continue;
        }
        constexpr std::size_t kOne = 5;   // length of "$5.4 "
        constexpr std::size_t kTwo = 10;  // length of "$5.10|3.15"
        const std::size_t bar = line.find('|');
        const bool two = bar != std::string::npos && bar < kTwo;
        const std::size_t width = two ? kTwo : kOne;
        const std::string mark = line.substr(1, (two ? bar : kOne) - 1);
        const auto first = d_->fits(mark);
        const auto second = two ? d_->fits(line.substr(bar + 1, kTwo - bar - 1)) : std::optional(false);
        if (!first || !second || line.size() < width) {
            understood = false;
            continue;
        }
        const unsigned firstMajor = static_cast<unsigned>(std::stoul(mark));
        if (*first || *second || d_->major > firstMajor) {
            kept += std::string(width, ' ') + line.substr(width) + "\n";
        }
    }
    ur_script = std::move(kept);
    return understood;
}

bool ScriptClient::scanAndInjectAdditionalScriptCode(std::string& ur_script) {
    bool all = true;
    for (const auto& [place, code] : d_->injections) {
        const std::size_t at = ur_script.find(place);
        if (at == std::string::npos) {
            all = false;
            continue;
        }
        ur_script.insert(at + place.size(), code);
    }
    return all;
}

}  // namespace ur_rtde
