// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <memory>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/document/waypoint_clipboard.h"
#include "robot/station/route/waypoint_motion.h"
#include "robot/station/text/reach_words.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoint_model.h"

using namespace tiller;
using project::MoveKind;
using project::TargetKind;
using project::Waypoint;

namespace {

const JointPositions kStart(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

Waypoint at(const QString& name, const JointPositions& q) {
    Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.joints = q;
    point.pose = kinematics::forwardTcp(dh(), q);
    return point;
}

QString names(const ProjectDocument& document) {
    QStringList result;
    for (const Waypoint& point : document.waypoints()) {
        result << point.name;
    }
    return result.join(',');
}

QString cell(const WaypointModel& model, int row, int column) {
    return model.index(row, column).data(Qt::DisplayRole).toString();
}

}  // namespace

class TestWaypointModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        document_ = std::make_unique<UndoableDocument>();
        model_ = std::make_unique<WaypointModel>(*document_);
        tester_ = std::make_unique<QAbstractItemModelTester>(
            model_.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        project::Project cell;
        tray_ = QUuid::createUuid();
        cell.frames.append({tray_, "Tray A", Pose(-0.3, -0.4, 0.1, 0, 0, 0.4), {}});
        for (const char* name : {"home", "approach", "above tray", "pick"}) {
            cell.waypoints.append(at(name, kStart));
        }
        Waypoint linear = cell.waypoints.at(2);
        linear.move = MoveKind::Linear;
        linear.priority = TargetKind::Pose;
        linear.blend = 0.005;
        cell.waypoints.replace(2, linear);
        document_->setProject(cell);
    }

    void cleanup() {
        tester_.reset();
        model_.reset();
        document_.reset();
    }

    void columnsHaveTheDesignedFormat() {
        QCOMPARE(model_->index(1, WaypointModel::Number).data(Qt::AccessibleTextRole).toString(),
                 QString("# 2"));
        QCOMPARE(cell(*model_, 0, WaypointModel::Move), QString("J"));
        QCOMPARE(cell(*model_, 0, WaypointModel::Frame), QString("—"));
        QCOMPARE(cell(*model_, 0, WaypointModel::Speed), QString("60 °/s"));
        QCOMPARE(cell(*model_, 0, WaypointModel::ReachColumn), QString("✓"));
        QCOMPARE(cell(*model_, 2, WaypointModel::Frame), QString("Base"));
        QCOMPARE(cell(*model_, 2, WaypointModel::Speed), QString("250 mm/s"));
        QCOMPARE(cell(*model_, 2, WaypointModel::Blend), QString("5"));
        QCOMPARE(model_->headerData(5, Qt::Horizontal, Qt::DisplayRole).toString(), QString("Blend mm"));
    }

    void unreachableWaypointIsLabelled() {
        Waypoint far = document_->waypoints().at(2);
        far.pose.position = Eigen::Vector3d(2, 0, 0.3);
        document_->changeWaypoint(2, far, "x");
        QCOMPARE(cell(*model_, 2, WaypointModel::ReachColumn), QString("✕ reach"));
        QVERIFY(!reachAdvice(document_->reach(2)).isEmpty());
        // A longer arm reaches the pose.
        document_->setRobot(robotModel(RobotModelId::UR20));
        far.pose.position = Eigen::Vector3d(1.2, 0, 0.3);
        document_->changeWaypoint(2, far, "x");
        QCOMPARE(cell(*model_, 2, WaypointModel::ReachColumn), QString("✓"));
    }

    // An empty project adopts the model of the connected arm. Waypoints restored by undo were taught with the
    // previous arm.
    void undoRestoresTheModelOfTheWaypoints() {
        project::Project cell = document_->project();
        cell.robot = RobotModelId::UR5e;
        document_->setProject(cell);
        document_->setRobot(robotModel(RobotModelId::UR10e));
        document_->adoptRobot(RobotModelId::UR10e);
        QVERIFY(document_->isOfOtherModel());
        document_->removeWaypoints({0, 1, 2, 3});
        document_->adoptRobot(RobotModelId::UR10e);
        QVERIFY(document_->project().robot == RobotModelId::UR10e);
        document_->insertWaypoints(0, {at("new", kStart)}, "Teach");
        QVERIFY(!document_->isOfOtherModel());
        document_->undo();
        QVERIFY(document_->project().robot == RobotModelId::UR10e);
        document_->undo();
        QVERIFY(document_->project() == cell);
        QVERIFY(document_->isOfOtherModel());
        QVERIFY(document_->reach(0).obstacle == project::Reach::Obstacle::OtherModel);
        document_->redo();
        document_->redo();
        QVERIFY(document_->project().robot == RobotModelId::UR10e);
        QVERIFY(!document_->isOfOtherModel());
        // A project that was opened in the meantime has its own arm model.
        document_->setProject(cell);
        QVERIFY(document_->project().robot == RobotModelId::UR5e);
    }

    void everyEditCanBeUndoneAndRedone() {
        const project::Project before = document_->project();
        document_->insertWaypoints(1, {at("new", kStart)}, "Teach");
        document_->removeWaypoints({0, 3});
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Name), "renamed", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Move), "L", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Speed), "100 mm/s", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Blend), "2,5", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Frame), "Tray A", Qt::EditRole));
        document_->moveWaypointsBefore({0}, 3);
        const project::Project after = document_->project();
        QCOMPARE(names(*document_), QString("approach,pick,renamed"));
        QCOMPARE(document_->undoStack().count(), 8);
        while (document_->undoStack().canUndo()) {
            document_->undoStack().undo();
        }
        QVERIFY(document_->project() == before);
        while (document_->undoStack().canRedo()) {
            document_->undoStack().redo();
        }
        QVERIFY(document_->project() == after);
        QVERIFY(std::abs(document_->waypoints().at(2).blend - 0.0025) < 1e-15);
        QVERIFY(std::abs(document_->waypoints().at(2).toolSpeed - 0.1) < 1e-15);
    }

    void unchangedValuesAddNoUndoStep() {
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Name), "home", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, WaypointModel::Move), "J", Qt::EditRole));
        document_->moveWaypointsBefore({1}, 1);
        document_->moveWaypointsBefore({1}, 2);
        QCOMPARE(document_->undoStack().count(), 0);
    }

    void invalidValuesAreRefusedWithAReason() {
        QSignalSpy refused(model_.get(), &WaypointModel::editRefused);
        QVERIFY(!model_->setData(model_->index(0, WaypointModel::Name), "  ", Qt::EditRole));
        QVERIFY(!model_->setData(model_->index(0, WaypointModel::Name), "pick", Qt::EditRole));
        QVERIFY(refused.last()[0].toString().contains("Waypoint 4"));
        QVERIFY(!model_->setData(model_->index(0, WaypointModel::Speed), "fast", Qt::EditRole));
        QVERIFY(!model_->setData(model_->index(0, WaypointModel::Speed), "181", Qt::EditRole));
        QVERIFY(refused.last()[0].toString().contains("°/s"));
        QVERIFY(!model_->setData(model_->index(2, WaypointModel::Speed), "1001", Qt::EditRole));
        QVERIFY(!model_->setData(model_->index(2, WaypointModel::Blend), "-1", Qt::EditRole));
        QVERIFY(!model_->setData(model_->index(2, WaypointModel::Frame), "Tray Z", Qt::EditRole));
        QVERIFY(!model_->setData(model_->index(2, WaypointModel::Move), "C", Qt::EditRole));
        QCOMPARE(refused.count(), 7);
        QCOMPARE(document_->undoStack().count(), 0);
    }

    void changingTheFrameKeepsThePosition() {
        const Pose before = *project::poseInBase(document_->waypoints().at(2), document_->frames());
        QVERIFY(model_->setData(model_->index(2, WaypointModel::Frame), "Tray A", Qt::EditRole));
        const Waypoint& moved = document_->waypoints().at(2);
        QCOMPARE(moved.frame, tray_);
        QVERIFY(moved.pose != before);
        const auto off = project::poseDifference(*project::poseInBase(moved, document_->frames()), before);
        QVERIFY(off.distance < 1e-12);
        QVERIFY(off.angle < 1e-12);
        QVERIFY(model_->setData(model_->index(2, WaypointModel::Frame), "—", Qt::EditRole));
        QVERIFY(document_->waypoints().at(2).priority == TargetKind::Joints);
    }

    void draggedRowsLandWhereTheyAreDropped() {
        std::unique_ptr<QMimeData> mime(
            model_->mimeData({model_->index(0, 0), model_->index(0, 1), model_->index(1, 0)}));
        QVERIFY(model_->dropMimeData(mime.get(), Qt::MoveAction, 4, 0, {}));
        QCOMPARE(names(*document_), QString("above tray,pick,home,approach"));
        document_->undoStack().undo();
        QCOMPARE(names(*document_), QString("home,approach,above tray,pick"));
        QMimeData foreign;
        foreign.setText("x");
        QVERIFY(!model_->dropMimeData(&foreign, Qt::MoveAction, 0, 0, {}));
    }

    void selectionFollowsAReorder() {
        const QPersistentModelIndex pick = model_->index(3, 1);
        document_->moveWaypointsBefore({3}, 0);
        QCOMPARE(pick.row(), 0);
        QCOMPARE(pick.data().toString(), QString("pick"));
    }

    void pastedTableRoundTrip() {
        project::FrameList frames = document_->frames();
        QVERIFY(model_->setData(model_->index(2, WaypointModel::Frame), "Tray A", Qt::EditRole));
        std::vector<Waypoint> points(document_->waypoints().begin(), document_->waypoints().end());
        points[3].tcpOffset = Pose(0.01, 0.02, 0.15, 0.1, 0.2, 0.3);
        const QString text = waypoint_clipboard::toText(points, frames);
        const auto back = waypoint_clipboard::fromText(text, frames);
        QVERIFY2(back.ok(), qPrintable(back.error().toString()));
        QCOMPARE(back->size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Waypoint& got = (*back)[i];
            QVERIFY(got.id != points[i].id);
            QCOMPARE(got.name, points[i].name);
            QVERIFY(got.move == points[i].move);
            QVERIFY(got.priority == points[i].priority);
            QCOMPARE(got.frame, points[i].frame);
            QVERIFY((got.joints.values - points[i].joints.values).norm() < 1e-12);
            QVERIFY(project::poseDifference(got.pose, points[i].pose).distance < 1e-12);
            QVERIFY(project::poseDifference(got.pose, points[i].pose).angle < 1e-7);
            QVERIFY(project::poseDifference(got.tcpOffset, points[i].tcpOffset).distance < 1e-12);
            QVERIFY(std::abs(got.speed() - points[i].speed()) < 1e-12);
            QVERIFY(std::abs(got.blend - points[i].blend) < 1e-12);
        }
    }

    void textTablesMayBeReorderedAndUseCommas() {
        const std::vector<Waypoint> points = {document_->waypoints().at(0)};
        QStringList lines = waypoint_clipboard::toText(points, {}).split('\n');
        QStringList heading = lines[0].split('\t');
        QStringList fields = lines[1].split('\t');
        heading.move(0, 5);
        fields.move(0, 5);
        const QString text = heading.join('\t') + "\r\n" + fields.join('\t').replace('.', ',') + "\r\n";
        const auto back = waypoint_clipboard::fromText(text, {});
        QVERIFY2(back.ok(), qPrintable(back.error().toString()));
        QCOMPARE(back->at(0).name, QString("home"));
        QVERIFY(std::abs(back->at(0).joints[0] - kStart[0]) < 1e-12);
        // Without a header line, columns are read in the order in which Tiller writes them.
        QVERIFY(waypoint_clipboard::fromText(lines[1], {}).ok());
    }

    void anInvalidTextTableIsRefusedWithTheCell() {
        QString text = waypoint_clipboard::toText({document_->waypoints().at(0)}, {});
        text.replace("\t60\t", "\tfast\t");
        const auto back = waypoint_clipboard::fromText(text, {});
        QVERIFY(back.error().code == ErrorCode::InvalidArgument);
        QVERIFY2(back.error().context.contains("Line 2, column “Speed”"), qPrintable(back.error().context));
        QVERIFY(!waypoint_clipboard::fromText("hello", {}).ok());
        QVERIFY(waypoint_clipboard::fromText("", {})->empty());
    }

    void goToRespectsTheSpeedCaps() {
        const control::MotionLimits limits;
        Waypoint joint = at("j", kStart);
        joint.joints[0] += 1.0;
        const auto moveJ = moveRequestFor(robotModel(RobotModelId::UR5e), joint, {}, kStart, {}, limits);
        QVERIFY(moveJ.ok());
        QVERIFY(moveJ->kind == MoveRequest::Kind::MoveJ);
        QVERIFY(moveJ->speed <= limits.jointSpeed);
        const double atTcp = (kinematics::jacobian(dh(), kStart).topRows<3>().col(0) * moveJ->speed).norm();
        QVERIFY(atTcp <= limits.tcpSpeed * 1.0001);

        Waypoint linear = at("l", kStart);
        linear.move = MoveKind::Linear;
        linear.priority = TargetKind::Pose;
        linear.pose.position.z() += 0.05;
        linear.toolSpeed = 1.0;
        const auto moveL = moveRequestFor(robotModel(RobotModelId::UR5e), linear, {}, kStart, {}, limits);
        QVERIFY(moveL.ok());
        QVERIFY(moveL->kind == MoveRequest::Kind::MoveL);
        QCOMPARE(moveL->speed, limits.tcpSpeed);
        QVERIFY((moveL->pose.position - linear.pose.position).norm() < 1e-12);

        linear.pose.position.x() += 3;
        QVERIFY(moveRequestFor(robotModel(RobotModelId::UR5e), linear, {}, kStart, {}, limits).error().code ==
                ErrorCode::NoSolution);
    }

    void anExtendedArmRotatesSlowerAtTheSameToolSpeed() {
        const JointPositions stretched(0, -0.1, 0.05, 0, 0.5, 0);
        JointPositions turned = stretched;
        turned[0] += 0.5;
        const double near =
            kinematics::jointSpeedBound(robotModel(RobotModelId::UR5e).dh, stretched, turned, {}, 0.25).speed;
        QVERIFY(near < 0.25 / 0.7);
        QVERIFY(near > 0.2);
        const double far =
            kinematics::jointSpeedBound(robotModel(RobotModelId::UR20).dh, stretched, turned, {}, 0.25).speed;
        QVERIFY(far < near);
        QVERIFY(std::isinf(
            kinematics::jointSpeedBound(robotModel(RobotModelId::UR5e).dh, kStart, kStart, {}, 0.25).speed));
    }

private:
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<WaypointModel> model_;
    std::unique_ptr<QAbstractItemModelTester> tester_;
    QUuid tray_;
};

QTEST_MAIN(TestWaypointModel)
#include "tst_waypoint_model.moc"
