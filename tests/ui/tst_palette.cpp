// SPDX-License-Identifier: GPL-3.0-or-later
//
// The palette finds the functions of the plots and tabs by their names, and Return runs them.

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QTabBar>
#include <QTest>
#include <QTimer>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "resources/resources.h"
#include "tests/support/window_bench.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/io/io_channel.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1280, 720)); }

    app::CommandPalette* type(const QString& words) {
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window)) {
            return nullptr;
        }
        QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier);
        auto* palette = window.findChild<app::CommandPalette*>();
        if (palette != nullptr) {
            QTest::keyClicks(palette->findChild<QLineEdit*>("paletteWords"), words);
        }
        return palette;
    }
    /// Types the words and runs the first match, which must be this command.
    void run(const QString& words, const QString& id) {
        app::CommandPalette* palette = type(words);
        QVERIFY(palette != nullptr);
        QVERIFY2(!palette->listed().isEmpty(), qPrintable(words));
        QCOMPARE(palette->listed().first()->objectName(), id);
        QTest::keyClick(palette->findChild<QLineEdit*>("paletteWords"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(window.findChild<app::CommandPalette*>() == nullptr, 60'000);
        window.activateWindow();  // the test has no window manager
        QVERIFY(QTest::qWaitForWindowActive(&window));
    }
    QString tab() {
        const auto& tabs = find<QTabBar>("tabs");
        return tabs.tabData(tabs.currentIndex()).toString();
    }
};

}  // namespace

class TestPalette : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }

    void actionsOfKeysAreFound_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("id");
        const auto row = [](const char* words, const char* id) { QTest::newRow(words) << words << id; };
        row("record", "plots.action.record");
        row("stop recording", "plots.action.stopRecording");
        row("pause plots", "plots.action.pause");
        row("export plots", "plots.action.export");
        row("plots 10 min", "plots.action.span.600");
        row("teach here", "waypoint.action.teach");
        row("touch up", "waypoint.action.touchUp");
        row("teach frame TCP", "frame.action.fromTcp");
        row("three points", "frame.action.threePoints");
        row("search inputs", "io.action.search");
        row("rename input", "io.action.rename");
        row("switch output", "io.action.switch");
        row("pulse", "io.action.pulse");
        row("set tcp", "tcp.action.use");
        row("search log", "log.action.search");
        row("errors only", "log.action.from.2");
        row("copy log", "log.action.copy");
        row("export log", "log.action.export");
        row("export settings", "app.exportSettings");
        row("import settings", "app.importSettings");
    }
    void actionsOfKeysAreFound() {
        QFETCH(QString, words);
        QFETCH(QString, id);
        Bench bench;
        app::CommandPalette* palette = bench.type(words);
        QVERIFY(palette != nullptr);
        QVERIFY2(!palette->listed().isEmpty(), "nothing found");
        QCOMPARE(palette->listed().first()->objectName(), id);
        palette->close();
    }

    void recordingStartsAndEndsFromThePalette() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const QString folder = bench.folder.filePath("recordings");
        bench.find<PlotDock>("plots").setRecordingChoice({.folder = folder});
        const auto records = [&bench] {
            bench.cell.advanceMs(20);
            return bench.window.session().state().recording.active;
        };
        bench.run("record", "plots.action.record");
        QTRY_VERIFY_WITH_TIMEOUT(records(), 60'000);
        QVERIFY2(!bench.window.actions().find("plots.action.record")->isEnabled(),
                 "a second recording can be started");
        bench.run("stop recording", "plots.action.stopRecording");
        QTRY_VERIFY_WITH_TIMEOUT(!records(), 60'000);
        QCOMPARE(QDir(folder).entryList({"*.csv"}, QDir::Files).size(), 1);
    }

    void paletteExplainsWhyRecordingNeedsARobot() {
        Bench bench;
        const QAction* record = bench.window.actions().find("plots.action.record");
        QVERIFY(!record->isEnabled());
        QVERIFY(app::ActionTable::obstacleOf(*record).contains("Connect"));
    }

    void thePlotsPauseAndResumeFromThePalette() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(1500);  // for a second after a motion, Space only stops
        const PlotView& view = bench.find<PlotDock>("plots").view();
        QVERIFY(view.window().follows());
        bench.run("pause plots", "plots.action.pause");
        QVERIFY(!view.window().follows());
        bench.run("resume plots", "plots.action.pause");
        QVERIFY(view.window().follows());
        bench.run("plots last 2 min", "plots.action.span.120");
        QCOMPARE(view.window().span(), 120.0);
    }

    void exportAsksForTheFile_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("id");
        QTest::newRow("plots") << "export plots"
                               << "plots.action.export";
        QTest::newRow("log") << "export log"
                             << "log.action.export";
    }
    void exportAsksForTheFile() {
        QFETCH(QString, words);
        QFETCH(QString, id);
        Bench bench;
        bool asked = false;
        // The dialog blocks the caller until it is answered.
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                asked = true;
                dialog->reject();
            }
        });
        answer.start(10);
        bench.run(words, id);
        QVERIFY(asked);
    }

    void theLogIsSearchedAndFilteredFromThePalette() {
        Bench bench;
        bench.run("search log", "log.action.search");
        QCOMPARE(bench.tab(), QString("log"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.window.focusWidget(), &bench.find<QLineEdit>("log.search"), 60'000);
        bench.run("log: show errors", "log.action.from.2");
        QCOMPARE(bench.find<SegmentedControl>("log.severity").currentIndex(), 2);
    }

    void theSelectedOutputIsSwitchedAndRenamedFromThePalette() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(1500);
        bench.run("search inputs", "io.action.search");
        QCOMPARE(bench.tab(), QString("io"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.window.focusWidget(), &bench.find<QLineEdit>("io.search"), 60'000);
        const auto isOn = [&bench] { return (bench.window.session().state().digitalOutputs & 1U) != 0; };
        // No row is selected yet.
        bench.run("switch selected", "io.action.switch");
        bench.cell.advanceMs(200);
        QVERIFY(!isOn());
        bench.find<IoChannel>("io.DO0").setFocus(Qt::TabFocusReason);
        bench.run("switch selected", "io.action.switch");
        QVERIFY(bench.cell.advanceUntil(isOn, 2000));
        bench.find<IoChannel>("io.DO0").setFocus(Qt::TabFocusReason);
        // Without run(), because the window activation in run() would close the editor. A window manager does
        // not cause this activation.
        QVERIFY(bench.type("rename selected") != nullptr);
        QTest::keyClick(bench.window.findChild<app::CommandPalette*>()->findChild<QLineEdit*>("paletteWords"),
                        Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(bench.find<QLineEdit>("io.DO0.name").isVisible(), 60'000);
    }
};

QTEST_MAIN(TestPalette)
#include "tst_palette.moc"
