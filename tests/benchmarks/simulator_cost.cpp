// SPDX-License-Identifier: MIT
//
// Measures the cost and regularity of a simulated controller in real time with real sockets: three RTDE
// clients with the full recipe of the receiver at full rate, a primary client, and a 500 Hz script. Runs
// first one controller and then several in parallel. As a reference, a thread with the same priority only
// wakes up every 2 ms. Finally, both are evaluated second by second: on a shared computer some seconds are
// disturbed, and the median is representative. Prints tables and, with --json, one JSON object. Does not
// check limits.
//
//   simulator_cost [--seconds 20] [--controllers 8] [--clients 3] [--priority 95] [--json]

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpSocket>
#include <QTextStream>
#include <QThread>
#include <algorithm>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include "robot/realtime/histogram.h"
#include "robot/receive/receiver.h"
#include "robot/script/primary_client.h"
#include "robot/simulator/simulator.h"
#include "tests/benchmarks/bare_timer.h"

using namespace tiller;
using benchmark::BareTimer;
using namespace std::chrono_literals;

namespace {

/// A typical control loop of a client: reads registers, sends a servo target, writes registers.
const char* const kScript =
    "def loop():\n"
    "  q0 = get_actual_joint_positions()\n"
    "  phase = 0.0\n"
    "  while True:\n"
    "    command = read_input_integer_register(24)\n"
    "    phase = phase + 0.005\n"
    "    q = q0\n"
    "    q[0] = q0[0] + 0.1 * sin(phase)\n"
    "    q[4] = q0[4] + 0.1 * (1 - cos(phase))\n"
    "    i = 0\n"
    "    while i < 6:\n"
    "      write_output_float_register(24 + i, q[i])\n"
    "      i = i + 1\n"
    "    end\n"
    "    write_output_integer_register(24, command)\n"
    "    servoj(q, t=get_steptime(), lookahead_time=0.1, gain=300)\n"
    "  end\n"
    "end\n";

/// A controller with its clients.
struct Cell {
    Cell(int number, int priority, int clients) {
        options.listenAddress = QStringLiteral("127.0.8.%1").arg(number);
        options.poweredOn = true;
        options.priority = priority;
        robot = std::make_unique<simulator::Simulator>(options);
        const Result<void> started = robot->start();
        if (!started) {
            error = started.error().toString();
            return;
        }
        for (int i = 0; i < clients; ++i) {
            receive::ReceiverOptions receiver;
            receiver.host = options.listenAddress;
            receiver.priority = 0;
            receivers.push_back(std::make_unique<receive::Receiver>(receiver));
            receivers.back()->start().value();
        }
        script::PrimaryClientOptions primaryOptions;
        primaryOptions.host = options.listenAddress;
        primary = std::make_unique<script::PrimaryClient>(primaryOptions);
        primary->start();
        QTcpSocket upload;
        upload.connectToHost(options.listenAddress, 30002);
        if (upload.waitForConnected(5000)) {
            upload.write(kScript);
            upload.waitForBytesWritten(5000);
            upload.waitForDisconnected(200);  // gives the controller time to read the script
        }
    }

    simulator::SimulatorOptions options;
    std::unique_ptr<simulator::Simulator> robot;
    std::vector<std::unique_ptr<receive::Receiver>> receivers;
    std::unique_ptr<script::PrimaryClient> primary;
    QString error;
};

double us(std::int64_t ns) {
    return static_cast<double>(ns) / 1000.0;
}

QJsonObject report(QTextStream& out, const char* name, const simulator::TickTiming& t, bool playing) {
    const double share = t.seconds > 0 ? 100 * t.threadSeconds / t.seconds : 0;
    out << name << ": " << share << " % of a core, " << t.ticks << " ticks, " << t.late << " late, " << t.lost
        << " lost" << (playing ? "" : "  (THE SCRIPT IS NOT RUNNING)") << "\n  lateness us   p50 "
        << us(t.lateness.percentileNs(50)) << "  p99 " << us(t.lateness.percentileNs(99)) << "  p99.9 "
        << us(t.lateness.percentileNs(99.9)) << "  max " << us(t.lateness.maxNs()) << "\n  work us       p50 "
        << us(t.work.percentileNs(50)) << "  p99 " << us(t.work.percentileNs(99)) << "  p99.9 "
        << us(t.work.percentileNs(99.9)) << "  max " << us(t.work.maxNs()) << "\n";
    return {{"core_percent", share},
            {"ticks", static_cast<qint64>(t.ticks)},
            {"late", static_cast<qint64>(t.late)},
            {"lost", static_cast<qint64>(t.lost)},
            {"lateness_us_p50", us(t.lateness.percentileNs(50))},
            {"lateness_us_p99", us(t.lateness.percentileNs(99))},
            {"lateness_us_p99_9", us(t.lateness.percentileNs(99.9))},
            {"lateness_us_max", us(t.lateness.maxNs())},
            {"work_us_p50", us(t.work.percentileNs(50))},
            {"work_us_p99_9", us(t.work.percentileNs(99.9))},
            {"script_running", playing},
            {"realtime_granted", t.priorityGranted}};
}

QJsonObject report(QTextStream& out, const realtime::Histogram& bare) {
    out << "a timer alone at that priority:\n  lateness us   p50 " << us(bare.percentileNs(50)) << "  p99 "
        << us(bare.percentileNs(99)) << "  p99.9 " << us(bare.percentileNs(99.9)) << "  max "
        << us(bare.maxNs()) << "\n";
    return {{"lateness_us_p50", us(bare.percentileNs(50))},
            {"lateness_us_p99", us(bare.percentileNs(99))},
            {"lateness_us_p99_9", us(bare.percentileNs(99.9))},
            {"lateness_us_max", us(bare.maxNs())}};
}

QString load() {
    std::ifstream file("/proc/loadavg");
    std::string text;
    std::getline(file, text);
    return text.empty() ? QStringLiteral("unknown") : QString::fromStdString(text);
}

/// Runs this number of controllers for the measuring time. Prints the results of each controller and of a
/// bare timer.
std::optional<QJsonArray> measure(QTextStream& out, int controllers, int clients, int priority, int seconds) {
    std::vector<std::unique_ptr<Cell>> cells;
    for (int i = 1; i <= controllers; ++i) {
        cells.push_back(std::make_unique<Cell>(i, priority, clients));
        if (!cells.back()->error.isEmpty()) {
            QTextStream(stderr) << cells.back()->error << '\n';
            return std::nullopt;
        }
    }
    std::this_thread::sleep_for(1s);
    for (const auto& cell : cells) {
        cell->robot->resetTiming();
    }
    BareTimer bare(priority);
    std::this_thread::sleep_for(std::chrono::seconds(seconds));
    QJsonArray all;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const simulator::TickTiming timing = cells[i]->robot->timing();
        const bool playing = cells[i]->robot->truth().runtimeState == RuntimeState::Playing;
        const QByteArray name = "controller " + QByteArray::number(static_cast<int>(i) + 1);
        all.append(report(out, name.constData(), timing, playing));
    }
    bare.stop();
    all.append(report(out, bare.lateness()));
    return all;
}

/// Runs one controller and a bare timer, and evaluates them second by second. The seconds without
/// disturbances of the computer show the cost of the controller.
std::optional<QJsonObject> measureBySeconds(QTextStream& out, int priority, int seconds) {
    Cell cell(1, priority, 3);
    if (!cell.error.isEmpty()) {
        QTextStream(stderr) << cell.error << '\n';
        return std::nullopt;
    }
    std::this_thread::sleep_for(1s);
    constexpr double kLimitUs = 200;
    std::vector<double> controller;
    std::vector<double> timer;
    for (int i = 0; i < seconds; ++i) {
        BareTimer bare(priority);
        cell.robot->resetTiming();
        std::this_thread::sleep_for(1s);
        controller.push_back(us(cell.robot->timing().lateness.percentileNs(99.9)));
        bare.stop();
        timer.push_back(us(bare.lateness().percentileNs(99.9)));
    }
    const auto tell = [&](const char* name, std::vector<double>& p999) {
        std::sort(p999.begin(), p999.end());
        const auto below = std::lower_bound(p999.begin(), p999.end(), kLimitUs) - p999.begin();
        const double middle = p999.empty() ? 0 : p999[p999.size() / 2];
        out << name << ", second by second: lateness us p99.9   best second " << (p999.empty() ? 0 : p999[0])
            << "  middle second " << middle << "  below " << kLimitUs << ": " << below << " of "
            << p999.size() << " seconds\n";
        return QJsonObject{{"middle_second_lateness_us_p99_9", middle},
                           {"seconds_below_200_us", static_cast<qint64>(below)},
                           {"seconds", static_cast<qint64>(p999.size())}};
    };
    return QJsonObject{{"controller", tell("one controller", controller)},
                       {"bare_timer", tell("a timer alone", timer)}};
}

}  // namespace

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions(
        {{"seconds", "How long each part is watched.", "s", "20"},
         {"controllers", "How many run side by side in the second part; 0 leaves it out.", "n", "8"},
         {"clients", "RTDE clients of the one in the first part.", "n", "3"},
         {"priority", "SCHED_FIFO priority asked for; 0: none.", "p", "95"},
         {"json", "One JSON object instead of tables."}});
    parser.process(application);
    const int seconds = parser.value("seconds").toInt();
    const int priority = parser.value("priority").toInt();
    const int clients = parser.value("clients").toInt();
    const int several = parser.value("controllers").toInt();

    QString text;
    QTextStream out(&text);
    out.setRealNumberNotation(QTextStream::FixedNotation);
    out.setRealNumberPrecision(1);
    const QString before = load();
    out << "load before: " << before << "; " << QThread::idealThreadCount() << " processors\n"
        << "one controller, " << clients << " RTDE clients, 1 primary client, a servo script at 500 Hz\n";
    const auto one = measure(out, 1, clients, priority, seconds);
    if (!one) {
        return 1;
    }
    QJsonArray side;
    if (several > 0) {
        out << several
            << " controllers side by side, each with 1 RTDE client, 1 primary client, the script\n";
        const auto found = measure(out, several, 1, priority, seconds);
        if (!found) {
            return 1;
        }
        side = *found;
    }
    const auto bySeconds = measureBySeconds(out, priority, seconds);
    if (!bySeconds) {
        return 1;
    }
    const QString after = load();
    out << "load after: " << after << '\n';
    QTextStream console(stdout);
    if (parser.isSet("json")) {
        console << QJsonDocument(QJsonObject{{"one", (*one)[0]},
                                             {"bare_timer", (*one)[1]},
                                             {"side_by_side", side},
                                             {"second_by_second", *bySeconds},
                                             {"load_before", before},
                                             {"load_after", after}})
                       .toJson(QJsonDocument::Compact)
                << '\n';
    } else {
        console << text;
    }
    return 0;
}
