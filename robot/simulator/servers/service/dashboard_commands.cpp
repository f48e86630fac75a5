// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/dashboard_commands.h"

#include <QDateTime>
#include <algorithm>
#include <cctype>

#include "robot/core/ascii.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/plant/personality.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/programs/program_store.h"
#include "robot/simulator/servers/service/support_file.h"

namespace tiller::simulator {

namespace {

using C = DashboardCommands;
constexpr SoftwareVersion kNever{99, 0, 0, 0};

constexpr const char* kRefusedInLocal =
    "Command is not allowed due to safety reasons, please switch robot to Remote Control mode and reconnect "
    "to port 29999";

bool startsWithIgnoringCase(std::string_view text, std::string_view start) {
    return text.size() >= start.size() && std::equal(start.begin(), start.end(), text.begin(),
                                                     [](char a, char b) { return lower(a) == lower(b); });
}

std::string upper(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return text;
}

}  // namespace

// If one command is the start of another, the longer command must be first.
const DashboardCommands::KnownCommand DashboardCommands::kCommands[] = {
    {"load installation", &C::loadInstallation, true, true, {3, 2, 0, 0}, {}},
    {"load", &C::load, true, true, {}, {}},
    {"play", &C::play, false, true, {}, {}},
    {"stop", &C::stop, false, true, {}, {}},
    {"pause", &C::pause, false, true, {}, {}},
    {"running", &C::running, false, false, {}, {}},
    {"programState", &C::programState, false, false, {}, {}},
    {"get loaded program", &C::loadedProgram, false, false, {}, {}},
    {"isProgramSaved", &C::isProgramSaved, false, false, {}, {}},
    {"robotmode", &C::robotMode, false, false, {}, {}},
    {"power on", &C::powerOn, false, true, {}, {}},
    {"power off", &C::powerOff, false, true, {}, {}},
    {"brake release", &C::brakeRelease, false, true, {}, {}},
    {"unlock protective stop", &C::unlockProtectiveStop, false, true, {3, 1, 0, 0}, {}},
    {"close safety popup", &C::closeSafetyPopup, false, true, {3, 1, 0, 0}, {}},
    {"restart safety", &C::restartSafety, false, true, {3, 7, 0, 0}, {5, 1, 0, 0}},
    {"safetymode", &C::safetyMode, false, false, {}, {}},
    {"safetystatus",
     &C::safetyStatus,
     false,
     false,
     {3, 11, 0, 0},
     {5, 4, 0, 0},
     {3, 11, 0, 0},
     {5, 5, 0, 0}},
    {"shutdown", &C::shutdown, false, true, {}, {}},
    {"quit", &C::quit, false, false, {}, {}},
    {"popup", &C::popup, true, false, {}, {}},
    {"close popup", &C::closePopup, false, false, {}, {}},
    {"addToLog", &C::addToLog, true, false, {}, {}},
    {"saveLog", &C::saveLog, false, false, {3, 13, 0, 0}, {5, 8, 0, 0}},
    {"setUserRole", &C::setUserRole, true, false, {}, kNever, {3, 1, 0, 0}},
    {"getUserRole", &C::getUserRole, false, false, {3, 1, 0, 0}, kNever},
    {"PolyscopeVersion", &C::polyscopeVersion, false, false, {}, {}},
    {"version", &C::version, false, false, kNever, {}, {}, {5, 13, 0, 0}},
    {"get serial number", &C::serialNumber, false, false, {3, 12, 0, 0}, {5, 6, 0, 0}},
    {"get robot model", &C::robotModel, false, false, {3, 12, 0, 0}, {5, 6, 0, 0}},
    {"is in remote control", &C::isInRemoteControl, false, false, kNever, {5, 6, 0, 0}},
    {"set operational mode", &C::setOperationalMode, true, false, kNever, {}},
    {"get operational mode", &C::getOperationalMode, false, false, kNever, {5, 6, 0, 0}},
    {"clear operational mode", &C::clearOperationalMode, false, false, kNever, {}},
    {"generate flight report", &C::flightReport, true, false, {3, 13, 0, 0}, {5, 8, 0, 0}},
    {"generate support file", &C::supportFile, true, false, {3, 13, 0, 0}, {5, 8, 0, 0}},
};

DashboardCommands::Rights DashboardCommands::rightsOfNewClient() const {
    // A connection opened in local control never gets the right to control the robot.
    return plant_.isRemoteControl() ? plant_.controlEpoch() + 1 : 0;
}

bool DashboardCommands::mayControl(Rights rights) const {
    // Clients on the controller itself are exempt. With a simulator on this PC, these are all clients, unless
    // gateLoopbackClients is set.
    const SimulatorOptions& options = plant_.options();
    const bool loopback = options.listenAddress.startsWith(QLatin1String("127."));
    const bool gated = options.gateLocalControl && (!loopback || options.gateLoopbackClients);
    return !gated || options.software.isCb3() || rights == plant_.controlEpoch() + 1;
}

bool DashboardCommands::isKnown(const KnownCommand& command) const {
    const SoftwareVersion& software = plant_.options().software;
    const bool isListed = plant_.assumptions().firstVersions == BehaviourOptions::FirstVersions::Latest;
    return software >= (software.isCb3() ? command.cb3 : command.eSeries) &&
           (!isListed || software >= (software.isCb3() ? command.listedCb3 : command.listedESeries));
}

/// Software before 3.4 replies as if the command had been executed.
std::string DashboardCommands::refused(const char* failure, const char* success) const {
    return plant_.options().software >= SoftwareVersion{3, 4, 0, 0} ? failure : success;
}

const DashboardCommands::KnownCommand* DashboardCommands::find(std::string_view line,
                                                               std::string& argument) const {
    for (const KnownCommand& command : kCommands) {
        if (!startsWithIgnoringCase(line, command.words) || !isKnown(command)) {
            continue;
        }
        const std::string_view rest = line.substr(command.words.size());
        if (rest.empty() || (command.takesArgument && rest.front() == ' ')) {
            argument = trimmed(rest);
            return &command;
        }
    }
    return nullptr;
}

DashboardCommands::Reply DashboardCommands::run(std::string_view line, Rights rights) {
    line = trimmed(line);
    std::string argument;
    const KnownCommand* command = find(line, argument);
    if (command == nullptr) {
        return {"could not understand: '" + std::string(line) + "'"};
    }
    if (command->controls && !mayControl(rights)) {
        return {kRefusedInLocal};
    }
    const bool closes = command->handler == &C::quit || command->handler == &C::shutdown;
    return {(this->*command->handler)(argument), closes};
}

// ---- program --------------------------------------------------------------------------------------------

namespace {
/// Removes the quotes that some clients put around file names.
QString unquoted(const std::string& name) {
    const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
    return QString::fromStdString(quoted ? name.substr(1, name.size() - 2) : name);
}
}  // namespace

std::string DashboardCommands::load(const std::string& name) {
    if (const Result<void> loaded = store_.load(unquoted(name)); !loaded) {
        const Error error = loaded.error();
        if (error.code == ErrorCode::FileNotReadable) {
            return "File not found: " + name;
        }
        plant_.appendToLog("Error while loading program: " + name + ": " + error.context.toStdString());
        return "Error while loading program: " + name;
    }
    // The reply means "loaded", so the previous program must have ended.
    plant_.programs().stopNow();
    return "Loading program: " + name;
}

std::string DashboardCommands::loadInstallation(const std::string& name) {
    if (const Result<void> loaded = store_.loadInstallation(unquoted(name)); !loaded) {
        if (loaded.error().code == ErrorCode::FileNotReadable) {
            return "File not found: " + name;
        }
        plant_.appendToLog("Failed to load installation: " + name + ": " +
                           loaded.error().context.toStdString());
        return "Failed to load installation: " + name;
    }
    plant_.programs().stopNow();
    plant_.power().powerOff();
    return "Loading installation: " + name;
}

std::string DashboardCommands::play(const std::string&) {
    const std::string failed = refused("Failed to execute: play", "Starting program");
    ProgramRunner& programs = plant_.programs();
    if (plant_.power().mode() != RobotMode::Running || !allowsMotion(plant_.safety().mode()) ||
        plant_.popups().anyBlocking()) {
        return failed;
    }
    if (programs.isPaused() || programs.state() == RuntimeState::Pausing) {
        programs.resume();
        return "Starting program";
    }
    if (programs.state() == RuntimeState::Stopping || programs.isStopRequested()) {
        programs.stopNow();  // "stop" has been confirmed, so "play" may follow at once
    }
    if (!store_.isLoaded() || programs.isActive()) {
        return failed;
    }
    const Result<std::string> text = store_.script();
    if (!text) {
        plant_.appendToLog("Error while loading program: " + store_.name() + ": " +
                           text.error().context.toStdString());
        return failed;
    }
    if (text->find(pendant::kControlNode) != std::string::npos) {
        programs.submitControlled(*text, store_.scriptProvider());
        return "Starting program";
    }
    return programs.submitText(*text) ? "Starting program" : failed;
}

std::string DashboardCommands::stop(const std::string&) {
    // Succeeds if no program is running, because clients may stop a program that has just ended.
    plant_.programs().requestStop();
    return "Stopped";
}

std::string DashboardCommands::pause(const std::string&) {
    if (plant_.programs().state() != RuntimeState::Playing) {
        return refused("Failed to execute: pause", "Pausing program");
    }
    plant_.programs().pause();
    return "Pausing program";
}

std::string DashboardCommands::running(const std::string&) {
    const bool running = plant_.programs().isActive() && !plant_.programs().isPaused();
    return running ? "Program running: true" : "Program running: false";
}

std::string DashboardCommands::programState(const std::string&) {
    if (!store_.isLoaded()) {
        // Always include a name, because some clients wait for it.
        return "STOPPED <unnamed>";
    }
    const ProgramRunner& programs = plant_.programs();
    // Scripts sent over a socket are not included.
    const char* state = !programs.isFileProgram() ? "STOPPED" : programs.isPaused() ? "PAUSED" : "PLAYING";
    return state + (" " + store_.name());
}

std::string DashboardCommands::loadedProgram(const std::string&) {
    return store_.isLoaded() ? "Loaded program: " + store_.path().toStdString() : "No program loaded";
}

std::string DashboardCommands::isProgramSaved(const std::string&) {
    return "true " + (store_.isLoaded() ? store_.name() : std::string("<unnamed>"));
}

// ---- power and safety -----------------------------------------------------------------------------------

std::string DashboardCommands::robotMode(const std::string&) {
    return "Robotmode: " + robotModeName(plant_.power().mode()).toStdString();
}

std::string DashboardCommands::powerOn(const std::string&) {
    plant_.powerOn();
    return "Powering on";
}

std::string DashboardCommands::powerOff(const std::string&) {
    plant_.power().powerOff();
    return "Powering off";
}

std::string DashboardCommands::brakeRelease(const std::string&) {
    plant_.releaseBrakes();
    return "Brake releasing";
}

std::string DashboardCommands::unlockProtectiveStop(const std::string&) {
    return plant_.safety().unlockProtectiveStop(true) ? "Protective stop releasing"
                                                      : "Cannot unlock protective stop until 5s after "
                                                        "occurrence. Always inspect cause of protective "
                                                        "stop before unlocking";
}

std::string DashboardCommands::closeSafetyPopup(const std::string&) {
    return "closing safety popup";
}

std::string DashboardCommands::restartSafety(const std::string&) {
    plant_.restartSafety();
    return "Restarting safety";
}

std::string DashboardCommands::safetyMode(const std::string&) {
    return "Safetymode: " + safetyModeName(plant_.safety().mode()).toStdString();
}

std::string DashboardCommands::safetyStatus(const std::string&) {
    return "Safetystatus: " + safetyModeName(plant_.safety().status()).toStdString();
}

std::string DashboardCommands::shutdown(const std::string&) {
    plant_.shutDown();
    return "Shutting down";
}

std::string DashboardCommands::quit(const std::string&) {
    return "Disconnected";
}

// ---- user interface -------------------------------------------------------------------------------------

std::string DashboardCommands::popup(const std::string& text) {
    plant_.showPopup(text, false);
    return "showing popup";
}

std::string DashboardCommands::closePopup(const std::string&) {
    plant_.popups().closeNewest();
    return "closing popup";
}

std::string DashboardCommands::addToLog(const std::string& text) {
    if (text.empty()) {
        return "No log message to add";
    }
    constexpr std::size_t kMaxMessages = 10'000;
    if (log_.size() >= kMaxMessages) {
        log_.pop_front();
    }
    log_.push_back(std::to_string(plant_.timestamp()) + ' ' + text);
    return "Added log message";
}

std::string DashboardCommands::saveLog(const std::string&) {
    QByteArray content;
    for (const std::string& message : log_) {
        content += QByteArray::fromStdString(message) + '\n';
    }
    return store_.save(QStringLiteral("log_history.txt"), content) ? "Log saved to disk"
                                                                   : "Error: the log cannot be written";
}

std::string DashboardCommands::setUserRole(const std::string& role) {
    static constexpr std::string_view kRoles[] = {"PROGRAMMER", "OPERATOR", "NONE", "LOCKED", "RESTRICTED"};
    const std::string wanted = upper(role);
    if (std::find(std::begin(kRoles), std::end(kRoles), wanted) == std::end(kRoles)) {
        return "Failed setting user role: " + role;
    }
    userRole_ = wanted;
    return "Setting user role: " + role;
}

std::string DashboardCommands::getUserRole(const std::string&) {
    return userRole_;
}

// ---- identity -------------------------------------------------------------------------------------------

std::string DashboardCommands::polyscopeVersion(const std::string&) {
    const SoftwareVersion& software = plant_.options().software;
    return "URSoftware " + versionText(software) + " (" + releaseDate(software) + ')';
}

std::string DashboardCommands::version(const std::string&) {
    return versionText(plant_.options().software);
}

std::string DashboardCommands::serialNumber(const std::string&) {
    return plant_.options().serialNumber.toStdString();
}

std::string DashboardCommands::robotModel(const std::string&) {
    return plant_.arm().model().dashboardName;
}

std::string DashboardCommands::isInRemoteControl(const std::string&) {
    return plant_.isRemoteControl() ? "true" : "false";
}

std::string DashboardCommands::setOperationalMode(const std::string& mode) {
    const std::string wanted = upper(mode);
    if (wanted != "MANUAL" && wanted != "AUTOMATIC") {
        return "Failed setting operational mode: " + mode;
    }
    plant_.safety().setOperationalMode(wanted == "MANUAL" ? OperationalMode::Manual
                                                          : OperationalMode::Automatic);
    return "Operational mode " + wanted + " is set";
}

std::string DashboardCommands::getOperationalMode(const std::string&) {
    switch (plant_.safety().operationalMode()) {
        case OperationalMode::Manual:
            return "MANUAL";
        case OperationalMode::Automatic:
            return "AUTOMATIC";
        case OperationalMode::None:
            break;
    }
    return "NONE";
}

std::string DashboardCommands::clearOperationalMode(const std::string&) {
    plant_.safety().setOperationalMode(OperationalMode::None);
    return "No longer controlling the operational mode. Current operational mode: NONE";
}

std::string DashboardCommands::flightReport(const std::string& type) {
    const std::string wanted = upper(type);
    if (!wanted.empty() && wanted != "CONTROLLER" && wanted != "SOFTWARE" && wanted != "SYSTEM") {
        return "Error: unknown flight report type: " + type;
    }
    // A controller can take minutes to create a report. Two requests in quick succession create one report
    // each. Source: urcl tests.
    return "Flight Report generated with id:" + std::to_string(++flightReports_);
}

std::string DashboardCommands::supportFile(const std::string& directory) {
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    const QString name = QStringLiteral("ur_%1_%2.zip").arg(plant_.options().serialNumber, stamp);
    const std::string about = "model " + std::string(plant_.arm().model().name) + "\nserial " +
                              plant_.options().serialNumber.toStdString() + "\nsoftware " +
                              versionText(plant_.options().software) + "\nmode " +
                              robotModeName(plant_.power().mode()).toStdString() + "\nsafety " +
                              safetyModeName(plant_.safety().mode()).toStdString() + '\n';
    if (!store_.saveBelow(unquoted(directory), name,
                          zipOf("support.txt", QByteArray::fromStdString(about)))) {
        return "Error: invalid target location: " + directory;
    }
    return "Completed successfully:" + name.toStdString();
}

}  // namespace tiller::simulator
