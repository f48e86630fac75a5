// SPDX-License-Identifier: GPL-3.0-or-later
//
// Actions at a waypoint, in the real window with the simulated robot. They are edited by keyboard, undone,
// shown in the list, and executed by "Run route" only while its button is held.

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QThread>
#include <QTimer>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/jog_window_test.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;
using Action = project::WaypointAction;

namespace {

Action setOutput(int pin, bool on) {
    Action action;
    action.kind = Action::Kind::SetOutput;
    action.pin = pin;
    action.value = on;
    return action;
}

Action pulse(int pin, double seconds) {
    Action action = setOutput(pin, true);
    action.kind = Action::Kind::PulseOutput;
    action.seconds = seconds;
    return action;
}

Action waitFor(int pin, double atMost) {
    Action action = pulse(pin, atMost);
    action.kind = Action::Kind::WaitForInput;
    return action;
}

Action waitTime(double seconds) {
    Action action;
    action.seconds = seconds;
    return action;
}

Action gripper(bool close) {
    Action action;
    action.kind = close ? Action::Kind::CloseGripper : Action::Kind::OpenGripper;
    return action;
}

enum class End {
    Release,
    WindowDeactivated,
    Dialog,
    Escape,
    Space,
    StopButton,
    SecondButton,
    SilentLink,
    ClosedLink,
    ProtectiveStop
};
constexpr const char* kEnds[] = {
    "released", "window deactivated", "dialog",      "Esc",         "Space",
    "STOP",     "second hand",        "silent link", "closed link", "protective stop"};

}  // namespace

class TestWaypointActions : public JogWindowTest {
    Q_OBJECT

private:
    QStringList said_;

    UndoableDocument& document() { return window().document(); }
    HoldToRunButton& through() { return key("waypoint.goThrough"); }
    WaypointsTab& tab() { return *window().findChild<WaypointsTab*>(); }
    bool output(int pin) { return (cell().truth().digitalOutputs >> pin & 1) != 0; }
    bool isAt(int row) {
        const JointPositions& q = document().waypoints().at(row).joints;
        return (cell().truth().q.values - q.values).cwiseAbs().maxCoeff() < 1e-3;
    }
    QString doing() { return through().accessibleDescription(); }
    /// Also waits in real time, because a worker thread sets the outputs.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    void pass(int ms) {
        for (int t = 0; t < ms; t += 20) {
            cell().advanceMs(20);
            QTest::qWait(1);
        }
    }
    /// Advances time without waiting for data from the robot, because no data arrive.
    void passWithoutLink(int ms) {
        for (int t = 0; t < ms; t += 20) {
            for (int tick = 0; tick < 10; ++tick) {
                cell().clock.advanceNs(2 * kNsPerMs);
                cell().robot.step();
            }
            cell().everyRefresh();
            QCoreApplication::processEvents();
            window().session().refresh();
            QTest::qWait(1);
        }
    }
    GripperPanel& useRobotiq() {
        window().showTab("gripper");
        auto& panel = bench_->find<GripperPanel>("gripper");
        auto& kind = bench_->find<QComboBox>("gripper.kind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_Home);
        QTest::keyClick(&kind, Qt::Key_Down);
        until([&] { return panel.robotiq().state().has_value(); });
        window().showTab("waypoints");
        pass(40);
        return panel;
    }
    bool activate(GripperPanel& panel) {
        window().showTab("gripper");
        auto& key = bench_->find<QAbstractButton>("gripper.activate");
        if (!until([&] { return key.isEnabled(); })) {
            return false;
        }
        QTest::mouseClick(&key, Qt::LeftButton);
        const bool active = until([&] {
            return panel.robotiq().state() &&
                   panel.robotiq().state()->activation == io::RobotiqActivation::Active;
        });
        window().showTab("waypoints");
        pass(40);
        return active;
    }
    /// Teaches two waypoints some distance apart.
    /// actions  executed at the first waypoint
    void teach(const project::WaypointActions& actions, double blend = 0) {
        const SessionState& state = window().session().state();
        std::vector<project::Waypoint> points;
        for (const double turn : {0.1, 0.2}) {
            project::Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("point %1").arg(points.size() + 1);
            JointPositions q = state.q;
            q[0] += turn;
            const Pose pose = kinematics::forwardTcp(robotModel(state.model).dh, q, state.tcpOffset);
            points.push_back(*project::taughtAt(point, q, pose, state.tcpOffset, document().frames()));
            points.back().blend = blend;
        }
        points[0].actions = actions;
        document().insertWaypoints(0, points, "taught");
        tab().selectRow(0);
        QVector<HoldToRunButton*> keys = window().jogColumn().holdKeys();
        keys << &through() << &key("waypoint.stepOn") << &key("waypoint.stepBack") << &key("waypoint.goTo");
        driveKeys(cell(), keys, &window().jogColumn().axisJog());
        window().jogColumn().selectors().setSpeedClass(3);
        said_.clear();
        test::onMessage(window().session().journal(), &window(),
                        [this](Severity, const QString& text) { said_ << text; });
        cell().advanceMs(40);
    }
    void hold(HoldToRunButton& button) {
        QVERIFY2(button.isEnabled(), qPrintable(button.toolTip()));
        press(button);
        QVERIFY(button.isHolding());
    }
    /// Holds the button until its motion ends.
    void holdToTheEnd(HoldToRunButton& button) {
        hold(button);
        QVERIFY(until([&] { return !button.isHolding(); }));
        release(button);
        pass(40);
    }
    bool wasSaid(const QString& text) { return said_.filter(text).size() > 0; }
    void end(End end) {
        switch (end) {
            case End::Release:
                release(through());
                break;
            case End::WindowDeactivated: {
                QEvent deactivated(QEvent::WindowDeactivate);
                QApplication::sendEvent(&window(), &deactivated);
                break;
            }
            case End::Dialog: {
                auto* dialog = new QDialog(&window());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
                break;
            }
            case End::Escape:
                QTest::keyPress(&window(), Qt::Key_Escape);
                break;
            case End::Space:
                QTest::keyPress(&window(), Qt::Key_Space);
                break;
            case End::StopButton:
                QTest::mousePress(window().findChild<QAbstractButton*>("stopButton"), Qt::LeftButton);
                break;
            case End::SecondButton:
                sendMouse(key("jog.Y+"), QEvent::MouseButtonPress, Qt::RightButton);
                break;
            case End::SilentLink:
                cell().robot.silence(true);
                break;
            case End::ClosedLink:
                cell().robot.closeClients();
                break;
            case End::ProtectiveStop:
                cell().robot.protectiveStop();
                break;
        }
    }
    /// Runs `use` in the actions dialog, which has its own event loop.
    void inDialog(const std::function<void(QDialog&)>& use) {
        bool used = false;
        QTimer::singleShot(0, &window(), [&] {
            auto* dialog = window().findChild<QDialog*>("waypoint.actions");
            if (dialog == nullptr) {
                return;
            }
            used = true;
            use(*dialog);
            if (dialog->isVisible()) {
                dialog->reject();
            }
        });
        for (QAction* action : tab().commandActions()) {
            if (action->objectName() == "waypoint.action.actions") {
                action->trigger();
            }
        }
        QVERIFY(used);
    }

private Q_SLOTS:
    void actionsRunInOrderAtTheirWaypoint() {
        teach({setOutput(3, true), waitTime(0.5), setOutput(3, false), setOutput(4, true)}, 0.02);
        hold(through());
        QVERIFY(until([&] { return output(3); }));
        QVERIFY2(isAt(0), "the arm passed the waypoint of the action");
        const double setAt = window().session().state().robotTime;
        QVERIFY(until([&] { return doing().contains("Wait 0.5 s"); }));
        QVERIFY2(doing().contains("point 1"), qPrintable(doing()));
        QVERIFY(until([&] { return !output(3); }));
        QVERIFY(window().session().state().robotTime - setAt >= 0.49);
        QVERIFY(isAt(0));
        QVERIFY(until([&] { return output(4); }));
        QVERIFY(until([&] { return !through().isHolding(); }));
        release(through());
        QVERIFY(isAt(1));
        QVERIFY(wasSaid("DO 3"));
    }

    void aPulseLastsItsDuration() {
        teach({pulse(2, 0.4)});
        hold(through());
        QVERIFY(until([&] { return output(2); }));
        const double on = window().session().state().robotTime;
        QVERIFY(until([&] { return !output(2); }));
        const double seconds = window().session().state().robotTime - on;
        QVERIFY2(seconds >= 0.37, qPrintable(QString::number(seconds)));
        QVERIFY(until([&] { return isAt(1); }));
        release(through());
    }

    void theRouteWaitsForAnInput() {
        teach({waitFor(5, 60), setOutput(1, true)});
        hold(through());
        QVERIFY(until([&] { return doing().contains("DI 5"); }));
        pass(1000);
        QVERIFY(isAt(0) && !output(1));
        QVERIFY(through().isHolding());
        cell().robot.setDigitalInput(5, true);
        QVERIFY(until([&] { return output(1); }));
        QVERIFY(until([&] { return isAt(1); }));
        release(through());
    }

    void missingInputEndsTheSequenceWithAReason() {
        teach({waitFor(5, 0.6), setOutput(1, true)});
        holdToTheEnd(through());
        QVERIFY(isAt(0));
        QVERIFY(!output(1));
        QVERIFY2(wasSaid("DI 5") && wasSaid("0.6 s") && wasSaid("point 1"), qPrintable(said_.join('\n')));
        // Pressing again repeats the wait action.
        cell().robot.setDigitalInput(5, true);
        holdToTheEnd(through());
        QVERIFY(output(1));
        QVERIFY(isAt(1));
    }

    // After any kind of release, neither the wait nor the following actions continue.
    void noActionRunsWithoutTheKey_data() {
        QTest::addColumn<int>("end");
        for (int e = 0; e < static_cast<int>(std::size(kEnds)); ++e) {
            QTest::newRow(kEnds[e]) << e;
        }
    }
    void noActionRunsWithoutTheKey() {
        QFETCH(int, end);
        teach({waitTime(1), setOutput(1, true), waitFor(5, 60), setOutput(2, true)});
        hold(through());
        QVERIFY(until([&] { return doing().contains("Wait 1 s"); }));
        pass(100);
        const bool linkEnds =
            static_cast<End>(end) == End::SilentLink || static_cast<End>(end) == End::ClosedLink;
        const auto passTime = [&](int ms) { linkEnds ? passWithoutLink(ms) : pass(ms); };
        this->end(static_cast<End>(end));
        // The button remains pressed if something else ended the motion.
        passTime(3000);
        QVERIFY(!through().isHolding());
        QVERIFY(!output(1) && !output(2));
        QVERIFY2(!doing().contains("Wait"), qPrintable(doing()));
        QVERIFY(isAt(0));
        // The sequence does not continue, even when the condition becomes true.
        cell().robot.silence(false);
        cell().robot.setDigitalInput(5, true);
        passTime(1000);
        QVERIFY(!output(1) && !output(2));
        QVERIFY(isAt(0));
    }

    void releasingDuringAPulseResetsTheOutput() {
        teach({pulse(2, 5), setOutput(1, true)});
        hold(through());
        QVERIFY(until([&] { return output(2) && doing().contains("DO 2"); }));
        pass(200);
        release(through());
        QVERIFY(until([&] { return !output(2); }));
        pass(500);
        QVERIFY(!output(1) && !output(2));
    }

    // The button is released before the worker has received the command, so the command is not sent.
    void immediateReleaseSetsNoOutputLater() {
        teach({setOutput(1, true)});
        hold(through());
        // Only virtual time is advanced. The worker has either executed the command before the release, or
        // the command is withdrawn. In both cases, no output is set after the release.
        cell().advanceUntil([&] { return doing().contains("DO 1"); }, 20'000);
        release(through());
        pass(100);
        const bool set = output(1);
        pass(1000);
        QCOMPARE(output(1), set);
    }

    void nextPressContinuesWithTheRemainingActions() {
        teach({setOutput(1, true), waitFor(5, 60), setOutput(2, true)});
        hold(through());
        QVERIFY(until([&] { return doing().contains("DI 5"); }));
        release(through());
        pass(100);
        QVERIFY(isAt(0));
        // Completed actions are not repeated.
        window().session().outputs().setDigitalOutput(1, false);
        QVERIFY(until([&] { return !output(1); }));
        cell().robot.setDigitalInput(5, true);
        holdToTheEnd(through());
        QVERIFY(!output(1) && output(2));
        QVERIFY(isAt(1));
    }

    void armReturnsFirstAfterBeingMovedAway() {
        teach({waitFor(5, 60), setOutput(2, true)});
        hold(through());
        QVERIFY(until([&] { return doing().contains("DI 5"); }));
        release(through());
        pass(100);
        jog("jog.Z+", 400);
        QVERIFY(!isAt(0));
        cell().robot.setDigitalInput(5, true);
        hold(through());
        QVERIFY(until([&] { return output(2); }));
        QVERIFY2(isAt(0), "the action was executed away from its waypoint");
        release(through());
    }

    void stepRunsActionsAndStepBackDoesNot() {
        teach({setOutput(1, true)});
        holdToTheEnd(key("waypoint.stepOn"));
        QVERIFY(isAt(0) && output(1));
        holdToTheEnd(key("waypoint.stepOn"));
        QVERIFY(isAt(1));
        window().session().outputs().setDigitalOutput(1, false);
        QVERIFY(until([&] { return !output(1); }));
        holdToTheEnd(key("waypoint.stepBack"));
        QVERIFY(isAt(0));
        QVERIFY(!output(1));
    }

    void theGripperOfOutputsClosesAndOpens() {
        teach({gripper(true), waitTime(0.2), gripper(false)});
        press(through());
        QVERIFY2(!through().isHolding(), "the route started without a gripper");
        release(through());
        QVERIFY2(wasSaid("No gripper"), qPrintable(said_.join('\n')));
        window().showTab("gripper");
        auto& kind = bench_->find<QComboBox>("gripper.kind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_End);
        QVERIFY(bench_->find<GripperPanel>("gripper").choice().kind == GripperChoice::Kind::TwoOutputs);
        window().showTab("waypoints");
        pass(40);
        hold(through());
        QVERIFY(until([&] { return output(16) && !output(17); }));
        QVERIFY(isAt(0));
        QVERIFY(until([&] { return output(17) && !output(16); }));
        QVERIFY(until([&] { return isAt(1); }));
        release(through());
    }

    void theRouteWaitsForARobotiqGripper() {
        teach({gripper(true)});
        GripperPanel& panel = useRobotiq();
        holdToTheEnd(through());
        QVERIFY2(wasSaid("Activate the gripper first") && wasSaid("point 1"), qPrintable(said_.join('\n')));
        QVERIFY(isAt(0));
        QVERIFY(activate(panel));
        holdToTheEnd(through());
        QVERIFY(panel.robotiq().state()->position > 200);
        QVERIFY(isAt(1));
    }

    // Moving fingers can pinch. They stop on release and continue with the next press.
    void releaseStopsTheGripperFingers() {
        teach({gripper(true)});
        GripperPanel& panel = useRobotiq();
        QVERIFY(activate(panel));
        bench_->find<DecimalSpinBox>("gripper.speed").setValue(0);
        const auto position = [&] {
            return panel.robotiq().state() ? panel.robotiq().state()->position : -1;
        };
        QVERIFY(until([&] { return position() >= 0 && position() < 20; }));
        hold(through());
        QVERIFY(until([&] { return position() > 50; }));
        release(through());
        QVERIFY(until([&] { return panel.robotiq().state() && !panel.robotiq().state()->goTo; }));
        pass(300);
        const int stood = position();
        QVERIFY2(stood > 50 && stood < 180, qPrintable(QString::number(stood)));
        pass(2000);
        QCOMPARE(position(), stood);
        QVERIFY(isAt(0));
        holdToTheEnd(through());
        QVERIFY(position() > 200);
        QVERIFY(isAt(1));
    }

    // When the window hangs, the hold ends, so a pulsed output must be switched off.
    void aHangingWindowEndsThePulse() {
        teach({pulse(2, 60), setOutput(1, true)});
        hold(through());
        QVERIFY(until([&] { return output(2) && doing().contains("DO 2"); }));
        pass(500);
        QVERIFY2(output(2), "the output was switched off during the hold");
        int hung = 0;
        for (; output(2) && hung < 20'000; hung += 20) {
            cell().advanceWithFrozenInterface(20);
            QThread::msleep(2);
        }
        QVERIFY2(!output(2) && hung < 20'000, qPrintable(QString::number(hung)));
        pass(500);
        QVERIFY(!output(1));
        QVERIFY(!output(2));
    }

    void actionsAreEditedByKeyboardAndUndone() {
        teach({});
        const QString before = tab().model().index(0, WaypointModel::Name).data().toString();
        const int commands = document().undoStack().count();
        inDialog([](QDialog& dialog) {
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.add"), Qt::Key_Return);
            QTest::keyClick(dialog.findChild<QComboBox*>("waypoint.actions.pin"), Qt::Key_Down);
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.add"), Qt::Key_Return);
            auto* kind = dialog.findChild<QComboBox*>("waypoint.actions.kind");
            QTest::keyClick(kind, Qt::Key_Down);
            QTest::keyClick(kind, Qt::Key_Down);
            auto* list = dialog.findChild<QListWidget*>("waypoint.actions.list");
            QCOMPARE(list->count(), 2);
            QCOMPARE(list->item(0)->text(), QString("DO 1 on"));
            QCOMPARE(list->item(1)->text(), QString("Wait until DI 1 is on (max. 10 s)"));
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.up"), Qt::Key_Return);
            QCOMPARE(list->currentRow(), 0);
            auto* seconds = dialog.findChild<QDoubleSpinBox*>("waypoint.actions.seconds");
            seconds->setFocus();
            seconds->selectAll();
            QTest::keyClicks(seconds, "2.5");
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.accept"), Qt::Key_Return);
        });
        const project::WaypointActions expected{waitFor(1, 2.5), setOutput(1, true)};
        QCOMPARE(document().waypoints().at(0).actions, expected);
        QCOMPARE(document().undoStack().count(), commands + 1);
        const QString shown = tab().model().index(0, WaypointModel::Name).data().toString();
        QVERIFY2(shown != before && shown.endsWith("2"), qPrintable(shown));
        QVERIFY(
            tab().model().index(0, WaypointModel::Name).data(Qt::ToolTipRole).toString().contains("DI 1"));
        document().undoStack().undo();
        QVERIFY(document().waypoints().at(0).actions.empty());
        QCOMPARE(tab().model().index(0, WaypointModel::Name).data().toString(), before);
        document().undoStack().redo();
        inDialog([](QDialog& dialog) {
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.remove"), Qt::Key_Return);
            auto* seconds = dialog.findChild<QDoubleSpinBox*>("waypoint.actions.seconds");
            QVERIFY(!seconds->isVisible());
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.accept"), Qt::Key_Return);
        });
        QCOMPARE(document().waypoints().at(0).actions, project::WaypointActions{setOutput(1, true)});
        // Cancel changes nothing.
        inDialog([](QDialog& dialog) {
            QTest::keyClick(dialog.findChild<QPushButton*>("waypoint.actions.remove"), Qt::Key_Return);
            dialog.reject();
        });
        QCOMPARE(document().waypoints().at(0).actions, project::WaypointActions{setOutput(1, true)});
    }
};

QTEST_MAIN(TestWaypointActions)
#include "tst_waypoint_actions.moc"
