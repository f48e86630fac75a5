// SPDX-License-Identifier: MIT
// One command: wait for its turn and for the program to be ready, send, wait for the answer.
#include "robot/ur_rtde/control_session.h"
#include "robot/ur_rtde/waiting.h"

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

}  // namespace

ControlSession::TurnLock ControlSession::takeTurn() {
    TurnLock turn(turn_, std::defer_lock);
    while (!turn.try_lock_for(milliseconds(10))) {
        throwIfInterrupted();
    }
    return turn;
}

bool ControlSession::isReady(ControlLink& link, const std::function<bool(const LinkState&)>& giveUp) {
    // A stop nobody waited for still has its answer to come, at standstill.
    return link.wait([&link](const LinkState&) { return !link.clearsWhenDone(); }, giveUp, kEver) &&
           link.wait([](const LinkState& state) { return state.answer == 1; }, giveUp, kReadyTime);
}

std::optional<LinkState> ControlSession::perform(const Command& command) {
    const TurnLock turn = takeTurn();
    return performInTurn(command, true);
}

std::optional<LinkState> ControlSession::performInTurn(const Command& command, bool mayBeStopped) {
    const auto current = link();
    if (!current || !current->isAlive()) {
        return std::nullopt;
    }
    ControlLink& robot = *current;
    const bool foreign = isForeign();
    const bool mayIdle = foreign || server_;
    // Two reasons to stop waiting that are no failure of the link.
    const auto hopeless = [&](const LinkState& state) {
        return state.isStopped() || (!mayIdle && !state.isPlaying()) || (mayBeStopped && stopsWaiting_ > 0) ||
               disconnecting_;
    };
    if (hopeless(robot.state())) {
        say("the robot is stopped, or the control program does not run");
        robot.clear();
        return std::nullopt;
    }
    if (!isReady(robot, hopeless) || !robot.send(command.recipe, numbered(command))) {
        say("the control program is not ready for a command");
        robot.clear();
        return std::nullopt;
    }
    const std::uint64_t sent = robot.state().sequence;
    LinkState answer;
    std::uint64_t readySince = 0;
    try {
        const bool done = robot.wait(
            [&](const LinkState& state) {
                answer = state;
                // Programs written for others answer some questions with "ready" only, a few packages later.
                const bool quick = foreign && command.id >= CommandId::ToolContact &&
                                   command.id <= CommandId::JointPositionsHistory;
                readySince = readySince == 0 ? state.sequence : readySince;
                return state.answer == 2 || (quick && state.sequence > readySince + 5);
            },
            hopeless, kEver);
        if (!done) {
            // Only when the program has seen it is "ready" an answer to its end.
            robot.wait(
                [sent](const LinkState& state) { return state.answer != 1 || state.sequence > sent + 3; },
                [this](const LinkState& state) { return state.isStopped() || disconnecting_; },
                milliseconds(100));
        }
        robot.clear();
        return done ? std::optional(answer) : std::nullopt;
    } catch (const Interrupted&) {
        // Nobody waits for it any more: it shall not go on by itself.
        const Uninterrupted stopping;
        robot.clear();
        robot.wait([](const LinkState& state) { return state.answer == 1; }, hopeless, milliseconds(100));
        robot.send(20, {static_cast<double>(CommandId::StopJ), 4.0, 1.0});
        robot.clearWhenDone();
        throw;
    }
}

bool ControlSession::stop(const Command& command, bool wait) {
    ++stopsWaiting_;
    if (const auto current = link()) {
        current->wake();
    }
    std::optional<TurnLock> turn;
    try {
        turn = takeTurn();
    } catch (...) {
        --stopsWaiting_;
        throw;
    }
    --stopsWaiting_;
    if (wait) {
        return performInTurn(command, false).has_value();
    }
    const auto current = link();
    const auto hopeless = [](const LinkState& state) { return state.isStopped() || !state.isPlaying(); };
    if (!current || !current->isAlive() || !isReady(*current, hopeless)) {
        return false;
    }
    const bool sent = current->send(command.recipe, numbered(command));
    current->clearWhenDone();
    return sent;
}

bool ControlSession::stream(const Command& command) {
    const TurnLock turn = takeTurn();
    const auto current = link();
    if (!current || !current->isAlive()) {
        return false;
    }
    ControlLink& robot = *current;
    const bool mayIdle = isForeign() || server_;
    const auto hopeless = [&](const LinkState& state) {
        return state.isStopped() || (!mayIdle && !state.isPlaying()) || disconnecting_;
    };
    if (hopeless(robot.state()) || !isReady(robot, hopeless)) {
        robot.clear();
        return false;
    }
    robot.countStream();
    return robot.send(command.recipe, numbered(command));
}

bool ControlSession::protectiveStop() {
    stop({CommandId::ProtectiveStop, 4, {}}, false);
    const auto current = link();
    return current &&
           current->wait([](const LinkState& state) { return (state.safetyStatus & (1U << 2)) != 0; },
                         [](const LinkState&) { return false; }, milliseconds(1000));
}

bool ControlSession::kickWatchdog() {
    const auto current = link();
    return current && current->kick();
}

}  // namespace tiller::urrtde
