// SPDX-License-Identifier: MIT
#pragma once

// Receives scripts from one client of a script port and passes them to the runner.

#include "robot/simulator/net/peer.h"
#include "robot/simulator/urscript/source_splitter.h"

namespace tiller::simulator {

class ControllerModel;

class ScriptIntake {
public:
    /// mayWrite  false: scripts are not run, because the robot is in local control
    explicit ScriptIntake(bool mayWrite) : mayWrite_(mayWrite) {}

    /// Reads the received data.
    /// plant  null for a read-only port: all data are discarded
    void read(Peer& peer, ControllerModel* plant);

private:
    bool mayWrite_;
    urscript::SourceSplitter splitter_;
};

}  // namespace tiller::simulator
