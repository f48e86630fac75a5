// SPDX-License-Identifier: GPL-3.0-or-later
//
// The content of recordings is selected on the settings page or next to the Record button, and applies to the
// next file.

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/action_table.h"
#include "app/recording_settings.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "robot/recording/csv_reader.h"
#include "robot/recording/formats/open_recording.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/window_bench.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/empty_state.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/project/undoable_document.h"
#include "widgets/status/preflight_page.h"
#include "widgets/status/status_line.h"

using namespace tiller;
using namespace tiller::test;

namespace {

void typeInto(QLineEdit& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

void tick(QListWidget& list, const QString& name) {
    const QList<QListWidgetItem*> found = list.findItems(name, Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    list.setCurrentItem(found.first());
    list.scrollToItem(found.first());
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Space);
}

}  // namespace

class TestRecording : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void theNextFileUsesTheSettings() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const QString folder = bench.folder.filePath("measured");

        // Open the page from the menu of the Record button.
        QMenu* menu = bench.find<QToolButton>("plots.recordMenu").menu();
        Q_EMIT menu->aboutToShow();
        menu->findChild<QAction*>("plots.record.signals", Qt::FindDirectChildrenOnly)->trigger();
        auto* page = bench.window.findChild<app::SettingsPage*>();
        QVERIFY(page != nullptr);
        auto* recording = page->findChild<app::RecordingSettings*>();
        QVERIFY2(recording->isVisible(), "the page does not open at the recording settings");
        typeInto(*page->findChild<QLineEdit*>("settings.recording.folder"), folder);
        typeInto(*page->findChild<QLineEdit*>("settings.recording.pattern"), "run {number}");
        QVERIFY(page->findChild<QLabel*>("settings.recording.example")->text().contains("run 001.csv"));
        auto* every = page->findChild<QDoubleSpinBox*>("settings.recording.every");
        every->setFocus();
        every->selectAll();
        QTest::keyClicks(every, "4");
        QTest::keyClick(every, Qt::Key_Return);
        auto* list = page->findChild<QListWidget*>("settings.recording.signals");
        for (const QString& field : recordableFields()) {
            if (field != "actual_q" && field != "actual_TCP_force") {
                tick(*list, field);
            }
        }
        QVERIFY2(page->isVisible(), "a key closed the page");
        QCOMPARE(recording->choice().fields.size(), 2);
        page->close();

        const auto record = [&](int ms) {
            auto& key = bench.find<QToolButton>("plots.record");
            QTest::mouseClick(&key, Qt::LeftButton);
            const auto active = [&] { return bench.window.session().state().recording.active; };
            QVERIFY(bench.cell.advanceUntil(
                [&] {
                    QTest::qWait(1);
                    return active();
                },
                20'000));
            bench.cell.advanceMs(ms);
            QTest::mouseClick(&key, Qt::LeftButton);
            QVERIFY(bench.cell.advanceUntil(
                [&] {
                    QTest::qWait(1);
                    return !active();
                },
                20'000));
        };
        record(400);
        const auto table = recording::readCsv(QDir(folder).filePath("run 001.csv"));
        QVERIFY2(table.ok(), qPrintable(table.error().toString()));
        QCOMPARE(table->columns.size(), std::size_t(1 + 6 + 6 + 1));
        QVERIFY(table->column("actual_q_5") != nullptr && table->column("actual_TCP_force_0") != nullptr);
        const std::vector<double>& times = table->values[0];
        QVERIFY(times.size() > 20);
        for (std::size_t row = 1; row < times.size(); ++row) {
            QVERIFY(std::abs(times[row] - times[row - 1] - 4 * 0.002) < 1e-6);
        }

        // Select different content in the menu. The previous file is not changed.
        Q_EMIT menu->aboutToShow();
        for (QAction* action : menu->actions()) {
            if (action->data().toInt() == 10) {
                action->trigger();
            }
        }
        record(400);
        const auto second = recording::readCsv(QDir(folder).filePath("run 002.csv"));
        QVERIFY2(second.ok(), qPrintable(second.error().toString()));
        QVERIFY(std::abs(second->values[0][1] - second->values[0][0] - 10 * 0.002) < 1e-6);
        QVERIFY(QFile::exists(QDir(folder).filePath("run 001.csv")));

        // The selection is saved.
        const RecordingChoice kept = app::Settings(bench.file).preferences().recording;
        QCOMPARE(kept.every, 10);
        QCOMPARE(kept.pattern, QString("run {number}"));
        QCOMPARE(kept.fields.size(), 2);
        QCOMPARE(QDir(kept.folder), QDir(folder));
    }

    void closingTheWindowAsksAboutARunningRecording() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const QString path = bench.folder.filePath("running.csv");
        bench.window.session().recording().start(path);
        const auto active = [&] {
            bench.cell.advanceMs(20);
            return bench.window.session().state().recording.active;
        };
        QTRY_VERIFY_WITH_TIMEOUT(active(), 20'000);
        bench.cell.advanceMs(200);

        QVERIFY2(!bench.window.close(), "the recording ended without a question");
        auto* question = bench.window.findChild<QMessageBox*>("endQuestion");
        QVERIFY(question != nullptr && question->isVisible());
        QVERIFY2(!question->isModal() && QApplication::activeModalWidget() == nullptr,
                 "STOP cannot be clicked");
        QCOMPARE(question->defaultButton()->objectName(), QString("endQuestion.keep"));
        QVERIFY(active());
        QVERIFY(!bench.window.close());
        QCOMPARE(bench.window.findChildren<QMessageBox*>("endQuestion").size(), 1);
        question = bench.window.findChild<QMessageBox*>("endQuestion");
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QMessageBox*>("endQuestion") == nullptr, 60'000);
        QVERIFY(bench.window.isVisible() && active());

        // Changing the connection also requires a confirmation.
        for (const char* action : {"robot.disconnect", "robot.simulator"}) {
            (void)bench.window.close();  // replaced by the next question
            bench.window.actions().find(QLatin1String(action))->trigger();
            QCOMPARE(bench.window.findChildren<QMessageBox*>("endQuestion").size(), 1);
            question = bench.window.findChild<QMessageBox*>("endQuestion");
            QVERIFY2(question != nullptr && question->windowTitle() == "Change connection", action);
            QTest::keyClick(question, Qt::Key_Escape);
            QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QMessageBox*>("endQuestion") == nullptr, 60'000);
            QVERIFY2(active() && bench.window.session().state().link == LinkState::Live, action);
        }

        // The page with the check closes when its button Connect is clicked, and the question must not close
        // with it.
        bench.window.actions().find("robot.check")->trigger();
        auto* page = bench.window.findChild<PreflightPage*>();
        QVERIFY(page != nullptr && QTest::qWaitForWindowActive(page));
        auto* key = page->findChild<QPushButton*>("preflightConnect");
        key->setEnabled(true);
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<PreflightPage*>() == nullptr, 60'000);
        question = bench.window.findChild<QMessageBox*>("endQuestion");
        QVERIFY(question != nullptr && question->isVisible() && active());
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<QMessageBox*>("endQuestion") == nullptr, 60'000);

        const auto end = [&] {
            QVERIFY(!bench.window.close());
            question = bench.window.findChild<QMessageBox*>("endQuestion");
            QTest::mouseClick(question->findChild<QPushButton*>("endQuestion.take"), Qt::LeftButton);
        };
        // The answer "Cancel" to the question about the project keeps the window and the recording.
        bench.window.document().insertWaypoints(0, {project::Waypoint()}, "Teach");
        QString answer = "unsavedCopy.stay";
        QTimer asked;
        connect(&asked, &QTimer::timeout, &asked, [&] {
            if (QWidget* open = QApplication::activeModalWidget()) {
                asked.stop();
                open->findChild<QPushButton*>(answer)->click();
            }
        });
        asked.start(10);
        end();
        QTRY_VERIFY_WITH_TIMEOUT(!asked.isActive(), 60'000);
        QVERIFY(bench.window.isVisible());
        QVERIFY2(active(), "the recording ended although the window stays open");

        answer = "unsavedCopy.drop";
        asked.start(10);
        end();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.window.isVisible(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(!active(), 20'000);
        const auto table = recording::readCsv(path);
        QVERIFY2(table.ok(), qPrintable(table.error().toString()));
        QVERIFY(table->rows() > 50);
        QVERIFY(!table->truncated);
    }

    void anMcapFileContainsAllDataAndTheProject() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const QString folder = bench.folder.filePath("measured");
        bench.find<PlotDock>("plots").setRecordingChoice({.folder = folder, .pattern = "run"});
        bench.window.actions().find("app.settings")->trigger();
        auto* page = bench.window.findChild<app::SettingsPage*>();
        page->showRecording();
        auto* format = page->findChild<QComboBox*>("settings.recording.format");
        format->setFocus();
        QTest::keyClick(format, Qt::Key_Down);
        QCOMPARE(format->currentData().toString(), QString("mcap"));
        typeInto(*page->findChild<QLineEdit*>("settings.recording.folder"), folder);
        typeInto(*page->findChild<QLineEdit*>("settings.recording.pattern"), "run");
        QVERIFY(page->findChild<QLabel*>("settings.recording.example")->text().contains("run.mcap"));
        page->close();
        auto& key = bench.find<QToolButton>("plots.record");
        const auto active = [&] { return bench.window.session().state().recording.active; };
        const auto until = [&](const std::function<bool()>& condition) {
            return bench.cell.advanceUntil(
                [&] {
                    QTest::qWait(1);
                    return condition();
                },
                60'000);
        };
        QTest::mouseClick(&key, Qt::LeftButton);
        QVERIFY(until(active));
        bench.window.session().journal().add(Severity::Info, QStringLiteral("seen"), Origin::Operator);
        QVERIFY(until([&] { return bench.window.session().state().recording.rows > 200; }));
        // The menu shows size, rate and free space.
        QMenu* menu = bench.find<QToolButton>("plots.recordMenu").menu();
        Q_EMIT menu->aboutToShow();
        const QString progress =
            menu->findChild<QAction*>("plots.record.progress", Qt::FindDirectChildrenOnly)->text();
        QVERIFY2(progress.contains("free") && key.toolTip().contains("B/s"), qPrintable(progress));
        QTest::mouseClick(&key, Qt::LeftButton);
        QVERIFY(until([&] { return !active(); }));
        const auto file = recording::openRecording(QDir(folder).filePath("run.mcap"));
        QVERIFY2(file.ok(), qPrintable(file.error().toString()));
        QVERIFY2((*file)->problems().isEmpty(), qPrintable((*file)->problems().join('\n')));
        QVERIFY((*file)->rows() > 200);
        QVERIFY((*file)->columns().size() > 100);
        QCOMPARE((*file)->facts().at("model"), std::string("UR5e"));
        QCOMPARE((*file)->facts().at("serial_number"),
                 QString(bench.cell.robot.options().serialNumber).toStdString());
        QCOMPARE((*file)->attachments().size(), qsizetype(1));
        const auto inside = (*file)->attachment((*file)->attachments().front());
        QVERIFY(inside.ok() && inside->contains("waypoints"));
        const auto& events = (*file)->events();
        QVERIFY(std::any_of(events.begin(), events.end(),
                            [](const auto& event) { return event.text == "seen"; }));
        QCOMPARE(app::Settings(bench.file).preferences().recording.format, QString("mcap"));
    }

    void fullDiskEndsTheRecordingWithAMessage() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const test::EventSpy messages(bench.window.session().journal());
        const QString path = bench.folder.filePath("full.csv");
        bench.window.session().recording().start(
            {.path = path, .keepFree = std::numeric_limits<std::int64_t>::max()});
        const auto failure = [&] {
            for (const auto& message : messages) {
                if (message.severity == Severity::Error) {
                    return message.text;
                }
            }
            return QString();
        };
        QVERIFY(bench.cell.advanceUntil(
            [&] {
                QTest::qWait(1);
                return !failure().isEmpty();
            },
            120'000));
        QVERIFY2(failure().contains("free"), qPrintable(failure()));
        QVERIFY(recording::readCsv(path).ok());
    }

    void aRecordingThatCannotStartSaysWhyUntilTheNextAttempt() {
        WindowBench bench;
        bench.show(QSize(1280, 720));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const QString file = bench.folder.filePath("file");
        QVERIFY(QFile(file).open(QIODevice::WriteOnly));
        auto& recording = bench.window.session().recording();
        auto& line = bench.find<StatusLine>("statusLine");
        auto& details = bench.find<ElidedLabel>("recordingDetails");
        recording.start(file + "/run.csv");
        QVERIFY(goOnUntil(bench.cell, [&] { return line.messageText().contains("run.csv"); }));
        bench.window.session().journal().add(Severity::Info, QStringLiteral("Something else"));
        bench.cell.advanceMs(2000);
        QVERIFY(!line.messageText().contains("run.csv"));
        QVERIFY2(details.fullText().contains("run.csv"), qPrintable(details.fullText()));
        QCOMPARE(line.recordingText(), QStringLiteral("Not recording"));
        QCOMPARE(details.property("role").toByteArray(), QByteArray("alarm"));
        recording.start(bench.folder.filePath("run.csv"));
        QVERIFY(goOnUntil(bench.cell, [&] { return bench.window.session().state().recording.active; }));
        recording.stop();
        QVERIFY(goOnUntil(bench.cell, [&] { return !bench.window.session().state().recording.active; }));
        QVERIFY2(details.fullText().isEmpty(), qPrintable(details.fullText()));
    }

    void impossibleRequestsAreRefusedWithoutChanges() {
        WindowBench bench;
        bench.show();
        bench.window.actions().find("app.settings")->trigger();
        auto* page = bench.window.findChild<app::SettingsPage*>();
        page->showRecording();
        auto* recording = page->findChild<app::RecordingSettings*>();
        const RecordingChoice before = recording->choice();
        typeInto(*page->findChild<QLineEdit*>("settings.recording.pattern"), "a/b");
        QVERIFY(page->findChild<QLabel*>("settings.recording.example")->text().contains('/'));
        QVERIFY(recording->choice() == before);
        // The last signal cannot be removed.
        auto* list = page->findChild<QListWidget*>("settings.recording.signals");
        const QStringList fields = recordableFields();
        for (const QString& field : fields) {
            tick(*list, field);
        }
        QCOMPARE(recording->choice().fields, QStringList(fields.last()));
        QCOMPARE(list->item(list->count() - 1)->checkState(), Qt::Checked);
        QTest::mouseClick(page->findChild<QPushButton*>("settings.recording.all"), Qt::LeftButton);
        QVERIFY(recording->choice().fields.isEmpty());
    }

    void signalsAreSearched() {
        WindowBench bench;
        bench.show();
        bench.window.actions().find("app.settings")->trigger();
        auto* page = bench.window.findChild<app::SettingsPage*>();
        page->showRecording();
        auto* search = page->findChild<QLineEdit*>("settings.recording.search");
        auto* list = page->findChild<QListWidget*>("settings.recording.signals");
        const auto* nothing = page->findChild<EmptyState*>("settings.recording.signals.nothingFound");
        search->setFocus();
        QTest::keyClicks(search, "tcp force");
        int shown = 0;
        for (int row = 0; row < list->count(); ++row) {
            shown += list->item(row)->isHidden() ? 0 : 1;
        }
        QVERIFY(shown >= 1 && shown < list->count());
        QVERIFY(!nothing->isVisible());
        QTest::keyClicks(search, "qqxyz");
        QVERIFY(nothing->isVisible());
    }
};

QTEST_MAIN(TestRecording)
#include "tst_recording.moc"
