// SPDX-License-Identifier: MIT
#pragma once

// For the files that make up RTDEControlInterface only.

#include "robot/ur_rtde/detail/control_session.h"

struct ur_rtde::RTDEControlInterface::Private {
    explicit Private(const tiller::urrtde::SessionOptions& options, double p)
        : session(options), givenPeriod(p) {}

    tiller::urrtde::ControlSession session;
    double givenPeriod;  ///< [s]; 0: the controller's own

    tiller::control::JointLimits limits() const { return session.backend()->jointLimits(); }

    using CommandId = tiller::urrtde::CommandId;
    using List = std::vector<double>;

    /// Since 5.4; what the program does elsewhere is nothing.
    bool feelsContact() const {
        const auto& version = session.identity().versions;
        return version.major > 5 || (version.major == 5 && version.minor >= 4);
    }
    bool done(CommandId id, int recipe, const List& values = {}) {
        const auto answer = session.backend()->perform({id, recipe, values});
        return answer && (answer->result != 0 || !answersResult(id));
    }
    bool move(CommandId id, const List& values) {
        const auto answer = session.backend()->perform({id, 1, values});
        return answer && (answer->result != 0 || session.isForeign());
    }
    /// The six values the robot answers with; none when it does not, or says that there are none.
    List six(CommandId id, int recipe, const List& values = {}, bool mayFail = false) {
        const auto answer = session.backend()->perform({id, recipe, values});
        if (!answer || (mayFail && answer->result == 0)) {
            return {};
        }
        return {answer->values.begin(), answer->values.end()};
    }
    int integer(CommandId id, int recipe, const List& values = {}) {
        const auto answer = session.backend()->perform({id, recipe, values});
        return answer ? answer->result : 0;
    }

private:
    /// Programs customised by users leave the result alone where the original has none.
    static bool answersResult(CommandId id) {
        switch (id) {
            case CommandId::PoseWithinLimits:
            case CommandId::JointsWithinLimits:
            case CommandId::IsSteady:
            case CommandId::HasSolution:
            case CommandId::HasSolutionNear:
            case CommandId::ReadContactDetection:
            case CommandId::StopContactDetection:
                return true;
            default:
                return false;
        }
    }
};
