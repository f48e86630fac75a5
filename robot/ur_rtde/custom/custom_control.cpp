// SPDX-License-Identifier: MIT
#include "robot/ur_rtde/custom/custom_control.h"

#include <QScopeGuard>
#include <sstream>

#include "robot/core/file_reading.h"
#include "robot/core/wait_until.h"
#include "robot/script/supervised_program.h"
#include "robot/ur_rtde/detail/arguments.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::urrtde {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ControlInterface = ur_rtde::RTDEControlInterface;

constexpr milliseconds kCustomConnectTime(5000);
constexpr milliseconds kProgramStart(5000);
constexpr milliseconds kCustomManualStart(60000);
constexpr milliseconds kProgramEnd(5000);
// No time limit, because at a speed slider of 2 %, a move of one minute takes almost an hour.
constexpr milliseconds kEver = std::chrono::hours(24 * 365);

const auto never = [](const RegisterState&) { return false; };
const auto isPlaying = [](const RegisterState& state) { return state.isPlaying(); };
const auto hasEnded = [](const RegisterState& state) { return state.hasEnded(); };

// Returns true for a complete user program. The built-in program is only the text between `def` and `end`.
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

// Placeholders for registers and paths in programs written for ur_rtde.
constexpr const char* kOffsetPlace = "  # register offset\n";
constexpr const char* kFloatOffsetPlace = "# float register offset\n";
constexpr const char* kIntOffsetPlace = "# int register offset\n";
constexpr const char* kPathPlace = "# inject move path\n";
constexpr const char* kHeaderEnd = "# HEADER_END";

constexpr milliseconds kReadyTime(3000);

std::vector<double> numbered(const RecipeCommand& command) {
    std::vector<double> values{static_cast<double>(command.id)};
    values.insert(values.end(), command.values.begin(), command.values.end());
    return values;
}

// The arm must not continue without its client.
const RecipeCommand kStopBeforeLeaving{CommandId::StopJ, 20, {4.0, 1.0}};
constexpr milliseconds kLastWords(160);

// Result register value after the watchdog thread has ended the program.
constexpr int kHeartbeatExpired = 100'004;

script::Heartbeat heartbeatOf(const RegisterLink& link) {
    script::Heartbeat heartbeat;
    heartbeat.number = link.heartbeatRegister();
    heartbeat.expired = {link.resultRegister(), kHeartbeatExpired};
    heartbeat.timeout = control::kHoldTime;
    return heartbeat;
}

// Clears a command of an earlier client or program, so that it cannot start later.
void clearUnlessStopping(RegisterLink& link) {
    if (!link.isCommandAlone()) {
        link.clear();
    }
}

// Retries if the send buffer of the connection is full.
bool sendStop(RegisterLink& link, const RecipeCommand& command) {
    bool sent = false;
    waitUntil(
        Deadline::after(milliseconds(100)),
        [&] {
            sent = link.sendAlone(command.recipe, numbered(command));
            return sent || !link.isAlive();
        },
        milliseconds(5));
    return sent;
}

}  // namespace

CustomControl::CustomControl(const SessionOptions& options, Pendant& pendant, ProgramServer* server,
                             std::string file)
    : options_(options), pendant_(pendant), server_(server), scriptFile_(std::move(file)) {
    connect();
}

CustomControl::~CustomControl() {
    disconnect(control::Supervision::Heartbeat);
}

void CustomControl::disconnect(control::Supervision supervision) {
    disconnecting_ = true;
    if (const auto current = link()) {
        current->endHeartbeat();
        if (supervision == control::Supervision::Heartbeat && isPlaying(current->state())) {
            const Uninterrupted stopping;
            sendStop(*current, kStopBeforeLeaving);
            current->wait([&](const RegisterState&) { return !current->isCommandAlone(); }, hasEnded,
                          kLastWords);
        }
        current->close();
    }
    // Wait until the calls of other threads have returned, at most 100 ms.
    if (const std::unique_lock turn(turn_, milliseconds(100)); turn.owns_lock()) {
        scripts_.reset();
    }
    disconnecting_ = false;
}

bool CustomControl::isConnected() const {
    const auto current = link();
    return current && current->isAlive();
}

RegisterState CustomControl::state() const {
    const auto current = link();
    return current ? current->state() : RegisterState();
}

std::shared_ptr<RegisterLink> CustomControl::link() const {
    const std::lock_guard lock(linkMutex_);
    return link_;
}

SoftwareVersion CustomControl::version() const {
    const auto current = link();
    return current ? current->version() : SoftwareVersion{};
}

control::JointLimits CustomControl::jointLimits() const {
    return check::anyArm();  // there is no connection to query
}

std::string CustomControl::lastError() const {
    const std::lock_guard lock(linkMutex_);
    return error_;
}

void CustomControl::say(const std::string& text) const {
    options_.say(text);
    const std::lock_guard lock(linkMutex_);
    error_ = text;
}

void CustomControl::connect() {
    RegisterLinkOptions wanted;
    wanted.host = QString::fromStdString(options_.host);
    wanted.frequency = options_.frequency > 0 ? options_.frequency : 0;
    wanted.offset = options_.offset();
    wanted.priority = options_.priority;
    auto opened = RegisterLink::open(wanted, within(kCustomConnectTime));
    if (!opened) {
        raise(opened.error());
    }
    std::shared_ptr<RegisterLink> fresh = std::move(opened).value();
    {
        const std::lock_guard lock(linkMutex_);
        link_ = fresh;
    }
    if (!fresh->wait([](const RegisterState& state) { return state.sequence > 0; }, never,
                     kCustomConnectTime)) {
        throw std::runtime_error("RTDE at " + options_.host + " sends no data");
    }
    fresh->clear();
    startProgram(*fresh);
}

void CustomControl::startProgram(RegisterLink& link) {
    if (server_ != nullptr && !scriptFile_.empty()) {
        server_->setProgram(program(link, {}, true));
    }
    if (server_ == nullptr && !scriptFile_.empty()) {
        if (isPlaying(link.state()) && !endProgram(link)) {
            throw std::runtime_error("The program that is running on the robot cannot be stopped");
        }
        if (!upload(link, {}) || !awaitProgram(link, kProgramStart)) {
            throw std::logic_error(
                "The program did not start within 5 s. Check that the robot is switched on, its brakes are "
                "released, and it accepts scripts.");
        }
        return;
    }
    if (!options_.has(ControlInterface::FLAG_NO_WAIT) && !awaitProgram(link, kCustomManualStart)) {
        throw std::logic_error("No program was started on the robot within 60 s");
    }
}

std::string CustomControl::program(RegisterLink& link, const std::string& pathCode, bool bare) const {
    const SoftwareVersion version = link.version();
    const auto content = readWholeFile(QString::fromStdString(scriptFile_), kMaxScriptBytes);
    if (!content) {
        throw std::runtime_error("cannot read the script " + scriptFile_);
    }
    std::string text = content->toStdString();
    ur_rtde::ScriptClient tool(options_.host, version.major, version.minor);
    const std::string number = std::to_string(options_.offset());
    for (const auto& [place, code] : {std::pair{kOffsetPlace, "  global O = " + number + "\n"},
                                      {kFloatOffsetPlace, number},
                                      {kIntOffsetPlace, number},
                                      {kPathPlace, pathCode}}) {
        if (text.find(place) != std::string::npos) {
            tool.setScriptInjection(place, code);
        }
    }
    if (!tool.removeUnsupportedFunctions(text) || !tool.scanAndInjectAdditionalScriptCode(text)) {
        throw std::runtime_error("The script " + scriptFile_ + " contains an invalid version marker");
    }
    if (!link.beginHeartbeat()) {
        throw std::runtime_error("Another client uses input_int_register_" +
                                 std::to_string(link.heartbeatRegister()) + ", which the heartbeat requires");
    }
    if (bare) {
        // In a program with the URCap, the header runs long before the URCap's node.
        const std::size_t header = text.find(kHeaderEnd);
        const std::size_t begin = header == std::string::npos ? 0 : text.find('\n', header) + 1;
        return text.insert(begin, script::watchdogScript(heartbeatOf(link), version).toStdString());
    }
    const std::string whole = isWhole(text) ? text : "def rtde_control():\n" + text + "end\n";
    return script::supervised(QString::fromStdString(whole), heartbeatOf(link), version).text.toStdString();
}

bool CustomControl::upload(RegisterLink& link, const std::string& pathCode) {
    playedBefore_ = link.state().played;
    if (scriptFile_.empty()) {
        return false;  // only the owner of the other program can start it
    }
    const std::string text = program(link, pathCode, server_ != nullptr);
    if (server_ != nullptr) {
        server_->setProgram(text);
        pendant_.play();  // the program that contains the URCap's node requests the text when it starts
        return true;
    }
    return sendScript(link, text);
}

bool CustomControl::sendScript(const RegisterLink& link, const std::string& text) {
    if (!scripts_) {
        scripts_ = std::make_unique<ur_rtde::ScriptClient>(options_.host, link.version().major,
                                                           link.version().minor);
    }
    if (!scripts_->isConnected()) {
        scripts_->connect();
    }
    return scripts_->sendScriptCommand(text);
}

bool CustomControl::awaitProgram(RegisterLink& link, milliseconds atMost,
                                 const std::function<bool(const RegisterState&)>& giveUp) {
    // A user program may already have ended.
    const auto ready = [&](const RegisterState& state) {
        return playedBefore_ ? state.played != *playedBefore_ : state.isPlaying();
    };
    return link.wait(ready, giveUp ? giveUp : never, atMost);
}

// Sends a command first. If the program does not respond, uses the dashboard.
bool CustomControl::endProgram(RegisterLink& link) {
    link.send(4, {static_cast<double>(CommandId::StopScript)});
    bool ended = link.wait(hasEnded, never, milliseconds(500));
    if (!ended) {
        pendant_.stop();
    }
    ended = ended || link.wait(hasEnded, never, kProgramEnd);
    ended = ended && link.wait([](const RegisterState& s) { return s.runtime == RuntimeState::Stopped; },
                               never, kProgramEnd);
    link.clear();
    return ended;
}

bool CustomControl::reupload() {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive()) {
        return false;
    }
    if (!endProgram(*current) || !upload(*current, {})) {
        return false;
    }
    // No program runs during a protective or emergency stop, so transferring the program is sufficient. The
    // next packets may still report a stop that has just been unlocked.
    const std::uint64_t settled = current->state().sequence + 50;
    bool stopped = false;
    const auto isStopped = [&](const RegisterState& state) {
        stopped = state.isStopped() && state.sequence > settled;
        return stopped;
    };
    return awaitProgram(*current, kProgramStart, isStopped) || stopped;
}

void CustomControl::stopProgram() {
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

bool CustomControl::runCustom(const std::string& program, control::Supervision supervision) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive() || !endProgram(*current)) {
        return false;
    }
    std::string text = program;
    if (supervision == control::Supervision::Heartbeat) {
        if (!current->beginHeartbeat()) {
            say("another client uses the register that the heartbeat requires");
            return false;
        }
        text = script::supervised(QString::fromStdString(program), heartbeatOf(*current), current->version())
                   .text.toStdString();
    }
    // Count packets with a running program, because the program may end before this thread checks. A short
    // program may even end before any packet reports it. In this case, use the final state of programs
    // written for ur_rtde.
    const RegisterState before = current->state();
    const auto hasBegun = [&before](const RegisterState& state) {
        return state.played != before.played || (before.answer != 2 && state.answer == 2);
    };
    const auto isUnwanted = [this](const RegisterState& state) {
        return state.isStopped() || stopsWaiting_ > 0;
    };
    const auto isOver = [](const RegisterState& state) { return state.runtime == RuntimeState::Stopped; };
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
        // No caller is waiting for the motion, so it must not continue.
        end();
        throw;
    }
    if (ran && current->state().result == kHeartbeatExpired) {
        say("no heartbeat reached the robot for 100 ms, so the custom script was ended");
        ran = false;
    }
    if (!ran && stopsWaiting_ > 0) {
        end();
        // The motion may not have started yet.
        current->wait(hasBegun, never, milliseconds(500));
        current->wait(isOver, never, kProgramEnd);
    }
    return upload(*current, {}) && awaitProgram(*current, kProgramStart) && ran;
}

bool CustomControl::follow(const ur_rtde::Path& path, bool asynchronous) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive() || !endProgram(*current) || !upload(*current, path.toScriptCode()) ||
        !awaitProgram(*current, kProgramStart)) {
        return false;
    }
    return performInTurn({CommandId::MovePath, 15, {asynchronous ? 1.0 : 0.0}}, true).has_value();
}

// ---- commands: wait for the lock and for the program to be ready, send, wait for the reply ----------------

CustomControl::TurnLock CustomControl::takeTurn() {
    TurnLock turn(turn_, std::defer_lock);
    while (!turn.try_lock_for(milliseconds(10))) {
        throwIfInterrupted();
    }
    return turn;
}

CustomControl::TurnLock CustomControl::takeTurnToStop() {
    ++stopsWaiting_;
    const auto arrived = qScopeGuard([this] { --stopsWaiting_; });
    if (const auto current = link()) {
        current->wake();
    }
    return takeTurn();
}

bool CustomControl::isReady(RegisterLink& link, const std::function<bool(const RegisterState&)>& giveUp) {
    // A stop without a waiting caller is complete at standstill, but other programs may not report
    // standstill.
    const auto isFree = [&link](const RegisterState&) { return !link.isCommandAlone(); };
    if (!link.wait(isFree, giveUp, kReadyTime)) {
        if (!link.isAlive() || giveUp(link.state()) || !link.state().isPlaying()) {
            return false;
        }
        link.forgetCommandAlone();
    }
    return link.wait([](const RegisterState& state) { return state.answer == 1; }, giveUp, kReadyTime);
}

// "Ready" means completion only after the program has read the command.
void CustomControl::untilSeen(RegisterLink& link, std::uint64_t sent, milliseconds atMost) {
    constexpr int kPackages = 3;  // for other programs, which may always report "ready"
    link.wait([&](const RegisterState& s) { return s.answer != 1 || s.sequence > sent + kPackages; },
              [this](const RegisterState& s) { return s.isStopped() || s.hasEnded() || disconnecting_; },
              atMost);
}

std::optional<CommandResult> CustomControl::perform(const RecipeCommand& command) {
    const TurnLock turn = takeTurn();
    const auto done = performInTurn(command, true);
    return done ? std::optional(CommandResult{done->result, done->values}) : std::nullopt;
}

std::optional<RegisterState> CustomControl::performInTurn(const RecipeCommand& command, bool mayBeStopped) {
    const auto current = link();
    if (!current || !current->isAlive()) {
        return std::nullopt;
    }
    RegisterLink& robot = *current;
    // Reasons to end the wait, other than a broken connection.
    const auto hopeless = [&](const RegisterState& state) {
        return state.isStopped() || (!mayBeStopped && !state.isPlaying()) ||
               (mayBeStopped && stopsWaiting_ > 0) || disconnecting_;
    };
    // Other programs may never reply to a stop, which must not block the next stop. An interrupted stop
    // replaces the current command.
    const auto pointless = [&](const RegisterState& state) {
        return hopeless(state) || stopsWaiting_ > 0 || !robot.holds(command.id);
    };
    if (hopeless(robot.state())) {
        say("the robot is stopped, or the control program is not running");
        clearUnlessStopping(robot);
        return std::nullopt;
    }
    if (!isReady(robot, hopeless) || !robot.send(command.recipe, numbered(command))) {
        say("the control program is not ready for a command");
        clearUnlessStopping(robot);
        return std::nullopt;
    }
    const std::uint64_t sent = robot.state().sequence;
    RegisterState answer;
    std::uint64_t readySince = 0;
    try {
        const bool done = robot.wait(
            [&](const RegisterState& state) {
                answer = state;
                // Other programs reply to some queries only with "ready", a few packets later.
                const bool quick =
                    command.id >= CommandId::ToolContact && command.id <= CommandId::JointPositionsHistory;
                readySince = readySince == 0 ? state.sequence : readySince;
                return state.isDone(static_cast<int>(command.id)) ||
                       (quick && state.sequence > readySince + 5);
            },
            pointless, kEver);
        if (!done) {
            untilSeen(robot, sent, milliseconds(1000));
        }
        const RegisterState now = robot.state();
        if (!done && !mayBeStopped && now.answer == 1 && !now.isPlaying() && !now.hasEnded()) {
            sendStop(robot, command);  // the paused program has not read the command and would run it later
        } else {
            robot.clear(command.id);
        }
        return done ? std::optional(answer) : std::nullopt;
    } catch (const Interrupted&) {
        // No caller is waiting for the motion, so it must not continue.
        const Uninterrupted stopping;
        untilSeen(robot, sent, milliseconds(50));
        robot.clear(command.id);
        robot.wait([](const RegisterState& state) { return state.answer == 1; }, hopeless, milliseconds(100));
        sendStop(robot, {CommandId::StopJ, 20, {4.0, 1.0}});
        throw;
    }
}

bool CustomControl::stop(const RecipeCommand& command, bool wait) {
    auto current = link();
    bool tried = false;
    try {
        const TurnLock turn = takeTurnToStop();
        current = link();
        if (!current || !current->isAlive()) {
            return false;
        }
        RegisterLink& robot = *current;
        const auto hopeless = [this](const RegisterState& state) {
            return state.hasEnded() || disconnecting_;
        };
        const auto isSilent = [&](const RegisterState& state) {
            return hopeless(state) || !state.isPlaying() || state.isStopped();
        };
        const bool ready = !isSilent(robot.state()) && isReady(robot, isSilent);
        if (hopeless(robot.state())) {
            say("no program is running");
            clearUnlessStopping(robot);
            return false;
        }
        tried = true;
        if (ready && wait) {
            return performInTurn(command, false).has_value();
        }
        // A program that is paused or does not respond executes the stop when it resumes.
        return sendStop(robot, command) && ready;
    } catch (const Interrupted&) {
        if (current && !tried) {
            const Uninterrupted stopping;
            sendStop(*current, command);
        }
        throw;
    }
}

bool CustomControl::stream(const RecipeCommand& command) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive()) {
        return false;
    }
    RegisterLink& robot = *current;
    const auto hopeless = [&](const RegisterState& state) {
        return state.isStopped() || stopsWaiting_ > 0 || disconnecting_;
    };
    if (hopeless(robot.state()) || !isReady(robot, hopeless)) {
        clearUnlessStopping(robot);
        return false;
    }
    return robot.send(command.recipe, numbered(command));
}

bool CustomControl::protectiveStop() {
    const auto isStopped = [](const RegisterState& state) { return (state.safetyStatus & (1U << 2)) != 0; };
    if (isStopped(state())) {
        return true;
    }
    stop({CommandId::ProtectiveStop, 4, {}}, false);
    const auto current = link();
    const bool stopped =
        current && current->wait(
                       isStopped, [](const RegisterState&) { return false; }, milliseconds(1000));
    if (current && !stopped) {
        current->clear(CommandId::ProtectiveStop);  // the command must not take effect later
    }
    return stopped;
}

bool CustomControl::kickWatchdog() {
    const auto current = link();
    return current && current->kick();
}

}  // namespace tiller::urrtde
