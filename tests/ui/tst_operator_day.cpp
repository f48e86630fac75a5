// SPDX-License-Identifier: GPL-3.0-or-later
//
// Typical operator tasks in the real window: running a program of the project, teaching, editing, and
// restarting Tiller. Uses a simulated robot in virtual time.

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QSessionManager>
#include <QTest>
#include <QTimer>

#include "app/action_table.h"
#include "app/settings_page.h"
#include "program_samples.h"
#include "resources/resources.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/notice_bar.h"
#include "widgets/io/analog_row.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"
#include "widgets/program/program_tab.h"
#include "widgets/project/undoable_document.h"
#include "widgets/status/stop_button.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kStopMs = 250;  ///< maximum stopping time according to the jog contract

project::Project cycleProject() {
    project::Project project = program::sampleProject();
    std::vector<project::ProgramStep> moves;
    for (const char* waypoint : {"pick", "place"}) {
        moves.push_back(program::step("moveL", {{"waypoint", program::waypointId(project, waypoint)}}));
    }
    project.programs.append(
        program::makeProgram("Cycle", {program::step("loop", {{"times", 0}}, std::move(moves))}));
    return project;
}

simulator::SimulatorOptions robotAtPick() {
    simulator::SimulatorOptions options = VirtualCell::options();
    const project::Project project = program::sampleProject();
    options.startJoints = project.waypoints.at(project.waypoints.indexOfName("pick")).joints;
    return options;
}

struct DayBench : WindowBench {
    DayBench() : WindowBench(robotAtPick()) {
        show(QSize(1280, 720));
        window.openProject(folder.filePath("day.tiller"));  // closing the window needs no answer
        window.document().setProject(cycleProject());
    }
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell, condition); }
    bool bringUp() {
        if (!cell.bringUp()) {
            return false;
        }
        driveKeys(cell, window.findChildren<HoldToRunButton*>());
        return true;
    }
    bool runs() {
        return window.findChild<ProgramTab*>()->runsFreely() &&
               until([this] { return tcpSpeed(cell) > 0.03; });
    }
    /// Starts the program without hold-to-run.
    bool run() {
        window.showTab("program");
        auto& key = find<QPushButton>("program.run");
        find<QPushButton>("program.preview").click();
        if (!until([&key] { return key.isEnabled(); })) {
            return false;
        }
        key.click();
        return runs();
    }
    QMessageBox* question(const char* name) { return window.findChild<QMessageBox*>(QLatin1String(name)); }
    void answer(const char* button) { find<QPushButton>(button).click(); }
    QAction* action(const char* id) { return window.actions().find(QLatin1String(id)); }
};

}  // namespace

class TestOperatorDay : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void whatStopsARunningProgramAsksFirst_data() {
        QTest::addColumn<QString>("action");
        for (const char* action : {"app.quit", "robot.disconnect", "robot.simulator", "connect"}) {
            QTest::newRow(action) << QString::fromLatin1(action);
        }
    }
    void whatStopsARunningProgramAsksFirst() {
        QFETCH(QString, action);
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        const auto act = [&] {
            if (action == "connect") {
                bench.window.connectRobot({"other", "127.0.0.1", 31'000, false});
            } else {
                bench.action(qPrintable(action))->trigger();
            }
        };
        act();
        QMessageBox* question = bench.question("endQuestion");
        QVERIFY2(question != nullptr && question->isVisible(), "the program ended without a question");
        QVERIFY2(!question->isModal() && QApplication::activeModalWidget() == nullptr,
                 "STOP cannot be clicked");
        QVERIFY2(question->text().contains("Cycle"), qPrintable(question->text()));
        QCOMPARE(question->defaultButton()->objectName(), QString("endQuestion.keep"));
        bench.cell.advanceMs(1000);
        QVERIFY2(bench.runs(), "the program does not continue while the question is open");
        bench.answer("endQuestion.keep");
        bench.cell.advanceMs(1000);
        QVERIFY(bench.runs());
        QVERIFY(bench.window.isVisible());

        act();
        bench.answer("endQuestion.take");
        QVERIFY(bench.until([&] { return standsStill(bench.cell); }));
        QVERIFY(timeToStandstill(bench.cell) == 0);
        if (action == "app.quit") {
            QTRY_VERIFY_WITH_TIMEOUT(!bench.window.isVisible(), 60'000);
        }
        QVERIFY(bench.question("endQuestion") == nullptr || !bench.question("endQuestion")->isVisible());
    }

    void stopWorksWhileTheQuestionIsOpen_data() {
        QTest::addColumn<QString>("way");
        for (const char* way : {"STOP", "Space", "Esc"}) {
            QTest::newRow(way) << QString::fromLatin1(way);
        }
    }
    void stopWorksWhileTheQuestionIsOpen() {
        QFETCH(QString, way);
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        QVERIFY(!bench.window.close());
        QMessageBox* question = bench.question("endQuestion");
        QVERIFY(question != nullptr);
        QVERIFY(QTest::qWaitForWindowActive(question));
        if (way == "STOP") {
            QTest::mouseClick(bench.window.findChild<StopButton*>(), Qt::LeftButton);
        } else {
            QTest::keyClick(QApplication::focusWidget(), way == "Space" ? Qt::Key_Space : Qt::Key_Escape);
        }
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kStopMs, qPrintable(QString::number(ms)));
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
        QVERIFY2(bench.window.isVisible(), "the key answered the question");
    }

    void oneQuestionNamesTheRecordingAndTheProgram() {
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        bench.window.session().recording().start(bench.folder.filePath("running.csv"));
        QVERIFY(bench.until([&] { return bench.window.session().state().recording.active; }));
        QVERIFY(!bench.window.close());
        QCOMPARE(bench.window.findChildren<QMessageBox*>().size(), 1);
        const QString text = bench.question("endQuestion")->text();
        QVERIFY2(text.contains("recording") && text.contains("Cycle"), qPrintable(text));
        bench.answer("endQuestion.take");
        QTRY_VERIFY_WITH_TIMEOUT(!bench.window.isVisible(), 60'000);
        QVERIFY(bench.until([&] { return !bench.window.session().state().recording.active; }));
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kStopMs, qPrintable(QString::number(ms)));
    }

    void aHeldProgramStopsWithTheWindowWithoutAQuestion() {
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.window.showTab("program");
        auto& key = bench.find<HoldToRunButton>("program.runHold");
        QVERIFY(bench.until([&] { return key.isEnabled(); }));
        press(key);
        QVERIFY(bench.until([&] { return tcpSpeed(bench.cell) > 0.02; }));
        QVERIFY(bench.window.close());
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kStopMs, qPrintable(QString::number(ms)));
        QVERIFY(bench.question("endQuestion") == nullptr);
    }

    void theEndOfTheDesktopSessionDoesNotWaitForAnAnswer() {
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        auto* manager = qApp->findChild<QSessionManager*>();
        QVERIFY(manager != nullptr);
        Q_EMIT qApp->commitDataRequest(*manager);
        QVERIFY(bench.window.close());
        const int ms = timeToStandstill(bench.cell);
        QVERIFY2(ms >= 0 && ms <= kStopMs, qPrintable(QString::number(ms)));
    }

    void outputsAreChangedDuringAProgramOnlyAfterAQuestion_data() {
        QTest::addColumn<QString>("control");
        for (const char* control : {"digital", "analog", "register", "gripper"}) {
            QTest::newRow(control) << QString::fromLatin1(control);
        }
    }
    void outputsAreChangedDuringAProgramOnlyAfterAQuestion() {
        QFETCH(QString, control);
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        bench.window.showTab(control == "gripper" ? "gripper" : "io");
        auto& io = bench.find<IoTab>("io");
        QVERIFY(bench.until([&] { return !io.output(0)->isStale(); }));
        QVERIFY2(bench.runs(), "selecting the tab stopped the program");
        const auto change = [&](const char* gripperKey) {
            if (control == "digital") {
                io.output(3)->click();
            } else if (control == "analog") {
                Q_EMIT bench.find<AnalogRow>("io.AO0").setRequested(io::AnalogDomain::Voltage, 0.5);
            } else if (control == "register") {
                bench.find<QPushButton>("io.register.write").click();
            } else {
                bench.find<QPushButton>(gripperKey).click();
            }
        };
        if (control == "gripper") {
            auto& kind = bench.find<QComboBox>("gripper.kind");
            kind.setCurrentIndex(kind.findText("One output", Qt::MatchStartsWith));
            Q_EMIT kind.activated(kind.currentIndex());
        }
        QStringList done;
        const test::Listening listening =
            test::onMessage(bench.window.session().journal(), &bench.window,
                            [&](Severity, const QString& text, Origin origin) {
                                done << (origin == Origin::Operator ? QStringList(text) : QStringList());
                            });
        const std::uint64_t before = bench.cell.truth().digitalOutputs;
        change("gripper.close");
        QMessageBox* question = bench.question("changeQuestion");
        QVERIFY2(question != nullptr, "the change was made without a question");
        QVERIFY2(question->text().contains("Cycle"), qPrintable(question->text()));
        QVERIFY2(QApplication::activeModalWidget() == nullptr, "STOP cannot be clicked");
        bench.cell.advanceMs(500);
        QCOMPARE(bench.cell.truth().digitalOutputs, before);
        QVERIFY2(done.isEmpty(), qPrintable(done.join('\n')));
        bench.answer("changeQuestion.take");
        QVERIFY(bench.until([&] { return !done.isEmpty(); }));
        QVERIFY(bench.runs());
        if (control == "gripper") {  // disabled while the command is pending
            QVERIFY(bench.until([&] { return bench.find<QPushButton>("gripper.open").isEnabled(); }));
        }
        change("gripper.open");
        QVERIFY(bench.until([&] { return bench.question("changeQuestion") != nullptr; }));
    }

    void theAnswerAppliesToOneRun() {
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.run());
        RobotSession& session = bench.window.session();
        QVERIFY(session.mustAskBeforeChange());
        session.confirmChanges();
        QVERIFY(!session.mustAskBeforeChange());
        session.stop(control::StopCause::StopButton);
        QVERIFY(bench.until([&] { return session.state().canMove() && !session.state().programRuns; }));
        QVERIFY(!session.mustAskBeforeChange());
    }

    void aPositionIsTaughtOnlyAtStandstill_data() {
        QTest::addColumn<QString>("way");
        for (const char* way : {"key", "button", "menu", "touch up"}) {
            QTest::newRow(way) << QString::fromLatin1(way);
        }
    }
    void aPositionIsTaughtOnlyAtStandstill() {
        QFETCH(QString, way);
        DayBench bench;
        QVERIFY2(bench.bringUp(), qPrintable(bench.cell.what()));
        bench.window.showTab("waypoints");
        bench.window.selectWaypoint(0);
        const int before = bench.window.waypointCount();
        auto* notice = bench.window.waypoints().findChild<NoticeBar*>();
        const auto teach = [&] {
            if (way == "key") {
                QTest::keyClick(&bench.window, Qt::Key_T);
            } else if (way == "button") {
                bench.find<QPushButton>("waypoint.teach").click();
            } else {
                bench.action(way == "menu" ? "waypoint.action.teach" : "waypoint.action.touchUp")->trigger();
            }
        };
        auto& key = bench.find<HoldToRunButton>("jog.X+");
        press(key);
        QVERIFY(bench.until([&] { return bench.window.session().state().moving; }));
        teach();
        QCOMPARE(bench.window.waypointCount(), before);
        QVERIFY2(notice->isVisible() && notice->title().contains("Stop the arm first"),
                 qPrintable(notice->title()));
        release(key);
        QVERIFY(
            bench.until([&] { return standsStill(bench.cell) && !bench.window.session().state().moving; }));
        teach();
        if (way == "touch up") {
            QVERIFY2(notice->title().startsWith("Touch up"), qPrintable(notice->title()));
        } else {
            QCOMPARE(bench.window.waypointCount(), before + 1);
            QVERIFY2(!notice->isVisible() || notice->title().startsWith("Taught"),
                     qPrintable(notice->title()));
        }
    }

    void ctrlZInAFieldUndoesTheAcceptedValue() {
        DayBench bench;
        bench.window.showTab("waypoints");
        bench.window.selectWaypoint(0);
        auto& x = bench.find<DecimalSpinBox>("waypoint.details.x");
        const project::Waypoint before = bench.window.document().waypoints().at(0);
        const auto now = [&] { return bench.window.document().waypoints().at(0).pose; };
        x.setFocus();
        x.selectAll();
        QTest::keyClicks(&x, "123.5");
        QTest::keyClick(&x, Qt::Key_Return);
        QVERIFY(std::abs(now().position.x() - 0.1235) < 1e-9);
        QVERIFY(x.hasFocus());
        // Typed text is undone in the field first.
        QTest::keyClicks(&x, "7");
        QTest::keyClick(&x, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(std::abs(now().position.x() - 0.1235) < 1e-9);
        QTest::keyClick(&x, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(now(), before.pose);
        QVERIFY(std::abs(x.value() - 1000 * before.pose.position.x()) < 0.01);
        QTest::keyClick(&x, Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(std::abs(now().position.x() - 0.1235) < 1e-9);
        // Leaving the field must not apply text that has been undone.
        bench.window.setFocus();
        QVERIFY(std::abs(now().position.x() - 0.1235) < 1e-9);
    }

    void theValuesOfAWaypointNameTheirTcp() {
        DayBench bench;
        bench.window.showTab("waypoints");
        project::Waypoint point = bench.window.document().waypoints().at(0);
        bench.window.selectWaypoint(0);
        auto& details = bench.find<WaypointDetails>("waypoint.details");
        QVERIFY2(details.headline().contains("TCP at the flange"), qPrintable(details.headline()));
        point.tcpOffset = Pose(0, 0, 0.1, 0, 0, 0);
        bench.window.document().changeWaypoint(0, point, "Change");
        QVERIFY2(details.headline().contains("TCP “gripper”"), qPrintable(details.headline()));
        point.tcpOffset = Pose(0, 0, 0.25, 0, 0, 0);
        bench.window.document().changeWaypoint(0, point, "Change");
        QVERIFY2(details.headline().contains("TCP 250.0 mm from the flange"), qPrintable(details.headline()));
    }

    void theButtonsOfAProgramFitTheirTexts() {
        DayBench bench;
        bench.window.setTheme("light");
        bench.window.showTab("program");
        QTest::qWait(50);
        for (const auto& [name, text] : {std::pair{"program.fromHere", "Continue at 4"},
                                         {"program.fromHere", "From step 12 ✕"},
                                         {"program.pause", "Resume"},
                                         {"program.run", "Stop"}}) {
            const int needed = QPushButton(QString::fromUtf8(text)).sizeHint().width();
            const int width = bench.find<QPushButton>(name).width();
            QVERIFY2(width >= needed,
                     qPrintable(QStringLiteral("%1: %2 < %3").arg(text).arg(width).arg(needed)));
        }
    }

    void thePanelsKeepTheirWidthsOverRestarts_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("tab");
        QTest::addColumn<bool>("enlarged");
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
            for (const char* tab : {"waypoints", "program", "io"}) {
                for (const bool enlarged : {false, true}) {
                    QTest::addRow("%dx%d %s %s", size.width(), size.height(), tab,
                                  enlarged ? "maximized" : "normal")
                        << size << QString::fromLatin1(tab) << enlarged;
                }
            }
        }
    }
    void thePanelsKeepTheirWidthsOverRestarts() {
        QFETCH(QSize, size);
        QFETCH(QString, tab);
        QFETCH(bool, enlarged);
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        QList<int> widths;
        for (int start = 0; start < 6; ++start) {
            app::MainWindow window{app::Settings(file)};
            if (start == 0 || enlarged) {
                window.resize(size);
            }
            window.show();
            QVERIFY(QTest::qWaitForWindowActive(&window));
            if (enlarged) {
                window.resize(size + QSize(640, 200));  // as by a window manager that maximizes the window
            }
            window.showTab(tab);
            QTest::qWait(50);
            if (start == 0) {
                // The user drags the separator to make the panel wider.
                auto& stage = *window.findChild<QMainWindow*>("stage");
                auto* panel = window.findChild<QDockWidget*>("tabsDock");
                const int before = panel->width();
                const QPoint separator(panel->x() - 3, panel->y() + panel->height() / 2);
                QTest::mousePress(&stage, Qt::LeftButton, {}, separator);
                sendMouse(stage, QEvent::MouseMove, Qt::LeftButton, separator - QPoint(40, 0));
                QTest::qWait(50);
                QTest::mouseRelease(&stage, Qt::LeftButton, {}, separator - QPoint(40, 0));
                QTest::qWait(50);
                QVERIFY2(panel->width() > before + 20, qPrintable(QString::number(panel->width())));
            }
            widths << window.findChild<QDockWidget*>("tabsDock")->width()
                   << window.findChild<QDockWidget*>("jogDock")->width();
            QVERIFY(window.close());
        }
        QString text;
        for (const int width : widths) {
            text += QString::number(width) + QLatin1Char(' ');
        }
        for (qsizetype i = 2; i < widths.size(); ++i) {
            QVERIFY2(std::abs(widths[i] - widths[i % 2]) <= 1, qPrintable(text));
        }
    }
};

QTEST_MAIN(TestOperatorDay)
#include "tst_operator_day.moc"
