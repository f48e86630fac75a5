// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transfer of all settings in one file. The user sees in advance what will be replaced, and the settings take
// effect immediately. A damaged file, or a file with a newer format, changes nothing.

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QTimer>

#include "app/action_table.h"
#include "app/settings_page.h"
#include "app/settings_transfer.h"
#include "resources/resources.h"
#include "tests/support/event_spy.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "widgets/common/density.h"
#include "widgets/common/theme.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/io/io_channel.h"
#include "widgets/plots/plot_dock.h"

using namespace tiller;
using namespace tiller::test;
using app::SettingsPart;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1280, 720)); }

    app::SettingsPage* openSettings() {
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        return window.findChild<app::SettingsPage*>();
    }
    app::ImportDialog* ask(const QString& path) {
        window.transfer().importFrom(path, &window);
        return window.findChild<app::ImportDialog*>();
    }
    QString robotsInTheMenu() {
        QStringList names;
        for (const QAction* action : find<QMenu>("mainMenu").actions()) {
            if (action->objectName().startsWith("robot.remembered.")) {
                names << action->text();
            }
        }
        return names.join('\n');
    }
};

/// Creates a settings file with many settings that differ from the defaults.
QString fileOfACell(const QTemporaryDir& folder) {
    app::Settings settings(folder.filePath("cell.ini"));
    settings.setTheme("dark");
    settings.rememberRobot({"Lab UR5e", "10.0.0.7", 0, false});
    settings.setIoNames({{"DO 0", "gripper, left"}});
    app::Preferences chosen;
    chosen.density = Density::Touch;
    chosen.longestHold = 40;
    chosen.shortcuts["app.help"] = QKeySequence(Qt::CTRL | Qt::Key_H);
    settings.setPreferences(chosen);
    const QString path = folder.filePath("cell.json");
    return app::writeSettingsFile(path, settings.bundle()) ? path : QString();
}

/// Answers the next file dialog, which blocks its caller.
struct FileAnswer {
    explicit FileAnswer(QString path) {
        QObject::connect(&timer, &QTimer::timeout, &timer, [this, path = std::move(path)] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                timer.stop();
                asked = true;
                // Enter the path as if it were typed, because a selection is ignored while the field has the
                // focus.
                dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
                static_cast<QDialog*>(dialog)->accept();
            }
        });
        timer.start(10);
    }
    QTimer timer;
    bool asked = false;
};

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

}  // namespace

class TestSettingsTransfer : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        applyTheme(*qApp, Theme::light());
        applyDensity(*qApp, Density::Mouse);
    }
    void cleanupTestCase() { applyDensity(*qApp, Density::Mouse); }

    void theExportButtonWritesTheFile() {
        Bench bench;
        app::Settings(bench.file).rememberRobot({"Lab UR5e", "10.0.0.7", 0, false});
        app::SettingsPage* page = bench.openSettings();
        QVERIFY(page != nullptr);
        const test::EventSpy said(bench.window.session().journal());
        const QString path = bench.folder.filePath("exported.json");
        FileAnswer answer(path);
        QTest::mouseClick(page->findChild<QPushButton*>("settingsExport"), Qt::LeftButton);
        QVERIFY(answer.asked);
        const Result<app::SettingsBundle> read = app::readSettingsFile(path);
        QVERIFY2(read.ok(), qPrintable(read.error().toString()));
        QCOMPARE(read->values.value("robots/1/host").toString(), QString("10.0.0.7"));
        QVERIFY2(!read->part(SettingsPart::Layout).isEmpty(), "the current layout is not in the file");
        QVERIFY(!said.isEmpty() && said.last().text.contains(path));
    }

    void importListsReplacedSettingsAndAppliesAtOnce() {
        Bench bench;
        app::Settings(bench.file).rememberRobot({"old", "10.0.0.1", 0, false});
        app::Settings(bench.file).rememberRobot({"older", "10.0.0.2", 0, false});
        const QString path = fileOfACell(bench.folder);
        QVERIFY(!path.isEmpty());
        app::SettingsPage* page = bench.openSettings();
        FileAnswer answer(path);
        QTest::mouseClick(page->findChild<QPushButton*>("settingsImport"), Qt::LeftButton);
        QVERIFY(answer.asked);
        auto* dialog = page->findChild<app::ImportDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        const auto* robots = dialog->findChild<QCheckBox*>(
            QStringLiteral("importSettings.part.%1").arg(static_cast<int>(SettingsPart::Robots)));
        QVERIFY(robots != nullptr && robots->isChecked());
        QVERIFY2(robots->text().contains("2 in Tiller") && robots->text().contains("1 in the file"),
                 qPrintable(robots->text()));
        const QStringList found = stillClipped(*dialog);
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
        QVERIFY2(!Theme::current().isDark(), "the settings changed before the button was pressed");

        const test::EventSpy said(bench.window.session().journal());
        QTest::mouseClick(dialog->findChild<QPushButton*>("importSettings.replace"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::SettingsPage*>() == nullptr, 60'000);
        QVERIFY(Theme::current().isDark());
        QCOMPARE(currentDensity(), Density::Touch);
        QCOMPARE(bench.find<IoChannel>("io.DO0").name(), QString("gripper, left"));
        QCOMPARE(bench.window.actions().find("app.help")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_H));
        QVERIFY2(
            bench.robotsInTheMenu().contains("10.0.0.7") && !bench.robotsInTheMenu().contains("10.0.0.1"),
            qPrintable(bench.robotsInTheMenu()));
        const QStringList kept = QDir(bench.folder.path()).entryList({"settings-before-import_*.json"});
        QCOMPARE(kept.size(), 1);
        const bool reported = std::any_of(said.begin(), said.end(), [&kept](const JournalEvent& message) {
            return message.text.contains(kept.first());
        });
        QVERIFY2(reported, "no message names the file of the backup");

        // The settings are the same at the next start, and the backup restores the previous state.
        VirtualClock clock;
        const app::MainWindow next(app::Settings(bench.file), clock);
        QCOMPARE(currentDensity(), Density::Touch);
        QCOMPARE(app::Settings(bench.file).preferences().longestHold, 40);
        app::ImportDialog* back = bench.ask(bench.folder.filePath(kept.first()));
        QVERIFY(back != nullptr);
        QTest::mouseClick(back->findChild<QPushButton*>("importSettings.replace"), Qt::LeftButton);
        QVERIFY(bench.robotsInTheMenu().contains("10.0.0.1"));
    }

    void tutorialProgressIsNotOverwritten() {
        Bench bench;
        app::Settings(bench.file).setTutorialProgress({false, {"jog"}, {"measure"}});
        app::Settings other(bench.folder.filePath("other.ini"));
        other.setTutorialProgress({false, {"powerOn", "teach"}, {"recover"}});
        const QString path = bench.folder.filePath("other.json");
        QVERIFY(app::writeSettingsFile(path, other.bundle()).ok());
        app::ImportDialog* dialog = bench.ask(path);
        QVERIFY(dialog != nullptr);
        QTest::mouseClick(dialog->findChild<QPushButton*>("importSettings.replace"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::ImportDialog*>() == nullptr, 60'000);
        QCOMPARE(app::Settings(bench.file).learned().firstSteps, QStringList({"powerOn", "teach"}));
        QCOMPARE(app::Settings(bench.file).learned().practice, QStringList("recover"));
        // The next saved value must not remove the other values.
        bench.window.actions().find("app.firstSteps")->trigger();
        bench.find<QAbstractButton>("firstSteps.dismiss").click();
        const app::TutorialProgress learned = app::Settings(bench.file).learned();
        QVERIFY(learned.dismissed);
        QCOMPARE(learned.firstSteps, QStringList({"powerOn", "teach"}));
        QCOMPARE(learned.practice, QStringList("recover"));
    }

    void importedGripperAndRecordingSettingsApplyImmediately() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const auto& gripper = bench.find<GripperPanel>("gripper");
        QCOMPARE(gripper.choice().toText(), QString());
        app::Settings other(bench.folder.filePath("other.ini"));
        other.setGripper("simulator", "output|0");
        app::Preferences chosen;
        chosen.recording.pattern = QStringLiteral("cell 7 {number}");
        chosen.recording.every = 10;
        other.setPreferences(chosen);
        const QString path = bench.folder.filePath("other.json");
        QVERIFY(app::writeSettingsFile(path, other.bundle()).ok());
        app::ImportDialog* dialog = bench.ask(path);
        QVERIFY(dialog != nullptr);
        QTest::mouseClick(dialog->findChild<QPushButton*>("importSettings.replace"), Qt::LeftButton);
        QCOMPARE(gripper.choice().toText(), QString("output|0"));
        const auto* plots = bench.window.findChild<PlotDock*>();
        QVERIFY(plots != nullptr);
        QCOMPARE(plots->recordingChoice().pattern, QString("cell 7 {number}"));
        QCOMPARE(plots->recordingChoice().every, 10);
    }

    void settingsMissingInTheFileAreReplacedOnlyWhenTicked() {
        Bench bench;
        app::Settings(bench.file).rememberRobot({"old", "10.0.0.1", 0, false});
        const QString path = bench.folder.filePath("keys.json");
        app::SettingsBundle few;
        few.values["look/theme"] = "dark";
        QVERIFY(app::writeSettingsFile(path, few).ok());
        app::ImportDialog* dialog = bench.ask(path);
        QVERIFY(dialog != nullptr);
        QCOMPARE(dialog->chosen(), QSet<SettingsPart>{SettingsPart::Look});
        auto* robots = dialog->findChild<QCheckBox*>(
            QStringLiteral("importSettings.part.%1").arg(static_cast<int>(SettingsPart::Robots)));
        QVERIFY(robots != nullptr && robots->isEnabled());
        robots->setFocus();
        QTest::keyClick(robots, Qt::Key_Space);
        QTest::mouseClick(dialog->findChild<QPushButton*>("importSettings.replace"), Qt::LeftButton);
        QVERIFY(Theme::current().isDark());
        QVERIFY(app::Settings(bench.file).rememberedRobots().isEmpty());
    }

    void untickedSettingsAreKept() {
        Bench bench;
        app::Settings(bench.file).rememberRobot({"old", "10.0.0.1", 0, false});
        app::ImportDialog* dialog = bench.ask(fileOfACell(bench.folder));
        QVERIFY(dialog != nullptr);
        auto* replace = dialog->findChild<QPushButton*>("importSettings.replace");
        const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
        QVERIFY(boxes.size() > 3);
        for (QCheckBox* box : boxes) {
            if (box->isChecked()) {
                box->setFocus();
                QTest::keyClick(box, Qt::Key_Space);
            }
        }
        QVERIFY2(!replace->isEnabled(), "the button is enabled although there is nothing to replace");
        auto* look = dialog->findChild<QCheckBox*>(
            QStringLiteral("importSettings.part.%1").arg(static_cast<int>(SettingsPart::Look)));
        look->setFocus();
        QTest::keyClick(look, Qt::Key_Space);
        QTest::mouseClick(replace, Qt::LeftButton);
        QVERIFY(Theme::current().isDark());
        QCOMPARE(app::Settings(bench.file).rememberedRobots().first().host, QString("10.0.0.1"));
        QVERIFY(bench.find<IoChannel>("io.DO0").name().isEmpty());
    }

    void cancelChangesNothing() {
        Bench bench;
        app::ImportDialog* dialog = bench.ask(fileOfACell(bench.folder));
        QVERIFY(dialog != nullptr);
        QTest::keyClick(dialog, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::ImportDialog*>() == nullptr, 60'000);
        QVERIFY(!Theme::current().isDark());
        QVERIFY(app::Settings(bench.file).theme().isEmpty());
        QVERIFY(QDir(bench.folder.path()).entryList({"settings-before-import_*"}).isEmpty());
    }

    void unusableFileChangesNothingAndGivesTheReason_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("words");
        QTest::newRow("newer") << QByteArray(R"({"format": "tiller-settings", "version": 99, "values": {}})")
                               << "Update Tiller";
        QTest::newRow("a project") << QByteArray(R"({"format": "tiller-project", "version": 1})")
                                   << "no Tiller settings";
        QTest::newRow("cut off") << QByteArray("{\"format\": \"tiller-settings\", \"vers") << "damaged";
    }
    void unusableFileChangesNothingAndGivesTheReason() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, words);
        Bench bench;
        app::Settings(bench.file).setTheme("light");
        QFile settings(bench.file);
        QVERIFY(settings.open(QIODevice::ReadOnly));
        const QByteArray before = settings.readAll();
        settings.close();
        const QString path = bench.folder.filePath("other.json");
        write(path, bytes);
        app::ImportDialog* dialog = bench.ask(path);
        QVERIFY(dialog != nullptr);
        const QString said = dialog->findChild<QLabel*>("importSettings.note")->text();
        QVERIFY2(said.contains(words), qPrintable(said));
        QVERIFY2(!said.contains("robot", Qt::CaseInsensitive), qPrintable(said));
        QVERIFY(!dialog->findChild<QPushButton*>("importSettings.replace")->isVisible());
        const QStringList found = stillClipped(*dialog);
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
        QTest::keyClick(dialog, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::ImportDialog*>() == nullptr, 60'000);
        QVERIFY(settings.open(QIODevice::ReadOnly));
        QCOMPARE(settings.readAll(), before);
    }
};

QTEST_MAIN(TestSettingsTransfer)
#include "tst_settings_transfer.moc"
