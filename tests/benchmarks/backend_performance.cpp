// SPDX-License-Identifier: MIT
//
// The comparison of the ur_rtde paper (section IV), run again over real sockets against the simulated
// controller on this machine: (a) the circle test with a timer and with the packet-locked loop, (b) the speed
// slider's round trip, (c) what decoding and a control tick cost, (d) allocations and locks in both loops,
// (e) the share of a CPU that receiving takes, (f) how soon calls end against a mute peer. One table, or one
// JSON object with
// --json; asserts nothing.
//
//   backend_performance [--seconds 3] [--round-trips 1000] [--priority 85] [--json]
//
// Under load: stress -c $(nproc) & backend_performance. Instructions:
//   valgrind --tool=callgrind --toggle-collect='*oneDecode*' backend_performance --seconds 0.1 --round-trips
//   1

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

#include "robot/control/arm_queries.h"
#include "robot/control/control_loop.h"
#include "robot/control/packet_loop.h"
#include "robot/io/outputs.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/realtime_report.h"
#include "robot/receive/receiver.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/fields.h"
#include "robot/simulator/controller.h"
#include "tests/support/hot_threads.h"

using namespace tiller;
using namespace std::chrono_literals;
using realtime::Histogram;
using SteadyTime = std::chrono::steady_clock;

namespace {

constexpr std::int64_t kCycleLimitNs = 2'500'000;      // as in the paper
constexpr std::int64_t kRoundTripLimitNs = 4'500'000;  // as in the paper

std::int64_t since(SteadyTime::time_point begin) {
    return std::chrono::nanoseconds(SteadyTime::now() - begin).count();
}

QJsonObject summary(const Histogram& h, std::int64_t limitNs) {
    const auto us = [](std::int64_t ns) { return static_cast<double>(ns) / 1000.0; };
    return {{"count", static_cast<qint64>(h.count())},
            {"p50_us", us(h.percentileNs(50))},
            {"p99_us", us(h.percentileNs(99))},
            {"p99_9_us", us(h.percentileNs(99.9))},
            {"max_us", us(h.maxNs())},
            {"above_limit", static_cast<qint64>(h.countAbove(limitNs))}};
}

/// Equation (1) of the paper: a circle in the XY plane.
struct Circle {
    Pose centre;
    double radius = 0.05;
    double frequency = 0.25;
    Pose at(double time) const {
        Pose pose = centre;
        const double phase = 6.283185307179586 * frequency * time;
        pose.position.x() += radius * (std::cos(phase) - 1);
        pose.position.y() += radius * std::sin(phase);
        return pose;
    }
    /// How far a place is off the circle [mm].
    double offMm(const Eigen::Vector3d& place) const {
        const Eigen::Vector2d middle = centre.position.head<2>() - Eigen::Vector2d(radius, 0);
        return 1000 * std::abs((place.head<2>() - middle).norm() - radius);
    }
};

struct CircleResult {
    Histogram cycles;
    double worstOffMm = 0;
    std::uint64_t missed = 0;
};

CircleResult timerCircle(control::Controller& controller, double seconds) {
    CircleResult result;
    control::Motions motions(controller);
    Circle circle;
    circle.centre = Pose::fromArray(controller.status().tcpPose);
    auto servo = motions.startServoL();
    if (!servo) {
        return result;
    }
    realtime::PeriodicTimer timer(2ms);
    auto previous = SteadyTime::now();
    double time = 0;
    const int cycles = static_cast<int>(seconds * 500);
    for (int i = 0; i < cycles; ++i) {
        if (!servo->send(circle.at(time))) {
            break;
        }
        result.missed += timer.wait();
        const auto now = SteadyTime::now();
        result.cycles.add(std::chrono::nanoseconds(now - previous).count());
        previous = now;
        const auto status = controller.status();
        result.worstOffMm =
            std::max(result.worstOffMm, circle.offMm(Pose::fromArray(status.tcpPose).position));
        time += 0.002 * status.speedFraction * status.speedScaling;
    }
    if (const auto stop = motions.stopL(2.0)) {
        (void)stop->wait(Deadline::after(2s));
    }
    return result;
}

CircleResult packetCircle(control::Controller& controller, double seconds) {
    CircleResult result;
    Circle circle;
    circle.centre = Pose::fromArray(controller.status().tcpPose);
    control::CycleReport report;
    const auto follow = [&](const control::CycleState& state) -> std::optional<Pose> {
        result.worstOffMm = std::max(result.worstOffMm, circle.offMm(state.tcpPose.position));
        return state.time < seconds ? std::optional(circle.at(state.time)) : std::nullopt;
    };
    (void)control::PacketLoop(controller).servoL(follow, {}, Deadline::after(120s), &report);
    result.cycles = report.intervals;
    result.missed = report.missed;
    std::this_thread::sleep_for(300ms);
    return result;
}

QJsonObject toJson(const CircleResult& circle) {
    QJsonObject json = summary(circle.cycles, kCycleLimitNs);
    json["worst_off_circle_mm"] = circle.worstOffMm;
    json["missed"] = static_cast<qint64>(circle.missed);
    return json;
}

QJsonObject roundTrips(const receive::Receiver& receiver, const QString& host, int count) {
    io::OutputsOptions options;
    options.host = host;
    io::Outputs outputs(options, {[] { return io::Report(); }});
    // Sent without waiting for the outputs' own confirmation: what is measured is the way out and back.
    Histogram trips;
    auto stream = receiver.subscribe();
    receive::Sample sample(receiver.layout());
    if (!outputs.connect(Deadline::after(5s))) {
        return {};
    }
    for (int i = 0; i < count; ++i) {
        const double wanted = i % 2 == 0 ? 0.5 : 1.0;
        while (stream.next(sample)) {
        }
        const auto begin = SteadyTime::now();
        (void)outputs.setSpeedSlider(wanted, Deadline::after(0ms));
        bool seen = false;
        while (!seen && since(begin) < 1'000'000'000) {
            receiver.latest(sample);
            seen = std::abs(sample.field("target_speed_fraction")[0] - wanted) < 1e-6;
            if (!seen) {
                std::this_thread::sleep_for(20us);
            }
        }
        trips.add(since(begin));
    }
    return summary(trips, kRoundTripLimitNs);
}

/// One packet of the 20-field recipe. A function of its own, so that callgrind can count it.
[[gnu::noinline]] bool oneDecode(const rtde::ValueLayout& layout, rtde::ByteView wire,
                                 std::span<double> values) {
    return rtde::decodeValues(layout, wire, values);
}

}  // namespace

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"seconds", "How long each circle takes.", "s", "3"},
                       {"round-trips", "How often the slider is set.", "n", "1000"},
                       {"priority", "Real-time priority of the control thread; 0: none.", "p", "85"},
                       {"json", "One JSON object instead of a table."}});
    parser.process(application);
    QTextStream err(stderr);

    simulator::ControllerOptions options;
    options.listenAddress = QStringLiteral("127.0.8.1");
    options.poweredOn = true;
    options.priority = 95;
    simulator::Controller robot(options);
    if (const auto started = robot.start(); !started) {
        err << started.error().toString() << '\n';
        return 1;
    }
    const int priority = parser.value("priority").toInt();
    receive::ReceiverOptions following;
    following.host = options.listenAddress;
    following.priority = priority > 0 ? 90 : 0;
    receive::Receiver receiver(following);
    receiver.start();
    control::ControllerOptions wanted;
    wanted.host = options.listenAddress;
    wanted.priority = priority;
    control::Controller controller(wanted);
    if (const auto taken = controller.takeControl(Deadline::after(10s)); !taken) {
        err << taken.error().toString() << '\n';
        return 1;
    }
    std::this_thread::sleep_for(500ms);

    QJsonObject json;
    const realtime::RealtimeReport granted =
        priority > 0 ? realtime::requestRealtime(80, {}, true) : realtime::RealtimeReport();
    json["realtime"] = QJsonObject{{"priority", granted.priority.granted},
                                   {"memory_locked", granted.memoryLocked},
                                   {"realtime_kernel", granted.realtimeKernel}};
    const double seconds = parser.value("seconds").toDouble();
    const test::HotCounts before = test::hotCounts();
    const std::uint64_t packets = receiver.counters().packets;
    test::countHotThreads(true);
    const std::clock_t cpuBefore = std::clock();
    json["circle_timer_loop"] = toJson(timerCircle(controller, seconds));
    json["circle_packet_loop"] = toJson(packetCircle(controller, seconds));
    test::countHotThreads(false);
    const auto cycles = static_cast<double>(receiver.counters().packets - packets);
    json["loops"] = QJsonObject{
        {"threads_watched", test::hotThreads()},
        {"packets", cycles},
        {"allocations", static_cast<qint64>(test::hotCounts().allocations - before.allocations)},
        {"locks", static_cast<qint64>(test::hotCounts().locks - before.locks)},
        {"process_cpu_percent_with_simulator",
         100.0 * static_cast<double>(std::clock() - cpuBefore) / CLOCKS_PER_SEC / (cycles * 0.002)}};
    json["slider_round_trip"] =
        roundTrips(receiver, options.listenAddress, parser.value("round-trips").toInt());

    const std::vector<std::string> twenty{"timestamp",
                                          "target_q",
                                          "target_qd",
                                          "actual_q",
                                          "actual_qd",
                                          "actual_current",
                                          "actual_TCP_pose",
                                          "actual_TCP_speed",
                                          "actual_TCP_force",
                                          "target_TCP_pose",
                                          "target_TCP_speed",
                                          "joint_temperatures",
                                          "robot_mode",
                                          "joint_mode",
                                          "safety_mode",
                                          "speed_scaling",
                                          "runtime_state",
                                          "target_speed_fraction",
                                          "actual_digital_input_bits",
                                          "actual_digital_output_bits"};
    std::vector<rtde::DataType> types;
    for (const std::string& name : twenty) {
        types.push_back(rtde::findOutput(name)->type);
    }
    const rtde::ValueLayout layout(types);
    const std::vector<std::uint8_t> wire(layout.wireBytes(), 0x3f);
    std::vector<double> values(layout.components());
    constexpr int kDecodes = 200'000;
    const auto begin = SteadyTime::now();
    bool good = true;
    for (int i = 0; i < kDecodes; ++i) {
        good = oneDecode(layout, wire, values) && good;
    }
    json["decode_20_fields_ns"] = good ? static_cast<double>(since(begin)) / kDecodes : -1.0;

    control::Mailbox mailbox;
    control::ControlLoop loop(mailbox, {});
    const SteadyClock& clock = SteadyClock::shared();
    loop.begin(1, 0.002, control::ArmLimits::of(robotModel(RobotModelId::UR5e)), clock.nowNs());
    control::Feedback data;
    data.runtimeState = RuntimeState::Playing;
    data.robotMode = RobotMode::Running;
    data.safetyMode = SafetyMode::Normal;
    constexpr int kTicks = 200'000;
    const auto ticking = SteadyTime::now();
    for (int i = 0; i < kTicks; ++i) {
        data.hostNs = clock.nowNs();
        const control::Command command = loop.tick(data);
        data.echo.sequence = command.sequence;
        data.echo.epoch = command.epoch;
        data.echo.session = command.session;
    }
    json["control_tick_ns"] = static_cast<double>(since(ticking)) / kTicks;

    // (f) the mute peer
    robot.silence(true);
    Histogram late;
    for (int i = 0; i < 20; ++i) {
        const auto asked = SteadyTime::now();
        (void)control::ArmQueries(controller).jointTorques(Deadline::after(20ms));
        late.add(since(asked) - 20'000'000);
    }
    json["deadline_overrun_mute_peer"] = summary(late, 60'000'000);
    const auto releasing = SteadyTime::now();
    controller.release();
    receiver.stop();
    json["disconnect_mute_peer_ms"] = static_cast<double>(since(releasing)) / 1e6;
    robot.stop();

    QTextStream out(stdout);
    if (parser.isSet("json")) {
        out << QJsonDocument(json).toJson(QJsonDocument::Compact) << '\n';
        return 0;
    }
    for (auto it = json.begin(); it != json.end(); ++it) {
        out << it.key();
        if (it->isObject()) {
            out << '\n';
            const QJsonObject inner = it->toObject();
            for (auto value = inner.begin(); value != inner.end(); ++value) {
                out << "    " << value.key() << "  " << value->toVariant().toString() << '\n';
            }
        } else {
            out << "  " << it->toVariant().toString() << '\n';
        }
    }
    for (const QString& advice : granted.advice) {
        out << advice << '\n';
    }
    return 0;
}
