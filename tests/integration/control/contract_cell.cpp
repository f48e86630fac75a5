// SPDX-License-Identifier: MIT
#include "tests/integration/control/contract_cell.h"

#include <algorithm>
#include <cmath>

namespace tiller::test {

using namespace tiller::control;
using std::chrono::milliseconds;

namespace {

constexpr double kSpeed = 0.1;         ///< TCP speed [m/s], as in the jog contract
constexpr double kAcceleration = 0.5;  ///< [m/s2]
constexpr double kTurn = 0.3;          ///< joint speed that results in about the same TCP speed [rad/s]

Deadline testTimeout() {
    return Deadline::after(std::chrono::seconds(30));
}

JogTarget up(double contactForce = 0) {
    JogTarget target;
    target.twist.linear.z() = kSpeed;
    target.contactForce = contactForce;
    return target;
}

JogTarget turning(double speed = kTurn) {
    JogTarget target;
    target.kind = JogTarget::Kind::Joint;
    target.qd[0] = speed;
    return target;
}

Pose raised(const ContractCell& cell, double by) {
    Pose pose = Pose::fromArray(cell.controller->status().tcpPose);
    pose.position.z() += by;
    return pose;
}

JointPositions turned(const ContractCell& cell, double by) {
    JointPositions q(cell.controller->status().q);
    q[0] += by;
    return q;
}

/// Returns the torque that accelerates the base to about kTurn and keeps this speed [Nm].
double turningTorque(const ContractCell& cell) {
    constexpr double kGain = 40;            // [Nm s/rad]
    constexpr double kAimed = 1.2 * kTurn;  // compensates friction
    return kGain * (kAimed - cell.robot.truth().qd[0]);
}

Error beginJog(ContractCell& cell, const JogTarget& target) {
    const auto jog = Motions(*cell.controller).startJog(target);
    cell.jog = jog ? *jog : Jog();
    return jog ? Error() : jog.error();
}

Error take(ContractCell& cell, const Result<Motion>& motion) {
    cell.motion = motion ? *motion : Motion();
    return motion ? Error() : motion.error();
}

/// Refreshes a stream continuously through a copy of its handle.
template <class Stream, class Next>
Error stream(ContractCell& cell, const Result<Stream>& started, Next next) {
    if (!started) {
        return started.error();
    }
    cell.motion = started->motion();
    cell.send = [stream = *started, next]() mutable { (void)stream.send(next()); };
    return {};
}

void holdJog(ContractCell& cell) {
    (void)cell.jog.refresh();
}
void holdMove(ContractCell& cell) {
    (void)cell.motion.refresh();
}
void feed(ContractCell& cell) {
    if (cell.send) {
        cell.send();
    }
}
void nothing(ContractCell&) {}

Error section(ContractCell& cell, const char* body) {
    return take(cell, cell.during([&] {
        return Programs(*cell.controller)
            .startFunction(QStringLiteral("contract"), QString::fromLatin1(body), testTimeout(),
                           Holding::Held);
    }));
}

Error push(ContractCell& cell) {
    const auto on = cell.during([&] {
        ForceMode mode;
        mode.compliant[2] = true;
        mode.wrench.force.z() = 30;
        mode.limits = {0.1, 0.1, kSpeed, 0.5, 0.5, 0.5};
        return Compliance(*cell.controller).setForceMode(mode, testTimeout());
    });
    return on ? Error() : on.error();
}

}  // namespace

const std::vector<ContractMotion>& contractMotions() {
    // The position of the arm is known. Each motion stays away from all limits.
    static const std::vector<ContractMotion> kMotions{
        {"jog", nullptr, false, false, kSpeed, [](ContractCell& c) { return beginJog(c, up()); }, holdJog},
        {"jog a joint", nullptr, false, false, 0.08, [](ContractCell& c) { return beginJog(c, turning()); },
         holdJog},
        {"jog until contact", nullptr, false, false, kSpeed,
         [](ContractCell& c) { return beginJog(c, up(30)); }, holdJog},
        {"moveJ", nullptr, false, false, 0.08,
         [](ContractCell& c) {
             return take(c, Motions(*c.controller).moveJ(turned(c, 0.8), {kTurn, 1.4, Holding::Free}));
         },
         nothing},
        {"moveJ to a pose", nullptr, false, false, 0.03,
         [](ContractCell& c) {
             return take(c, Motions(*c.controller).moveJToPose(raised(c, 0.25), {kTurn, 1.4, Holding::Free}));
         },
         nothing},
        {"moveL", nullptr, false, false, kSpeed,
         [](ContractCell& c) {
             return take(
                 c, Motions(*c.controller).moveL(raised(c, 0.25), {kSpeed, kAcceleration, Holding::Free}));
         },
         nothing},
        {"moveL to joints", nullptr, false, false, kSpeed,
         [](ContractCell& c) {
             return take(c, Motions(*c.controller)
                                .moveLToJoints(turned(c, 0.6), {kSpeed, kAcceleration, Holding::Free}));
         },
         nothing},
        {"held moveL", nullptr, false, false, kSpeed,
         [](ContractCell& c) {
             return take(
                 c, Motions(*c.controller).moveL(raised(c, 0.25), {kSpeed, kAcceleration, Holding::Held}));
         },
         holdMove},
        {"path", nullptr, false, true, kSpeed,
         [](ContractCell& c) {
             const PathEntry there{PathEntry::Kind::MoveL, raised(c, 0.25), {}, kSpeed, kAcceleration, 0};
             const PathEntry back{PathEntry::Kind::MoveL, raised(c, 0), {}, kSpeed, kAcceleration, 0};
             return take(c, c.during([&] {
                 return Motions(*c.controller).movePath({there, back, there}, testTimeout(), Holding::Free);
             }));
         },
         nothing},
        {"move until contact", "tool_contact", false, false, kSpeed,
         [](ContractCell& c) {
             return take(c, c.during([&] {
                 return Motions(*c.controller)
                     .moveUntilContact(up().twist, testTimeout(),
                                       {.acceleration = kAcceleration, .holding = Holding::Free});
             }));
         },
         nothing},
        {"servoJ", nullptr, false, false, 0.07,
         [](ContractCell& c) {
             return stream(
                 c, Motions(*c.controller).startServoJ(),
                 [q = turned(c, 0), by = kTurn * c.robot.stepTime()]() mutable { return q[0] += by, q; });
         },
         feed},
        {"servoL", nullptr, false, false, 0.08,
         [](ContractCell& c) {
             return stream(c, Motions(*c.controller).startServoL(),
                           [pose = raised(c, 0), by = kSpeed * c.robot.stepTime()]() mutable {
                               return pose.position.z() += by, pose;
                           });
         },
         feed},
        {"servoC", "servoc", false, false, 0.08,
         [](ContractCell& c) {
             return stream(c, Motions(*c.controller).startServoC({kSpeed, kAcceleration, 0}),
                           [pose = raised(c, 0.25)] { return pose; });
         },
         feed},
        {"speedJ", nullptr, false, false, 0.08,
         [](ContractCell& c) {
             return stream(c, Motions(*c.controller).startSpeedJ(),
                           [] { return JointVelocities(kTurn, 0, 0, 0, 0, 0); });
         },
         feed},
        {"speedL", nullptr, false, false, kSpeed,
         [](ContractCell& c) {
             return stream(c, Motions(*c.controller).startSpeedL(), [] { return up().twist; });
         },
         feed},
        {"torque", "direct_torque", false, false, 0.07,
         [](ContractCell& c) {
             return stream(c, Motions(*c.controller).startTorque(),
                           [&c] { return JointTorques(turningTorque(c), 0, 0, 0, 0, 0); });
         },
         feed, false, SoftwareVersion{5, 25, 1, 0}},
        {"freedrive", nullptr, true, false, 0.03,
         [](ContractCell& c) { return take(c, Compliance(*c.controller).startFreedrive({}, Holding::Held)); },
         holdMove, true},
        {"teach", "teach_mode", true, false, 0.03,
         [](ContractCell& c) { return take(c, Compliance(*c.controller).startTeachMode(Holding::Held)); },
         holdMove, true},
        {"force mode", nullptr, false, false, 0.03, push, nothing, true},
        {"jog in force mode", nullptr, false, false, 0.03,
         [](ContractCell& c) {
             const Error error = push(c);
             return error.code == ErrorCode::None ? beginJog(c, turning(kTurn / 3)) : error;
         },
         holdJog, true},
        {"function", nullptr, false, true, kSpeed,
         [](ContractCell& c) {
             return section(c,
                            "while True:\n"
                            "  movel(pose_add(get_target_tcp_pose(), p[0,0,0.2,0,0,0]), a=0.5, v=0.1)\n"
                            "  movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), a=0.5, v=0.1)\n"
                            "end");
         },
         holdMove},
        {"function in force mode", nullptr, false, true, 0.03,
         [](ContractCell& c) {
             return section(c,
                            "force_mode(p[0,0,0,0,0,0], [0,0,1,0,0,0], [0,0,30,0,0,0], 2, "
                            "[0.1,0.1,0.1,0.5,0.5,0.5])\n"
                            "sleep(1000)");
         },
         holdMove, true},
    };
    return kMotions;
}

namespace {

constexpr double kReleaseMs = 100;
constexpr double kLostMs = 250;
constexpr double kLongPause = 0.4;  // [s]

void play(ContractCell& cell) {
    cell.say("run program");
}

/// A pause during which the process ends.
ContractEvent lostInPause(const char* name, double seconds) {
    return {name,
            kLostMs,
            [](ContractCell& c) {
                c.say("pause program");
                c.holding = c.reachable = false;
                c.clock.freeze(true);
            },
            {play},
            false,
            true,
            seconds};
}

}  // namespace

const std::vector<ContractEvent>& contractEvents() {
    static const std::vector<ContractEvent> kEvents{
        {"release",
         kReleaseMs,
         [](ContractCell& c) {
             c.holding = false;
             // Send the stop immediately. A stop does not wait for data, so bunched data must not delay it in
             // this test either.
             const std::uint64_t packages = c.robot.inputPackages();
             c.clock.pretendToRun(true);
             c.controller->stop(StopCause::Released);
             const bool sent = c.robot.waitForInputPackages(packages + 1, testTimeout());
             c.clock.pretendToRun(false);
             if (!sent) {
                 c.fault = QStringLiteral("no stop was sent");
             }
         },
         {[](ContractCell& c) { c.holding = true; }}},
        {"kill -9",
         kLostMs,
         [](ContractCell& c) {
             c.holding = c.reachable = false;
             c.robot.closeClients();
         },
         {}},
        {"SIGSTOP",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.clock.freeze(true);
         },
         {}},
        {"cut cable",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.inject("link lost");
         },
         {[](ContractCell& c) {
             c.inject("link back");
             c.reachable = true;
         }}},
        {"silent link",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.inject("silence on");
         },
         {[](ContractCell& c) {
             c.inject("silence off");
             c.reachable = true;
         }}},
        {"half-open connections",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.inject("half-open");
         },
         {}},
        {"power cut",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.inject("silence on");
         },
         {[](ContractCell& c) {
             c.inject("half-open");  // the client has reconnected, and the previous connection is half-open
             c.inject("silence off");
         }}},
        {"debugger pause",
         kLostMs,
         [](ContractCell& c) {
             c.reachable = false;
             c.clock.freeze(true);
         },
         {[](ContractCell& c) {
             c.clock.freeze(false);
             c.reachable = true;
         }}},
        {"protective stop",
         kLostMs,
         [](ContractCell& c) { c.robot.protectiveStop(); },
         {[](ContractCell& c) { c.say("set unlock protective stop"); }, play},
         true},
        {"pause and play", kLostMs, [](ContractCell& c) { c.say("pause program"); }, {play}, true},
        {"safeguard",
         kLostMs,
         [](ContractCell& c) { c.inject("safeguard on"); },
         {[](ContractCell& c) { c.inject("safeguard off"); }, play},
         true},
        {"emergency stop",
         kLostMs,
         [](ContractCell& c) { c.inject("emergency-stop on"); },
         {[](ContractCell& c) { c.inject("emergency-stop off"); }, [](ContractCell& c) { c.say("power on"); },
          [](ContractCell& c) { c.say("set robotmode run"); }, play},
         true},
        lostInPause("pause, kill -9, play", kLongPause),
    };
    return kEvents;
}

const ContractEvent& lostInLocal() {
    static const ContractEvent kEvent{"to local, kill -9, to remote",
                                      kLostMs,
                                      [](ContractCell& c) {
                                          c.robot.setRemoteControl(false);
                                          c.holding = c.reachable = false;
                                          c.clock.freeze(true);
                                      },
                                      {[](ContractCell& c) { c.robot.setRemoteControl(true); }, play}};
    return kEvent;
}

const std::vector<ContractEvent>& shortPauses() {
    static const std::vector<ContractEvent> kEvents{
        lostInPause("0.12 s of pause, kill -9", 0.12), lostInPause("0.2 s of pause, kill -9", 0.2),
        lostInPause("0.45 s of pause, kill -9", 0.45), lostInPause("0.6 s of pause, kill -9", 0.6)};
    return kEvents;
}

ContractCell::ContractCell(const simulator::BehaviourOptions& assumptions, double slider,
                           const SoftwareVersion& software)
    : robot([&] {
        simulator::SimulatorOptions options;
        options.software = software;
        if (software.isCb3()) {
            options.model = RobotModelId::UR5;
        }
        options.anyFreePorts = true;
        options.time = simulator::Time::Virtual;
        options.poweredOn = true;
        options.fastTransitions = true;
        options.startJoints = JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        options.assumptions = assumptions;
        return options;
    }())
    , slider_(slider) {
    if (const auto started = robot.start(); !started) {
        qFatal("%s", qPrintable(started.error().toString()));
    }
    primary_ = std::make_unique<script::ScriptClient>(robot.listenAddress(), robot.ports().primary);
    ControllerOptions options;
    options.host = robot.listenAddress();
    options.primaryPort = robot.ports().primary;
    options.rtdePort = robot.ports().rtde;
    options.clock = &clock;
    options.priority = 0;
    controller = std::make_unique<Controller>(options);
}

ContractCell::~ContractCell() {
    clock.freeze(false);
    robot.stop();  // stop the robot first, so that no thread waits for it
    controller.reset();
}

void ContractCell::step() {
    step(20'000);
}

void ContractCell::step(int testTimeoutMs) {
    clock.advanceNs(static_cast<std::int64_t>(robot.stepTime() * 1e9 + 0.5));
    if (held_ != nullptr && holding && !clock.isFrozen()) {
        held_->hold(*this);
    }
    if (reachable && robot.truth().runtimeState == RuntimeState::Paused) {
        // The controller stops a paused program over another connection, which takes real time.
        std::this_thread::sleep_for(milliseconds(1));
    }
    if (reachable) {
        // Each package must be answered before time advances.
        robot.stepAnswered(Deadline::after(milliseconds(testTimeoutMs)));
    } else {
        robot.step();
    }
}

bool ContractCell::takeControl(QString& why) {
    constexpr int kShort = 2;  // there are no replies until the control thread is running
    const auto taken =
        during([this] { return controller->takeControl(Deadline::after(std::chrono::seconds(30))); }, kShort);
    why = taken ? QString() : taken.error().toString();
    return taken.ok();
}

ContractOutcome ContractCell::run(const ContractMotion& what, const ContractEvent& event) {
    ContractOutcome outcome;
    robot.setSpeedSlider(slider_);
    if (!takeControl(outcome.problem)) {
        return outcome;
    }
    if (const auto connected = primary_->connect(Deadline::after(std::chrono::seconds(20))); !connected) {
        outcome.problem = connected.error().toString();
        return outcome;
    }
    stepMs(20);
    const Error refused = what.begin(*this);
    if (refused.code == ErrorCode::VersionUnsupported && what.needs != nullptr) {
        outcome.applies = false;
        return outcome;
    }
    if (refused.code != ErrorCode::None) {
        outcome.problem = "not begun: " + refused.toString();
        return outcome;
    }
    held_ = &what;
    const double fast = 0.9 * what.fast * slider_;
    const int atMost = static_cast<int>(3000 / slider_);
    double waited = 0;
    while (robot.truth().tcpSpeed.linear.norm() < fast && waited < atMost) {
        step();
        // Apply the force after 60 ms, because a force at the start of freedrive causes a protective stop.
        if (what.byOperator && waited <= 60 && waited + stepTimeMs() > 60) {
            robot.pressHand({{0, 0, 12}, {0, 0, 0}});
        }
        waited += stepTimeMs();
    }
    if (waited >= atMost) {
        outcome.problem = QStringLiteral("it moves at %1 m/s only, ended by %2")
                              .arg(robot.truth().tcpSpeed.linear.norm())
                              .arg(static_cast<int>(controller->status().lastCause));
        return outcome;
    }
    stepMs(20);

    const simulator::SimulatedState before = robot.truth();
    event.happen(*this);
    simulator::SimulatedState last = before;
    while (robot.truth().timestamp < before.timestamp + event.watched) {
        step();
        if (!isStanding()) {
            last = robot.truth();
        }
    }
    const simulator::SimulatedState rest = robot.truth();
    outcome.standstillMs = (last.timestamp - before.timestamp) * 1000;
    outcome.driftMm = (rest.tcpPose.position - before.tcpPose.position).norm() * 1000;
    outcome.problem = fault;
    const bool scaled = robot.options().assumptions.programStops == simulator::BehaviourOptions::Time::Scaled;
    if (outcome.problem.isEmpty() && outcome.standstillMs > event.limitMs && !(event.robotBrakes && scaled)) {
        outcome.problem = QStringLiteral("%1 ms to standstill").arg(outcome.standstillMs, 0, 'f', 0);
    }
    for (const auto& next : event.after) {
        next(*this);
        for (double t = 0; t < 200; t += stepTimeMs()) {
            step();
            const simulator::SimulatedState now = robot.truth();
            outcome.resumedMm =
                std::max(outcome.resumedMm, (now.tcpPose.position - rest.tcpPose.position).norm() * 1000);
        }
    }
    constexpr double kNothing = 0.3;  // [mm] one or two steps of the remaining motion, and noise
    if (outcome.resumedMm > kNothing && outcome.problem.isEmpty()) {
        outcome.problem = QStringLiteral("the arm resumed and moved %1 mm").arg(outcome.resumedMm, 0, 'f', 2);
    }
    if (!isStanding() && outcome.problem.isEmpty()) {
        outcome.problem = QStringLiteral("the arm still moves at the end");
    }
    const bool reported = !clock.isFrozen() && reachable;
    if (reported && outcome.problem.isEmpty() && (motion.isActive() || jog.isActive())) {
        outcome.problem = QStringLiteral("the motion is said to go on");
    }
    return outcome;
}

}  // namespace tiller::test
