// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of frames. Every edit can be undone in the same history as edits of waypoints.

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/live_state.h"
#include "widgets/common/apply_notation.h"
#include "widgets/frames/frame_model.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::test;
using project::Frame;
using project::TargetKind;
using project::Waypoint;

class TestFrameModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        applyNotation(*qApp, {});
        document_ = std::make_unique<UndoableDocument>();
        tray_ = {QUuid::createUuid(), "tray", Pose(-0.1, -0.4, 0.1, 0, 0, 0.5), {}};
        table_ = {QUuid::createUuid(), "table", Pose(0, -0.5, 0, 0, 0, 0), {}};
        project::Project cell;
        cell.frames.append(tray_);
        cell.frames.append(table_);
        // Two waypoints move with the tray. The third one is defined by its joints and only stores a pose
        // relative to the tray.
        for (int i = 0; i < 3; ++i) {
            Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("place %1").arg(i);
            point.priority = i < 2 ? TargetKind::Pose : TargetKind::Joints;
            const JointPositions q = moved(0, 0.1 * i);
            point.frame = tray_.id;
            cell.waypoints.append(*project::taughtAt(
                point, q, kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, q), {}, cell.frames));
        }
        document_->setProject(cell);
        model_ = std::make_unique<FrameModel>(*document_);
        tester_ = std::make_unique<QAbstractItemModelTester>(
            model_.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() {
        tester_.reset();
        model_.reset();
        document_.reset();
    }

    void tableShowsTheValuesAnOperatorNeeds() {
        QCOMPARE(model_->rowCount(), 2);
        QCOMPARE(cell(0, FrameModel::Name), QString("tray"));
        QCOMPARE(cell(0, FrameModel::Origin), QString("−100.0 −400.0 100.0"));
        QVERIFY2(cell(0, FrameModel::Rotation).endsWith("28.65°"), qPrintable(cell(0, FrameModel::Rotation)));
        QCOMPARE(cell(0, FrameModel::Waypoints), QString("2"));
        QCOMPARE(cell(1, FrameModel::Waypoints), QString("0"));
        QCOMPARE(cell(0, FrameModel::Distance), QString("–"));
        model_->setTcp(Pose(-0.1, -0.4, 0.2, 0, 0, 0));
        QCOMPARE(cell(0, FrameModel::Distance), QString("100.0"));
        applyNotation(*qApp, {LengthUnit::Inches, RotationNotation::RotationVector});
        QCOMPARE(cell(0, FrameModel::Origin), QString("−3.94 −15.75 3.94"));
        QVERIFY(cell(0, FrameModel::Rotation).endsWith("0.5000"));
        QVERIFY(model_->headerData(FrameModel::Origin, Qt::Horizontal, Qt::DisplayRole)
                    .toString()
                    .endsWith("in"));
    }

    void waypointsMoveWithTheirFrameAndUndoRestoresThem() {
        const Pose before = placeOf(0);
        const Pose jointsBefore = placeOf(2);
        Frame moved = tray_;
        moved.T_base_frame.position.z() += 0.05;
        QSignalSpy changed(document_.get(), &ProjectDocument::framesChanged);
        document_->changeFrame(0, moved, "x");
        QCOMPARE(changed.count(), 1);
        QVERIFY((placeOf(0).position - before.position - Eigen::Vector3d(0, 0, 0.05)).norm() < 1e-9);
        document_->undoStack().undo();
        QVERIFY(project::poseDifference(placeOf(0), before).distance < 1e-12);
        QVERIFY(project::poseDifference(placeOf(2), jointsBefore).distance < 1e-12);
        document_->undoStack().redo();
        QVERIFY((placeOf(0).position - before.position).norm() > 0.04);
    }

    void unchangedValuesAddNoUndoStep() {
        document_->changeFrame(0, tray_, "x");
        QCOMPARE(document_->undoStack().count(), 0);
        QVERIFY(model_->setData(model_->index(0, FrameModel::Name), "tray", Qt::EditRole));
        QCOMPARE(document_->undoStack().count(), 0);
    }

    void unreachableWaypointsAreCounted() {
        QCOMPARE(model_->use(tray_).waypoints, 2);
        QCOMPARE(model_->use(tray_).outOfReach, 0);
        Pose far = tray_.T_base_frame;
        far.position.z() += 2;
        QCOMPARE(model_->use(tray_.id, far).outOfReach, 2);
        QVERIFY(document_->frames().find(tray_.id)->T_base_frame == tray_.T_base_frame);
    }

    void deletingAFrameLeavesNoOrphanedWaypoint() {
        const Pose first = placeOf(0);
        document_->removeFrame(0);
        QCOMPARE(model_->rowCount(), 1);
        for (const Waypoint& point : document_->waypoints()) {
            QVERIFY2(point.frame.isNull(), qPrintable(point.name));
        }
        QVERIFY(project::poseDifference(placeOf(0), first).distance < 1e-9);
        QVERIFY(document_->reach(0).ok());
        // The saved file can be read again: no waypoint refers to a missing frame.
        const auto bytes = project::serializeProject(document_->project());
        QVERIFY(bytes && project::parseProject(*bytes));
        // One undo step reverts all changes.
        document_->undoStack().undo();
        QCOMPARE(model_->rowCount(), 2);
        QCOMPARE(model_->rowOf(tray_.id), 0);
        QCOMPARE(document_->waypoints().at(0).frame, tray_.id);
        QCOMPARE(document_->waypoints().at(2).frame, tray_.id);
        QVERIFY(!document_->undoStack().canUndo());
    }

    void badNamesAreRefusedWithTheReason_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("empty") << "";
        QTest::newRow("blank") << "   ";
        QTest::newRow("Base") << "Base";
        QTest::newRow("tool in small letters") << "tool";
        QTest::newRow("View") << " View ";
        QTest::newRow("taken") << "table";
        QTest::newRow("taken in other letters") << "TABLE";
        QTest::newRow("no frame") << "—";
    }
    void badNamesAreRefusedWithTheReason() {
        QFETCH(QString, name);
        QSignalSpy refused(model_.get(), &FrameModel::editRefused);
        QVERIFY(!model_->setData(model_->index(0, FrameModel::Name), name, Qt::EditRole));
        QCOMPARE(refused.count(), 1);
        QVERIFY(!refused[0][0].toString().isEmpty());
        QCOMPARE(cell(0, FrameModel::Name), QString("tray"));
        QCOMPARE(document_->undoStack().count(), 0);
    }

    void aValidNameIsAppliedAndUndone() {
        QVERIFY(model_->setData(model_->index(0, FrameModel::Name), "  Tray A ", Qt::EditRole));
        QCOMPARE(cell(0, FrameModel::Name), QString("Tray A"));
        QVERIFY(document_->frames().findByName("Tray A") != nullptr);
        document_->undoStack().undo();
        QCOMPARE(cell(0, FrameModel::Name), QString("tray"));
    }

    void onlyTheNameIsEditedInPlace() {
        for (int column = 0; column < FrameModel::ColumnCount; ++column) {
            QCOMPARE((model_->index(0, column).flags() & Qt::ItemIsEditable) != 0,
                     column == FrameModel::Name);
        }
    }

private:
    QString cell(int row, int column) { return model_->index(row, column).data().toString(); }
    Pose placeOf(int row) {
        return *project::poseInBase(document_->waypoints().at(row), document_->frames());
    }

    Frame tray_;
    Frame table_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<FrameModel> model_;
    std::unique_ptr<QAbstractItemModelTester> tester_;
};

QTEST_MAIN(TestFrameModel)
#include "tst_frame_model.moc"
