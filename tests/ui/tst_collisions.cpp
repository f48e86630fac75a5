// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arm does not move into known obstacles. Every bounded motion of the window is refused with the reason,
// and a jog ends at the distance that its button displays.

#include <QAction>
#include <QLabel>
#include <QTest>
#include <algorithm>

#include "app/action_table.h"
#include "robot/collision/collision_check.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/event_spy.h"
#include "tests/support/jog_window_test.h"
#include "tests/support/pictures.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/segmented_control.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/travel_watch.h"
#include "widgets/project/undoable_document.h"
#include "widgets/tools/cell_page.h"
#include "widgets/tools/tools_tab.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestCollisions : public JogWindowTest {
    Q_OBJECT

private:
    UndoableDocument& document() { return window().document(); }
    const SessionState& state() { return window().session().state(); }
    const DhParameters& dh() { return state().dh; }

    /// Adds a cube in the base frame.
    void addCrate(const Eigen::Vector3d& centre, double edge) {
        project::CellBox box;
        box.id = QUuid::createUuid();
        box.name = QStringLiteral("crate");
        box.pose = Pose(centre.x(), centre.y(), centre.z(), 0, 0, 0);
        box.size = Eigen::Vector3d::Constant(edge);
        project::CellGeometry cell = document().cell();
        cell.boxes.append(box);
        document().changeCell(cell, QStringLiteral("crate"));
        cell_->advanceMs(40);
    }
    /// Adds a table below the wrist, at this distance from the lowest body of the wrist [m].
    void addTable(double gap) {
        double low = 1e9;
        const auto bodies =
            collision::placedCapsules(collision::armCapsules(robotModel(state().model)), dh(), state().q);
        for (const collision::LinkCapsule& body : bodies) {
            if (body.link >= 4) {
                low = std::min(low, std::min(body.shape.from.z(), body.shape.to.z()) - body.shape.radius);
            }
        }
        constexpr double kThick = 0.04;
        project::CellBox table;
        table.id = QUuid::createUuid();
        table.name = QStringLiteral("table");
        table.pose =
            Pose(state().tcpPose.position.x(), state().tcpPose.position.y(), low - gap - kThick / 2, 0, 0, 0);
        table.size = {0.3, 0.3, kThick};
        project::CellGeometry cell = document().cell();
        cell.boxes.append(table);
        document().changeCell(cell, QStringLiteral("table"));
        cell_->advanceMs(40);
    }
    void addWaypoint(const QString& name, const JointPositions& q, project::MoveKind move) {
        window().waypoints().teach();
        const int row = document().waypoints().size() - 1;
        project::Waypoint point = document().waypoints().at(row);
        point.name = name;
        point.joints = q;
        point.pose = kinematics::forwardTcp(dh(), q, point.tcpOffset);
        point.move = move;
        document().changeWaypoint(row, point, name);
    }
    JointPositions turned(int joint, double by) {
        JointPositions q = state().q;
        q[joint] += by;
        return q;
    }
    QString reachText(int row) {
        const WaypointModel& model = window().waypoints().model();
        return model.data(model.index(row, WaypointModel::ReachColumn), Qt::DisplayRole).toString();
    }
    bool isShown(const QString& text) {
        for (const QLabel* label : window().findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(text)) {
                return true;
            }
        }
        const auto* line = window().findChild<LimiterLine*>();
        return (line->limiter().what + line->limiter().advice).contains(text);
    }
    /// segment  0: hold; 1 ... 3: steps of 0.1, 1 and 10 mm
    void chooseMotion(int segment) {
        window().findChild<SegmentedControl*>(QStringLiteral("jogMotion"))->setCurrentIndex(segment);
    }
    void drive() {
        QVector<HoldToRunButton*> keys = window().jogColumn().holdKeys();
        for (const char* name :
             {"waypoint.goThrough", "waypoint.stepOn", "waypoint.stepBack", "waypoint.goTo"}) {
            keys << &key(name);
        }
        driveKeys(*cell_, keys, &window().jogColumn().axisJog());
        cell_->advanceMs(40);
    }
    /// Presses a button and verifies that there is no motion and that the reason is shown.
    void verifyRefused(const char* name, const QString& reason) {
        const JointPositions before = cell_->truth().q;
        press(key(name));
        cell_->advanceMs(600);
        QVERIFY2((cell_->truth().q.values - before.values).cwiseAbs().maxCoeff() < 1e-4, name);
        QVERIFY2(isShown(reason), name);
        release(key(name));
        cell_->advanceMs(100);
    }
    VirtualCell* cell_ = nullptr;

private Q_SLOTS:
    void goToAndGoThroughAreRefusedWithTheReason_data() {
        QTest::addColumn<bool>("linear");
        QTest::newRow("MoveJ") << false;
        QTest::newRow("MoveL") << true;
    }
    void goToAndGoThroughAreRefusedWithTheReason() {
        cell_ = &cell();
        QFETCH(const bool, linear);
        addWaypoint("far", turned(0, 0.8), linear ? project::MoveKind::Linear : project::MoveKind::Joint);
        window().waypoints().selectWaypoint(document().waypoints().at(0).id);
        cell_->advanceMs(100);
        QTRY_COMPARE_WITH_TIMEOUT(reachText(0), QStringLiteral("✓"), 60'000);
        const Pose target = kinematics::forwardTcp(dh(), turned(0, 0.8), state().tcpOffset);
        const Eigen::Vector3d between =
            linear ? Eigen::Vector3d((state().tcpPose.position + target.position) / 2)
                   : kinematics::forwardTcp(dh(), turned(0, 0.4), state().tcpOffset).position;
        addCrate(between, 0.06);
        QTRY_VERIFY2_WITH_TIMEOUT(reachText(0) == QStringLiteral("✕ path"), qPrintable(reachText(0)), 60'000);
        drive();
        verifyRefused("waypoint.goTo", QStringLiteral("Move refused: "));
        verifyRefused("waypoint.goTo", QStringLiteral("collides with “crate” after"));
        verifyRefused("waypoint.goThrough", QStringLiteral("collides with “crate” after"));
        verifyRefused("waypoint.stepOn", QStringLiteral("collides with “crate” after"));
        keepPicture(window(), QStringLiteral("collision-refused"));

        // The motion is possible without the crate.
        document().undoStack().undo();
        cell_->advanceMs(100);
        QTRY_COMPARE_WITH_TIMEOUT(reachText(0), QStringLiteral("✓"), 60'000);
        const Eigen::Vector3d from = cell_->truth().tcpPose.position;
        press(key("waypoint.goTo"));
        cell_->advanceMs(600);
        release(key("waypoint.goTo"));
        QVERIFY((cell_->truth().tcpPose.position - from).norm() > 0.005);
    }

    // The position of the object is unknown, so nothing can be checked against it.
    void anObjectWithAMissingFrameEndsMovesUntilItIsResolved() {
        cell_ = &cell();
        addWaypoint("far", turned(0, 0.8), project::MoveKind::Joint);
        window().waypoints().selectWaypoint(document().waypoints().at(0).id);
        QStringList warnings;
        const auto watching =
            test::onMessage(window().session().journal(), this, [&](Severity severity, const QString& text) {
                if (severity == Severity::Warning) {
                    warnings << text;
                }
            });
        project::CellBox box;
        box.id = QUuid::createUuid();
        box.name = QStringLiteral("crate");
        box.frame = QUuid::createUuid();
        box.pose = Pose(0, 0, -3, 0, 0, 0);
        project::CellGeometry without = document().cell();
        project::CellGeometry with = without;
        with.boxes.append(box);
        document().changeCell(with, QStringLiteral("crate"));
        cell_->advanceMs(40);
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings[0].contains("“crate”") && warnings[0].contains("frame"), qPrintable(warnings[0]));
        document().changeCell(with, QStringLiteral("again"));
        QCOMPARE(warnings.size(), 1);
        drive();
        for (const char* name : {"waypoint.goTo", "waypoint.goThrough", "waypoint.stepOn"}) {
            verifyRefused(name, QStringLiteral("The position of “crate” is unknown"));
        }
        const JointPositions path = turned(0, 0.1);
        QVERIFY(!window().session().permitsPath({&path, 1}).ok());
        // A jog is allowed, because the operator watches the arm and may need it to teach the position again.
        const Eigen::Vector3d from = cell_->truth().tcpPose.position;
        press(key("jog.Z+"));
        cell_->advanceMs(600);
        release(key("jog.Z+"));
        cell_->advanceMs(300);
        QVERIFY((cell_->truth().tcpPose.position - from).norm() > 0.002);

        // A new position on the Cell page replaces the missing frame.
        window().findChild<ToolsTab*>()->showPage(ToolsTab::Cell);
        window().showTab(QStringLiteral("tools"));
        auto& page = window().findChild<ToolsTab*>()->cell();
        page.selectRow(0);
        QVERIFY(page.findChild<QLabel*>("cell.facts")->text().contains("missing frame"));
        auto* x = page.findChild<DecimalSpinBox*>("cell.box.x");
        x->setFocus();
        x->selectAll();
        QTest::keyClicks(x, QStringLiteral("300"));
        QTest::keyClick(x, Qt::Key_Return);
        QVERIFY(document().cell().boxes.at(0).frame.isNull());
        cell_->advanceMs(40);
        QVERIFY(window().session().permitsPath({&path, 1}).ok());
        disconnect(watching);
    }

    void theArmDoesNotCollideWithItself() {
        cell_ = &cell();
        // The elbow folds until wrist 1 collides with the upper arm.
        addWaypoint("folded", turned(2, -0.9), project::MoveKind::Joint);
        window().waypoints().selectWaypoint(document().waypoints().at(0).id);
        cell_->advanceMs(100);
        QTRY_COMPARE_WITH_TIMEOUT(reachText(0), QStringLiteral("✕ path"), 60'000);
        drive();
        verifyRefused("waypoint.goTo", QStringLiteral("% of the path"));
    }

    void homeStepsAndBackStopBeforeAnObstacle() {
        cell_ = &cell();
        // In the Home position, the arm is upright.
        const Pose home =
            kinematics::forwardTcp(dh(), JointPositions(0, -1.5707963, 0, -1.5707963, 0, 0), {});
        addCrate(home.position, 0.08);
        verifyRefused("homeKey", QStringLiteral("“crate”"));
        document().undoStack().undo();

        // A step of 10 mm towards a table at a distance of 15 mm would leave 5 mm.
        addTable(0.015);
        chooseMotion(3);
        cell_->advanceMs(40);
        verifyRefused("jog.Z-", QStringLiteral("comes within 10 mm of “table”"));
        const double z = cell_->truth().tcpPose.position.z();
        press(key("jog.Z+"));
        release(key("jog.Z+"));
        cell_->advanceMs(1500);
        QVERIFY2(std::abs(cell_->truth().tcpPose.position.z() - z - 0.01) < 0.0005,
                 "the arm did not move up by 10 mm");
        document().undoStack().undo();
        chooseMotion(0);
        cell_->advanceMs(40);

        // An obstacle is added on the arm's path.
        const Eigen::Vector3d from = state().tcpPose.position;
        jog("jog.Z+", 4000);
        QVERIFY((state().tcpPose.position - from).norm() > 0.15);
        const Eigen::Vector3d crate = from - Eigen::Vector3d(0, 0, 0.05);
        addCrate(crate, 0.04);
        const Eigen::Vector3d before = state().tcpPose.position;
        jog("backKey", 8000);
        QVERIFY2((state().tcpPose.position - before).norm() > 0.02,
                 "the arm did not move along the unobstructed part of the path");
        QVERIFY((state().tcpPose.position - crate).norm() > 0.03);
    }

    // If the arm is inside the safety distance, it may move away from the obstacle, but not closer.
    void leavingTheSafetyDistanceIsAllowed() {
        cell_ = &cell();
        addTable(0.004);
        chooseMotion(2);
        cell_->advanceMs(40);
        verifyRefused("jog.Z-", QStringLiteral("“table”"));
        const double z = cell_->truth().tcpPose.position.z();
        press(key("jog.Z+"));
        release(key("jog.Z+"));
        cell_->advanceMs(1000);
        QVERIFY(std::abs(cell_->truth().tcpPose.position.z() - z - 0.001) < 0.0003);
        chooseMotion(0);
        cell_->advanceMs(40);
        jog("jog.Z+", 1000);
        QVERIFY(cell_->truth().tcpPose.position.z() - z > 0.02);
    }

    void aJogEndsAtTheDistanceOnItsKey_data() {
        QTest::addColumn<int>("speed");
        for (int speed = 1; speed < kSpeedClassCount; ++speed) {
            QTest::newRow(qPrintable(QString::number(speed))) << speed;
        }
    }
    void aJogEndsAtTheDistanceOnItsKey() {
        cell_ = &cell();
        QFETCH(const int, speed);
        addTable(0.08);
        window().jogColumn().selectors().setSpeedClass(speed);
        cell_->advanceMs(40);
        for (int i = 0; i < 12; ++i) {
            window().jogColumn().travel().look();
        }
        auto& down = static_cast<JogKey&>(key("jog.Z-"));
        QCOMPARE(down.travel(), QStringLiteral("70 mm"));
        const double z = cell_->truth().tcpPose.position.z();
        press(down);
        for (int ms = 0; down.isHolding() && ms < 15000; ms += 20) {
            cell_->advanceMs(20);
        }
        QVERIFY2(!down.isHolding(), "the jog does not end by itself");
        release(down);
        QVERIFY(timeToStandstill(*cell_) >= 0);
        cell_->advanceMs(100);
        QVERIFY2(std::abs(z - cell_->truth().tcpPose.position.z() - 0.070) < 0.001,
                 qPrintable(QString::number(z - cell_->truth().tcpPose.position.z())));
        QVERIFY2(isShown(QStringLiteral("is 10 mm from “table”")),
                 qPrintable(window().findChild<LimiterLine*>()->limiter().what));
        QVERIFY2(isShown(QStringLiteral("jog Z+")), "the direction away from the obstacle is not shown");
        keepPicture(window(), QStringLiteral("collision-limiter"));
    }

    // The arm does not move during this test.
    void theLimiterLineFollowsAnEditOfTheCell() {
        cell_ = &cell();
        cell_->advanceMs(300);
        const auto* line = window().findChild<LimiterLine*>();
        QVERIFY2(!isShown(QStringLiteral("table")), qPrintable(line->limiter().what));
        addTable(0.015);
        cell_->advanceMs(200);
        QVERIFY2(isShown(QStringLiteral("is 15 mm from “table”")), qPrintable(line->limiter().what));
        document().changeCell({}, QStringLiteral("no table"));
        cell_->advanceMs(200);
        QVERIFY2(!isShown(QStringLiteral("table")), qPrintable(line->limiter().what));
    }
    // The display is never empty during the calculation. It shows the previous number, marked as outdated, or
    // a symbol for a calculation in progress.
    void aValueOnAKeyIsMarkedWhileItIsRecalculated() {
        cell_ = &cell();
        addTable(0.08);
        TravelWatch& travel = window().jogColumn().travel();
        const auto lookAtAll = [&] {
            for (int i = 0; i < 12; ++i) {
                travel.look();
            }
        };
        lookAtAll();
        auto& down = static_cast<JogKey&>(key("jog.Z-"));
        QCOMPARE(down.travel(), QStringLiteral("70 mm"));
        QVERIFY(!down.isTravelOutdated());
        addTable(0.05);
        travel.look();
        const auto& keys = window().findChild<JogPad*>()->keys();
        QVERIFY(
            std::any_of(keys.begin(), keys.end(), [](const JogKey* any) { return any->isTravelOutdated(); }));
        QVERIFY(!down.travel().isEmpty());
        lookAtAll();
        QCOMPARE(down.travel(), QStringLiteral("40 mm"));
        QVERIFY(std::none_of(keys.begin(), keys.end(),
                             [](const JogKey* any) { return any->isTravelOutdated(); }));
        travel.reset();  // after a change of units
        QVERIFY2(!down.travel().isEmpty(), "the distances are not shown after a change of units");
        cell_->robot.protectiveStop();
        cell_->advanceMs(200);
        travel.look();
        QVERIFY(!window().session().state().canMove());
        QVERIFY2(down.isTravelOutdated(), "the distances are not marked as outdated after a stop");
    }

    void theCellIsEditedInTheWindow() {
        cell_ = &cell();
        window().findChild<ToolsTab*>()->showPage(ToolsTab::Cell);
        window().showTab(QStringLiteral("tools"));
        auto& page = window().findChild<ToolsTab*>()->cell();
        const auto trigger = [&](const char* name) {
            auto* action = window().actions().find(QStringLiteral("cell.action.") + QLatin1String(name));
            QVERIFY2(action != nullptr, name);
            action->trigger();
        };
        const auto enter = [&](const char* name, const QString& text) {
            auto* box = page.findChild<DecimalSpinBox*>(QLatin1String(name));
            QVERIFY2(box != nullptr && box->isVisible(), name);
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Return);
        };
        trigger("box");
        QCOMPARE(document().cell().boxes.size(), std::size_t(1));
        enter("cell.box.x", QStringLiteral("300"));
        enter("cell.size.2", QStringLiteral("250"));
        QVERIFY(std::abs(document().cell().boxes.at(0).pose.position.x() - 0.3) < 1e-9);
        QVERIFY(std::abs(document().cell().boxes.at(0).size.z() - 0.25) < 1e-9);
        cell_->advanceMs(40);
        QCOMPARE(state().check->surroundings().obstacles.size(), std::size_t(1));
        QVERIFY(std::abs(state().check->surroundings().obstacles[0].size.z() - 0.25) < 1e-9);

        // A disabled object is neither checked nor displayed. After undo it is checked and displayed again.
        trigger("enable");
        cell_->advanceMs(40);
        QVERIFY(state().check->surroundings().obstacles.empty());
        document().undoStack().undo();
        cell_->advanceMs(40);
        QCOMPARE(state().check->surroundings().obstacles.size(), std::size_t(1));

        // Add a plane through the TCP, normal to the tool, with the arm on the permitted side.
        trigger("plane");
        QCOMPARE(document().cell().planes.size(), std::size_t(1));
        const Pose plane = document().cell().planes.at(0).pose;
        QVERIFY((plane.position - state().tcpPose.position).norm() < 1e-9);
        const Eigen::Vector3d tool = rotationMatrix(state().tcpPose.rotation).col(2);
        QVERIFY((rotationMatrix(plane.rotation).col(2) + tool).norm() < 1e-9);
        enter("cell.normal.0", QStringLiteral("1"));
        QVERIFY(rotationMatrix(document().cell().planes.at(0).pose.rotation).col(2).x() > 0.5);
        trigger("delete");
        QVERIFY(document().cell().planes.isEmpty());

        const Eigen::Vector3d first = state().tcpPose.position;
        trigger("corner");
        for (const char* name : {"jog.X+", "jog.Y+", "jog.Z+"}) {
            jog(name, 800);
        }
        trigger("corner");
        QCOMPARE(document().cell().boxes.size(), std::size_t(2));
        const project::CellBox taught = document().cell().boxes.at(1);
        QVERIFY((taught.pose.position - (first + state().tcpPose.position) / 2).norm() < 0.001);
        QVERIFY((taught.size - (state().tcpPose.position - first).cwiseAbs()).norm() < 0.001);
        document().undoStack().undo();
        QCOMPARE(document().cell().boxes.size(), std::size_t(1));

        trigger("floor");
        QVERIFY(document().cell().floor.has_value());
        QVERIFY(std::abs(*document().cell().floor - state().tcpPose.position.z()) < 1e-9);
        enter("cell.safetyDistance", QStringLiteral("25"));
        QVERIFY(std::abs(document().cell().safetyDistance - 0.025) < 1e-9);
        cell_->advanceMs(40);
        QVERIFY(std::abs(state().check->safetyDistance() - 0.025) < 1e-9);
        keepPicture(window(), QStringLiteral("cell-page"));
        // Each edit is an undo step with its own name.
        QVERIFY(document().undoStack().undoText().contains(QStringLiteral("safety distance")));
        while (document().undoStack().canUndo()) {
            document().undoStack().undo();
        }
        QVERIFY(document().cell().isEmpty());
        QCOMPARE(document().cell().safetyDistance, project::kDefaultSafetyDistance);
    }
};

QTEST_MAIN(TestCollisions)
#include "tst_collisions.moc"
