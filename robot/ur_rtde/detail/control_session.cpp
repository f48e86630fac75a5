// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/detail/control_session.h"

#include <iostream>
#include <sstream>
#include <stdexcept>

#include "robot/ur_rtde/custom/custom_control.h"
#include "robot/ur_rtde/detail/native_control.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::urrtde {

namespace {

using ControlInterface = ur_rtde::RTDEControlInterface;

constexpr int kDashboardPort = 29999;

// Addresses of controllers that accept commands even in local control: the controller itself, and the
// vendor's virtual machine.
bool isExempt(const std::string& host) {
    return host == "localhost" || host == "127.0.0.1" || host == "192.168.56.101";
}

}  // namespace

void SessionOptions::say(const std::string& text) const {
    if (has(ControlInterface::FLAG_VERBOSE)) {
        std::cout << "RTDEControlInterface: " << text << std::endl;
    }
}

// ---- pendant --------------------------------------------------------------------------------------------

template <class Call>
void Pendant::tryTo(Call call) {
    const std::lock_guard lock(mutex_);
    if (!client_ || !client_->isConnected()) {
        return;
    }
    try {
        call(*client_);
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        options_.say(error.what());
    }
}

void Pendant::connect() {
    const std::lock_guard lock(mutex_);
    client_ = std::make_unique<ur_rtde::DashboardClient>(options_.host, kDashboardPort, false);
    try {
        client_->connect();
    } catch (const Interrupted&) {
        throw;
    } catch (const std::runtime_error& error) {
        options_.say(std::string("no dashboard server: ") + error.what());
    }
}

void Pendant::disconnect() {
    // A pending call to an unresponsive dashboard server holds the mutex. Do not wait for this call; its
    // socket remains open until the call returns.
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock()) {
        client_.reset();
    }
}

bool Pendant::isConnected() {
    const std::lock_guard lock(mutex_);
    return client_ && client_->isConnected();
}

std::string Pendant::serialNumber() {
    std::string number;  // not available in old software
    tryTo([&](ur_rtde::DashboardClient& dashboard) { number = dashboard.getSerialNumber(); });
    return number;
}

bool Pendant::allowsRemoteControl() {
    bool remote = true;
    tryTo([&](ur_rtde::DashboardClient& dashboard) {
        std::istringstream version(dashboard.polyscopeVersion());
        int major = 0;
        int minor = 0;
        char dot = 0;
        version >> major >> dot >> minor;
        remote = major != 5 || minor <= 5 || dashboard.isInRemoteControl();  // other versions do not have
                                                                             // this query
    });
    return remote;
}

void Pendant::stop() {
    tryTo([](ur_rtde::DashboardClient& dashboard) { dashboard.stop(); });
}

void Pendant::play() {
    tryTo([](ur_rtde::DashboardClient& dashboard) { dashboard.play(); });
}

void Pendant::unlockProtectiveStop() {
    const std::lock_guard lock(mutex_);
    if (!client_ || !client_->isConnected()) {
        throw std::runtime_error("unlockProtectiveStop: no dashboard server at " + options_.host);
    }
    client_->unlockProtectiveStop();
}

// ---- session --------------------------------------------------------------------------------------------

ControlSession::ControlSession(const SessionOptions& options) : options_(options) {
    if (options_.has(ControlInterface::FLAG_USE_EXT_UR_CAP)) {
        server_ = std::make_unique<ProgramServer>(options_.capPort);
    }
    connect();
}

ControlSession::~ControlSession() {
    disconnect();
}

std::shared_ptr<ControlBackend> ControlSession::backend() const {
    const std::lock_guard lock(mutex_);
    return backend_;
}

void ControlSession::put(std::shared_ptr<ControlBackend> backend) {
    const std::lock_guard lock(mutex_);
    backend_ = std::move(backend);
    error_.clear();
}

void ControlSession::disconnect(control::Supervision supervision) {
    if (const auto current = backend()) {
        current->disconnect(supervision);
    }
    pendant_.disconnect();
}

void ControlSession::reconnect() {
    disconnect();
    connect();
}

void ControlSession::connect() {
    const std::lock_guard lock(changing_);
    pendant_.connect();
    put(open());
    const SoftwareVersion version = backend()->version();
    identity_.versions = {version.major, version.minor, version.bugfix, version.build};
    identity_.serialNumber = pendant_.serialNumber();
}

std::shared_ptr<ControlBackend> ControlSession::open() {
    const bool uploads = options_.has(ControlInterface::FLAG_UPLOAD_SCRIPT);
    if (!isExempt(options_.host) && !server_ && !pendant_.allowsRemoteControl()) {
        throw std::logic_error("The robot at " + options_.host +
                               " is in local control. Switch it to remote control on the teach pendant.");
    }
    if (!scriptFile_.empty()) {
        return openCustom();
    }
    if (uploads || server_) {
        return openNative(false);
    }
    // Use the running program, or the next one that is started: a program of Tiller or of an earlier client,
    // otherwise one with ur_rtde's registers.
    std::shared_ptr<ControlBackend> ours;
    if (!options_.has(ControlInterface::FLAG_CUSTOM_SCRIPT)) {
        ours = openNative(true);
    }
    return ours ? ours : openCustom();
}

std::shared_ptr<ControlBackend> ControlSession::openNative(bool join) {
    auto native = std::make_shared<NativeControl>(options_, pendant_, server_.get());
    if (join) {
        return native->join() ? native : nullptr;
    }
    native->connect();
    return native;
}

std::shared_ptr<ControlBackend> ControlSession::openCustom() {
    return std::make_shared<CustomControl>(options_, pendant_, server_.get(), scriptFile_);
}

std::string ControlSession::lastError() const {
    {
        const std::lock_guard lock(mutex_);
        if (!error_.empty()) {
            return error_;
        }
    }
    return backend()->lastError();
}

// Also prints the text to standard error, as in ur_rtde.
void ControlSession::keepError(const std::string& text) {
    std::cerr << "RTDEControlInterface: " << text << std::endl;
    const std::lock_guard lock(mutex_);
    error_ = text;
}

bool ControlSession::isForeign() const {
    return dynamic_cast<const CustomControl*>(backend().get()) != nullptr;
}

bool ControlSession::reupload() {
    const std::lock_guard lock(changing_);
    const auto current = backend();
    if (!current->isConnected()) {
        return false;
    }
    const bool none =
        isForeign() && scriptFile_.empty() && !options_.has(ControlInterface::FLAG_CUSTOM_SCRIPT);
    if (!none) {
        return current->reupload();
    }
    current->stopProgram();
    current->disconnect(control::Supervision::Heartbeat);
    put(openNative(false));
    return true;
}

void ControlSession::useScriptFile(const std::string& file) {
    const std::lock_guard lock(changing_);
    const bool connected = isConnected();
    scriptFile_ = file;
    if (connected) {
        const auto current = backend();
        current->stopProgram();
        current->disconnect(control::Supervision::Heartbeat);
        put(open());
    }
}

}  // namespace tiller::urrtde
