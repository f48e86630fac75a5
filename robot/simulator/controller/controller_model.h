// SPDX-License-Identifier: MIT
#pragma once

// The robot with its programs, without network services, advanced by one control period at a time. The order
// within a period is that of a controller: safety, power, watchdogs, script frame, arm.

#include "robot/simulator/host/script_host.h"
#include "robot/simulator/plant/plant.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

/// Threads  the simulator thread
class ControllerModel final : public Plant {
public:
    explicit ControllerModel(const SimulatorOptions& options);
    ~ControllerModel();

    void step();

    ProgramRunner& programs() override { return programs_; }
    const ProgramRunner& programs() const override { return programs_; }
    ScriptHost& scriptHost() { return host_; }

private:
    ScriptHost host_;
    ProgramRunner programs_;
};

}  // namespace tiller::simulator
