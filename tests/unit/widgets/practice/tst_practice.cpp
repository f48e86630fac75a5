// SPDX-License-Identifier: GPL-3.0-or-later
//
// Practice tasks: when they can be started, what they set up and restore, and the card that displays them.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "resources/resources.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/practice/practice.h"
#include "tests/support/live_state.h"
#include "widgets/common/theme.h"
#include "widgets/practice/checklist_item.h"
#include "widgets/practice/practice_card.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::test;

class TestPractice : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<Practice> practice_;
    QString elsewhere_;  ///< reason why practising is not possible with this robot
    QList<PracticeTask> setUp_;
    int tidied_ = 0;

    void show(const SessionState& state) { Q_EMIT session_->stateChanged(state); }
    static SessionState stopped() {
        SessionState state = liveState();
        state.safetyMode = SafetyMode::ProtectiveStop;
        state.control = ControlState::None;
        return state;
    }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }
    void init() {
        elsewhere_.clear();
        setUp_.clear();
        tidied_ = 0;
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        PracticeHooks hooks;
        hooks.obstacle = [this](const SessionState&) { return elsewhere_; };
        hooks.setUp = [this](PracticeTask task) { setUp_.append(task); };
        hooks.tidyUp = [this] { ++tidied_; };
        hooks.addWaypoint = [this](const project::Waypoint& point) {
            document_->insertWaypoints(document_->waypoints().size(), {point}, "Practice");
        };
        practice_ = std::make_unique<Practice>(*session_, *document_, hooks);
    }
    void cleanup() {
        practice_.reset();
        document_.reset();
        session_.reset();
    }

    void unavailableTaskIsRefusedWithAReason() {
        practice_->start();
        QVERIFY(!practice_->isRunning() && practice_->text().contains("simulated robot"));
        elsewhere_ = QStringLiteral("This is “Lab UR5e”.");
        show(liveState());
        practice_->start();
        QVERIFY(!practice_->isRunning() && practice_->text() == elsewhere_);
        elsewhere_.clear();
        SessionState off = liveState();
        off.robotMode = RobotMode::PowerOff;
        show(off);
        practice_->start();
        QVERIFY(!practice_->isRunning() && practice_->text().contains("Power"));
        show(stopped());
        practice_->start();
        QVERIFY(!practice_->isRunning() && practice_->text().contains("Recover"));
        QVERIFY(setUp_.isEmpty());
        show(liveState());
        practice_->start();
        QVERIFY(practice_->isRunning());
        QCOMPARE(setUp_, QList<PracticeTask>{PracticeTask::Recover});
    }

    void onlyCheckedResultsCountAsDone() {
        QSignalSpy done(practice_.get(), &Practice::taskDone);
        show(liveState());
        practice_->start();
        practice_->finish();
        QCOMPARE(done.count(), 0);
        show(stopped());
        show(liveState());
        QVERIFY(practice_->passed());
        practice_->finish();
        QCOMPARE(done.count(), 1);
        QCOMPARE(practice_->done(), QStringList{"recover"});
        QVERIFY(practice_->task() == PracticeTask::TeachFrame && !practice_->isRunning());
        QCOMPARE(tidied_, 1);
    }

    void lastCompletedTaskStaysShown() {
        practice_->setDone({"teachFrame", "touchUp", "findLimit", "measure"});
        show(liveState());
        practice_->start();
        show(stopped());
        show(liveState());
        practice_->finish();
        QVERIFY(practice_->allDone() && practice_->task() == PracticeTask::Recover);
    }

    void abandonedTaskIsReverted() {
        show(liveState());
        practice_->choose(PracticeTask::Measure);
        practice_->start();
        QCOMPARE(tidied_, 0);
        practice_->turn(1);
        QCOMPARE(tidied_, 1);
        QVERIFY(!practice_->isRunning() && practice_->task() == PracticeTask::Recover);
        practice_->turn(-1);
        practice_->start();
        // Another robot is connected.
        elsewhere_ = QStringLiteral("This is “Lab UR5e”.");
        show(liveState());
        QCOMPARE(tidied_, 2);
        elsewhere_.clear();
        show(liveState());
        practice_->start();
        practice_.reset();
        QCOMPARE(tidied_, 3);
    }

    void touchUpTaskProvidesItsWaypoint() {
        show(liveState());
        practice_->choose(PracticeTask::TouchUp);
        practice_->start();
        QCOMPARE(document_->waypoints().size(), 1);
        QCOMPARE(document_->waypoints().at(0).joints.values, kReadyJoints.values);
        // Simulates a touch-up while the arm is at the part.
        SessionState there = liveState();
        there.tcpPose.position.x() += kPartMoved;
        show(there);
        QVERIFY(!practice_->passed());
        project::Waypoint point = document_->waypoints().at(0);
        point.pose = there.tcpPose;
        document_->changeWaypoint(0, point, "Touch up");
        QVERIFY2(practice_->passed(), "the edit was not checked immediately");
        document_->undoStack().undo();
        document_->undoStack().undo();
        QVERIFY(document_->waypoints().isEmpty());
    }

    // ---- the card

    void theCardUpdatesButItsButtonsStayInPlace() {
        QWidget view;
        view.resize(480, 500);
        PracticeCard card(*practice_, view);
        view.show();
        card.open();
        QCoreApplication::processEvents();
        auto* start = card.findChild<QPushButton*>("practice.start");
        auto* done = card.findChild<QPushButton*>("practice.done");
        auto* check = card.findChild<ChecklistItem*>("practice.check");
        const auto place = [&](const QWidget* key) {
            return QRect(key->mapTo(&view, QPoint()), key->size());
        };
        const QRect startAt = place(start);
        const QRect doneAt = place(done);
        QVERIFY(!start->isEnabled() && start->toolTip().contains("simulated robot"));
        for (int i = 0; i < static_cast<int>(kPracticeTasks.size()); ++i) {
            QVERIFY(card.findChild<QLabel*>("practice.what")->text() == practiceText(practice_->task()));
            QTest::mouseClick(card.findChild<QAbstractButton*>("practice.next"), Qt::LeftButton);
            QCoreApplication::processEvents();
            QCOMPARE(place(start), startAt);
            QCOMPARE(place(done), doneAt);
        }
        show(liveState());
        QTest::mouseClick(start, Qt::LeftButton);
        QVERIFY(practice_->isRunning() && !done->isEnabled());
        show(stopped());
        QVERIFY(check->text().contains("protective stop") && !check->isDone());
        show(liveState());
        QVERIFY(check->isDone() && done->isEnabled());
        QCoreApplication::processEvents();
        QCOMPARE(place(done), doneAt);
        QTest::mouseClick(done, Qt::LeftButton);
        QCOMPARE(practice_->done(), QStringList{"recover"});
    }

    void answerIsEnteredWithReturn() {
        QWidget view;
        view.setFocusPolicy(Qt::StrongFocus);
        view.resize(480, 400);
        PracticeCard card(*practice_, view);
        view.show();
        view.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&view));
        card.open();
        auto* answer = card.findChild<QLineEdit*>("practice.answer");
        QVERIFY(!answer->isVisible());
        show(liveState());
        practice_->choose(PracticeTask::Measure);
        QVERIFY(answer->isVisible() && !answer->isEnabled());
        practice_->start();
        QVERIFY(answer->isEnabled());
        SessionState state = liveState();
        state.tcpForce.force.z() = -41;
        state.recording.active = true;
        show(state);
        state.recording.seconds = 4;
        show(state);
        state.recording.active = false;
        show(state);
        answer->setFocus();
        for (const char* wrong : {"20,5", "nan", "-nan", "inf", "-inf"}) {
            answer->selectAll();
            QTest::keyClicks(answer, wrong);
            QTest::keyClick(answer, Qt::Key_Return);
            QVERIFY2(!practice_->passed(), wrong);
        }
        answer->selectAll();
        QTest::keyClicks(answer, "-41.0");
        QVERIFY2(!practice_->passed(), "the check passed before Return was pressed");
        QTest::keyClick(answer, Qt::Key_Return);
        QVERIFY(practice_->passed());
        // When the task is completed, the field disappears. The focus then moves to the view, not to the next
        // task.
        answer->setFocus();
        practice_->finish();
        QVERIFY(!answer->isVisible() && view.hasFocus());
    }
};

QTEST_MAIN(TestPractice)
#include "tst_practice.moc"
