// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures how backend and plots scale with the number of robots and fields. Each simulated controller is a
// separate process. Each has a receiver, a history and a recorder (MCAP), as in the window, and the page has
// four curves per robot. Counts lost packets and prints the processor time by thread as a table. Does not
// check limits.
//
//   scale [--seconds 5] [--robots 1,8,32] [--fields 20,100] [--json]
//
// robots, fields  one row per pair; the fields are the first outputs of the controller. Their names must
//                 fit into 2048 bytes, which is about 110 fields
// receive         processor time of a receive thread [us per packet]
// history         moving a packet from the ring to the history [us per packet]
// recorder        writing a packet to the file [us per packet]; size of the file [MB per minute and robot]
// frame           drawing a page of 1920 x 900 with 4 curves per robot, 30 s of history, without robots [ms]
// memory          memory of half an hour of history [MB per robot]
// lost            packets that a receiver did not receive [%]
// all             CPU load of this program, and of the controllers [% of a core]

#include <QApplication>
#include <QCommandLineParser>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <QTextStream>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/receive/receiver.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/recorder.h"
#include "robot/rtde/fields.h"
#include "robot/station/history/plot_marks.h"
#include "robot/station/history/signal_store.h"
#include "robot/station/history/state_lane.h"
#include "widgets/common/theme.h"
#include "widgets/plots/plot_pane.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;
using namespace std::chrono_literals;

namespace {

constexpr double kRate = 500;          // packets per second
constexpr double kHalfHour = 30 * 60;  // [s]
constexpr auto kFrame = 16ms;

double seconds(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Returns the processor time of the threads of a process, by thread name [s].
std::map<std::string, double> threadSeconds(const std::string& process) {
    std::map<std::string, double> byName;
    std::error_code problem;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + process + "/task", problem)) {
        std::string name;
        std::getline(std::ifstream(thread.path() / "comm"), name);
        double ns = 0;
        std::ifstream(thread.path() / "schedstat") >> ns;
        byName[name] += ns * 1e-9;
    }
    return byName;
}

double sum(const std::map<std::string, double>& byName) {
    double all = 0;
    for (const auto& [name, time] : byName) {
        all += time;
    }
    return all;
}

/// One robot: a controller in a separate process and Tiller's objects for it.
struct Robot {
    Robot(int number, const std::vector<std::string>& fields, const QString& folder) {
        receive::ReceiverOptions options;
        options.host = QStringLiteral("127.0.9.%1").arg(number);
        options.fields = fields;
        controller.setStandardOutputFile(QProcess::nullDevice());
        controller.start(QCoreApplication::applicationDirPath() + QStringLiteral("/../tiller-cli"),
                         {"simulate", "--headless", "--listen", options.host});
        receiver = std::make_unique<receive::Receiver>(options);
        file.path = QStringLiteral("%1/%2.mcap").arg(folder).arg(number);
        file.fields = fields;
        file.format = recording::mcapFormat();
    }
    ~Robot() {
        recorder.stop();
        receiver->stop();
        controller.kill();
        controller.waitForFinished();
    }

    bool start() {
        if (!controller.waitForStarted() || !receiver->start() ||
            !receiver->waitForData(Deadline::after(60s), receive::OnRefusal::Wait)) {
            return false;
        }
        subscription = receiver->subscribe();
        history = std::make_unique<SeriesBuffer>(static_cast<int>(receiver->layout()->size()),
                                                 HistoryLimits{kHalfHour, std::size_t{8} << 30});
        return static_cast<bool>(recorder.start(file, *receiver));
    }

    /// Moves the packets received since the last frame to the history.
    void drain() {
        std::size_t count = 0;
        for (;; ++count) {
            if (count == room.size()) {
                room.emplace_back(receiver->layout());
            }
            if (!subscription.next(room[count])) {
                break;
            }
        }
        rows.clear();
        for (std::size_t i = 0; i < count; ++i) {
            rows.push_back({static_cast<double>(room[i].hostTimeNs) * 1e-9, room[i].lostBefore > 0});
        }
        history->appendRows(rows,
                            [this](std::size_t column, std::size_t row) { return room[row].values[column]; });
        packets += count;
    }

    QProcess controller;
    std::unique_ptr<receive::Receiver> receiver;
    recording::Recorder recorder;
    recording::RecorderOptions file;
    receive::Subscription subscription;
    std::unique_ptr<SeriesBuffer> history;
    std::vector<receive::Sample> room;
    std::vector<SeriesBuffer::Row> rows;
    std::size_t packets = 0;
};

struct Figures {
    int robots = 0, fields = 0, numbers = 0;
    double receive = 0, history = 0, recorder = 0;  ///< [us per packet]
    double fileMb = 0;                              ///< [MB per minute and robot]
    double memoryMb = 0;                            ///< [MB per robot]
    double lost = 0;                                ///< [%]
    double program = 0, controllers = 0;            ///< [% of a core]
    double frameMs = 0;
};

/// Returns the memory of half an hour of history with this number of values, extrapolated from two minutes
/// [MB].
double memoryOf(int numbers) {
    constexpr std::size_t kRows = 65'536;
    SeriesBuffer history(numbers, HistoryLimits{kHalfHour, std::size_t{8} << 30});
    const auto empty = static_cast<double>(history.memoryBytes());
    std::vector<SeriesBuffer::Row> rows(kRows);
    for (std::size_t i = 0; i < kRows; ++i) {
        rows[i].time = static_cast<double>(i) / kRate;
    }
    history.appendRows(rows, [](std::size_t column, std::size_t row) {
        return static_cast<double>(column) + static_cast<double>(row);
    });
    return (static_cast<double>(history.memoryBytes()) - empty) * kHalfHour * kRate / kRows / 1e6;
}

/// Returns the processor time of one live frame of a page with this number of curves, the median of 101
/// frames [ms].
double frameOf(int curves) {
    SignalStore store;
    const auto columns = static_cast<int>(store.liveColumns().size());
    StateLane lane;
    PlotMarks marks(store);
    PageLayout page;
    const int panes = std::min(16, curves / 4);
    for (int pane = 0; pane < panes; ++pane) {
        QStringList keys;
        for (int i = curves * pane / panes; i < curves * (pane + 1) / panes; ++i) {
            keys << QString::fromStdString(store.liveColumns()[static_cast<std::size_t>(i % columns)]);
        }
        page.panes.append({keys, {}, pane / 4, 1});
    }
    std::int64_t next = 0;
    const auto grow = [&](std::int64_t count) {
        std::vector<SeriesBuffer::Row> rows;
        for (std::int64_t i = 0; i < count; ++i, ++next) {
            rows.push_back({static_cast<double>(next) / kRate, false});
        }
        store.appendLive(rows, [&](std::size_t column, std::size_t row) {
            const double t = rows[row].time;
            return std::sin(t * 3 + static_cast<double>(column)) + 0.1 * std::sin(t * 997);
        });
    };
    grow(20'000);
    PlotView view(store, lane, marks);
    view.setPage(page);
    view.setAttribute(Qt::WA_DontShowOnScreen);
    view.resize(1920, 900);
    view.setVisible(true);
    QCoreApplication::processEvents();
    QImage image(view.size(), QImage::Format_RGB32);
    constexpr int kWarmUp = 5;
    constexpr int kFrames = 101;
    std::vector<double> times;
    for (int i = 0; i < kWarmUp + kFrames; ++i) {
        grow(8);
        const double before = seconds(CLOCK_THREAD_CPUTIME_ID);
        view.showRange(store.live().lastTime() - 30, store.live().lastTime());
        QPainter painter(&image);
        view.render(&painter);
        painter.end();
        if (i >= kWarmUp) {
            times.push_back(seconds(CLOCK_THREAD_CPUTIME_ID) - before);
        }
    }
    // Other load only makes frames slower, so the median depends on it less than the mean.
    std::nth_element(times.begin(), times.begin() + kFrames / 2, times.end());
    return times[kFrames / 2] * 1e3;
}

/// Returns an empty optional if a controller did not start.
std::optional<Figures> measure(int robots, int fields, double duration) {
    std::vector<std::string> names;
    for (const rtde::Field& field : rtde::outputFields()) {
        if (static_cast<int>(names.size()) < fields) {
            names.emplace_back(field.name);
        }
    }
    const QTemporaryDir folder;
    std::vector<std::unique_ptr<Robot>> all;
    for (int i = 1; i <= robots; ++i) {
        all.push_back(std::make_unique<Robot>(i, names, folder.path()));
    }
    for (const auto& robot : all) {
        if (!robot->start()) {
            return {};
        }
    }
    const auto controllerSeconds = [&all] {
        double spent = 0;
        for (const auto& robot : all) {
            spent += sum(threadSeconds(std::to_string(robot->controller.processId())));
        }
        return spent;
    };
    const auto rest = [&](double time, double& spent) {
        const double end = seconds(CLOCK_MONOTONIC) + time;
        while (seconds(CLOCK_MONOTONIC) < end) {
            const double before = seconds(CLOCK_THREAD_CPUTIME_ID);
            for (const auto& robot : all) {
                robot->drain();
            }
            spent += seconds(CLOCK_THREAD_CPUTIME_ID) - before;
            std::this_thread::sleep_for(kFrame);
        }
    };
    double history = 0;
    rest(1, history);  // run until all buffers have their final size
    const double begun = seconds(CLOCK_MONOTONIC);
    const auto threads = threadSeconds("self");
    const double controllers = controllerSeconds();
    std::size_t before = 0;
    std::uint64_t rows = 0;
    for (const auto& robot : all) {
        before += robot->packets;
        rows += robot->recorder.progress().rows;
    }
    history = 0;
    rest(duration, history);
    const double took = seconds(CLOCK_MONOTONIC) - begun;
    auto spent = threadSeconds("self");
    for (const auto& [name, time] : threads) {
        spent[name] -= time;
    }
    Figures figures;
    figures.robots = robots;
    figures.fields = static_cast<int>(names.size());
    figures.numbers = static_cast<int>(all.front()->receiver->layout()->size());
    figures.controllers = 100 * (controllerSeconds() - controllers) / took;
    figures.program = 100 * sum(spent) / took;
    std::size_t packets = 0;
    double bytes = 0;
    std::uint64_t written = 0;
    for (const auto& robot : all) {
        packets += robot->packets;
        const recording::RecorderProgress progress = robot->recorder.progress();
        written += progress.rows;
        bytes += progress.seconds > 0 ? static_cast<double>(progress.bytes) / progress.seconds : 0;
    }
    const auto came = static_cast<double>(packets - before);
    figures.receive = 1e6 * spent["tiller-receive"] / came;
    figures.history = 1e6 * history / came;
    figures.recorder = 1e6 * spent["tiller-publish"] / std::max(1.0, static_cast<double>(written - rows));
    figures.fileMb = bytes * 60 / 1e6 / robots;
    figures.memoryMb = memoryOf(figures.numbers);
    figures.lost = std::max(0.0, 100 * (1 - came / (took * kRate * robots)));
    // Their threads would take the caches and the processor from the frames.
    all.clear();
    figures.frameMs = frameOf(4 * robots);
    return figures;
}

std::vector<int> numbersIn(const QString& text) {
    std::vector<int> numbers;
    for (const QString& word : text.split(',', Qt::SkipEmptyParts)) {
        numbers.push_back(std::clamp(word.toInt(), 1, 250));
    }
    return numbers;
}

}  // namespace

int main(int argc, char* argv[]) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    applyTheme(application, Theme::light());
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"seconds", "How long each pair is watched.", "s", "5"},
                       {"robots", "How many side by side.", "n,n", "1,8,32"},
                       {"fields", "How many output fields each sends.", "n,n", "20,100"},
                       {"json", "One JSON object instead of a table."}});
    parser.process(application);
    const double duration = std::max(1.0, parser.value("seconds").toDouble());
    QTextStream out(stdout);
    QJsonObject rows;
    if (!parser.isSet("json")) {
        out << "robots fields numbers | receive history recorder [us a packet] | file MB/min  memory MB | "
               "frame ms "
               "| lost % | program, controllers [% of a core]\n";
    }
    for (const int fields : numbersIn(parser.value("fields"))) {
        for (const int robots : numbersIn(parser.value("robots"))) {
            const auto f = measure(robots, fields, duration);
            if (!f) {
                QTextStream(stderr)
                    << "scale: one of " << robots
                    << " simulated controllers sent nothing: build tiller-cli first, and ask for "
                       "fewer than 110 fields\n";
                return 1;
            }
            rows.insert(QStringLiteral("%1 x %2").arg(f->robots).arg(f->fields),
                        QJsonObject{{"numbers", f->numbers},
                                    {"receive_us", f->receive},
                                    {"history_us", f->history},
                                    {"recorder_us", f->recorder},
                                    {"file_mb_per_minute", f->fileMb},
                                    {"memory_mb", f->memoryMb},
                                    {"frame_ms", f->frameMs},
                                    {"lost_percent", f->lost},
                                    {"program_percent", f->program},
                                    {"controllers_percent", f->controllers}});
            if (!parser.isSet("json")) {
                out << QStringLiteral("%1 %2 %3 | %4 %5 %6 | %7 %8 | %9 | %10 | %11 %12\n")
                           .arg(f->robots, 6)
                           .arg(f->fields, 6)
                           .arg(f->numbers, 7)
                           .arg(f->receive, 7, 'f', 1)
                           .arg(f->history, 7, 'f', 1)
                           .arg(f->recorder, 8, 'f', 1)
                           .arg(f->fileMb, 11, 'f', 1)
                           .arg(f->memoryMb, 10, 'f', 1)
                           .arg(f->frameMs, 8, 'f', 2)
                           .arg(f->lost, 6, 'f', 2)
                           .arg(f->program, 8, 'f', 1)
                           .arg(f->controllers, 8, 'f', 1);
                out.flush();
            }
        }
    }
    if (parser.isSet("json")) {
        out << QJsonDocument(rows).toJson();
    }
    return 0;
}
