// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/dashboard_client.h"

#include <deque>
#include <iostream>
#include <mutex>
#include <stdexcept>

#include "robot/dashboard/dashboard_client.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace ur_rtde {

using tiller::urrtde::within;

namespace {
constexpr std::chrono::milliseconds kReplyTime(2500);
}

struct DashboardClient::Private {
    Private(const std::string& host, int port, bool v)
        : client(QString::fromStdString(host), port), verbose(v) {}

    std::recursive_mutex mutex;
    tiller::dashboard::DashboardClient client;
    bool verbose;
    std::deque<std::string> replies;  ///< replies to lines sent by send()

    template <class Refused = std::logic_error>
    std::string ask(const std::string& line) {
        const std::lock_guard lock(mutex);
        const auto reply = client.command(QString::fromStdString(line), within(kReplyTime));
        if (!reply && reply.error().code == tiller::ErrorCode::RemoteControlRequired) {
            throw Refused(line + ": " + reply.error().controllerMessage.toStdString());
        }
        if (!reply && reply.error().code == tiller::ErrorCode::InvalidArgument) {
            throw std::invalid_argument(reply.error().toString().toStdString());
        }
        if (!reply) {
            tiller::urrtde::raise(reply.error());
        }
        if (verbose) {
            std::cout << "DashboardClient: " << line << " -> " << reply->toStdString() << std::endl;
        }
        return reply->toStdString();
    }

    /// Sends a line and returns the reply, which must have this prefix.
    template <class Refused = std::logic_error>
    std::string order(const std::string& line, const std::string& beginning) {
        const std::string reply = ask<Refused>(line);
        if (reply.compare(0, beginning.size(), beginning) != 0) {
            throw Refused(line + ": " + reply);
        }
        return reply;
    }

    bool isTrue(const std::string& line) {
        const QString reply = QString::fromStdString(ask(line)).toLower();
        return reply == QLatin1String("true") || reply.startsWith(QLatin1String("true "));
    }
};

DashboardClient::DashboardClient(std::string hostname, int port, bool verbose) {
    if (hostname.empty()) {
        throw std::invalid_argument("hostname is empty");
    }
    tiller::urrtde::check::port("port", port);
    d_ = std::make_unique<Private>(hostname, port, verbose);
}

DashboardClient::~DashboardClient() = default;

void DashboardClient::connect(uint32_t timeout_ms) {
    const std::lock_guard lock(d_->mutex);
    const auto connected = d_->client.connect(within(std::chrono::milliseconds(timeout_ms)));
    if (!connected) {
        d_->client.close();
        tiller::urrtde::raise(connected.error());
    }
    d_->replies.clear();
}

bool DashboardClient::isConnected() {
    const std::lock_guard lock(d_->mutex);
    return d_->client.checkConnection();
}

void DashboardClient::disconnect() {
    const std::lock_guard lock(d_->mutex);
    d_->client.close();
}

void DashboardClient::send(const std::string& str) {
    const std::lock_guard lock(d_->mutex);
    const std::size_t end = str.find_last_not_of("\r\n");
    // Read the reply at once, so that it cannot be mistaken for the reply to another line.
    d_->replies.push_back(d_->ask(end == std::string::npos ? std::string() : str.substr(0, end + 1)));
}

std::string DashboardClient::receive() {
    const std::lock_guard lock(d_->mutex);
    if (d_->replies.empty()) {
        throw std::logic_error("receive() requires a preceding send()");
    }
    std::string reply = std::move(d_->replies.front());
    d_->replies.pop_front();
    return reply;
}

// ---- programs -------------------------------------------------------------------------------------------

void DashboardClient::loadURP(const std::string& urp_name) {
    if (urp_name.empty()) {
        throw std::invalid_argument("urp_name is empty");
    }
    d_->order<std::runtime_error>("load " + urp_name, "Loading program: ");
}

void DashboardClient::play() {
    d_->order<std::runtime_error>("play", "Starting program");
}

void DashboardClient::stop() {
    d_->order<std::runtime_error>("stop", "Stopped");
}

void DashboardClient::pause() {
    d_->order<std::runtime_error>("pause", "Pausing program");
}

bool DashboardClient::running() {
    const std::string prefix = "Program running: ";
    return d_->order("running", prefix).substr(prefix.size()) == "true";
}

std::string DashboardClient::programState() {
    return d_->ask("programState");
}

std::string DashboardClient::getLoadedProgram() {
    return d_->ask("get loaded program");
}

bool DashboardClient::isProgramSaved() {
    return d_->isTrue("isProgramSaved");
}

// ---- power and safety -----------------------------------------------------------------------------------

void DashboardClient::powerOn() {
    d_->order("power on", "Powering on");
}

void DashboardClient::powerOff() {
    d_->order("power off", "Powering off");
}

void DashboardClient::brakeRelease() {
    d_->order("brake release", "Brake releasing");
}

void DashboardClient::unlockProtectiveStop() {
    d_->order("unlock protective stop", "Protective stop releasing");
}

void DashboardClient::restartSafety() {
    d_->order("restart safety", "Restarting safety");
}

void DashboardClient::closeSafetyPopup() {
    d_->order("close safety popup", "closing safety popup");
}

std::string DashboardClient::robotmode() {
    return d_->order("robotmode", "Robotmode: ");
}

std::string DashboardClient::safetymode() {
    return d_->order("safetymode", "Safetymode: ");
}

std::string DashboardClient::safetystatus() {
    return d_->order("safetystatus", "Safetystatus: ");
}

// ---- pendant and controller -----------------------------------------------------------------------------

void DashboardClient::popup(const std::string& message) {
    d_->order("popup " + message, "showing popup");
}

void DashboardClient::closePopup() {
    d_->order("close popup", "closing popup");
}

void DashboardClient::addToLog(const std::string& message) {
    d_->order("addToLog " + message, "Added log message");
}

void DashboardClient::setUserRole(const UserRole& role) {
    static constexpr const char* kNames[] = {"programmer", "operator", "none", "locked", "restricted"};
    d_->order(std::string("setUserRole ") + kNames[static_cast<std::size_t>(role)], "Setting user role: ");
}

void DashboardClient::quit() {
    d_->order("quit", "Disconnected");
    disconnect();
}

void DashboardClient::shutdown() {
    d_->order("shutdown", "Shutting down");
    disconnect();
}

std::string DashboardClient::polyscopeVersion() {
    const std::string reply = d_->ask("PolyscopeVersion");
    const std::size_t begin = reply.find_first_of("0123456789");
    const std::size_t end = reply.find_first_not_of("0123456789.", begin);
    if (begin == std::string::npos) {
        throw std::logic_error("PolyscopeVersion: " + reply);
    }
    return reply.substr(begin, end - begin);
}

std::string DashboardClient::getRobotModel() {
    return d_->order("get robot model", "UR");
}

std::string DashboardClient::getSerialNumber() {
    const std::string reply = d_->ask("get serial number");
    if (reply.empty() || reply.find_first_not_of("0123456789") != std::string::npos) {
        throw std::logic_error("get serial number: " + reply);
    }
    return reply;
}

bool DashboardClient::isInRemoteControl() {
    return d_->isTrue("is in remote control");
}

}  // namespace ur_rtde
