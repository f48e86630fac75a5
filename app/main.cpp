// SPDX-License-Identifier: GPL-3.0-or-later
//
// tiller: the desktop application.

#include <QFile>
#include <QPointer>
#include <QTextStream>
#include <QTimer>
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>

#include "app/application.h"
#include "app/command_line.h"
#include "app/crash_report.h"
#include "app/demonstration.h"
#include "app/interface_size.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/start_project.h"
#include "resources/resources.h"
#include "robot/station/link/recording_choice.h"
#include "robot/station/text/texts.h"
#include "tiller_version.h"

using namespace tiller;

namespace {

constexpr int kUsageError = 2;
constexpr int kNoDisplay = 3;

void print(FILE* to, const QString& text) {
    QTextStream out(to);
    out << text;
    if (!text.endsWith('\n')) {
        out << '\n';
    }
}

/// Returns the requested project. If there is none, returns the last project or a new file.
app::StartProject projectOf(const app::CommandLine& line, const app::Settings& settings) {
    if (!line.demoDirectory.isEmpty()) {
        // Always start the demonstration with a new project.
        const QString file = line.demoDirectory + QStringLiteral("/demo.tiller");
        QFile::remove(file);
        return {file, {}};
    }
    return line.projectFile.isEmpty() ? app::startProject(settings) : app::StartProject{line.projectFile, {}};
}

/// True if there is no display. Qt would abort in this case, even with `--help`.
bool withoutDisplay(const QStringList& arguments) {
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    const char* const names[] = {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"};
    return std::ranges::all_of(names, [](const char* name) { return qEnvironmentVariableIsEmpty(name); }) &&
           !arguments.contains(QStringLiteral("-platform"));
#else
    Q_UNUSED(arguments)
    return false;
#endif
}

/// Returns the interface size. The demonstration uses the same size on every computer.
int sizeFor(const QStringList& arguments) {
    const bool demonstrates = std::ranges::any_of(
        arguments, [](const QString& word) { return word.startsWith(QLatin1String("--demo")); });
    return demonstrates ? app::kInterfaceSizes.front() : app::readInterfaceSize({});
}

/// Shows the hint unless an interface size has been saved before.
void showSizeHint(app::MainWindow& window) {
    if (app::needsLargerSize(*window.screen()) &&
        !app::SettingsView({}).contains(QStringLiteral("look/size"))) {
        window.session().journal().add(
            Severity::Info,
            QCoreApplication::translate("InterfaceSize",
                                        "This screen has a high resolution. Increase “Interface size” in "
                                        "Settings to enlarge text, controls and plots."));
    }
}

void connectAsAsked(app::MainWindow& window, const app::CommandLine& line) {
    switch (line.start) {
        case app::CommandLine::Start::Simulator:
            window.connectSimulator();
            break;
        case app::CommandLine::Start::Robot:
            window.connectToHost(line.robotHost);
            break;
        case app::CommandLine::Start::Ask:
            break;
    }
}

int runDemonstration(app::Application& application, app::MainWindow& window, const QString& folder) {
    app::Demonstration demonstration(window, folder);
    QObject::connect(&demonstration, &app::Demonstration::finished, &application, [&](bool succeeded) {
        print(stdout, demonstration.summary());
        QCoreApplication::exit(succeeded ? 0 : 1);
    });
    QTimer::singleShot(0, &demonstration, &app::Demonstration::start);
    return QApplication::exec();
}

/// Connects to the robot of the previous window. The user must take control again.
void connectAgain(app::MainWindow& window, const SessionState& before) {
    if (before.link == LinkState::Disconnected) {
        return;
    }
    if (before.simulated) {
        window.connectSimulator();
    } else {
        window.connectRobot({before.robotName, before.address, before.portOffset, false});
    }
}

/// Stops the arm when Qt ends the process without destroying the window, e.g. because the connection to the
/// display server is lost. Otherwise, a held motion would continue until its next refresh is overdue.
void stopAtExit(app::MainWindow& window) {
    static QPointer<app::MainWindow> open;
    static const int registered = std::atexit([] {
        if (open) {
            open->session().stop(control::StopCause::WindowClosed);
        }
    });
    Q_UNUSED(registered)
    open = &window;
}

/// connect  called before the window is shown, so that the robot can respond while the first frame is painted
std::unique_ptr<app::MainWindow> openWindow(app::Application& application, const app::CommandLine& line,
                                            const app::Settings& settings,
                                            const std::function<void(app::MainWindow&)>& connect) {
    auto window = std::make_unique<app::MainWindow>(settings);
    application.setKeyRepeat(&window->keyRepeat());
    stopAtExit(*window);
    const QString theme = line.theme.isEmpty() ? settings.theme() : line.theme;
    window->setTheme(theme.isEmpty() ? QStringLiteral("light") : theme);
    window->keepIncidentsIn((line.demoDirectory.isEmpty() ? recordingFolder() : line.demoDirectory) +
                            QStringLiteral("/Incidents"));
    if (line.monitorOnly) {
        window->lockMonitorOnly();
    }
    connect(*window);
    window->show();
    // Activate the window, because an inactive window does not start motions, and there may be no window
    // manager.
    window->activateWindow();
    const app::StartProject project = projectOf(line, settings);
    window->openProject(project.path);
    if (!project.missing.isEmpty()) {
        window->session().journal().add(
            Severity::Warning,
            QCoreApplication::translate("StartProject", "The last project no longer exists: %1")
                .arg(project.missing));
    }
    for (const QString& recording : line.recordings) {
        window->openRecording(recording);
    }
    return window;
}

}  // namespace

int main(int argc, char* argv[]) {
    const QStringList words(argv, argv + argc);
    const bool unseen = withoutDisplay(words);
    if (unseen) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    app::SizedApplication sized(argc, argv, sizeFor(words));
    app::Application& application = sized.application();
    QApplication::setApplicationName(QStringLiteral("Tiller"));
    QApplication::setOrganizationName(QStringLiteral("Tiller"));
    QApplication::setApplicationVersion(QStringLiteral(TILLER_VERSION));
    // The desktop environment finds the icon by this name.
    QApplication::setDesktopFileName(QStringLiteral("org.tiller.Tiller"));

    app::LanguageTexts texts(app::Settings().preferences().language);

    Result<app::CommandLine> line = app::parseCommandLine(QApplication::arguments());
    if (!line) {
        print(stderr,
              QStringLiteral("tiller: %1 (%2)").arg(line.error().context, line.error().controllerMessage));
        return kUsageError;
    }
    if (line->showHelp) {
        print(stdout, line->helpText);
        return 0;
    }
    if (line->showVersion) {
        print(stdout, QStringLiteral("tiller %1").arg(QStringLiteral(TILLER_VERSION)));
        return 0;
    }

    if (unseen && line->demoDirectory.isEmpty()) {
        print(stderr,
              QStringLiteral("tiller: no display is available. Start Tiller in a desktop session, or run the "
                             "demonstration without a display: tiller --simulator --demo DIR"));
        return kNoDisplay;
    }

    initResources();
    const bool demonstration = !line->demoDirectory.isEmpty();
    // The demonstration uses a separate settings file with the default layout, so that the settings of the
    // user do not change.
    app::Settings settings(demonstration ? line->demoDirectory + QStringLiteral("/settings.ini") : QString());
    if (demonstration) {
        settings.setTutorialProgress({.dismissed = true, .firstSteps = {}, .practice = {}});
    }
    // The demonstration connects later, so that it receives all errors.
    auto window = openWindow(application, *line, settings, [&](app::MainWindow& opened) {
        if (!demonstration) {
            connectAsAsked(opened, *line);
        }
    });
    if (demonstration) {
        return runDemonstration(application, *window, line->demoDirectory);
    }
    showSizeHint(*window);
    window->keepUnsavedWorkIn(app::unsavedWorkFolder());
    window->offerCrashReport(app::crashReportPath());
    app::keepCrashReports(app::crashReportPath());
    window->lookForDevices();
    if (line->start == app::CommandLine::Start::Ask) {
        window->askForRobot();
    }
    for (;;) {
        std::optional<SessionState> before;
        QObject::connect(window.get(), &app::MainWindow::closedForNewWindow, &application,
                         [&](const SessionState& state) { before = state; });
        const int code = QApplication::exec();
        if (!before) {
            return code;
        }
        window.reset();
        texts.take(app::Settings().preferences().language);
        // Keep the current project instead of opening the files on the command line again.
        line->projectFile.clear();
        line->recordings.clear();
        window = openWindow(application, *line, settings,
                            [&](app::MainWindow& opened) { connectAgain(opened, *before); });
        window->keepUnsavedWorkIn(app::unsavedWorkFolder());
        window->lookForDevices();
    }
}
