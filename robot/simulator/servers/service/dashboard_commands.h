// SPDX-License-Identifier: MIT
#pragma once

// The commands of the dashboard, each with its exact reply. Source: Dashboard Server guide. Replies that
// clients compare literally are recorded from the vendor's simulator.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

#include "robot/core/version.h"

namespace tiller::simulator {

class ControllerModel;
class ProgramStore;

class DashboardCommands {
public:
    DashboardCommands(ControllerModel& plant, ProgramStore& store) : plant_(plant), store_(store) {}

    /// Rights of a connection. They are determined when the connection is opened and end when the
    /// Local/Remote switch of the teach pendant changes.
    using Rights = std::uint64_t;
    Rights rightsOfNewClient() const;

    struct Reply {
        std::string line;  ///< reply without the newline
        bool closes = false;
    };
    Reply run(std::string_view line, Rights rights);

private:
    using Handler = std::string (DashboardCommands::*)(const std::string& argument);
    struct KnownCommand {
        std::string_view words;
        Handler handler;
        bool takesArgument = false;
        bool controls = false;  ///< refused in local control
        SoftwareVersion cb3{};
        SoftwareVersion eSeries{};
        SoftwareVersion listedCb3{};  ///< latest first version if sources disagree
        SoftwareVersion listedESeries{};
    };
    static const KnownCommand kCommands[];
    const KnownCommand* find(std::string_view line, std::string& argument) const;
    bool isKnown(const KnownCommand& command) const;
    std::string refused(const char* failure, const char* success) const;

    // program
    std::string load(const std::string& name);
    std::string loadInstallation(const std::string& name);
    std::string play(const std::string&);
    std::string stop(const std::string&);
    std::string pause(const std::string&);
    std::string running(const std::string&);
    std::string programState(const std::string&);
    std::string loadedProgram(const std::string&);
    std::string isProgramSaved(const std::string&);
    // power and safety
    std::string robotMode(const std::string&);
    std::string powerOn(const std::string&);
    std::string powerOff(const std::string&);
    std::string brakeRelease(const std::string&);
    std::string unlockProtectiveStop(const std::string&);
    std::string closeSafetyPopup(const std::string&);
    std::string restartSafety(const std::string&);
    std::string safetyMode(const std::string&);
    std::string safetyStatus(const std::string&);
    std::string shutdown(const std::string&);
    std::string quit(const std::string&);
    // user interface
    std::string popup(const std::string& text);
    std::string closePopup(const std::string&);
    std::string addToLog(const std::string& text);
    std::string saveLog(const std::string&);
    std::string setUserRole(const std::string& role);
    std::string getUserRole(const std::string&);
    // identity
    std::string polyscopeVersion(const std::string&);
    std::string version(const std::string&);
    std::string serialNumber(const std::string&);
    std::string robotModel(const std::string&);
    // operational mode, reports
    std::string isInRemoteControl(const std::string&);
    std::string setOperationalMode(const std::string& mode);
    std::string getOperationalMode(const std::string&);
    std::string clearOperationalMode(const std::string&);
    std::string flightReport(const std::string&);
    std::string supportFile(const std::string&);

    bool mayControl(Rights rights) const;

    ControllerModel& plant_;
    ProgramStore& store_;
    std::deque<std::string> log_;
    std::string userRole_ = "PROGRAMMER";
    unsigned flightReports_ = 0;
};

}  // namespace tiller::simulator
