// SPDX-License-Identifier: MIT
#pragma once

// The receiving side of a script port for one client: bytes in, programs to the runner.

#include "robot/simulator/servers/net/peer.h"
#include "robot/simulator/urscript/source_splitter.h"

namespace tiller::simulator {

class Plant;

class ScriptIntake {
public:
    /// mayWrite  false: what the client writes is not run, because the robot is in local control
    explicit ScriptIntake(bool mayWrite) : mayWrite_(mayWrite) {}

    /// Reads what has come. plant  null: a read-only port, everything is thrown away
    void read(Peer& peer, Plant* plant);

private:
    bool mayWrite_;
    urscript::SourceSplitter splitter_;
};

}  // namespace tiller::simulator
