// SPDX-License-Identifier: GPL-3.0-or-later
//
// "Run route" in the real window: runs the waypoints one after the other while the button is held, with pause
// and steps forward and back. Also tests all events that must end the motion, in every stage: during a motion
// without a blend, during a blended path, and while the path is being sent.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QPushButton>
#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/jog_window_test.h"
#include "tests/support/pictures.h"
#include "tests/support/question_answer.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

constexpr int kDeathToStandstillMs = 250;

enum class Stage {
    Plain,    ///< during a motion without a blend
    Blended,  ///< during a path of blended motions
    Sending,  ///< while the path is being sent to the robot
    StepOn,
    StepBack
};
constexpr const char* kStages[] = {"plain", "blended", "sending", "step on", "step back"};

enum class End {
    Release,
    WindowDeactivated,
    WindowMinimised,
    WindowClosed,
    Dialog,
    Escape,
    Space,
    StopButton,
    SecondButton,
    SpeedChange,
    TabChange,
    FrozenInterface,
    SilentLink,
    ProcessKilled,
    ProtectiveStop
};
constexpr const char* kEnds[] = {"released",
                                 "window deactivated",
                                 "window minimised",
                                 "window closed",
                                 "dialog",
                                 "Esc",
                                 "Space",
                                 "STOP",
                                 "another button or key pressed",
                                 "speed changes",
                                 "tab changes",
                                 "frozen window",
                                 "silent link",
                                 "process killed",
                                 "protective stop"};

}  // namespace

class TestGoThrough : public JogWindowTest {
    Q_OBJECT

private:
    UndoableDocument& document() { return window().document(); }
    HoldToRunButton& through() { return key("waypoint.goThrough"); }
    WaypointsTab& tab() { return *window().findChild<WaypointsTab*>(); }
    JointPositions q(int row) { return document().waypoints().at(row).joints; }
    double apart(int row) { return (cell().truth().q.values - q(row).values).cwiseAbs().maxCoeff(); }
    bool isAt(int row) { return apart(row) < 1e-3; }

    /// Teaches waypoints around the current position.
    /// turns  rotation of the base joint for each waypoint [rad]
    void teach(const std::vector<double>& turns, double blend,
               project::MoveKind move = project::MoveKind::Joint) {
        std::vector<project::Waypoint> points;
        const SessionState& state = window().session().state();
        for (const double turn : turns) {
            project::Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("point %1").arg(points.size() + 1);
            point.move = move;
            JointPositions q = state.q;
            q[0] += turn;
            const Pose pose = kinematics::forwardTcp(robotModel(state.model).dh, q, state.tcpOffset);
            points.push_back(*project::taughtAt(point, q, pose, state.tcpOffset, document().frames()));
            points.back().blend = blend;
        }
        document().insertWaypoints(0, points, "taught");
        tab().selectRow(0);
        drive();
    }
    void drive() {
        QVector<HoldToRunButton*> keys = window().jogColumn().holdKeys();
        keys << &through() << &key("waypoint.stepOn") << &key("waypoint.stepBack") << &key("waypoint.goTo");
        driveKeys(cell(), keys, &window().jogColumn().axisJog());
        window().jogColumn().selectors().setSpeedClass(3);
        cell().advanceMs(40);
    }
    QString coming() { return through().accessibleDescription(); }
    bool isMarked(int row) {
        return tab()
            .model()
            .index(row, WaypointModel::Name)
            .data()
            .toString()
            .startsWith(QStringLiteral("▶"));
    }
    bool until(const std::function<bool()>& condition, int ms = 60'000) {
        return cell().advanceUntil(condition, ms);
    }
    void hold(HoldToRunButton& button) {
        QVERIFY2(button.isEnabled(), qPrintable(button.toolTip()));
        press(button);
        QVERIFY(button.isHolding());
    }
    /// Holds a step button until the arm has arrived.
    void step(const char* name) {
        hold(key(name));
        QVERIFY(until([&] { return !key(name).isHolding(); }));
        release(key(name));
        cell().advanceMs(40);
    }

    /// Presses a button and advances to this stage.
    void begin(Stage stage) {
        switch (stage) {
            case Stage::Plain:
                teach({0.4, 0.8}, 0);
                hold(through());
                cell().advanceMs(300);
                break;
            case Stage::Blended:
                teach({0.2, 0.4, 0.6, 0.8}, 0.02);
                hold(through());
                QVERIFY(until([&] { return !standsStill(cell()); }));
                cell().advanceMs(200);
                break;
            case Stage::Sending:
                teach({0.2, 0.4, 0.6, 0.8}, 0.02);
                hold(through());
                break;
            case Stage::StepOn:
                teach({0.4, 0.8}, 0);
                hold(key("waypoint.stepOn"));
                cell().advanceMs(300);
                break;
            case Stage::StepBack:
                teach({0.4, 0.05}, 0);
                step("waypoint.stepOn");
                QVERIFY(isAt(0));
                hold(key("waypoint.stepOn"));
                cell().advanceMs(300);
                release(key("waypoint.stepOn"));
                QVERIFY(timeToStandstill(cell()) >= 0);
                cell().advanceMs(40);
                hold(key("waypoint.stepBack"));
                cell().advanceMs(150);
                break;
        }
    }
    HoldToRunButton& keyOf(Stage stage) {
        return stage == Stage::StepOn     ? key("waypoint.stepOn")
               : stage == Stage::StepBack ? key("waypoint.stepBack")
                                          : through();
    }
    void end(End end, HoldToRunButton& held) {
        switch (end) {
            case End::Release:
                release(held);
                break;
            case End::WindowDeactivated: {
                QEvent deactivated(QEvent::WindowDeactivate);
                QApplication::sendEvent(&window(), &deactivated);
                break;
            }
            case End::WindowMinimised:
                window().showMinimized();
                break;
            case End::WindowClosed: {
                // The taught waypoints are not saved, so closing asks for confirmation. The stop does not
                // wait for the answer.
                const QuestionAnswer answer("unsavedCopy.drop");
                QVERIFY(window().close());
                QVERIFY(answer.wasAsked());
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
            case End::SpeedChange:
                window().jogColumn().selectors().setSpeedClass(2);
                break;
            case End::TabChange:
                window().showTab("io");
                break;
            case End::ProtectiveStop:
                cell().robot.protectiveStop();
                break;
            default:
                break;
        }
    }
    /// Advances only robot and controller, as after a crash or hang of the client. Returns the time to
    /// standstill [ms]; -1 if the arm still moves at the end.
    int robotAlone(int ms) {
        int stood = -1;
        for (int t = 0; t < ms; t += 2) {
            cell().clock.advanceNs(2 * kNsPerMs);
            cell().robot.step();
            if (stood < 0 && t >= 10 && standsStill(cell())) {
                stood = t;
            } else if (!standsStill(cell())) {
                stood = -1;
            }
        }
        return stood;
    }

private Q_SLOTS:
    // On a low screen, there is space either for the route buttons or for the values of the waypoint. A
    // button switches between them.
    void onALowScreenButtonsReplaceTheWaypointValues() {
        window().setTheme("light");
        teach({0.2, 0.4}, 0);
        window().resize(1280, 720);
        cell().advanceMs(40);
        auto& place = bench_->find<QPushButton>("waypoint.details.place");
        auto& figures = bench_->find<QWidget>("waypoint.details.x");
        QVERIFY(place.isVisible() && figures.isVisible() && !through().isVisible());
        const QSize before = tab().size();
        QTest::mouseClick(&place, Qt::LeftButton);
        cell().advanceMs(40);
        QVERIFY(place.isVisible() && !figures.isVisible());
        QCOMPARE(tab().size(), before);
        for (const char* name : {"waypoint.goThrough", "waypoint.stepBack", "waypoint.stepOn"}) {
            QVERIFY2(key(name).isVisible() && tab().rect().contains(key(name).geometry().translated(
                                                  key(name).parentWidget()->mapTo(&tab(), QPoint()))),
                     name);
        }
        keepPicture(window(), QStringLiteral("go-through-low"));
        hold(through());
        QVERIFY(until([&] { return isAt(0); }));
        release(through());
        QTest::mouseClick(&place, Qt::LeftButton);
        cell().advanceMs(40);
        QVERIFY(figures.isVisible() && !through().isVisible());
        // On a higher screen, there is space for both, and the switch is hidden.
        window().resize(1920, 1080);
        cell().advanceMs(40);
        QVERIFY(!place.isVisible() && figures.isVisible() && through().isVisible());
    }

    void routeButtonsAreVisibleOnAnOrdinaryScreen() {
        window().setTheme("light");
        teach({0.2, 0.4}, 0);
        window().resize(1920, 1080);
        cell().advanceMs(40);
        for (const char* name : {"waypoint.goThrough", "waypoint.stepBack", "waypoint.stepOn"}) {
            QVERIFY2(key(name).isVisible(), qPrintable(QStringLiteral("row %1, tab %2 x %3, minimum %4")
                                                           .arg(key(name).parentWidget()->sizeHint().width())
                                                           .arg(tab().width())
                                                           .arg(tab().height())
                                                           .arg(tab().minimumSizeHint().height())));
        }
    }

    void theRouteVisitsAllWaypointsInOrder() {
        teach({0.2, 0.4, 0.1}, 0);
        hold(through());
        QVERIFY(isMarked(0));
        QVERIFY2(coming().contains("1 of 3") && coming().contains("point 1"), qPrintable(coming()));
        for (int row = 0; row < 3; ++row) {
            QVERIFY(until([&] { return isAt(row); }));
        }
        QVERIFY(until([&] { return !through().isHolding(); }));
        release(through());
        cell().advanceMs(40);
        QVERIFY(isAt(2));
        QVERIFY2(coming().startsWith("Done"), qPrintable(coming()));
        for (int row = 0; row < 3; ++row) {
            QVERIFY(!isMarked(row));
        }
        // The next press begins at the first waypoint.
        hold(through());
        QVERIFY(until([&] { return isAt(0); }));
        release(through());
    }

    void releasePausesAndTheNextPressContinues() {
        teach({0.3, 0.6, 0.9}, 0);
        hold(through());
        QVERIFY(until([&] { return isMarked(1); }));
        cell().advanceMs(300);
        release(through());
        QVERIFY(timeToStandstill(cell()) >= 0);
        QVERIFY(!isAt(0) && !isAt(1));
        QVERIFY2(isMarked(1), "the next waypoint is not marked during the pause");
        const JointPositions paused = cell().truth().q;
        cell().advanceMs(1000);
        QVERIFY((cell().truth().q.values - paused.values).cwiseAbs().maxCoeff() < 1e-4);

        hold(through());
        double nearest = 1;
        QVERIFY(until([&] {
            nearest = std::min(nearest, apart(0));
            return isAt(1);
        }));
        QVERIFY2(nearest > 0.01, "the route started from the first waypoint again");
        QVERIFY(until([&] { return isAt(2); }));
        release(through());
    }

    void stepForwardAndStepBack() {
        teach({0.2, 0.4, 0.6}, 0.02);
        QVERIFY2(!key("waypoint.stepBack").isEnabled(), "stepping back is possible before the first step");
        step("waypoint.stepOn");
        QVERIFY(isAt(0));
        step("waypoint.stepOn");
        QVERIFY(isAt(1));
        cell().advanceMs(500);
        QVERIFY2(isAt(1), "one step passed more than one waypoint");
        step("waypoint.stepBack");
        QVERIFY(isAt(0));
        QVERIFY(isMarked(1));
        QVERIFY(!key("waypoint.stepBack").isEnabled());
        step("waypoint.stepOn");
        QVERIFY(isAt(1));
        step("waypoint.stepOn");
        QVERIFY(isAt(2));
        QVERIFY2(coming().startsWith("Done"), qPrintable(coming()));
    }

    void aLoopRepeatsUntilTheMaximumHoldTime() {
        teach({0.05, 0.1}, 0);
        window().findChild<QCheckBox*>("waypoint.routeLoop")->click();
        hold(through());
        for (int round = 0; round < 3; ++round) {
            QVERIFY(until([&] { return isAt(1); }));
            QVERIFY(until([&] { return isAt(0); }));
        }
        QVERIFY2(until([&] { return !through().isHolding(); }, 25'000),
                 "the maximum hold time did not end the loop");
        QVERIFY(timeToStandstill(cell()) >= 0);
        release(through());
    }

    // After reaching the waypoint, the arm would only wait while the button is held.
    void aLoopOfOneWaypointIsNotStarted() {
        teach({0.1}, 0);
        QVERIFY(through().isEnabled());
        window().findChild<QCheckBox*>("waypoint.routeLoop")->click();
        QVERIFY(!through().isEnabled());
        QVERIFY2(through().toolTip().contains("at least two waypoints"), qPrintable(through().toolTip()));
        QVERIFY(key("waypoint.stepOn").isEnabled());
        window().findChild<QCheckBox*>("waypoint.routeLoop")->click();
        QVERIFY(through().isEnabled());
    }

    void theRouteStartsAtTheSelectedWaypoint() {
        teach({0.1, 0.2, 0.3, 0.4}, 0);
        tab().selectRow(2);
        hold(through());
        double nearest = 1;
        QVERIFY(until([&] {
            nearest = std::min(nearest, std::min(apart(0), apart(3)));
            return isAt(2);
        }));
        QVERIFY(until([&] { return isAt(3); }));
        release(through());
        cell().advanceMs(40);

        auto* table = window().findChild<QAbstractItemView*>("waypoint.table");
        window().findChild<QComboBox*>("waypoint.routeScope")->setCurrentIndex(1);
        table->selectionModel()->select(table->model()->index(0, 0),
                                        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        table->selectionModel()->select(table->model()->index(2, 0),
                                        QItemSelectionModel::Select | QItemSelectionModel::Rows);
        QVERIFY2(coming().contains("2 waypoints"), qPrintable(coming()));
        hold(through());
        QVERIFY(until([&] { return isAt(0); }));
        QVERIFY(until([&] { return isAt(2); }));
        QVERIFY(until([&] { return !through().isHolding(); }));
        release(through());
    }

    // With blends, the arm does not stop along the path. It does not reach the corner itself, and it ends at
    // the last point.
    void blendedWaypointsAreOnePath() {
        teach({0.3, 0.6, 0.9}, 0.03);
        project::Waypoint corner = document().waypoints().at(1);
        JointPositions q = corner.joints;
        q[1] -= 0.2;
        corner =
            *project::taughtAt(corner, q, kinematics::forwardTcp(document().robot().dh, q, corner.tcpOffset),
                               corner.tcpOffset, document().frames());
        document().changeWaypoint(1, corner, "raised");
        drive();
        hold(through());
        QVERIFY(until([&] { return !standsStill(cell()); }));
        double slowest = 1;
        double nearest = 1;
        bool passed = false;
        QVERIFY(until([&] {
            nearest = std::min(nearest, apart(1));
            passed = passed || isMarked(2);
            if (tcpSpeed(cell()) < slowest && cell().truth().q[0] > this->q(0)[0] - 0.2 && !isAt(2) &&
                apart(2) > 0.15) {
                slowest = tcpSpeed(cell());
            }
            return isAt(2);
        }));
        QVERIFY(passed);
        QVERIFY2(slowest > 0.01, qPrintable(QString::number(slowest)));
        QVERIFY2(nearest > 0.001, "the path passes through the blended corner");
        QVERIFY(until([&] { return !through().isHolding(); }));
        release(through());
        QVERIFY(window().session().state().canMove());
    }

    // The selected speed limits every motion, at TCP and elbow, with and without blends.
    void noRouteIsFasterThanTheChosenSpeed_data() {
        QTest::addColumn<double>("blend");
        QTest::addColumn<project::MoveKind>("move");
        QTest::newRow("joint") << 0.0 << project::MoveKind::Joint;
        QTest::newRow("joint, blended") << 0.02 << project::MoveKind::Joint;
        QTest::newRow("line") << 0.0 << project::MoveKind::Linear;
        QTest::newRow("line, blended") << 0.02 << project::MoveKind::Linear;
    }
    void noRouteIsFasterThanTheChosenSpeed() {
        QFETCH(double, blend);
        QFETCH(project::MoveKind, move);
        teach({0.15, 0.3, 0.1}, blend, move);
        window().jogColumn().selectors().setSpeedClass(2);
        const double cap = window().jogColumn().heldSpeed().tcp;
        cell().advanceMs(40);
        hold(through());
        double fastest = 0;
        QVERIFY(until([&] {
            fastest = std::max(fastest, tcpSpeed(cell()));
            return !through().isHolding();
        }));
        release(through());
        QVERIFY(isAt(2));
        QVERIFY2(fastest <= cap * 1.02, qPrintable(QString::number(fastest)));
        QVERIFY2(fastest > cap * 0.5, qPrintable(QString::number(fastest)));
    }

    void everyStageEndsByEveryRule_data() {
        QTest::addColumn<int>("stage");
        QTest::addColumn<int>("end");
        for (int stage = 0; stage < static_cast<int>(std::size(kStages)); ++stage) {
            for (int e = 0; e < static_cast<int>(std::size(kEnds)); ++e) {
                QTest::addRow("%s, %s", kStages[stage], kEnds[e]) << stage << e;
            }
        }
    }
    void everyStageEndsByEveryRule() {
        QFETCH(int, stage);
        QFETCH(int, end);
        const Stage which = static_cast<Stage>(stage);
        const End how = static_cast<End>(end);
        begin(which);
        if (QTest::currentTestFailed()) {
            return;
        }
        QVERIFY2(which == Stage::Sending || !standsStill(cell()), "the arm does not move");
        int ms = 0;
        int bound = kDeathToStandstillMs;
        switch (how) {
            case End::FrozenInterface:
                for (int t = 0; t < 400; t += 2) {
                    cell().advanceWithFrozenInterface(2);
                    ms = standsStill(cell()) ? ms : t + 2;
                }
                break;
            case End::SilentLink:
                cell().robot.silence(true);
                ms = robotAlone(600);
                break;
            case End::ProcessKilled:
                // The operating system closes the sockets of a terminated process. Nothing else is sent.
                cell().robot.closeClients();
                ms = robotAlone(600);
                break;
            case End::WindowClosed:
                this->end(how, keyOf(which));
                ms = robotAlone(600);
                break;
            default:
                bound = kReleaseToStandstillMs;
                this->end(how, keyOf(which));
                ms = timeToStandstill(cell());
                break;
        }
        QVERIFY2(ms >= 0 && ms <= bound, qPrintable(QString::number(ms)));
        // The robot may still receive the rest of the path. The arm must not move before the button is
        // pressed again.
        const Pose rest = cell().truth().tcpPose;
        if (how == End::SilentLink || how == End::ProcessKilled || how == End::WindowClosed) {
            robotAlone(1000);
        } else {
            for (int i = 0; i < 50; ++i) {
                cell().advanceMs(20);
                QTest::qWait(1);  // the path is sent in real time
            }
        }
        QVERIFY2(distanceMm(rest, cell().truth().tcpPose) < 0.05,
                 qPrintable(QString::number(distanceMm(rest, cell().truth().tcpPose))));
        // If only the robot has advanced, the button has not been notified yet.
        if (how != End::WindowClosed && how != End::SilentLink && how != End::ProcessKilled) {
            QVERIFY(!keyOf(which).isHolding());
        }
    }

    // The button is released while the path is being sent, and then pressed again. The path of the new press
    // moves the arm, and the old path does not.
    void aNewPressMovesTheArmAfterACancelledPress() {
        teach({0.2, 0.4}, 0.02);
        for (int i = 0; i < 3; ++i) {
            hold(through());
            release(through());
        }
        QVERIFY2(window().session().state().canMove(),
                 "cancelling a path that is being sent caused a loss of control");
        hold(through());
        QVERIFY(until([&] { return isAt(1); }));
        QVERIFY(until([&] { return !through().isHolding(); }));
        release(through());
    }

    void unreachableWaypointsAreNotStarted() {
        teach({0.2, 0.4}, 0);
        project::Waypoint far = document().waypoints().at(1);
        far.priority = project::TargetKind::Pose;
        far.pose.position = Eigen::Vector3d(3, 0, 0);
        document().changeWaypoint(1, far, "far");
        drive();
        QVERIFY(!through().isEnabled());
        QVERIFY2(through().toolTip().contains("point 2"), qPrintable(through().toolTip()));
        QVERIFY2(key("waypoint.stepOn").isEnabled(),
                 "a step to the first waypoint, which is reachable, is disabled");
    }

    void anEditWhileTheButtonIsHeldEndsTheRun() {
        teach({0.4, 0.8}, 0);
        hold(through());
        cell().advanceMs(300);
        document().removeWaypoints({1});
        QVERIFY(!through().isHolding());
        QVERIFY(timeToStandstill(cell()) <= kReleaseToStandstillMs);
        release(through());
    }
};

QTEST_MAIN(TestGoThrough)
#include "tst_go_through.moc"
