// SPDX-License-Identifier: MIT
// Time and instruction counts of decoding a package and of a control tick, and the CPU share of receiving.
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include "robot/collision/collision_check.h"
#include "robot/control/detail/control_loop.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/receive/receiver.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"
#include "robot/simulator/simulator.h"
#include "tests/benchmarks/backend/report.h"

namespace tiller::benchmark {

namespace {

using namespace std::chrono_literals;
using SteadyTime = std::chrono::steady_clock;

const std::vector<std::string>& twentyFields() {
    static const std::vector<std::string> names{"timestamp",
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
    return names;
}

/// Decodes one package of the recipe. This is a separate function, so that callgrind can count it.
[[gnu::noinline]] bool oneDecode(const rtde::ValueLayout& layout, rtde::ByteView wire,
                                 std::span<double> values) {
    return rtde::decodeValues(layout, wire, values);
}

struct Decoding {
    rtde::ValueLayout layout;
    std::vector<std::uint8_t> wire;
    std::vector<double> values;

    Decoding() : layout(types()), wire(layout.wireBytes(), 0x3f), values(layout.components()) {}
    bool once() { return oneDecode(layout, wire, values); }

private:
    static std::vector<rtde::DataType> types() {
        std::vector<rtde::DataType> all;
        for (const std::string& name : twentyFields()) {
            all.push_back(rtde::findOutput(name)->type);
        }
        return all;
    }
};

/// A control loop and its robot. The measurement includes the simulation of the robot, which is one line.
struct Ticking {
    control::Mailbox mailbox;
    control::ControlLoop loop{mailbox, {}};
    control::Feedback data;
    const Clock& clock = SteadyClock::shared();

    Ticking() {
        loop.begin(1, 0.002, control::ArmLimits::of(robotModel(RobotModelId::UR5e)), clock.nowNs());
        data.runtimeState = RuntimeState::Playing;
        data.robotMode = RobotMode::Running;
        data.safetyMode = SafetyMode::Normal;
        once();
        once();
        control::MotionCommand stream;
        stream.kind = control::MotionCommand::Kind::Program;
        stream.program = static_cast<std::int32_t>(control::ScriptCommand::SpeedL);
        stream.held = false;
        mailbox.start(stream, clock.nowNs());
    }
    bool once() {
        data.hostNs = clock.nowNs();
        data.timestamp += 0.002;
        const control::Command command = loop.tick(data);
        const auto values = control::encode(command);
        data.echo.sequence = command.sequence;
        data.echo.epoch = command.epoch;
        data.echo.session = command.session;
        return values.size() == control::kCommandSize;
    }
};

/// A jog just above a floor, so that all limits are evaluated in each tick.
struct Jogging : Ticking {
    /// boxes  number of nearby boxes; negative: no collision check
    explicit Jogging(int boxes) {
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        data.q = JointPositions(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);
        data.tcpPose = kinematics::forwardTcp(model.dh, data.q);
        if (boxes >= 0) {
            collision::Surroundings around;
            around.borders.push_back({{}, Pose(0, 0, data.tcpPose.position.z() - 0.12, 0, 0, 0)});
            for (int i = 0; i < boxes; ++i) {
                around.obstacles.push_back(
                    {QString::number(i), Pose(0.3 * i - 1, -0.8, 0.3, 0, 0, 0.3), {0.2, 0.2, 0.4}});
            }
            loop.setCollisionCheck(
                std::make_shared<collision::CollisionCheck>(model, collision::ToolBody{{}, 0}, around));
        }
        control::MotionCommand jog;
        jog.kind = control::MotionCommand::Kind::Jog;
        jog.jog.twist.linear = {0.1, 0.02, -0.1};
        jog.held = false;
        mailbox.start(jog, clock.nowNs());
    }
};

double nanoseconds(int times, const std::function<void(int)>& work) {
    work(times / 10);  // warm-up
    const auto begin = SteadyTime::now();
    work(times);
    return static_cast<double>(std::chrono::nanoseconds(SteadyTime::now() - begin).count()) / times;
}

/// Reads the performance counter of the CPU. Empty if the counter is not accessible, as in most virtual
/// machines.
std::optional<double> instructions([[maybe_unused]] int times,
                                   [[maybe_unused]] const std::function<void(int)>& work) {
#ifdef __linux__
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
    attributes.disabled = 1;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    const int counter = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
    if (counter < 0) {
        return {};
    }
    ioctl(counter, PERF_EVENT_IOC_RESET, 0);
    ioctl(counter, PERF_EVENT_IOC_ENABLE, 0);
    work(times);
    ioctl(counter, PERF_EVENT_IOC_DISABLE, 0);
    std::uint64_t count = 0;
    const bool good = read(counter, &count, sizeof count) == static_cast<ssize_t>(sizeof count);
    close(counter);
    if (good && count > 0) {
        return static_cast<double>(count) / times;
    }
#endif
    return {};
}

/// Counts with callgrind, which runs this program as a child process.
std::optional<double> decodeInstructionsByCallgrind() {
    constexpr int kTimes = 1000;
    const QString valgrind = QStandardPaths::findExecutable(QStringLiteral("valgrind"));
    if (valgrind.isEmpty()) {
        return {};
    }
    QProcess process;
    process.start(valgrind,
                  {QStringLiteral("--tool=callgrind"), QStringLiteral("--callgrind-out-file=/dev/null"),
                   QStringLiteral("--toggle-collect=*oneDecode*"), QCoreApplication::applicationFilePath(),
                   QStringLiteral("--decode-only"), QString::number(kTimes)});
    process.waitForFinished(120'000);
    static const QRegularExpression kCollected(QStringLiteral("Collected : (\\d+)"));
    const auto found = kCollected.match(QString::fromLatin1(process.readAllStandardError()));
    return found.hasMatch() && found.captured(1).toDouble() > 0
               ? std::optional(found.captured(1).toDouble() / kTimes)
               : std::nullopt;
}

/// Returns the accumulated run time of the threads with this name [s].
double cpuSeconds(const QByteArray& thread) {
    double seconds = 0;
    const QDir tasks(QStringLiteral("/proc/self/task"));
    for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile name(tasks.filePath(task + QStringLiteral("/comm")));
        QFile spent(tasks.filePath(task + QStringLiteral("/schedstat")));
        if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == thread &&
            spent.open(QIODevice::ReadOnly)) {
            seconds += spent.readAll().split(' ').value(0).toDouble() / 1e9;
        }
    }
    return seconds;
}

/// Returns as many fields of the catalogue as fit into one request.
std::vector<std::string> allFields() {
    std::vector<std::string> names;
    std::size_t bytes = 0;
    for (const rtde::Field& field : rtde::outputFields()) {
        bytes += std::string_view(field.name).size() + 1;
        if (bytes > 2000) {
            break;
        }
        names.emplace_back(field.name);
    }
    return names;
}

void receiving(Report& report, const QString& host, const char* what,
               const std::vector<std::string>& fields) {
    receive::ReceiverOptions options;
    options.host = host;
    options.fields = fields;
    options.priority = 0;
    receive::Receiver receiver(options);
    receiver.start().value();
    while (receiver.counters().packets < 100) {
        std::this_thread::sleep_for(1ms);
    }
    const double before = cpuSeconds("tiller-receive");
    const auto begin = SteadyTime::now();
    const std::uint64_t packets = receiver.counters().packets;
    std::this_thread::sleep_for(5s);
    const double passed = std::chrono::duration<double>(SteadyTime::now() - begin).count();
    const double share = (cpuSeconds("tiller-receive") - before) / passed;
    const auto rate = static_cast<double>(receiver.counters().packets - packets) / passed;
    report.add(QStringLiteral("receiving %1 (%2 fields) at %3 Hz")
                   .arg(QLatin1String(what))
                   .arg(fields.size())
                   .arg(rate, 0, 'f', 0),
               100 * share, QStringLiteral("% of a core"));
}

}  // namespace

bool decodeOnly(int times) {
    Decoding decoding;
    bool good = true;
    for (int i = 0; i < times; ++i) {
        good = decoding.once() && good;
    }
    return good;
}

void measureCosts(Report& report) {
    report.begin(QStringLiteral("costs"));
    constexpr int kTimes = 200'000;
    Decoding decoding;
    bool good = true;
    const auto decode = [&](int times) {
        for (int i = 0; i < times; ++i) {
            good = decoding.once() && good;
        }
    };
    report.add(QStringLiteral("decode of 20 fields"), nanoseconds(kTimes, decode), QStringLiteral("ns"),
               1000);
    auto counted = instructions(kTimes, decode);
    if (!counted) {
        counted = decodeInstructionsByCallgrind();
    }
    if (counted) {
        report.add(QStringLiteral("decode of 20 fields, instructions"), *counted, QString(), 5000);
    } else {
        report.cannot(QStringLiteral("decode of 20 fields, instructions"),
                      QStringLiteral("no counter for us here, and no valgrind"));
    }
    Ticking ticking;
    const auto tick = [&](int times) {
        for (int i = 0; i < times; ++i) {
            good = ticking.once() && good;
        }
    };
    report.add(QStringLiteral("control tick with a stream, clock and encoding included"),
               nanoseconds(kTimes, tick), QStringLiteral("ns"), 2000);
    if (const auto perTick = instructions(kTimes, tick)) {
        report.add(QStringLiteral("control tick, instructions"), *perTick, QString());
    }
    for (const int boxes : {-1, 0, 8}) {
        Jogging jogging(boxes);
        report.add(boxes < 0 ? QStringLiteral("control tick with a jog, without a collision check")
                             : QStringLiteral("the same with the arm, a floor and %1 boxes").arg(boxes),
                   nanoseconds(kTimes / 10,
                               [&](int times) {
                                   for (int i = 0; i < times; ++i) {
                                       good = jogging.once() && good;
                                   }
                               }),
                   QStringLiteral("ns"));
    }
    report.add(QStringLiteral("decodes or ticks that failed"), good ? 0 : 1, QString(), 0.0);

    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.0.8.100");
    options.poweredOn = true;
    simulator::Simulator robot(options);
    if (const auto started = robot.start(); !started) {
        report.cannot(QStringLiteral("receiving"), started.error().toString());
        return;
    }
    receiving(report, options.listenAddress, "the twenty", twentyFields());
    receiving(report, options.listenAddress, "all that fit", allFields());
    robot.stop();
}

}  // namespace tiller::benchmark
