// SPDX-License-Identifier: MIT
// The life of the control program: connecting, uploading, stopping, running others in between.
#include "robot/ur_rtde/control_session.h"

#include <fstream>
#include <iostream>
#include <sstream>

#include "robot/ur_rtde/control_program.h"
#include "robot/ur_rtde/waiting.h"

namespace tiller::urrtde {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Face = ur_rtde::RTDEControlInterface;

constexpr milliseconds kConnectTime(5000);
constexpr milliseconds kProgramStart(5000);
constexpr milliseconds kManualStart(60000);
constexpr milliseconds kProgramEnd(5000);
constexpr milliseconds kEver = std::chrono::hours(24 * 365);

const auto never = [](const LinkState&) { return false; };
const auto isPlaying = [](const LinkState& state) { return state.isPlaying(); };
const auto hasEnded = [](const LinkState& state) { return state.hasEnded(); };

// A whole program, as programs of users are; the built-in one is what stands between `def` and `end`.
bool isWhole(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.find_first_not_of(" \t\r");
        if (begin != std::string::npos && line[begin] != '#') {
            return line.compare(0, 4, "def ") == 0;
        }
    }
    return false;
}

// Addresses where a controller in Local is obeyed all the same: itself, and the vendor's virtual machine.
bool isExempt(const std::string& host) {
    return host == "localhost" || host == "127.0.0.1" || host == "192.168.56.101";
}

}  // namespace

ControlSession::ControlSession(const SessionOptions& options) : options_(options) {
    if (options_.has(Face::FLAG_USE_EXT_UR_CAP)) {
        server_ = std::make_unique<ProgramServer>(options_.capPort);
    }
    connectAndStart();
}

ControlSession::~ControlSession() {
    disconnect();
}

void ControlSession::disconnect() {
    disconnecting_ = true;
    if (const auto current = link()) {
        current->close();
    }
    // Whoever waited has noticed by now; who is talking to a mute server keeps its socket a little longer.
    if (const std::unique_lock turn(turn_, milliseconds(100)); turn.owns_lock()) {
        scripts_.reset();
        dashboard_.reset();
    }
    disconnecting_ = false;
}

void ControlSession::reconnect() {
    disconnect();
    const TurnLock turn = takeTurn();
    connectAndStart();
}

bool ControlSession::isConnected() const {
    const auto current = link();
    return current && current->isAlive();
}

LinkState ControlSession::state() const {
    const auto current = link();
    return current ? current->state() : LinkState();
}

std::shared_ptr<ControlLink> ControlSession::link() const {
    const std::lock_guard lock(linkMutex_);
    return link_;
}

double ControlSession::controlPeriod() const {
    const auto current = link();
    return current ? current->version().controlPeriod() : SoftwareVersion{5, 0, 0, 0}.controlPeriod();
}

int ControlSession::offset() const {
    return options_.has(Face::FLAG_UPPER_RANGE_REGISTERS) ? 24 : 0;
}

void ControlSession::say(const std::string& text) const {
    if (options_.has(Face::FLAG_VERBOSE)) {
        std::cout << "RTDEControlInterface: " << text << std::endl;
    }
}

void ControlSession::connectAndStart() {
    playedBefore_.reset();
    // PolyScope X has no dashboard server, and nothing below needs it.
    dashboard_ = std::make_unique<ur_rtde::DashboardClient>(options_.host, 29999, false);
    try {
        dashboard_->connect();
    } catch (const Interrupted&) {
        throw;
    } catch (const std::runtime_error& error) {
        say(std::string("no dashboard server: ") + error.what());
    }
    LinkOptions wanted;
    wanted.host = QString::fromStdString(options_.host);
    wanted.frequency = options_.frequency > 0 ? options_.frequency : 0;
    wanted.offset = offset();
    wanted.priority = options_.priority;
    auto opened = ControlLink::open(wanted, within(kConnectTime));
    if (!opened) {
        raise(opened.error());
    }
    std::shared_ptr<ControlLink> fresh = std::move(opened).value();
    identify(fresh->version());
    checkRemoteControl(fresh->version());
    {
        const std::lock_guard lock(linkMutex_);
        link_ = fresh;
    }
    if (!fresh->wait([](const LinkState& state) { return state.sequence > 0; }, never, kConnectTime)) {
        throw std::runtime_error("RTDE at " + options_.host + " sends no data");
    }
    fresh->clear();
    startProgram(*fresh);
}

void ControlSession::identify(const SoftwareVersion& version) {
    identity_.versions = {version.major, version.minor, version.bugfix, version.build};
    try {
        identity_.serialNumber = dashboard_->isConnected() ? dashboard_->getSerialNumber() : std::string();
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        identity_.serialNumber.clear();  // old software does not tell
        say(error.what());
    }
}

void ControlSession::unlockProtectiveStop() {
    const TurnLock turn = takeTurn();
    if (!dashboard_ || !dashboard_->isConnected()) {
        throw std::runtime_error("unlockProtectiveStop: no dashboard server at " + options_.host);
    }
    dashboard_->unlockProtectiveStop();
}

void ControlSession::checkRemoteControl(const SoftwareVersion& version) {
    const bool canTell = version.major == 5 && version.minor > 5 && dashboard_->isConnected();
    if (!canTell || isExempt(options_.host) || options_.has(Face::FLAG_USE_EXT_UR_CAP)) {
        return;
    }
    if (!dashboard_->isInRemoteControl()) {
        throw std::logic_error("The robot at " + options_.host +
                               " is in local control. Switch it to remote control on the pendant.");
    }
}

void ControlSession::startProgram(ControlLink& link) {
    if (server_) {
        server_->setProgram(program(link.version(), {}, true));
    }
    if (options_.has(Face::FLAG_UPLOAD_SCRIPT) && !server_) {
        if (isPlaying(link.state()) && !endProgram(link)) {
            throw std::runtime_error("The program that runs on the robot cannot be stopped");
        }
        if (!upload(link, {}) || !awaitProgram(link, kProgramStart)) {
            throw std::logic_error(
                "The control program does not run within 5 s: is the robot switched on, are its brakes "
                "released, "
                "and may scripts be sent to it?");
        }
        return;
    }
    if (!options_.has(Face::FLAG_NO_WAIT) && !awaitProgram(link, kManualStart)) {
        throw std::logic_error("No program was started on the robot within 60 s");
    }
}

std::string ControlSession::program(const SoftwareVersion& version, const std::string& pathCode,
                                    bool bare) const {
    std::string text = controlProgram();
    if (!scriptFile_.empty()) {
        std::ifstream file(scriptFile_, std::ios::binary);
        std::ostringstream content;
        content << file.rdbuf();
        if (!file) {
            throw std::runtime_error("cannot read the script " + scriptFile_);
        }
        text = content.str();
    }
    ur_rtde::ScriptClient tool(options_.host, version.major, version.minor);
    const std::string number = std::to_string(offset());
    for (const auto& [place, code] : {std::pair{kOffsetPlace, "  global O = " + number + "\n"},
                                      {kFloatOffsetPlace, number},
                                      {kIntOffsetPlace, number},
                                      {kPathPlace, pathCode}}) {
        if (text.find(place) != std::string::npos) {
            tool.setScriptInjection(place, code);
        }
    }
    if (!tool.removeUnsupportedFunctions(text) || !tool.scanAndInjectAdditionalScriptCode(text)) {
        throw std::runtime_error("The script " + scriptFile_ +
                                 " has a version mark that cannot be understood");
    }
    if (bare || isWhole(text)) {
        return text;
    }
    return "def rtde_control():\n" + text + "end\n";
}

bool ControlSession::upload(ControlLink& link, const std::string& pathCode) {
    playedBefore_ = link.state().played;
    const std::string text = program(link.version(), pathCode, server_ != nullptr);
    if (server_) {
        server_->setProgram(text);
        dashboard_->play();  // the program with the URCap's node asks again when it starts
        return true;
    }
    return sendScript(link, text);
}

bool ControlSession::sendScript(const ControlLink& link, const std::string& text) {
    if (!scripts_) {
        scripts_ = std::make_unique<ur_rtde::ScriptClient>(options_.host, link.version().major,
                                                           link.version().minor);
    }
    if (!scripts_->isConnected()) {
        scripts_->connect();
    }
    return scripts_->sendScriptCommand(text);
}

bool ControlSession::awaitProgram(ControlLink& link, milliseconds atMost,
                                  const std::function<bool(const LinkState&)>& giveUp) {
    // A program of the user's that was sent may be over already.
    const auto ready = [&](const LinkState& state) {
        return isForeign() && playedBefore_
                   ? state.played != *playedBefore_
                   : state.isPlaying() && (isForeign() || server_ || state.answer == 1);
    };
    return link.wait(ready, giveUp ? giveUp : never, atMost);
}

// The polite way first; the dashboard for programs that do not listen.
bool ControlSession::endProgram(ControlLink& link) {
    link.send(4, {static_cast<double>(CommandId::StopScript)});
    bool ended = link.wait(hasEnded, never, milliseconds(500));
    if (!ended && dashboard_ && dashboard_->isConnected()) {
        try {
            dashboard_->stop();
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception& error) {
            say(error.what());
        }
    }
    ended = ended || link.wait(hasEnded, never, kProgramEnd);
    ended = ended && link.wait([](const LinkState& s) { return s.runtime == RuntimeState::Stopped; }, never,
                               kProgramEnd);
    link.clear();
    return ended;
}

bool ControlSession::reupload() {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive()) {
        return false;
    }
    if (!endProgram(*current) || !upload(*current, {})) {
        return false;
    }
    // During a stop nothing runs; handed over is all there can be. One that was just unlocked may be in the
    // next packages still.
    const std::uint64_t settled = current->state().sequence + 50;
    bool stopped = false;
    const auto isStopped = [&](const LinkState& state) {
        stopped = state.isStopped() && state.sequence > settled;
        return stopped;
    };
    return awaitProgram(*current, kProgramStart, isStopped) || stopped;
}

void ControlSession::useScriptFile(const std::string& file) {
    {
        const TurnLock turn = takeTurn();
        scriptFile_ = file;
    }
    if (isConnected()) {
        reupload();
    }
}

void ControlSession::stopProgram() {
    auto current = link();
    try {
        const TurnLock turn = takeTurnToStop();
        current = link();
        if (current && current->isAlive()) {
            endProgram(*current);
        }
    } catch (const Interrupted&) {
        if (current) {
            current->send(4, {static_cast<double>(CommandId::StopScript)});
        }
        throw;
    }
}

bool ControlSession::runCustom(const std::string& text, int mark) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive() || !endProgram(*current)) {
        return false;
    }
    // It may be over before this thread looks, which is why the packages are counted; or before any package
    // tells that it plays: then its mark tells, or what programs written for ur_rtde end with.
    const LinkState before = current->state();
    const auto hasBegun = [&before, mark](const LinkState& state) {
        return state.played != before.played || (mark != 0 && state.result == mark) ||
               (before.answer != 2 && state.answer == 2);
    };
    const auto isUnwanted = [this](const LinkState& state) { return state.isStopped() || stopsWaiting_ > 0; };
    const auto isOver = [](const LinkState& state) { return state.runtime == RuntimeState::Stopped; };
    const auto end = [&] {
        const Uninterrupted stopping;
        try {
            if (!sendScript(*current, "stop program\n")) {
                say("the custom script could not be stopped");
            }
        } catch (const std::runtime_error& error) {
            say(error.what());
        }
    };
    bool ran = false;
    try {
        ran = sendScript(*current, text) && current->wait(hasBegun, isUnwanted, kProgramStart) &&
              current->wait(hasEnded, isUnwanted, kEver) && current->wait(isOver, never, kProgramEnd);
    } catch (const Interrupted&) {
        // Nobody waits for it any more: it shall not go on by itself.
        end();
        throw;
    }
    if (!ran && stopsWaiting_ > 0) {
        end();
        // It may have been on its way still.
        current->wait(hasBegun, never, milliseconds(500));
        current->wait(isOver, never, kProgramEnd);
    }
    return upload(*current, {}) && awaitProgram(*current, kProgramStart) && ran;
}

bool ControlSession::follow(const std::string& pathCode, bool asynchronous) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive() || !endProgram(*current) || !upload(*current, pathCode) ||
        !awaitProgram(*current, kProgramStart)) {
        return false;
    }
    return performInTurn({CommandId::MovePath, 15, {asynchronous ? 1.0 : 0.0}}, true).has_value();
}

}  // namespace tiller::urrtde
