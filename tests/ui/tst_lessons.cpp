// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first steps and the practice tasks in the real window, performed by mouse and keys with the simulated
// controller. The checklist and the checks follow the state of the controller, and nothing else in the window
// moves.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <memory>

#include "app/action_table.h"
#include "app/help_page.h"
#include "resources/resources.h"
#include "robot/station/practice/first_steps.h"
#include "robot/station/practice/practice_check.h"
#include "tests/support/go_on_until.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/density.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/practice/checklist_item.h"
#include "widgets/practice/first_steps_card.h"
#include "widgets/practice/practice_card.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"
#include "widgets/status/recovery_page.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Bench : WindowBench {
    explicit Bench(bool own = true, const simulator::SimulatorOptions& options = VirtualCell::options())
        : WindowBench(options) {
        window.practiseOn(own ? &cell.robot : nullptr);
        show(QSize(1600, 900));
    }
    ~Bench() { window.practiseOn(nullptr); }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    /// Takes control and makes all buttons use the clock of the cell.
    bool bringUp() {
        if (!cell.bringUp()) {
            return false;
        }
        drive();
        return true;
    }
    void drive() {
        QVector<HoldToRunButton*> keys = window.jogColumn().holdKeys();
        keys << window.findChild<HoldToRunButton*>("waypoint.goTo");
        driveKeys(cell, keys);
        cell.advanceMs(40);
    }
    /// Advances real time and robot time until the condition is true. The dashboard thread responds in real
    /// time, and the robot runs in virtual time.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell, condition, 16); }
    void click(const char* name) { QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton); }
    /// Clicks the header button for the next step.
    /// word  expected text
    bool nextStep(const QString& word) {
        auto& key = find<QPushButton>("nextStepButton");
        if (!until(
                [&] { return key.isVisible() && key.isEnabled() && key.accessibleName().contains(word); })) {
            return false;
        }
        QTest::mouseClick(&key, Qt::LeftButton);
        return true;
    }
    /// Holds a button of the pad until the condition is true, releases it, and waits until the arm has
    /// stopped.
    bool hold(const char* name, const std::function<bool()>& enough) {
        auto& key = find<HoldToRunButton>(name);
        if (!until([&] { return key.isEnabled(); })) {
            return false;
        }
        press(key);
        const bool reached = cell.advanceUntil(enough, 19'000);
        release(key);
        const bool stands = cell.advanceUntil([this] { return standsStill(cell); }, 2000);
        cell.advanceMs(80);
        return reached && stands;
    }
    bool jog(const char* name, double mm) {
        const Pose from = cell.truth().tcpPose;
        return hold(name, [this, from, mm] { return distanceMm(from, cell.truth().tcpPose) > mm; });
    }
    QAction& command(const char* id) const { return *window.actions().find(QLatin1String(id)); }
    FirstStepsCard& steps() { return *window.findChild<FirstStepsCard*>(); }
    PracticeCard& practice() { return *window.findChild<PracticeCard*>(); }
    bool isTicked(FirstStep step) {
        return find<ChecklistItem>(qPrintable(QStringLiteral("firstSteps.%1").arg(static_cast<int>(step))))
            .isDone();
    }
    const ChecklistItem& check() { return find<ChecklistItem>("practice.check"); }
    void turnTo(PracticeTask task) {
        command("app.practice").trigger();
        for (int i = 0; i < static_cast<int>(kPracticeTasks.size()) &&
                        find<QLabel>("practice.name").text() != practiceTitle(task);
             ++i) {
            click("practice.next");
        }
    }
    app::TutorialProgress learned() const { return app::Settings(file).learned(); }
    const SessionState& state() { return window.session().state(); }
};

/// Positions of all controls of the window except those on the cards.
QMap<const QWidget*, QRect> places(Bench& bench) {
    QTest::qWait(50);
    QMap<const QWidget*, QRect> found;
    for (const QWidget* widget : bench.window.findChildren<QWidget*>()) {
        const bool control = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                             qobject_cast<const QLineEdit*>(widget) != nullptr ||
                             qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
                             qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
                             qobject_cast<const SceneView*>(widget) != nullptr;
        if (control && widget->isVisible() && widget->window() == &bench.window &&
            !bench.steps().isAncestorOf(widget) && !bench.practice().isAncestorOf(widget)) {
            found[widget] = QRect(widget->mapTo(&bench.window, QPoint()), widget->size());
        }
    }
    return found;
}

}  // namespace

class TestLessons : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }
    void cleanupTestCase() { applyDensity(*qApp, Density::Mouse); }

    // ---- first steps

    void everyItemIsTickedByItsAction() {
        simulator::SimulatorOptions off = VirtualCell::options();
        off.poweredOn = false;
        Bench bench(true, off);
        QVERIFY(!bench.steps().isVisible());
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        QVERIFY(bench.steps().isVisible());
        QVERIFY2(!QApplication::activeModalWidget() && bench.window.isActiveWindow(),
                 "the checklist blocks the window");
        for (const FirstStep step : kFirstSteps) {
            QVERIFY(!bench.isTicked(step));
        }
        keepPicture(bench.window, "first-steps");
        QVERIFY2(bench.nextStep("Power on"), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.isTicked(FirstStep::PowerOn); }));
        QVERIFY2(bench.nextStep("Release brakes"), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.isTicked(FirstStep::ReleaseBrakes); }));
        QVERIFY2(bench.nextStep("Take control"), qPrintable(bench.cell.what()));
        QVERIFY(bench.until([&] { return bench.state().canMove(); }));
        QVERIFY(!bench.isTicked(FirstStep::Jog));

        bench.drive();
        QVERIFY(bench.jog("jog.Z+", 30));
        QVERIFY(bench.isTicked(FirstStep::Jog));
        bench.click("waypoint.teach");
        QVERIFY(bench.isTicked(FirstStep::Teach));
        QVERIFY(bench.jog("jog.Z+", 40));
        QVERIFY(!bench.isTicked(FirstStep::GoTo));
        bench.window.selectWaypoint(0);
        QVERIFY(bench.hold("waypoint.goTo", [&] { return bench.isTicked(FirstStep::GoTo); }));
        QVERIFY(!bench.isTicked(FirstStep::Record));
        bench.window.session().recording().start(bench.folder.filePath("first.csv"));
        QVERIFY(bench.until([&] { return bench.isTicked(FirstStep::Record); }));
        bench.window.session().recording().stop();
        QVERIFY(bench.steps().title().contains("6 of 6"));
        keepPicture(bench.window, "first-steps-done");
        // The completed card remains visible until it is dismissed.
        QCOMPARE(bench.learned().firstSteps.size(), 6);
        QVERIFY(!bench.learned().dismissed);
    }

    void dismissedCardStaysDismissed() {
        const auto isShownAfterConnecting = [](Bench& bench) {
            if (!bench.cell.connect()) {
                qFatal("%s", qPrintable(bench.cell.what()));
            }
            bench.cell.advanceMs(60);
            return bench.steps().isVisible();
        };
        QTemporaryDir kept;
        const QString file = kept.filePath("settings.ini");
        {
            Bench bench;
            QVERIFY(isShownAfterConnecting(bench));
            bench.click("firstSteps.dismiss");
            QVERIFY(!bench.steps().isVisible() && bench.learned().dismissed);
            // The card remains hidden when the robot is disconnected.
            bench.window.session().disconnectFromRobot();
            bench.cell.advanceMs(40);
            QVERIFY(!bench.steps().isVisible());
            QVERIFY(QFile::copy(bench.file, file));
        }
        // The card is not shown at the next start of the application.
        VirtualClock clock;
        app::MainWindow window(app::Settings(file), clock);
        VirtualCell cell(clock, window.session());
        window.practiseOn(&cell.robot);
        window.show();
        QVERIFY2(cell.connect(), qPrintable(cell.what()));
        cell.advanceMs(60);
        auto* card = window.findChild<FirstStepsCard*>();
        QVERIFY(!card->isVisible());
        // The card is shown on request.
        window.actions().find("app.firstSteps")->trigger();
        QVERIFY(card->isVisible());
        window.practiseOn(nullptr);
    }

    void cardIsHiddenOnOtherRobots() {
        Bench bench(false);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        QVERIFY(!bench.steps().isVisible());
        QVERIFY2(bench.learned().firstSteps.isEmpty(), "a robot that was already running completed an item");
    }

    void cardDoesNotMoveOtherWidgets_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x720") << QSize(1280, 720);
        QTest::newRow("1280x720 less a title bar") << QSize(1264, 672);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }
    void cardDoesNotMoveOtherWidgets() {
        QFETCH(QSize, size);
        Bench bench;
        bench.window.resize(size);
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        auto& view = *bench.window.findChild<SceneView*>();
        const auto isInside = [&](const QWidget& card) {
            return card.isVisible() && view.rect().contains(card.geometry());
        };
        QVERIFY(isInside(bench.steps()));
        const QMap<const QWidget*, QRect> before = places(bench);
        QVERIFY2(before.size() > 30, qPrintable(QString::number(before.size())));
        bench.click("firstSteps.fold");
        QCoreApplication::processEvents();
        QVERIFY(isInside(bench.steps()) && places(bench) == before);
        bench.click("firstSteps.fold");
        QCoreApplication::processEvents();
        QVERIFY(isInside(bench.steps()) && places(bench) == before);
        bench.command("app.practice").trigger();
        QCoreApplication::processEvents();
        QVERIFY(isInside(bench.practice()) && !bench.steps().isVisible());
        QVERIFY(places(bench) == before);
        bench.click("practice.close");
        QCoreApplication::processEvents();
        QVERIFY(!bench.practice().isVisible() && places(bench) == before);
    }

    void cardsAreNotTruncated_data() {
        QTest::addColumn<bool>("touch");
        QTest::newRow("mouse") << false;
        QTest::newRow("touch") << true;
    }
    void cardsAreNotTruncated() {
        QFETCH(bool, touch);
        Bench bench;
        app::Preferences preferences;
        preferences.density = touch ? Density::Touch : Density::Mouse;
        bench.window.applyPreferences(preferences);
        bench.window.resize(1280, 720);
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        const auto look = [&](const QString& name) {
            QTest::qWait(50);
            keepPicture(bench.window, name + (touch ? "-touch" : "-mouse"));
            const QStringList found = stillClipped(bench.window);
            QVERIFY2(found.isEmpty(), qPrintable(name + ":\n" + found.join('\n')));
        };
        look("lessons-folded");
        bench.command("app.firstSteps").trigger();
        look("lessons-first-steps");
        for (const PracticeTask task : kPracticeTasks) {
            bench.turnTo(task);
            look("lessons-" + practiceName(task));
        }
    }

    void aCardTakesNoFocusAndStopsNoMotion() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.click("firstSteps.close");
        auto& key = bench.find<HoldToRunButton>("jog.Z+");
        press(key);
        QVERIFY(bench.cell.advanceUntil([&] { return tcpSpeed(bench.cell) > 0.01; }, 2000));
        QWidget* focus = QApplication::focusWidget();
        bench.command("app.firstSteps").trigger();
        QVERIFY(bench.steps().isVisible());
        QCOMPARE(QApplication::focusWidget(), focus);
        bench.cell.advanceMs(200);
        QVERIFY2(tcpSpeed(bench.cell) > 0.01, "showing the card ended the hold");
        release(key);
        QVERIFY(bench.cell.advanceUntil([&] { return standsStill(bench.cell); }, 2000));
    }

    // ---- practice

    void helpAndTheChecklistOpenTheTasks() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        bench.click("firstSteps.practice");
        QVERIFY(bench.practice().isVisible() && !bench.steps().isVisible());
        bench.click("practice.close");
        QVERIFY(!bench.practice().isVisible());
        bench.command("app.help").trigger();
        auto* page = bench.window.findChild<app::HelpPage*>();
        QVERIFY(page != nullptr);
        QTest::mouseClick(page->findChild<QPushButton*>("help.practice"), Qt::LeftButton);
        QVERIFY(bench.practice().isVisible() && !page->isVisible());
    }

    void practiceNeverChangesAnotherRobot() {
        Bench bench(false);
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        for (const PracticeTask task : kPracticeTasks) {
            bench.turnTo(task);
            auto& start = bench.find<QPushButton>("practice.start");
            QVERIFY(!start.isEnabled());
            QVERIFY2(bench.check().text().contains("Virtual UR5e"), qPrintable(bench.check().text()));
            QTest::mouseClick(&start, Qt::LeftButton);
            bench.cell.advanceMs(100);
            QCOMPARE(bench.cell.truth().safetyMode, SafetyMode::Normal);
            QVERIFY(bench.window.document().waypoints().isEmpty());
            QVERIFY(std::abs(bench.state().tcpForce.force.z()) < 5);
        }
    }

    void startReportsMissingConditions() {
        simulator::SimulatorOptions off = VirtualCell::options();
        off.poweredOn = false;
        Bench bench(true, off);
        bench.command("app.practice").trigger();
        QVERIFY(!bench.find<QPushButton>("practice.start").isEnabled());
        QVERIFY2(bench.check().text().contains("simulated robot"), qPrintable(bench.check().text()));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(60);
        QVERIFY(!bench.steps().isVisible());  // only one card is visible at a time
        QVERIFY2(bench.check().text().contains("Power on the arm"), qPrintable(bench.check().text()));
    }

    void theProtectiveStopTaskIsCompleted() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.turnTo(PracticeTask::Recover);
        bench.click("practice.start");
        QVERIFY(bench.until([&] { return bench.cell.truth().safetyMode == SafetyMode::ProtectiveStop; }));
        bench.cell.advanceMs(200);
        QVERIFY(!bench.check().isDone() && !bench.find<QPushButton>("practice.done").isEnabled());
        QVERIFY2(bench.check().text().contains("Recover"), qPrintable(bench.check().text()));
        QVERIFY(bench.nextStep("Recover"));
        auto* page = bench.window.findChild<RecoveryPage*>();
        QVERIFY(page != nullptr);
        bench.cell.advanceMs(5500);
        QCOMPARE(bench.cell.truth().safetyMode, SafetyMode::ProtectiveStop);
        for (QCheckBox* box : page->findChildren<QCheckBox*>()) {
            box->setChecked(true);
        }
        auto* key = page->findChild<QPushButton*>("recoveryKey");
        QVERIFY(bench.until([&] { return key->isEnabled(); }));
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(bench.until([&] { return bench.cell.truth().safetyMode == SafetyMode::Normal; }));
        QVERIFY(bench.until([&] { return page->guide().takesControl && key->isEnabled(); }));
        QVERIFY(!bench.check().isDone());
        QTest::mouseClick(key, Qt::LeftButton);
        QVERIFY(bench.until([&] { return bench.check().isDone(); }));
        keepPicture(bench.window, "practice-recovered");
        bench.click("practice.done");
        QCOMPARE(bench.learned().practice, QStringList{"recover"});
        QCOMPARE(bench.find<QLabel>("practice.name").text(), practiceTitle(PracticeTask::TeachFrame));
    }

    void theFrameTaskIsCompleted() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.window.jogColumn().selectors().setSpeedClass(3);
        bench.turnTo(PracticeTask::TeachFrame);
        bench.click("practice.start");
        bench.window.showTab("frames");
        bench.command("frame.action.threePoints").trigger();
        const auto take = [&] {
            QTest::keyClick(&bench.window, Qt::Key_P);
            bench.cell.advanceMs(20);
        };
        take();
        QVERIFY(bench.jog("jog.Y+", 60));
        take();
        QVERIFY(bench.jog("jog.X-", 40));
        take();
        QVERIFY(!bench.check().isDone());
        bench.click("frame.teacher.make");
        QVERIFY2(bench.check().isDone(), qPrintable(bench.check().text()));
        bench.click("practice.done");
        QCOMPARE(bench.learned().practice, QStringList{"teachFrame"});
    }

    void theTouchUpTaskIsCompleted() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.window.jogColumn().selectors().setSpeedClass(1);
        bench.turnTo(PracticeTask::TouchUp);
        bench.click("practice.start");
        QCOMPARE(bench.window.waypointCount(), 1);
        QVERIFY2(!bench.isTicked(FirstStep::Teach), "the waypoint of the task completed the item");
        const project::Waypoint before = bench.window.document().waypoints().at(0);
        QVERIFY(bench.jog("jog.X+", 19.5));
        QVERIFY(!bench.check().isDone());
        bench.window.selectWaypoint(0);
        bench.click("waypoint.touchUp");
        QTest::mouseClick(bench.window.waypoints().findChild<QPushButton*>("notice.accept"), Qt::LeftButton);
        QVERIFY(!(bench.window.document().waypoints().at(0) == before));
        QVERIFY2(bench.check().isDone(), qPrintable(bench.check().text()));
        bench.click("practice.done");
        QCOMPARE(bench.learned().practice, QStringList{"touchUp"});
    }

    void theReachLimitTaskIsCompleted() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.window.jogColumn().selectors().setSpeedClass(3);
        bench.turnTo(PracticeTask::FindLimit);
        bench.click("practice.start");
        bench.cell.advanceMs(40);
        QVERIFY(bench.hold("jog.Y-", [&] { return bench.check().text().contains("Limit reached"); }));
        QVERIFY(!bench.check().isDone());
        QVERIFY(bench.jog("jog.Y+", 60));
        QVERIFY2(bench.check().isDone(), qPrintable(bench.check().text()));
        bench.click("practice.done");
        QCOMPARE(bench.learned().practice, QStringList{"findLimit"});
    }

    void theForceTaskIsCompleted() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.turnTo(PracticeTask::Measure);
        bench.click("practice.start");
        QVERIFY(bench.until([&] { return bench.state().tcpForce.force.z() < -20; }));
        const Pose at = bench.cell.truth().tcpPose;
        bench.window.session().recording().start(bench.folder.filePath("force.csv"));
        QVERIFY(bench.until([&] { return bench.state().recording.active; }));
        QVERIFY(bench.until([&] { return bench.state().recording.seconds > 3.2; }));
        bench.window.session().recording().stop();
        QVERIFY(bench.until([&] { return !bench.state().recording.active; }));
        bench.cell.advanceMs(40);
        QVERIFY2(bench.check().text().contains("Enter the force"), qPrintable(bench.check().text()));
        QVERIFY2(distanceMm(at, bench.cell.truth().tcpPose) < 0.1, "the contact force moved the arm");
        auto& answer = bench.find<QLineEdit>("practice.answer");
        answer.setFocus();
        QTest::keyClicks(&answer, "3");
        QTest::keyClick(&answer, Qt::Key_Return);
        QVERIFY(!bench.check().isDone());
        answer.selectAll();
        QTest::keyClicks(&answer, QString::number(bench.state().tcpForce.force.z(), 'f', 1));
        QTest::keyClick(&answer, Qt::Key_Return);
        QVERIFY2(bench.check().isDone(), qPrintable(bench.check().text()));
        bench.click("practice.done");
        QCOMPARE(bench.learned().practice, QStringList{"measure"});
        // Closing the task removes the external force.
        QVERIFY(bench.until([&] { return std::abs(bench.state().tcpForce.force.z()) < 2; }));
    }

    void closingATaskRestoresItsSetup() {
        Bench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.turnTo(PracticeTask::Measure);
        bench.click("practice.start");
        QVERIFY(bench.until([&] { return bench.state().tcpForce.force.z() < -20; }));
        bench.click("practice.close");
        QVERIFY(bench.until([&] { return std::abs(bench.state().tcpForce.force.z()) < 2; }));
        QVERIFY(bench.learned().practice.isEmpty());
    }
};

QTEST_MAIN(TestLessons)
#include "tst_lessons.moc"
