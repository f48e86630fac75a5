// SPDX-License-Identifier: MIT

#include <QProcess>
#include <QSet>
#include <QTest>
#include <csignal>

#include "tests/support/raw_client.h"

using namespace tiller;
using namespace tiller::test;

namespace {

QString ownAddress() {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.7").arg(100 + pid % 100).arg((pid / 100) % 250);
}

struct Cli {
    explicit Cli(const QStringList& arguments) {
        process.start(QStringLiteral(TILLER_CLI), arguments);
        process.waitForStarted(kWaitTimeoutMs);
    }
    ~Cli() {
        if (process.state() != QProcess::NotRunning) {
            process.kill();
            process.waitForFinished(kWaitTimeoutMs);
        }
    }
    QByteArray readyLine() {
        while (!process.canReadLine() && process.waitForReadyRead(kWaitTimeoutMs)) {
        }
        return process.readLine();
    }
    /// Exit code; -1 if the process did not exit, -2 if it crashed.
    int exitCode() {
        if (process.state() != QProcess::NotRunning && !process.waitForFinished(kWaitTimeoutMs)) {
            return -1;
        }
        return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2;
    }
    QProcess process;
};

}  // namespace

class TestCliSimulate : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void printsReadyAndEndsOnASignal_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
    }
    void printsReadyAndEndsOnASignal() {
        QFETCH(int, signal);
        Cli cli({"simulate", "--listen", ownAddress()});
        const QByteArray ready = cli.readyLine();
        QVERIFY2(ready.startsWith("ready "), cli.process.readAllStandardError());
        QVERIFY(ready.contains(ownAddress().toUtf8()));
        QVERIFY(ready.contains("29999"));
        QVERIFY(ready.contains("30004"));
        RawDashboard dashboard(ownAddress(), 29999);
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: POWER_OFF\n"));
        QVERIFY(RawRtde(ownAddress(), 30004).useVersion());
        // The simulator must listen only on its own address.
        const auto last = ownAddress().section('.', 0, 2) + ".8";
        QVERIFY(!RawClient(last, 30004).isConnected());

        ::kill(static_cast<pid_t>(cli.process.processId()), signal);
        QCOMPARE(cli.exitCode(), 0);
        QVERIFY(dashboard.waitClosed());
    }

    void headlessIsReadyToMove() {
        Cli cli({"simulate", "--listen", ownAddress(), "--headless", "--port-offset", "500", "--model",
                 "ur10e", "--software", "5.20"});
        QVERIFY(cli.readyLine().contains("30504"));
        RawDashboard dashboard(ownAddress(), 30499);
        QCOMPARE(dashboard.ask("robotmode"), QByteArray("Robotmode: RUNNING\n"));
        QCOMPARE(dashboard.ask("is in remote control"), QByteArray("true\n"));
        QCOMPARE(dashboard.ask("get robot model"), QByteArray("UR10\n"));
        QVERIFY(dashboard.ask("PolyscopeVersion").startsWith("URSoftware 5.20."));
    }

    // Behaviour of a robot of this series. The fault "remote off" alone does not refuse any command, as in
    // the vendor's simulator.
    void localControlRefusesTheSameAsARobot_data() {
        QTest::addColumn<bool>("local");
        QTest::newRow("--local") << true;
        QTest::newRow("--fault \"remote off\"") << false;
    }
    void localControlRefusesTheSameAsARobot() {
        QFETCH(bool, local);
        QStringList arguments{"simulate", "--listen", ownAddress()};
        arguments << (local ? QStringList{"--local"} : QStringList{"--headless", "--fault", "remote off"});
        Cli cli(arguments);
        QVERIFY(cli.readyLine().startsWith("ready"));
        const auto isObeyed = [&](const QString& address) {
            RawDashboard dashboard(address, 29999);
            const bool mayPower = dashboard.ask("power on") == "Powering on\n";
            RawPrimary listener(address, 30001);
            QSet<int> refused;
            int reported = 0;
            for (const int port : {30001, 30002, 30003}) {
                RawClient sender(address, static_cast<quint16>(port));
                sender.send("sec p():\n  textmsg(\"ran " + QByteArray::number(port) + "\")\nend\n");
                QByteArray heard;
                const auto isReported = [&] {
                    for (const QByteArray& package : listener.packages()) {
                        heard += package[4] == 20 && (package[14] == 0 || package[14] == 6) ? package
                                                                                            : QByteArray();
                    }
                    return heard.contains("ran " + QByteArray::number(port)) || heard.contains("read-only");
                };
                QElapsedTimer waited;
                waited.start();
                while (!isReported() && waited.elapsed() < kWaitTimeoutMs) {
                }
                reported += heard.contains("ran") || heard.contains("read-only") ? 1 : 0;
                if (!heard.contains("ran")) {
                    refused << port;
                }
            }
            return reported == 3 && mayPower == refused.isEmpty() &&
                           (refused.isEmpty() || refused.size() == 3)
                       ? std::optional(mayPower)
                       : std::nullopt;
        };
        RawDashboard dashboard(ownAddress(), 29999);
        QCOMPARE(dashboard.ask("is in remote control"), QByteArray("false\n"));
        QCOMPARE(isObeyed(ownAddress()), std::optional(!local));
        // The switch on the teach pendant also works, in both directions.
        const auto turn = [&](const char* where) {
            Cli fault({"fault", ownAddress(), "remote", where});
            return fault.exitCode() == 0;
        };
        QVERIFY(turn("on"));
        QCOMPARE(isObeyed(ownAddress()), std::optional(true));
        QVERIFY(turn("off"));
        QCOMPARE(isObeyed(ownAddress()), std::optional(!local));
    }

    void polyScopeXHasARobotApiInsteadOfADashboard() {
        Cli cli({"simulate", "--listen", ownAddress(), "--software", "10.12"});
        const QByteArray ready = cli.readyLine();
        QVERIFY2(ready.contains(" robot-api="), ready);
        QVERIFY(!ready.contains("dashboard"));
        QVERIFY(!RawClient(ownAddress(), 29999).isConnected());
    }

    void faultsAreInjectedFromTheStartAndFromAnotherProcess() {
        Cli cli({"simulate", "--listen", ownAddress(), "--headless", "--fault", "safeguard on", "--fault",
                 "speed 0.5"});
        QVERIFY(cli.readyLine().contains("faults=29990"));
        RawDashboard dashboard(ownAddress(), 29999);
        QTRY_COMPARE_WITH_TIMEOUT(dashboard.ask("safetymode"), QByteArray("Safetymode: SAFEGUARD_STOP\n"),
                                  60'000);
        Cli release({"fault", ownAddress(), "safeguard", "off"});
        QCOMPARE(release.exitCode(), 0);
        QCOMPARE(release.process.readAllStandardOutput(), QByteArray("ok\n"));
        QTRY_COMPARE_WITH_TIMEOUT(dashboard.ask("safetymode"), QByteArray("Safetymode: NORMAL\n"), 60'000);
        Cli wrong({"fault", ownAddress(), "safeguard", "perhaps"});
        QCOMPARE(wrong.exitCode(), 1);
        QVERIFY(wrong.process.readAllStandardError().contains("perhaps"));
        Cli nobody({"fault", ownAddress() + ":1", "status"});
        QCOMPARE(nobody.exitCode(), 1);
        QVERIFY(nobody.process.readAllStandardError().contains("no simulated controller"));
    }

    void aSecondSimulatorOnTheSameAddressGetsASuggestion() {
        Cli first({"simulate", "--listen", ownAddress()});
        QVERIFY(first.readyLine().startsWith("ready"));
        Cli second({"simulate", "--listen", ownAddress()});
        QCOMPARE(second.exitCode(), 1);
        const QByteArray words = second.process.readAllStandardError();
        QVERIFY(words.contains("29999"));
        QVERIFY(words.contains("in use"));
    }

    void wrongArgumentsAreExplained_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("hint");
        const auto row = [](const char* name, const QStringList& arguments, const char* hint) {
            QTest::newRow(name) << arguments << QByteArray(hint);
        };
        row("none", {}, "command");
        row("unknown command", {"fly"}, "fly");
        row("unknown option", {"simulate", "--fly"}, "fly");
        row("too much", {"simulate", "now"}, "now");
        row("address", {"simulate", "--listen", "robot"}, "127.0.0.2");
        row("offset", {"simulate", "--port-offset", "many"}, "number");
        row("offset out of range", {"simulate", "--port-offset", "50000"}, "35000");
        row("model", {"simulate", "--model", "ur99"}, "ur5e");
        row("software", {"simulate", "--software", "new"}, "5.22");
        row("software of another series", {"simulate", "--software", "3.15"}, "UR5e");
        row("software too old", {"simulate", "--model", "ur15", "--software", "5.11"}, "5.22");
        row("software of no series", {"simulate", "--software", "4.1"}, "10.12");
        row("fault", {"simulate", "--listen", ownAddress(), "--fault", "explode"}, "explode");
        row("fault without its words", {"simulate", "--listen", ownAddress(), "--fault", "link"},
            "lost|back");
        row("programs nowhere", {"simulate", "--listen", ownAddress(), "--programs", "/nope"}, "/nope");
        row("programs in a file", {"simulate", "--listen", ownAddress(), "--programs", TILLER_CLI}, "folder");
        row("programs without a name", {"simulate", "--listen", ownAddress(), "--programs", ""},
            "--programs");
        row("fault without words", {"simulate", "--listen", ownAddress(), "--fault", ""}, "help");
        row("assumption", {"simulate", "--assume", "gravity=off"}, "safeguard-reset");
        row("assumption without its value", {"simulate", "--assume", "registers"}, "kept or zeroed");
        row("boot time", {"simulate", "--boot-time", "long"}, "3600");
        row("calibration", {"simulate", "--calibration", "7"}, "5");
        row("headless and local", {"simulate", "--headless", "--local"}, "--local");
        row("fault without address", {"fault"}, "127.0.0.1");
        row("fault command without words", {"fault", "127.0.0.1"}, "protective-stop");
        row("fault at no port", {"fault", "127.0.0.1:x", "fault"}, "127.0.0.1:x");
        row("missing value", {"simulate", "--listen"}, "listen");
    }
    void wrongArgumentsAreExplained() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, hint);
        Cli cli(arguments);
        QCOMPARE(cli.exitCode(), 2);
        QVERIFY(cli.process.readAllStandardOutput().isEmpty());
        const QByteArray words = cli.process.readAllStandardError();
        QVERIFY2(words.contains(hint), words);
    }

    void helpAndVersionExitWithSuccess_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("contains");
        QTest::newRow("help") << QStringList{"--help"} << QByteArray("simulate");
        QTest::newRow("simulate help") << QStringList{"simulate", "--help"} << QByteArray("--port-offset");
        QTest::newRow("assumptions") << QStringList{"simulate", "--assume", "help"}
                                     << QByteArray("registers=kept|zeroed");
        QTest::newRow("fault help") << QStringList{"fault", "--help"} << QByteArray("hold-registers");
        QTest::newRow("help on faults")
            << QStringList{"simulate", "--fault", "help"} << QByteArray("hold-registers");
        QTest::newRow("help among faults")
            << QStringList{"simulate", "--headless", "--fault", "safeguard on", "--fault", " help "}
            << QByteArray("hold-registers");
        QTest::newRow("version") << QStringList{"--version"} << QByteArray("tiller-cli ");
    }
    void helpAndVersionExitWithSuccess() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, contains);
        Cli cli(arguments);
        QCOMPARE(cli.exitCode(), 0);
        const QByteArray words = cli.process.readAllStandardOutput();
        QVERIFY2(words.contains(contains), words);
        QVERIFY2(!words.startsWith("ready "), words);
    }
};

QTEST_GUILESS_MAIN(TestCliSimulate)
#include "tst_cli_simulate.moc"
