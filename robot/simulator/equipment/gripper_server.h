// SPDX-License-Identifier: MIT
#pragma once

// The gripper's service on port 63352, which exchanges lines of ASCII text:
//
//     SET ACT 1                       ack
//     SET POS 200 SPE 255 GTO 1       ack          (several at once; no newline after "ack")
//     GET POS                         POS 187
//
// The value of an unknown variable is "?". The URScript code of the manufacturer sends requests without a
// newline and reads a fixed number of digits:
//
//     GET STA    3        GET FLT    00        GET PRE    007        GET SID    [9] and spaces, 17 in total
//
// Source: requests and expected replies of the gripper class of ur_rtde and of the manufacturer's URScript
// code.

#include "robot/simulator/equipment/gripper.h"
#include "robot/simulator/net/line_server.h"

namespace tiller::simulator {

class GripperServer final : public LineServer {
public:
    /// The gripper moves only with tool power, which is off when the arm has no power.
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
