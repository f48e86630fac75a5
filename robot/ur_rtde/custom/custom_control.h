// SPDX-License-Identifier: MIT
#pragma once

// Executes the commands of RTDEControlInterface through a user program with ur_rtde's registers. Only
// programs sent by this class contain the heartbeat watchdog; apart from the watchdog, the program determines
// when its motions end. The behaviour of a program started elsewhere depends entirely on that program.

#include "robot/ur_rtde/custom/register_link.h"
#include "robot/ur_rtde/detail/control_session.h"
#include "robot/ur_rtde/script_client.h"

#include "robot/core/turn.h"

namespace tiller::urrtde {

class CustomControl final : public ControlBackend {
public:
    /// Connects, and sends the file or waits for a program that is started by other means. Throws the same
    /// exceptions as RTDEControlInterface.
    /// file  program to send; empty: no program is sent
    CustomControl(const SessionOptions& options, Pendant& pendant, ProgramServer* server, std::string file);
    ~CustomControl() override;

    void disconnect(control::Supervision supervision) override;
    bool isConnected() const override;
    SoftwareVersion version() const override;
    control::JointLimits jointLimits() const override;
    std::uint32_t robotStatus() const override { return state().robotStatus; }
    int progress() const override { return state().progress; }
    std::string lastError() const override;

    std::optional<CommandResult> perform(const RecipeCommand& command) override;
    bool stop(const RecipeCommand& command, bool wait) override;
    bool stream(const RecipeCommand& command) override;
    bool follow(const ur_rtde::Path& path, bool asynchronous) override;
    bool kickWatchdog() override;
    bool protectiveStop() override;
    bool reupload() override;
    void stopProgram() override;
    bool runCustom(const std::string& program, control::Supervision supervision) override;

private:
    using TurnLock = std::unique_lock<Turn>;
    TurnLock takeTurn();
    TurnLock takeTurnToStop();  ///< cancels the wait of another thread
    RegisterState state() const;
    void untilSeen(RegisterLink& link, std::uint64_t sent, std::chrono::milliseconds atMost);
    std::shared_ptr<RegisterLink> link() const;
    bool isReady(RegisterLink& link, const std::function<bool(const RegisterState&)>& giveUp);
    std::optional<RegisterState> performInTurn(const RecipeCommand& command, bool mayBeStopped);
    bool endProgram(RegisterLink& link);
    bool upload(RegisterLink& link, const std::string& pathCode);
    bool sendScript(const RegisterLink& link, const std::string& text);
    bool awaitProgram(RegisterLink& link, std::chrono::milliseconds atMost,
                      const std::function<bool(const RegisterState&)>& giveUp = {});
    void connect();
    void startProgram(RegisterLink& link);
    std::string program(RegisterLink& link, const std::string& pathCode, bool bare) const;
    void say(const std::string& text) const;

    const SessionOptions& options_;
    Pendant& pendant_;
    ProgramServer* server_;
    const std::string scriptFile_;
    std::optional<std::uint64_t> playedBefore_;  ///< packet count before the last upload; empty: not sent
    Turn turn_;                                  ///< serializes commands
    std::atomic<int> stopsWaiting_{0};           ///< number of threads requesting a stop
    std::atomic<bool> disconnecting_{false};
    mutable std::mutex linkMutex_;  ///< protects the following members
    std::shared_ptr<RegisterLink> link_;
    mutable std::string error_;
    std::unique_ptr<ur_rtde::ScriptClient> scripts_;
};

}  // namespace tiller::urrtde
