// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sample projects are offered, opened as a copy, run with the simulated robot, and never overwritten.

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "app/connect_dialog.h"
#include "app/sample_projects.h"
#include "resources/resources.h"
#include "tests/support/pictures.h"
#include "tests/support/question_answer.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/project/project_files.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;
using app::SampleDialog;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1600, 900)); }
    SampleDialog* dialog() { return window.findChild<SampleDialog*>(); }
    /// Opens the sample through its command, by mouse.
    bool open(const QString& id) {
        window.actions().find("project.sample")->trigger();
        auto* key = dialog() == nullptr ? nullptr : dialog()->findChild<QPushButton*>("sample." + id);
        if (key == nullptr) {
            return false;
        }
        QTest::mouseClick(key, Qt::LeftButton);
        window.activateWindow();
        // The dialog is deleted in the next iteration of the event loop. The window is then active again.
        return QTest::qWaitFor([this] { return dialog() == nullptr; }) &&
               QTest::qWaitForWindowActive(&window);
    }
    void change() {
        project::Waypoint point = window.document().waypoints().at(0);
        point.name = QStringLiteral("mine");
        window.document().changeWaypoint(0, point, "Rename");
    }
    const ProjectStore& store() { return window.files().store(); }
};

}  // namespace

class TestSamples : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }

    void theDialogOffersThreeSamples() {
        Bench bench;
        bench.window.actions().find("project.sample")->trigger();
        QVERIFY(bench.dialog() != nullptr && bench.dialog()->isVisible());
        QTest::qWait(50);
        keepPicture(*bench.dialog(), "samples");
        const QStringList found = stillClipped(*bench.dialog());
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
        QVERIFY(bench.dialog()->height() <= 720 - 40);
        QCOMPARE(app::sampleProjects().size(), 3);
        for (const app::SampleProject& sample : app::sampleProjects()) {
            auto* key = bench.dialog()->findChild<QPushButton*>("sample." + sample.id);
            QVERIFY2(key != nullptr && key->accessibleName().contains(sample.title), qPrintable(sample.id));
            QVERIFY2(QFile::exists(sample.path), qPrintable(sample.path));
        }
        bench.dialog()->reject();
        QVERIFY(bench.window.document().waypoints().isEmpty());
    }

    void thePaletteFindsTheSamples() {
        Bench bench;
        app::CommandPalette palette(bench.window.actions());
        palette.findChild<QLineEdit*>("paletteWords")->setText("sample");
        QVERIFY(!palette.listed().isEmpty());
        QCOMPARE(palette.listed().first()->objectName(), QString("project.sample"));
    }

    void theFirstRunPageOffersTheSamples() {
        QTemporaryDir folder;
        app::MainWindow window{app::Settings(folder.filePath("settings.ini"))};
        window.show();
        window.askForRobot();
        auto* connect = window.findChild<app::ConnectDialog*>();
        QTest::mouseClick(connect->findChild<QPushButton*>("startSample"), Qt::LeftButton);
        auto* dialog = window.findChild<SampleDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        QTest::mouseClick(dialog->findChild<QPushButton*>("sample.gluing"), Qt::LeftButton);
        QVERIFY(window.waypointCount() > 10);
        QTRY_COMPARE_WITH_TIMEOUT(window.session().state().link, LinkState::Live, 30'000);
        QVERIFY(window.session().state().simulated);
    }

    void everySampleOpensAsAReachableCopy_data() {
        QTest::addColumn<QString>("id");
        for (const app::SampleProject& sample : app::sampleProjects()) {
            QTest::newRow(qPrintable(sample.id)) << sample.id;
        }
    }
    void everySampleOpensAsAReachableCopy() {
        QFETCH(QString, id);
        Bench bench;
        QVERIFY(bench.open(id));
        const ProjectDocument& document = bench.window.document();
        QVERIFY(document.waypoints().size() >= 10 && !document.frames().isEmpty());
        for (int row = 0; row < document.waypoints().size(); ++row) {
            QVERIFY2(document.reach(row).ok(), qPrintable(document.waypoints().at(row).name));
        }
        QVERIFY(bench.store().path().isEmpty() && !bench.store().isModified());
        QVERIFY2(app::Settings(bench.file).recentProjects().isEmpty(),
                 "a copy of a sample was added to the recent projects");
        // An unchanged sample is closed without a question.
        const QuestionAnswer answer("unsavedCopy.stay");
        QVERIFY(bench.window.close());
        QVERIFY(!answer.wasAsked());
    }

    void changesAreSavedInASeparateFile() {
        Bench bench;
        QVERIFY(bench.open("gluing"));
        bench.change();
        QVERIFY(bench.store().isModified());
        const QString mine = bench.folder.filePath("mine.tiller");
        bench.window.files().saveAs(mine);
        QVERIFY(!bench.store().isModified());
        QCOMPARE(project::loadProject(mine)->waypoints.at(0).name, QString("mine"));
        QCOMPARE(app::Settings(bench.file).recentProjects(), QStringList{mine});
        // When the sample is opened again, it is unchanged.
        QVERIFY(bench.open("gluing"));
        QCOMPARE(bench.window.document().waypoints().at(0).name, QString("start"));
        QVERIFY2(!QFile::exists(bench.folder.filePath("gluing.tiller")),
                 "the sample was saved automatically");
    }

    void closingAChangedCopyAsksFirst() {
        Bench bench;
        QVERIFY(bench.open("gluing"));
        bench.change();
        {
            const QuestionAnswer answer("unsavedCopy.stay");
            QVERIFY(!bench.window.close());
            QVERIFY(answer.wasAsked());
            QVERIFY(bench.window.isVisible());
        }
        {
            const QuestionAnswer answer("unsavedCopy.stay");
            QVERIFY(bench.open("pick-and-place"));
            QVERIFY(answer.wasAsked());
            QCOMPARE(bench.store().copyName(), QString("Gluing along a path"));
        }
        {
            const QuestionAnswer answer("unsavedCopy.drop");
            QVERIFY(bench.open("pick-and-place"));
            QVERIFY(answer.wasAsked());
            QCOMPARE(bench.store().copyName(), QString("Pick and place"));
        }
        bench.change();
        const QuestionAnswer answer("unsavedCopy.drop");
        QVERIFY(bench.window.close());
        QVERIFY(answer.wasAsked());
    }

    void goToMovesTheSimulatedArmToTheSampleWaypoints() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.open("pick-and-place"));
        auto& goTo = bench.find<HoldToRunButton>("waypoint.goTo");
        QVector<HoldToRunButton*> keys = bench.window.jogColumn().holdKeys();
        keys << &goTo;
        driveKeys(bench.cell, keys);
        const ProjectDocument& document = bench.window.document();
        for (int row = 1; row < 4; ++row) {
            bench.window.selectWaypoint(row);
            bench.cell.advanceMs(60);
            QVERIFY2(goTo.isEnabled(), qPrintable(document.waypoints().at(row).name));
            const std::optional<Pose> target =
                project::poseInBase(document.waypoints().at(row), document.frames());
            press(goTo);
            const bool there = bench.cell.advanceUntil(
                [&] {
                    return distanceMm(bench.cell.truth().tcpPose, *target) < 0.5 && standsStill(bench.cell);
                },
                30'000);
            release(goTo);
            QVERIFY2(there, qPrintable(document.waypoints().at(row).name));
            bench.cell.advanceMs(200);
        }
    }
};

QTEST_MAIN(TestSamples)
#include "tst_samples.moc"
