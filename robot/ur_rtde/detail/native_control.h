// SPDX-License-Identifier: MIT
#pragma once

// Executes the commands of RTDEControlInterface through robot/control. The rules for motions and their ends
// are those of robot/control. Private to robot/ur_rtde.

#include <atomic>
#include <mutex>
#include <variant>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/core/turn.h"
#include "robot/ur_rtde/detail/control_session.h"

namespace tiller::urrtde {

class NativeControl final : public ControlBackend {
public:
    /// server  provides the program to the ExternalControl URCap; null: the program is sent
    NativeControl(const SessionOptions& options, Pendant& pendant, ProgramServer* server);
    ~NativeControl() override;

    /// Throws std::runtime_error if the connection fails, std::logic_error if the state of the robot does not
    /// permit a program.
    void connect();
    /// Takes over the program of a client that has exited.
    /// Returns  false if no such program is running. Throws the same exceptions as connect()
    bool join();

    void disconnect(control::Supervision supervision) override;
    bool isConnected() const override { return controller_.isConnected(); }
    SoftwareVersion version() const override { return controller_.version(); }
    control::JointLimits jointLimits() const override { return controller_.jointLimits(); }
    std::uint32_t robotStatus() const override { return controller_.status().robotStatusBits; }
    int progress() const override;
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
    using Outcome = std::optional<CommandResult>;
    /// Locks the motions. If a stop occurred first, the returned lock is not owned.
    TurnLock takeTurn();
    /// Returns true if in control. Regains control of a program that was paused and is running again.
    bool isReady();
    Outcome failed(const Error& error);
    Outcome outcome(const Result<void>& done);
    /// Starts a motion and, unless asynchronous, waits for its end.
    template <class Start>
    Outcome move(bool asynchronous, Start start);
    Outcome begin(const Result<control::Motion>& motion, bool asynchronous);
    void remember(const control::Motion& motion);
    /// Returns true if setpoints may start a new stream; otherwise prints an error.
    bool mayBegin(const control::Motion& before);
    template <class Stream, class Target, class Parameters, class Start>
    bool send(Stream& stream, const Target& target, const Parameters& parameters, Start start);
    Outcome ask(const RecipeCommand& command);
    Outcome setUp(const RecipeCommand& command);
    bool forceMode(const std::vector<double>& values);
    Outcome pose(const Result<Pose>& answer);
    Outcome solve(const RecipeCommand& command, bool onlyWhether);
    Outcome guide(const Result<control::Motion>& motion);
    Outcome whole(const Result<bool>& answer);
    [[noreturn]] void interrupted();
    bool isUsersDoing(const Error& error) const;

    const SessionOptions& options_;
    Pendant& pendant_;
    ProgramServer* server_;
    control::Controller controller_;
    control::Motions motions_{controller_};
    control::Compliance compliance_{controller_};
    control::ToolSetup tool_{controller_};
    control::ArmQueries arm_{controller_};
    control::Programs programs_{controller_};

    Turn turn_;  ///< serializes motions; protects the streams below
    std::atomic<int> stopsMade_{0};
    std::atomic<int> starts_{0};  ///< number of calls that started or ended a motion, excluding setpoints
    int streamStart_ = 0;         ///< value of starts_ at the start of the current stream
    std::atomic<bool> disconnecting_{false};
    control::JointServo jointServo_;
    control::PoseServo poseServo_;
    control::CircularServo circularServo_;
    control::JointSpeed jointSpeed_;
    control::ToolSpeed toolSpeed_;

    mutable std::mutex state_;  ///< protects the following members
    control::Motion motion_;    ///< the last motion
    control::Motion guiding_;
    std::vector<double> force_;  ///< last force mode parameters; empty: no force mode
    int operation_ = 0;
    mutable int changes_ = 0;
    mutable int reported_ = 0;  ///< last returned running state and progress
    std::string error_;
};

}  // namespace tiller::urrtde
