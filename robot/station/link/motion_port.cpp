// SPDX-License-Identifier: MIT
#include "robot/station/link/motion_port.h"

namespace tiller {

MotionPort motionPort(RobotSession& session) {
    return {
        .beginJog = [&session](const control::JogTarget& target) { return session.beginJog(target); },
        .beginMove = [&session](const MoveRequest& request) { return session.beginMove(request); },
        .hold = [&session](RobotSession::MotionId id) { return session.hold(id); },
        .endMotion = [&session](RobotSession::MotionId id,
                                control::StopCause cause) { session.endMotion(id, cause); },
        .limits = [&session] { return session.limits(); },
        .beginFreedrive = [&session](const control::Freedrive& f) { return session.beginFreedrive(f); },
        .holdWith = [&session](RobotSession::MotionId id,
                               const control::JogTarget& target) { return session.hold(id, target); },
        .beginPath = [&session](control::MotionPath path,
                                std::uint64_t stops) { return session.beginPath(std::move(path), stops); },
        .stops = [&session] { return session.stops(); },
        .progress = [&session](RobotSession::MotionId id) { return session.motionProgress(id); },
        .permits = [&session](std::span<const MoveRequest> moves) { return session.permits(moves); },
        .permitsPath = [&session](std::span<const JointPositions> way) { return session.permitsPath(way); },
    };
}

}  // namespace tiller
