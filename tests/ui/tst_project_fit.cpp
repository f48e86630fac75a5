// SPDX-License-Identifier: GPL-3.0-or-later
//
// A project that was taught with another robot model or TCP, in the real window with a simulated UR5e in
// virtual time. The arm must not move to positions of the project before the user has answered.

#include <QAction>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/project_file.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/notice_bar.h"
#include "widgets/project/project_files.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

const JointPositions kStart(-1.6, -1.7, -2.2, -0.8, 1.6, 0.2);

JointPositions turned(double by) {
    JointPositions q = kStart;
    q[0] += by;
    return q;
}

/// A project with two waypoints and Home near the initial position of the arm.
project::Project taughtWith(RobotModelId model, const Pose& tcp = {}) {
    project::Project project;
    project.robot = model;
    for (const double by : {0.1, 0.2}) {
        project::Waypoint point;
        point.id = QUuid::createUuid();
        point.name = project.waypoints.nextName(QStringLiteral("point"));
        const JointPositions q = turned(by);
        project.waypoints.append(*project::taughtAt(
            point, q, kinematics::forwardTcp(robotModel(model).dh, q, tcp), tcp, project.frames));
    }
    project.positions.list = {{QUuid::createUuid(), QStringLiteral("Home"), turned(-0.1), {}, {}}};
    project.positions.home = project.positions.list.at(0).id;
    return project;
}

}  // namespace

class TestProjectFit : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;
    QStringList said_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    UndoableDocument& document() { return window().document(); }
    HoldToRunButton& key(const char* name) { return bench_->find<HoldToRunButton>(name); }

    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    void bringUp() {
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), window().findChildren<HoldToRunButton*>().toVector());
        QVERIFY(until([this] { return window().session().state().modelKnown; }));
    }
    void open(const project::Project& project) {
        const QString path = bench_->folder.filePath("cell.tiller");
        QVERIFY(project::saveProject(path, project).ok());
        window().openProject(path);
        window().showTab("waypoints");
        QCOMPARE(document().waypoints().size(), project.waypoints.size());
        window().selectWaypoint(0);
        cell().advanceMs(40);
    }
    QMessageBox* question() { return window().findChild<QMessageBox*>("projectFit"); }
    void answer(const char* button) {
        QVERIFY(until([this] { return question() != nullptr && question()->isVisible(); }));
        question()->findChild<QPushButton*>(QLatin1String(button))->click();
        QVERIFY(until([this] { return question() == nullptr; }));
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        cell().advanceMs(40);
    }
    /// Holds this button and returns the distance moved by the TCP [m].
    double movedBy(const char* name) {
        const Pose before = cell().truth().tcpPose;
        press(key(name));
        cell().advanceMs(600);
        release(key(name));
        cell().advanceMs(300);
        return (cell().truth().tcpPose.position - before.position).norm();
    }
    /// Checks that neither the buttons nor the session functions move the arm to a position of the project.
    void nothingMovesToThem() {
        for (const char* name : {"waypoint.goTo", "waypoint.goThrough", "homeKey"}) {
            QVERIFY2(movedBy(name) < 1e-4, name);
            if (question() != nullptr) {
                answer("projectFit.cancel");
            }
        }
        MoveRequest move;
        move.q = turned(0.1);
        move.speed = 0.1;
        move.toProject = true;
        const auto begun = window().session().beginMove(move);
        QVERIFY(!begun.ok());
        QVERIFY2(begun.error().context.contains("project"), qPrintable(begun.error().context));
        const auto path = window().session().beginPath({}, window().session().stops());
        QVERIFY(!path.ok());
        QCOMPARE(path.error().code, ErrorCode::Cancelled);
        QCoreApplication::processEvents();
        if (question() != nullptr) {
            answer("projectFit.cancel");
        }
    }
    double offFrom(const Pose& place) { return (cell().truth().tcpPose.position - place.position).norm(); }
    void goTo(int row) {
        window().selectWaypoint(row);
        cell().advanceMs(40);
        QVERIFY2(key("waypoint.goTo").isEnabled(), qPrintable(key("waypoint.goTo").toolTip()));
        press(key("waypoint.goTo"));
        cell().advanceMs(300);
        cell().advanceUntil([this] { return standsStill(cell()); }, 60'000);
        release(key("waypoint.goTo"));
        cell().advanceMs(100);
    }

private Q_SLOTS:
    void init() {
        simulator::SimulatorOptions options = VirtualCell::options();
        options.startJoints = kStart;
        bench_ = std::make_unique<WindowBench>(options);
        bench_->show();
        said_.clear();
        test::onMessage(window().session().journal(), this,
                        [this](Severity, const QString& text) { said_ << text; });
    }
    void cleanup() { bench_.reset(); }

    void aProjectOfTheSameModelAsksNothing() {
        bringUp();
        open(taughtWith(RobotModelId::UR5e));
        cell().advanceMs(200);
        QCoreApplication::processEvents();
        QVERIFY(question() == nullptr);
        QVERIFY(movedBy("waypoint.goTo") > 0.005);
        QVERIFY(question() == nullptr);
    }

    void nothingMovesBeforeTheQuestionIsAnswered_data() {
        QTest::addColumn<bool>("connectedFirst");
        QTest::newRow("asked when it is opened") << true;
        QTest::newRow("asked when the robot is connected") << false;
    }
    void nothingMovesBeforeTheQuestionIsAnswered() {
        QFETCH(bool, connectedFirst);
        if (connectedFirst) {
            bringUp();
        }
        open(taughtWith(RobotModelId::UR10e));
        if (!connectedFirst) {
            QVERIFY2(document().reach(0).ok(),
                     "without a robot, the reach is not that of the arm of the project");
            bringUp();
        }
        QVERIFY(until([this] { return question() != nullptr; }));
        QVERIFY2(question()->text().contains("UR10e") && question()->text().contains("UR5e"),
                 qPrintable(question()->text()));
        answer("projectFit.cancel");
        for (int row = 0; row < 2; ++row) {
            QVERIFY2(!document().reach(row).ok(), "a waypoint of the other arm is marked as reachable");
        }
        nothingMovesToThem();
        // Positions of the two arm models must not be mixed either.
        QVERIFY(!bench_->find<QPushButton>("waypoint.teach").isEnabled());
        // Motions that do not depend on the project are possible.
        QVERIFY(movedBy("jog.Z+") > 0.005);
        // The question can be shown again.
        window().findChild<QAction*>("project.adapt")->trigger();
        QVERIFY(until([this] { return question() != nullptr; }));
        answer("projectFit.cancel");
        QCOMPARE(document().project().robot, std::optional(RobotModelId::UR10e));
    }

    void theNoticeEndsWithTheConnection() {
        bringUp();
        open(taughtWith(RobotModelId::UR10e));
        answer("projectFit.cancel");
        auto* notice = window().waypoints().findChild<NoticeBar*>();
        QVERIFY(notice->isVisible());
        // The text names the different arm model as the reason for the missing ghost, instead of the reach.
        const QString ghost = window().findChild<SceneView*>()->ghostText();
        QVERIFY2(ghost.contains("a different robot model"), qPrintable(ghost));
        window().session().disconnectFromRobot();
        QVERIFY(until([&] { return !notice->isVisible(); }));
    }

    void keptPosesStayInPlace() {
        bringUp();
        const project::Project before = taughtWith(RobotModelId::UR10e);
        open(before);
        const int steps = document().undoStack().count();
        answer("projectFit.poses");
        QCOMPARE(document().undoStack().count(), steps + 1);
        QVERIFY(document().reach(0).ok());
        goTo(0);
        QVERIFY2(offFrom(before.waypoints.at(0).pose) < 0.001,
                 qPrintable(QString::number(1e3 * offFrom(before.waypoints.at(0).pose))));
        // After undo, the project belongs to the other arm model again, and the question is shown again.
        document().undo();
        QVERIFY(document().waypoints().at(0).joints == before.waypoints.at(0).joints);
        QCOMPARE(document().project().robot, std::optional(RobotModelId::UR10e));
        QVERIFY(!document().reach(0).ok());
        nothingMovesToThem();
    }

    void keptJointsGiveTheSamePosture() {
        bringUp();
        const project::Project before = taughtWith(RobotModelId::UR10e);
        open(before);
        answer("projectFit.joints");
        QVERIFY(document().waypoints().at(0).joints == before.waypoints.at(0).joints);
        goTo(0);
        QVERIFY((cell().truth().q.values - before.waypoints.at(0).joints.values).cwiseAbs().maxCoeff() <
                0.002);
        QVERIFY2(offFrom(document().waypoints().at(0).pose) < 0.001,
                 "the pose was not computed for this arm");
    }

    void unreachableWaypointsAreNamed() {
        bringUp();
        project::Project project = taughtWith(RobotModelId::UR10e);
        project::Waypoint far = project.waypoints.at(0);
        far.id = QUuid::createUuid();
        far.name = QStringLiteral("far");
        far = *project::taughtAt(far, JointPositions(0.4, -0.4, 0.3, -0.3, 1.5, 0),
                                 kinematics::forwardTcp(robotModel(RobotModelId::UR10e).dh,
                                                        JointPositions(0.4, -0.4, 0.3, -0.3, 1.5, 0)),
                                 {}, project.frames);
        project.waypoints.append(far);
        open(project);
        answer("projectFit.poses");
        QVERIFY2(said_.join('\n').contains("Out of reach: far"), qPrintable(said_.join('\n')));
        QVERIFY(document().reach(0).ok() && !document().reach(2).ok());
    }

    // A file without a robot model, or a project without positions, uses the connected model. No question is
    // shown.
    void projectWithoutAModelTakesTheConnectedModel() {
        bringUp();
        project::Project project = taughtWith(RobotModelId::UR10e);
        project.robot.reset();
        open(project);
        QVERIFY(until([this] { return document().project().robot == RobotModelId::UR5e; }));
        QVERIFY(question() == nullptr);
        QVERIFY(!window().files().store().isModified());
        project::Project empty;
        empty.robot = RobotModelId::UR10e;
        const QString path = bench_->folder.filePath("empty.tiller");
        QVERIFY(project::saveProject(path, empty).ok());
        window().openProject(path);
        QVERIFY(until([this] { return document().project().robot == RobotModelId::UR5e; }));
        QVERIFY(question() == nullptr);
    }

    // The TCP question appears when the user wants to move the arm.
    void anotherTcpAsksBeforeAnythingMoves() {
        bringUp();
        project::Project project = taughtWith(RobotModelId::UR5e, Pose(0, 0, 0.15, 0, 0, 0));
        project.tooling.tools.append({QUuid::createUuid(), "gripper", Pose(0, 0, 0.15, 0, 0, 0), 0, {}, {}});
        project.tooling.activeTool = project.tooling.tools.at(0).id;
        open(project);
        cell().advanceMs(200);
        QVERIFY2(question() == nullptr, "the question appeared before a motion was requested");
        QVERIFY(movedBy("waypoint.goTo") < 1e-4);
        QVERIFY(until([this] { return question() != nullptr; }));
        QVERIFY2(question()->text().contains("gripper"), qPrintable(question()->text()));
        answer("projectFit.cancel");
        QVERIFY(movedBy("homeKey") < 1e-4);
        answer("projectFit.setTcp");
        QVERIFY(until([this] { return window().session().state().tcpOffset.position.z() > 0.149; }));
        QVERIFY(movedBy("waypoint.goTo") > 0.005);
        QVERIFY(question() == nullptr);
    }

    void theTcpOfTheRobotMayBeKept() {
        bringUp();
        open(taughtWith(RobotModelId::UR5e, Pose(0, 0, 0.15, 0, 0, 0)));
        QVERIFY(movedBy("waypoint.goTo") < 1e-4);
        answer("projectFit.keepTcp");
        QVERIFY(movedBy("waypoint.goTo") > 0.005);
        QVERIFY(question() == nullptr);
    }
};

QTEST_MAIN(TestProjectFit)
#include "tst_project_fit.moc"
