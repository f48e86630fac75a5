// SPDX-License-Identifier: GPL-3.0-or-later
//
// Teaching, touching up and editing frames with real widgets, using the mouse or only the keyboard.

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <memory>
#include <numbers>

#include "tests/support/event_spy.h"
#include "tests/support/live_state.h"
#include "widgets/common/apply_notation.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/theme.h"
#include "widgets/frames/frame_details.h"
#include "widgets/frames/frame_model.h"
#include "widgets/frames/frame_table.h"
#include "widgets/frames/frame_teacher.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::test;
using project::TargetKind;
using project::Waypoint;

namespace {

const Pose kCorner(-0.2, -0.5, 0.1, 0, 0, 0);

Pose nextTo(double x, double y, double z = 0) {
    Pose pose = kCorner;
    pose.position += Eigen::Vector3d(x, y, z);
    return pose;
}

}  // namespace

class TestFramesTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        applyNotation(*qApp, {});
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        tab_ = std::make_unique<FramesTab>(*session_, *document_);
        tab_->resize(560, 560);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowActive(tab_.get()));
    }
    void cleanup() {
        tab_.reset();
        document_.reset();
        session_.reset();
    }

    void emptyListShowsTheNextAction() {
        auto* empty = tab_->findChild<QLabel*>("frame.empty");
        QVERIFY(empty->isVisible());
        QVERIFY(empty->text().contains("From TCP"));
        QVERIFY(!button("frame.fromTcp")->isEnabled());
        QVERIFY(!button("frame.fromTcp")->toolTip().isEmpty());
        feed(kCorner);
        click("frame.fromTcp");
        QVERIFY(!empty->isVisible());
        QVERIFY(table()->isVisible());
    }

    void aFrameFromTheTcpUsesTheCurrentPose() {
        const Pose tcp(-0.2, -0.5, 0.1, 0.4, -0.2, 1.1);
        feed(tcp);
        QTest::keyClick(tab_.get(), Qt::Key_T, Qt::ShiftModifier);
        QCOMPARE(names(), QStringList({"frame 1"}));
        QVERIFY(frame(0).T_base_frame == tcp);
        QCOMPARE(tab_->currentRow(), 0);
        document_->undoStack().undo();
        QVERIFY(names().isEmpty());
        document_->undoStack().redo();
        QCOMPARE(names(), QStringList({"frame 1"}));
    }

    void aFrameIsTaughtWithTheKeyboardAlone() {
        feed(kCorner);
        QTest::keyClick(tab_.get(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(teacher()->isVisible());
        QTest::keyClick(tab_.get(), Qt::Key_P);
        feed(nextTo(0, 0.12));
        QTest::keyClick(tab_.get(), Qt::Key_P);
        feed(nextTo(-0.08, 0.03));
        QTest::keyClick(tab_.get(), Qt::Key_P);
        QVERIFY2(feedback().startsWith("Ready"), qPrintable(feedback()));
        QTest::keyClick(tab_.get(), Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(!teacher()->isVisible());
        QCOMPARE(names(), QStringList({"frame 1"}));
        // X along +Y of the base and Y along -X of the base: rotated by 90 deg about Z.
        const Pose& made = frame(0).T_base_frame;
        QVERIFY((made.position - kCorner.position).norm() < 1e-12);
        QVERIFY((made.rotation - Eigen::Vector3d(0, 0, std::numbers::pi / 2)).norm() < 1e-9);
    }

    void badPointsAreReportedAndCreateNoFrame() {
        feed(kCorner);
        click("frame.threePoints");
        auto* make = button("frame.teacher.make");
        click("frame.teacher.origin");
        feed(nextTo(0.0123, 0));
        QTRY_VERIFY2_WITH_TIMEOUT(feedback().contains("12.3 mm"), qPrintable(feedback()),
                                  60'000);  // distance of the tool tip at this time
        click("frame.teacher.onX");
        QVERIFY2(feedback().contains("only 12.3 mm") && feedback().contains("20 mm"), qPrintable(feedback()));
        QVERIFY(!make->isEnabled());
        feed(nextTo(0.1, 0));
        QTest::keyClick(tab_.get(), Qt::Key_P);  // records the bad point again, not the next one
        feed(nextTo(0.25, 0.004));
        QTRY_VERIFY2_WITH_TIMEOUT(feedback().contains("4.0 mm"), qPrintable(feedback()), 60'000);
        click("frame.teacher.towardsY");
        QVERIFY2(feedback().contains("collinear") && feedback().contains("only 4.0 mm"),
                 qPrintable(feedback()));
        QVERIFY(!make->isEnabled());
        QTest::keyClick(tab_.get(), Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(names().isEmpty());
        feed(nextTo(0.02, 0.09));
        click("frame.teacher.towardsY");
        QVERIFY(make->isEnabled());
        click("frame.teacher.make");
        QCOMPARE(names().size(), 1);
    }

    void noPointIsTakenFromOldData() {
        feed(kCorner);
        click("frame.threePoints");
        SessionState stale = liveAt(kCorner);
        stale.link = LinkState::Stale;
        Q_EMIT session_->stateChanged(stale);
        QVERIFY(!button("frame.teacher.origin")->isEnabled());
        QTest::keyClick(tab_.get(), Qt::Key_P);
        QCOMPARE(place("origin"), QStringLiteral("–"));
        QVERIFY2(feedback().contains("out of date"), qPrintable(feedback()));
        feed(kCorner);
        QTest::keyClick(tab_.get(), Qt::Key_P);
        QVERIFY(place("origin").contains("−200.00"));
    }

    void newFrameIsPreviewed() {
        QSignalSpy marks(tab_.get(), &FramesTab::marksChanged);
        feed(kCorner);
        click("frame.threePoints");
        click("frame.teacher.origin");
        feed(nextTo(0.1, 0));
        click("frame.teacher.onX");
        QVERIFY(tab_->marks().empty());
        feed(nextTo(0, 0.1));  // the tip is used as the third point
        QTRY_COMPARE_WITH_TIMEOUT(tab_->marks().size(), std::size_t(1), 60'000);
        QVERIFY(tab_->marks()[0].selected);
        QVERIFY((tab_->marks()[0].T_base_frame.position - kCorner.position).norm() < 1e-12);
        QVERIFY(marks.count() > 1);
        click("frame.teacher.cancel");
        QVERIFY(tab_->marks().empty());
        QVERIFY(names().isEmpty());
    }

    void touchUpShowsTheDifferenceAndAffectedWaypoints() {
        teachWithWaypoints(2);
        const Pose before = frame(0).T_base_frame;
        const Pose place = placeOf(0);
        const Pose there = nextTo(0.03, 0, 0.04);
        feed(there);
        QTest::keyClick(tab_.get(), Qt::Key_U, Qt::ShiftModifier);
        QVERIFY(notice()->isVisible());
        QVERIFY2(notice()->text().contains("50.0 mm"), qPrintable(notice()->text()));
        QVERIFY2(notice()->text().contains("2 waypoints move with the frame"), qPrintable(notice()->text()));
        QVERIFY(frame(0).T_base_frame == before);
        click("notice.accept");
        QVERIFY(frame(0).T_base_frame == there);
        QVERIFY2(notice()->text().contains("2 waypoints moved with the frame"), qPrintable(notice()->text()));
        QVERIFY((placeOf(0).position - place.position - Eigen::Vector3d(0.03, 0, 0.04)).norm() < 1e-9);
        document_->undoStack().undo();
        QVERIFY(frame(0).T_base_frame == before);
        QVERIFY(project::poseDifference(placeOf(0), place).distance < 1e-12);
    }

    // While the question is shown, it is updated as the arm moves. The pose at the time of confirmation is
    // stored.
    void touchUpFollowsTheArm() {
        teachWithWaypoints(1);
        const Pose before = frame(0).T_base_frame;
        feed(nextTo(0.03, 0));
        click("frame.touchUp");
        QVERIFY2(notice()->text().contains("30.0 mm"), qPrintable(notice()->text()));
        feed(nextTo(0.05, 0));
        QTRY_VERIFY2_WITH_TIMEOUT(notice()->text().contains("50.0 mm"), qPrintable(notice()->text()), 60'000);
        SessionState moving = liveAt(nextTo(0.06, 0));
        moving.moving = true;
        Q_EMIT session_->stateChanged(moving);
        click("notice.accept");
        QVERIFY(frame(0).T_base_frame == before);
        QVERIFY2(notice()->title().contains("moving"), qPrintable(notice()->title()));
        feed(nextTo(0.03, 0));
        click("frame.touchUp");
        feed(nextTo(0.07, 0));
        click("notice.accept");
        QVERIFY(frame(0).T_base_frame == nextTo(0.07, 0));
    }

    // Checking the reach of many waypoints takes too long to be repeated at every update of the question.
    void touchUpChecksTheReachOncePerPose() {
        teachWithWaypoints(1500);
        feed(nextTo(0.03, 0));
        QElapsedTimer timer;
        timer.start();
        click("frame.touchUp");
        const qint64 first = timer.nsecsElapsed();
        timer.restart();
        for (int i = 0; i < 50; ++i) {
            notice()->refresh();
        }
        QVERIFY2(timer.nsecsElapsed() < 10 * first,
                 qPrintable(QStringLiteral("%1 and %2 ns").arg(first).arg(timer.nsecsElapsed())));
        // A change of the project closes the question.
        document_->removeWaypoints({0});
        QVERIFY(!notice()->isVisible());
        click("frame.touchUp");
        QVERIFY2(notice()->text().contains("1499"), qPrintable(notice()->text()));
    }

    // A frame from three recorded points does not depend on the current position.
    void touchUpFromThreePointsKeepsThePoints() {
        teachWithWaypoints(1);
        action("touchUpThreePoints")->trigger();
        for (const Pose& pose : {nextTo(0.01, 0), nextTo(0.01, 0.1), nextTo(-0.1, 0)}) {
            feed(pose);
            QTest::keyClick(tab_.get(), Qt::Key_P);
        }
        click("frame.teacher.make");
        const QString text = notice()->text();
        feed(nextTo(0.5, 0));
        QTest::qWait(150);
        QCOMPARE(notice()->text(), text);
        click("notice.accept");
        QVERIFY((frame(0).T_base_frame.position - nextTo(0.01, 0).position).norm() < 1e-12);
    }

    void touchUpReportsUnreachableWaypoints() {
        teachWithWaypoints(1);
        feed(nextTo(2, 0));
        click("frame.touchUp");
        QVERIFY2(notice()->text().contains("out of reach"), qPrintable(notice()->text()));
        click("notice.dismiss");
        QVERIFY(frame(0).T_base_frame == kCorner);
    }

    void touchUpFromThreePointsAsksToo() {
        teachWithWaypoints(1);
        action("touchUpThreePoints")->trigger();
        for (const Pose& pose : {nextTo(0.01, 0), nextTo(0.01, 0.1), nextTo(-0.1, 0)}) {
            feed(pose);
            QTest::keyClick(tab_.get(), Qt::Key_P);
        }
        click("frame.teacher.make");
        QVERIFY(frame(0).T_base_frame == kCorner);
        QVERIFY2(notice()->text().contains("90.0°"), qPrintable(notice()->text()));
        click("notice.accept");
        QVERIFY(std::abs(frame(0).T_base_frame.rotation.z() - std::numbers::pi / 2) < 1e-9);
        QCOMPARE(names().size(), 1);
    }

    void changedSelectionCancelsTheQuestion() {
        feed(kCorner);
        tab_->teachFromTcp();
        tab_->teachFromTcp();
        click("frame.touchUp");
        QVERIFY(notice()->isVisible());
        tab_->selectRow(0);
        QVERIFY(!notice()->isVisible());
    }

    void f2RenamesInPlace() {
        feed(kCorner);
        tab_->teachFromTcp();
        QTest::keyClick(table(), Qt::Key_F2);
        auto* editor = table()->findChild<QLineEdit*>("frame.editor");
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, "TUPray");  // letters that are shortcuts in other places
        feed(nextTo(0.1, 0));                // the table keeps updating
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"TUPray"}), 60'000);
        document_->undoStack().undo();
        QCOMPARE(names(), QStringList({"frame 1"}));
    }

    void anInvalidNameIsRefusedWithAReason() {
        feed(kCorner);
        tab_->teachFromTcp();
        QVERIFY(!tab_->model().setData(tab_->model().index(0, FrameModel::Name), "Base", Qt::EditRole));
        QVERIFY(notice()->isVisible());
        QVERIFY(notice()->title().contains("Base"));
        QCOMPARE(names(), QStringList({"frame 1"}));
    }

    void enteringOneValueKeepsTheOthersExact() {
        const Pose tcp(-0.123456789, -0.5, 0.1, 0, 0, 0.3);
        feed(tcp);
        tab_->teachFromTcp();
        const test::EventSpy messages(session_->journal());
        type("y", "-450,5");
        QVERIFY(messages.count() == 1 && messages.front().text.contains("No waypoints moved"));
        QVERIFY(box("y")->isVisible());  // the operator continues with the next field
        QVERIFY(std::abs(frame(0).T_base_frame.position.y() + 0.4505) < 1e-12);
        QCOMPARE(frame(0).T_base_frame.position.x(), tcp.position.x());
        QVERIFY(frame(0).T_base_frame.rotation == tcp.rotation);
        type("rz", "90");
        QVERIFY(std::abs(frame(0).T_base_frame.rotation.z() - std::numbers::pi / 2) < 1e-9);
        applyNotation(*qApp, {LengthUnit::Inches, RotationNotation::RotationVector});
        QCOMPARE(box("z")->text(), QStringLiteral("3.937 in"));
        QCOMPARE(box("rz")->text(), QStringLiteral("1.5708 rad"));
        type("z", "10");
        QVERIFY(std::abs(frame(0).T_base_frame.position.z() - 0.254) < 1e-12);
        for (int steps = 0; steps < 3; ++steps) {
            document_->undoStack().undo();
        }
        QVERIFY(frame(0).T_base_frame == tcp);
    }

    void wheelChangesNoValue() {
        feed(kCorner);
        tab_->teachFromTcp();
        box("x")->setFocus();
        QWheelEvent wheel(QPointF(5, 5), box("x")->mapToGlobal(QPointF(5, 5)), QPoint(), QPoint(0, 120),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(box("x"), &wheel);
        box("y")->setFocus();
        QVERIFY(frame(0).T_base_frame == kCorner);
        QCOMPARE(document_->undoStack().count(), 1);
    }

    void framesAreDuplicatedAndDeletedByKey() {
        feed(kCorner);
        tab_->teachFromTcp();
        QTest::keyClick(table(), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(names(), QStringList({"frame 1", "frame 2"}));
        QCOMPARE(tab_->currentRow(), 1);
        QVERIFY(frame(0).id != frame(1).id);
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(names(), QStringList({"frame 1"}));
        QCOMPARE(tab_->currentRow(), 0);
    }

    void deletingAFrameInUseAsksAndLeavesNoOrphan() {
        teachWithWaypoints(3);
        const Pose place = placeOf(0);
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(names().size(), 1);
        QVERIFY2(notice()->text().contains("3 waypoints"), qPrintable(notice()->text()));
        click("notice.dismiss");
        QCOMPARE(names().size(), 1);
        QTest::keyClick(table(), Qt::Key_Delete);
        click("notice.accept");
        QVERIFY(names().isEmpty());
        QVERIFY(document_->waypoints().at(0).frame.isNull());
        QVERIFY(project::poseDifference(placeOf(0), place).distance < 1e-9);
        document_->undoStack().undo();
        QCOMPARE(names().size(), 1);
        QCOMPARE(document_->waypoints().at(0).frame, frame(0).id);
    }

    void theTableFollowsTheUnits() {
        feed(nextTo(0, 0, 0.0254));
        tab_->teachFromTcp();
        feed(kCorner);
        auto* details = tab_->findChild<FrameDetails*>("frame.details");
        QTRY_VERIFY2_WITH_TIMEOUT(details->headline().contains("25.4 mm"), qPrintable(details->headline()),
                                  60'000);
        applyNotation(*qApp, {LengthUnit::Inches, RotationNotation::RollPitchYaw});
        QVERIFY2(details->headline().contains("1.00 in"), qPrintable(details->headline()));
        QCOMPARE(tab_->model().index(0, FrameModel::Distance).data().toString(), QStringLiteral("1.00"));
    }

    void everyControlHasANameForTestsAndScreenReaders() {
        feed(kCorner);
        tab_->teachFromTcp();
        for (const char* page : {"table", "teacher"}) {
            for (QAbstractButton* control : tab_->findChildren<QAbstractButton*>()) {
                if (control->isVisible()) {
                    QVERIFY2(!control->objectName().isEmpty(), qPrintable(control->text()));
                    QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(control->objectName()));
                }
            }
            keepPicture(QStringLiteral("frames-") + QLatin1String(page));
            tab_->teachThreePoints();
        }
        for (const QAction* command : tab_->commandActions()) {
            QVERIFY(command->objectName().startsWith("frame.action."));
            QVERIFY(!command->text().isEmpty());
        }
    }

private:
    void feed(const Pose& tcp) { Q_EMIT session_->stateChanged(liveAt(tcp)); }
    /// Teaches a frame at the corner and the given number of waypoints in it.
    void teachWithWaypoints(int count) {
        feed(kCorner);
        tab_->teachFromTcp();
        std::vector<Waypoint> points;
        for (int i = 0; i < count; ++i) {
            Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("place %1").arg(i);
            point.priority = TargetKind::Pose;
            point.frame = frame(0).id;
            const SessionState ready = liveState(moved(0, 0.05 * i));
            points.push_back(*project::taughtAt(point, ready.q, ready.tcpPose, {}, document_->frames()));
        }
        document_->insertWaypoints(0, points, "x");
        tab_->selectRow(0);
        table()->setFocus();
    }
    void type(const char* figure, const QString& text) {
        box(figure)->setFocus();
        box(figure)->selectAll();
        QTest::keyClicks(box(figure), text);
        QTest::keyClick(box(figure), Qt::Key_Return);
    }
    void keepPicture(const QString& name) {
        const QString to = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!to.isEmpty()) {
            QVERIFY(tab_->grab().save(QStringLiteral("%1/%2.png").arg(to, name)));
        }
    }

    QStringList names() {
        QStringList result;
        for (const project::Frame& frame : document_->frames()) {
            result << frame.name;
        }
        return result;
    }
    const project::Frame& frame(std::size_t row) { return document_->frames().at(row); }
    Pose placeOf(int row) {
        return *project::poseInBase(document_->waypoints().at(row), document_->frames());
    }
    QString feedback() { return teacher()->feedback(); }
    QString place(const QString& point) {
        return tab_->findChild<QLabel*>("frame.teacher." + point + ".place")->text();
    }
    FrameTable* table() { return tab_->findChild<FrameTable*>("frame.table"); }
    FrameTeacher* teacher() { return tab_->findChild<FrameTeacher*>("frame.teacher"); }
    NoticeBar* notice() { return tab_->findChild<NoticeBar*>("notice"); }
    QDoubleSpinBox* box(const QString& figure) {
        return tab_->findChild<QDoubleSpinBox*>("frame.details." + figure);
    }
    QPushButton* button(const char* name) { return tab_->findChild<QPushButton*>(name); }
    void click(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    QAction* action(const QString& name) { return tab_->findChild<QAction*>("frame.action." + name); }

    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<FramesTab> tab_;
};

QTEST_MAIN(TestFramesTab)
#include "tst_frames_tab.moc"
