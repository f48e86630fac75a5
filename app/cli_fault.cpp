// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTcpSocket>

#include "app/cli_command.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/simulator.h"

namespace tiller::app {

namespace {

constexpr int kWaitTimeoutMs = 5000;

int fault(const CommandArguments& arguments) {
    const QStringList operands = arguments.operands();
    if (operands.isEmpty()) {
        return wrongArguments(
            QStringLiteral("fault: an address and a fault are required, such as 'tiller-cli fault 127.0.0.1 "
                           "protective-stop'"));
    }
    if (operands.size() < 2) {
        return wrongArguments(QStringLiteral("fault: a fault is required, such as 'protective-stop'"));
    }
    const QStringList address = operands[0].split(':');
    bool ok = address.size() <= 2;
    const quint16 port = address.size() < 2 ? simulator::Ports().faults : address[1].toUShort(&ok);
    if (!ok || port == 0) {
        return wrongArguments(
            QStringLiteral("fault: '%1' must be an address, optionally with a port").arg(operands[0]));
    }
    QTcpSocket socket;
    socket.connectToHost(address[0], port);
    if (!socket.waitForConnected(kWaitTimeoutMs)) {
        return complain(QStringLiteral("no simulated controller responds at %1, port %2 (%3)")
                            .arg(address[0])
                            .arg(port)
                            .arg(socket.errorString()),
                        kFailed);
    }
    socket.write(operands.mid(1).join(' ').replace('\n', ' ').toUtf8() + '\n');
    while (!socket.canReadLine() && socket.waitForReadyRead(kWaitTimeoutMs)) {
    }
    // Only the reply to `help` has several lines.
    QByteArray answer = socket.readAll();
    if (answer.isEmpty()) {
        return complain(QStringLiteral("the simulated controller at %1, port %2, does not respond")
                            .arg(address[0])
                            .arg(port),
                        kFailed);
    }
    if (answer.startsWith("error: ")) {
        return complain(QString::fromUtf8(answer.mid(7)).trimmed(), kFailed);
    }
    out() << QString::fromUtf8(answer.mid(answer.startsWith("ok ") ? 3 : 0));
    out().flush();
    return kSuccess;
}

}  // namespace

const Command& faultCommand() {
    static const Command kCommand{
        .name = "fault",
        .summary = "triggers a fault on a simulated controller (see 'tiller-cli fault --help')",
        .title = "triggers a fault on a simulated controller",
        .usage = {"ADDRESS[:PORT] WORDS..."},
        .notes = QStringLiteral("ADDRESS is the address of 'tiller-cli simulate' or of the simulated robot "
                                "in Tiller. PORT is the port that the 'ready' line of 'tiller-cli simulate' "
                                "lists as 'faults' (default 29990). Any program can trigger faults over a "
                                "TCP connection: the program sends one line with WORDS and receives one line "
                                "with 'ok', or 'error: ' and the reason.\n\nWORDS is one of\n") +
                 simulator::faultHelp().chopped(1),
        .run = fault,
        .optionsEndAtFirstOperand = true};
    return kCommand;
}

}  // namespace tiller::app
