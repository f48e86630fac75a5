// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <memory>

#include "robot/core/angles.h"
#include "robot/core/clock.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/event_spy.h"
#include "tests/support/live_state.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/project/undoable_document.h"
#include "widgets/tools/payload_page.h"
#include "widgets/tools/positions_page.h"
#include "widgets/tools/tcp_page.h"
#include "widgets/tools/tools_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

const DhParameters& dh() {
    return robotModel(RobotModelId::UR5e).dh;
}

/// Joint positions at which a tool with this offset touches the point. `turn` is the tilt from vertical.
std::optional<JointPositions> onPoint(const Pose& tool, const Eigen::Vector3d& point,
                                      const Eigen::Vector3d& turn) {
    const Pose target(point, rotationVector(rotationMatrix({M_PI, 0, 0}) * rotationMatrix(turn)));
    return kinematics::inverseNearest(dh(), target, tool, kReadyJoints);
}

}  // namespace

class TestToolsTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        moves_.clear();
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        MotionPort port;
        port.beginMove = [this](const MoveRequest& request) -> Result<MotionPort::Id> {
            moves_.push_back(request);
            return MotionPort::Id(moves_.size());
        };
        port.hold = [](MotionPort::Id) { return true; };
        port.endMotion = [this](MotionPort::Id, control::StopCause cause) { ends_.push_back(cause); };
        port.limits = [] { return control::MotionLimits(); };
        tab_ = std::make_unique<ToolsTab>(*session_, *document_, port, policy_);
        tab_->resize(560, 560);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowActive(tab_.get()));
    }
    void cleanup() {
        tab_.reset();
        document_.reset();
        session_.reset();
    }

    void tcpOfTheRobotIsAddedNamedAndEdited() {
        SessionState state = liveState();
        state.tcpOffset = Pose(0.01, 0, 0.15, 0, 0, 0);
        feed(state);
        click("tcp.fromRobot");
        QCOMPARE(document_->tooling().tools.size(), std::size_t(1));
        QCOMPARE(document_->tooling().tools.at(0).tcpOffset, state.tcpOffset);
        QVERIFY(label("tcp.facts").contains("active on the robot"));
        // A second press reports that the TCP is already in the list.
        click("tcp.fromRobot");
        QCOMPARE(document_->tooling().tools.size(), std::size_t(1));

        auto* z = tab_->findChild<QDoubleSpinBox*>("tcp.details.z");
        type(z, "162.5");
        QVERIFY(std::abs(document_->tooling().tools.at(0).tcpOffset.position.z() - 0.1625) < 1e-12);
        QVERIFY(label("tcp.facts").contains("12.5 mm"));
        everythingGoesThereAndBack(2);
    }

    void namesAreUniqueAndRenamedInPlace() {
        feed(liveState());
        action("tcp.action.new")->trigger();
        action("tcp.action.duplicate")->trigger();
        QCOMPARE(document_->tooling().tools.at(1).name, QString("tool 2"));
        auto* table = tab_->findChild<QTableView*>("tcp.table");
        const QModelIndex name = table->model()->index(1, PartModel::Name);
        QVERIFY(!table->model()->setData(name, "tool 1", Qt::EditRole));
        QVERIFY(notice("tcp.page")->text().isEmpty());
        QVERIFY(notice("tcp.page")->title().contains("already exists"));
        action("tcp.action.rename")->trigger();
        auto* editor = tab_->findChild<QLineEdit*>("tcp.editor");
        QVERIFY(editor != nullptr);
        QCOMPARE(editor->text(), QString("tool 2"));
        editor->selectAll();
        QTest::keyClicks(editor, "gripper");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(document_->tooling().tools.at(1).name, QString("gripper"), 60'000);
        action("tcp.action.delete")->trigger();
        QCOMPARE(document_->tooling().tools.size(), std::size_t(1));
        everythingGoesThereAndBack(4);
    }

    void differenceToTheRobotIsReportedOnceWithoutChanges() {
        project::Tooling tooling;
        tooling.tools = {{QUuid::createUuid(), "gripper", Pose(0, 0, 0.15, 0, 0, 0), 0, {}, {}}};
        tooling.activeTool = tooling.tools.at(0).id;
        document_->changeTooling(tooling, "x");
        const test::EventSpy said(session_->journal());
        SessionState state = liveState();
        state.tcpOffset = Pose(0, 0, 0.10, 0, 0, 0);
        feed(state);
        QVERIFY(notice("tcp.page")->isVisible());
        QVERIFY(notice("tcp.page")->title().contains("differs from “gripper”"));
        QVERIFY(notice("tcp.page")->text().contains("50.0 mm"));
        QVERIFY(notice("tcp.page")->text().contains("Nothing was changed"));
        QCOMPARE(said.count(), 1);
        notice("tcp.page")->dismiss();
        feed(state);
        QVERIFY(!notice("tcp.page")->isVisible());
        QVERIFY(document_->tooling() == tooling);
        // Another program sets a third TCP on the robot.
        state.tcpOffset = Pose(0, 0, 0.12, 0, 0, 0);
        feed(state);
        QVERIFY(notice("tcp.page")->isVisible());
        state.tcpOffset = Pose(0, 0, 0.15, 0, 0, 0);
        notice("tcp.page")->dismiss();
        feed(state);
        QVERIFY(!notice("tcp.page")->isVisible());
        QCOMPARE(said.count(), 2);
    }

    // The button of the notice sets the displayed value, even if the value has changed since.
    void theNoticeFollowsTheProjectAndTheRobot() {
        project::Tooling tooling;
        tooling.tools = {{QUuid::createUuid(), "gripper", Pose(), 0, {}, {}}};
        tooling.activeTool = tooling.tools.at(0).id;
        document_->changeTooling(tooling, "x");
        project::Tooling taught = tooling;
        project::Tool tool = tooling.tools.at(0);
        tool.tcpOffset = Pose(0, 0, 0.15, 0, 0, 0);
        taught.tools.replace(0, tool);
        document_->changeTooling(taught, "y");
        SessionState state = liveState();
        state.tcpOffset = Pose(0, 0, 0.10, 0, 0, 0);
        feed(state);
        QVERIFY(notice("tcp.page")->text().contains("50.0 mm"));
        // After the undo, the value in the project is 0 again, and the notice shows this.
        document_->undoStack().undo();
        QVERIFY(notice("tcp.page")->isVisible());
        QVERIFY2(notice("tcp.page")->text().contains("100.0 mm"), qPrintable(notice("tcp.page")->text()));
        // Another program sets that TCP on the robot.
        state.tcpOffset = Pose();
        feed(state);
        QVERIFY(!notice("tcp.page")->isVisible());
        state.tcpOffset = Pose(0, 0, 0.10, 0, 0, 0);
        feed(state);
        QVERIFY(notice("tcp.page")->isVisible());
        // Another project is opened.
        document_->setProject({});
        QVERIFY(!notice("tcp.page")->isVisible());
    }

    void thePayloadNoticeFollowsTheProjectAndTheRobot() {
        project::Tooling tooling;
        tooling.payloads = {{QUuid::createUuid(), "part", 2.0, Eigen::Vector3d::Zero(), {}, {}, {}}};
        tooling.activePayload = tooling.payloads.at(0).id;
        document_->changeTooling(tooling, "x");
        SessionState state = liveState();
        state.payloadMass = 1.0;
        feed(state);
        QVERIFY(notice("payload.page")->text().contains("2.000 kg"));
        project::Tooling heavier = tooling;
        project::Payload payload = tooling.payloads.at(0);
        payload.mass = 3.0;
        heavier.payloads.replace(0, payload);
        document_->changeTooling(heavier, "y");
        QVERIFY2(notice("payload.page")->text().contains("3.000 kg"),
                 qPrintable(notice("payload.page")->text()));
        document_->setProject({});
        QVERIFY(notice("payload.page")->isHidden());
    }

    void settingWithoutControlSuggestsASolution() {
        SessionState state = liveState();
        state.control = ControlState::None;
        state.controlReason = "Take control first.";
        feed(state);
        click("tcp.fromRobot");
        click("tcp.use");
        QVERIFY(notice("tcp.page")->title().contains("Take control first."));
        QCOMPARE(document_->tooling().activeTool, document_->tooling().tools.at(0).id);
        document_->undoStack().undo();
        QVERIFY(document_->tooling().activeTool.isNull());
    }

    void fourPosesTeachATcp() {
        const Pose tool(0.02, -0.01, 0.17, 0, 0, 0);
        const Eigen::Vector3d point(-0.35, -0.25, 0.1);
        feed(liveState());
        click("tcp.teach");
        QVERIFY(label("tcp.teacher.feedback").contains("sharp point"));
        int taken = 0;
        for (const Eigen::Vector3d& turn :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(-0.25, 0.5, 0),
              Eigen::Vector3d(-0.2, -0.4, 0.6)}) {
            const auto q = onPoint(tool, point, turn);
            QVERIFY(q.has_value());
            feed(liveState(*q));
            QCOMPARE(button("tcp.teacher.take")->text(), QString("Record pose %1").arg(++taken));
            QVERIFY(!button("tcp.teacher.make")->isEnabled());
            click("tcp.teacher.take");
        }
        QVERIFY2(label("tcp.teacher.feedback").contains("agree within 0.00 mm"),
                 qPrintable(label("tcp.teacher.feedback")));
        click("tcp.teacher.make");
        QCOMPARE(document_->tooling().tools.size(), std::size_t(1));
        const Pose found = document_->tooling().tools.at(0).tcpOffset;
        QVERIFY2((found.position - tool.position).norm() < 1e-9,
                 qPrintable(QString::number((found.position - tool.position).norm())));
        everythingGoesThereAndBack(1);
    }

    void theWorstPoseIsReportedAndReplaced() {
        const Pose tool(0, 0, 0.17, 0, 0, 0);
        const Eigen::Vector3d point(-0.35, -0.25, 0.1);
        const std::vector<Eigen::Vector3d> turns = {
            {0, 0, 0}, {0.5, 0, 0}, {-0.25, 0.5, 0}, {-0.2, -0.4, 0.6}, {0.3, 0.3, -0.8}};
        feed(liveState());
        click("tcp.teach");
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const Eigen::Vector3d beside(0, i == 2 ? 0.004 : 0, 0);
            feed(liveState(*onPoint(tool, point + beside, turns[i])));
            click("tcp.teacher.take");
        }
        QVERIFY2(label("tcp.teacher.feedback").contains("pose 3 deviates most"),
                 qPrintable(label("tcp.teacher.feedback")));
        QVERIFY(label("tcp.teacher.poses").contains("◀"));
        feed(liveState(*onPoint(tool, point, turns[2])));
        click("tcp.teacher.again");
        QVERIFY(label("tcp.teacher.feedback").contains("agree within 0.00 mm"));
        click("tcp.teacher.cancel");
        QVERIFY(document_->tooling().tools.isEmpty());
    }

    void similarPosesAreRefusedWithAdvice() {
        feed(liveState());
        click("tcp.teach");
        for (int i = 0; i < 4; ++i) {
            click("tcp.teacher.take");
        }
        QVERIFY(label("tcp.teacher.feedback").contains("too similar"));
        QVERIFY(!button("tcp.teacher.make")->isEnabled());
    }

    void rotationIsTaughtFromOneOrThreePoses() {
        const Pose tool(0, 0, 0.17, 0, 0.4, 0);
        const Eigen::Vector3d point(-0.35, -0.25, 0.1);
        feed(liveState());
        click("tcp.teach");
        for (const Eigen::Vector3d& turn :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(-0.25, 0.5, 0),
              Eigen::Vector3d(-0.2, -0.4, 0.6)}) {
            feed(liveState(*onPoint(tool, point, turn)));
            click("tcp.teacher.take");
        }
        choose("tcp.teacher.turning", 1);
        feed(liveState(*onPoint(tool, point, {0, 0, 0})));
        click("tcp.teacher.takeTurn");
        click("tcp.teacher.make");
        const Pose one = document_->tooling().tools.at(0).tcpOffset;
        QVERIFY((rotationMatrix(one.rotation) - rotationMatrix(tool.rotation)).norm() < 1e-8);

        action("tcp.action.teachAgain")->trigger();
        for (const Eigen::Vector3d& turn :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(-0.25, 0.5, 0),
              Eigen::Vector3d(-0.2, -0.4, 0.6)}) {
            feed(liveState(*onPoint(tool, point, turn)));
            click("tcp.teacher.take");
        }
        choose("tcp.teacher.turning", 2);
        // The tool points straight down: +Z down, +X along +X of the base.
        for (const Eigen::Vector3d& way :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, -0.05), Eigen::Vector3d(0.05, 0, 0)}) {
            feed(liveState(*onPoint(tool, point + way, {0, 0, 0})));
            click("tcp.teacher.takeTurn");
        }
        QVERIFY2(label("tcp.teacher.turnFeedback").contains("Orientation recorded"),
                 qPrintable(label("tcp.teacher.turnFeedback")));
        click("tcp.teacher.make");
        QCOMPARE(document_->tooling().tools.size(), std::size_t(1));
        const Pose three = document_->tooling().tools.at(0).tcpOffset;
        QVERIFY((rotationMatrix(three.rotation) - rotationMatrix(tool.rotation)).norm() < 1e-7);
    }

    void payloadsAreEnteredAndPresetsAdded() {
        tab_->showPage(ToolsTab::Payloads);
        SessionState state = liveState();
        state.payloadMass = 1.5;
        state.payloadKnown = true;
        state.payloadCentre = {0, 0, 0.05};
        feed(state);
        action("payload.action.fromRobot")->trigger();
        QCOMPARE(document_->tooling().payloads.at(0).mass, 1.5);
        QVERIFY(label("payload.facts").contains("active on the robot"));
        type(tab_->findChild<QDoubleSpinBox*>("payload.details.mass"), "2.25");
        type(tab_->findChild<QDoubleSpinBox*>("payload.details.z"), "80");
        QCOMPARE(document_->tooling().payloads.at(0).mass, 2.25);
        QVERIFY(std::abs(document_->tooling().payloads.at(0).centre.z() - 0.08) < 1e-12);
        // Values out of range are refused instead of being clamped.
        type(tab_->findChild<QDoubleSpinBox*>("payload.details.mass"), "80");
        QCOMPARE(document_->tooling().payloads.at(0).mass, 2.25);
        QTest::keyClick(tab_->findChild<QDoubleSpinBox*>("payload.details.mass"), Qt::Key_Escape);
        action("payload.action.preset1")->trigger();
        QCOMPARE(document_->tooling().payloads.at(1).mass, 0.925);
        everythingGoesThereAndBack(4);
    }

    void aDifferentPayloadOnTheRobotAsks() {
        project::Tooling tooling;
        tooling.payloads = {{QUuid::createUuid(), "empty", 0.9, {0, 0, 0.05}, std::nullopt, {}, {}}};
        tooling.activePayload = tooling.payloads.at(0).id;
        document_->changeTooling(tooling, "x");
        SessionState state = liveState();
        state.payloadMass = 2;
        state.payloadKnown = true;
        feed(state);
        tab_->showPage(ToolsTab::Payloads);
        QVERIFY(notice("payload.page")->isVisible());
        QVERIFY(notice("payload.page")->text().contains("2.000 kg"));
        QVERIFY(document_->tooling() == tooling);
    }

    void payloadCheckMeasuresTheActualMass() {
        tab_->showPage(ToolsTab::Payloads);
        SessionState state = liveState();
        state.payloadMass = 1;
        state.tcpForce.force = {0, 0, -9.82};
        feed(state);
        click("payload.check");
        weigh(state);
        QVERIFY2(notice("payload.page")->title().contains("wrong"),
                 qPrintable(notice("payload.page")->title()));
        QVERIFY2(notice("payload.page")->text().contains("about 1.00 kg heavier"),
                 qPrintable(notice("payload.page")->text()));
        state.tcpForce.force = {0.1, 0, 0.4};
        feed(state);
        click("payload.check");
        weigh(state);
        QCOMPARE(notice("payload.page")->title(), QString("The payload is correct"));
        // A motion invalidates the measurement, and this is reported.
        click("payload.check");
        state.moving = true;
        weigh(state, 1);
        QVERIFY(notice("payload.page")->title().contains("The arm moved"));
    }

    void fourPosesMeasureAPayload() {
        tab_->showPage(ToolsTab::Payloads);
        feed(liveState());
        click("payload.weigh");
        const Eigen::Vector3d centre(0.01, -0.02, 0.07);
        for (int n = 0; n < 4; ++n) {
            // The arm moves to the proposed pose while the button is held.
            auto* next = tab_->findChild<HoldToRunButton*>("payload.estimator.next");
            QTest::mousePress(next, Qt::LeftButton);
            QVERIFY(next->isHolding());
            QTest::mouseRelease(next, Qt::LeftButton);
            QVERIFY(!next->isHolding());
            QCOMPARE(moves_.size(), static_cast<std::size_t>(n + 1));
            QCOMPARE(ends_.back(), control::StopCause::Released);
            SessionState state = liveState(moves_.back().q);
            const Eigen::Matrix3d R = kinematics::forward(dh(), state.q).linear();
            const Eigen::Vector3d weight = R.transpose() * Eigen::Vector3d(0, 0, -2.0 * 9.82);
            state.rawWrenchKnown = true;
            state.rawWrench = {weight + Eigen::Vector3d(1, -1, 2), centre.cross(weight)};
            feed(state);
            QVERIFY(!button("payload.estimator.keep")->isEnabled());
            click("payload.estimator.take");
            weigh(state);
        }
        QVERIFY2(label("payload.estimator.feedback").contains("2.000 kg"),
                 qPrintable(label("payload.estimator.feedback")));
        click("payload.estimator.keep");
        QCOMPARE(document_->tooling().payloads.size(), std::size_t(1));
        QVERIFY(std::abs(document_->tooling().payloads.at(0).mass - 2.0) < 1e-6);
        QVERIFY((document_->tooling().payloads.at(0).centre - centre).norm() < 1e-6);
        everythingGoesThereAndBack(1);
    }

    void nextPoseNeedsControl() {
        tab_->showPage(ToolsTab::Payloads);
        SessionState state = liveState();
        state.control = ControlState::None;
        state.controlReason = "Take control first.";
        feed(state);
        click("payload.weigh");
        auto* next = tab_->findChild<HoldToRunButton*>("payload.estimator.next");
        QTest::mousePress(next, Qt::LeftButton);
        QTest::mouseRelease(next, Qt::LeftButton);
        QVERIFY(moves_.empty());
    }

    void settingHomeAsksBeforeReplacingIt() {
        tab_->showPage(ToolsTab::Positions);
        feed(liveState());
        click("position.setHome");
        QVERIFY(document_->positions().homePosition() != nullptr);
        QCOMPARE(document_->positions().homePosition()->joints, kReadyJoints);
        feed(liveState(moved(0, 0.3)));
        click("position.setHome");
        QCOMPARE(document_->positions().homePosition()->joints, kReadyJoints);
        QTest::mouseClick(notice("position.page")->findChild<QPushButton*>("notice.accept"), Qt::LeftButton);
        QCOMPARE(document_->positions().homePosition()->joints, moved(0, 0.3));
        QCOMPARE(document_->positions().list.size(), std::size_t(1));
        everythingGoesThereAndBack(2);
    }

    void positionsAreAddedEditedTouchedUpAndSelected() {
        tab_->showPage(ToolsTab::Positions);
        feed(liveState());
        click("position.add");
        feed(liveState(moved(3, 0.1)));
        click("position.add");
        QCOMPARE(document_->positions().list.at(1).name, QString("position 2"));
        QVERIFY(document_->positions().home.isNull());
        click("position.useAsHome");
        QCOMPARE(document_->positions().home, document_->positions().list.at(1).id);
        type(tab_->findChild<QDoubleSpinBox*>("position.details.0"), "-45");
        QVERIFY(std::abs(document_->positions().list.at(1).joints[0] - toRadians(-45)) < 1e-12);
        feed(liveState());
        action("position.action.touchUp")->trigger();
        QVERIFY(notice("position.page")->text().contains("Largest joint change"));
        QTest::mouseClick(notice("position.page")->findChild<QPushButton*>("notice.accept"), Qt::LeftButton);
        QCOMPARE(document_->positions().list.at(1).joints, kReadyJoints);
        action("position.action.delete")->trigger();
        QVERIFY(document_->positions().home.isNull());
        everythingGoesThereAndBack(6);
    }

    // The questions are updated while the arm moves. The position at the time of confirmation is stored.
    void questionsAboutPositionsFollowTheArm() {
        tab_->showPage(ToolsTab::Positions);
        feed(liveState());
        click("position.setHome");
        const auto accept = [this] {
            QTest::mouseClick(notice("position.page")->findChild<QPushButton*>("notice.accept"),
                              Qt::LeftButton);
        };
        feed(liveState(moved(0, 0.3)));
        action("position.action.touchUp")->trigger();
        const QString text = notice("position.page")->text();
        feed(liveState(moved(1, 0.5)));
        QVERIFY2(notice("position.page")->text() != text, qPrintable(text));
        SessionState moving = liveState(moved(1, 0.6));
        moving.moving = true;
        feed(moving);
        accept();
        QCOMPARE(document_->positions().homePosition()->joints, kReadyJoints);
        QVERIFY(notice("position.page")->title().contains("moving"));
        feed(liveState(moved(1, 0.5)));
        action("position.action.touchUp")->trigger();
        feed(liveState(moved(1, 0.7)));
        accept();
        QCOMPARE(document_->positions().homePosition()->joints, moved(1, 0.7));

        click("position.setHome");
        feed(moving);
        accept();
        QCOMPARE(document_->positions().homePosition()->joints, moved(1, 0.7));
        feed(liveState());
        click("position.setHome");
        feed(liveState(moved(2, 0.2)));
        accept();
        QCOMPARE(document_->positions().homePosition()->joints, moved(2, 0.2));
    }

    void safeHeightIsTaughtAndEntered() {
        tab_->showPage(ToolsTab::Positions);
        const SessionState state = liveState();
        feed(state);
        click("position.heightHere");
        QVERIFY(document_->positions().safeHeight.has_value());
        QCOMPARE(document_->positions().safeHeight->height, state.tcpPose.position.z());
        type(tab_->findChild<QDoubleSpinBox*>("position.height"), "350");
        QVERIFY(std::abs(document_->positions().safeHeight->height - 0.35) < 1e-12);
        QTest::mouseClick(tab_->findChild<QWidget*>("position.hasHeight"), Qt::LeftButton, {}, QPoint(8, 10));
        QVERIFY(!document_->positions().safeHeight.has_value());
        everythingGoesThereAndBack(3);
    }

private:
    void feed(const SessionState& state) {
        Q_EMIT session_->stateChanged(state);
        // The values are updated ten times per second.
        tab_->tcps().setState(state);
        tab_->positions().setState(state);
    }
    /// Feeds the given number of samples of an arm at standstill.
    void weigh(SessionState state, int samples = StandstillMean::kSamples) {
        for (int n = 0; n < samples; ++n) {
            state.sequence = ++sequence_;
            Q_EMIT session_->stateChanged(state);
        }
    }
    QPushButton* button(const char* name) { return tab_->findChild<QPushButton*>(name); }
    QAction* action(const char* name) { return tab_->findChild<QAction*>(name); }
    QString label(const char* name) { return tab_->findChild<QLabel*>(name)->text(); }
    NoticeBar* notice(const char* page) {
        return tab_->findChild<QWidget*>(page)->findChild<NoticeBar*>("notice");
    }
    void click(const char* name) {
        QVERIFY2(button(name) != nullptr && button(name)->isVisible(), name);
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    void choose(const char* name, int index) {
        auto* box = tab_->findChild<QComboBox*>(name);
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    void type(QDoubleSpinBox* box, const char* text) {
        QVERIFY(box != nullptr && box->isVisible());
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// Undoes all edits one by one and redoes them. The project is then identical, byte by byte.
    void everythingGoesThereAndBack(int edits) {
        const QByteArray after = *project::serializeProject(document_->project());
        QCOMPARE(document_->undoStack().count(), edits);
        while (document_->undoStack().canUndo()) {
            document_->undoStack().undo();
        }
        QCOMPARE(*project::serializeProject(document_->project()), *project::serializeProject({}));
        while (document_->undoStack().canRedo()) {
            document_->undoStack().redo();
        }
        QCOMPARE(*project::serializeProject(document_->project()), after);
    }

    HoldPolicy policy_;
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<ToolsTab> tab_;
    std::vector<MoveRequest> moves_;
    std::vector<control::StopCause> ends_;
    std::uint64_t sequence_ = 100;
};

QTEST_MAIN(TestToolsTab)
#include "tst_tools_tab.moc"
