// SPDX-License-Identifier: MIT
// The last stop that a session shows: a stop by the safety system replaces the stop measured before it.
#include <QTest>

#include "robot/control/motion.h"
#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

struct Bench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell{clock, session};

    const SessionState& state() const { return session.state(); }
    /// Jogs upwards until the arm moves.
    bool jog() {
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        const auto motion = session.beginJog(up);
        if (!motion) {
            return false;
        }
        id_ = *motion;
        cell.everyRefresh = [this] { session.hold(id_); };
        if (!cell.advanceUntil([this] { return state().moving; }, 2000)) {
            return false;
        }
        cell.advanceMs(100);
        return state().moving;
    }
    /// Jogs and releases; true if the stop was measured.
    bool jogAndRelease() {
        const std::uint64_t before = state().lastStop.count;
        if (!jog()) {
            return false;
        }
        cell.everyRefresh = {};
        session.endMotion(id_, StopCause::Released);
        return cell.advanceUntil([&] { return state().lastStop.count == before + 1; }, 2000) &&
               state().lastStop.cause == StopCause::Released && state().lastStopSeen;
    }
    bool comesToRest() {
        return cell.advanceUntil([this] { return !allowsMotion(state().safety()) && !state().moving; }, 2000);
    }
    /// Advances robot and session until the condition is true. The timeout is measured in real time, because
    /// another client is involved.
    bool within(const std::function<bool()>& condition) {
        const Deadline limit = testTimeout();
        while (!condition() && !limit.hasExpired()) {
            cell.robot.drainSockets();
            cell.advanceMs(2);
        }
        return condition();
    }

    /// Releases control and lets another client move the arm.
    bool runOtherProgram(const QString& pause = "") {
        session.releaseControl();
        return within([this] {
                   return state().control == ControlState::None &&
                          state().runtimeState == RuntimeState::Stopped;
               }) &&
               takeOver(pause);
    }

    /// Lets another client move the arm.
    /// pause  statement between the motions
    bool takeOver(const QString& pause = "") {
        script::ScriptClient other(cell.robot.listenAddress(),
                                   script::kPrimaryPort + cell.robot.options().portOffset);
        const bool sent =
            other.connect(testTimeout()).ok() &&
            other
                .send(QStringLiteral("def others():\nwhile True:\n"
                                     "movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                                     "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\nsync()\n%1\n"
                                     "end\nend\n")
                          .arg(pause),
                      testTimeout())
                .ok();
        if (!sent || !within([this] { return state().moving; })) {
            return false;
        }
        cell.advanceMs(200);
        return true;
    }

    /// Advances robot and clock without the process: neither controller nor session runs.
    void hang(int ms) {
        cell.robot.silence(true);
        for (int t = 0; t < ms; t += 2) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
        }
        cell.robot.silence(false);
    }

    /// Advances the session without waiting for packets, because none arrive.
    void passWithoutData(int ms) {
        for (int t = 0; t < ms; t += 2) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
            QTest::qWait(1);
            session.refresh();
        }
    }

private:
    RobotSession::MotionId id_ = 0;
};

enum class Safety { Protective, Emergency, Safeguard };

void stopBy(Safety safety, simulator::Simulator& robot) {
    switch (safety) {
        case Safety::Protective:
            robot.protectiveStop();
            break;
        case Safety::Emergency:
            robot.emergencyStop(true);
            break;
        case Safety::Safeguard:
            robot.safeguardStop(true);
            break;
    }
}

void addSafetyRows() {
    QTest::addColumn<Safety>("safety");
    QTest::addRow("protective stop") << Safety::Protective;
    QTest::addRow("emergency stop") << Safety::Emergency;
    QTest::addRow("safeguard stop") << Safety::Safeguard;
}

}  // namespace

class TestLastStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSafetyStopOfAJogIsTheLastStop_data() { addSafetyRows(); }
    void aSafetyStopOfAJogIsTheLastStop() {
        QFETCH(const Safety, safety);
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        const std::uint64_t before = bench.state().lastStop.count;
        QVERIFY(bench.jog());
        stopBy(safety, bench.cell.robot);
        QVERIFY(bench.comesToRest());
        bench.cell.advanceMs(200);
        QCOMPARE(bench.state().lastStop.count, before + 1);
        QCOMPARE(bench.state().lastStop.cause, StopCause::UnsafeMode);
        QVERIFY(bench.state().lastStopSeen);
        QVERIFY(bench.state().lastStop.durationMs > 0);
    }

    // The connection is intact, so the cause is not a lost connection. Control is not taken again.
    void aHangDuringAProgramIsNamedAndEndsControl() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const auto run = bench.session.beginProgram(
            "cycle",
            QStringLiteral("def cycle():\nwhile True:\nmovej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\n"
                           "movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=2, v=1)\nend\nend\n"),
            control::Holding::Free, bench.session.stops(), {}, {});
        QVERIFY2(run.ok(), qPrintable(run.error().toString()));
        QVERIFY(bench.within([&] { return bench.state().moving; }));
        bench.hang(600);
        const auto progress = [&] { return bench.session.motionProgress(*run); };
        QVERIFY(bench.within([&] {
            const auto now = progress();
            return !now || now->phase != control::MotionPhase::Active;
        }));
        QVERIFY2(progress().ok(), qPrintable(progress().error().toString()));
        QCOMPARE(progress()->cause, StopCause::EventLoopStalled);
        bench.cell.advanceMs(1000);
        QVERIFY(bench.state().control != ControlState::InControl);
        QCOMPARE(bench.state().runtimeState, RuntimeState::Stopped);
    }

    // The controller ends the motion while the window hangs. The stop is reported when the window continues.
    void aStopDuringAHangOfTheWindowIsReported() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        const std::uint64_t before = bench.state().lastStop.count;
        QVERIFY(bench.jog());
        messages.clear();
        bench.cell.advanceWithFrozenInterface(500);
        bench.session.refresh();
        QCOMPARE(bench.state().lastStop.count, before + 1);
        QCOMPARE(bench.state().lastStop.cause, StopCause::EventLoopStalled);
        QCOMPARE(messages.filter(QStringLiteral("Stopped: ")).size(), 1);
    }

    // The whole process was stopped, as by kill -STOP. The robot has stopped the arm by its own timeout.
    void aHangOfTheProcessIsReportedAsNotMeasured() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        QVERIFY(bench.jog());
        const std::uint64_t before = bench.state().lastStop.count;
        messages.clear();
        bench.hang(300);
        bench.cell.everyRefresh = {};
        QVERIFY(bench.within([&] { return !bench.state().lastStopSeen; }));
        QVERIFY(bench.within([&] { return bench.state().unmeasuredStop.count == 1; }));
        QCOMPARE(bench.state().unmeasuredStop.cause, StopCause::EventLoopStalled);
        QCOMPARE(bench.state().lastStop.count, before);
        const QStringList stops = messages.filter(QStringLiteral("Stopped: "));
        QCOMPARE(stops.size(), 1);
        QVERIFY2(
            stops.first().contains("the window did not respond") && stops.first().contains("not measured"),
            qPrintable(stops.first()));
        QVERIFY(bench.jogAndRelease());
        QVERIFY(bench.state().lastStopSeen);
    }

    void aTakeoverDuringAHoldIsNotMeasured() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        QVERIFY(bench.jog());
        const std::uint64_t before = bench.state().lastStop.count;
        QVERIFY(bench.takeOver());
        QVERIFY(bench.within([&] { return bench.state().unmeasuredStop.count == 1; }));
        QVERIFY(!bench.state().lastStopSeen);
        QCOMPARE(bench.state().unmeasuredStop.reason, control::UnmeasuredStop::Reason::OtherProgram);
        QVERIFY(bench.within([&] { return !bench.state().moving; }));
        bench.cell.advanceMs(200);
        QCOMPARE(bench.state().lastStop.count, before);
        QVERIFY(!bench.state().lastStopSeen);
    }

    // The program of another client moves the arm, and STOP is pressed while the robot cannot be reached.
    // The arm is at rest when the connection is back, and the program moves it again later.
    void aStopOfAWaitingProgramThatDidNotArriveIsNotReportedAsAStop() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runOtherProgram("sleep(60)"));
        messages.clear();
        QVERIFY(bench.cell.robot.inject("link lost").ok());
        bench.session.stop(StopCause::StopButton);
        const Deadline limit = testTimeout();
        while (messages.filter("could not be stopped").isEmpty() && !limit.hasExpired()) {
            bench.passWithoutData(50);
        }
        bench.passWithoutData(5000);  // the motion of the program ends
        QVERIFY(bench.cell.robot.inject("link back").ok());
        QVERIFY(bench.within([&] { return bench.state().isFresh(); }));
        QVERIFY(!bench.state().moving);
        bench.cell.advanceMs(1200);
        QVERIFY(bench.state().foreignProgramRuns());
        const QString all = messages.join('\n');
        QVERIFY2(!all.contains("Stopped: "), qPrintable(all));
        QVERIFY2(all.contains("still running"), qPrintable(all));
        QCOMPARE(bench.state().unmeasuredStop.reason, control::UnmeasuredStop::Reason::NotStopped);
        // The header must not show "not stopped" after the next stop.
        bench.session.stop(StopCause::StopButton);
        QVERIFY(bench.within([&] { return !bench.state().foreignProgramRuns(); }));
        QVERIFY(bench.within([&] {
            return bench.state().unmeasuredStop.reason != control::UnmeasuredStop::Reason::NotStopped;
        }));
    }

    void aStopThatDidNotArriveIsNotReportedAsAStop() {
        QStringList messages;  // must outlive the session, which reports its end in the destructor
        Bench bench;
        test::onMessage(bench.session.journal(), &bench.session,
                        [&](Severity, const QString& text) { messages << text; });
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.runOtherProgram());
        messages.clear();
        QVERIFY(bench.cell.robot.inject("link lost").ok());
        bench.session.stop(StopCause::StopButton);
        const Deadline limit = testTimeout();
        while (messages.filter("could not be stopped").isEmpty() && !limit.hasExpired()) {
            bench.passWithoutData(50);
        }
        QVERIFY2(messages.join('\n').contains("could not be stopped"), qPrintable(messages.join('\n')));
        QVERIFY(bench.cell.robot.inject("link back").ok());
        QVERIFY(bench.within([&] { return bench.state().isFresh() && bench.state().moving; }));
        QVERIFY(bench.within([&] { return bench.state().unmeasuredStop.count == 1; }));
        bench.cell.advanceMs(1200);  // the arm could still have been braking
        QVERIFY(bench.state().moving);
        const QString all = messages.join('\n');
        QVERIFY2(!all.contains("Stopped: "), qPrintable(all));
        QVERIFY2(all.contains("the arm is still moving"), qPrintable(all));
        QCOMPARE(bench.state().unmeasuredStop.reason, control::UnmeasuredStop::Reason::NotStopped);
    }

    void aSafetyStopOfAnotherProgramIsTheLastStop_data() { addSafetyRows(); }
    void aSafetyStopOfAnotherProgramIsTheLastStop() {
        QFETCH(const Safety, safety);
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        const std::uint64_t before = bench.state().lastStop.count;
        QVERIFY(bench.runOtherProgram());
        stopBy(safety, bench.cell.robot);
        QVERIFY(bench.comesToRest());
        bench.cell.advanceMs(200);
        QCOMPARE(bench.state().lastStop.count, before + 1);
        QCOMPARE(bench.state().lastStop.cause, StopCause::UnsafeMode);
        QVERIFY(bench.state().lastStop.durationMs > 0);
    }

    // The stop of the previous jog must not be shown as the result of the safety stop.
    void aSafetyStopOfAnotherProgramWithoutDataIsUnknown() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.jogAndRelease());
        QVERIFY(bench.state().lastStopSeen);
        QVERIFY(bench.runOtherProgram());
        bench.cell.robot.protectiveStop();
        QVERIFY(bench.cell.advanceUntil([&] { return !allowsMotion(bench.state().safety()); }, 100));
        QVERIFY2(bench.state().moving, "the arm stopped before the data ended");
        QVERIFY(bench.cell.robot.inject("link lost").ok());
        bench.passWithoutData(500);
        QVERIFY(bench.state().link != LinkState::Live);
        QVERIFY(!bench.state().lastStopSeen);
    }
};

QTEST_MAIN(TestLastStop)
#include "tst_last_stop.moc"
