// SPDX-License-Identifier: MIT
// How a session classifies the program that runs on the robot: a program of another client, Tiller's program,
// or the control program of a client that has exited.
#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <future>

#include "robot/control/programs.h"
#include "robot/core/deadline.h"
#include "robot/rtde/connection.h"
#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

constexpr int kTimeoutMs = 60'000;

struct ProgramBench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell{clock, session};
    int questions = 0;
    std::unique_ptr<script::ScriptClient> other;

    ProgramBench() {
        QObject::connect(&session, &RobotSession::takeControlQuestion, &session, [this] { ++questions; });
    }
    const SessionState& state() const { return session.state(); }
    bool runs() const { return cell.truth().runtimeState == RuntimeState::Playing; }
    bool moves() const {
        return cell.truth().tcpSpeed.linear.norm() > 0.05 ||
               cell.truth().qd.values.cwiseAbs().maxCoeff() > 0.05;
    }
    bool isInControl() const { return state().control == ControlState::InControl; }
    std::vector<JournalEvent> messagesAbout(const QString& part) const {
        std::vector<JournalEvent> found = session.journal().events();
        std::erase_if(found, [&](const JournalEvent& event) { return !event.text.contains(part); });
        return found;
    }

    /// Advances robot and session until the condition is true. The timeout is measured in real time, because
    /// another client is involved.
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kTimeoutMs) {
            cell.robot.drainSockets();
            cell.advanceMs(2);
        }
        return condition();
    }
    /// Like within(), but while no data arrive. The virtual cell itself would wait for data.
    bool withoutData(const std::function<bool()>& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kTimeoutMs) {
            clock.advanceNs(20 * kNsPerMs);
            for (int ms = 0; ms < 20; ms += 2) {
                cell.robot.step();
            }
            cell.robot.drainSockets();
            QTest::qWait(2);
            session.refresh();
        }
        return condition();
    }
    bool send(const QString& program) {
        other = std::make_unique<script::ScriptClient>(
            cell.robot.listenAddress(), script::kPrimaryPort + cell.robot.options().portOffset);
        const Deadline deadline = Deadline::after(std::chrono::milliseconds(kTimeoutMs));
        return other->connect(deadline).ok() && other->send(program, deadline).ok();
    }
    /// Sends a program of another client that rotates the base back and forth.
    bool sendMovingProgram() {
        return send(
            QStringLiteral("def others():\nwhile True:\n"
                           "movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                           "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\nsync()\nend\nend\n"));
    }
    /// Starts a control program without a client, as left by a killed process, and waits until the session
    /// has recognized it.
    bool abandonProgram() {
        return send(control::Programs::controlProgram(cell.robot.options().software,
                                                      control::RegisterRange::Upper)) &&
               within([this] { return runs() && state().hasForeignProgram(); }) &&
               cell.advanceUntil([this] { return !state().hasForeignProgram(); }, 1000) && runs();
    }
    void press(int times, int everyMs) {
        for (int i = 0; i < times && runs(); ++i) {
            session.stop(i % 2 == 0 ? StopCause::Space : StopCause::Escape);
            cell.robot.drainSockets();
            cell.advanceMs(everyMs);
        }
    }
};

}  // namespace

class TestForeignProgram : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // The other client claims the registers while its program runs.
    void aRefusalEndsWithTheProgramOfTheOtherClient() {
        ProgramBench bench;
        const EventSpy messages(bench.session.journal());
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        rtde::ConnectionOptions options;
        options.host = bench.cell.robot.listenAddress();
        options.port = static_cast<std::uint16_t>(bench.cell.robot.ports().rtde);
        options.request.inputs = {{{"input_int_register_24", "input_double_register_24"}, true}};
        auto opening = std::async(std::launch::async, [&options] {
            return rtde::Connection::open(options, Deadline::after(std::chrono::milliseconds(kTimeoutMs)));
        });
        QVERIFY(bench.within(
            [&] { return opening.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
        auto rival = opening.get();
        QVERIFY2(rival.ok(), qPrintable(rival ? QString() : rival.error().toString()));
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.state().hasForeignProgram(); }));
        bench.session.takeControl(RobotSession::ForeignProgram::Stop);
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::Refused; }));
        const QString reason = bench.state().controlReason;
        QVERIFY2(reason.startsWith("Registers in use") && reason.contains("Close the other program"),
                 qPrintable(reason));
        QVERIFY2(!reason.contains("input_int_register") && !reason.contains("upper"), qPrintable(reason));
        QVERIFY(std::any_of(messages.begin(), messages.end(), [&](const JournalEvent& event) {
            return event.text == reason && event.detail.contains(QLatin1String("upper"));
        }));
        rival = Error{ErrorCode::Cancelled, {}, {}};
        QVERIFY(bench.send(QStringLiteral("stop program\n")));
        QVERIFY(bench.within([&] { return bench.state().control == ControlState::None; }));
    }

    void changesDuringAProgramOfAnotherClientNeedConfirmation() {
        ProgramBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const auto change = [] {};
        QVERIFY2(bench.sendMovingProgram() && bench.within([&] { return bench.state().moving; }),
                 "the program is not running");
        QVERIFY2(!bench.session.asksBeforeChange("DO 3", change),
                 "confirmation is required although nothing can show the question");
        QStringList asked;
        QObject::connect(&bench.session, &RobotSession::changeQuestion, &bench.session,
                         [&](const QString& what) { asked << what; });
        QVERIFY(bench.session.asksBeforeChange("DO 3", change));
        QCOMPARE(asked, QStringList{"DO 3"});
        bench.session.confirmChanges();
        QVERIFY(!bench.session.asksBeforeChange("DO 4", change));
        bench.session.confirmChanges(false);
        QVERIFY(bench.session.asksBeforeChange("DO 4", change));
        bench.session.confirmChanges();
        QVERIFY(bench.cell.robot.inject("script-error").ok());
        QVERIFY(bench.within([&] { return !bench.state().hasForeignProgram(); }));
        QVERIFY2(!bench.session.asksBeforeChange("DO 4", change),
                 "confirmation is required although no program is running");
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.state().moving; }));
        QVERIFY(bench.session.asksBeforeChange("DO 5", change));
        QCOMPARE(asked.size(), 3);
    }

    void aStopThatFailsDuringAnOutageIsNotExecutedLater() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        ProgramBench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.moves(); }));
        QVERIFY(bench.cell.robot.inject("link lost").ok());
        QVERIFY(bench.withoutData([&] { return bench.state().link == LinkState::Lost; }));
        bench.session.stop(StopCause::StopButton);
        QVERIFY2(!messages.filter("may not reach the robot").isEmpty(),
                 "the failure is not reported immediately");
        QVERIFY(bench.withoutData([&] { return !messages.filter("could not be stopped").isEmpty(); }));
        QVERIFY(bench.runs());
        // Wait until the threads that expect replies have reset their connections.
        int turns = 0;
        QVERIFY(bench.withoutData([&] { return ++turns > 500; }));
        QVERIFY(bench.cell.robot.inject("link back").ok());
        QVERIFY(bench.within([&] { return bench.state().link == LinkState::Live; }));
        for (int i = 0; i < 200; ++i) {
            bench.cell.robot.drainSockets();
            bench.cell.advanceMs(10);
            QVERIFY2(bench.runs(), "the stop was delivered after the outage");
        }
    }

    void theLogNamesProgramsOfOtherClients() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        ProgramBench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.moves(); }));
        QVERIFY(bench.within([&] { return messages.filter("another client is running").size() == 1; }));
        bench.session.takeControl(RobotSession::ForeignProgram::Stop);
        QCOMPARE(messages.filter("Stopping the other client's program").size(), 1);
        QVERIFY(bench.within([&] { return bench.isInControl(); }));
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.within([&] { return messages.filter("taken over").size() == 1; }));
        QVERIFY2(bench.state().controlReason.contains("taken over"), qPrintable(bench.state().controlReason));
        QCOMPARE(messages.filter("another client is running").size(), 1);
        // A program that starts later has not taken over control from Tiller.
        QVERIFY(bench.send(QStringLiteral("stop program\n")) &&
                bench.within([&] { return !bench.state().foreignProgramRuns(); }));
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.within([&] { return messages.filter("another client is running").size() == 2; }));
        QCOMPARE(messages.filter("taken over").size(), 1);
    }

    /// The control program has been replaced while its connection still exists.
    void aTakeoverIsLoggedWithinHalfASecondWithItsTime() {
        std::vector<JournalEvent> takeovers;  // outlives the session, which reports its end in the destructor
        ProgramBench bench;
        bench.session.journal().setWallClock([&] { return bench.clock.nowNs(); });
        QObject::connect(&bench.session.journal(), &Journal::added, &bench.session,
                         [&](const JournalEvent& event) {
                             if (event.text.contains("another client") || event.text.contains("has ended")) {
                                 takeovers.push_back(event);
                             }
                         });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(2000);
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.moves(); }));
        const std::int64_t movesNs = bench.clock.nowNs();
        QVERIFY(bench.within([&] { return bench.state().controlLoss == control::ControlLoss::EchoStalled; }));
        const std::int64_t lostNs = bench.clock.nowNs();
        QVERIFY(bench.within([&] { return !takeovers.empty(); }));
        QVERIFY2(takeovers[0].text.contains("taken over"), qPrintable(takeovers[0].text));
        const auto late = [](std::int64_t ns) { return QStringLiteral("%1 ms").arg(ns / kNsPerMs).toUtf8(); };
        const std::int64_t recognizedNs = bench.clock.nowNs() - lostNs;
        QVERIFY2(recognizedNs <= 500 * kNsPerMs, late(recognizedNs).constData());
        const std::int64_t errorNs = takeovers[0].utcNs - movesNs;
        QVERIFY2(std::abs(errorNs) <= 300 * kNsPerMs, late(errorNs).constData());
        // A connection that is lost now is not another takeover, and the program continues.
        QVERIFY(bench.cell.robot.inject("half-open").ok());
        QVERIFY(
            bench.withoutData([&] { return bench.state().controlLoss == control::ControlLoss::LinkLost; }));
        QVERIFY(bench.withoutData([&] { return bench.state().isFresh(); }));
        bench.cell.advanceMs(20'000);
        QCOMPARE(takeovers.size(), std::size_t(1));
    }

    void theLogNamesAProgramThatReplacesAnother() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        ProgramBench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.moves(); }));
        QVERIFY(bench.within([&] { return messages.filter("another client is running").size() == 1; }));
        bench.cell.advanceMs(2000);
        QCOMPARE(messages.filter("replaced").size(), 0);
        QVERIFY(bench.send(QStringLiteral("def second():\n  while True:\n    sync()\n  end\nend\n")));
        QVERIFY(bench.within([&] { return messages.filter("replaced").size() == 1; }));
        QCOMPARE(messages.filter("has ended").size(), 0);
    }

    /// The session confirms the end with a delay. The log must show the time of the end itself.
    void theEndOfAProgramIsLoggedWithItsTime() {
        std::vector<JournalEvent> ends;
        ProgramBench bench;
        bench.session.journal().setWallClock([&] { return bench.clock.nowNs(); });
        QObject::connect(&bench.session.journal(), &Journal::added, &bench.session,
                         [&](const JournalEvent& event) {
                             if (event.text.contains("other client has ended")) {
                                 ends.push_back(event);
                             }
                         });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.send(QStringLiteral("def cycle():\nsleep(0.5)\nend\n")));
        QVERIFY(bench.within([&] { return bench.state().foreignProgramRuns(); }));
        QVERIFY(bench.within([&] { return !bench.runs(); }));
        const std::int64_t endNs = bench.clock.nowNs();
        const double endSeconds = bench.state().robotTime;
        QVERIFY(bench.within([&] { return !ends.empty(); }));
        constexpr std::int64_t kToleranceNs = 100 * kNsPerMs;
        QVERIFY2(std::abs(ends[0].utcNs - endNs) <= kToleranceNs,
                 qPrintable(QStringLiteral("%1 ms late").arg((ends[0].utcNs - endNs) / kNsPerMs)));
        QVERIFY(std::abs(ends[0].controllerSeconds.value() - endSeconds) <= 0.1);
    }

    void theLogNamesTheEndOfProgramsOfOtherClients() {
        QStringList messages;  // outlives the session, which reports its end
        ProgramBench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        const auto ends = [&] { return messages.filter("other client has ended").size(); };
        // Short programs, one per cycle.
        for (int cycle = 0; cycle < 3; ++cycle) {
            QVERIFY(bench.send(QStringLiteral("def cycle():\nsleep(0.2)\nend\n")));
            QVERIFY(bench.within([&] { return bench.runs(); }));
            QVERIFY(bench.within([&] { return !bench.runs(); }));
        }
        QCOMPARE(ends(), 0);
        QVERIFY(bench.within([&] { return ends() == 1; }));
        QVERIFY(bench.sendMovingProgram() && bench.within([&] { return bench.state().moving; }));
        QVERIFY(bench.cell.robot.inject("power-loss").ok());
        QVERIFY(bench.within([&] { return ends() == 2; }));
        QCOMPARE(messages.filter("Robot mode: ").size(), 1);
        bench.cell.advanceMs(5000);
        QCOMPARE(ends(), 2);
    }

    void aProgramStartedDuringAnOutageIsLoggedWithinASecond() {
        ProgramBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.cell.robot.inject("half-open").ok());
        QVERIFY(
            bench.withoutData([&] { return bench.state().controlLoss == control::ControlLoss::LinkLost; }));
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.withoutData([&] { return bench.moves(); }));
        QVERIFY(bench.withoutData([&] { return bench.state().isFresh(); }));
        QCOMPARE(bench.messagesAbout("another client").size(), 0U);
        QVERIFY(bench.cell.advanceUntil(
            [&] { return bench.messagesAbout("another client is running").size() == 1; }, 1000));
        const JournalEvent event = bench.messagesAbout("another client is running").front();
        QVERIFY2(event.detail.contains("at most"), qPrintable(event.detail));
        QVERIFY2(bench.state().keysStop(), "the stop keys lose their function too early");
        bench.cell.advanceMs(16'000);
        QCOMPARE(bench.messagesAbout("another client").size(), 1U);
    }

    void aProgramStartedAfterAnOutageIsLoggedAtOnce() {
        ProgramBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.cell.robot.inject("half-open").ok());
        QVERIFY(
            bench.withoutData([&] { return bench.state().controlLoss == control::ControlLoss::LinkLost; }));
        QVERIFY(bench.withoutData([&] { return bench.state().isFresh(); }));
        // Until the control program has ended, it is not reported as a program of another client.
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.runs(); }, 5500));
        bench.cell.advanceMs(100);
        QVERIFY(bench.state().controlInDoubt);
        QCOMPARE(bench.messagesAbout("another client").size(), 0U);
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.within([&] { return bench.runs(); }));
        bench.cell.advanceMs(100);
        QCOMPARE(bench.messagesAbout("another client is running").size(), 1U);
        QVERIFY(bench.messagesAbout("another client is running").front().detail.isEmpty());
    }

    // The control program of a killed process continues to run at standstill for five seconds.
    void anAbandonedProgramIsReplacedWithoutConfirmation() {
        ProgramBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.abandonProgram());
        QVERIFY(bench.state().programAbandoned);
        bench.session.takeControl();
        QCOMPARE(bench.questions, 0);
        QVERIFY(bench.within([&] { return bench.isInControl(); }));
        QVERIFY(!bench.state().programAbandoned);
    }

    // The register of the abandoned program keeps its last value.
    void aProgramAfterAnAbandonedOneNeedsConfirmation() {
        ProgramBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.abandonProgram());
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.within([&] { return bench.moves(); }));
        bench.cell.advanceMs(60);
        for (int i = 0; i < 30; ++i) {
            QVERIFY(bench.state().hasForeignProgram());
            bench.session.takeControl();
            QCOMPARE(bench.questions, i + 1);
            bench.cell.advanceMs(100);
        }
        QVERIFY(bench.runs());
    }

    void anAbandonedProgramEndsByItself() {
        ProgramBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.abandonProgram());
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.runs(); }, 5500));
        bench.cell.advanceMs(100);
        QVERIFY(!bench.state().programAbandoned);
    }

    void stopEndsAnAbandonedProgram() {
        ProgramBench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.abandonProgram());
        bench.session.stop(StopCause::StopButton);
        QVERIFY(bench.cell.advanceUntil([&] { return !bench.runs(); }, 1000));  // it ends only after 5 s
    }

    // All key presses belong to the same stop. Pressing again does not postpone the stop through the other
    // interfaces.
    void repeatedStopsDoNotPostponeAStopAfterATakeover() {
        ProgramBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.sendMovingProgram());
        QVERIFY(bench.within([&] { return bench.moves(); }));
        QVERIFY2(bench.isInControl(), "the loss of control has already been detected");
        bench.press(12, 20);  // less than the 500 ms after which the loss is detected
        QVERIFY2(!bench.runs(), "the program did not stop");
    }

    // The robot's data confirm each stop, so Tiller's own program is not ended.
    void repeatedStopsOfOwnMotionsKeepControl() {
        ProgramBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        for (int round = 0; round < 3; ++round) {
            const auto motion = bench.session.beginJog(up);
            QVERIFY(motion.ok());
            for (int held = 0; held < 15; ++held) {
                bench.session.hold(*motion);
                bench.cell.advanceMs(20);
            }
            QVERIFY(bench.state().moving);
            bench.press(8, 20);
            bench.cell.advanceMs(500);
            QVERIFY(!bench.state().moving);
            QVERIFY(bench.runs() && bench.isInControl());
        }
    }

    // Collisions with an object cannot be checked if its position is unknown.
    void movesAreRefusedWhileAnObjectHasNoPosition() {
        ProgramBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QStringList warnings;
        const test::Listening listening = test::onMessage(bench.session.journal(), &bench.session,
                                                          [&](Severity severity, const QString& text) {
                                                              if (severity == Severity::Warning) {
                                                                  warnings << text;
                                                              }
                                                          });
        collision::CellSurroundings surroundings;
        surroundings.unplaced.push_back({QStringLiteral("crate"), QStringLiteral("0f0e0d0c")});
        bench.session.setSurroundings(surroundings);
        bench.session.setSurroundings(surroundings);
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings[0].contains("crate") && warnings[0].contains("frame"), qPrintable(warnings[0]));

        JointPositions target = bench.state().q;
        target[0] += 0.1;
        MoveRequest request;
        request.kind = MoveRequest::Kind::MoveJ;
        request.q = target;
        const auto move = bench.session.beginMove(request);
        QVERIFY(!move.ok());
        QVERIFY2(move.error().context.contains("crate"), qPrintable(move.error().context));
        QVERIFY(!bench.session.permits({&request, 1}).ok());
        QVERIFY(!bench.session.permitsPath({&target, 1}).ok());
        // Jogs are permitted. The operator watches them and may need them to teach the position again.
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        const auto jog = bench.session.beginJog(up);
        QVERIFY(jog.ok());
        bench.session.stop(StopCause::Released);

        bench.session.setSurroundings({});
        QVERIFY(bench.session.permits({&request, 1}).ok());
        QVERIFY(bench.session.permitsPath({&target, 1}).ok());
    }
};

QTEST_MAIN(TestForeignProgram)
#include "tst_foreign_program.moc"
