// SPDX-License-Identifier: GPL-3.0-or-later
//
// tiller-cli provides the functions of Tiller that need no window. It does not link to the widget libraries.

#include <QCoreApplication>

#include "app/cli_command.h"
#include "tiller_version.h"

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("tiller-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TILLER_VERSION));
    return tiller::app::runCommand(QCoreApplication::arguments());
}
