// SPDX-License-Identifier: GPL-3.0-or-later
//
// The “First steps” checklist: actions that complete an item, actions that do not, and the card that shows
// the checklist.

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <memory>

#include "resources/resources.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/practice/first_steps.h"
#include "tests/support/live_state.h"
#include "widgets/common/theme.h"
#include "widgets/practice/checklist_item.h"
#include "widgets/practice/first_steps_card.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::test;

namespace {

project::Waypoint taughtAt(const JointPositions& q) {
    project::Waypoint point;
    point.id = QUuid::createUuid();
    point.name = QStringLiteral("home");
    point.joints = q;
    point.pose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, q);
    return point;
}

}  // namespace

class TestFirstSteps : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<FirstSteps> steps_;

    void show(const SessionState& state) { Q_EMIT session_->stateChanged(state); }
    bool isDone(FirstStep step) const { return steps_->isDone(step); }
    /// Simulates a move by Tiller, as reported in frames.
    void move(const JointPositions& from, const JointPositions& to) {
        SessionState state = liveState(from);
        show(state);
        state.motionActive = state.moving = true;
        show(state);
        state = liveState(to);
        state.motionActive = state.moving = true;
        show(state);
        show(liveState(to));
    }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }
    void init() {
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        steps_ = std::make_unique<FirstSteps>(*session_, *document_);
        steps_->setFollowing(true);
    }
    void cleanup() {
        steps_.reset();
        document_.reset();
        session_.reset();
    }

    void powerAndBrakesAreTickedOnRobotReport() {
        SessionState state = liveState();
        state.robotMode = RobotMode::PowerOff;
        show(state);
        state.robotMode = RobotMode::PowerOn;
        show(state);
        QVERIFY2(!isDone(FirstStep::PowerOn), "the item is completed before the arm is powered on");
        state.robotMode = RobotMode::Idle;
        show(state);
        QVERIFY(isDone(FirstStep::PowerOn) && !isDone(FirstStep::ReleaseBrakes));
        state.robotMode = RobotMode::Running;
        show(state);
        QVERIFY(isDone(FirstStep::ReleaseBrakes));
        QCOMPARE(steps_->done(), (QStringList{"powerOn", "releaseBrakes"}));
    }

    void aJogTicksOnceTheArmMoves() {
        SessionState state = liveState();
        state.motionActive = state.jogActive = true;
        show(state);
        QVERIFY2(!isDone(FirstStep::Jog), "a request without a motion completed the item");
        state.moving = true;
        show(state);
        QVERIFY(isDone(FirstStep::Jog));
        QVERIFY(!isDone(FirstStep::GoTo));
    }

    void teachingTicksButPastingDoesNot() {
        show(liveState());
        document_->insertWaypoints(0, {taughtAt(moved(1, 0.3))}, "Paste");
        QVERIFY2(!isDone(FirstStep::Teach), "a waypoint away from the arm completed the item");
        project::Project opened;
        opened.waypoints.append(taughtAt(kReadyJoints));
        document_->setProject(opened);
        QVERIFY2(!isDone(FirstStep::Teach), "opening a project completed the item");
        document_->insertWaypoints(0, {taughtAt(kReadyJoints)}, "Teach");
        QVERIFY(isDone(FirstStep::Teach));
    }

    void goToIsTickedWhenTheArmReachesAWaypoint() {
        document_->insertWaypoints(0, {taughtAt(moved(0, 0.5))}, "Teach");
        move(kReadyJoints, moved(0, 0.2));
        QVERIFY2(!isDone(FirstStep::GoTo), "a move that did not reach the waypoint completed the item");
        move(moved(0, 0.2), moved(0, 0.5));
        QVERIFY(isDone(FirstStep::GoTo));
    }

    void beingAtAWaypointDoesNotTickGoTo() {
        document_->insertWaypoints(0, {taughtAt(kReadyJoints)}, "Teach");
        move(kReadyJoints, kReadyJoints);
        QVERIFY(!isDone(FirstStep::GoTo));
    }

    void joggingToAWaypointDoesNotTickGoTo() {
        document_->insertWaypoints(0, {taughtAt(moved(0, 0.5))}, "Teach");
        SessionState state = liveState(moved(0, 0.1));
        state.motionActive = state.jogActive = state.moving = true;
        show(state);
        show(liveState(moved(0, 0.5)));
        QVERIFY(!isDone(FirstStep::GoTo));
    }

    void aRecordingTicksWithItsFirstRow() {
        SessionState state = liveState();
        state.recording.active = true;
        show(state);
        QVERIFY(!isDone(FirstStep::Record));
        state.recording.rows = 1;
        show(state);
        QVERIFY(isDone(FirstStep::Record));
    }

    void nothingIsTickedWithStaleOrMissingData() {
        SessionState state = liveState();
        state.motionActive = state.jogActive = state.moving = true;
        state.link = LinkState::Stale;
        show(state);
        steps_->setFollowing(false);
        show(liveState());
        document_->insertWaypoints(0, {taughtAt(kReadyJoints)}, "Teach");
        QVERIFY2(steps_->done().isEmpty(), qPrintable(steps_->done().join(' ')));
    }

    void progressIsSavedByName() {
        steps_->setDone({"jog", "record", "something else"});
        QCOMPARE(steps_->done(), (QStringList{"jog", "record"}));
        QVERIFY(!steps_->allDone());
        steps_->setDone({"powerOn", "releaseBrakes", "jog", "teach", "goTo", "record"});
        QVERIFY(steps_->allDone());
    }

    // ---- the card

    void tickingDoesNotMoveTheCardContents() {
        QWidget view;
        view.resize(480, 280);
        FirstStepsCard card(*steps_, view);
        view.show();
        card.open();
        QCoreApplication::processEvents();
        QVERIFY(card.isVisible() && !card.isFolded());
        QVERIFY2(view.rect().contains(card.geometry()), "the card extends beyond the view");
        const QList<QWidget*> parts = card.findChildren<QWidget*>();
        QVector<QRect> places;
        for (const QWidget* part : parts) {
            places.append(QRect(part->mapTo(&view, QPoint()), part->size()));
        }
        const QRect place = card.geometry();
        for (int i = 0; i < static_cast<int>(kFirstSteps.size()); ++i) {
            QVERIFY(!card.findChild<ChecklistItem*>(QStringLiteral("firstSteps.%1").arg(i))->isDone());
        }
        steps_->setDone({"powerOn", "releaseBrakes", "jog", "teach", "goTo", "record"});
        QCoreApplication::processEvents();
        for (int i = 0; i < static_cast<int>(kFirstSteps.size()); ++i) {
            const auto* line = card.findChild<ChecklistItem*>(QStringLiteral("firstSteps.%1").arg(i));
            QVERIFY(line->isDone() && line->accessibleDescription() == "done");
        }
        QCOMPARE(card.geometry(), place);
        for (qsizetype i = 0; i < parts.size(); ++i) {
            QCOMPARE(QRect(parts[i]->mapTo(&view, QPoint()), parts[i]->size()), places[i]);
        }
    }

    void aSmallViewShowsOnlyTheTitle() {
        QWidget view;
        view.resize(480, 100);
        FirstStepsCard card(*steps_, view);
        view.show();
        card.open();
        QVERIFY(card.isFolded());
        QVERIFY(view.rect().contains(card.geometry()));
        QVERIFY(!card.findChild<QPushButton*>("firstSteps.dismiss")->isVisible());
        view.resize(480, 400);
        QTRY_VERIFY_WITH_TIMEOUT(!card.isFolded(), 60'000);
        QVERIFY(card.findChild<QPushButton*>("firstSteps.dismiss")->isVisible());
        QTest::mouseClick(card.findChild<QToolButton*>("firstSteps.fold"), Qt::LeftButton);
        QVERIFY(card.isFolded());
    }

    void automaticCardCoversLittleOfTheView() {
        QWidget view;
        view.resize(344, 280);
        FirstStepsCard card(*steps_, view);
        view.show();
        card.openQuietly();
        QVERIFY(card.isVisible() && card.isFolded());
        QTest::mouseClick(card.findChild<QToolButton*>("firstSteps.fold"), Qt::LeftButton);
        QVERIFY(!card.isFolded() && view.rect().contains(card.geometry()));
        card.putAway();
        view.resize(900, 600);
        card.openQuietly();
        QVERIFY(!card.isFolded());
    }

    void foldingDoesNotMoveTheButton() {
        QWidget view;
        view.resize(480, 400);
        FirstStepsCard card(*steps_, view);
        view.show();
        card.open();
        QCoreApplication::processEvents();
        auto* fold = card.findChild<QToolButton*>("firstSteps.fold");
        const QPoint at = fold->mapTo(&view, QPoint());
        for (int i = 0; i < 2; ++i) {
            QTest::mouseClick(fold, Qt::LeftButton);
            QCoreApplication::processEvents();
            QCOMPARE(fold->mapTo(&view, QPoint()), at);
            QVERIFY2(view.height() - card.geometry().bottom() < 16, "the card is not at the lower edge");
        }
        QVERIFY(!card.isFolded());
    }

    void aHiddenCardMovesTheFocusToTheView() {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* view = new QWidget;
        view->setFocusPolicy(Qt::StrongFocus);
        view->setMinimumSize(480, 320);
        auto* next = new QLineEdit;
        layout->addWidget(view);
        layout->addWidget(next);
        FirstStepsCard card(*steps_, *view);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        card.open();
        auto* dismiss = card.findChild<QPushButton*>("firstSteps.dismiss");
        dismiss->setFocus(Qt::TabFocusReason);
        QVERIFY(dismiss->hasFocus());
        QSignalSpy dismissed(&card, &FirstStepsCard::dismissed);
        QTest::mouseClick(dismiss, Qt::LeftButton);
        QCOMPARE(dismissed.count(), 1);
        card.putAway();
        QVERIFY(view->hasFocus() && !card.isVisible());
    }

    void theMouseOnTheCardDoesNotReachTheView() {
        struct View : QWidget {
            int presses = 0;
            void mousePressEvent(QMouseEvent*) override { ++presses; }
        } view;
        view.resize(480, 400);
        FirstStepsCard card(*steps_, view);
        view.show();
        card.open();
        QTest::mouseClick(card.findChild<ChecklistItem*>("firstSteps.0"), Qt::LeftButton);
        QTest::mouseClick(&card, Qt::LeftButton, {}, QPoint(4, 4));
        QCOMPARE(view.presses, 0);
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(470, 10));
        QCOMPARE(view.presses, 1);
    }
};

QTEST_MAIN(TestFirstSteps)
#include "tst_first_steps.moc"
