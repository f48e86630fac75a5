// SPDX-License-Identifier: MIT
// Takes control and moves the arm until the process is killed, or until a line on its standard input selects
// how it ends (see endProcess()). "object" destroys the controller, and the process continues to run. "leave"
// also destroys it, but releases control first, so that motions continue unattended:
//     moving_helper <host> <primary port> <rtde port> <type of motion>
#include <QCoreApplication>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "robot/control/compliance.h"
#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/control/output_pulses.h"
#include "robot/control/packet_loop.h"
#include "robot/control/programs.h"
#include "tests/support/process_end.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::control;
using namespace tiller::test;

namespace {

/// Called repeatedly. Starts the motion if it is not active, otherwise refreshes its hold. On a busy computer
/// the refresh may be late, and the motion is then started again.
using Way = std::function<void()>;

std::atomic<bool> leaves{false};
std::atomic<bool> objectEnds{false};

constexpr double kSpeed = 0.1;         ///< TCP speed, as in the jog contract [m/s]
constexpr double kAcceleration = 0.5;  ///< [m/s2]
constexpr double kTurn = 0.4;          ///< joint speed [rad/s]

// Constants for fast moves.
constexpr double kWideTurn = 4.5;          ///< rotation of the base [rad]
constexpr double kLongLine = 0.5;          ///< [m]
constexpr double kHardAcceleration = 5.0;  ///< [rad/s2], [m/s2]
constexpr double kHighCap = 3.0;           ///< speed cap of TCP and elbow [m/s]

/// Prints the error if the result contains one.
template <class T>
bool well(const Result<T>& result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", why(result).constData());
    }
    return result.ok();
}

template <class T>
T begun(const Result<T>& result, T otherwise = {}) {
    return well(result) ? *result : otherwise;
}

Way jog(Controller& controller, const JogTarget& target) {
    return [&controller, target, jog = Jog()]() mutable {
        if (!jog.refresh()) {
            jog = begun(Motions(controller).startJog(target));
        }
    };
}

Way held(Controller& controller, const std::function<Result<Motion>()>& begin) {
    return [&controller, begin, motion = Motion()]() mutable {
        if (!motion.refresh()) {
            motion = begun(begin());
        }
    };
}

Way section(Controller& controller, const char* body) {
    return held(controller, [&controller, body] {
        return Programs(controller)
            .startFunction(QStringLiteral("killed"), QString::fromLatin1(body), testTimeout(), Holding::Held);
    });
}

JogTarget up(double contactForce = 0) {
    JogTarget target;
    target.twist.linear.z() = kSpeed;
    target.contactForce = contactForce;
    return target;
}

Pose raised(const ControllerStatus& status, double by) {
    Pose pose = Pose::fromArray(status.tcpPose);
    pose.position.z() += by;
    return pose;
}

JointPositions turned(const ControllerStatus& status, double by) {
    JointPositions q(status.q);
    q[0] += by;
    return q;
}

/// Oscillates around the start of the stream with this maximum speed.
double swing(double time, double speed) {
    constexpr double kRate = 0.5;  // [rad/s]; a quarter of the oscillation takes three seconds
    return speed / kRate * std::sin(kRate * time);
}

/// Alternates between both directions, so that the base stays within its range [rad/s].
double swings(double time, double speed) {
    constexpr double kFirst = 1.3;  // [s]; later halves are twice as long
    return std::fmod(time + kFirst, 4 * kFirst) < 2 * kFirst ? speed : -speed;
}

bool pushUpwards(Controller& controller) {
    ForceMode mode;
    mode.compliant[2] = true;
    mode.wrench.force.z() = 30;
    mode.limits = {0.1, 0.1, kSpeed, 0.5, 0.5, 0.5};
    return well(Compliance(controller).setForceMode(mode, testTimeout()));
}

/// Starts the motion once, because it needs no refresh.
Way once(const std::function<void()>& begin) {
    return [begin, begun = false]() mutable {
        if (!begun) {
            begun = true;
            begin();
        }
    };
}

constexpr auto kRising =
    "def rising():\n"
    "  while True:\n"
    "    movel(pose_add(get_target_tcp_pose(), p[0,0,0.2,0,0,0]), a=0.5, v=0.1)\n"
    "    movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), a=0.5, v=0.1)\n"
    "  end\n"
    "end\n";

constexpr auto kTurning =
    "def turning():\n"
    "  while True:\n"
    "    movej([2.9, -1.2, -2.3, -1.2, 1.57, 0], a=5, v=1.05)\n"
    "    movej([-1.57, -1.2, -2.3, -1.2, 1.57, 0], a=5, v=1.05)\n"
    "  end\n"
    "end\n";

void addFreeWays(Controller& c, std::map<QString, Way>& ways) {
    const auto free = [&c, &ways](const char* name, const std::function<Result<Motion>(Motions&)>& begin) {
        ways[name] = once([&c, begin] {
            Motions motions(c);
            well(begin(motions));
        });
    };
    free("free moveJ", [&c](Motions& m) { return m.moveJ(turned(c.status(), 1.5), {kTurn, 1.4}); });
    free("free moveJToPose", [&c](Motions& m) {
        return m.moveJToPose(raised(c.status(), 0.3), {kTurn, 1.4});
    });
    free("free moveL", [&c](Motions& m) {
        return m.moveL(raised(c.status(), 0.3), {kSpeed, kAcceleration});
    });
    free("free moveLToJoints", [&c](Motions& m) {
        return m.moveLToJoints(turned(c.status(), 0.6), {kSpeed, kAcceleration});
    });
    free("free path", [&c](Motions& m) {
        const auto to = [&c](double by) {
            return PathEntry{PathEntry::Kind::MoveL, raised(c.status(), by), {}, kSpeed, kAcceleration, 0};
        };
        return m.movePath({to(0.2), to(0), to(0.2), to(0)}, testTimeout());
    });
    // Moves back and forth at full speed until the process ends.
    const auto endless = [&c, &ways](const QString& name,
                                     const std::function<Result<Motion>(Motions&, bool)>& begin) {
        ways[name] = [&c, begin, motion = Motion(), back = true]() mutable {
            if (!motion.isActive()) {
                well(c.setSpeedCap(kHighCap));
                back = !back;
                Motions motions(c);
                motion = begun(begin(motions, back));
            }
        };
    };
    for (const double speed : {1.05, 3.0}) {
        endless(QStringLiteral("free moveJ at %1").arg(speed), [&c, speed](Motions& m, bool back) {
            return m.moveJ(turned(c.status(), back ? -kWideTurn : kWideTurn), {speed, kHardAcceleration});
        });
    }
    for (const double speed : {0.25, 1.0}) {
        endless(QStringLiteral("free moveL at %1").arg(speed), [&c, speed](Motions& m, bool back) {
            Pose pose = Pose::fromArray(c.status().tcpPose);
            pose.position.x() += back ? -kLongLine : kLongLine;
            return m.moveL(pose, {speed, kHardAcceleration});
        });
    }
    ways["free jog"] = once([&c] { well(Motions(c).startJog(up(), Holding::Free)); });
    ways["free speedL"] = once([&c] {
        static ToolSpeed stream;
        stream = begun(Motions(c).startSpeedL({}, Holding::Free));
        well(stream.send(up().twist));
    });
    ways["free freedrive"] = once([&c] {
        static Motion freedrive;
        freedrive = begun(Compliance(c).startFreedrive({}, Holding::Free));
    });
    const auto script = [&c](const char* text, Supervision supervision) {
        return once([&c, text, supervision] {
            std::thread([&c, text, supervision] {
                (void)Programs(c).runScript(QString::fromLatin1(text), Deadline::never(), supervision);
            }).detach();
        });
    };
    ways["script"] = script(kRising, Supervision::Heartbeat);
    ways["fast script"] = script(kTurning, Supervision::Heartbeat);
    ways["unattended script"] = script(kRising, Supervision::Unattended);
}

std::map<QString, Way> everyWay(Controller& c) {
    std::map<QString, Way> ways;
    ways["jog"] = jog(c, up());
    ways["jog a joint"] = jog(c, [] {
        JogTarget target;
        target.kind = JogTarget::Kind::Joint;
        target.qd[0] = kTurn;
        return target;
    }());
    ways["jog until contact"] = jog(c, up(30));
    ways["move until contact"] = [&c, motion = Motion()]() mutable {
        if (!motion.isActive()) {
            motion = begun(Motions(c).moveUntilContact(
                up().twist, testTimeout(), {.acceleration = kAcceleration, .holding = Holding::Free}));
        }
    };

    // This entry starts two output pulses instead of a motion. One of the outputs stays on only while this
    // process refreshes it.
    ways["pulse"] = [&c, begun = false]() mutable {
        if (!begun) {
            OutputPulses pulses(c);
            begun = well(pulses.begin(1U << 2, 1U << 2, std::chrono::minutes(10), Holding::Held,
                                      testTimeout())) &&
                    well(pulses.begin(1U << 1, 1U << 1, std::chrono::milliseconds(1500), Holding::Free,
                                      testTimeout()));
        }
    };

    ways["moveJ"] = held(c, [&c, by = 0.8]() mutable {
        by = -by;
        return Motions(c).moveJ(turned(c.status(), by), {kTurn, 1.4, Holding::Held});
    });
    ways["moveL"] = held(c, [&c, by = -0.2]() mutable {
        by = -by;
        return Motions(c).moveL(raised(c.status(), by), {kSpeed, kAcceleration, Holding::Held});
    });
    ways["path"] = held(c, [&c] {
        const auto to = [&c](double by) {
            return PathEntry{PathEntry::Kind::MoveL, raised(c.status(), by), {}, kSpeed, kAcceleration, 0};
        };
        return Motions(c).movePath({to(0.2), to(0), to(0.2), to(0)}, testTimeout(), Holding::Held);
    });

    ways["servoJ"] = [&c] {
        const JointPositions from = turned(c.status(), 0);
        well(PacketLoop(c).servoJ(
            [&from](const CycleState& now) -> std::optional<JointPositions> {
                if (objectEnds) {
                    return std::nullopt;
                }
                JointPositions q = from;
                q[0] += swing(now.time, kTurn);
                return q;
            },
            {}, Deadline::never()));
    };
    ways["servoL"] = [&c] {
        const Pose from = raised(c.status(), 0);
        well(PacketLoop(c).servoL(
            [&from](const CycleState& now) -> std::optional<Pose> {
                if (objectEnds) {
                    return std::nullopt;
                }
                Pose pose = from;
                pose.position.z() += swing(now.time, kSpeed);
                return pose;
            },
            {}, Deadline::never()));
    };
    ways["servoC"] = [&c, servo = CircularServo(), target = Pose()]() mutable {
        if (!servo.isActive()) {
            target = raised(c.status(), 0.2);
            servo = begun(Motions(c).startServoC({kSpeed, kAcceleration, 0}));
        }
        (void)servo.send(target);
    };
    ways["speedJ"] = [&c] {
        well(PacketLoop(c).speedJ(
            [](const CycleState&) -> std::optional<JointVelocities> {
                if (objectEnds) {
                    return std::nullopt;
                }
                return JointVelocities(kTurn, 0, 0, 0, 0, 0);
            },
            {}, Deadline::never()));
    };
    ways["speedL"] = [&c] {
        well(PacketLoop(c).speedL(
            [](const CycleState&) { return objectEnds ? std::nullopt : std::optional(up().twist); }, {},
            Deadline::never()));
    };
    ways["fast speedJ"] = [&c] {
        well(c.setSpeedCap(kHighCap));
        well(PacketLoop(c).speedJ(
            [](const CycleState& now) -> std::optional<JointVelocities> {
                if (objectEnds) {
                    return std::nullopt;
                }
                return JointVelocities(swings(now.time, 3.0), 0, 0, 0, 0, 0);
            },
            {.acceleration = kHardAcceleration}, Deadline::never()));
    };
    ways["fast servoJ"] = [&c] {
        well(c.setSpeedCap(kHighCap));
        const JointPositions from = turned(c.status(), 0);
        well(PacketLoop(c).servoJ(
            [&from](const CycleState& now) -> std::optional<JointPositions> {
                if (objectEnds) {
                    return std::nullopt;
                }
                JointPositions q = from;
                q[0] += swing(now.time, 1.5);
                return q;
            },
            {}, Deadline::never()));
    };

    ways["torque"] = [&c] {
        well(PacketLoop(c).torque(
            [](const CycleState& now) -> std::optional<JointTorques> {
                if (objectEnds) {
                    return std::nullopt;
                }
                constexpr double kGain = 60;             // [Nm s/rad]
                constexpr double kAimed = 1.15 * kTurn;  // higher than kTurn to compensate friction
                return JointTorques(kGain * (kAimed - now.qd[0]), 0, 0, 0, 0, 0);
            },
            {}, Deadline::never()));
    };

    ways["freedrive"] = held(c, [&c] { return Compliance(c).startFreedrive({}, Holding::Held); });
    ways["teach mode"] = held(c, [&c] { return Compliance(c).startTeachMode(Holding::Held); });
    ways["force mode"] = [&c, on = false]() mutable { on = on || pushUpwards(c); };
    ways["jog in force mode"] = [&c, on = false, moves = jog(c, up())]() mutable {
        on = on || pushUpwards(c);
        moves();
    };

    ways["section"] = section(c,
                              "while True:\n"
                              "  movel(pose_add(get_target_tcp_pose(), p[0,0,0.2,0,0,0]), a=0.5, v=0.1)\n"
                              "  movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), a=0.5, v=0.1)\n"
                              "end");
    ways["section with a thread"] = section(c,
                                            "thread rise():\n"
                                            "  while True:\n"
                                            "    speedl([0,0,0.1,0,0,0], 0.5, 0.002)\n"
                                            "  end\n"
                                            "end\n"
                                            "run rise()\n"
                                            "sleep(1000)");
    // A conveyor that runs at 0.1 m/s, which is 1000 ticks per second.
    ways["section on a conveyor"] = section(c,
                                            "encoder_enable_pulse_decode(0, 1, 0, 1)\n"
                                            "track_conveyor_linear(p[0,0,1,0,0,0], 10000, 0)\n"
                                            "sleep(1000)");
    ways["section in force mode"] = section(c,
                                            "force_mode(p[0,0,0,0,0,0], [0,0,1,0,0,0], [0,0,30,0,0,0], 2, "
                                            "[0.1,0.1,0.1,0.5,0.5,0.5])\n"
                                            "sleep(1000)");
    ways["section in freedrive"] = section(c, "freedrive_mode()\nsleep(1000)");
    addFreeWays(c, ways);
    return ways;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    ControllerOptions options;
    options.host = app.arguments().at(1);
    options.primaryPort = app.arguments().at(2).toInt();
    options.rtdePort = app.arguments().at(3).toInt();
    options.priority = 0;
    auto controller = std::make_unique<Controller>(options);
    if (!well(controller->takeControl(testTimeout()))) {
        return 1;
    }
    std::thread([] {
        for (std::string line; std::getline(std::cin, line);) {
            leaves = line == "leave";
            objectEnds = leaves || line == "object";
            endProcess(line);
        }
    }).detach();
    const Way move = everyWay(*controller).at(app.arguments().at(4));
    while (!objectEnds) {
        move();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    if (leaves) {
        controller->leave(Supervision::Unattended);
    }
    controller.reset();
    std::cout << "object done" << std::endl;
    while (true) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
}
