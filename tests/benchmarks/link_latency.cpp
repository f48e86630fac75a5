// SPDX-License-Identifier: MIT
//
// Measures the regularity of packages and the time from a stop to standstill, with real sockets and the
// simulated controller on this computer. Prints a table and, with --json, one JSON object. Does not check
// limits.
//
//   link_latency [--seconds 10] [--jogs 20] [--record FILE] [--json]

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>
#include <algorithm>
#include <thread>
#include <vector>

#include "robot/control/motions.h"
#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;

namespace {

double percentile(std::vector<double> values, double percent) {
    if (values.empty()) {
        return 0;
    }
    std::sort(values.begin(), values.end());
    const auto index =
        static_cast<std::size_t>(percent / 100.0 * static_cast<double>(values.size() - 1) + 0.5);
    return values[std::min(index, values.size() - 1)];
}

struct JogTimes {
    std::vector<double> pressToMotionMs;
    std::vector<double> releaseToStandstillMs;
    std::vector<double> distanceMm;
};

/// Performs one hold and release at 100 mm/s. The motion is refreshed every 20 ms, as by a button.
void jogOnce(control::Controller& controller, double direction, JogTimes& times) {
    control::JogTarget target;
    target.twist.linear.x() = 0.1 * direction;
    const std::uint64_t stops = controller.status().lastStop.count;
    const auto pressed = std::chrono::steady_clock::now();
    const Result<control::Jog> jog = control::Motions(controller).startJog(target);
    if (!jog) {
        return;
    }
    bool seenMoving = false;
    for (auto next = pressed; std::chrono::steady_clock::now() - pressed < 400ms;) {
        if (!seenMoving && controller.status().executing) {
            seenMoving = true;
            times.pressToMotionMs.push_back(
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - pressed)
                    .count());
        }
        if (std::chrono::steady_clock::now() >= next) {
            jog->refresh();
            next += 20ms;
        }
        std::this_thread::sleep_for(200us);
    }
    jog->cancel(control::StopCause::Released);
    const auto released = std::chrono::steady_clock::now();
    while (controller.status().lastStop.count == stops && std::chrono::steady_clock::now() - released < 2s) {
        std::this_thread::sleep_for(1ms);
    }
    const control::StopMeasurement stop = controller.status().lastStop;
    if (stop.count > stops) {
        times.releaseToStandstillMs.push_back(stop.durationMs);
        times.distanceMm.push_back(stop.distanceMm);
    }
}

}  // namespace

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"seconds", "How long packages are watched.", "s", "10"},
                       {"jogs", "How many holds and releases.", "n", "20"},
                       {"record", "Record to this CSV file meanwhile.", "file"},
                       {"json", "One JSON object instead of a table."}});
    parser.process(application);

    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.0.7.1");
    options.poweredOn = true;
    options.priority = 95;
    simulator::Simulator robot(options);
    QTextStream err(stderr);
    if (const Result<void> started = robot.start(); !started) {
        err << started.error().toString() << '\n';
        return 1;
    }
    receive::ReceiverOptions receiverOptions;
    receiverOptions.host = options.listenAddress;
    receive::Receiver receiver(receiverOptions);
    receiver.start().value();
    control::ControllerOptions controllerOptions;
    controllerOptions.host = options.listenAddress;
    control::Controller controller(controllerOptions);
    if (const Result<void> taken = controller.takeControl(Deadline::after(10s)); !taken) {
        err << taken.error().toString() << '\n';
        return 1;
    }
    std::this_thread::sleep_for(500ms);
    receiver.resetCounters();
    std::this_thread::sleep_for(10ms);  // the command takes effect with the next package
    recording::Recorder recorder;
    if (parser.isSet("record")) {
        recording::RecorderOptions recorderOptions;
        recorderOptions.path = parser.value("record");
        if (const Result<void> recording = recorder.start(recorderOptions, receiver); !recording) {
            err << recording.error().toString() << '\n';
            return 1;
        }
    }
    std::this_thread::sleep_for(std::chrono::seconds(parser.value("seconds").toInt()));
    const receive::ReceiverCounters counters = receiver.counters();
    recorder.stop();
    const recording::RecorderProgress recorded = recorder.progress();
    const realtime::Histogram intervals = receiver.intervals();

    JogTimes times;
    for (int i = 0; i < parser.value("jogs").toInt(); ++i) {
        jogOnce(controller, i % 2 == 0 ? 1.0 : -1.0, times);
    }
    controller.release();

    const auto us = [](std::int64_t ns) { return static_cast<double>(ns) / 1000.0; };
    QTextStream out(stdout);
    if (parser.isSet("json")) {
        const QJsonObject json{
            {"packages", static_cast<qint64>(counters.packets)},
            {"late", static_cast<qint64>(counters.late)},
            {"lost", static_cast<qint64>(counters.lost)},
            {"recorded_rows", static_cast<qint64>(recorded.rows)},
            {"recorded_lost", static_cast<qint64>(recorded.lost)},
            {"interval_us_p50", us(intervals.percentileNs(50))},
            {"interval_us_p99", us(intervals.percentileNs(99))},
            {"interval_us_p99_9", us(intervals.percentileNs(99.9))},
            {"interval_us_max", us(intervals.maxNs())},
            {"press_to_motion_ms_p50", percentile(times.pressToMotionMs, 50)},
            {"press_to_motion_ms_p99", percentile(times.pressToMotionMs, 99)},
            {"release_to_standstill_ms_p50", percentile(times.releaseToStandstillMs, 50)},
            {"release_to_standstill_ms_p99", percentile(times.releaseToStandstillMs, 99)},
            {"stop_distance_mm_p99", percentile(times.distanceMm, 99)},
            {"realtime_granted", receiver.priority().granted},
        };
        out << QJsonDocument(json).toJson(QJsonDocument::Compact) << '\n';
        return 0;
    }
    out.setRealNumberNotation(QTextStream::FixedNotation);
    out.setRealNumberPrecision(1);
    out << "receive: " << counters.packets << " packages, " << counters.late << " late, " << counters.lost
        << " lost; real-time priority " << receiver.priority().granted << " of "
        << receiver.priority().requested << "\n  interval us   p50 " << us(intervals.percentileNs(50))
        << "  p99 " << us(intervals.percentileNs(99)) << "  p99.9 " << us(intervals.percentileNs(99.9))
        << "  max " << us(intervals.maxNs()) << '\n'
        << "record: " << recorded.rows << " rows over " << recorded.seconds << " s of robot time, "
        << recorded.lost << " packages missing\n"
        << "jog: " << times.releaseToStandstillMs.size() << " holds at 100 mm/s\n"
        << "  press to motion confirmed ms   p50 " << percentile(times.pressToMotionMs, 50) << "  p99 "
        << percentile(times.pressToMotionMs, 99) << "\n  release to standstill ms       p50 "
        << percentile(times.releaseToStandstillMs, 50) << "  p99 "
        << percentile(times.releaseToStandstillMs, 99) << "\n  release to standstill mm       p50 "
        << percentile(times.distanceMm, 50) << "  p99 " << percentile(times.distanceMm, 99) << '\n';
    return 0;
}
