// SPDX-License-Identifier: MIT
// Assumptions of the session about control without data: before the first data, and after a lost connection.
#include <QElapsedTimer>
#include <QTest>

#include "robot/script/script_client.h"
#include "tests/support/event_spy.h"
#include "tests/support/virtual_cell.h"
#include "tests/support/waiting.h"

using namespace tiller;
using namespace tiller::test;

namespace {

constexpr int kTimeoutMs = 60'000;
constexpr int kStepMs = 20;

struct DoubtBench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell{clock, session};

    const SessionState& state() const { return session.state(); }
    /// Advances time until the condition is true. Returns false on timeout.
    template <class Condition>
    bool until(const Condition& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kTimeoutMs) {
            cell.advanceMs(kStepMs);
        }
        return condition();
    }
    /// Advances time for the robot and the session without waiting for data, because no data can arrive.
    void goOn(int ms) {
        for (int t = 0; t < ms; t += 2) {
            clock.advanceNs(2 * kNsPerMs);
            cell.robot.step();
        }
        cell.robot.drainSockets();
        QCoreApplication::processEvents();
        session.refresh();
    }
    template <class Condition>
    bool goOnUntil(const Condition& condition) {
        QElapsedTimer waited;
        waited.start();
        while (!condition() && waited.elapsed() < kTimeoutMs) {
            goOn(kStepMs);
            QTest::qWait(5);  // lets the threads of the connection run
        }
        return condition();
    }
    bool loseTheConnection() {
        return cell.robot.inject(QStringLiteral("half-open")).ok() &&
               goOnUntil([this] { return state().controlLoss == control::ControlLoss::LinkLost; });
    }
    bool isFresh() {
        return goOnUntil([this] { return state().isFresh(); });
    }
    void silence() {
        cell.robot.silence(true);
        goOn(300);
    }
};

}  // namespace

class TestControlDoubt : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // Without data, another program may be running. Taking control could end it without confirmation.
    void takingControlWaitsForData() {
        QStringList said;  // declared first, because the session may send a message in its destructor
        bool asked = false;
        DoubtBench bench;
        QVERIFY(bench.cell.robot.start().ok());
        test::onMessage(bench.session.journal(), &bench.session,
                        [&said](Severity, const QString& text) { said << text; });
        QObject::connect(&bench.session, &RobotSession::takeControlQuestion, &bench.session,
                         [&asked] { asked = true; });
        bench.session.connectTo({QStringLiteral("Virtual UR5e"), bench.cell.robot.listenAddress(), 0, true});
        bench.session.refresh();
        QVERIFY(!bench.state().hasData());
        bench.session.takeControl();
        QVERIFY(bench.state().control != ControlState::Taking);
        QVERIFY(!asked);
        QVERIFY2(said.contains(bench.state().controlReason), qPrintable(said.join('\n')));
        QVERIFY(bench.until([&] { return bench.state().link == LinkState::Live; }));
        bench.session.takeControl();
        QVERIFY(bench.until([&] { return bench.state().control == ControlState::InControl; }));
    }

    void controlIsInDoubtFor15SecondsOfFreshData() {
        DoubtBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(!bench.state().controlInDoubt);
        QVERIFY(bench.loseTheConnection());
        QVERIFY(bench.state().controlInDoubt);
        QVERIFY(bench.isFresh());
        bench.cell.advanceMs(14'900);
        QVERIFY(bench.state().isFresh());
        QVERIFY(bench.state().controlInDoubt);
        bench.cell.advanceMs(200);
        QVERIFY(!bench.state().controlInDoubt);
        // controlInDoubt does not become true again. A later delay of the data contains no information about
        // the previous connection.
        bench.silence();
        QVERIFY(!bench.state().isFresh());
        QVERIFY(!bench.state().controlInDoubt);
    }

    // Outdated data prove nothing, so the waiting time restarts when fresh data arrive.
    void lateDataProlongTheDoubt() {
        DoubtBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.loseTheConnection());
        QVERIFY(bench.isFresh());
        bench.cell.advanceMs(10'000);
        bench.silence();
        QVERIFY(!bench.state().isFresh());
        bench.cell.robot.silence(false);
        QVERIFY(bench.isFresh());
        bench.cell.advanceMs(14'900);
        QVERIFY(bench.state().controlInDoubt);
        bench.cell.advanceMs(200);
        QVERIFY(!bench.state().controlInDoubt);
    }

    // If the connection fails while it is uncertain whether the control program has ended, the 15 s start
    // again.
    void aConnectionLostAfterMissingAnswersProlongsTheDoubt() {
        DoubtBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        script::ScriptClient other(bench.cell.robot.listenAddress(), bench.cell.robot.ports().primary);
        QVERIFY(other.connect(testTimeout()).ok());
        QVERIFY(other.send("def other():\n  while True:\n    sync()\n  end\nend\n", testTimeout()).ok());
        QVERIFY(
            bench.goOnUntil([&] { return bench.state().controlLoss == control::ControlLoss::EchoStalled; }));
        QVERIFY(bench.state().controlInDoubt);
        QVERIFY(bench.loseTheConnection());
        QVERIFY(bench.isFresh());
        bench.cell.advanceMs(14'000);
        QVERIFY(bench.state().controlInDoubt);
        bench.cell.advanceMs(1'100);
        QVERIFY(!bench.state().controlInDoubt);
    }

    void takingControlEndsTheDoubt() {
        DoubtBench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.loseTheConnection());
        QVERIFY(bench.isFresh());
        bench.session.takeControl(RobotSession::ForeignProgram::Stop);
        QVERIFY(bench.until([&] { return bench.state().control == ControlState::InControl; }));
        QVERIFY(!bench.state().controlInDoubt);
    }
};

QTEST_MAIN(TestControlDoubt)
#include "tst_control_doubt.moc"
