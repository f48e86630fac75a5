// SPDX-License-Identifier: GPL-3.0-or-later
// In control, and the robot goes from Remote to Local: motion stops, control is given back, and the operator
// reads why. A robot that never was in Remote may be controlled as it is.
#include <QElapsedTimer>
#include <QTest>

#include "tests/support/virtual_cell.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// Session time within which the switch is asked about; the answer itself takes real time.
constexpr int kNoticedMs = 600;
constexpr int kPatienceMs = 20'000;

struct Bench {
    VirtualClock clock;
    RobotSession session{clock};
    VirtualCell cell;
    QStringList warnings;
    RobotSession::MotionId jog = 0;

    explicit Bench(const simulator::ControllerOptions& options = VirtualCell::options())
        : cell(clock, session, options) {
        QObject::connect(&session, &RobotSession::message, &session,
                         [this](Severity severity, const QString& text) {
                             if (severity != Severity::Info) {
                                 warnings << text;
                             }
                         });
        cell.everyRefresh = [this] {
            if (jog != 0) {
                session.hold(jog);
            }
        };
    }
    bool knowsRemote() {
        return within([this] { return session.state().remoteControl; });
    }
    bool within(const std::function<bool()>& condition) {
        QElapsedTimer patience;
        patience.start();
        while (!condition() && patience.elapsed() < kPatienceMs) {
            cell.advanceMs(16);
        }
        return condition();
    }
    /// The session's time stands still: what was asked for is answered.
    bool answered(const std::function<bool()>& condition) {
        return QTest::qWaitFor(
            [&] {
                session.refresh();
                return condition();
            },
            kPatienceMs);
    }
    bool beginJog() {
        control::JogTarget up;
        up.twist.linear.z() = 0.05;
        const auto begun = session.beginJog(up);
        if (!begun) {
            return false;
        }
        jog = *begun;
        return cell.advanceUntil([this] { return cell.truth().tcpSpeed.linear.norm() > 0.04; }, 1000);
    }
    bool isInControl() const { return session.state().control == ControlState::InControl; }
    QString said() const { return warnings.join(QLatin1Char('\n')); }
};

}  // namespace

class TestControlPlace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fromRemoteToLocalControlIsGivenBack() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        QVERIFY(bench.beginJog());
        bench.warnings.clear();
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(kNoticedMs);
        QVERIFY(bench.answered([&] { return !bench.warnings.isEmpty(); }));
        QVERIFY2(bench.said().contains(QStringLiteral("Local")), qPrintable(bench.said()));
        // The hand still holds the key: it moves nothing any more.
        QVERIFY(
            bench.cell.advanceUntil([&] { return bench.cell.truth().tcpSpeed.linear.norm() < 0.001; }, 250));
        QVERIFY(bench.within([&] { return !bench.isInControl(); }));
        QVERIFY(bench.within([&] { return bench.cell.truth().runtimeState == RuntimeState::Stopped; }));
        QCOMPARE(bench.session.state().control, ControlState::Refused);
        QVERIFY(bench.session.state().controlReason.contains(QStringLiteral("Local")));
        QCOMPARE(bench.warnings.size(), 1);
        // And back: nothing is taken by itself, but everything can be.
        bench.jog = 0;
        bench.cell.robot.setRemoteControl(true);
        QVERIFY(bench.knowsRemote());
        bench.cell.advanceMs(1000);
        QVERIFY(!bench.isInControl());
        bench.session.takeControl();
        QVERIFY(bench.within([&] { return bench.isInControl(); }));
        QVERIFY(bench.beginJog());
    }

    // Remote control switched off in the settings of the robot: it answers "false" from the beginning.
    void aRobotThatNeverWasInRemoteIsNoTransition() {
        simulator::ControllerOptions options = VirtualCell::options();
        options.remoteControl = false;
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.within([&] { return bench.session.state().service == dashboard::ServiceKind::Dashboard; }));
        QVERIFY(bench.beginJog());
        bench.cell.advanceMs(3000);
        QVERIFY(bench.isInControl());
        QVERIFY(bench.cell.truth().tcpSpeed.linear.norm() > 0.01);
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    // Software that does not know the question.
    void whereNobodyTellsThereIsNoTransition() {
        simulator::ControllerOptions options = VirtualCell::options();
        options.software = {5, 5, 1, 0};
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(
            bench.within([&] { return bench.session.state().service == dashboard::ServiceKind::Dashboard; }));
        bench.cell.robot.setRemoteControl(false);
        bench.cell.advanceMs(3000);
        QVERIFY(bench.isInControl());
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    void withoutControlThereIsNothingToGiveBack() {
        Bench bench;
        QVERIFY2(bench.cell.connect(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        bench.cell.robot.setRemoteControl(false);
        QVERIFY(bench.within([&] { return !bench.session.state().remoteControl; }));
        QCOMPARE(bench.session.state().control, ControlState::None);
        QVERIFY2(bench.warnings.isEmpty(), qPrintable(bench.said()));
    }

    void aTransitionOnPolyscopeXIsOneToo() {
        simulator::ControllerOptions options = VirtualCell::options();
        options.software = {10, 12, 0, 0};
        options.portOffset = 20'000;
        Bench bench(options);
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        QVERIFY(bench.knowsRemote());
        bench.warnings.clear();
        bench.cell.robot.setRemoteControl(false);
        QVERIFY(bench.within([&] { return !bench.isInControl(); }));
        QVERIFY(bench.within([&] { return !bench.warnings.isEmpty(); }));
        QVERIFY2(bench.said().contains(QStringLiteral("Local")), qPrintable(bench.said()));
    }
};

QTEST_MAIN(TestControlPlace)
#include "tst_control_place.moc"
