// SPDX-License-Identifier: MIT
#pragma once

// Random programs with moves, for tests.

#include <QRandomGenerator>

#include "program_samples.h"

namespace tiller::program {

/// Generates programs from a fixed seed. Most of their steps do not depend on earlier steps.
class RandomMoves {
public:
    RandomMoves(quint32 seed, const project::Project& project) : random_(seed), project_(project) {}

    project::Program program() {
        std::vector<project::ProgramStep> steps{move("moveJ")};
        for (int i = 0; i < 4; ++i) {
            add(steps, 0);
        }
        return makeProgram("random", steps);
    }
    int below(int limit) { return static_cast<int>(random_.bounded(limit)); }

private:
    project::ProgramStep move(const char* kind) {
        static const QStringList names{"home", "pick", "place", "row 1"};
        return step(kind, {{"waypoint", waypointId(project_, names[below(4)])},
                           {"blend", below(3) == 0 ? 0.01 : 0.0}});
    }
    std::vector<project::ProgramStep> list(int depth) {
        std::vector<project::ProgramStep> steps;
        for (int i = 0; i <= below(3); ++i) {
            add(steps, depth);
        }
        return steps;
    }
    QString condition() {
        static const QStringList all{"DI0", "not DI0", "n < 2", "True"};
        return all[below(4)];
    }
    void add(std::vector<project::ProgramStep>& steps, int depth) {
        switch (below(depth < 2 ? 22 : 13)) {
            case 0:
            case 1:
                steps.push_back(move("moveL"));
                break;
            case 2:
                steps.push_back(move("moveJ"));
                break;
            case 3:
                steps.push_back(step("moveRelative", {{"z", 0.01 + 0.005 * below(3)}}));
                break;
            case 4:
                steps.push_back(step("wait", {{"time", 0.05 * (1 + below(4))}}));
                break;
            case 5:
                steps.push_back(step("setOutput", {{"output", below(4)}, {"value", below(2) == 1}}));
                break;
            case 6:
                steps.push_back(step("pulseOutput", {{"output", below(4)}, {"time", 0.15}}));
                break;
            case 7:
                steps.push_back(
                    step("gripper", {{"action", below(2) == 0 ? "close" : "open"}, {"time", 0.2}}));
                break;
            case 8:
                steps.push_back(step(
                    "setRegister", {{"register", below(2)},
                                    {"value", below(2) == 0 ? "3" : "read_output_integer_register(1) + 1"}}));
                break;
            case 9:
                steps.push_back(step("setAnalogOutput", {{"output", 0}, {"level", 0.25 * below(4)}}));
                break;
            case 10:
                steps.push_back(
                    step("assign", {{"variable", "n"},
                                    {"type", "whole"},
                                    {"value", below(3) == 0 ? "n + 1" : QString::number(below(3))}}));
                break;
            case 11:
                steps.push_back(
                    step("waitInput",
                         {{"input", 1}, {"value", true}, {"timeLimit", 0.2}, {"otherwise", "continue"}}));
                break;
            case 12:
                steps.push_back(step("message", {{"text", "ready"}, {"waits", below(2) == 0}}));
                break;
            case 13:
                steps.push_back(step("loop", {{"times", 1 + below(3)}}, list(depth + 1)));
                break;
            case 14:
                steps.push_back(
                    step("if", {{"condition", below(2) == 0 ? "DI0" : "not DI0"}}, list(depth + 1)));
                steps.push_back(step("else", {}, list(depth + 1)));
                break;
            case 15:
                steps.push_back(step("folder", {{"name", "part"}}, list(depth + 1)));
                break;
            case 16:
                steps.push_back(step("speed", {{"factor", 0.5}}, list(depth + 1)));
                break;
            case 17: {
                std::vector<project::ProgramStep> tried = list(depth + 1);
                if (below(2) == 0) {
                    tried.push_back(step("fail", {{"text", "on purpose"}}));
                }
                steps.push_back(step("try", {}, tried));
                steps.push_back(step("onError", {}, list(depth + 1)));
                break;
            }
            case 18:
                steps.push_back(step("forEachWaypoint", {{"group", "row"}, {"variable", "at"}},
                                     {step("moveL", {{"pose", "at"}})}));
                break;
            case 19:
                steps.push_back(step("moveGroup", {{"group", "row"}}));
                break;
            case 20:
                steps.push_back(
                    step("force", {{"force", 0}, {"axis", "z"}}, {step("wait", {{"time", 0.2}})}));
                break;
            default:
                steps.push_back(step("payload", {{"payload", idText(project_.tooling.payloads.at(0).id)}}));
                break;
        }
    }

    QRandomGenerator random_;
    const project::Project& project_;
};

}  // namespace tiller::program
