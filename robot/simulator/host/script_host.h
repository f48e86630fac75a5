// SPDX-License-Identifier: MIT
#pragma once

// Access of scripts to the simulated robot. Combines the classes that implement the interpreter's Host.

#include "robot/simulator/host/script_arm.h"
#include "robot/simulator/host/script_messages.h"
#include "robot/simulator/host/script_modbus.h"
#include "robot/simulator/host/script_motion.h"
#include "robot/simulator/host/script_sockets.h"
#include "robot/simulator/host/script_superposition.h"
#include "robot/simulator/host/script_terminals.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Plant;

/// Threads  the simulator thread
class ScriptHost final : public urscript::Host,
                         public ScriptMotion,
                         public ScriptSuperposition,
                         public ScriptArm,
                         public ScriptTerminals,
                         public ScriptSockets,
                         public ScriptMessages,
                         public ScriptModbus {
public:
    explicit ScriptHost(Plant& plant);

    /// Must be called once per control period, before the scripts run.
    void beginPeriod();

    // ProgramHost
    double stepTime() const override;
    std::int64_t controllerTimeNs() const override;
    std::int64_t systemTimeNs() const override;
    Result<void> protectiveStop() override;
    void powerDown() override;
    Result<void> setWatchdog(std::string_view field, double minFrequency,
                             urscript::WatchdogAction action) override;
    void programEnded(urscript::ProgramKind kind) override;

private:
    Plant& plant_;
    bool wasRunning_ = false;
    bool freedriveWanted_ = false;
};

}  // namespace tiller::simulator
