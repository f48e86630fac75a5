// SPDX-License-Identifier: MIT
// One command: wait for its turn and for the program to be ready, send, wait for the answer.
#include <QScopeGuard>

#include "robot/ur_rtde/custom/custom_control.h"
#include "robot/ur_rtde/detail/waiting.h"

namespace tiller::urrtde {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReadyTime(3000);
// A move takes as long as it takes: at a speed slider of 2 % a minute becomes an hour.
constexpr milliseconds kEver = std::chrono::hours(24 * 365);

std::vector<double> numbered(const Command& command) {
    std::vector<double> values{static_cast<double>(command.id)};
    values.insert(values.end(), command.values.begin(), command.values.end());
    return values;
}

// What was not sent needs no end, but what an earlier client or program left must not begin by itself.
void clearUnlessStopping(RegisterLink& link) {
    if (!link.isCommandAlone()) {
        link.clear();
    }
}

// A connection with no room for it just now has some a moment later.
bool sendStop(RegisterLink& link, const Command& command) {
    bool sent = link.sendAlone(command.recipe, numbered(command));
    for (int i = 0; i < 20 && !sent && link.isAlive(); ++i) {
        std::this_thread::sleep_for(milliseconds(5));
        sent = link.sendAlone(command.recipe, numbered(command));
    }
    return sent;
}

}  // namespace

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
    // A stop nobody waited for is done at standstill. Programs of others may not know it.
    const auto isFree = [&link](const RegisterState&) { return !link.isCommandAlone(); };
    if (!link.wait(isFree, giveUp, kReadyTime)) {
        if (!link.isAlive() || giveUp(link.state()) || !link.state().isPlaying()) {
            return false;
        }
        link.forgetCommandAlone();
    }
    return link.wait([](const RegisterState& state) { return state.answer == 1; }, giveUp, kReadyTime);
}

// Only after the program has seen a command does "ready" say that it has seen its end too.
void CustomControl::untilSeen(RegisterLink& link, std::uint64_t sent, milliseconds atMost) {
    constexpr int kPackages = 3;  // for programs of others, which may call themselves ready all the time
    link.wait([&](const RegisterState& s) { return s.answer != 1 || s.sequence > sent + kPackages; },
              [this](const RegisterState& s) { return s.isStopped() || s.hasEnded() || disconnecting_; },
              atMost);
}

std::optional<Answer> CustomControl::perform(const Command& command) {
    const TurnLock turn = takeTurn();
    const auto done = performInTurn(command, true);
    return done ? std::optional(Answer{done->result, done->values}) : std::nullopt;
}

std::optional<RegisterState> CustomControl::performInTurn(const Command& command, bool mayBeStopped) {
    const auto current = link();
    if (!current || !current->isAlive()) {
        return std::nullopt;
    }
    RegisterLink& robot = *current;
    // Two reasons to stop waiting that are no failure of the link.
    const auto hopeless = [&](const RegisterState& state) {
        return state.isStopped() || (!mayBeStopped && !state.isPlaying()) ||
               (mayBeStopped && stopsWaiting_ > 0) || disconnecting_;
    };
    // A program of others may never answer a stop, which must not keep the next one waiting. And an
    // interrupted stop takes the place of whatever is under way.
    const auto pointless = [&](const RegisterState& state) {
        return hopeless(state) || stopsWaiting_ > 0 || !robot.holds(command.id);
    };
    if (hopeless(robot.state())) {
        say("the robot is stopped, or the control program does not run");
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
                // Programs written for others answer some questions with "ready" only, a few packages later.
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
            sendStop(robot, command);  // paused before it was seen: obeyed when the program goes on
        } else {
            robot.clear(command.id);
        }
        return done ? std::optional(answer) : std::nullopt;
    } catch (const Interrupted&) {
        // Nobody waits for it any more: it shall not go on by itself.
        const Uninterrupted stopping;
        untilSeen(robot, sent, milliseconds(50));
        robot.clear(command.id);
        robot.wait([](const RegisterState& state) { return state.answer == 1; }, hopeless, milliseconds(100));
        sendStop(robot, {CommandId::StopJ, 20, {4.0, 1.0}});
        throw;
    }
}

bool CustomControl::stop(const Command& command, bool wait) {
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
            say("no program runs that could be stopped");
            clearUnlessStopping(robot);
            return false;
        }
        tried = true;
        if (ready && wait) {
            return performInTurn(command, false).has_value();
        }
        // A program that is paused, or does not answer, obeys when it goes on.
        return sendStop(robot, command) && ready;
    } catch (const Interrupted&) {
        if (current && !tried) {
            const Uninterrupted stopping;
            sendStop(*current, command);
        }
        throw;
    }
}

bool CustomControl::stream(const Command& command) {
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
        current->clear(CommandId::ProtectiveStop);  // not at some later time
    }
    return stopped;
}

bool CustomControl::kickWatchdog() {
    const auto current = link();
    return current && current->kick();
}

}  // namespace tiller::urrtde
