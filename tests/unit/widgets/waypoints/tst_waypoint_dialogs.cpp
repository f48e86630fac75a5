// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs that edit waypoints: with real clicks and keys, undo and redo.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <functional>
#include <memory>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/waypoint_revision.h"
#include "robot/station/document/waypoint_exchange.h"
#include "tests/support/live_state.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_rules.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/pattern_grid.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoint_dialogs.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_table.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

project::Waypoint at(const QString& name, const Eigen::Vector3d& position) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = name;
    point.move = project::MoveKind::Linear;
    point.priority = project::TargetKind::Pose;
    point.pose = Pose(position, {M_PI, 0, 0});
    point.joints =
        *kinematics::inverseNearest(robotModel(RobotModelId::UR5e).dh, point.pose, {}, kReadyJoints);
    return point;
}

}  // namespace

class TestWaypointDialogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        document_->setAuthor("Ann");
        tab_ = std::make_unique<WaypointsTab>(*session_, *document_, policy_);
        tab_->resize(560, 560);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowActive(tab_.get()));
        project::Project cell;
        cell.frames.append({QUuid::createUuid(), "Tray A", Pose(-0.3, -0.4, 0.1, 0, 0, M_PI / 2), {}});
        cell.waypoints.append(at("corner", {-0.45, -0.25, 0.2}));
        cell.waypoints.append(at("end of row", {-0.45, -0.05, 0.2}));
        cell.waypoints.append(at("last row", {-0.35, -0.25, 0.2}));
        cell.waypoints.append(at("away", {-0.3, -0.3, 0.4}));
        document_->setProject(cell);
        before_ = bytes();
    }
    void cleanup() {
        tab_.reset();
        document_.reset();
        session_.reset();
    }

    void onlyTickedPropertiesAreChangedForAllSelected() {
        select({0, 2});
        inDialog("waypoint.action.properties", [](QDialog& dialog) {
            auto* group = dialog.findChild<QComboBox*>("waypoint.properties.group");
            group->setFocus();
            group->lineEdit()->selectAll();
            QTest::keyClicks(group, "Tray");
            auto* note = dialog.findChild<QPlainTextEdit*>("waypoint.properties.note");
            QTest::keyClicks(note, "mind the clamp");
            QTest::keyClick(dialog.findChild<QComboBox*>("waypoint.properties.colour"), Qt::Key_Down);
            auto* blend = dialog.findChild<QDoubleSpinBox*>("waypoint.properties.blend");
            blend->setFocus();
            blend->selectAll();
            QTest::keyClicks(blend, "2.5");
            QVERIFY(!dialog.findChild<QCheckBox*>("waypoint.properties.toolSpeed.tick")->isChecked());
            press(dialog, "waypoint.properties.accept");
        });
        for (const int row : {0, 2}) {
            const project::Waypoint& point = document_->waypoints().at(row);
            QCOMPARE(point.group, QString("Tray"));
            QCOMPARE(point.note, QString("mind the clamp"));
            QVERIFY(point.colour == project::WaypointColour::Blue);
            QVERIFY(std::abs(point.blend - 0.0025) < 1e-12);
            QCOMPARE(point.toolSpeed, project::kDefaultToolSpeed);
        }
        QVERIFY(document_->waypoints().at(1).group.isEmpty());
        QVERIFY(tab_->findChild<WaypointDetails*>()->headline().contains("Tray"));
        thereAndBack(1);
    }

    void propertiesOutOfRangeAreRefusedAndCancelChangesNothing() {
        select({0});
        inDialog("waypoint.action.properties", [](QDialog& dialog) {
            auto* speed = dialog.findChild<QDoubleSpinBox*>("waypoint.properties.toolSpeed");
            speed->setFocus();
            speed->selectAll();
            QTest::keyClicks(speed, "90000");
            press(dialog, "waypoint.properties.accept");
            QVERIFY(dialog.isVisible());
            dialog.reject();
        });
        QCOMPARE(bytes(), before_);
        QCOMPARE(document_->undoStack().count(), 0);
    }

    void selectionIsMovedInAFrame() {
        select({0, 1});
        const Eigen::Vector3d was = document_->waypoints().at(0).pose.position;
        inDialog("waypoint.action.shift", [](QDialog& dialog) {
            auto* axes = dialog.findChild<QComboBox*>("waypoint.shift.axes");
            axes->setCurrentText("Tray A");
            auto* x = dialog.findChild<QDoubleSpinBox*>("waypoint.shift.x");
            x->setFocus();
            x->selectAll();
            QTest::keyClicks(x, "20");
            press(dialog, "waypoint.shift.accept");
        });
        // X of the tray is parallel to Y of the base.
        QVERIFY((document_->waypoints().at(0).pose.position - was - Eigen::Vector3d(0, 0.02, 0)).norm() <
                1e-9);
        thereAndBack(1);
    }

    void selectionIsTurnedAndMirrored() {
        select({3});
        inDialog("waypoint.action.shift", [](QDialog& dialog) {
            dialog.findChild<QComboBox*>("waypoint.shift.kind")->setCurrentIndex(1);
            auto* angle = dialog.findChild<QDoubleSpinBox*>("waypoint.shift.angle");
            angle->setFocus();
            angle->selectAll();
            QTest::keyClicks(angle, "90");
            press(dialog, "waypoint.shift.accept");
        });
        QVERIFY((document_->waypoints().at(3).pose.position - Eigen::Vector3d(0.3, -0.3, 0.4)).norm() < 1e-9);
        inDialog("waypoint.action.shift", [](QDialog& dialog) {
            dialog.findChild<QComboBox*>("waypoint.shift.kind")->setCurrentIndex(2);
            dialog.findChild<QComboBox*>("waypoint.shift.axis")->setCurrentIndex(0);
            press(dialog, "waypoint.shift.accept");
        });
        QVERIFY((document_->waypoints().at(3).pose.position - Eigen::Vector3d(-0.3, -0.3, 0.4)).norm() <
                1e-9);
        thereAndBack(2);
    }

    void moveOutOfReachOfJointsIsRefusedByName() {
        project::Waypoint joints = document_->waypoints().at(0);
        joints.priority = project::TargetKind::Joints;
        document_->changeWaypoint(0, joints, "x");
        select({0});
        const QByteArray was = bytes();
        inDialog("waypoint.action.shift", [](QDialog& dialog) {
            auto* x = dialog.findChild<QDoubleSpinBox*>("waypoint.shift.x");
            x->setFocus();
            x->selectAll();
            QTest::keyClicks(x, "5000");
            QTest::keyClick(x, Qt::Key_Tab);
            QVERIFY(dialog.findChild<QLabel*>("waypoint.shift.feedback")->text().contains("corner"));
            QVERIFY(!dialog.findChild<QPushButton*>("waypoint.shift.accept")->isEnabled());
            dialog.reject();
        });
        QCOMPARE(bytes(), was);
    }

    void patternIsCreatedEditedAndFollowsItsCorner() {
        makePattern();
        QCOMPARE(document_->waypoints().size(), 4 + 5);
        QCOMPARE(document_->waypoints().at(3).name, QString("tray 1.1"));
        QVERIFY((document_->waypoints().at(7).pose.position - Eigen::Vector3d(-0.35, -0.05, 0.2)).norm() <
                1e-9);
        // The group remains a pattern. One row is added, and the omitted position is restored.
        const QUuid second = document_->waypoints().at(5).id;
        select({4});
        inDialog("waypoint.action.pattern", [](QDialog& dialog) {
            dialog.findChild<QSpinBox*>("pattern.rows")->setValue(3);
            auto* grid = dialog.findChild<PatternGrid*>();
            QTest::mouseClick(grid, Qt::LeftButton, {}, grid->rectOf({1, 0}).center());
            press(dialog, "pattern.accept");
        });
        QCOMPARE(document_->waypoints().size(), 4 + 9);
        QCOMPARE(document_->waypoints().at(4).name, QString("tray 1.2"));
        QCOMPARE(document_->waypoints().at(6).name, QString("tray 2.1"));
        QVERIFY(document_->waypoints().indexOf(second) >= 0);
        // When a corner is touched up, the whole pattern follows in the same undo step.
        project::Waypoint corner = document_->waypoints().at(0);
        corner.pose.position.z() += 0.03;
        document_->changeWaypoint(0, corner, "Touch up");
        QVERIFY(std::abs(document_->waypoints().at(3).pose.position.z() - 0.23) < 1e-9);
        thereAndBack(3);
    }

    void aManuallyMovedCellStaysWhenThePatternChanges() {
        makePattern();
        project::Waypoint moved = document_->waypoints().at(4);
        moved.pose.position.z() += 0.01;
        document_->changeWaypoint(4, moved, "Touch up");
        project::Pattern pattern = document_->patterns().at(0);
        pattern.rowEnd.x() += 0.05;
        pattern.name = "rack";
        document_->changePattern(pattern, "Change");
        QCOMPARE(document_->waypoints().at(4).pose, moved.pose);
        QCOMPARE(document_->waypoints().at(4).name, QString("rack 1.3"));
        QVERIFY(std::abs(document_->waypoints().at(5).pose.position.x() + 0.30) < 1e-9);
        thereAndBack(3);
    }

    void aDeletedCellStaysExcluded() {
        makePattern();
        select({4});
        trigger("waypoint.action.delete");
        QCOMPARE(document_->patterns().at(0).excluded.size(), std::size_t(2));
        QCOMPARE(project::placesOf(document_->patterns().at(0)).size(), std::size_t(4));
        select({0});
        trigger("waypoint.action.delete");
        QVERIFY(document_->patterns().at(0).corners[0].isNull());
        QVERIFY(project::serializeProject(document_->project()).ok());
        thereAndBack(3);
    }

    void patternIsDissolvedAndDeleted() {
        makePattern();
        select({4});
        trigger("waypoint.action.dissolve");
        QVERIFY(document_->patterns().isEmpty());
        QVERIFY(document_->waypoints().at(4).place.isNull());
        QCOMPARE(document_->waypoints().size(), 9);
        document_->undoStack().undo();
        select({4});
        trigger("waypoint.action.removePattern");
        QVERIFY(document_->patterns().isEmpty());
        QCOMPARE(document_->waypoints().size(), 4);
        thereAndBack(2);
    }

    void patternWithoutCornersReportsMissingPoints() {
        select({0});
        inDialog("waypoint.action.pattern", [](QDialog& dialog) {
            QVERIFY(!dialog.findChild<QPushButton*>("pattern.accept")->isEnabled());
            QVERIFY(dialog.findChild<QLabel*>("pattern.feedback")->text().contains("select a waypoint"));
            dialog.findChild<QSpinBox*>("pattern.columns")->setValue(200);
            dialog.findChild<QSpinBox*>("pattern.rows")->setValue(200);
            dialog.findChild<QComboBox*>("pattern.corner.column")->setCurrentIndex(2);
            dialog.findChild<QComboBox*>("pattern.corner.row")->setCurrentIndex(3);
            QVERIFY(dialog.findChild<QLabel*>("pattern.feedback")->text().contains("40000 cells"));
            dialog.reject();
        });
        QCOMPARE(bytes(), before_);
    }

    void deletingAFrameKeepsItsPattern() {
        project::Pattern pattern;
        pattern.id = QUuid::createUuid();
        pattern.name = "rack";
        pattern.first = *project::givenIn(document_->waypoints().at(0), document_->frames().at(0).id,
                                          document_->frames());
        pattern.columnEnd = pattern.first.pose.position + Eigen::Vector3d(0.1, 0, 0);
        pattern.rowEnd = pattern.first.pose.position + Eigen::Vector3d(0, 0.1, 0);
        pattern.columns = pattern.rows = 2;
        document_->insertPattern(4, pattern, "Make");
        const Pose was = *project::poseInBase(document_->waypoints().at(7), document_->frames());
        document_->removeFrame(0);
        QVERIFY(project::poseDifference(was, document_->waypoints().at(7).pose).distance < 1e-9);
        QVERIFY(project::isWhereLaid(document_->waypoints().at(7), document_->patterns().at(0)));
        QVERIFY(project::serializeProject(document_->project()).ok());
        thereAndBack(2);
    }

    void historyListsChangesAndCanRevertThem() {
        project::Waypoint point = document_->waypoints().at(3);
        const Pose taught = point.pose;
        point.pose.position.z() += 0.05;
        document_->changeWaypoint(3, point, "Touch up “away”");
        point = document_->waypoints().at(3);
        point.toolSpeed = 0.1;
        document_->changeWaypoint(3, point, "Set the speed");
        select({3});
        inDialog("waypoint.action.history", [](QDialog& dialog) {
            auto* list = dialog.findChild<QListWidget*>("waypoint.history.list");
            QCOMPARE(list->count(), 2);
            QVERIFY(list->item(0)->text().contains("Set the speed"));
            QVERIFY(list->item(1)->text().contains("(Ann)"));
            auto* compare = dialog.findChild<QLabel*>("waypoint.history.compare");
            QVERIFY(compare->text().contains("MoveL speed: 250 mm/s → 100 mm/s"));
            QTest::keyClick(list, Qt::Key_Down);
            QVERIFY2(compare->text().contains("50.0 mm"), qPrintable(compare->text()));
            press(dialog, "waypoint.history.revert");
        });
        QCOMPARE(document_->waypoints().at(3).pose, taught);
        QCOMPARE(document_->waypoints().at(3).toolSpeed, project::kDefaultToolSpeed);
        QCOMPARE(document_->waypoints().at(3).history.size(), 3);
        thereAndBack(3);
    }

    void csvAndJsonRoundTrip_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("csv") << "points.csv";
        QTest::newRow("json") << "points.json";
    }
    void csvAndJsonRoundTrip() {
        QFETCH(QString, name);
        project::Waypoint point = document_->waypoints().at(1);
        point.name = "end; \"of\", row";
        point.group = "Tray";
        point.colour = project::WaypointColour::Green;
        point.note = "two\nlines, \\ and a comma";
        document_->changeWaypoint(1, point, "x");
        QTemporaryDir folder;
        const QString path = folder.filePath(name);
        select({});
        tab_->dialogs().exportTo(path);
        QVERIFY(QFile::exists(path));
        const project::WaypointList was = document_->waypoints();
        document_->removeWaypoints({0, 1, 2, 3});
        const QByteArray without = bytes();
        tab_->dialogs().importFrom(path);
        QCOMPARE(document_->waypoints().size(), 4);
        for (int row = 0; row < 4; ++row) {
            const project::Waypoint& now = document_->waypoints().at(row);
            const project::Waypoint& then = was.at(row);
            QCOMPARE(now.name, then.name);
            QCOMPARE(now.group, then.group);
            QCOMPARE(now.note, then.note);
            QVERIFY(now.colour == then.colour);
            QVERIFY((now.joints.values - then.joints.values).norm() < 1e-9);
            QVERIFY(project::poseDifference(now.pose, then.pose).distance < 1e-9);
        }
        document_->undoStack().undo();
        QCOMPARE(bytes(), without);
    }

    void damagedImportsAreReportedAndChangeNothing_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("said");
        QTest::newRow("no csv") << "a.csv" << QByteArray("hello\nworld\n") << "not a table of waypoints";
        QTest::newRow("figure") << "a.csv"
                                << QByteArray("Name,X mm,Y mm,Z mm,RX °,RY °,RZ °\na,1,x,3,4,5,6\n")
                                << "Line 2, column “Y mm”: “x” is not a number";
        QTest::newRow("quotes") << "a.csv" << QByteArray("Name,X mm\n\"a,1\n") << "closing quotation mark";
        QTest::newRow("empty") << "a.csv" << QByteArray() << "no waypoints";
        QTest::newRow("json") << "a.json" << QByteArray("{ \"format\": 1 }") << "not a Tiller project";
        QTest::newRow("binary") << "a.json" << QByteArray(300, '\xff') << "line 1";
    }
    void damagedImportsAreReportedAndChangeNothing() {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, said);
        QTemporaryDir folder;
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        tab_->dialogs().importFrom(file.fileName());
        auto* notice = tab_->findChild<NoticeBar*>("notice");
        QVERIFY(notice->isVisible());
        QVERIFY2(notice->text().contains(said), qPrintable(notice->text()));
        QCOMPARE(bytes(), before_);
        tab_->dialogs().importFrom(folder.filePath("none.csv"));
        QVERIFY(notice->text().contains("none.csv"));
    }

    void searchHidesTheOthersAndMovesNoRow() {
        project::Waypoint point = document_->waypoints().at(3);
        point.note = "above the clamp";
        document_->changeWaypoint(3, point, "x");
        select({0});
        QTest::keyClick(table(), Qt::Key_F, Qt::ControlModifier);
        auto* field = tab_->findChild<QLineEdit*>("waypoint.search.field");
        QVERIFY(field->isVisible());
        QCOMPARE(QApplication::focusWidget(), field);
        const QRect tableWas = table()->geometry();
        QTest::keyClicks(field, "CLAMP");
        QCOMPARE(table()->geometry(), tableWas);
        QCOMPARE(shownRows(), QList<int>({3}));
        QVERIFY(tab_->findChild<QLabel*>("waypoint.search.count")->text().contains("1"));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(tab_->currentRow(), 3);
        field->selectAll();
        QTest::keyClicks(field, "row");
        QCOMPARE(shownRows(), QList<int>({1, 2}));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(tab_->currentRow(), 1);
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(shownRows(), QList<int>({0, 1, 2, 3}));
        QVERIFY(!field->isVisible());
    }

    void usesAreListedInTheDetails() {
        makePattern();
        tab_->selectRow(0);
        QVERIFY(tab_->findChild<WaypointDetails*>()->headline().contains("corner of “tray”"));
        tab_->selectRow(4);
        QVERIFY(tab_->findChild<WaypointDetails*>()->headline().contains("cell of “tray”"));
    }

    void duplicatedAndTaughtWaypointsHaveNoHistoryOrCell() {
        makePattern();
        select({4});
        trigger("waypoint.action.duplicate");
        const project::Waypoint& copy = document_->waypoints().at(5);
        QVERIFY(copy.place.isNull());
        QVERIFY(copy.history.isEmpty());
        Q_EMIT session_->stateChanged(liveState());
        tab_->selectRow(4);
        tab_->teach();
        QVERIFY(document_->waypoints().at(5).place.isNull());
    }

private:
    QByteArray bytes() const { return *project::serializeProject(document_->project()); }
    WaypointTable* table() { return tab_->findChild<WaypointTable*>(); }
    QList<int> shownRows() {
        QList<int> rows;
        for (int row = 0; row < document_->waypoints().size(); ++row) {
            if (!table()->isRowHidden(row)) {
                rows << row;
            }
        }
        return rows;
    }
    void select(const QList<int>& rows) {
        table()->selectionModel()->clear();
        for (const int row : rows) {
            table()->selectionModel()->setCurrentIndex(
                tab_->model().index(row, WaypointModel::Name),
                QItemSelectionModel::Select | QItemSelectionModel::Rows);
        }
    }
    void trigger(const char* action) { tab_->findChild<QAction*>(action)->trigger(); }
    static void press(QDialog& dialog, const char* key) {
        QTest::mouseClick(dialog.findChild<QPushButton*>(key), Qt::LeftButton);
    }
    /// Triggers the action and calls the function in the dialog that opens.
    void inDialog(const char* action, const std::function<void(QDialog&)>& inside) {
        bool seen = false;
        QTimer::singleShot(0, this, [&] {
            auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) {
                return;
            }
            seen = true;
            QVERIFY(QTest::qWaitForWindowActive(dialog));
            inside(*dialog);
            if (dialog->isVisible() && QTest::currentTestFailed()) {
                dialog->reject();
            }
        });
        trigger(action);
        QVERIFY2(seen, action);
    }
    /// A pattern of 3 x 2 positions between the first three waypoints, without the middle position of the
    /// first row.
    void makePattern() {
        select({0, 1, 2});
        inDialog("waypoint.action.pattern", [](QDialog& dialog) {
            auto* name = dialog.findChild<QLineEdit*>("pattern.name");
            name->selectAll();
            QTest::keyClicks(name, "tray");
            dialog.findChild<QSpinBox*>("pattern.columns")->setValue(3);
            dialog.findChild<QSpinBox*>("pattern.rows")->setValue(2);
            auto* grid = dialog.findChild<PatternGrid*>();
            QTest::mouseClick(grid, Qt::LeftButton, {}, grid->rectOf({1, 0}).center());
            press(dialog, "pattern.accept");
        });
    }
    /// Undoes all edits one by one and redoes them. The file is then identical, byte by byte.
    void thereAndBack(int edits) {
        QCOMPARE(document_->undoStack().count(), edits);
        const QByteArray after = bytes();
        while (document_->undoStack().canUndo()) {
            document_->undoStack().undo();
        }
        QCOMPARE(bytes(), before_);
        while (document_->undoStack().canRedo()) {
            document_->undoStack().redo();
        }
        QCOMPARE(bytes(), after);
        const auto again = project::parseProject(after);
        QVERIFY(again.ok());
        QCOMPARE(*project::serializeProject(*again), after);
    }

    HoldPolicy policy_;
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<WaypointsTab> tab_;
    QByteArray before_;
};

QTEST_MAIN(TestWaypointDialogs)
#include "tst_waypoint_dialogs.moc"
