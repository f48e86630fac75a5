// SPDX-License-Identifier: MIT
// Measures a circular servo path (equation (1) of the publication), driven by a timer and by the
// packet-locked loop, and the round trip of the speed slider. With and without real-time priority, idle and
// under load.
#include <QTextStream>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#ifdef __linux__
#include <sched.h>
#endif

#include "robot/control/packet_loop.h"
#include "robot/io/outputs.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/realtime_report.h"
#include "robot/receive/receiver.h"
#include "robot/simulator/simulator.h"
#include "tests/benchmarks/backend/report.h"
#include "tests/benchmarks/bare_timer.h"
#include "tests/support/hot_threads.h"

namespace tiller::benchmark {

namespace {

using namespace std::chrono_literals;
using realtime::Histogram;

constexpr std::int64_t kCycleLimitNs = 2'500'000;      // limit of the publication
constexpr std::int64_t kRoundTripLimitNs = 4'500'000;  // limit of the publication

/// Keeps all cores busy at normal priority, like the tool `stress`.
class Load {
public:
    explicit Load(bool wanted) {
        const unsigned count = wanted ? std::thread::hardware_concurrency() + 1 : 0;
        for (unsigned i = 0; i < count; ++i) {
            threads_.emplace_back([this] {
                realtime::nameThread("load");
#ifdef __linux__
                const sched_param normal{};
                sched_setscheduler(0, SCHED_OTHER, &normal);  // must not depend on the priority of the parent
#endif
                volatile double x = 1;
                while (!over_) {
                    for (int k = 0; k < 1000; ++k) {
                        x = std::sqrt(x + k);
                    }
                }
            });
        }
    }
    ~Load() {
        over_ = true;
        for (std::thread& thread : threads_) {
            thread.join();
        }
    }
    Load(const Load&) = delete;
    Load& operator=(const Load&) = delete;

private:
    std::atomic<bool> over_{false};
    std::vector<std::thread> threads_;
};

/// Equation (1) of the publication: a circle in the XY plane.
struct Circle {
    Pose centre;
    double radius = 0.05;
    static constexpr double kFrequency = 0.25;  ///< [Hz]
    Pose at(double time) const {
        Pose pose = centre;
        const double phase = 6.283185307179586 * kFrequency * time;
        pose.position.x() += radius * (std::cos(phase) - 1);
        pose.position.y() += radius * std::sin(phase);
        return pose;
    }
    /// Distance of a position from the circle [mm].
    double offMm(const Eigen::Vector3d& place) const {
        const Eigen::Vector2d middle = centre.position.head<2>() - Eigen::Vector2d(radius, 0);
        return 1000 * std::abs((place.head<2>() - middle).norm() - radius);
    }
};

std::size_t cyclesIn(double seconds) {
    return static_cast<std::size_t>(seconds * 500);
}

struct CircleResult {
    explicit CircleResult(double seconds) : cycles(2 * cyclesIn(seconds)) {}
    Spans cycles;
    /// Time from the package that a target is based on to the package with which the target is sent.
    Histogram reaction;
    double worstOffMm = 0;
    std::uint64_t stale = 0;  ///< cycles without a packet in time
    Error error;
};

void stand(control::Controller& controller) {
    if (const auto stop = control::Motions(controller).stopL(2.0)) {
        (void)stop->wait(Deadline::after(2s));
    }
}

void timerCircle(control::Controller& controller, double seconds, CircleResult& result) {
    Circle circle;
    circle.centre = Pose::fromArray(controller.status().tcpPose);
    auto servo = control::Motions(controller).startServoL();
    if (!servo) {
        result.error = servo.error();
        return;
    }
    realtime::PeriodicTimer timer(2ms);
    std::int64_t previous = SteadyClock::shared().nowNs();
    double time = 0;
    const std::size_t cycles = cyclesIn(seconds);
    std::int64_t usedNs =
        0;  // newest package when the target was computed, and the time when the target was passed on
    std::int64_t handedNs = 0;
    for (std::size_t i = 0; i < cycles; ++i) {
        usedNs = controller.status().dataTimeNs;
        handedNs = SteadyClock::shared().nowNs();
        if (const auto sent = servo->send(circle.at(time)); !sent) {
            result.error = sent.error();
            break;
        }
        timer.wait();
        const std::int64_t now = SteadyClock::shared().nowNs();
        result.cycles.add(previous, now);
        previous = now;
        const auto status = controller.status();
        // The target is sent with the reply to the first later package.
        constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
        std::int64_t leftNs = status.dataTimeNs;
        while (leftNs - kPeriodNs > handedNs) {
            leftNs -= kPeriodNs;
        }
        result.reaction.add(std::max(leftNs, handedNs) - usedNs);
        result.worstOffMm =
            std::max(result.worstOffMm, circle.offMm(Pose::fromArray(status.tcpPose).position));
        time += 0.002 * status.speedFraction * status.speedScaling;
    }
    stand(controller);
}

void packetCircle(control::Controller& controller, double seconds, CircleResult& result) {
    Circle circle;
    circle.centre = Pose::fromArray(controller.status().tcpPose);
    std::int64_t previous = 0;
    const auto follow = [&](const control::CycleState& state) -> std::optional<Pose> {
        if (previous != 0) {
            result.cycles.add(previous, state.beginNs);
        }
        previous = state.beginNs;
        result.worstOffMm = std::max(result.worstOffMm, circle.offMm(state.tcpPose.position));
        result.reaction.add(SteadyClock::shared().nowNs() - state.hostNs);
        return state.time < seconds ? std::optional(circle.at(state.time)) : std::nullopt;
    };
    control::CycleReport cycles;
    const auto ended =
        control::PacketLoop(controller)
            .servoL(follow, {}, Deadline::after(std::chrono::milliseconds(int(seconds * 2000) + 10000)),
                    &cycles);
    if (!ended) {
        result.error = ended.error();
    }
    result.stale += cycles.stale;
    stand(controller);
}

template <class Durations>
double p999Ms(const Durations& durations) {
    return static_cast<double>(durations.percentileNs(99.9)) / 1e6;
}

// Compares the regularity of the loops without concurrent measurements. In one cycle out of ten, the machine
// watch and the idle timer cost about 20 us, which is more than the difference. The loops alternate, so that
// load on the computer affects both.
void compareLoops(Report& report, control::Controller& controller, double seconds) {
    constexpr double kTurn = 1 / Circle::kFrequency;  // the next revolution starts at the same point
    const int turns = std::max(1, static_cast<int>(seconds / kTurn));
    CircleResult timer(turns * kTurn);
    CircleResult packet(turns * kTurn);
    for (int turn = 0; turn < turns; ++turn) {
        timerCircle(controller, kTurn, timer);
        packetCircle(controller, kTurn, packet);
    }
    const QString what = QStringLiteral("%1 s circles in turns, unwatched").arg(turns * kTurn);
    for (const auto& [loop, circle] : {std::pair("timer loop", &timer), {"packet loop", &packet}}) {
        const QString which = QStringLiteral("%1, %2").arg(what, QLatin1String(loop));
        if (circle->error.code != ErrorCode::None) {
            report.cannot(which, circle->error.toString());
            return;
        }
        const Durations quieter = circle->cycles.quieterHalf();
        report.add(which + QStringLiteral(": p99.9"), p999Ms(circle->cycles.all()), QStringLiteral("ms"));
        report.add(which + QStringLiteral(", quieter half: p99"),
                   static_cast<double>(quieter.percentileNs(99)) / 1e6, QStringLiteral("ms"));
        report.add(which + QStringLiteral(", quieter half: p99.9"), p999Ms(quieter), QStringLiteral("ms"));
    }
    report.add(what + QStringLiteral(", packet loop: cycles without their packet"),
               static_cast<double>(packet.stale), QString());
    report.add(what + QStringLiteral(", quieter half: p99.9, packet loop by timer loop"),
               p999Ms(packet.cycles.quieterHalf()) / std::max(p999Ms(timer.cycles.quieterHalf()), 1e-6),
               QString(), 1.0);
}

Spans roundTrips(const receive::Receiver& receiver, const QString& host, int count) {
    Spans trips(static_cast<std::size_t>(count));
    io::Outputs outputs({host}, {[] { return io::Report(); }});
    receive::Sample sample(receiver.layout());
    if (!outputs.connect(Deadline::after(5s))) {
        return trips;
    }
    for (int i = 0; i < count; ++i) {
        const double wanted = i % 2 == 0 ? 0.5 : 1.0;
        const std::int64_t begin = SteadyClock::shared().nowNs();
        // Do not wait for the confirmation of the outputs, because the round trip is measured.
        (void)outputs.setSpeedSlider(wanted, Deadline::after(0ms));
        bool seen = false;
        while (!seen && SteadyClock::shared().nowNs() - begin < kNsPerSecond) {
            receiver.latest(sample);
            seen = std::abs(sample.field("target_speed_fraction")[0] - wanted) < 1e-6;
            if (!seen) {
                std::this_thread::sleep_for(20us);
            }
        }
        trips.add(begin, SteadyClock::shared().nowNs());
    }
    return trips;
}

/// CPUs of the threads. The threads of the program share one CPU, as ControllerOptions::cpus recommends.
/// Those of the robot, which is normally a separate computer, use the other CPUs.
struct Places {
    std::vector<int> program;
    std::vector<int> robot;
};

/// Assigns the last CPU available to this process to the program, and all others to the robot. Empty if there
/// is only one CPU.
Places places() {
    std::vector<int> cpus;
#ifdef __linux__
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
        for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
            if (CPU_ISSET(static_cast<std::size_t>(cpu), &allowed)) {
                cpus.push_back(cpu);
            }
        }
    }
#endif
    if (cpus.size() < 2) {
        return {};
    }
    const int last = cpus.back();
    cpus.pop_back();
    return {{last}, cpus};
}

struct Condition {
    const char* name;
    bool realtime;
    bool load;
};

void measure(Report& report, const Wishes& wishes, const Condition& condition, const QString& address) {
    report.begin(QString::fromLatin1(condition.name));
    QTextStream(stderr) << condition.name << "...\n";
    simulator::SimulatorOptions options;
    options.listenAddress = address;
    options.poweredOn = true;
    options.priority = 95;
    simulator::Simulator robot(options);
    const Places stay = condition.realtime ? places() : Places();
    Result<void> started;
    std::thread starting([&] {  // threads started here inherit the CPUs
        if (!stay.robot.empty()) {
            (void)realtime::bindToCpus(stay.robot);
        }
        started = robot.start();
    });
    starting.join();
    if (!started) {
        report.cannot(QStringLiteral("the simulated controller"), started.error().toString());
        return;
    }
    receive::ReceiverOptions following;
    following.cpus = stay.program;
    following.host = address;
    following.priority = condition.realtime ? 90 : 0;
    receive::Receiver receiver(following);
    receiver.start().value();
    control::ControllerOptions wanted;
    wanted.cpus = stay.program;
    wanted.host = address;
    wanted.priority = condition.realtime ? 85 : 0;
    control::Controller controller(wanted);
    if (const auto taken = controller.takeControl(Deadline::after(10s)); !taken) {
        report.cannot(QStringLiteral("control"), taken.error().toString());
        return;
    }
    const bool required = condition.realtime && condition.load;
    const Load load(condition.load);
    std::thread worker([&] {  // a separate thread, so that its priority ends with the thread
        if (condition.realtime) {
            const auto granted = realtime::requestRealtime(80, stay.program, true);
            report.add(QStringLiteral("real-time priority refused"), granted.priority.granted ? 0 : 1,
                       QString(), 0.0);
            for (const QString& advice : granted.advice) {
                QTextStream(stderr) << advice << '\n';
            }
        }
        std::this_thread::sleep_for(500ms);
        CircleResult warmUp(0.5);
        timerCircle(controller, 0.5, warmUp);
        if (required) {
            compareLoops(report, controller, wishes.seconds);
        }
        const MachineWatch watch;
        const std::vector<double> lengths =
            wishes.seconds > 3 ? std::vector<double>{3, wishes.seconds} : std::vector<double>{wishes.seconds};
        for (const double seconds : lengths) {
            const bool longest = seconds == lengths.back();
            const QString name = QStringLiteral("%1 s circle, ").arg(seconds);
            const test::HotCounts before = test::hotCounts();
            const std::uint64_t packets = receiver.counters().packets;
            test::countHotThreads(true);
            constexpr int kAboveAll = 97;
            BareTimer bare(condition.realtime ? kAboveAll : 0);
            CircleResult timer(seconds);
            timerCircle(controller, seconds, timer);
            robot.resetTiming();
            CircleResult packet(seconds);
            packetCircle(controller, seconds, packet);
            test::countHotThreads(false);
            bare.stop();
            const test::HotCounts after = test::hotCounts();
            const simulator::TickTiming ticks = robot.timing();
            for (const auto& [loop, circle] : {std::pair("timer loop", &timer), {"packet loop", &packet}}) {
                const QString what = name + QLatin1String(loop);
                if (circle->error.code != ErrorCode::None) {
                    report.cannot(what, circle->error.toString());
                    continue;
                }
                report.add(what, circle->cycles, watch, kCycleLimitNs, required && longest);
                report.add(what + QStringLiteral(": furthest off the circle"), circle->worstOffMm,
                           QStringLiteral("mm"));
            }
            if (!longest) {
                continue;
            }
            report.add(QStringLiteral("a timer that does nothing, during both: p99.9"),
                       static_cast<double>(bare.cycles().percentileNs(99.9)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("a timer that does nothing, during both: above 2.5 ms"),
                       static_cast<double>(bare.cycles().countAbove(kCycleLimitNs)), QString());
            report.add(QStringLiteral("simulated controller, lateness of a period: p99.9"),
                       static_cast<double>(ticks.lateness.percentileNs(99.9)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("simulated controller, work of a period: p50"),
                       static_cast<double>(ticks.work.percentileNs(50)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("simulated controller, work of a period: p99.9"),
                       static_cast<double>(ticks.work.percentileNs(99.9)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("simulated controller, periods caught up"),
                       static_cast<double>(ticks.late), QString());
            const auto ratio = [](const auto& locked, const auto& timed) {
                return static_cast<double>(locked.percentileNs(99.9)) /
                       std::max(static_cast<double>(timed.percentileNs(99.9)), 1.0);
            };
            report.add(QStringLiteral("packet loop: cycles without their packet"),
                       static_cast<double>(packet.stale), QString());
            report.add(QStringLiteral("p99.9 of cycles, packet loop by timer loop"),
                       ratio(packet.cycles.all(), timer.cycles.all()), QString());
            report.add(QStringLiteral("timer loop, package in to target out: p99.9"),
                       static_cast<double>(timer.reaction.percentileNs(99.9)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("packet loop, package in to target out: p99.9"),
                       static_cast<double>(packet.reaction.percentileNs(99.9)) / 1e6, QStringLiteral("ms"));
            report.add(QStringLiteral("p99.9 of package in to target out, packet by timer"),
                       ratio(packet.reaction, timer.reaction), QString(),
                       required ? std::optional(1.0) : std::nullopt);
            report.add(QStringLiteral("packages during both circles"),
                       static_cast<double>(receiver.counters().packets - packets), QString());
            report.add(QStringLiteral("allocations in both threads"),
                       static_cast<double>(after.allocations - before.allocations), QString(), 0.0);
            report.add(QStringLiteral("locks in both threads"),
                       static_cast<double>(after.locks - before.locks), QString(), 0.0);
            report.add(QStringLiteral("threads watched are missing"), test::hotThreads() >= 2 ? 0 : 1,
                       QString(), 0.0);
        }
        const Spans trips = roundTrips(receiver, address, wishes.roundTrips);
        report.add(QStringLiteral("slider round trip"), trips, watch, kRoundTripLimitNs, required);
    });
    worker.join();
    controller.release();
    receiver.stop();
    robot.stop();
}

}  // namespace

void measureLoops(Report& report, const Wishes& wishes) {
    const Condition conditions[] = {
        {"normal priority, idle", false, false},
        {"normal priority, under load", false, true},
        {"real-time priority, idle", true, false},
        {"real-time priority, under load", true, true},
    };
    int number = 0;
    for (const Condition& condition : conditions) {
        measure(report, wishes, condition, QStringLiteral("127.0.8.%1").arg(++number));
    }
}

}  // namespace tiller::benchmark
