// SPDX-License-Identifier: GPL-3.0-or-later
//
// tiller-cli provides the functions of Tiller that do not need a window. It does not link any widgets.

#include <QCoreApplication>

#include "app/cli_command.h"
#include "app/cli_program.h"
#include "tiller_version.h"

using namespace tiller;
using app::out;

namespace {

const QString kHelp = QStringLiteral(
    "tiller-cli: Tiller without a window\n"
    "\n"
    "Usage: tiller-cli COMMAND [options]\n"
    "\n"
    "Commands:\n"
    "  simulate             runs a simulated robot controller (see 'tiller-cli simulate --help')\n"
    "  fault                triggers a fault on a simulated controller (see 'tiller-cli fault --help')\n"
    "  doctor ADDRESS       checks whether this PC can control a robot\n"
    "  record ADDRESS       records the data of a robot (see 'tiller-cli record --help')\n"
    "  project ACTION FILE  inspects, checks or converts a project (see 'tiller-cli project --help')\n"
    "  run FILE             runs a program of a project, simulated or on a robot\n"
    "  test FILE...         tests programs of a project in the simulated controller\n"
    "  script FILE          writes a program of a project as URScript\n"
    "  info FILE            describes the content of a recording\n"
    "  export FILE          exports a recording as CSV or HDF5 (see 'tiller-cli export --help')\n"
    "  serve ADDRESS        forwards live data of a robot to Foxglove or PlotJuggler\n"
    "  episodes FILE...     cuts recordings into demonstrations for imitation learning\n"
    "  divergence FILE      compares the motion of an arm with its model\n"
    "\n"
    "Options:\n"
    "  --help               shows this text\n"
    "  --version            shows the version of Tiller\n");

}  // namespace

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("tiller-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TILLER_VERSION));

    QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 2) {
        return app::wrongArguments(QStringLiteral("a command is missing"));
    }
    const QString command = arguments.takeAt(1);
    if (command == QLatin1String("--help") || command == QLatin1String("-h") ||
        command == QLatin1String("help")) {
        out() << kHelp;
        return app::kSuccess;
    }
    if (command == QLatin1String("--version") || command == QLatin1String("-v")) {
        out() << "tiller-cli " << TILLER_VERSION << Qt::endl;
        return app::kSuccess;
    }
    if (command == QLatin1String("simulate")) {
        return app::simulate(arguments);
    }
    if (command == QLatin1String("fault")) {
        return app::fault(arguments);
    }
    if (command == QLatin1String("doctor")) {
        return app::doctor(arguments);
    }
    if (command == QLatin1String("record")) {
        return app::record(arguments);
    }
    if (command == QLatin1String("run")) {
        return app::run(arguments);
    }
    if (command == QLatin1String("test")) {
        return app::test(arguments);
    }
    if (command == QLatin1String("script")) {
        return app::script(arguments);
    }
    if (command == QLatin1String("info")) {
        return app::info(arguments);
    }
    if (command == QLatin1String("export")) {
        return app::exportRecording(arguments);
    }
    if (command == QLatin1String("serve")) {
        return app::serve(arguments);
    }
    if (command == QLatin1String("episodes")) {
        return app::episodes(arguments);
    }
    if (command == QLatin1String("project")) {
        return app::projectCommand(arguments);
    }
    if (command == QLatin1String("divergence")) {
        return app::divergence(arguments);
    }
    return app::wrongArguments(QStringLiteral("'%1' is not a command").arg(command));
}
