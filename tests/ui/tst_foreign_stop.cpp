// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of another client moves the arm while this window only monitors. STOP and the stop button of a
// device stop the arm immediately, independent of the focus and of the robot's dashboard. The focus widget
// receives Space and Esc, and taking control requires a confirmation. Uses the real window, real events and
// real sockets, with the simulated robot in virtual time.

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTcpServer>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>

#include "app/action_table.h"
#include "resources/resources.h"
#include "tests/ui/foreign_program_bench.h"
#include "widgets/common/state_chip.h"
#include "widgets/status/recovery_page.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

using Bench = ForeignProgramBench;
enum class Focus { Window, TextField, Table, Dialog, Palette };
constexpr const char* kFocuses[] = {"window", "text field", "table", "dialog", "palette"};
enum class Path { Header, Command, Recovery };
constexpr const char* kPaths[] = {"header", "command", "recovery page"};

/// Robot options for PolyScope X, which has no dashboard, so that a test can listen at the dashboard port.
simulator::SimulatorOptions withoutDashboard() {
    simulator::SimulatorOptions options = VirtualCell::options();
    options.software = {10, 12, 0, 0};
    options.portOffset = 20'000;
    return options;
}

}  // namespace

class TestForeignStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void onlyTheStopButtonStopsAForeignProgram_data() {
        QTest::addColumn<Way>("way");
        QTest::addColumn<Focus>("focus");
        for (const Focus focus :
             {Focus::Window, Focus::TextField, Focus::Table, Focus::Dialog, Focus::Palette}) {
            for (const Way way : {Way::StopButton, Way::Escape, Way::Space, Way::Device}) {
                QTest::addRow("%s, focus in %s", kWays[static_cast<int>(way)],
                              kFocuses[static_cast<int>(focus)])
                    << way << focus;
            }
        }
    }
    void onlyTheStopButtonStopsAForeignProgram() {
        QFETCH(Way, way);
        QFETCH(Focus, focus);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());

        auto& search = bench.find<QLineEdit>("log.search");
        QDialog dialog(&bench.window);
        auto* layout = new QVBoxLayout(&dialog);
        auto* inDialog = new QLineEdit(&dialog);
        layout->addWidget(inDialog);
        QLineEdit* typed = nullptr;
        QPointer<QDialog> open;
        switch (focus) {
            case Focus::Window:
                bench.window.setFocus();
                break;
            case Focus::TextField:
                bench.window.showTab(QStringLiteral("log"));
                search.setFocus();
                typed = &search;
                break;
            case Focus::Table:
                bench.window.showTab(QStringLiteral("log"));
                bench.find<QWidget>("log.table").setFocus();
                break;
            case Focus::Dialog:
                open = &dialog;
                dialog.open();
                QVERIFY(QTest::qWaitForWindowActive(&dialog));
                inDialog->setFocus();
                typed = inDialog;
                break;
            case Focus::Palette:
                bench.window.actions().find("app.palette")->trigger();
                open = bench.window.findChild<QDialog*>("commandPalette");
                QVERIFY(open != nullptr);
                QVERIFY(QTest::qWaitForWindowActive(open));
                typed = open->findChild<QLineEdit*>();
                QVERIFY(typed != nullptr);
                break;
        }
        QVERIFY(bench.startMoving());
        const std::uint64_t stops = bench.state().lastStop.count;

        bench.stop(way);
        if (way == Way::Escape || way == Way::Space) {
            bench.cell.robot.drainSockets();
            bench.cell.advanceMs(500);
            QVERIFY2(bench.runs(), "a key of the focused control ended the program");
            QVERIFY(way == Way::Escape || typed == nullptr || typed->text() == QStringLiteral(" "));
            QTRY_VERIFY_WITH_TIMEOUT(way == Way::Space || open == nullptr || !open->isVisible(), 60'000);
            return;
        }
        QVERIFY2(bench.stopsAtOnce(), "the program did not stop");
        QVERIFY2(bench.comesToRest(), "the arm did not stop");
        QVERIFY(typed == nullptr || typed->text().isEmpty());
        QVERIFY(open == nullptr || open->isVisible());
        // The stopping distance is measured and displayed.
        QVERIFY(bench.within([&] { return bench.state().lastStop.count > stops; }));
        QCOMPARE(bench.state().lastStop.cause, StopCause::StopButton);
        QVERIFY(bench.state().lastStop.durationMs > 0);
        QVERIFY(bench.state().lastStop.distanceMm > 1);
        QCOMPARE(bench.find<StateChip>("lastStopChip").text().contains(QStringLiteral("ms")), true);
        QVERIFY2(bench.errors.isEmpty(), qPrintable(bench.errors.join('\n')));
    }

    // Space typed in a name must not end the program of the client that has taken control, regardless of the
    // time since then.
    void keysGoToTheFocusedWidgetAfterControlIsReplaced() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.session().takeControl(RobotSession::ForeignProgram::Stop);
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::InControl; }));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::None; }));
        bench.cell.advanceMs(5000);  // longer than the stop keys keep their stop function
        QVERIFY(!bench.state().keysStop());
        auto& search = bench.find<QLineEdit>("log.search");
        bench.window.showTab(QStringLiteral("log"));
        search.setFocus();
        QTest::keyClick(&search, Qt::Key_Space);
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY2(bench.runs(), "a space in a text field ended the program");
        QCOMPARE(search.text(), QStringLiteral(" "));
    }

    void aFocusedButtonIsPressedBySpace() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        auto& button = bench.find<QAbstractButton>("plots.pause");
        QVERIFY(button.isVisible());
        button.setFocus();
        const QString before = button.text();
        QTest::keyClick(&button, Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(button.text() != before, 60'000);
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY(bench.runs());
    }

    void theStopKeyShowsHowItStops() {
        Bench bench;
        const auto& stop = bench.find<StopButton>("stopButton");
        QVERIFY(!stop.keysStop());
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(!stop.keysStop());
        QVERIFY2(stop.toolTip().contains(QStringLiteral("Click")), qPrintable(stop.toolTip()));
        bench.window.session().takeControl(RobotSession::ForeignProgram::Stop);
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::InControl; }));
        QVERIFY(stop.keysStop());
        QVERIFY2(stop.toolTip().contains(QStringLiteral("Space and Esc also stop")),
                 qPrintable(stop.toolTip()));
        bench.window.session().releaseControl();
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::None; }));
        QVERIFY(!stop.keysStop());
    }

    void takingControlAsksForConfirmation_data() {
        QTest::addColumn<Path>("path");
        QTest::addColumn<bool>("paused");
        for (const bool paused : {false, true}) {
            for (const Path path : {Path::Header, Path::Command, Path::Recovery}) {
                QTest::addRow("%s, %s", kPaths[static_cast<int>(path)], paused ? "paused" : "running")
                    << path << paused;
            }
        }
    }
    void takingControlAsksForConfirmation() {
        QFETCH(Path, path);
        QFETCH(bool, paused);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        RecoveryPage* recovery = nullptr;
        if (path == Path::Recovery) {
            // The page is still open from an earlier stop.
            bench.window.actions().find("power.recover")->setEnabled(true);
            bench.window.actions().find("power.recover")->trigger();
            recovery = bench.window.findChild<RecoveryPage*>();
            QVERIFY(recovery != nullptr && QTest::qWaitForWindowActive(recovery));
        }
        QVERIFY(bench.startMoving());
        if (paused) {
            QVERIFY(bench.pendant->send(QStringLiteral("pause program\n"), testTimeout()).ok());
        }
        const RuntimeState before = paused ? RuntimeState::Paused : RuntimeState::Playing;
        QVERIFY(bench.within([&] { return bench.state().runtimeState == before; }));
        const auto take = [&] {
            switch (path) {
                case Path::Header:
                    QTest::mouseClick(&bench.find<QPushButton>("nextStepButton"), Qt::LeftButton);
                    break;
                case Path::Command:
                    bench.window.actions().find("control.take")->trigger();
                    break;
                case Path::Recovery:
                    recovery->findChild<QPushButton*>("recoveryKey")->click();
                    break;
            }
        };
        const auto question = [&]() -> QMessageBox* {
            for (QWidget* window : QApplication::topLevelWidgets()) {
                if (window->objectName() == QStringLiteral("takeControlQuestion") && window->isVisible()) {
                    return qobject_cast<QMessageBox*>(window);
                }
            }
            return nullptr;
        };
        // Return, Space and Esc all select No.
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space, Qt::Key_Escape}) {
            QVERIFY(bench.within([&] { return bench.find<QPushButton>("nextStepButton").isEnabled(); }));
            take();
            QVERIFY2(question() != nullptr, "control was taken without a question");
            QVERIFY2(
                question()->text().contains(paused ? QStringLiteral("paused") : QStringLiteral("running")),
                qPrintable(question()->text()));
            QVERIFY(QTest::qWaitForWindowActive(question()));
            QTest::keyClick(question()->focusWidget(), key);
            QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, 60'000);
            bench.cell.robot.drainSockets();
            bench.cell.advanceMs(500);
            QCOMPARE(bench.cell.truth().runtimeState, before);
            QCOMPARE(bench.state().control, ControlState::None);
            // The button in the header keeps its position for half a second of real time.
            QTest::qWait(600);
        }
        take();
        QVERIFY(question() != nullptr);
        question()->findChild<QPushButton*>("takeControlQuestion.take")->click();
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::InControl; }));
    }
    void poweringOffAsksWhileAnotherProgramRuns() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.within([&] { return bench.state().runtimeState == RuntimeState::Playing; }));
        const auto question = [&] { return bench.window.findChild<QMessageBox*>("powerOffQuestion"); };
        bench.window.actions().find("power.off")->trigger();
        QVERIFY2(question() != nullptr, "the arm was powered off without a question");
        QVERIFY(QTest::qWaitForWindowActive(question()));
        QTest::keyClick(question()->focusWidget(), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, 60'000);
        bench.cell.advanceMs(300);
        QCOMPARE(bench.cell.truth().runtimeState, RuntimeState::Playing);
        QCOMPARE(bench.cell.truth().robotMode, RobotMode::Running);
        bench.window.actions().find("power.off")->trigger();
        QVERIFY(question() != nullptr);
        question()->findChild<QPushButton*>("powerOffQuestion.take")->click();
        QVERIFY(bench.within([&] { return bench.cell.truth().robotMode == RobotMode::PowerOff; }));
    }
    // The command palette runs its first entry with Return. A typing error must not stop a production
    // program.
    void pausingResumingAndStoppingAnotherProgramAsks_data() {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("paused");
        QTest::addColumn<RuntimeState>("reached");
        QTest::addRow("pause") << "control.pause"
                               << "pauseQuestion" << false << RuntimeState::Paused;
        QTest::addRow("stop") << "control.stopProgram"
                              << "stopProgramQuestion" << false << RuntimeState::Stopped;
        QTest::addRow("stop, paused") << "control.stopProgram"
                                      << "stopProgramQuestion" << true << RuntimeState::Stopped;
        QTest::addRow("resume") << "control.play"
                                << "playQuestion" << true << RuntimeState::Playing;
    }
    void pausingResumingAndStoppingAnotherProgramAsks() {
        QFETCH(const QString, command);
        QFETCH(const QString, name);
        QFETCH(const bool, paused);
        QFETCH(const RuntimeState, reached);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.within([&] { return bench.state().runtimeState == RuntimeState::Playing; }));
        if (paused) {
            bench.window.session().services().perform(RobotCommand::Pause, true);
            QVERIFY(bench.within([&] { return bench.state().runtimeState == RuntimeState::Paused; }));
        }
        const RuntimeState before = bench.state().runtimeState;
        const auto question = [&] { return bench.window.findChild<QMessageBox*>(name); };
        bench.window.actions().find(command)->trigger();
        QVERIFY2(question() != nullptr, "the program was changed without a question");
        QVERIFY(QTest::qWaitForWindowActive(question()));
        QTest::keyClick(question()->focusWidget(), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, 60'000);
        bench.cell.advanceMs(300);
        QCOMPARE(bench.cell.truth().runtimeState, before);
        bench.window.actions().find(command)->trigger();
        QVERIFY(question() != nullptr);
        question()->findChild<QPushButton*>(name + ".take")->click();
        QVERIFY(bench.within([&] { return bench.cell.truth().runtimeState == reached; }));
    }
    void takingControlOfAnIdleRobotDoesNotAsk() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.actions().find("control.take")->trigger();
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::InControl; }));
    }

    // A dialog blocks the window behind it. STOP is still available at its normal position.
    void stopCanBeClickedWhileADialogIsOpen() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QDialog dialog(&bench.window);
        dialog.resize(200, 100);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QVERIFY(bench.startMoving());
        // Sends the click to the topmost window at this position, like the display server.
        const auto& stop = bench.find<StopButton>("stopButton");
        const QPoint place = stop.mapToGlobal(stop.rect().center());
        QWindow* under = nullptr;  // the most recently shown window is on top
        for (QWindow* each : QGuiApplication::topLevelWindows()) {
            under = each->isVisible() && each->geometry().contains(place) ? each : under;
        }
        QVERIFY(under != nullptr);
        QTest::mousePress(under, Qt::LeftButton, {}, under->mapFromGlobal(place));
        QTest::mouseRelease(under, Qt::LeftButton, {}, under->mapFromGlobal(place));
        QVERIFY2(bench.stopsAtOnce(), "the program did not stop");
        QVERIFY(bench.comesToRest());
        QVERIFY(dialog.isVisible() && dialog.isActiveWindow());
        // The button above the dialog covers STOP after every change of the layout. Otherwise, a part of STOP
        // would be visible but would not respond.
        const auto covers = [&] {
            const auto* above = bench.window.findChild<StopButton*>("stopAboveDialog");
            return above != nullptr && above->pos() == stop.mapToGlobal(QPoint(0, 0)) &&
                   above->size() == stop.size();
        };
        QVERIFY(covers());
        bench.window.resize(bench.window.width() + 150, bench.window.height());
        QTRY_VERIFY_WITH_TIMEOUT(covers(), 60'000);
        const_cast<StopButton&>(stop).setFixedSize(stop.width() - 40, stop.height());
        QTRY_VERIFY_WITH_TIMEOUT(covers(), 60'000);
        dialog.close();
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<StopButton*>("stopAboveDialog") == nullptr, 60'000);
    }

    // The dashboard accepts the connection and sends nothing while a query is in progress.
    void silentDashboardDoesNotDelayTheStop_data() {
        QTest::addColumn<Way>("way");
        for (const Way way : {Way::StopButton, Way::Device}) {
            QTest::newRow(kWays[static_cast<int>(way)]) << way;
        }
    }
    void silentDashboardDoesNotDelayTheStop() {
        QFETCH(Way, way);
        QTcpServer mute;
        Bench bench(withoutDashboard());
        QVERIFY(mute.listen(QHostAddress(bench.cell.robot.options().listenAddress), 29999 + 20'000));
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        QVERIFY(bench.startMoving());
        bench.stop(way);
        QVERIFY2(bench.stopsAtOnce(), "the program did not stop");
        QVERIFY(bench.comesToRest());
    }

    // A program started on the teach pendant is running. The operator cancels while control is being taken.
    void stopsWhileControlIsBeingTaken_data() {
        QTest::addColumn<Way>("way");
        QTest::addColumn<int>("afterMs");
        for (const int ms : {0, 2, 10, 30, 100}) {
            for (const Way way : {Way::StopButton, Way::Escape}) {
                QTest::addRow("%s after %d ms", kWays[static_cast<int>(way)], ms) << way << ms;
            }
        }
    }
    void stopsWhileControlIsBeingTaken() {
        QFETCH(Way, way);
        QFETCH(int, afterMs);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.window.session().takeControl(RobotSession::ForeignProgram::Stop);
        bench.cell.advanceMs(afterMs);
        bench.stop(way);
        QVERIFY(bench.within([&] { return standsStill(bench.cell); }));
        QVERIFY(bench.within([&] { return bench.state().control != ControlState::Taking; }));
        // In all cases, the arm must stop, and no program of another client may be running.
        QVERIFY(bench.within([&] {
            return bench.state().control == ControlState::InControl || !bench.state().foreignProgramRuns();
        }));
        bench.cell.advanceMs(500);
        QVERIFY(standsStill(bench.cell));
    }

    // The program of another client has just replaced the program of the window, and the window has not
    // detected it yet.
    void stopsDirectlyAfterATakeover() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.pendant = std::make_unique<script::ScriptClient>(bench.cell.robot.listenAddress());
        QVERIFY(bench.pendant->connect(testTimeout()).ok());
        QVERIFY(
            bench.pendant
                ->send(QStringLiteral("def others():\nwhile True:\nmovej([1.0, -1.7, -2.2, -0.8, 1.6, 0], "
                                      "a=2, v=1)\nmovej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                                      "sync()\nend\nend\n"),
                       testTimeout())
                .ok());
        QElapsedTimer real;
        real.start();
        while (tcpSpeed(bench.cell) < 0.05 && real.elapsed() < kForeignTimeoutMs) {
            bench.cell.robot.drainSockets();
            bench.cell.advanceMs(2);
        }
        QVERIFY(tcpSpeed(bench.cell) >= 0.05);
        QCOMPARE(bench.state().control, ControlState::InControl);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return bench.state().control != ControlState::InControl; }));
        QVERIFY(bench.within([&] { return !bench.runs() && standsStill(bench.cell); }));
    }

    void programAtStandstillIsStoppedToo() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startProgram("sleep(0.1)\n"));
        bench.stop(Way::StopButton);
        QVERIFY(bench.stopsAtOnce());
        QVERIFY(bench.comesToRest());
    }

    void aPausedProgramIsEndedByStopAlone() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.pendant->send(QStringLiteral("pause program\n"), testTimeout()).ok());
        const auto paused = [&] { return bench.state().runtimeState == RuntimeState::Paused; };
        QVERIFY(bench.within(paused));
        bench.cell.advanceMs(1100);
        bench.stop(Way::Escape);
        bench.stop(Way::Space);
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY(paused());
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return bench.state().runtimeState == RuntimeState::Stopped; }));
    }

    // An unnecessary stop would end a program that is started immediately afterwards.
    void nothingIsSentWhenNothingRuns() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        bench.window.devices().use(bench.window.devices().devices().front().get());
        for (const Way way : {Way::StopButton, Way::Escape, Way::Space, Way::Device}) {
            bench.stop(way);
        }
        QVERIFY(bench.startMoving());
        bench.cell.advanceMs(3000);
        QVERIFY(bench.runs());
        QVERIFY2(bench.errors.isEmpty(), qPrintable(bench.errors.join('\n')));
    }

    // All other stops apply only to the window's own motions.
    void changingTheTabStopsNoForeignProgram() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.window.showTab(QStringLiteral("log"));
        bench.window.showTab(QStringLiteral("io"));
        bench.cell.robot.drainSockets();
        bench.cell.advanceMs(500);
        QVERIFY(bench.runs());
    }

    void eachChangeDuringAForeignProgramNeedsConfirmation() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        const auto question = [&] { return bench.window.findChild<QMessageBox*>("changeQuestion"); };
        const auto isOn = [&](int output) { return (bench.cell.truth().digitalOutputs >> output & 1U) != 0; };
        RobotSession& session = bench.window.session();
        const auto set = [&session](int output) {
            const auto change = [&session, output] { session.outputs().setDigitalOutput(output, true); };
            if (!session.asksBeforeChange(QStringLiteral("DO %1").arg(output), change)) {
                change();
            }
        };
        for (const int output : {1, 2}) {
            set(output);
            QVERIFY2(question() != nullptr, qPrintable(QString::number(output)));
            const bool last = output == 2;
            question()->findChild<QCheckBox*>("changeQuestion.option")->setChecked(last);
            question()->findChild<QPushButton*>("changeQuestion.take")->click();
            QVERIFY(bench.within([&] { return isOn(output) && question() == nullptr; }));
        }
        set(3);
        QVERIFY(question() == nullptr);
        QVERIFY(bench.within([&] { return isOn(3); }));
        QVERIFY(bench.runs());
        // The confirmation does not apply to a program that replaces the confirmed program without a stop.
        QVERIFY(
            bench.pendant->send("def second():\nwhile True:\nsync()\nend\nend\n", Deadline::never()).ok());
        QVERIFY(bench.within([&] { return bench.state().runningProgram == QLatin1String("second"); }));
        set(4);
        QVERIFY(question() != nullptr);
        QVERIFY2(question()->text().contains("second"), qPrintable(question()->text()));
        QVERIFY(!isOn(4));
    }

    // The loaded program may be stopped while another program is running.
    void questionsNameTheRunningProgram() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.within([&] { return bench.state().runningProgram == QLatin1String("others"); }));
        bench.window.actions().find("control.take")->trigger();
        const auto* question = bench.window.findChild<QMessageBox*>("takeControlQuestion");
        QVERIFY(question != nullptr);
        QVERIFY2(question->text().contains(QStringLiteral("“others”")), qPrintable(question->text()));
    }

    // An outdated answer would stop another program, or the program of another robot.
    void questionsCloseWithTheirProgram_data() {
        QTest::addColumn<QString>("change");
        QTest::newRow("ended") << QStringLiteral("stop program\n");
        QTest::newRow("paused") << QStringLiteral("pause program\n");
        QTest::newRow("replaced") << QStringLiteral("def second():\nwhile True:\nsync()\nend\nend\n");
        QTest::newRow("disconnected") << QString();
    }
    void questionsCloseWithTheirProgram() {
        QFETCH(const QString, change);
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        QVERIFY(bench.within([&] { return bench.state().runningProgram == QLatin1String("others"); }));
        bench.window.actions().find("control.take")->trigger();
        const QPointer<QMessageBox> question = bench.window.findChild<QMessageBox*>("takeControlQuestion");
        QVERIFY(question != nullptr);
        bench.cell.advanceMs(500);
        QVERIFY2(question != nullptr && question->isVisible(),
                 "the question closed while its program was running");
        if (change.isEmpty()) {
            bench.window.session().disconnectFromRobot();
        } else {
            QVERIFY(bench.pendant->send(change, Deadline::never()).ok());
        }
        QVERIFY(bench.within([&] { return question == nullptr || !question->isVisible(); }));
        QVERIFY(bench.state().control != ControlState::InControl);
    }

    // A question about a program without a name must not become a question about another program.
    void aQuestionStaysAboutItsProgram() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        // The robot reports the name of a program only at its start.
        RobotSession& session = bench.window.session();
        session.connectTo(RobotAddress(session.address()));
        QVERIFY(bench.within([&] { return bench.state().foreignProgramRuns(); }));
        QVERIFY2(bench.state().runningProgram.isEmpty(), qPrintable(bench.state().runningProgram));
        bench.window.actions().find("control.take")->trigger();
        const QPointer<QMessageBox> question = bench.window.findChild<QMessageBox*>("takeControlQuestion");
        QVERIFY(question != nullptr);
        const QString text = question->text();
        bench.cell.advanceMs(500);
        QVERIFY(question != nullptr && question->isVisible());
        QVERIFY(
            bench.pendant->send("def second():\nwhile True:\nsync()\nend\nend\n", Deadline::never()).ok());
        QVERIFY(bench.within(
            [&] { return question == nullptr || !question->isVisible() || question->text() != text; }));
        QVERIFY2(question == nullptr || !question->isVisible(), qPrintable(question->text()));
    }

    void questionsCloseWithTheConnection() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        RobotSession& session = bench.window.session();
        session.recording().start(bench.folder.filePath("running.csv"));
        QVERIFY(bench.within([&] { return session.state().recording.active; }));
        QVERIFY(!bench.window.close());
        const QPointer<QMessageBox> question = bench.window.findChild<QMessageBox*>("endQuestion");
        QVERIFY(question != nullptr);
        bench.cell.advanceMs(200);
        QVERIFY(question != nullptr && question->isVisible());
        session.connectTo({QStringLiteral("other"), bench.cell.robot.listenAddress(), 0, true});
        QTRY_VERIFY_WITH_TIMEOUT(question == nullptr || !question->isVisible(), 60'000);
        QVERIFY(bench.window.isVisible());
    }

    void aRobotInLocalControlIsReported() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.gateLocalControl = true;
        options.gateLoopbackClients = true;
        Bench bench(options);
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.startMoving());
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(100);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return !bench.errors.isEmpty(); }));
        QVERIFY2(bench.errors.first().contains(QStringLiteral("teach pendant")),
                 qPrintable(bench.errors.first()));
        QVERIFY(bench.runs());
        // After remote control is enabled again, the connections work.
        bench.cell.robot.setRemoteControl(true);
        bench.cell.advanceMs(100);
        bench.stop(Way::StopButton);
        QVERIFY(bench.within([&] { return !bench.runs(); }));
    }
};

QTEST_MAIN(TestForeignStop)
#include "tst_foreign_stop.moc"
