// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTest>

#include "app/command_line.h"
#include "app/connect_dialog.h"

using namespace tiller;
using namespace tiller::app;

class TestCommandLine : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void startingWithoutArgumentsAsksForTheRobot() {
        const Result<CommandLine> line = parseCommandLine({"tiller"});
        QVERIFY(line.ok());
        QCOMPARE(line->start, CommandLine::Start::Ask);
    }

    void robotTakesAnAddress() {
        const Result<CommandLine> line = parseCommandLine({"tiller", "--robot", "192.168.0.10"});
        QVERIFY(line.ok());
        QCOMPARE(line->start, CommandLine::Start::Robot);
        QCOMPARE(line->robotHost, QString("192.168.0.10"));
    }

    void demoRunsOnTheSimulator() {
        const Result<CommandLine> line = parseCommandLine({"tiller", "--demo", "/tmp/x"});
        QVERIFY(line.ok());
        QCOMPARE(line->start, CommandLine::Start::Simulator);
        QCOMPARE(line->demoDirectory, QString("/tmp/x"));
    }

    void monitorOnlyOptionIsAccepted() {
        QVERIFY(!parseCommandLine({"tiller", "--robot", "x"})->monitorOnly);
        const Result<CommandLine> line = parseCommandLine({"tiller", "--robot", "x", "--monitor-only"});
        QVERIFY(line.ok());
        QVERIFY(line->monitorOnly);
        QVERIFY(line->helpText.contains("--monitor-only"));
    }

    void projectOpensByItsCurrentOrFormerName() {
        QCOMPARE(parseCommandLine({"tiller", "--project", "a.tiller"})->projectFile, QString("a.tiller"));
        QCOMPARE(parseCommandLine({"tiller", "--session", "b.tiller"})->projectFile, QString("b.tiller"));
        QCOMPARE(parseCommandLine({"tiller", "--session", "b.tiller", "--project", "a.tiller"})->projectFile,
                 QString("a.tiller"));
        const QString help = parseCommandLine({"tiller", "--help"})->helpText;
        QVERIFY2(help.contains("--project") && !help.contains("--session"), qPrintable(help));
    }

    void aProjectFileAloneIsOpened() {
        const Result<CommandLine> line = parseCommandLine({"tiller", "/home/me/my cell.tiller"});
        QVERIFY(line.ok());
        QCOMPARE(line->projectFile, QString("/home/me/my cell.tiller"));
        QCOMPARE(line->start, CommandLine::Start::Ask);
    }

    void wrongArgumentsAreNamed_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        QTest::newRow("unknown option") << QStringList{"--robt", "x"} << "robt";
        QTest::newRow("robot without address") << QStringList{"--robot"} << "robot";
        QTest::newRow("no recording") << QStringList{"a.mcap", "b.txt"} << "b.txt";
        QTest::newRow("stray word") << QStringList{"192.168.0.10"} << "192.168.0.10";
        QTest::newRow("two projects") << QStringList{"a.tiller", "b.tiller"} << "b.tiller";
        QTest::newRow("a project twice") << QStringList{"a.tiller", "--project", "b.tiller"} << "a.tiller";
        QTest::newRow("demonstration that only monitors")
            << QStringList{"--demo", "/tmp/x", "--monitor-only"} << "--monitor-only";
        QTest::newRow("both robots") << QStringList{"--robot", "x", "--simulator"} << "cannot be combined";
        QTest::newRow("demonstration on a real robot")
            << QStringList{"--demo", "d", "--robot", "x"} << "simulated";
        QTest::newRow("theme") << QStringList{"--theme", "pink"} << "pink";
    }
    void recordingsAreOpened() {
        const Result<CommandLine> line =
            parseCommandLine({"tiller", "a.tiller", "/x/b.mcap", "c.H5", "d.csv"});
        QVERIFY(line.ok());
        QCOMPARE(line->projectFile, QString("a.tiller"));
        QCOMPARE(line->recordings, (QStringList{"/x/b.mcap", "c.H5", "d.csv"}));
    }
    void wrongArgumentsAreNamed() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        const Result<CommandLine> line = parseCommandLine(QStringList{"tiller"} + arguments);
        QVERIFY(!line.ok());
        QCOMPARE(line.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(line.error().context.contains(named), qPrintable(line.error().context));
    }

    void addressesAreCheckedBeforeConnecting_data() {
        QTest::addColumn<QString>("host");
        QTest::addColumn<bool>("good");
        QTest::newRow("address") << "192.168.0.10" << true;
        QTest::newRow("name") << "ur5e.local" << true;
        QTest::newRow("empty") << "" << false;
        QTest::newRow("three numbers") << "192.168.10" << false;
        QTest::newRow("number too large") << "192.168.0.300" << false;
        QTest::newRow("blank inside") << "my robot" << false;
    }
    void addressesAreCheckedBeforeConnecting() {
        QFETCH(QString, host);
        QFETCH(bool, good);
        QCOMPARE(hostProblem(host).isEmpty(), good);
    }
};

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
