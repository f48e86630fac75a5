// SPDX-License-Identifier: MIT
// A program with an External Control node. When the program is played, the robot requests the script of the
// node from a computer.
#include <QFile>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

QByteArray setOutput(int number) {
    return "set_standard_digital_out(" + QByteArray::number(number) + ", True)\n";
}
QByteArray scriptNode(const QByteArray& text) {
    return "<Script type=\"File\"><cachedContents>" + text + "</cachedContents></Script>";
}

/// A robot in real time with a loaded program whose External Control node is between two statements.
struct Cell {
    Cell() {
        server.listen(QHostAddress::LocalHost);
        const QByteArray node =
            "<Contributed strategyClass=\"com.fzi.externalcontrol.ExternalControlNode\" "
            "strategyURCapName=\"External Control\"><dataModel/></Contributed>";
        write("external_control.urp",
              "<URProgram name=\"p\"><children><InitVariablesNode/><MainProgram><children>" +
                  scriptNode(setOutput(0)) + node + scriptNode(setOutput(3) + "sleep(1)\n") +
                  "</children></MainProgram></children></URProgram>");
        write(
            "default.installation",
            "<Installation><Contributed ownerId=\"another\"><data key=\"port_nr\" value=\"1\"/></Contributed>"
            "<Contributed ownerId=\"com.fzi.externalcontrol\"><data key=\"host_ip\" value=\"192.168.56.1\"/>"
            "<data key=\"port_nr\" value=\"" +
                QByteArray::number(server.serverPort()) + "\"/></Contributed></Installation>");
        loaded = dashboard.ask("load external_control.urp");
    }
    void write(const char* name, const QByteArray& content) const {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(content);
        }
    }
    /// The next connection of the robot; null if the robot does not connect.
    std::unique_ptr<QTcpSocket> connection() {
        server.waitForNewConnection(kWaitTimeoutMs);
        return std::unique_ptr<QTcpSocket>(server.nextPendingConnection());
    }
    QByteArray state() { return dashboard.ask("programState"); }
    quint64 outputs() const { return robot.controller.truth().digitalOutputs; }

    static simulator::SimulatorOptions options(const QString& programs) {
        auto options = VirtualRobot::options();
        options.time = simulator::Time::Real;
        options.programsFolder = programs;
        // This time is longer than the possible delay of this thread before it sends the next piece.
        options.scriptSilence = std::chrono::seconds(2);
        return options;
    }
    QTemporaryDir folder;
    QTcpServer server;
    VirtualRobot robot{options(folder.path())};
    RawDashboard dashboard = robot.dashboard();
    QByteArray loaded;
};

}  // namespace

class TestExternalControl : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void scriptReplacesTheNode() {
        Cell cell;
        QCOMPARE(cell.loaded, QByteArray("Loading program: external_control.urp\n"));
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        const auto provider = cell.connection();
        QVERIFY(provider);
        while (!provider->canReadLine() && provider->waitForReadyRead(kWaitTimeoutMs)) {
        }
        QCOMPARE(provider->readAll(), QByteArray("request_program\n"));
        QCOMPARE(cell.state(), QByteArray("STOPPED external_control.urp\n"));
        // The script is sent in pieces, and the connection stays open, so that only a pause marks its end.
        provider->write("# words before\n# HEADER_BEGIN\ndef own(n):\n  set_standard_digital_out(n, ");
        provider->waitForBytesWritten(kWaitTimeoutMs);
        provider->write(
            "get_standard_digital_out(0))\nend\n# HEADER_END\n# NODE_CONTROL_LOOP_BEGINS\nown(2)\n"
            "while not get_standard_digital_in(1):\n  sync()\nend\n# NODE_CONTROL_LOOP_ENDS");
        provider->waitForBytesWritten(kWaitTimeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(cell.state(), QByteArray("PLAYING external_control.urp\n"), kWaitTimeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(cell.outputs(), quint64(0b101), kWaitTimeoutMs);
        cell.robot.controller.setDigitalInput(1, true);
        QTRY_COMPARE_WITH_TIMEOUT(cell.outputs(), quint64(0b1101), kWaitTimeoutMs);

        // Every start must request the script again.
        cell.dashboard.ask("stop");
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        const auto again = cell.connection();
        QVERIFY(again);
        again->write(setOutput(5));
        again->disconnectFromHost();
        QTRY_COMPARE_WITH_TIMEOUT(cell.outputs(), quint64(0b101101), kWaitTimeoutMs);
    }

    void withoutItsScriptTheProgramWaitsForTheOperator() {
        Cell cell;
        cell.server.close();
        QCOMPARE(cell.dashboard.ask("play"), QByteArray("Starting program\n"));
        QTRY_COMPARE_WITH_TIMEOUT(cell.outputs(), quint64(1), kWaitTimeoutMs);
        QCOMPARE(cell.state(), QByteArray("PLAYING external_control.urp\n"));
        QCOMPARE(cell.dashboard.ask("close popup"), QByteArray("closing popup\n"));
        QTRY_COMPARE_WITH_TIMEOUT(cell.outputs(), quint64(0b1001), kWaitTimeoutMs);
    }

    void aStopEndsTheWaitForTheScript() {
        Cell cell;
        cell.dashboard.ask("play");
        const auto provider = cell.connection();
        QVERIFY(provider);
        cell.dashboard.ask("stop");
        QVERIFY(provider->state() == QAbstractSocket::UnconnectedState ||
                provider->waitForDisconnected(kWaitTimeoutMs));
        QCOMPARE(cell.state(), QByteArray("STOPPED external_control.urp\n"));
        QCOMPARE(cell.outputs(), quint64(0));
    }
};

QTEST_GUILESS_MAIN(TestExternalControl)
#include "tst_external_control.moc"
