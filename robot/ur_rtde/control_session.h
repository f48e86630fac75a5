// SPDX-License-Identifier: MIT
#pragma once

// The inside of RTDEControlInterface: gets the control program to run and has it carry out commands. Private
// to this room.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/turn.h"
#include "robot/ur_rtde/control_link.h"
#include "robot/ur_rtde/dashboard_client.h"
#include "robot/ur_rtde/program_server.h"
#include "robot/ur_rtde/rtde_control_interface.h"
#include "robot/ur_rtde/script_client.h"

namespace tiller::urrtde {

struct Command {
    CommandId id;
    int recipe;                  ///< 1 ... 20
    std::vector<double> values;  ///< of the recipe, without the command itself
};

struct SessionOptions {
    std::string host;
    double frequency = -1;
    std::uint16_t flags = 0;
    int capPort = 0;
    int priority = 0;

    bool has(ur_rtde::RTDEControlInterface::Flags flag) const { return (flags & flag) != 0; }
};

/// Threads  any; commands wait for their turn, stops do not
class ControlSession {
public:
    /// Connects and starts the program. Throws as RTDEControlInterface does.
    explicit ControlSession(const SessionOptions& options);
    ~ControlSession();

    void disconnect();
    void reconnect();
    bool isConnected() const;
    LinkState state() const;
    double controlPeriod() const;  ///< [s]
    /// Whether a program of the user's runs, which may know less than ours.
    bool isForeign() const {
        return options_.has(ur_rtde::RTDEControlInterface::FLAG_CUSTOM_SCRIPT) || !scriptFile_.empty();
    }

    /// Whether it is certain that ours runs, or none.
    bool isOurs() const {
        return !isForeign() && !server_ && options_.has(ur_rtde::RTDEControlInterface::FLAG_UPLOAD_SCRIPT);
    }

    /// Has a command carried out and waits until it is.
    /// Returns  the package that said so; none when it was not, or another thread stopped it
    std::optional<LinkState> perform(const Command& command);
    /// As perform(), but ends what another thread waits for instead of waiting for it.
    /// wait  false: return when it is on its way
    bool stop(const Command& command, bool wait = true);
    /// Sends one set point of a stream, without waiting for an answer.
    bool stream(const Command& command);
    /// Sends the path to the robot and follows it.
    bool follow(const std::string& pathCode, bool asynchronous);
    bool kickWatchdog();
    bool protectiveStop();

    bool reupload();
    void stopProgram();
    /// mark  what the program writes into integer register 1 first of all, from nextMark(); 0: nothing
    bool runCustom(const std::string& program, int mark = 0);
    int nextMark() { return kFirstMark + marks_++; }
    /// Throws std::runtime_error without a dashboard server.
    void unlockProtectiveStop();

    struct Identity {
        ur_rtde::Versions versions;
        std::string serialNumber;
    };
    const Identity& identity() const { return identity_; }
    int offset() const;  ///< of the registers: 0 or 24
    /// From now on; the program that runs is replaced.
    void useScriptFile(const std::string& file);

private:
    using TurnLock = std::unique_lock<Turn>;
    TurnLock takeTurn();
    TurnLock takeTurnToStop();  ///< ends what another thread waits for
    void untilSeen(ControlLink& link, std::uint64_t sent, std::chrono::milliseconds atMost);
    std::shared_ptr<ControlLink> link() const;
    bool isReady(ControlLink& link, const std::function<bool(const LinkState&)>& giveUp);
    std::optional<LinkState> performInTurn(const Command& command, bool mayBeStopped);
    bool endProgram(ControlLink& link);
    bool upload(ControlLink& link, const std::string& pathCode);
    bool sendScript(const ControlLink& link, const std::string& text);
    bool awaitProgram(ControlLink& link, std::chrono::milliseconds atMost,
                      const std::function<bool(const LinkState&)>& giveUp = {});
    void connectAndStart();
    void startProgram(ControlLink& link);
    void identify(const SoftwareVersion& version);
    void checkRemoteControl(const SoftwareVersion& version);
    std::string program(const SoftwareVersion& version, const std::string& pathCode, bool bare) const;
    void say(const std::string& text) const;

    static constexpr int kFirstMark = 0x40000000;  // no command has such a result

    const SessionOptions options_;
    Identity identity_;
    std::atomic<int> marks_{0};
    std::string scriptFile_;
    std::optional<std::uint64_t> playedBefore_;  ///< packages before the last upload; none: nothing was sent
    Turn turn_;                                  ///< one command after the other
    std::atomic<int> stopsWaiting_{0};           ///< threads that want to stop something
    std::atomic<bool> disconnecting_{false};
    mutable std::mutex linkMutex_;  ///< of the pointer
    std::shared_ptr<ControlLink> link_;
    std::unique_ptr<ur_rtde::DashboardClient> dashboard_;
    std::unique_ptr<ur_rtde::ScriptClient> scripts_;
    std::unique_ptr<ProgramServer> server_;
};

}  // namespace tiller::urrtde
