// SPDX-License-Identifier: MIT
//
// Measures the speed of the simulated controller without real time: the ratio of virtual to real time for a
// moving UR5e with a running program, and the time to create a controller, start it, move it for 10 ms and
// destroy it. Prints both and, with --json, one JSON object. Does not check limits.
//
//   simulator_speed [--seconds 60] [--lives 1000] [--json]

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpSocket>
#include <QTextStream>
#include <chrono>
#include <cmath>
#include <ctime>

#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

namespace {

/// Alternates joint and linear moves, and writes the progress to an output.
const char* const kProgram =
    "def tour():\n"
    "  home = get_actual_joint_positions()\n"
    "  place = get_actual_tcp_pose()\n"
    "  round = 0\n"
    "  while True:\n"
    "    movej([home[0] + 0.6, home[1] - 0.2, home[2], home[3], home[4], home[5] + 0.8], a=1.4, v=1.05)\n"
    "    movej(home, a=1.4, v=1.05)\n"
    "    movel(pose_add(place, p[0.1, 0, 0.05, 0, 0, 0]), a=1.2, v=0.25)\n"
    "    movel(place, a=1.2, v=0.25)\n"
    "    round = round + 1\n"
    "    write_output_integer_register(24, round)\n"
    "    set_digital_out(0, round % 2 == 0)\n"
    "  end\n"
    "end\n";
/// Starts to move in the first period.
const char* const kTurn =
    "def turn():\n"
    "  speedj([0.5, 0, 0, 0, 0, 0], 5, 10)\n"
    "end\n";

double secondsSince(Steady::time_point begin) {
    return std::chrono::duration<double>(Steady::now() - begin).count();
}

/// Processor time of all threads of this program [s].
double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

simulator::SimulatorOptions virtualRobot() {
    simulator::SimulatorOptions options;
    options.anyFreePorts = true;
    options.time = simulator::Time::Virtual;
    options.poweredOn = true;
    return options;
}

/// Starts the program. Returns true if it is running.
bool play(simulator::Simulator& robot, const char* program) {
    QTcpSocket upload;
    upload.connectToHost(robot.listenAddress(), robot.ports().secondary);
    if (!upload.waitForConnected(20'000) || upload.write(program) < 0) {
        return false;
    }
    upload.flush();
    constexpr int kMaxValue = 20'000;  // attempts
    for (int i = 0; i < kMaxValue && robot.truth().runtimeState != RuntimeState::Playing; ++i) {
        robot.step();
    }
    return robot.truth().runtimeState == RuntimeState::Playing;
}

struct Speed {
    double passed = 0;     ///< real time [s]
    double processor = 0;  ///< [s]
    double path = 0;       ///< path of the TCP, to verify that the arm moves [m]
    bool good = false;
};

Speed measureSpeed(double seconds) {
    Speed speed;
    simulator::Simulator robot(virtualRobot());
    if (!robot.start() || !play(robot, kProgram)) {
        return speed;
    }
    constexpr double kPiece = 0.1;  // [s]
    const double processor = processorSeconds();
    const auto begin = Steady::now();
    Eigen::Vector3d before = robot.truth().tcpPose.position;
    for (double done = 0; done < seconds; done += kPiece) {
        robot.stepSeconds(kPiece);
        const Eigen::Vector3d here = robot.truth().tcpPose.position;
        speed.path += (here - before).norm();
        before = here;
    }
    speed.passed = secondsSince(begin);
    speed.processor = processorSeconds() - processor;
    speed.good = robot.truth().runtimeState == RuntimeState::Playing;
    return speed;
}

struct Lives {
    double passed = 0;     ///< real time [s]
    double processor = 0;  ///< [s]
    int moved = 0;
};

Lives measureLives(int count) {
    Lives lives;
    const double processor = processorSeconds();
    const auto begin = Steady::now();
    for (int i = 0; i < count; ++i) {
        simulator::Simulator robot(virtualRobot());
        if (!robot.start() || !play(robot, kTurn)) {
            break;
        }
        robot.stepSeconds(0.01);
        lives.moved += std::abs(robot.truth().qd[0]) > 0.01 ? 1 : 0;
    }
    lives.passed = secondsSince(begin);
    lives.processor = processorSeconds() - processor;
    return lives;
}

}  // namespace

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"seconds", "How long the program runs, by the robot's clock.", "s", "60"},
                       {"lives", "How many controllers are created and destroyed.", "n", "1000"},
                       {"json", "One JSON object instead of lines."}});
    parser.process(application);
    const double seconds = parser.value("seconds").toDouble();
    const int count = parser.value("lives").toInt();
    const Speed speed = seconds > 0 ? measureSpeed(seconds) : Speed();
    const Lives lives = measureLives(count);
    if ((seconds > 0 && !speed.good) || lives.moved != count) {
        QTextStream(stderr) << "the program does not run, or the arm of " << count - lives.moved
                            << " controllers did not move\n";
        return 1;
    }
    QJsonObject json{{"lives", count},
                     {"lives_moved", lives.moved},
                     {"lives_s", lives.passed},
                     {"lives_processor_s", lives.processor}};
    if (seconds > 0) {
        json.insert("times_real_time", seconds / speed.passed);
        json.insert("times_real_time_of_processor_time", seconds / speed.processor);
        json.insert("path_m", speed.path);
    }
    QTextStream out(stdout);
    if (parser.isSet("json")) {
        out << QJsonDocument(json).toJson(QJsonDocument::Compact) << '\n';
        return 0;
    }
    if (seconds > 0) {
        out << "a moving UR5e with a program: " << seconds / speed.passed << " times real time, "
            << seconds / speed.processor << " by the processor time it took; the TCP went " << speed.path
            << " m in " << seconds << " s\n";
    }
    out << count << " controllers created, started, moved for 10 ms, destroyed: " << lives.passed << " s, "
        << lives.processor << " s of processor time\n";
    return 0;
}
