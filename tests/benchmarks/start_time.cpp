// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures start-up times: from the start of the process to the first frame of the window, to the first frame
// with a live value of the simulated controller, and to the first line of tiller-cli. Each start is a
// separate process. Prints the median wall time and processor time of several runs as a table. The process of
// the window performs the steps of app/main.cpp and prints its progress. QT_QPA_PLATFORM=xcb measures on an X
// server. Does not check limits.
//
//   start_time [--runs 7] [--json]

#include <QApplication>
#include <QCommandLineParser>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTranslator>
#include <algorithm>
#include <ctime>
#include <map>
#include <vector>

#include <sys/resource.h>

#include "app/interface_size.h"
#include "app/main_window.h"
#include "app/start_project.h"
#include "resources/resources.h"

using namespace tiller;

namespace {

constexpr auto kPart = "--part-of-start-time";

double seconds(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Prints the name of an event, the wall time since the start of the process, and the processor time so far
/// [ms].
void tell(const char* moment, double begun) {
    QTextStream(stdout) << moment << ' ' << (seconds(CLOCK_MONOTONIC) - begun) * 1e3 << ' '
                        << seconds(CLOCK_PROCESS_CPUTIME_ID) * 1e3 << '\n';
}

/// Waits for the first frame painted after a condition has become true.
class FirstFrame : public QObject {
public:
    FirstFrame(QWidget& window, double begun) : window_(window), begun_(begun) {
        window.installEventFilter(this);
    }
    void setLive() { live_ = true; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::UpdateRequest && watched == &window_) {
            // The frame is on the screen after this event.
            const bool live = live_;
            QMetaObject::invokeMethod(
                this, [this, live] { shown(live); }, Qt::QueuedConnection);
        }
        return false;
    }

private:
    void shown(bool live) {
        if (!std::exchange(first_, true)) {
            tell("first-frame", begun_);
        }
        if (live) {
            tell("live", begun_);
            window_.removeEventFilter(this);
            QCoreApplication::quit();
        }
    }

    QWidget& window_;
    double begun_;
    bool first_ = false;
    bool live_ = false;
};

int runWindow(int argc, char* argv[], double begun) {
    tell("main", begun);
    app::SizedApplication sized(argc, argv, app::readInterfaceSize({}));
    QApplication::setApplicationName(QStringLiteral("TillerStartTime"));
    QTranslator translator;
    if (translator.load(QStringLiteral(":/i18n/tiller_en"))) {
        QApplication::installTranslator(&translator);
    }
    tell("application", begun);
    initResources();
    const QTemporaryDir folder;
    app::Settings settings(folder.filePath(QStringLiteral("settings.ini")));
    app::MainWindow window(settings);
    tell("window-made", begun);
    window.setTheme(QStringLiteral("light"));
    tell("theme-applied", begun);
    FirstFrame frames(window, begun);
    QObject::connect(&window.session(), &RobotSession::stateChanged, &frames, [&](const SessionState& state) {
        if (state.link == LinkState::Live) {
            frames.setLive();
        }
    });
    window.connectSimulator();
    tell("simulator-started", begun);
    window.show();
    tell("window-shown", begun);
    window.openProject(folder.filePath(QStringLiteral("cell.tiller")));
    window.lookForDevices();
    tell("devices-looked-for", begun);
    return QApplication::exec();
}

struct Moment {
    std::vector<double> wall, cpu;  ///< [ms]
};

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double childrenCpuMs() {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    const auto ms = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

bool startWindow(std::map<QString, Moment>& moments) {
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(),
                {QString::fromLatin1(kPart), QString::number(seconds(CLOCK_MONOTONIC), 'f', 6)});
    if (!child.waitForFinished(60'000) || child.exitCode() != 0) {
        child.kill();
        child.waitForFinished();
        return false;
    }
    const QStringList lines =
        QString::fromUtf8(child.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
    for (const QString& line : lines) {
        const QStringList words = line.split(' ');
        if (words.size() == 3) {
            moments[words[0]].wall.push_back(words[1].toDouble());
            moments[words[0]].cpu.push_back(words[2].toDouble());
        }
    }
    return true;
}

/// Measures one start of tiller-cli up to its first line.
bool startCli(const QStringList& arguments, const QString& name, std::map<QString, Moment>& moments) {
    const double cpuBefore = childrenCpuMs();
    QProcess child;
    const double begun = seconds(CLOCK_MONOTONIC);
    child.start(QCoreApplication::applicationDirPath() + QStringLiteral("/../tiller-cli"), arguments);
    const bool spoke = child.waitForReadyRead(60'000);
    moments[name].wall.push_back((seconds(CLOCK_MONOTONIC) - begun) * 1e3);
    child.terminate();
    child.waitForFinished();
    moments[name].cpu.push_back(childrenCpuMs() - cpuBefore);
    return spoke;
}

}  // namespace

int main(int argc, char* argv[]) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (argc == 3 && qstrcmp(argv[1], kPart) == 0) {
        QStandardPaths::setTestModeEnabled(true);
        const double begun = QByteArray(argv[2]).toDouble();
        int one = 1;
        return runWindow(one, argv, begun);
    }
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions(
        {{"runs", "How often each is started.", "n", "7"}, {"json", "One JSON object instead of a table."}});
    parser.process(application);
    const int runs = std::max(1, parser.value("runs").toInt());
    std::map<QString, Moment> moments;
    for (int i = 0; i < runs; ++i) {
        if (!startWindow(moments) || !startCli({"--version"}, "cli-version", moments) ||
            !startCli({"simulate", "--headless", "--listen", "127.0.7.6"}, "cli-ready", moments)) {
            QTextStream(stderr) << "start_time: a program did not start: build tiller-cli too\n";
            return 1;
        }
    }
    QTextStream out(stdout);
    QJsonObject json;
    if (!parser.isSet("json")) {
        out << "since the start [ms]      wall, median   least   most   processor\n";
    }
    for (const QString name :
         {"main", "application", "window-made", "theme-applied", "simulator-started", "window-shown",
          "devices-looked-for", "first-frame", "live", "cli-version", "cli-ready"}) {
        const Moment& moment = moments[name];
        if (moment.wall.empty()) {
            continue;
        }
        const auto [least, most] = std::minmax_element(moment.wall.begin(), moment.wall.end());
        json.insert(name, QJsonObject{{"wall_ms", median(moment.wall)},
                                      {"least_ms", *least},
                                      {"most_ms", *most},
                                      {"cpu_ms", median(moment.cpu)}});
        if (!parser.isSet("json")) {
            out << QStringLiteral("%1 %2 %3 %4 %5\n")
                       .arg(name, -24)
                       .arg(median(moment.wall), 13, 'f', 0)
                       .arg(*least, 7, 'f', 0)
                       .arg(*most, 6, 'f', 0)
                       .arg(median(moment.cpu), 11, 'f', 0);
        }
    }
    if (parser.isSet("json")) {
        out << QJsonDocument(json).toJson();
    }
    return 0;
}
