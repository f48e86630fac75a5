// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>
#include <memory>
#include <vector>

#include "robot/core/angles.h"
#include "robot/core/clock.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/event_spy.h"
#include "tests/support/key_events.h"
#include "tests/support/live_state.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/project/project_files.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoint_details.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_table.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;
using control::StopCause;

namespace {

/// Replaces the arm and counts the requests of the tab.
struct FakeArm {
    std::vector<MoveRequest> moves;
    std::vector<StopCause> ends;
    int holds = 0;
    bool alive = true;
    Error refusal;

    MotionPort port() {
        return {
            .beginMove = [this](const MoveRequest& request) -> Result<RobotSession::MotionId> {
                if (refusal.code != ErrorCode::None) {
                    return refusal;
                }
                moves.push_back(request);
                alive = true;
                return RobotSession::MotionId(moves.size());
            },
            .hold =
                [this](RobotSession::MotionId) {
                    ++holds;
                    return alive;
                },
            .endMotion = [this](RobotSession::MotionId, StopCause cause) { ends.push_back(cause); },
            .limits = [] { return control::MotionLimits(); },
        };
    }
};

}  // namespace

class TestWaypointsTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        arm_ = FakeArm();
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        document_ = std::make_unique<UndoableDocument>();
        tab_ = std::make_unique<WaypointsTab>(*session_, *document_, arm_.port(), policy_);
        goTo()->guard().setClock(clock_);
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
        auto* empty = tab_->findChild<QLabel*>("waypoint.empty");
        QVERIFY(empty->isVisible());
        QVERIFY(empty->text().contains("Teach here"));
        QVERIFY(!table()->isVisible());
        feed(liveState());
        click("waypoint.teach");
        QVERIFY(!empty->isVisible());
        QVERIFY(table()->isVisible());
    }

    void teachingNeedsFreshData() {
        QVERIFY(!button("waypoint.teach")->isEnabled());
        QVERIFY(!button("waypoint.teach")->toolTip().isEmpty());
        feed(liveState());
        QVERIFY(button("waypoint.teach")->isEnabled());
        SessionState stale = liveState();
        stale.link = LinkState::Stale;
        feed(stale);
        QVERIFY(!button("waypoint.teach")->isEnabled());
        tab_->teach();
        QCOMPARE(document_->waypoints().size(), 0);
    }

    void teachStoresJointsAndPoseAfterTheSelection() {
        teachThree();
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 2", "waypoint 3"}));
        tab_->selectRow(0);
        SessionState state = liveState(moved(0, 0.5));
        state.tcpOffset = Pose(0, 0, 0.1, 0, 0, 0);
        feed(state);
        QTest::keyClick(tab_.get(), Qt::Key_T);
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 4", "waypoint 2", "waypoint 3"}));
        QCOMPARE(tab_->currentRow(), 1);
        const project::Waypoint& taught = document_->waypoints().at(1);
        QCOMPARE(taught.joints, state.q);
        QCOMPARE(taught.pose, state.tcpPose);
        QCOMPARE(taught.tcpOffset, state.tcpOffset);
    }

    // A letter that was typed without an input field must not change the project unnoticed.
    void teachingByKeyFromElsewhereIsShown() {
        teachThree();
        QWidget other;
        QVBoxLayout layout(&other);
        QPushButton pad;
        layout.addWidget(&pad);
        layout.addWidget(tab_.get());
        other.show();
        QVERIFY(QTest::qWaitForWindowActive(&other));
        pad.setFocus();
        feed(liveState(moved(0, 0.5)));
        QTest::keyClick(&pad, Qt::Key_T);
        QCOMPARE(document_->waypoints().size(), 4);
        QVERIFY(notice()->isVisible());
        QVERIFY2(notice()->title().contains("Taught “waypoint 4”"), qPrintable(notice()->title()));
        click("notice.accept");
        QCOMPARE(document_->waypoints().size(), 3);
        // F2 renames the new waypoint.
        pad.setFocus();
        QTest::keyClick(&pad, Qt::Key_T);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F2);
        QVERIFY(table()->findChild<QLineEdit*>() != nullptr);
        // With the focus in the tab, the selection shows the new waypoint.
        QTest::keyClick(table()->findChild<QLineEdit*>(), Qt::Key_Escape);
        click("notice.dismiss");
        table()->setFocus();
        QTest::keyClick(table(), Qt::Key_T);
        QCOMPARE(document_->waypoints().size(), 5);
        QVERIFY(!notice()->isVisible());
        tab_->setParent(nullptr);
    }

    void touchUpShowsTheDifferenceAndAsks() {
        teachThree();
        tab_->selectRow(1);
        const project::Waypoint before = document_->waypoints().at(1);
        const SessionState live = liveState(moved(4, 0.2));
        feed(live);
        QTest::keyClick(tab_.get(), Qt::Key_U);
        QVERIFY(notice()->isVisible());
        QVERIFY(notice()->title().contains("waypoint 2"));
        QVERIFY2(notice()->text().contains("mm"), qPrintable(notice()->text()));
        QVERIFY(notice()->text().contains("Wrist 2"));
        QVERIFY(document_->waypoints().at(1) == before);

        click("notice.dismiss");
        QVERIFY(!notice()->isVisible());
        QVERIFY(document_->waypoints().at(1) == before);

        click("waypoint.touchUp");
        click("notice.accept");
        QCOMPARE(document_->waypoints().at(1).joints, live.q);
        QCOMPARE(document_->waypoints().at(1).name, before.name);
        QCOMPARE(document_->waypoints().at(1).id, before.id);
        document_->undoStack().undo();
        QVERIFY(document_->waypoints().at(1) == before);
    }

    // The arm moves while the question is open. Distance and ghost are updated, and the position at the time
    // of confirmation is stored.
    void touchUpFollowsTheArm() {
        teachThree();
        tab_->selectRow(1);
        const project::Waypoint before = document_->waypoints().at(1);
        feed(liveState(moved(4, 0.2)));
        click("waypoint.touchUp");
        const QString text = notice()->text();
        const SessionState later = liveState(moved(4, 0.9));
        feed(later);
        QTRY_VERIFY_WITH_TIMEOUT(notice()->text() != text, 60'000);
        QVERIFY2(notice()->text().contains(QStringLiteral("mm")), qPrintable(notice()->text()));
        QVERIFY(tab_->touchUpGhost().has_value());
        QCOMPARE(tab_->touchUpGhost()->q, later.q);
        click("notice.accept");
        QCOMPARE(document_->waypoints().at(1).joints, later.q);
        QCOMPARE(document_->waypoints().at(1).pose, later.tcpPose);
        document_->undoStack().undo();
        QVERIFY(document_->waypoints().at(1) == before);
    }

    void touchUpIsNotConfirmedWithAMovingArm() {
        teachThree();
        tab_->selectRow(1);
        const project::Waypoint before = document_->waypoints().at(1);
        feed(liveState(moved(4, 0.2)));
        click("waypoint.touchUp");
        SessionState moving = liveState(moved(4, 0.9));
        moving.moving = true;
        feed(moving);
        click("notice.accept");
        QVERIFY(document_->waypoints().at(1) == before);
        QVERIFY(notice()->isVisible());
        QVERIFY2(notice()->title().contains(QStringLiteral("moving")), qPrintable(notice()->title()));
    }

    // A click on the text of the question gives it the focus, but the key belongs to the list.
    void deleteInTheTouchUpQuestionDeletesNothing() {
        teachThree();
        tab_->selectRow(1);
        feed(liveState(moved(4, 0.2)));
        click("waypoint.touchUp");
        auto* text = tab_->findChild<QLabel*>("notice.text");
        QTest::mouseClick(text, Qt::LeftButton);
        QCOMPARE(QApplication::focusWidget(), text);
        QTest::keyClick(text, Qt::Key_Delete);
        QCOMPARE(document_->waypoints().size(), 3);
        QVERIFY(notice()->isVisible());
        click("notice.dismiss");
        QVERIFY2(table()->hasFocus(), "not a button that records or moves");
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(document_->waypoints().size(), 2);
    }

    // The notice disappears automatically, because its reason is temporary and the log keeps the text.
    void aPressDuringAnotherHoldShowsAPassingNotice() {
        teachThree();
        tab_->selectRow(0);
        QWidget other;
        HoldRules hold(policy_, [&hold](StopCause) { hold.end(); });
        hold.begin(&other, {HoldSource::By::Keys}, {});
        QVERIFY(!goTo()->guard().press({HoldSource::By::Keys}));
        QVERIFY(notice()->isVisible());
        QVERIFY2(notice()->title().contains("already held"), qPrintable(notice()->title()));
        QTRY_VERIFY_WITH_TIMEOUT(!notice()->isVisible(), 60'000);
    }

    void changedSelectionCancelsTheQuestion() {
        teachThree();
        tab_->selectRow(1);
        click("waypoint.touchUp");
        QVERIFY(notice()->isVisible());
        tab_->selectRow(2);
        QVERIFY(!notice()->isVisible());
    }

    void f2RenamesInPlace() {
        teachThree();
        tab_->selectRow(1);
        QTest::keyClick(table(), Qt::Key_F2);
        auto* editor = table()->findChild<QLineEdit*>("waypoint.editor");
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, "above tray");  // letters that are shortcuts in other places
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(names(), QStringList({"waypoint 1", "above tray", "waypoint 3"}), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(table()->findChild<QLineEdit*>("waypoint.editor") == nullptr, 60'000);
        QTest::keyClick(table(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names().at(1), QString("waypoint 2"));
        QTest::keyClick(table(), Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(names().at(1), QString("above tray"));
    }

    void typingTeachesNothing() {
        teachThree();
        tab_->selectRow(0);
        QTest::keyClick(table(), Qt::Key_F2);
        auto* editor = table()->findChild<QLineEdit*>("waypoint.editor");
        QTest::keyClicks(editor, "tug");
        QCOMPARE(document_->waypoints().size(), 3);
        QVERIFY(arm_.moves.empty());
        QCOMPARE(editor->text(), QString("tug"));
        QTest::keyClick(editor, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(table()->findChild<QLineEdit*>("waypoint.editor") == nullptr, 60'000);
        QCOMPARE(names().at(0), QString("waypoint 1"));
    }

    // If a cursor key ended the editing, the next letters would trigger commands for another waypoint.
    void cursorKeysStayInTheNameField() {
        teachThree();
        tab_->selectRow(0);
        QTest::keyClick(table(), Qt::Key_F2);
        auto* editor = table()->findChild<QLineEdit*>("waypoint.editor");
        QVERIFY(editor != nullptr);
        for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Up, Qt::Key_PageDown, Qt::Key_PageUp}) {
            QTest::keyClick(editor, key);
            QVERIFY2(editor->isVisible() && editor->hasFocus(), "the key ended the editing");
            QCOMPARE(table()->currentIndex().row(), 0);
        }
        QTest::keyClick(editor, Qt::Key_Escape);
    }

    void numbersWithTwoDigitsFit() {
        for (int n = 0; n < 12; ++n) {
            feed(liveState(moved(5, 0.1 * n)));
            tab_->teach();
        }
        const QModelIndex last =
            table()->model()->index(table()->model()->rowCount() - 1, WaypointModel::Number);
        QVERIFY(last.row() >= 9);
        const int needed = table()->sizeHintForIndex(last).width();
        QVERIFY2(
            table()->columnWidth(WaypointModel::Number) >= needed,
            qPrintable(QString("%1 of %2").arg(table()->columnWidth(WaypointModel::Number)).arg(needed)));
    }

    // The first letter typed in the list starts a search for a name. The letters that follow it are part of
    // the search and do not trigger commands.
    void typingAWordInTheListIsNotACommand() {
        const int interval = QApplication::keyboardInputInterval();
        const auto restore = qScopeGuard([interval] { QApplication::setKeyboardInputInterval(interval); });
        QApplication::setKeyboardInputInterval(60'000);
        teachThree();
        tab_->selectRow(0);
        table()->setFocus();
        QTest::keyClicks(table(), "waypoint");
        QTest::keyClick(table(), Qt::Key_U);
        QTest::keyPress(table(), Qt::Key_G);
        QVERIFY(!goTo()->isHolding());
        QTest::keyRelease(table(), Qt::Key_G);
        QCOMPARE(document_->waypoints().size(), 3);
        QVERIFY(!notice()->isVisible());
        QVERIFY(arm_.moves.empty());
        // A click ends the search, so the next letter is a command.
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {},
                          table()->visualRect(table()->model()->index(2, WaypointModel::Name)).center());
        QTest::keyClick(table(), Qt::Key_T);
        QCOMPARE(document_->waypoints().size(), 4);
    }

    // A notice reduces the table height at the lower end. The rows do not move and are not covered.
    void aNoticeMovesAndCoversNoRow() {
        teachThree();
        tab_->resize(tab_->width(), 700);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        tab_->selectRow(0);
        const QModelIndex second = table()->model()->index(1, WaypointModel::Name);
        const QRect list(table()->mapTo(tab_.get(), QPoint(0, 0)), table()->size());
        const QRect row = table()->visualRect(second);
        click("waypoint.touchUp");
        QVERIFY(notice()->isVisible());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const QRect below(table()->mapTo(tab_.get(), QPoint(0, 0)), table()->size());
        QCOMPARE(below.topLeft(), list.topLeft());
        QCOMPARE(below.width(), list.width());
        QVERIFY2(!below.intersects(notice()->geometry()), "the notice covers the table");
        QCOMPARE(table()->visualRect(second), row);
        QVERIFY2(tab_->rect().contains(notice()->geometry()), "the notice extends beyond the page");
        QVERIFY2(notice()->height() >= notice()->heightForWidth(notice()->width()),
                 "the text of the notice is clipped");
        for (const QPushButton* key : tab_->findChildren<QPushButton*>()) {
            const QRect place(key->mapTo(tab_.get(), QPoint(0, 0)), key->size());
            QVERIFY2(
                notice()->isAncestorOf(key) || !key->isVisible() || !notice()->geometry().intersects(place),
                qPrintable(key->objectName()));
        }
        click("notice.dismiss");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QCOMPARE(table()->visualRect(second), row);
        QCOMPARE(QRect(table()->mapTo(tab_.get(), QPoint(0, 0)), table()->size()), list);
    }

    void waypointsAreDuplicatedDeletedAndMovedByKey() {
        teachThree();
        tab_->selectRow(0);
        QTest::keyClick(table(), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 4", "waypoint 2", "waypoint 3"}));
        QTest::keyClick(table(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 2", "waypoint 4", "waypoint 3"}));
        QCOMPARE(tab_->currentRow(), 2);
        QTest::keyClick(table(), Qt::Key_Up, Qt::AltModifier);
        QTest::keyClick(table(), Qt::Key_Up, Qt::AltModifier);
        QTest::keyClick(table(), Qt::Key_Up, Qt::AltModifier);  // already first, so there is no effect
        QCOMPARE(names(), QStringList({"waypoint 4", "waypoint 1", "waypoint 2", "waypoint 3"}));
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 2", "waypoint 3"}));
        QCOMPARE(tab_->currentRow(), 0);
        for (int n = 0; n < 5; ++n) {
            QTest::keyClick(table(), Qt::Key_Z, Qt::ControlModifier);
        }
        QCOMPARE(names(), QStringList({"waypoint 1", "waypoint 2", "waypoint 3"}));
    }

    void copyAndPasteGoThroughText() {
        teachThree();
        tab_->selectRow(0);
        table()->selectAll();
        QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().startsWith("Name\tMove\t"));
        tab_->selectRow(2);
        QTest::keyClick(table(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(document_->waypoints().size(), 6);
        QStringList all = names();
        QCOMPARE(all.removeDuplicates(), 0);
        document_->undoStack().undo();
        QCOMPARE(document_->waypoints().size(), 3);

        QApplication::clipboard()->setText("not\ta table");
        QTest::keyClick(table(), Qt::Key_V, Qt::ControlModifier);
        QVERIFY(notice()->isVisible());
        QCOMPARE(document_->waypoints().size(), 3);
    }

    void holdingGoToMovesAndReleasingStops() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        HoldToRunButton* key = goTo();
        QVERIFY2(key->isEnabled(), qPrintable(key->toolTip()));
        QTest::mousePress(key, Qt::LeftButton);
        QCOMPARE(arm_.moves.size(), std::size_t(1));
        QVERIFY(arm_.moves[0].kind == MoveRequest::Kind::MoveJ);
        QCOMPARE(arm_.moves[0].q, document_->waypoints().at(1).joints);
        QTRY_VERIFY_WITH_TIMEOUT(arm_.holds >= 2, 60'000);
        QTest::mouseRelease(key, Qt::LeftButton);
        QCOMPARE(arm_.ends, std::vector<StopCause>{StopCause::Released});
        const int holds = arm_.holds;
        QTest::qWait(3 * HoldGuard::kRefreshMs);
        QCOMPARE(arm_.holds, holds);
    }

    void holdingTheLetterGMovesAndReleasingStops() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QTest::keyPress(table(), Qt::Key_G);
        QCOMPARE(arm_.moves.size(), std::size_t(1));
        QVERIFY(goTo()->isHolding());
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_G, Qt::NoModifier, "g", true);
        QApplication::sendEvent(QApplication::focusWidget(), &repeat);
        QCOMPARE(arm_.moves.size(), std::size_t(1));
        QVERIFY(arm_.ends.empty());
        QTest::keyRelease(QApplication::focusWidget(), Qt::Key_G);
        QCOMPARE(arm_.ends, std::vector<StopCause>{StopCause::Released});
        QVERIFY(!goTo()->isHolding());
    }

    // The key may have been released while another window was active.
    void theLetterGEndsWithTheWindowItWasPressedIn() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QWidget& to = *table();
        keyDown(to, scan::kG, Qt::Key_G);
        QVERIFY(goTo()->isHolding());
        QWidget left;
        QEvent deactivate(QEvent::WindowDeactivate);
        QApplication::sendEvent(&left, &deactivate);
        QCOMPARE(arm_.ends, std::vector<StopCause>{StopCause::WindowDeactivated});
        QVERIFY(!goTo()->isHolding());
        // The release was sent to another window, so the next press counts as a new press.
        keyDown(to, scan::kG, Qt::Key_G);
        QCOMPARE(arm_.moves.size(), std::size_t(2));
        keyUp(to, scan::kG, Qt::Key_G);
        QVERIFY(!goTo()->isHolding());
    }

    void theLetterGIsAKeyFromPressToRelease_data() {
        QTest::addColumn<int>("how");
        QTest::addColumn<StopCause>("cause");
        QTest::newRow("under another layout") << 0 << StopCause::Released;
        QTest::newRow("another key goes down") << 1 << StopCause::SecondButton;
        QTest::newRow("a release nobody can place") << 2 << StopCause::HoldUnproven;
        QTest::newRow("pressed though it is down") << 3 << StopCause::HoldUnproven;
        QTest::newRow("no number, another name") << 4 << StopCause::HoldUnproven;
    }
    void theLetterGIsAKeyFromPressToRelease() {
        QFETCH(int, how);
        QFETCH(StopCause, cause);
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QWidget& to = *table();
        const quint32 code = how == 4 ? 0 : scan::kG;
        keyDown(to, code, Qt::Key_G);
        QVERIFY(goTo()->isHolding());
        switch (how) {
            case 0:
            case 4:
                keyUp(to, code, 0x041f);  // the character produced by a Russian layout
                break;
            case 1:
                keyDown(to, scan::kShift, Qt::Key_Shift, {Qt::ShiftModifier});
                break;
            case 2:
                keyUp(to, scan::kLeft, Qt::Key_Left);
                break;
            default:
                keyDown(to, code, Qt::Key_G);
                break;
        }
        QCOMPARE(arm_.ends, std::vector<StopCause>{cause});
        // Key repeats do not count as presses.
        keyDown(to, code, Qt::Key_G, {{}, true});
        QCOMPARE(arm_.moves.size(), std::size_t(1));
    }

    void theLetterGStartsOnceDespitePairedAutoRepeat() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QWidget& to = *table();
        keyDown(to, scan::kG, Qt::Key_G, {{}, false, 1000});
        keyUp(to, scan::kG, Qt::Key_G, {{}, false, 1400});
        keyDown(to, scan::kG, Qt::Key_G, {{}, false, 1400});
        QCOMPARE(arm_.moves.size(), std::size_t(1));
        QCOMPARE(arm_.ends, std::vector<StopCause>{StopCause::Released});
        keyUp(to, scan::kG, Qt::Key_G, {{}, false, 1430});
    }

    void anotherSelectionStopsTheArm() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QTest::mousePress(goTo(), Qt::LeftButton);
        tab_->selectRow(2);
        QCOMPARE(arm_.ends, std::vector<StopCause>{StopCause::SelectionChanged});
        QTest::mouseRelease(goTo(), Qt::LeftButton);
        QCOMPARE(arm_.moves.size(), std::size_t(1));
    }

    void anEditStopsTheArm() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QTest::mousePress(goTo(), Qt::LeftButton);
        document_->undoStack().undo();
        QCOMPARE(arm_.ends.size(), std::size_t(1));
        QTest::mouseRelease(goTo(), Qt::LeftButton);
    }

    void losingControlStopsTheArmAndDisablesGoToWithAReason() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QTest::mousePress(goTo(), Qt::LeftButton);
        SessionState lost = liveState();
        lost.control = ControlState::None;
        lost.controlReason = "The robot is in Local mode. Switch it to Remote on the pendant.";
        feed(lost);
        QVERIFY(!goTo()->isEnabled());
        QCOMPARE(goTo()->toolTip(), lost.controlReason);
        QCOMPARE(arm_.ends.size(), std::size_t(1));
        QTest::mouseRelease(goTo(), Qt::LeftButton);
    }

    void hidingTheTabStopsTheArm() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        QTest::mousePress(goTo(), Qt::LeftButton);
        tab_->hide();
        QCOMPARE(arm_.ends.size(), std::size_t(1));
    }

    void refusedMoveGivesTheReason() {
        teachThree();
        feed(liveState(moved(0, 0.3)));
        tab_->selectRow(1);
        arm_.refusal = {ErrorCode::UnsafeState, "start a MoveJ", "protective stop"};
        const test::EventSpy messages(session_->journal());
        QTest::mouseClick(goTo(), Qt::LeftButton);
        QCOMPARE(messages.count(), 1);
        QVERIFY(notice()->isVisible());
    }

    void goToIsRefusedForAnUnreachableWaypoint() {
        teachThree();
        project::Waypoint far = document_->waypoints().at(1);
        far.priority = project::TargetKind::Pose;
        far.pose.position.x() = 4;
        document_->changeWaypoint(1, far, "x");
        tab_->selectRow(1);
        QVERIFY(!goTo()->isEnabled());
        QVERIFY(goTo()->toolTip().contains("reach"));
        QVERIFY(!tab_->ghost()->reachable);
    }

    void ghostAndMarksFollowTheSelection() {
        QSignalSpy ghosts(tab_.get(), &WaypointsTab::ghostChanged);
        QSignalSpy selections(tab_.get(), &WaypointsTab::selectionChanged);
        QVERIFY(!tab_->ghost().has_value());
        teachThree();
        ghosts.clear();
        selections.clear();
        tab_->selectRow(0);
        QVERIFY(ghosts.count() >= 1);
        QCOMPARE(selections.count(), 1);
        QCOMPARE(selections[0][0].toUuid(), document_->waypoints().at(0).id);
        QCOMPARE(tab_->ghost()->name, QString("waypoint 1"));
        QCOMPARE(tab_->ghost()->q, document_->waypoints().at(0).joints);
        QCOMPARE(tab_->marks().size(), std::size_t(3));
        QVERIFY(tab_->marks()[0].selected);
        QVERIFY((tab_->marks()[1].position - document_->waypoints().at(1).pose.position).norm() < 1e-9);
        tab_->selectRow(-1);
        QVERIFY(!tab_->ghost().has_value());
    }

    void detailsShowTheDistanceOfTheArm() {
        teachThree();
        tab_->selectRow(0);
        SessionState state = liveState();
        state.tcpPose.position.z() += 0.0612;
        feed(state);
        auto* details = tab_->findChild<WaypointDetails*>("waypoint.details");
        QTRY_VERIFY2_WITH_TIMEOUT(details->headline().contains("61.2 mm"), qPrintable(details->headline()),
                                  60'000);
        QVERIFY(details->headline().startsWith("waypoint 1"));
        QVERIFY(details->poseLine().contains("RX"));
        // Another TCP on the robot does not change the distance: the move uses the TCP of the waypoint.
        const Pose tool(0, 0, 0.15, 0, 0, 0);
        state.tcpPose = state.tcpPose * state.tcpOffset.inverse() * tool;
        state.tcpOffset = tool;
        state.tcpPose.position.z() += 0.01;
        feed(state);
        QTRY_VERIFY2_WITH_TIMEOUT(details->headline().contains("71.2 mm"), qPrintable(details->headline()),
                                  60'000);
    }

    void detailsShowTheStepsThatUseTheWaypoint() {
        teachThree();
        tab_->selectRow(0);
        auto* details = tab_->findChild<WaypointDetails*>("waypoint.details");
        QVERIFY2(!details->headline().contains("used in"), qPrintable(details->headline()));
        project::ProgramStep step;
        step.id = QUuid::createUuid();
        step.kind = "moveL";
        step.fields["waypoint"] = document_->waypoints().at(0).id.toString();
        project::Program program;
        program.id = QUuid::createUuid();
        program.name = "p";
        program.steps = {step};
        project::ProgramList programs;
        programs.append(program);
        document_->changePrograms(programs, "add");
        QVERIFY2(details->headline().contains("used in 1 step"), qPrintable(details->headline()));
        tab_->selectRow(1);
        QVERIFY2(!details->headline().contains("used in"), qPrintable(details->headline()));
    }

    void aPoseAloneCanBePasted() {
        feed(liveState());
        tab_->teach();
        const project::Waypoint taught = document_->waypoints().at(0);
        const Pose there = kinematics::forwardTcp(document_->robot().dh, taught.joints, taught.tcpOffset);
        const Eigen::Vector3d rpy = rpyFromRotationVector(there.rotation) * toDegrees(1);
        const auto paste = [this](const QString& text) {
            QApplication::clipboard()->setText(text);
            tab_->findChild<QAction*>("waypoint.action.paste")->trigger();
        };
        const QString figures = QStringLiteral("%1\t%2\t%3\t%4\t%5\t%6")
                                    .arg(there.position.x() * 1000)
                                    .arg(there.position.y() * 1000)
                                    .arg(there.position.z() * 1000 + 30)
                                    .arg(rpy.x())
                                    .arg(rpy.y())
                                    .arg(rpy.z());
        // Six numbers from a spreadsheet without a header line.
        paste(figures);
        QCOMPARE(document_->waypoints().size(), 2);
        project::Waypoint pasted = document_->waypoints().at(1);
        QVERIFY(pasted.priority == project::TargetKind::Pose);
        QVERIFY(document_->reach(1).ok());
        QVERIFY(!pasted.name.isEmpty());
        for (int i = 0; i < kJointCount; ++i) {
            QVERIFY(std::abs(pasted.joints[i] - taught.joints[i]) < 0.5);
        }
        // With a header line, some of the columns are sufficient.
        paste("Name\tX mm\tY mm\tZ mm\tRX °\tRY °\tRZ °\nover it\t" + figures);
        QCOMPARE(document_->waypoints().size(), 3);
        QCOMPARE(document_->waypoints().at(2).name, QStringLiteral("over it"));
        QVERIFY(document_->waypoints().at(2).move == project::MoveKind::Joint);
        // An incomplete pose is not pasted, and the reason is shown.
        paste("Name\tX mm\tY mm\nhalf\t1\t2");
        QCOMPARE(document_->waypoints().size(), 3);
    }

    void aPoseIsEnteredAndTheJointsFollow() {
        feed(liveState());
        tab_->teach();
        tab_->selectRow(0);
        const project::Waypoint before = document_->waypoints().at(0);
        QVERIFY(before.priority == project::TargetKind::Joints);
        auto* z = tab_->findChild<QDoubleSpinBox*>("waypoint.details.z");
        const double from = z->value();
        const auto type = [](QDoubleSpinBox* box, const QString& text) {
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Return);
        };
        type(z, QString::number(from + 50));
        const project::Waypoint after = document_->waypoints().at(0);
        QVERIFY(after.priority == project::TargetKind::Joints);
        const Pose there = kinematics::forwardTcp(document_->robot().dh, after.joints, after.tcpOffset);
        QVERIFY(std::abs(there.position.z() * 1000 - (from + 50)) < 0.01);
        // The nearest configuration is used: no joint has flipped.
        for (int i = 0; i < kJointCount; ++i) {
            QVERIFY(std::abs(after.joints[i] - before.joints[i]) < 0.5);
        }
        QCOMPARE(document_->undoStack().undoText(), QStringLiteral("Change the pose of “waypoint 1”"));

        // If the arm cannot reach the pose, nothing changes, and the box shows the pose of the waypoint.
        type(z, QStringLiteral("9000"));
        QCOMPARE(document_->waypoints().at(0), after);
        QVERIFY(std::abs(z->value() - (from + 50)) < 0.01);

        // If the pose defines the waypoint, the pose may be out of reach. It is kept and marked.
        tab_->findChild<QComboBox*>("waypoint.details.frame")->setFocus();
        QTest::keyClick(tab_->findChild<QComboBox*>("waypoint.details.frame"), Qt::Key_Down);
        QVERIFY(document_->waypoints().at(0).priority == project::TargetKind::Pose);
        type(z, QStringLiteral("9000"));
        QCOMPARE(document_->waypoints().at(0).pose.position.z(), 9.0);
        QVERIFY(!document_->reach(0).ok());
        document_->undoStack().undo();
        QVERIFY(document_->reach(0).ok());
    }

    void changingTheFrameInTheDetailsKeepsThePosition() {
        project::Project cell;
        project::Frame tray;
        tray.id = QUuid::createUuid();
        tray.name = "tray";
        tray.T_base_frame = Pose(0.3, -0.2, 0.1, 0, 0, 0.7);
        cell.frames.append(tray);
        document_->setProject(cell);
        feed(liveState());
        tab_->teach();
        auto* frame = tab_->findChild<QComboBox*>("waypoint.details.frame");
        QVERIFY(frame->isVisible());
        QCOMPARE(frame->currentText(), QStringLiteral("—"));
        frame->setFocus();
        QTest::keyClick(frame, Qt::Key_Down);
        QTest::keyClick(frame, Qt::Key_Down);
        QCOMPARE(frame->currentText(), QStringLiteral("tray"));
        const project::Waypoint& point = document_->waypoints().at(0);
        QCOMPARE(point.frame, tray.id);
        QVERIFY(point.priority == project::TargetKind::Pose);
        const Pose place = *project::poseInBase(point, document_->frames());
        QVERIFY(project::poseDifference(place, liveState().tcpPose).distance < 1e-9);
        document_->undoStack().undo();
        document_->undoStack().undo();
        QCOMPARE(frame->currentText(), QStringLiteral("—"));
    }

    void damagedProjectOffersTheReadablePart() {
        teachThree();
        QTemporaryDir directory;
        const QString path = directory.filePath("cell-7.tiller");
        ProjectStore store(*document_);
        ProjectFiles files(store, session_->journal());
        connect(&files, &ProjectFiles::noticeWanted, tab_.get(), &WaypointsTab::showNotice);
        files.saveAs(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray whole = file.readAll();
        QVERIFY(file.resize(whole.lastIndexOf("\"joints\"")));
        file.close();
        files.open(path);
        QVERIFY(notice()->isVisible());
        QVERIFY2(notice()->text().contains("line "), qPrintable(notice()->text()));
        QCOMPARE(document_->waypoints().size(), 3);
        click("notice.accept");
        QCOMPARE(document_->waypoints().size(), 2);
    }

    void everyControlHasANameForTestsAndScreenReaders() {
        for (QAbstractButton* control : tab_->findChildren<QAbstractButton*>()) {
            if (control->isVisible()) {
                QVERIFY2(!control->objectName().isEmpty(), qPrintable(control->text()));
                QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(control->objectName()));
            }
        }
        QVERIFY(!table()->accessibleName().isEmpty());
        for (QAction* action : tab_->commandActions()) {
            QVERIFY(!action->objectName().isEmpty());
            QVERIFY(!action->text().isEmpty());
        }
    }

private:
    void feed(const SessionState& state) { Q_EMIT session_->stateChanged(state); }
    void teachThree() {
        for (int n = 0; n < 3; ++n) {
            feed(liveState(moved(5, 0.1 * n)));
            tab_->teach();
        }
        feed(liveState());
    }
    QStringList names() {
        QStringList result;
        for (const project::Waypoint& point : document_->waypoints()) {
            result << point.name;
        }
        return result;
    }
    WaypointTable* table() { return tab_->findChild<WaypointTable*>("waypoint.table"); }
    NoticeBar* notice() { return tab_->findChild<NoticeBar*>("notice"); }
    HoldToRunButton* goTo() { return tab_->findChild<HoldToRunButton*>("waypoint.goTo"); }
    QPushButton* button(const char* name) { return tab_->findChild<QPushButton*>(name); }
    void click(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }

    FakeArm arm_;
    VirtualClock clock_;  // constant, so that a delayed event loop does not end a hold
    HoldPolicy policy_;
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<WaypointsTab> tab_;
};

QTEST_MAIN(TestWaypointsTab)
#include "tst_waypoints_tab.moc"
