// SPDX-License-Identifier: MIT
#pragma once

// The gripper's service, port 63352, in lines of ASCII:
//
//     SET ACT 1                       ack
//     SET POS 200 SPE 255 GTO 1       ack          (several at once; no newline behind "ack")
//     GET POS                         POS 187
//
// A variable that does not exist reads as "?". The maker's own URScript asks without a newline, and reads
// digits of a fixed number:
//
//     GET STA    3        GET FLT    00        GET PRE    007        GET SID    [9] and blanks, 17 in all
//
// Source: what ur_rtde's gripper class and the maker's URScript send and expect.

#include "robot/simulator/equipment/gripper.h"
#include "robot/simulator/servers/net/line_server.h"

namespace tiller::simulator {

class GripperServer final : public LineServer {
public:
    /// Motion requires tool power, which is lost with the power of the arm.
    void step(double dt, bool powered);
    void setObject(std::optional<int> position) { gripper_.setObject(position); }

protected:
    LineAnswer answer(std::string_view line, std::uint64_t tag) override;
    std::optional<LineAnswer> answerUnfinished(std::string_view line) override;

private:
    Gripper gripper_;
    bool powered_ = true;
};

}  // namespace tiller::simulator
