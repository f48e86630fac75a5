// SPDX-License-Identifier: GPL-3.0-or-later
//
// A problem report contains exactly what the page shows, no names or addresses unless the user selects them,
// and a crash report. The crash is a real crash of this test program, which is started again as a child
// process.

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <csignal>

#include "app/action_table.h"
#include "app/crash_report.h"
#include "app/report_dialog.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "widgets/common/notice_bar.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr char kCrash[] = "--crash";
constexpr char kLastLine[] = "Connected to Lab UR5e at 10.0.0.7";

/// Enables crash reports, stores lines for them, and raises the signal, like a crash of the program.
int crash(const QString& path, int signal) {
    app::keepCrashReports(path);
    app::rememberForCrash(QStringLiteral("the first line\nof two"));
    for (int i = 0; i < 100; ++i) {
        app::rememberForCrash(QStringLiteral("line %1").arg(i));
    }
    app::rememberForCrash(QString(1000, QLatin1Char('x')));
    app::rememberForCrash(QString::fromLatin1(kLastLine));
    std::raise(signal);
    return 0;
}

/// Returns the file written by a process that was terminated by this signal.
QByteArray crashed(const QString& path, int signal) {
    QProcess process;
    process.start(QCoreApplication::applicationFilePath(), {kCrash, path, QString::number(signal)});
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::CrashExit ||
        process.exitCode() != signal) {
        return "the process was not ended by the signal";
    }
    return app::readCrashReport(path);
}

/// Returns the files of a zip archive by name, read by another program.
QMap<QString, QByteArray> unzipped(const QString& path) {
    const QByteArray code =
        "import json, sys, zipfile\n"
        "with zipfile.ZipFile(sys.argv[1]) as z:\n"
        "    assert z.testzip() is None\n"
        "    print(json.dumps({n: z.read(n).decode() for n in z.namelist()}))\n";
    QProcess python;
    python.start("/usr/bin/python3", {"-c", code, path});
    python.waitForFinished(60'000);
    QMap<QString, QByteArray> files;
    const QJsonObject read = QJsonDocument::fromJson(python.readAllStandardOutput()).object();
    for (auto it = read.begin(); it != read.end(); ++it) {
        files[it.key()] = it.value().toString().toUtf8();
    }
    return files;
}

struct Bench : WindowBench {
    Bench() { show(QSize(1280, 720)); }

    app::ReportDialog& openReport() {
        window.actions().find("app.report")->trigger();
        return find<app::ReportDialog>("reportDialog");
    }
};

}  // namespace

class TestReports : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aCrashWritesSignalBacktraceAndLastLogLines_data() {
        QTest::addColumn<int>("signal");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("bad pointer") << SIGSEGV << QByteArray("SIGSEGV");
        QTest::newRow("abort") << SIGABRT << QByteArray("SIGABRT");
        QTest::newRow("division") << SIGFPE << QByteArray("SIGFPE");
    }
    void aCrashWritesSignalBacktraceAndLastLogLines() {
        QFETCH(int, signal);
        QFETCH(QByteArray, name);
        const QTemporaryDir folder;
        const QByteArray report = crashed(folder.filePath("new folder/crash.txt"), signal);
        QVERIFY2(report.contains("was terminated by " + name), report);
        // The call stack includes functions of the handler and of this test program.
        QVERIFY2(report.count("[0x") >= 3 && report.contains("tst_reports"), report);
        QVERIFY2(report.endsWith(QByteArray(kLastLine) + '\n'), report);
        QVERIFY(report.contains("line 99\n"));
        QVERIFY(!report.contains("line 0\n"));  // only the last lines are kept
    }

    void externalSignalLeavesNoFiles() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("crash.txt");
        QVERIFY(crashed(path, SIGTERM).isEmpty());
        QVERIFY(!QFile::exists(path));
    }

    void reportHidesNamesUnlessPermitted() {
        Bench bench;
        app::Settings settings(bench.file);
        settings.rememberRobot({"Paint shop", "10.1.2.3", 0, false});
        settings.setIoNames({{"DO 0", "secret valve"}});
        bench.window.session().journal().add(
            Severity::Warning, "Paint shop at 10.1.2.3 and 10.9.8.7: secret valve, " + QDir::homePath());
        app::ReportDialog& dialog = bench.openReport();
        const auto all = [&dialog] {
            QByteArray text;
            for (const app::ReportPart& part : dialog.parts()) {
                text += part.content;
            }
            return text;
        };
        QByteArray text = all();
        for (const QByteArray name : {"Paint shop", "10.1.2.3", "10.9.8.7", "secret valve"}) {
            QVERIFY2(!text.contains(name), name);
        }
        QVERIFY(!text.contains(QDir::homePath().toUtf8() + '\t') && text.contains("<home>"));
        QVERIFY(text.contains("<name> at <name> and <address>"));
        bench.find<QCheckBox>("report.names").click();
        text = all();
        for (const QByteArray name : {"Paint shop", "10.1.2.3", "10.9.8.7", "secret valve"}) {
            QVERIFY2(text.contains(name), name);
        }
    }

    void savedReportMatchesTheShownOne() {
        Bench bench;
        app::ReportDialog& dialog = bench.openReport();
        auto& words = bench.find<QPlainTextEdit>("report.words");
        QTest::keyClicks(&words, "It stood still");
        auto& list = bench.find<QListWidget>("report.parts");
        QMap<QString, QString> shown;
        for (int row = 0; row < list.count(); ++row) {
            list.setCurrentRow(row);
            shown[list.item(row)->text()] = bench.find<QPlainTextEdit>("report.content").toPlainText();
        }
        QVERIFY(shown.contains("what-happened.txt") && shown.contains("log.txt") &&
                shown.contains("settings.json"));
        QVERIFY2(shown["versions.txt"].contains("Tiller"), qPrintable(shown["versions.txt"]));
        QVERIFY2(clipped(dialog).isEmpty(), qPrintable(clipped(dialog).join('\n')));
        const QString path = bench.folder.filePath("report");
        dialog.saveTo(path);
        const QMap<QString, QByteArray> files = unzipped(path + ".zip");
        QCOMPARE(files.keys(), shown.keys());
        for (auto it = shown.cbegin(); it != shown.cend(); ++it) {
            QCOMPARE(QString::fromUtf8(files[it.key()]), *it);
        }
    }

    void failedSaveIsReportedAndKeepsTheReport() {
        Bench bench;
        app::ReportDialog& dialog = bench.openReport();
        dialog.saveTo(bench.folder.filePath("no such folder/report.zip"));
        QVERIFY(dialog.isVisible());
        QVERIFY(bench.find<QLabel>("report.failure").isVisible());
    }

    void aCrashReportIsOfferedOnceAtTheNextStart() {
        Bench bench;
        const QString path = bench.folder.filePath("crash.txt");
        QVERIFY(crashed(path, SIGSEGV).contains("SIGSEGV"));
        bench.window.offerCrashReport(path);
        auto* notice = bench.window.waypoints().findChild<NoticeBar*>();
        QVERIFY(notice != nullptr && notice->isVisibleTo(&bench.window));
        QVERIFY(notice->title().contains("unexpectedly"));
        QVERIFY(!QFile::exists(path));  // the path must be free for another report
        app::ReportDialog& dialog = bench.openReport();
        const QString zip = bench.folder.filePath("report.zip");
        dialog.saveTo(zip);
        QVERIFY(unzipped(zip)["crash.txt"].contains("SIGSEGV"));
        QVERIFY(!unzipped(zip)["crash.txt"].contains("10.0.0.7"));
        // The crash has been reported, so the next start must not offer it again.
        QCOMPARE(QDir(bench.folder.path()).entryList({"crash*"}).size(), 0);
        notice->dismiss();
        bench.window.offerCrashReport(path);
        QVERIFY(!notice->isVisibleTo(&bench.window));
    }
};

int main(int argc, char* argv[]) {
    if (argc == 4 && qstrcmp(argv[1], kCrash) == 0) {
        return crash(QString::fromLocal8Bit(argv[2]), QByteArray(argv[3]).toInt());
    }
    QApplication application(argc, argv);
    TestReports test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_reports.moc"
