// SPDX-License-Identifier: MIT
#pragma once

// Client of the robot's dashboard server (CB3 and e-Series). Each command is one line.
//
// Errors of every command: std::runtime_error if there is no connection, if the connection breaks, or if
// there is no reply for 2.5 s. If the server refuses a command, the exception contains the reply:
// std::runtime_error from loadURP(), play(), stop() and pause(), std::logic_error from the other commands, as
// in ur_rtde.

#include <ur_rtde/dashboard_enums.h>
#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

/// Threads  any; calls are serialized
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

    /// Sends any command, with or without a line end; receive() returns the reply.
    void send(const std::string& str);
    /// Returns the oldest unread reply.
    std::string receive();

    // Programs
    void loadURP(const std::string& urp_name);
    void play();
    void stop();
    void pause();
    bool running();
    std::string programState();      ///< e.g. "STOPPED name"
    std::string getLoadedProgram();  ///< "Loaded program: " and the path, or a message that no program is
                                     ///< loaded
    bool isProgramSaved();

    // Power and safety
    void powerOn();
    void powerOff();
    void brakeRelease();
    void unlockProtectiveStop();
    void restartSafety();
    void closeSafetyPopup();
    std::string robotmode();     ///< e.g. "Robotmode: RUNNING"
    std::string safetymode();    ///< e.g. "Safetymode: NORMAL"
    std::string safetystatus();  ///< e.g. "Safetystatus: NORMAL"

    // Pendant
    void popup(const std::string& message);
    void closePopup();
    void addToLog(const std::string& message);
    void setUserRole(const UserRole& role);  ///< CB3 only

    // Controller
    void quit();                     ///< closes the connection
    void shutdown();                 ///< switches off the robot and the controller
    std::string polyscopeVersion();  ///< e.g. "5.22.1.1214193"
    std::string getRobotModel();
    std::string getSerialNumber();
    bool isInRemoteControl();

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
