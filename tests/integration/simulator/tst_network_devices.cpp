// SPDX-License-Identifier: MIT
//
// Programs that communicate with cameras and grippers over the network. A device replies as specified in its
// table, late, or not at all.

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// A controller in real time with one device "camera".
struct Cell {
    explicit Cell(const QByteArray& table) : robot(options(folder, table)), primary(robot.primary()) {}

    static simulator::SimulatorOptions options(const QTemporaryDir& folder, const QByteArray& table) {
        auto options = VirtualRobot::options();
        options.time = simulator::Time::Real;
        QFile file(folder.filePath("camera.txt"));
        if (!file.open(QIODevice::WriteOnly) || file.write(table) != table.size()) {
            qFatal("cannot write the device table");
        }
        options.devices = {{QStringLiteral("camera"), file.fileName()}};
        return options;
    }
    /// Runs a program until it prints its last text, "end".
    bool play(const QByteArray& body) {
        texts.clear();
        times.clear();
        primary.send("def p():\n" + body + "textmsg(\"end\")\nend\n");
        for (int i = 0; i < 2000 && (texts.isEmpty() || texts.back() != "end"); ++i) {
            QTest::qWait(10);
            for (const QByteArray& package : primary.packages()) {
                if (package[4] == 20 && (package[14] == 0 || package[14] == 10)) {
                    texts << package.mid(package[14] == 0 ? 15 : 23);
                    times << static_cast<double>(qFromBigEndian<quint64>(package.constData() + 5)) * 1e-9;
                }
            }
            if (!texts.isEmpty() && texts.back().startsWith("compile_error")) {
                return false;
            }
        }
        return !texts.isEmpty() && texts.takeLast() == "end";
    }

    QTemporaryDir folder;
    VirtualRobot robot;
    RawPrimary primary;
    QList<QByteArray> texts;  ///< text messages and errors
    QList<double> times;      ///< controller times [s]
};

const QByteArray kCamera =
    "protocol xml-rpc\naddress 192.168.77.20:4242\n"
    "getPose | 1, * | p[0.3,0.2,0.1,0,0,0] | 0.3\n"
    "isReady |      | False\n"
    "isReady |      | True\n"
    "log     | *    |\n"
    "trigger |      | fault no light\n";

}  // namespace

class TestNetworkDevices : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProgramUsesAnXmlRpcDevice() {
        Cell cell(kCamera);
        QVERIFY(cell.robot.started);
        QVERIFY(
            cell.play("cam = rpc_factory(\"xmlrpc\", \"http://192.168.77.20:4242/RPC2\")\n"
                      "textmsg(cam.isReady())\ntextmsg(cam.isReady())\ncam.log(\"hello\", 1)\n"
                      "textmsg(\"ask\")\ntextmsg(cam.getPose(1, 7))\n"));
        QCOMPARE(cell.texts, (QList<QByteArray>{"False", "True", "ask", "p[0.3,0.2,0.1,0,0,0]"}));
        QVERIFY(cell.times[3] - cell.times[2] >= 0.3);
    }

    void anErrorOfTheDeviceAndAnUnknownCallEndTheProgram_data() {
        QTest::addColumn<QByteArray>("call");
        QTest::addColumn<QByteArray>("error");
        QTest::newRow("fault") << QByteArray("trigger()") << QByteArray("no light");
        QTest::newRow("arguments") << QByteArray("getPose(2, 7)") << QByteArray("no answer to getPose(2, 7)");
        QTest::newRow("name") << QByteArray("getImage()") << QByteArray("no answer to getImage()");
    }
    void anErrorOfTheDeviceAndAnUnknownCallEndTheProgram() {
        QFETCH(QByteArray, call);
        QFETCH(QByteArray, error);
        Cell cell(kCamera);
        cell.primary.send(
            "def p():\ncam = rpc_factory(\"xmlrpc\", \"http://192.168.77.20:4242/RPC2\")\nx = cam." + call +
            "\nend\n");
        QByteArray all;
        const auto seen = [&] {
            for (const QByteArray& package : cell.primary.packages()) {
                all += package;
            }
            return all.contains("XML-RPC fault: " + error);
        };
        QTRY_VERIFY_WITH_TIMEOUT(seen(), 20'000);
    }

    void aProgramUsesALineBasedDevice() {
        Cell cell("protocol lines\naddress 127.0.0.1:8500\nTRIGGER | | OK\nGET | POS | (1.5, 2.5)\n");
        QVERIFY(
            cell.play("if socket_open(\"127.0.0.1\", 8500, \"cam\"):\n"
                      "socket_send_string(\"TRIGGER\", \"cam\")\n"  // without a line end
                      "textmsg(socket_read_line(\"cam\"))\n"
                      "socket_send_line(\"GET POS\", \"cam\")\n"
                      "textmsg(socket_read_ascii_float(2, \"cam\"))\n"
                      "socket_close(\"cam\")\nend\n"));
        QCOMPARE(cell.texts, (QList<QByteArray>{"OK", "[2,1.5,2.5]"}));
    }

    void anAbsentDeviceRefusesOrDoesNotReply() {
        Cell cell("protocol lines\naddress 192.168.77.20:8500\nGET | | 1\n");
        const QByteArray ask =
            "textmsg(socket_open(\"192.168.77.20\", 8500, \"cam\"))\nsocket_send_line(\"GET\", \"cam\")\n"
            "textmsg(socket_read_line(\"cam\", 0.3))\nsocket_close(\"cam\")\n";
        QVERIFY(cell.play(ask));
        QCOMPARE(cell.texts, (QList<QByteArray>{"True", "1"}));
        QVERIFY(cell.robot.controller.inject("device camera silent").ok());
        QVERIFY(cell.play(ask));
        QCOMPARE(cell.texts, (QList<QByteArray>{"True", ""}));
        QVERIFY(cell.robot.controller.inject("device camera refuses").ok());
        QVERIFY(cell.play("textmsg(socket_open(\"192.168.77.20\", 8500, \"cam\"))\n"));
        QCOMPARE(cell.texts, (QList<QByteArray>{"False"}));
        QVERIFY(cell.robot.controller.inject("device camera answers").ok());
        QVERIFY(cell.play(ask));
        QCOMPARE(cell.texts, (QList<QByteArray>{"True", "1"}));
        QVERIFY(!cell.robot.controller.inject("device gripper silent").ok());
        QVERIFY(!cell.robot.controller.inject("device camera gone").ok());
    }

    void aBrokenTableIsNamedAtTheStart() {
        QTemporaryDir folder;
        auto options = Cell::options(folder, "protocol xml-rpc\naddress 10.0.0.9:1\na | |\nb | c | 1\n");
        simulator::Simulator broken(options);
        const Result<void> started = broken.start();
        QVERIFY(!started.ok());
        QVERIFY2(started.error().context.contains("camera.txt, line 4"), qPrintable(started.error().context));
        options.devices = {{QStringLiteral("camera"), folder.filePath("missing.txt")}};
        simulator::Simulator missing(options);
        QCOMPARE(missing.start().error().code, ErrorCode::FileNotReadable);
    }
};

QTEST_GUILESS_MAIN(TestNetworkDevices)
#include "tst_network_devices.moc"
