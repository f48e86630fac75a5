// SPDX-License-Identifier: GPL-3.0-or-later
//
// The buttons that run a program in the Program tab, with the simulated controller in virtual time.

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

#include "program_samples.h"
#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"
#include "tests/support/waiting.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/segmented_control.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/program/program_tab.h"
#include "widgets/program/run_bar.h"
#include "widgets/program/step_tree.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::program;
using namespace tiller::test;
using control::StopCause;

namespace {

constexpr int kLongMs = 60'000;
constexpr double kStandstillTime = 0.25;  ///< maximum stopping time according to the jog contract [s]

struct TabBench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell{clock, session, [] {
                         simulator::SimulatorOptions options = VirtualCell::options();
                         options.startJoints = sampleProject().waypoints.at(0).joints;
                         return options;
                     }()};
    HoldPolicy policy;
    UndoableDocument document;
    HeldSpeed speed{0.05, 0.26, 0.17};
    ProgramTab tab{document};

    TabBench() {
        document.setProject(sampleProject());
        setSteps({"pick", "place"});
        tab.setRobot(session, policy, [this] { return speed; });
        for (HoldToRunButton* key : {&hold(), &start()}) {
            key->guard().setClock(clock);
        }
        cell.everyRefresh = [this] {
            hold().guard().pump();
            start().guard().pump();
        };
        tab.resize(900, 700);
        tab.show();
        tab.activateWindow();
        if (!QTest::qWaitForWindowActive(&tab)) {
            qFatal("the window did not become active");
        }
        QCoreApplication::processEvents();
    }
    std::vector<project::ProgramStep> moves(const QStringList& waypoints) const {
        std::vector<project::ProgramStep> moves;
        for (const QString& waypoint : waypoints) {
            moves.push_back(program::step("moveL", {{"waypoint", waypointId(document.project(), waypoint)}}));
        }
        return moves;
    }
    void setSteps(const QStringList& waypoints) { setProgram(moves(waypoints)); }
    void setProgram(std::vector<project::ProgramStep> steps) {
        project::ProgramList programs;
        programs.append(makeProgram("Test", std::move(steps)));
        document.changePrograms(programs, "steps");
        QCoreApplication::processEvents();
    }
    template <class Widget>
    Widget& find(const char* name) const {
        return *tab.findChild<Widget*>(QLatin1String(name));
    }
    HoldToRunButton& hold() const { return find<HoldToRunButton>("program.runHold"); }
    HoldToRunButton& start() const { return find<HoldToRunButton>("program.moveToStart"); }
    QPushButton& run() const { return find<QPushButton>("program.run"); }
    QPushButton& pause() const { return find<QPushButton>("program.pause"); }
    QPushButton& step() const { return find<QPushButton>("program.step"); }
    QPushButton& finish() const { return find<QPushButton>("program.finishCycle"); }
    QPushButton& from() const { return find<QPushButton>("program.fromHere"); }
    QString status() const { return find<ElidedLabel>("program.status").fullText(); }
    const ProgramRunner& runner() const { return find<RunBar>("program.runBar").runner(); }
    void press(HoldToRunButton& key) { QTest::mousePress(&key, Qt::LeftButton); }
    void release(HoldToRunButton& key) { QTest::mouseRelease(&key, Qt::LeftButton); }
    double speedNow() const { return cell.truth().tcpSpeed.linear.norm(); }
    bool isStill() const {
        return speedNow() < 0.001 && cell.truth().qd.values.cwiseAbs().maxCoeff() < 0.001;
    }
    bool reachMotion() {
        return cell.advanceUntil([this] { return speedNow() > 0.03; }, kLongMs);
    }
    bool awaitEnd() {
        return cell.advanceUntil([this] { return runner().state() == ProgramRunner::State::Ended; }, kLongMs);
    }
    /// Observes the arm for 1.2 s. Returns the time until it last moved [s]; 0 if it did not move.
    double standstill() {
        const double from = cell.truth().timestamp;
        double last = from;
        for (int i = 0; i < 600; ++i) {
            cell.advanceMs(2);
            last = isStill() ? last : cell.truth().timestamp;
        }
        return last - from;
    }
    bool preview() {
        find<QPushButton>("program.preview").click();
        return QTest::qWaitFor([this] { return status().contains("Simulated: "); }, kLongMs);
    }
    /// Runs a program without hold-to-run from its start.
    bool runFreely(const QStringList& waypoints) {
        setSteps(waypoints);
        const bool ready = preview() && moveToStart();
        cell.advanceMs(20);
        run().click();
        return ready && reachMotion();
    }
    /// Sends a command as another client.
    bool sendFromOutside(const char* text) {
        script::ScriptClient client(cell.robot.listenAddress(), cell.robot.ports().primary);
        return client.connect(testTimeout()).ok() &&
               client.send(QString::fromLatin1(text), testTimeout()).ok();
    }
    bool reachStep(int step) {
        return cell.advanceUntil([&] { return runner().log().step() == step && speedNow() > 0.03; }, kLongMs);
    }
    bool checkRecoverability() {
        find<QAction>("program.action.recover").trigger();
        return QTest::qWaitFor([this] { return !status().startsWith("Checking"); }, kLongMs);
    }
    bool reachWaiting() {
        return cell.advanceUntil([this] { return runner().isWaiting(); }, kLongMs);
    }
    bool moveToStart() {
        press(start());
        const bool arrived = cell.advanceUntil([this] { return !start().isHolding(); }, kLongMs);
        release(start());
        return arrived;
    }
    QString row(int index) const {
        const QAbstractItemModel& model = *find<StepTree>("program.tree").model();
        return model.index(index, 0).data().toString();
    }
};

}  // namespace

class TestRunBar : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // A branch that the preview did not run may collide.
    void aRunWithStepsThatWereNotPreviewedNeedsAnAnswer() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        std::vector<project::ProgramStep> steps = bench.moves({"pick"});
        steps.push_back(program::step("if", {{"condition", "DI0"}}, bench.moves({"place"})));
        bench.setProgram(steps);
        QVERIFY(bench.preview());
        QVERIFY2(bench.status().contains("Not run: step 3"), qPrintable(bench.status()));
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        auto* question = bench.tab.findChild<QMessageBox*>("program.notSimulated");
        QVERIFY(question != nullptr && question->text().contains("step 3"));
        QVERIFY(!bench.runner().isActive());
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(bench.tab.findChild<QMessageBox*>("program.notSimulated") == nullptr,
                                 kLongMs);
        QVERIFY(!bench.runner().isActive());
        bench.run().click();
        QTest::mouseClick(bench.tab.findChild<QPushButton*>("program.notSimulated.run"), Qt::LeftButton);
        QVERIFY(bench.runner().isActive());
        QVERIFY(bench.awaitEnd());
        // The preview uses the inputs of the robot.
        bench.cell.robot.setDigitalInput(0, true);
        QVERIFY(bench.cell.advanceUntil([&] { return (bench.session.state().digitalInputs & 1U) != 0; },
                                        kLongMs));
        bench.find<QPushButton>("program.preview").click();
        QTRY_VERIFY_WITH_TIMEOUT(bench.status().endsWith("No problems found."), kLongMs);
    }

    // Keys that are pressed to control the run must not change the selected step.
    void theFocusOfADisabledButtonDoesNotMoveToAField() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.find<StepTree>("program.tree")
            .selectIds({bench.document.project().programs.at(0).steps.at(0).id});
        bench.find<SegmentedControl>("program.side").setCurrentIndex(1);
        QVERIFY(bench.find<QWidget>("program.field.waypoint").isVisible());
        for (QPushButton* button :
             {&bench.run(), &bench.pause(), &bench.step(), &bench.finish(), &bench.from()}) {
            button->setEnabled(true);
            button->setFocus();
            QVERIFY(button->hasFocus());
            button->setEnabled(false);
            QVERIFY2(QApplication::focusWidget() == nullptr, qPrintable(button->objectName()));
        }
    }

    void buttonsGiveTheReason() {
        TabBench bench;
        QVERIFY(!bench.hold().isEnabled());
        QVERIFY(!bench.hold().toolTip().isEmpty());
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY2(bench.hold().isEnabled(), qPrintable(bench.hold().toolTip()));
        QVERIFY(bench.start().isEnabled());
        QVERIFY(!bench.run().isEnabled());
        QVERIFY2(bench.run().toolTip().contains("Preview"), qPrintable(bench.run().toolTip()));
        project::ProgramList programs = bench.document.project().programs;
        project::Program wrong = programs.at(0);
        wrong.steps.push_back(step("moveL"));
        programs.replace(0, wrong);
        bench.document.changePrograms(programs, "wrong");
        QCoreApplication::processEvents();
        QVERIFY(!bench.hold().isEnabled());
        QVERIFY2(bench.hold().toolTip().contains("waypoint"), qPrintable(bench.hold().toolTip()));
    }

    void aHeldRunEndsWithTheButton_data() {
        QTest::addColumn<QString>("end");
        for (const char* end : {"release", "pointer left", "tab hidden", "policy", "stop", "edit"}) {
            QTest::newRow(end) << QString::fromLatin1(end);
        }
    }
    void aHeldRunEndsWithTheButton() {
        QFETCH(QString, end);
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        QVERIFY(bench.hold().isConfirmed());
        QVERIFY2(bench.row(0).startsWith(QStringLiteral("▶")), qPrintable(bench.row(0)));
        QVERIFY2(bench.status().contains("step 1"), qPrintable(bench.status()));
        if (end == "release") {
            bench.release(bench.hold());
        } else if (end == "pointer left") {
            QTest::mouseMove(&bench.hold(), QPoint(5, -80));
        } else if (end == "tab hidden") {
            bench.tab.hide();
        } else if (end == "policy") {
            bench.policy.stop(StopCause::SelectionChanged);
        } else if (end == "stop") {
            bench.session.stop(StopCause::StopButton);
        } else {
            project::ProgramList programs = bench.document.project().programs;
            programs.remove(0);
            bench.document.changePrograms(programs, "remove");
            QCoreApplication::processEvents();
        }
        const double time = bench.standstill();
        QVERIFY2(time <= kStandstillTime, qPrintable(QString::number(time)));
        QVERIFY(bench.awaitEnd());
        QVERIFY(!bench.hold().isHolding());
        QVERIFY2(bench.runner().end() == ProgramRunner::End::Stopped, qPrintable(bench.status()));
        QVERIFY2(bench.status().contains("Stopped in step 1 (MoveL)"), qPrintable(bench.status()));
        if (end != "edit") {
            QVERIFY2(!bench.row(0).startsWith(QStringLiteral("▶")), qPrintable(bench.row(0)));
        }
    }

    void aHeldRunIsNoFasterThanTheJogSpeed() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY2(bench.hold().detail().contains("50"), qPrintable(bench.hold().detail()));
        bench.speed.tcp = 0.02;
        bench.tab.followSpeed();
        QVERIFY2(bench.hold().detail().contains("20"), qPrintable(bench.hold().detail()));
        bench.press(bench.hold());
        double fastest = 0;
        bench.cell.advanceUntil([&] { return fastest = std::max(fastest, bench.speedNow()), false; }, 3000);
        QVERIFY2(fastest > 0.015 && fastest < 0.021, qPrintable(QString::number(fastest)));
        bench.release(bench.hold());
        QVERIFY(bench.awaitEnd());
    }

    void aHeldRunReachesItsEnd() {
        TabBench bench;
        bench.speed.tcp = 0.25;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        // The button checks the run at its next refresh.
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.hold().isHolding(); }, 100));
        QVERIFY(bench.standstill() == 0);  // the button is still pressed
        bench.release(bench.hold());
        QVERIFY(bench.session.state().canMove());
    }

    void aReleasedRunContinuesWhereItWasStopped() {
        TabBench bench;
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const auto stopInStep = [&](int step) {
            bench.press(bench.hold());
            const bool reached = bench.cell.advanceUntil(
                [&] { return bench.runner().log().step() == step && bench.speedNow() > 0.03; }, kLongMs);
            bench.cell.advanceMs(400);
            bench.release(bench.hold());
            return reached && bench.awaitEnd();
        };
        QVERIFY(stopInStep(2));
        QVERIFY2(bench.status().contains("Stopped in step 2"), qPrintable(bench.status()));
        QCOMPARE(bench.hold().text(), QStringLiteral("Continue (hold)"));
        QCOMPARE(bench.from().text(), QStringLiteral("From step 2 ✕"));
        QVERIFY(bench.from().isChecked());
        bench.cell.advanceMs(200);
        const Pose stopped = bench.cell.truth().tcpPose;
        const Pose place = bench.document.project().waypoints.at(2).pose;
        QVERIFY(distanceMm(stopped, place) > 20);
        // The press continues directly to the target of the step.
        bench.press(bench.hold());
        double farthest = 0;
        QVERIFY(bench.cell.advanceUntil(
            [&] {
                farthest = std::max(farthest, distanceMm(bench.cell.truth().tcpPose, place));
                return bench.runner().log().step() == 3;
            },
            kLongMs));
        QVERIFY2(farthest <= distanceMm(stopped, place) + 0.5, qPrintable(QString::number(farthest)));
        QVERIFY(bench.awaitEnd());
        bench.release(bench.hold());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.runner().log().timings()[0].count, 0);
        // The completed program starts from the beginning.
        QCOMPARE(bench.hold().text(), QStringLiteral("Run (hold)"));
        QVERIFY(!bench.from().isChecked());
        // The button and every edit also make the program start from the beginning.
        bench.cell.advanceMs(200);
        QVERIFY(stopInStep(2));
        QVERIFY(bench.from().isChecked());
        bench.cell.advanceMs(200);
        bench.from().click();
        QCOMPARE(bench.hold().text(), QStringLiteral("Run (hold)"));
        bench.cell.advanceMs(200);
        QVERIFY(stopInStep(2));
        QVERIFY(bench.from().isChecked());
        bench.setSteps({"pick", "place"});
        QCOMPARE(bench.hold().text(), QStringLiteral("Run (hold)"));
    }

    void aRunReleasedInASectionStartsFromTheBeginning() {
        TabBench bench;
        bench.setProgram({program::step("loop", {{"times", 2}}, bench.moves({"pick", "place"}))});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        bench.release(bench.hold());
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("cannot continue inside a section"), qPrintable(bench.status()));
        QCOMPARE(bench.hold().text(), QStringLiteral("Run (hold)"));
        QVERIFY(!bench.from().isChecked());
    }

    // The duration of the program is unknown, and its steps are in a section.
    void aHeldRunContinuesAfterTheMaximumHoldTime() {
        TabBench bench;
        bench.setProgram({program::step("loop", {{"times", 8}}, bench.moves({"pick", "place"}))});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        int presses = 0;
        while (bench.runner().state() != ProgramRunner::State::Ended && presses < 10) {
            ++presses;
            bench.press(bench.hold());
            const double from = bench.cell.truth().timestamp;
            QVERIFY(bench.cell.advanceUntil([&] { return !bench.hold().isHolding(); }, kLongMs));
            QVERIFY(bench.cell.truth().timestamp - from <= 20.5);
            bench.release(bench.hold());
            if (bench.runner().state() != ProgramRunner::State::Running) {
                break;
            }
            if (presses > 1) {
                continue;
            }
            // The arm waits at standstill, and only a press moves it.
            QVERIFY(bench.standstill() <= kStandstillTime);
            bench.cell.advanceMs(5000);
            QVERIFY(bench.runner().isActive() && bench.isStill());
            QVERIFY2(bench.status().contains("Hold “Continue (hold)”"), qPrintable(bench.status()));
            QCOMPARE(bench.hold().text(), QStringLiteral("Continue (hold)"));
            QVERIFY(bench.hold().isEnabled() && !bench.start().isEnabled());
            QVERIFY(!bench.pause().isEnabled() && !bench.step().isEnabled());
            // The script on the robot has the speed of the first press.
            const HeldSpeed before = std::exchange(bench.speed, {0.02, 0.26, 0.17});
            bench.press(bench.hold());
            QVERIFY2(bench.status().contains("Select this speed again"), qPrintable(bench.status()));
            bench.release(bench.hold());
            bench.speed = before;
            bench.cell.advanceMs(100);
        }
        QVERIFY2(presses > 2, qPrintable(QString::number(presses)));
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.runner().end() == ProgramRunner::End::Completed, qPrintable(bench.status()));
        QCOMPARE(bench.runner().log().timings()[1].count, 8);
    }

    void aProgramThatWaitsForAPressEnds_data() {
        QTest::addColumn<QString>("by");
        for (const char* by : {"Stop", "STOP", "another program", "a protective stop", "a pause on the robot",
                               "a hanging window", "the release after the next press"}) {
            QTest::newRow(by) << QString(by);
        }
    }
    void aProgramThatWaitsForAPressEnds() {
        QFETCH(QString, by);
        TabBench bench;
        bench.setProgram({program::step("loop", {{"times", 9}}, bench.moves({"pick", "place"}))});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.hold().isHolding(); }, kLongMs));
        bench.release(bench.hold());
        bench.cell.advanceMs(500);
        QVERIFY(bench.runner().isActive());
        if (by == "Stop") {
            QCOMPARE(bench.run().text(), QStringLiteral("Stop"));
            bench.run().click();
        } else if (by == "STOP") {
            bench.session.stop(StopCause::StopButton);
        } else if (by == "another program") {
            project::ProgramList programs = bench.document.project().programs;
            programs.append(makeProgram("Other", bench.moves({"home"})));
            bench.document.changePrograms(programs, "other");
            auto& choice = bench.find<QComboBox>("program.choice");
            choice.setCurrentIndex(1);
            Q_EMIT choice.activated(1);
        } else if (by == "a protective stop") {
            bench.cell.robot.protectiveStop();
        } else if (by == "a pause on the robot") {
            QVERIFY(bench.sendFromOutside("pause program\n"));
        } else if (by == "a hanging window") {
            bench.cell.advanceWithFrozenInterface(300);
        } else {
            bench.press(bench.hold());
            QVERIFY(bench.reachMotion());
            bench.release(bench.hold());
            QVERIFY(bench.standstill() <= kStandstillTime);
        }
        QVERIFY(bench.awaitEnd());
        QVERIFY(bench.isStill());
    }

    // At a low jog speed, one move takes longer than the maximum hold time.
    void aLongMoveOfAHeldRunReachesItsTarget_data() {
        QTest::addColumn<bool>("isReleased");
        QTest::newRow("held") << false;
        QTest::newRow("released") << true;
    }
    void aLongMoveOfAHeldRunReachesItsTarget() {
        QFETCH(bool, isReleased);
        TabBench bench;
        bench.speed = {0.004, 0.26, 0.17};
        bench.setProgram({program::step("try", {}, bench.moves({"pick", "place"})),
                          program::step("onError", {}, bench.moves({"home"}))});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        if (isReleased) {
            bench.cell.advanceMs(22'000);
            QVERIFY(bench.hold().isHolding() && bench.speedNow() > 0.003);
            bench.release(bench.hold());
            QVERIFY(bench.standstill() <= kStandstillTime);
            QVERIFY(bench.awaitEnd());
            return;
        }
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.hold().isHolding(); }, 2 * kLongMs));
        bench.release(bench.hold());
        QVERIFY2(bench.status().contains("Paused before step 3"), qPrintable(bench.status()));
        bench.press(bench.hold());
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.hold().isHolding(); }, 2 * kLongMs));
        bench.release(bench.hold());
        QVERIFY2(bench.awaitEnd(), qPrintable(bench.status()));
        QVERIFY2(bench.runner().end() == ProgramRunner::End::Completed, qPrintable(bench.status()));
    }

    // The step has no known end, so the program cannot pause before the next step.
    void aRunHeldTooLongNamesTheRemedy() {
        TabBench bench;
        bench.setProgram({program::step("loop", {{"times", 2}}, {program::step("wait", {{"time", 60}})})});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("maximum hold time"), qPrintable(bench.status()));
        QVERIFY2(bench.status().contains("Preview the program"), qPrintable(bench.status()));
        bench.release(bench.hold());
    }

    void aHeldRunExplainsItsLowSpeed() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        QVERIFY2(bench.status().contains("slow"), qPrintable(bench.status()));
        bench.release(bench.hold());
        QVERIFY(bench.awaitEnd());
        QVERIFY(bench.preview() && bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        QVERIFY2(!bench.status().contains("slow"), qPrintable(bench.status()));
        bench.release(bench.hold());
    }

    void theRecoverabilityCheckUsesTheInputs() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        std::vector<project::ProgramStep> steps = bench.moves({"home"});
        steps.push_back(program::step("if", {{"condition", "DI0"}}, bench.moves({"pick", "place"})));
        steps.push_back(program::step("else", {}, bench.moves({"pick"})));
        bench.setProgram(steps);
        bench.cell.robot.setDigitalInput(0, true);
        QVERIFY(bench.cell.advanceUntil([&] { return (bench.session.state().digitalInputs & 1U) != 0; },
                                        kLongMs));
        QVERIFY(bench.checkRecoverability());
        QVERIFY2(bench.status().contains("Not checked: steps 5 to 6"), qPrintable(bench.status()));
        // A stop in a step that was not checked.
        bench.cell.robot.setDigitalInput(0, false);
        QVERIFY(bench.cell.advanceUntil([&] { return (bench.session.state().digitalInputs & 1U) == 0; },
                                        kLongMs));
        QVERIFY(bench.preview() && bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        bench.tab.findChild<QPushButton*>("program.notSimulated.run")->click();
        QVERIFY(bench.cell.advanceUntil([&] { return bench.runner().log().step() == 6; }, kLongMs));
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("did not reach step 6"), qPrintable(bench.status()));
    }

    // The time of a stop on the teach pendant is not known.
    void aStopOnTheRobotIsTheLastStop() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runFreely({"pick", "place"}));
        QVERIFY(bench.session.state().lastStop.count == 0 || bench.session.state().lastStopSeen);
        QVERIFY(bench.sendFromOutside("stop program\n"));
        QVERIFY(bench.awaitEnd());
        QVERIFY(!bench.session.state().lastStopSeen);
    }

    void runNeedsAPreviewAndTheStartPosition() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.preview());
        bench.cell.advanceMs(20);
        QVERIFY(!bench.run().isEnabled());
        QVERIFY2(bench.run().toolTip().contains("start position"), qPrintable(bench.run().toolTip()));
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        QVERIFY2(bench.run().isEnabled(), qPrintable(bench.run().toolTip()));
        bench.run().click();
        QVERIFY(bench.reachMotion());
        QCOMPARE(bench.run().text(), QStringLiteral("Stop"));
        QVERIFY(!bench.hold().isEnabled());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.run().text(), QStringLiteral("Run"));
        // The arm is no longer at the start position.
        QVERIFY(!bench.run().isEnabled());
        // An edit makes the preview stale.
        QVERIFY(bench.moveToStart());
        bench.setSteps({"pick", "home"});
        bench.cell.advanceMs(20);
        QVERIFY(!bench.run().isEnabled());
        QVERIFY2(bench.run().toolTip().contains("Preview"), qPrintable(bench.run().toolTip()));
    }

    void theButtonStopsARun() {
        TabBench bench;
        bench.setSteps({"pick", "place", "home", "pick"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        QVERIFY(bench.reachMotion());
        bench.run().click();
        const double time = bench.standstill();
        QVERIFY2(time <= kStandstillTime, qPrintable(QString::number(time)));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Stopped);
        QVERIFY(bench.session.state().canMove());
    }

    void aRunPausesAndContinues() {
        TabBench bench;
        QStringList log;
        const test::Listening listening = test::onMessage(
            bench.session.journal(), &bench.tab, [&](Severity, const QString& text) { log.append(text); });
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(20);
        QVERIFY(!bench.pause().isEnabled() && !bench.step().isEnabled());
        QVERIFY2(bench.pause().toolTip().contains("No program"), qPrintable(bench.pause().toolTip()));
        QVERIFY2(bench.step().toolTip().contains("Preview"), qPrintable(bench.step().toolTip()));
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        QVERIFY(bench.reachMotion());
        QVERIFY(!bench.step().isEnabled());
        QVERIFY2(bench.step().toolTip().contains("Pause"), qPrintable(bench.step().toolTip()));
        QVERIFY(!bench.finish().isEnabled());
        QVERIFY2(bench.finish().toolTip().contains("endless"), qPrintable(bench.finish().toolTip()));
        const int width = bench.pause().width();
        bench.pause().click();
        QCOMPARE(bench.pause().text(), QStringLiteral("Resume"));
        QVERIFY2(bench.status().startsWith("Pausing"), qPrintable(bench.status()));
        const int running = bench.runner().log().step();
        QVERIFY(bench.reachWaiting());
        QCOMPARE(bench.pause().width(), width);
        QCOMPARE(bench.run().text(), QStringLiteral("Stop"));
        QVERIFY2(bench.status().startsWith(QStringLiteral("Paused before step %1").arg(running + 1)),
                 qPrintable(bench.status()));
        QVERIFY2(log.contains(bench.status()), qPrintable(log.join('\n')));
        QVERIFY2(bench.row(running).startsWith(QStringLiteral("▶")), qPrintable(bench.row(running)));
        QVERIFY(bench.standstill() <= kStandstillTime);
        QVERIFY(bench.isStill());
        bench.pause().click();
        QCOMPARE(bench.pause().text(), QStringLiteral("Pause"));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        QVERIFY(!bench.pause().isEnabled());
    }

    void theMarkerOfTheRunningStepEndsWithTheRun_data() {
        QTest::addColumn<bool>("replaced");
        QTest::newRow("program of another client") << true;
        QTest::newRow("lost link") << false;
    }
    void theMarkerOfTheRunningStepEndsWithTheRun() {
        QFETCH(bool, replaced);
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runFreely({"pick", "place", "home", "pick"}));
        QVERIFY(bench.reachStep(2));
        QVERIFY2(bench.row(1).startsWith(QStringLiteral("▶")), qPrintable(bench.row(1)));
        if (replaced) {
            QVERIFY(bench.sendFromOutside("def other():\n  sleep(20)\nend\n"));
        } else {
            bench.session.disconnectFromRobot();
        }
        QVERIFY(bench.awaitEnd());
        QVERIFY2(!bench.row(1).contains(QStringLiteral("▶")), qPrintable(bench.row(1)));
        // The names of internal requests are only in the log.
        for (const char* internal : {"run a script", "LinkLost", "control program"}) {
            QVERIFY2(!bench.status().contains(QLatin1String(internal)), qPrintable(bench.status()));
        }
        const QAbstractItemModel& model = *bench.find<StepTree>("program.tree").model();
        QVERIFY(!model.index(1, 0).data(Qt::FontRole).value<QFont>().bold());
    }

    // The tree scrolls to the running step until the user scrolls away from it.
    void theTreeFollowsTheRunningStep() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        std::vector<project::ProgramStep> steps = bench.moves({"pick"});
        for (int i = 0; i < 100; ++i) {
            steps.push_back(program::step("wait", {{"time", 0.1}}));
        }
        bench.setProgram(steps);
        StepTree& tree = bench.find<StepTree>("program.tree");
        const auto isVisible = [&](int row) {
            return tree.viewport()->rect().intersects(tree.visualRect(tree.model()->index(row, 0)));
        };
        QVERIFY(bench.preview() && bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        const auto runsStep = [&](int step) {
            return bench.cell.advanceUntil([&] { return bench.runner().log().step() == step; }, kLongMs);
        };
        QVERIFY(!isVisible(49) && runsStep(50));
        QVERIFY(isVisible(49) && !isVisible(0));
        tree.scrollToTop();
        QVERIFY(runsStep(70));
        QVERIFY(isVisible(0) && !isVisible(69));
        QVERIFY(bench.awaitEnd());
    }

    // Imported programs usually set their TCP.
    void aProgramThatSetsItsTcpRunsWithAnyTcp() {
        TabBench bench;
        const Pose tcp(0, 0, 0.1, 0, 0, 0);  // not the TCP of the robot
        project::Project project = bench.document.project();
        for (int i = 0; i < project.waypoints.size(); ++i) {
            project::Waypoint point = project.waypoints.at(i);
            point.tcpOffset = tcp;
            point.pose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, point.joints, tcp);
            project.waypoints.replace(i, point);
        }
        bench.document.setProject(project);
        std::vector<project::ProgramStep> steps = bench.moves({"pick", "place"});
        steps.insert(steps.begin(), program::step("script", {{"text", "set_tcp(p[0, 0, 0.1, 0, 0, 0])"}}));
        bench.setProgram(steps);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.preview());
        QVERIFY2(bench.status().contains("No problems found"), qPrintable(bench.status()));
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        QVERIFY2(bench.run().isEnabled(), qPrintable(bench.run().toolTip()));
        bench.run().click();
        QVERIFY2(bench.runner().isActive(), qPrintable(bench.status()));
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
    }

    void stepRunsOneStep() {
        TabBench bench;
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        QVERIFY2(bench.step().isEnabled(), qPrintable(bench.step().toolTip()));
        for (int next = 2; next <= 3; ++next) {
            bench.step().click();
            QVERIFY(bench.cell.advanceUntil(
                [&] { return bench.runner().isWaiting() && bench.runner().log().step() == next; }, kLongMs));
            QVERIFY(bench.standstill() <= kStandstillTime);
            QVERIFY(bench.isStill() && bench.step().isEnabled());
        }
        // STOP ends a paused program.
        bench.session.stop(StopCause::StopButton);
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Stopped);
        QVERIFY(bench.session.state().canMove());
    }

    void variablesAreEditedWhileTheProgramWaits() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto& list = bench.find<QTreeView>("program.variables");
        QVERIFY(!list.isVisible());
        std::vector<project::ProgramStep> steps = bench.moves({"pick", "place"});
        const auto assign = [](const char* variable, const char* type, const char* value) {
            return program::step("assign", {{"variable", variable}, {"type", type}, {"value", value}});
        };
        steps.insert(steps.begin() + 1, {assign("count", "whole", "2"), assign("done", "flag", "False"),
                                         assign("label", "text", "\"a\"")});
        bench.setProgram(steps);
        bench.tab.tree().selectIds({steps.at(4).id});
        bench.find<QAction>("program.action.breakpoint").trigger();
        QStringList log;
        const test::Listening listening = onMessage(bench.session.journal(), &bench.tab,
                                                    [&log](Severity, const QString& text) { log << text; });
        QVERIFY(bench.preview() && bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        QVERIFY(bench.reachWaiting());
        const auto text = [&](int row, int column) {
            return list.model()->index(row, column).data().toString();
        };
        QVERIFY(bench.cell.advanceUntil([&] { return text(0, 2) == "2" && text(2, 2) == "\"a\""; }, kLongMs));
        QVERIFY(list.isVisible());
        QCOMPARE(text(0, 0) + ' ' + text(0, 1), QStringLiteral("count Whole number"));
        QCOMPARE(text(1, 0) + ' ' + text(1, 1) + ' ' + text(1, 2),
                 QStringLiteral("done True or false False"));
        const auto index = [&](int row) { return list.model()->index(row, 2); };
        const auto select = [&](int row) {
            list.setFocus();
            list.setCurrentIndex(index(row));
        };
        // A text variable is read-only, and the reason is shown.
        select(2);
        QVERIFY(index(2).data(Qt::ToolTipRole).toString().contains("Only numbers"));
        Q_EMIT list.activated(index(2));
        QVERIFY2(bench.status().contains("Only numbers"), qPrintable(bench.status()));
        // A wrong value is refused.
        const auto type = [&](int row, const char* typed) {
            select(row);
            list.edit(index(row));
            auto* editor = list.findChild<QLineEdit*>();
            if (editor == nullptr) {
                return false;
            }
            editor->selectAll();
            QTest::keyClicks(editor, typed);
            QTest::keyClick(editor, Qt::Key_Return);
            QCoreApplication::processEvents();  // the delegate commits later
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return true;
        };
        QVERIFY(type(0, "2.5"));
        QVERIFY2(bench.status().contains("not a whole number"), qPrintable(bench.status()));
        QCOMPARE(text(0, 2), QStringLiteral("2"));
        // The variable is marked as changing until the robot confirms the change.
        QVERIFY(type(0, "7"));
        QCOMPARE(text(0, 2), QStringLiteral("2 (changing…)"));
        QVERIFY(!bench.pause().isEnabled() && !bench.step().isEnabled());
        QVERIFY(bench.pause().toolTip().contains("count"));
        QVERIFY(bench.cell.advanceUntil([&] { return text(0, 2) == "7"; }, kLongMs));
        QVERIFY(log.contains("Variable “count”: 2 → 7"));
        QVERIFY(bench.status().contains("2 → 7"));
        QVERIFY(bench.pause().isEnabled() && bench.step().isEnabled() && bench.isStill());
        // A Boolean value is selected from a list.
        select(1);
        list.edit(index(1));
        auto* flag = list.findChild<QComboBox*>();
        QVERIFY(flag != nullptr);
        flag->setCurrentIndex(1);
        QTest::keyClick(flag, Qt::Key_Return);
        QVERIFY(bench.cell.advanceUntil([&] { return text(1, 2) == "True"; }, kLongMs));
        QVERIFY(log.contains("Variable “done”: False → True"));
        QVERIFY(bench.standstill() == 0 && bench.runner().isWaiting());
        // A flag is typed, e.g. after Ctrl+A. Every other word is refused.
        const auto typeFlag = [&](const char* typed) {
            select(1);
            list.edit(index(1));
            flag = list.findChild<QComboBox*>();
            if (flag == nullptr) {
                return;
            }
            QTest::keyClick(flag, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(flag, typed);
            QTest::keyClick(flag, Qt::Key_Return);
            QCoreApplication::processEvents();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        };
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        typeFlag("False");
        QVERIFY(bench.cell.advanceUntil([&] { return text(1, 2) == "False"; }, kLongMs));
        typeFlag("True");
        QVERIFY(bench.cell.advanceUntil([&] { return text(1, 2) == "True"; }, kLongMs));
        typeFlag("yes");
        QVERIFY2(bench.status().contains("not True or False"), qPrintable(bench.status()));
        QCOMPARE(text(1, 2), QStringLiteral("True"));
        // The moves with the new values were not previewed.
        bench.pause().click();
        QVERIFY(bench.tab.findChild<QMessageBox*>("program.changed") != nullptr);
        QVERIFY(bench.standstill() == 0 && bench.runner().isWaiting());
        // While the program runs, and after its end, the values are read-only.
        QTest::mouseClick(bench.tab.findChild<QPushButton*>("program.changed.run"), Qt::LeftButton);
        QVERIFY(bench.reachMotion());
        QVERIFY(!index(0).flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(bench.awaitEnd());
        QVERIFY(list.isVisible() && text(0, 2) == "7");
        QVERIFY(index(0).data(Qt::ToolTipRole).toString().contains("No program is running"));
    }

    void finishCycleEndsAnEndlessProgram() {
        TabBench bench;
        bench.setProgram({program::step("loop", {{"times", 0}}, bench.moves({"pick", "place"}))});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        QVERIFY2(bench.finish().isEnabled(), qPrintable(bench.finish().toolTip()));
        bench.finish().click();
        QVERIFY(bench.runner().endsWithCycle() && bench.finish().isChecked());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        QVERIFY(!bench.finish().isChecked() && !bench.finish().isEnabled());
        bench.release(bench.hold());
    }

    void fromHereStartsAtTheSelectedStep() {
        TabBench bench;
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(20);
        QVERIFY(!bench.from().isEnabled());
        QVERIFY2(bench.from().toolTip().contains("Preview"), qPrintable(bench.from().toolTip()));
        QVERIFY(bench.preview());
        bench.tab.tree().selectIds({});
        QVERIFY(!bench.from().isEnabled());
        const std::vector<project::ProgramStep> steps = bench.document.project().programs.at(0).steps;
        bench.tab.tree().selectIds({steps[1].id});
        QVERIFY2(bench.from().isEnabled(), qPrintable(bench.from().toolTip()));
        const int width = bench.from().width();
        bench.from().click();
        QCOMPARE(bench.from().text(), QStringLiteral("From step 2 ✕"));
        QVERIFY(bench.from().isChecked());
        QCOMPARE(bench.from().width(), width);
        QVERIFY(QTest::qWaitFor([&] { return bench.status().contains("Simulated: "); }, kLongMs));
        bench.cell.advanceMs(20);
        QVERIFY2(bench.run().toolTip().contains("start position"), qPrintable(bench.run().toolTip()));
        bench.press(bench.hold());  // not at the start position
        QVERIFY2(bench.status().contains("start position"), qPrintable(bench.status()));
        bench.release(bench.hold());
        QVERIFY(bench.standstill() == 0);
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        const Pose pick = bench.document.project().waypoints.at(1).pose;
        QVERIFY(distanceMm(bench.cell.truth().tcpPose, pick) < 0.5);
        bench.run().click();
        QVERIFY(bench.reachMotion());
        QVERIFY(!bench.from().isEnabled());
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.runner().end(), ProgramRunner::End::Completed);
        QCOMPARE(bench.runner().log().timings()[0].count, 0);
        QCOMPARE(bench.runner().log().timings()[1].count, 1);
        QCOMPARE(bench.runner().log().timings()[2].count, 1);
        // The button and every edit reset the run to start from the beginning.
        bench.from().click();
        QCOMPARE(bench.from().text(), QStringLiteral("Start from here"));
        QVERIFY(!bench.from().isChecked());
        QVERIFY(bench.preview());
        bench.tab.tree().selectIds({steps[1].id});
        bench.from().click();
        QVERIFY(bench.from().isChecked());
        bench.setSteps({"pick", "place"});
        QVERIFY(!bench.from().isChecked());
    }

    void stoppedProgramContinuesAtTheStepOfTheMark() {
        TabBench bench;
        std::vector<project::ProgramStep> steps = bench.moves({"pick", "place", "pick"});
        steps.insert(steps.begin() + 2,
                     program::step("force", {{"force", 0}}, {program::step("wait", {{"time", 1}})}));
        bench.setProgram(steps);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(20);
        QVERIFY(bench.checkRecoverability());
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        QVERIFY2(bench.run().isEnabled(), qPrintable(bench.run().toolTip()));
        // A stop in the second move.
        bench.run().click();
        QVERIFY(bench.cell.advanceUntil(
            [&] { return bench.runner().log().step() == 2 && bench.speedNow() > 0.03; }, kLongMs));
        bench.cell.advanceMs(400);
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("can continue from step 2"), qPrintable(bench.status()));
        QCOMPARE(bench.from().text(), QStringLiteral("Continue at 2"));
        bench.cell.advanceMs(200);
        QVERIFY2(bench.from().isEnabled(), qPrintable(bench.from().toolTip()));
        bench.from().click();
        QCOMPARE(bench.from().text(), QStringLiteral("From step 2 ✕"));
        QVERIFY(
            QTest::qWaitFor([&] { return bench.status().startsWith("Simulated: the program"); }, kLongMs));
        bench.cell.advanceMs(200);
        QVERIFY2(bench.run().toolTip().contains("start position"), qPrintable(bench.run().toolTip()));
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(200);
        QVERIFY2(bench.run().isEnabled(), qPrintable(bench.run().toolTip()));
        bench.run().click();
        QVERIFY(bench.cell.advanceUntil([&] { return bench.runner().log().step() == 4; }, kLongMs));
        QCOMPARE(bench.runner().log().timings()[0].count, 0);
        // A stop in the open force section.
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QVERIFY2(
            bench.status().contains("cannot continue safely") && bench.status().contains("force section"),
            qPrintable(bench.status()));
        QVERIFY(!bench.from().text().startsWith("Continue"));
    }

    void aPauseOnTheRobotIsShown() {
        TabBench bench;
        QStringList log;
        const test::Listening listening = test::onMessage(
            bench.session.journal(), &bench.tab, [&](Severity, const QString& text) { log << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runFreely({"pick", "place", "home", "pick"}));
        QVERIFY(bench.sendFromOutside("pause program\n"));
        QVERIFY(bench.cell.advanceUntil(
            [&] { return bench.session.state().runtimeState == RuntimeState::Paused; }, kLongMs));
        bench.cell.advanceMs(100);
        QVERIFY2(bench.status().contains("Paused on the robot in step 2 (MoveL)"),
                 qPrintable(bench.status()));
        QVERIFY2(log.contains(bench.status()), qPrintable(log.join('\n')));
        QVERIFY(!bench.pause().isEnabled());
        QVERIFY2(bench.pause().toolTip().contains("paused on the robot"),
                 qPrintable(bench.pause().toolTip()));
        QVERIFY(!bench.step().isEnabled());
        QVERIFY(bench.run().isEnabled());
        QCOMPARE(bench.run().text(), QStringLiteral("Stop"));
        QVERIFY(bench.sendFromOutside("run program\n"));
        QVERIFY(bench.reachMotion());
        QVERIFY2(bench.status().contains("Running step 2"), qPrintable(bench.status()));
        QVERIFY(bench.pause().isEnabled());
        QVERIFY(bench.sendFromOutside("pause program\n"));
        bench.cell.advanceMs(500);
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("Stopped in step"), qPrintable(bench.status()));
    }

    void aPauseOnTheRobotEndsAHeldRun() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.hold());
        QVERIFY(bench.reachMotion());
        QVERIFY(bench.sendFromOutside("pause program\n"));
        QVERIFY(bench.standstill() <= kStandstillTime + 0.1);
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("Stopped in step 1 (MoveL)"), qPrintable(bench.status()));
        QVERIFY2(bench.status().contains("on the robot"), qPrintable(bench.status()));
        bench.release(bench.hold());
    }

    void aStopOnTheRobotIsAWarningAndCanContinue() {
        TabBench bench;
        std::optional<Severity> severity;
        const test::Listening listening =
            test::onMessage(bench.session.journal(), &bench.tab, [&](Severity how, const QString& text) {
                severity = text.contains("Stopped in step 2") ? how : severity;
            });
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.checkRecoverability());
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        QVERIFY(bench.reachStep(2));
        QVERIFY(bench.sendFromOutside("stop program\n"));
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("Stopped in step 2 (MoveL)"), qPrintable(bench.status()));
        QCOMPARE(severity, std::optional(Severity::Warning));
        QCOMPARE(bench.from().text(), QStringLiteral("Continue at 2"));
    }

    void anEditAfterAStopEndsTheOfferToContinue() {
        TabBench bench;
        bench.setSteps({"pick", "place", "home"});
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.checkRecoverability());
        QVERIFY(bench.preview());
        QVERIFY(bench.moveToStart());
        bench.cell.advanceMs(20);
        bench.run().click();
        QVERIFY(bench.reachStep(2));
        bench.cell.advanceMs(300);
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QCOMPARE(bench.from().text(), QStringLiteral("Continue at 2"));
        // The inserted step has never run.
        project::ProgramList programs = bench.document.project().programs;
        const project::Program before = programs.at(0);
        project::Program edited = before;
        edited.steps.insert(edited.steps.begin() + 1, program::step("setOutput", {{"output", 0}}));
        programs.replace(0, edited);
        bench.document.changePrograms(programs, "insert");
        QCoreApplication::processEvents();
        QCOMPARE(bench.from().text(), QStringLiteral("Start from here"));
        QVERIFY2(bench.status().contains("program was changed"), qPrintable(bench.status()));
        QVERIFY(bench.checkRecoverability());
        QVERIFY2(bench.status().contains("program was changed"), qPrintable(bench.status()));
        QCOMPARE(bench.from().text(), QStringLiteral("Start from here"));
        // Undo restores the program that ran.
        bench.document.undo();
        QCoreApplication::processEvents();
        QVERIFY(bench.checkRecoverability());
        QVERIFY2(bench.status().contains("can continue from step 2"), qPrintable(bench.status()));
        QCOMPARE(bench.from().text(), QStringLiteral("Continue at 2"));
        // An output that was switched after the stop has another state than at the simulated stop.
        bench.session.outputs().setDigitalOutput(2, true);
        QVERIFY(bench.cell.advanceUntil([&] { return bench.from().text() == "Start from here"; }, 2000));
        QVERIFY2(bench.status().contains("Outputs were changed"), qPrintable(bench.status()));
    }

    void textsOfARunHaveTheNumbersOfTheRows() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runFreely({"pick", "place", "home", "pick"}));
        QVERIFY(bench.reachStep(2));
        QVERIFY2(bench.status().contains("Running step 2"), qPrintable(bench.status()));
        project::ProgramList programs = bench.document.project().programs;
        project::Program edited = programs.at(0);
        edited.steps.erase(edited.steps.begin());
        programs.replace(0, edited);
        bench.document.changePrograms(programs, "remove step 1");
        QCoreApplication::processEvents();
        QVERIFY2(bench.row(0).startsWith(QStringLiteral("▶ 1")), qPrintable(bench.row(0)));
        QVERIFY2(bench.status().contains("Running step 1 (MoveL)"), qPrintable(bench.status()));
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        QVERIFY2(bench.status().contains("Stopped in step 1 (MoveL)"), qPrintable(bench.status()));
    }

    void theRunningProgramIsNotDeleted() {
        TabBench bench;
        QStringList log;
        const test::Listening listening = test::onMessage(
            bench.session.journal(), &bench.tab, [&](Severity, const QString& text) { log << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runFreely({"pick", "place", "home", "pick"}));
        const auto isKept = [&] {
            QCoreApplication::processEvents();
            const bool kept = bench.document.project().programs.size() == 1 &&
                              bench.status().contains("program is running") && !log.isEmpty() &&
                              log.last().contains("program is running") && bench.runner().isActive();
            log.clear();
            return kept;
        };
        bench.find<QAction>("program.action.remove").trigger();
        QVERIFY2(isKept(), qPrintable(bench.status()));
        while (bench.document.undoStack().canUndo() && !bench.document.project().programs.isEmpty()) {
            const int index = bench.document.undoStack().index();
            bench.document.undo();
            if (bench.document.undoStack().index() == index) {
                break;
            }
        }
        QVERIFY2(isKept(), qPrintable(bench.status()));
        bench.run().click();
        QVERIFY(bench.awaitEnd());
        bench.find<QAction>("program.action.remove").trigger();
        QCoreApplication::processEvents();
        QVERIFY(bench.document.project().programs.isEmpty());
        QVERIFY2(log.last().contains("Program “Test” deleted") && log.last().contains("Ctrl+Z"),
                 qPrintable(log.join('\n')));
    }

    void moveToStartEndsWithTheButton() {
        TabBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.press(bench.start());
        QVERIFY(bench.cell.advanceUntil([&] { return bench.speedNow() > 0.02; }, kLongMs));
        bench.release(bench.start());
        QVERIFY(bench.standstill() <= kStandstillTime);
        QVERIFY(!bench.start().isHolding());
    }
};

QTEST_MAIN(TestRunBar)
#include "tst_run_bar.moc"
