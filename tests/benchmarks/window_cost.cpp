// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the CPU load of the window without user input: processor time of the application and of its GUI
// thread, and the duration of a frame. The cases are: at rest with running plots, while the arm is jogged,
// and minimized. The simulated controller runs in a separate process, so that its cost is excluded. Uses the
// offscreen platform by default, and an X server with QT_QPA_PLATFORM=xcb. Prints a table. Does not check
// limits.
//
//   window_cost [--seconds 5] [--size 1920x1080 ...] [--no-jog] [--paints] [--json]

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QProcess>
#include <QTemporaryDir>
#include <QTextStream>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <vector>

#include <unistd.h>

#include "app/main_window.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/jog_column.h"

using namespace tiller;

namespace {

constexpr auto kRobot = "127.0.7.5";

double cpuSeconds(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Measures the time to handle each update request, which repaints a window.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::Paint && countPaints) {
            const QRect area = static_cast<QPaintEvent*>(event)->rect();
            QElapsedTimer time;
            time.start();
            const bool taken = QApplication::notify(receiver, event);
            Paints& paints = paintsOf[QString::fromLatin1(receiver->metaObject()->className()) +
                                      QLatin1Char(' ') + receiver->objectName()];
            ++paints.count;
            paints.ms += static_cast<double>(time.nsecsElapsed()) / 1e6;
            paints.pixels += static_cast<double>(area.width()) * area.height();
            return taken;
        }
        if (event->type() != QEvent::UpdateRequest) {
            return QApplication::notify(receiver, event);
        }
        QElapsedTimer time;
        time.start();
        const bool taken = QApplication::notify(receiver, event);
        frameMs.push_back(static_cast<double>(time.nsecsElapsed()) / 1e6);
        return taken;
    }

    std::vector<double> frameMs;

    /// Paint events of one widget. Measured only on request, to find the cause of a cost.
    struct Paints {
        int count = 0;
        double ms = 0;
        double pixels = 0;
    };
    bool countPaints = false;
    std::map<QString, Paints> paintsOf;
};

double percentile(std::vector<double> values, double percent) {
    if (values.empty()) {
        return 0;
    }
    std::sort(values.begin(), values.end());
    const double at = percent / 100.0 * static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::lround(at))];
}

template <class Condition>
bool spin(int ms, Condition condition) {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < ms) {
        if (condition()) {
            return true;
        }
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    return condition();
}

void mouse(QWidget& key, QEvent::Type type) {
    const QPointF at = QRectF(key.rect()).center();
    QCoreApplication::postEvent(
        &key,
        new QMouseEvent(type, at, key.mapToGlobal(at), Qt::LeftButton,
                        type == QEvent::MouseButtonPress ? Qt::MouseButtons(Qt::LeftButton) : Qt::NoButton,
                        Qt::NoModifier));
}

struct Figures {
    double programPercent = 0;  ///< all threads [% of one core]
    double guiPercent = 0;      ///< the GUI thread [% of one core]
    double framesPerSecond = 0;
    double p50 = 0, p99 = 0, longest = 0;  ///< duration of one frame [ms]
};

class Meter {
public:
    explicit Meter(TimedApplication& application) : application_(application) {
        application_.frameMs.clear();
        application_.paintsOf.clear();
        time_.start();
    }
    Figures read() const {
        const double seconds = static_cast<double>(time_.nsecsElapsed()) * 1e-9;
        const std::vector<double>& frames = application_.frameMs;
        return {100 * (cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - program_) / seconds,
                100 * (cpuSeconds(CLOCK_THREAD_CPUTIME_ID) - gui_) / seconds,
                static_cast<double>(frames.size()) / seconds,
                percentile(frames, 50),
                percentile(frames, 99),
                percentile(frames, 100)};
    }

private:
    TimedApplication& application_;
    QElapsedTimer time_;
    double program_ = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    double gui_ = cpuSeconds(CLOCK_THREAD_CPUTIME_ID);
};

Figures atRest(TimedApplication& application, int ms) {
    const Meter meter(application);
    spin(ms, [] { return false; });
    return meter.read();
}

/// Jogs back and forth for half a second in each direction, so that the arm remains near its position.
Figures jogging(TimedApplication& application, app::MainWindow& window, int ms) {
    const Meter meter(application);
    for (int way = 0; way * 500 < ms; ++way) {
        auto* key = window.findChild<HoldToRunButton*>(way % 2 == 0 ? "jog.X+" : "jog.X-");
        mouse(*key, QEvent::MouseButtonPress);
        spin(450, [] { return false; });
        mouse(*key, QEvent::MouseButtonRelease);
        spin(50, [] { return false; });
    }
    return meter.read();
}

}  // namespace

int main(int argc, char* argv[]) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    TimedApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"seconds", "How long each state is watched.", "s", "5"},
                       {"size", "Size of the window; may be given again.", "WxH"},
                       {"no-jog", "Only at rest."},
                       {"paints", "Name the widgets that painted, too."},
                       {"json", "One JSON object instead of a table."}});
    parser.process(application);
    QTextStream err(stderr);
    std::vector<QSize> sizes;
    const QStringList wanted = parser.values("size");
    for (const QString& text :
         wanted.isEmpty() ? QStringList{"1280x720", "1920x1080", "3840x2160"} : wanted) {
        const QStringList parts = text.split('x');
        const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
        if (size.isEmpty()) {
            err << "--size: " << text << " is not a size, give for example 1920x1080\n";
            return 2;
        }
        sizes.push_back(size);
    }
    const int ms = std::max(1, static_cast<int>(parser.value("seconds").toDouble() * 1000));

    QProcess robot;
    robot.setStandardOutputFile(QProcess::nullDevice());
    robot.start(QCoreApplication::applicationDirPath() + "/../tiller-cli",
                {"simulate", "--listen", kRobot, "--headless"});
    if (!robot.waitForStarted()) {
        err << "window_cost: " << robot.errorString() << ": build tiller-cli first\n";
        return 1;
    }
    QTemporaryDir folder;
    QJsonArray rows;
    QTextStream out(stdout);
    const bool json = parser.isSet("json");
    if (!json) {
        out << "% of a core                 program     GUI  frames/s   frame p50     p99     max ms\n";
    }
    {
        app::MainWindow window{app::Settings(folder.filePath("settings.ini"))};
        window.resize(sizes.front());
        window.show();
        window.activateWindow();
        window.connectRobot({"Benchmark", QString::fromLatin1(kRobot), 0, true});
        RobotSession& session = window.session();
        bool ready = spin(10'000, [&] { return session.state().link == LinkState::Live; });
        if (ready) {
            session.takeControl();
            ready = spin(10'000, [&] { return session.state().canMove() && window.isActiveWindow(); });
        }
        if (!ready) {
            err << "not in control: " << session.state().linkReason << ' ' << session.state().controlReason
                << '\n';
            robot.kill();
            robot.waitForFinished();
            return 1;
        }
        spin(3000, [] { return false; });
        const auto tell = [&](const QString& state, const Figures& f) {
            if (json) {
                rows.append(QJsonObject{{"state", state},
                                        {"program_percent", f.programPercent},
                                        {"gui_percent", f.guiPercent},
                                        {"frames_per_second", f.framesPerSecond},
                                        {"frame_p50_ms", f.p50},
                                        {"frame_p99_ms", f.p99},
                                        {"frame_max_ms", f.longest}});
                return;
            }
            out << QStringLiteral("%1 %2 %3 %4 %5 %6 %7\n")
                       .arg(state, -26)
                       .arg(f.programPercent, 8, 'f', 1)
                       .arg(f.guiPercent, 7, 'f', 1)
                       .arg(f.framesPerSecond, 9, 'f', 1)
                       .arg(f.p50, 11, 'f', 2)
                       .arg(f.p99, 7, 'f', 2)
                       .arg(f.longest, 7, 'f', 2);
            for (const auto& [name, paints] : application.paintsOf) {
                out << QStringLiteral("    %1 paints %2, %3 ms each, %4 pixels each\n")
                           .arg(name, -44)
                           .arg(paints.count, 5)
                           .arg(paints.ms / paints.count, 0, 'f', 3)
                           .arg(paints.pixels / paints.count, 0, 'f', 0);
            }
            out.flush();
        };
        application.countPaints = !json && parser.isSet("paints");
        for (const QSize& size : sizes) {
            window.resize(size);
            spin(1000, [] { return false; });
            const QString name = QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
            tell(name + " at rest", atRest(application, ms));
            if (!parser.isSet("no-jog")) {
                tell(name + " jogging", jogging(application, window, ms));
            }
        }
        window.showMinimized();
        spin(500, [] { return false; });
        tell("minimised", atRest(application, ms));
        session.shutDown();
    }
    if (json) {
        QJsonObject byState;
        for (const QJsonValue& row : rows) {
            QJsonObject figures = row.toObject();
            const QString state = figures.take("state").toString();
            byState.insert(state, figures);
        }
        out << QJsonDocument(byState).toJson();
    }
    robot.terminate();
    robot.waitForFinished();
    return 0;
}
