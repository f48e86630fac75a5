// SPDX-License-Identifier: MIT
#pragma once

// The dashboard server of the robot (CB3 and e-Series), one line for each command.
//
// Errors of every command: std::runtime_error when there is no connection, it breaks, or no reply comes
// within 2.5 s. With the server's own words when it answers something else than that it does as told:
// std::runtime_error from loadURP(), play(), stop() and pause(), std::logic_error from the others, as
// programs expect it.

#include <ur_rtde/dashboard_enums.h>
#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

/// Threads  any; calls are carried out one after the other.
class DashboardClient {
public:
    enum class ConnectionState : std::uint8_t { DISCONNECTED = 0, CONNECTED = 1 };

    explicit DashboardClient(std::string hostname, int port = 29999, bool verbose = false);
    virtual ~DashboardClient();
    DashboardClient(const DashboardClient&) = delete;
    DashboardClient& operator=(const DashboardClient&) = delete;

    /// Connects and reads the greeting.
    void connect(uint32_t timeout_ms = 2000);
    bool isConnected();
    void disconnect();

    /// Any command line, with or without its line end; receive() gives the reply.
    void send(const std::string& str);
    /// The reply to the oldest line sent that has not been fetched.
    std::string receive();

    // Programs
    void loadURP(const std::string& urp_name);
    void play();
    void stop();
    void pause();
    bool running();
    std::string programState();      ///< "STOPPED name"
    std::string getLoadedProgram();  ///< "Loaded program: " and its path, or that there is none
    bool isProgramSaved();

    // Power and safety
    void powerOn();
    void powerOff();
    void brakeRelease();
    void unlockProtectiveStop();
    void restartSafety();
    void closeSafetyPopup();
    std::string robotmode();     ///< "Robotmode: RUNNING"
    std::string safetymode();    ///< "Safetymode: NORMAL"
    std::string safetystatus();  ///< "Safetystatus: NORMAL"

    // Pendant
    void popup(const std::string& message);
    void closePopup();
    void addToLog(const std::string& message);
    void setUserRole(const UserRole& role);  ///< CB3

    // Controller
    void quit();                     ///< ends the connection
    void shutdown();                 ///< switches the robot and its controller off
    std::string polyscopeVersion();  ///< "5.22.1.1214193"
    std::string getRobotModel();
    std::string getSerialNumber();
    bool isInRemoteControl();

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
