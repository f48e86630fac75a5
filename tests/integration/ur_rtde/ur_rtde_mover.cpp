// SPDX-License-Identifier: MIT
// A program for ur_rtde that performs one type of motion until it is ended:
//     ur_rtde_mover <host> <type of motion>
// Like many programs, it ignores the return values of its calls. It prints "ready", then executes the lines
// of its standard input and replies to each with "<line> done". The lines are "begin", "again" (from the
// first start position), "release" (the function that ends this type of motion), "disconnect", "leave"
// (disconnect while the motion continues unattended), or a way to end the process (see endProcess()).
#include <ur_rtde/rtde_control_interface.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>

#include "tests/support/process_end.h"

using ur_rtde::Path;
using Control = ur_rtde::RTDEControlInterface;
using List = std::vector<double>;

namespace {

const List kBegin{-1.57, -1.2, -2.3, -1.2, 1.57, 0};
const List kDown{0, 0, -0.1, 0, 0, 0};
constexpr double kTurn = 0.4;  // [rad/s]

struct Way {
    std::function<void(Control&)> begin;          ///< called once
    std::function<void(Control&, double)> cycle;  ///< called every 4 ms with the time since the start [s]
    std::function<void(Control&)> release;
};

List turned(double angle) {
    List q = kBegin;
    q[0] += angle;
    return q;
}

List lowered(Control& control, double way) {
    static const List pose = control.getForwardKinematics(kBegin, List(6, 0.0));
    List out = pose;
    out[2] -= way;
    return out;
}

void nothing(Control& /*control*/) {}
void idle(Control& /*control*/, double /*time*/) {}
void stopJ(Control& control) {
    control.stopJ(4.0);
}
void stopL(Control& control) {
    control.stopL(3.0);
}

constexpr auto kRisingBody =
    "while True:\n"
    "  movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), a=0.5, v=0.1)\n"
    "  movel(pose_add(get_target_tcp_pose(), p[0,0,0.2,0,0,0]), a=0.5, v=0.1)\n"
    "end\n";

std::string risingProgram() {
    return "def rising():\n" + std::string(kRisingBody) + "end\n";
}

std::string risingFile() {
    char name[] = "/tmp/ur_rtde_mover_XXXXXX";
    const int descriptor = ::mkstemp(name);
    std::ofstream(name) << risingProgram();
    ::close(descriptor);
    return name;
}

/// Runs a call that blocks until its script has ended, in a separate thread.
template <class Call>
std::function<void(Control&)> waiting(Call call) {
    return [call](Control& c) { std::thread([&c, call] { call(c); }).detach(); };
}

void addScripts(std::map<std::string, Way>& table) {
    const auto add = [&table](const char* name, std::function<void(Control&)> begin) {
        table[name] = {std::move(begin), idle, stopJ};
    };
    for (const bool unattended : {false, true}) {
        const auto named = [&](const char* name) {
            return std::string(unattended ? "unattended " : "") + name;
        };
        add(named("script").c_str(),
            waiting([unattended](Control& c) { c.sendCustomScript(risingProgram(), unattended); }));
        add(named("function").c_str(), waiting([unattended](Control& c) {
                c.sendCustomScriptFunction("rising", kRisingBody, unattended);
            }));
        add(named("file").c_str(),
            waiting([unattended](Control& c) { c.sendCustomScriptFile(risingFile(), unattended); }));
    }
    add("custom program", [](Control& c) { c.setCustomScriptFile(risingFile()); });
}

/// Moves back and forth with calls that return at each end.
Way endless(const std::function<void(Control&, bool)>& move) {
    return {[move](Control& c) {
                std::thread([&c, move] {
                    for (bool back = false; c.isConnected(); back = !back) {
                        move(c, back);
                    }
                }).detach();
            },
            idle, stopJ};
}

List shifted(Control& control, double way) {
    List out = lowered(control, 0);
    out[0] += way;
    return out;
}

void addFastMoves(std::map<std::string, Way>& table) {
    constexpr double kHard = 5;        // [rad/s2], [m/s2]
    constexpr double kWideTurn = 4.5;  // [rad]
    constexpr double kLongLine = 0.5;  // [m]
    table["moveJ, default speed"] =
        endless([](Control& c, bool back) { c.moveJ(turned(back ? 0 : kWideTurn)); });
    table["moveJ, fast"] =
        endless([](Control& c, bool back) { c.moveJ(turned(back ? 0 : kWideTurn), 3.0, kHard); });
    table["moveL, default speed"] =
        endless([](Control& c, bool back) { c.moveL(shifted(c, back ? 0 : kLongLine)); });
    table["moveL, fast"] =
        endless([](Control& c, bool back) { c.moveL(shifted(c, back ? 0 : kLongLine), 1.0, kHard); });
}

const std::map<std::string, Way>& ways() {
    const auto speedStop = [](Control& c) { c.speedStop(3.0); };
    const auto servoStop = [](Control& c) { c.servoStop(3.0); };
    static std::map<std::string, Way> table = {
        {"moveJ", {[](Control& c) { c.moveJ(turned(1.5), kTurn, 1.4, true); }, idle, stopJ}},
        {"moveJ_IK", {[](Control& c) { c.moveJ_IK(lowered(c, 0.3), kTurn, 1.4, true); }, idle, stopJ}},
        {"moveL", {[](Control& c) { c.moveL(lowered(c, 0.3), 0.1, 0.5, true); }, idle, stopL}},
        {"moveL_FK", {[](Control& c) { c.moveL_FK(turned(0.5), 0.1, 0.5, true); }, idle, stopL}},
        {"path",
         {[](Control& c) {
              Path path;
              List first = turned(1.0);
              first.insert(first.end(), {kTurn, 1.4, 0.0});
              List second = turned(-1.0);
              second.insert(second.end(), {kTurn, 1.4, 0.0});
              path.appendMovejPath({first, second});
              c.movePath(path, true);
          },
          idle, stopJ}},
        {"speedJ",
         {nothing,
          [](Control& c, double) {
              c.speedJ({kTurn, 0, 0, 0, 0, 0}, 1.4);
          },
          speedStop}},
        {"speedJ once",
         {[](Control& c) {
              c.speedJ({kTurn, 0, 0, 0, 0, 0}, 1.4);
          },
          idle, speedStop}},
        {"speedL", {nothing, [](Control& c, double) { c.speedL(kDown, 0.5); }, speedStop}},
        {"servoJ",
         {nothing, [](Control& c, double t) { c.servoJ(turned(0.3 * t), 0, 0, 0.004, 0.1, 300); },
          servoStop}},
        {"servoL",
         {nothing, [](Control& c, double t) { c.servoL(lowered(c, 0.08 * t), 0, 0, 0.004, 0.1, 300); },
          servoStop}},
        {"servoC", {nothing, [](Control& c, double) { c.servoC(lowered(c, 0.3), 0.1, 0.5); }, servoStop}},
        {"jog",
         {[](Control& c) { c.jogStart(kDown, Control::FEATURE_BASE, 0.5); }, idle,
          [](Control& c) { c.jogStop(); }}},
        {"jog in the tool's frame",
         {[](Control& c) {
              c.jogStart({0, 0, 0.1, 0, 0, 0}, Control::FEATURE_TOOL, 0.5);
          },
          idle, [](Control& c) { c.jogStop(); }}},
        {"move until contact",
         {[](Control& c) { std::thread([&c] { c.moveUntilContact(kDown); }).detach(); }, idle, stopL}},
        {"force mode",
         {[](Control& c) {
              c.forceMode(List(6, 0.0), {0, 0, 1, 0, 0, 0}, {0, 0, -10, 0, 0, 0}, 2, {2, 2, 0.1, 1, 1, 1});
          },
          idle, [](Control& c) { c.forceModeStop(); }}},
        {"freedrive",
         {[](Control& c) { c.freedriveMode(); }, idle, [](Control& c) { c.endFreedriveMode(); }}},
        {"teach mode", {[](Control& c) { c.teachMode(); }, idle, [](Control& c) { c.endTeachMode(); }}},
    };
    addScripts(table);
    addFastMoves(table);
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3 || ways().count(argv[2]) == 0) {
        std::cerr << "ur_rtde_mover <host> <way of moving>" << std::endl;
        return 2;
    }
    const Way& way = ways().at(argv[2]);
    Control control(argv[1]);
    (void)lowered(control, 0);
    std::atomic<bool> over{false};
    std::thread cycles;
    const auto begin = [&] {
        over = false;
        way.begin(control);
        cycles = std::thread([&] {
            const auto first = std::chrono::steady_clock::now();
            for (auto now = first; !over; now += std::chrono::milliseconds(4)) {
                way.cycle(control, std::chrono::duration<double>(now - first).count());
                std::this_thread::sleep_until(now + std::chrono::milliseconds(4));
            }
        });
    };
    const auto end = [&] {
        over = true;
        if (cycles.joinable()) {
            cycles.join();
        }
    };
    std::cout << "ready" << std::endl;
    for (std::string line; std::getline(std::cin, line);) {
        if (line == "begin") {
            begin();
        } else if (line == "release") {
            end();
            way.release(control);
        } else if (line == "again") {
            end();
            way.release(control);
            if (!control.isProgramRunning()) {
                control.reuploadScript();
            }
            control.moveJ(kBegin);
            begin();
        } else if (line == "disconnect") {
            control.disconnect();
        } else if (line == "leave") {
            control.disconnect(true);
        } else {
            tiller::test::endProcess(line);
        }
        std::cout << line << " done" << std::endl;
    }
    end();
    return 0;
}
