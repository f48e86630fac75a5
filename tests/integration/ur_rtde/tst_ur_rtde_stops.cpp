// SPDX-License-Identifier: MIT
// Stops of RTDEControlInterface. Any motion must be stopped, even if a thread is late, if a stop follows
// immediately, or if other threads wait.
#include <ur_rtde/dashboard_client.h>
#include <ur_rtde/rtde_control_interface.h>

#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <future>

#include "robot/ur_rtde/detail/waiting.h"
#include "tests/support/ur_rtde_control_test.h"

using namespace tiller;
using namespace tiller::test;

class TestUrRtdeStops : public UrRtdeControlTest {
    Q_OBJECT

private Q_SLOTS:
    void stopsEndAnAsynchronousMove() {
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        control_->stopJ(2.0);
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
        QVERIFY(control_->moveL(with(pose(), 2, 0.3), 0.05, 0.5, true));
        QVERIFY(untilMoving());
        control_->stopL(5.0, true);
        QVERIFY(control_->moveJ(kStart));  // must not return before the end of the stop
        QVERIFY(near(joints(), kStart));
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        control_->stopJ(2.0, true);
        control_->stopJ(4.0, true);
        QVERIFY(untilStanding());
        QVERIFY(control_->moveJ(kStart));
        QVERIFY(near(joints(), kStart));
    }

    // Simulates Ctrl+C in Python while the connection is blocked: the program receives the stop directly
    // after the move, without an idle command in between.
    void aStopImmediatelyAfterAMoveIsObeyed() {
        static std::atomic<bool> impatient;
        impatient = false;
        urrtde::setInterruptCheck([] { return impatient.load(); });
        const auto undo = qScopeGuard([] { urrtde::setInterruptCheck(nullptr); });
        auto waiting =
            std::async(std::launch::async, [&] { return control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4); });
        QVERIFY(untilMoving());
        cell_->freeze(true);
        impatient = true;
        QVERIFY_EXCEPTION_THROWN(waiting.get(), urrtde::Interrupted);
        impatient = false;
        cell_->freeze(false);
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
        QVERIFY(control_->moveJ(kStart));
        QVERIFY(near(joints(), kStart));
    }

    // The move starts only after the previous move has been stopped. A reply to a move must not be
    // interpreted as the reply to the stop.
    void aStopAfterAReplacedMoveIsNotLost() {
        static std::atomic<bool> impatient;
        for (const bool interrupted : {false, true}) {
            impatient = false;
            urrtde::setInterruptCheck([] { return impatient.load(); });
            const auto undo = qScopeGuard([] { urrtde::setInterruptCheck(nullptr); });
            QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 1.0, 1.4, true));
            QVERIFY(cell_->until(
                [](const simulator::SimulatedState& t) { return t.q.array()[0] > kStart[0] + 0.4; }));
            auto turning = std::async(
                std::launch::async, [&] { return control_->moveJ(with(kStart, 0, -1.0), 0.02, 1.4, true); });
            bool ended = false;
            if (interrupted) {
                impatient = true;
                try {
                    turning.get();
                } catch (const urrtde::Interrupted&) {
                    ended = true;
                }
                impatient = false;
            } else {
                // The stop must be sent after the change of direction. If it were sent earlier, the arm would
                // still change direction, which is a different test.
                QVERIFY(
                    cell_->until([](const simulator::SimulatedState& t) { return t.qd.array()[0] < 0.98; }));
            }
            if (!ended) {
                control_->stopJ(4.0);
            }
            QVERIFY(untilStanding());
            QVERIFY(joints()[0] > kStart[0] - 0.9);
            if (!interrupted) {
                turning.get();
            }
            QVERIFY(untilStanding());
            QVERIFY(control_->moveJ(kStart));
            QVERIFY(near(joints(), kStart));
        }
    }

    // A command that waits for standstill reads its values afterwards. The values must not be overwritten in
    // the meantime.
    void obsoleteSetpointIsNotFollowed() {
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 1.0, 1.4, true));
        QVERIFY(cell_->until(
            [](const simulator::SimulatedState& t) { return t.q.array()[0] > kStart[0] + 0.4; }));
        QVERIFY(control_->servoJ(with(kStart, 0, 0.5), 0.5, 0.5, 0.002, 0.1, 300));
        control_->servoStop(10.0);
        QVERIFY(untilStanding());
        QCOMPARE(cell_->robot.truth().safetyMode, SafetyMode::Normal);
        QVERIFY(control_->moveJ(kStart));
        QVERIFY(near(joints(), kStart));
    }

    void aPausedProgramObeysAStopWhenItResumes() {
        ur_rtde::DashboardClient pendant(cell_->host());
        pendant.connect();
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        pendant.pause();
        QVERIFY(untilStanding());
        control_->stopJ(2.0);
        pendant.play();
        QVERIFY(cell_->until([&](const simulator::SimulatedState&) { return control_->isProgramRunning(); }));
        QVERIFY(cell_->pass(1));
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
        QVERIFY(control_->moveJ(kStart));
        QVERIFY(near(joints(), kStart));
    }

    void aProgramStopMayFollowAStopImmediately() {
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.5, 1.4, true));
        QVERIFY(untilMoving());
        control_->stopJ(1.0, true);
        control_->stopScript();
        QVERIFY(untilStanding());
        QVERIFY(!control_->isProgramRunning());
        QVERIFY(control_->reuploadScript());
        QVERIFY(control_->moveJ(kStart));
    }

    void interruptedCustomScriptIsNotWaitedFor() {
        static std::atomic<bool> impatient;
        impatient = false;
        urrtde::setInterruptCheck([] { return impatient.load(); });
        const auto undo = qScopeGuard([] { urrtde::setInterruptCheck(nullptr); });
        auto waiting = std::async(std::launch::async, [&] {
            return control_->sendCustomScript("def slow():\n  movej([0, -1.57, 0, 0, 0, 0], v=0.01)\nend\n");
        });
        QVERIFY(untilMoving());
        impatient = true;
        QVERIFY_EXCEPTION_THROWN(waiting.get(), urrtde::Interrupted);
        impatient = false;
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
        QVERIFY(control_->isProgramRunning());  // the control program is running again
        QVERIFY(control_->moveJ(kStart));
    }

    // Errors at run time and at compile time. The message of the controller contains the line of the program.
    void runtimeErrorOfAScriptIsReportedWithItsLine() {
        QVERIFY(!control_->sendCustomScript("def late():\n  sync()\n  a = [1, 2]\n  b = a[7]\nend\n"));
        const std::string late = control_->lastError();
        QVERIFY2(late.find("line 4") != std::string::npos, late.c_str());
        QVERIFY(!control_->sendCustomScript("def never():\n  sync()\n  b = = 7\nend\n"));
        const std::string never = control_->lastError();
        QVERIFY2(never.find("line 3") != std::string::npos, never.c_str());
        QVERIFY2(never.find("on_line:3:") != std::string::npos, never.c_str());
        QVERIFY(control_->isProgramRunning());
        QVERIFY(control_->moveJ(kStart));
    }

    void stopInterruptsAMoveThatAnotherThreadWaitsFor() {
        auto waiting =
            std::async(std::launch::async, [&] { return control_->moveJ(with(kStart, 0, 1.0), 0.02, 1.4); });
        QVERIFY(untilMoving());
        control_->stopJ(4.0);
        QVERIFY(!waiting.get());
        QVERIFY(untilStanding());
        QVERIFY(joints()[0] < kStart[0] + 0.9);
        QVERIFY(control_->moveJ(kStart));
    }

    void aStopInterruptsACustomScript() {
        const auto slow = [&] {
            return std::async(std::launch::async, [&] {
                return control_->sendCustomScript(
                    "def slow():\n  movej([0, -1.57, 0, 0, 0, 0], v=0.01)\nend\n");
            });
        };
        auto first = slow();
        QVERIFY(untilMoving());
        control_->stopJ(4.0);
        QVERIFY(!first.get());
        QVERIFY(untilStanding());
        QVERIFY(control_->moveJ(kStart));  // the control program is running again
        auto second = slow();
        QVERIFY(untilMoving());
        control_->stopScript();
        QVERIFY(!second.get());
        QVERIFY(untilStanding());
        QVERIFY(!control_->isProgramRunning());
    }

    // The reader and the writers detect the loss at the same time, so that ThreadSanitizer can find a race.
    void aLinkMayBreakWhileSetPointsAreSent_data() {
        QTest::addColumn<bool>("custom");
        QTest::newRow("our program") << false;
        QTest::newRow("a program of the user's") << true;
    }
    void aLinkMayBreakWhileSetPointsAreSent() {
        QFETCH(bool, custom);
        QTemporaryDir folder;
        if (custom) {
            const std::string file = folder.filePath("custom.script").toStdString();
            std::ofstream(file) << "  O = 0\n  while read_input_integer_register(O) != 255:\n"
                                   "    write_output_integer_register(O, 1)\n    sync()\n  end\n";
            control_->setCustomScriptFile(file);
        }
        for (int i = 0; i < 5; ++i) {
            std::atomic<bool> over{false};
            std::thread streaming([&] {
                while (!over) {
                    control_->speedJ({0, 0, 0, 0, 0, 0.05}, 1.0);
                }
            });
            QVERIFY(cell_->pass(0.05));
            cell_->robot.closeClients();
            QVERIFY(cell_->until([&](const simulator::SimulatedState&) { return !control_->isConnected(); }));
            over = true;
            streaming.join();
            QVERIFY(!control_->speedJ({0, 0, 0, 0, 0, 0.05}, 1.0));
            QVERIFY(untilStanding());
            QVERIFY(control_->reconnect());
        }
    }

    // A loop that ignores return values must not restart the motion.
    void setpointsDoNotResumeAMotionEndedByAPause() {
        ur_rtde::DashboardClient pendant(cell_->host());
        pendant.connect();
        const auto turn = [&] { return control_->speedJ({0, 0, 0, 0, 0, 0.2}, 2.0); };
        QVERIFY(turn());
        QVERIFY(untilMoving());
        pendant.pause();
        QVERIFY(untilStanding());
        pendant.play();
        QVERIFY(cell_->until([&](const simulator::SimulatedState&) { return control_->isProgramRunning(); }));
        for (int i = 0; i < 20; ++i) {
            QVERIFY(!turn());
            QVERIFY(cell_->pass(0.01));
        }
        QVERIFY(stands(cell_->robot.truth()));
        QVERIFY(!control_->lastError().empty());
        QVERIFY(control_->speedStop());
        QVERIFY(turn());
        QVERIFY(untilMoving());
        QVERIFY(control_->speedStop());
    }

    // A loop that reads the progress of an asynchronous motion must end when the motion ends for any reason.
    void theProgressEndsWithTheProgramOrTheLink_data() {
        QTest::addColumn<int>("end");
        QTest::newRow("protective stop") << 0;
        QTest::newRow("dashboard stop") << 1;
        QTest::newRow("link") << 2;
    }
    void theProgressEndsWithTheProgramOrTheLink() {
        QFETCH(int, end);
        QVERIFY(control_->moveJ(with(kStart, 0, 1.0), 0.05, 1.4, true));
        QVERIFY(untilMoving());
        QVERIFY(control_->getAsyncOperationProgress() >= 0);
        if (end == 0) {
            cell_->robot.protectiveStop();
        } else if (end == 1) {
            ur_rtde::DashboardClient pendant(cell_->host());
            pendant.connect();
            pendant.stop();
        } else {
            cell_->robot.closeClients();
        }
        QVERIFY(cell_->until(
            [&](const simulator::SimulatedState&) { return control_->getAsyncOperationProgress() < 0; }));
        QVERIFY(!control_->getAsyncOperationProgressEx().isAsyncOperationRunning());
        QVERIFY(
            cell_->until([&](const simulator::SimulatedState&) { return !control_->isProgramRunning(); }));
        QVERIFY(!control_->moveJ(kStart));
        QVERIFY(!control_->lastError().empty());
    }

    void kickDoesNotAffectTheMoveOfAnotherThread() {
        std::atomic<bool> done{false};
        std::thread kicker([&] {
            while (!done) {
                control_->kickWatchdog();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        });
        const bool moved = control_->moveJ(with(kStart, 0, 0.5));
        done = true;
        kicker.join();
        QVERIFY(moved);
        QVERIFY(near(joints(), with(kStart, 0, 0.5)));
    }
};

QTEST_GUILESS_MAIN(TestUrRtdeStops)
#include "tst_ur_rtde_stops.moc"
