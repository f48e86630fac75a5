// SPDX-License-Identifier: GPL-3.0-or-later
//
// tiller-cli: what Tiller can do without a window. Links the backend only, which proves that the backend
// stands on its own.

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
    "  simulate             run a simulated robot controller (see 'tiller-cli simulate --help')\n"
    "  fault                make something go wrong there (see 'tiller-cli fault --help')\n"
    "  doctor ADDRESS       say what stands between this PC and a robot that can be moved\n"
    "  record ADDRESS       write what a robot sends to a file (see 'tiller-cli record --help')\n"
    "  run FILE             run a program of a project, simulated or on a robot\n"
    "  script FILE          write a program of a project as URScript\n"
    "  info FILE            say what is in a recording\n"
    "  export FILE          a recording as CSV or HDF5 (see 'tiller-cli export --help')\n"
    "  serve ADDRESS        send on what a robot sends, to Foxglove or PlotJuggler\n"
    "  episodes FILE...     recordings as demonstrations to learn from\n"
    "  divergence FILE      say when the arm of a recording parted from its model\n"
    "\n"
    "Options:\n"
    "  --help               this text\n"
    "  --version            the version of Tiller\n");

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
    if (command == QLatin1String("divergence")) {
        return app::divergence(arguments);
    }
    return app::wrongArguments(QStringLiteral("'%1' is not a command").arg(command));
}
