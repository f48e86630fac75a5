// SPDX-License-Identifier: GPL-3.0-or-later
//
// Undo and redo from a tab that does not show the change. The commands show the name of the edit and its tab,
// and compare TCP and payload with the robot. Uses the real window, with a simulated robot in virtual time.

#include <QAction>
#include <QPushButton>
#include <QTabBar>
#include <QTest>

#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "tests/unit/robot/station/program/program_samples.h"
#include "widgets/common/notice_bar.h"
#include "widgets/project/undoable_document.h"
#include "widgets/tools/payload_page.h"
#include "widgets/tools/positions_page.h"
#include "widgets/tools/tcp_page.h"
#include "widgets/tools/tools_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestUndoAcrossTabs : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;
    QStringList said_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    UndoableDocument& document() { return window().document(); }
    ToolsTab& tools() { return bench_->find<ToolsTab>("tools"); }

    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    QString tab() {
        auto& tabs = bench_->find<QTabBar>("tabs");
        return tabs.tabData(tabs.currentIndex()).toString();
    }
    void trigger(const char* action) { window().findChild<QAction*>(QLatin1String(action))->trigger(); }
    static project::Tool gripper(double length) {
        project::Tool tool;
        tool.id = QUuid("{8a7a2f8e-9b1f-4c5e-8a39-1f7a0a4f2d11}");
        tool.name = QStringLiteral("gripper");
        tool.tcpOffset = Pose(0, 0, length, 0, 0, 0);
        return tool;
    }
    void changeTcp(double length, const QString& text) {
        project::Tooling after = document().tooling();
        after.tools = {gripper(length)};
        after.activeTool = gripper(length).id;
        document().changeTooling(after, text);
    }
    void changePayload(double mass, const QString& text) {
        project::Tooling after = document().tooling();
        project::Payload payload;
        payload.id = QUuid("{3c1c1d06-7a0e-4b3e-9f57-0f3a4a1e7b22}");
        payload.name = QStringLiteral("part");
        payload.mass = mass;
        after.payloads = {payload};
        after.activePayload = payload.id;
        document().changeTooling(after, text);
    }
    /// Waits until the pages have the state of the robot. They update ten times per second, in real time.
    void pageSeesTheRobot() {
        QTest::qWait(150);
        cell().advanceMs(40);
        QTest::qWait(150);
    }
    bool wasSaid(const QString& text) const { return said_.join('\n').contains(text); }

private Q_SLOTS:
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        said_.clear();
        test::onMessage(window().session().journal(), this,
                        [this](Severity, const QString& text) { said_ << text; });
        QVERIFY(until([this] { return window().session().state().modelKnown; }));
    }
    void cleanup() { bench_.reset(); }

    void anUndoneTcpIsShownAndComparedWithTheRobot() {
        changeTcp(0.15, "Change the TCP “gripper”");
        window().session().tooling().setTcp(Pose(0, 0, 0.2, 0, 0, 0), "gripper");
        QVERIFY(until([this] { return window().session().state().tcpOffset.position.z() > 0.199; }));
        changeTcp(0.2, "Change the TCP “gripper” again");
        QVERIFY(until([this] { return !window().session().state().moving; }));
        pageSeesTheRobot();
        window().showTab("waypoints");
        tools().showPage(ToolsTab::Payloads);
        said_.clear();

        trigger("waypoint.action.undo");
        QCOMPARE(document().tooling().tools.at(0).tcpOffset.position.z(), 0.15);
        QCOMPARE(tab(), QString("tools"));
        QVERIFY(tools().tcps().isVisible());
        QVERIFY2(wasSaid("Undone: Change the TCP “gripper” again"), qPrintable(said_.join('\n')));
        QVERIFY2(wasSaid("The robot's TCP differs from “gripper”"), qPrintable(said_.join('\n')));
        auto* notice = tools().tcps().findChild<NoticeBar*>();
        QVERIFY(notice != nullptr && notice->isVisible());
        QVERIFY2(notice->title().contains("TCP differs"), qPrintable(notice->title()));

        // After redo, there is no question, because the value equals that of the robot.
        window().showTab("io");
        said_.clear();
        trigger("waypoint.action.redo");
        QCOMPARE(tab(), QString("tools"));
        QVERIFY(wasSaid("Redone: Change the TCP “gripper” again"));
        QVERIFY2(!wasSaid("TCP differs"), qPrintable(said_.join('\n')));
    }

    void anUndonePayloadIsShownAndComparedWithTheRobot() {
        changePayload(1.0, "Change the payload “part”");
        RobotTooling::Load load;
        load.mass = 2.0;
        window().session().tooling().setPayload(load, "part");
        QVERIFY(until([this] { return window().session().state().payloadMass > 1.99; }));
        changePayload(2.0, "Change the payload “part” again");
        pageSeesTheRobot();
        window().showTab("frames");
        said_.clear();
        trigger("waypoint.action.undo");
        QCOMPARE(tab(), QString("tools"));
        QVERIFY(tools().payloads().isVisible());
        QVERIFY(wasSaid("Undone: Change the payload “part” again"));
        QVERIFY2(wasSaid("The robot's payload differs from “part”"), qPrintable(said_.join('\n')));
    }

    void everyPartShowsItsTab_data() {
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("shown");
        QTest::newRow("waypoints") << "waypoints"
                                   << "waypoints";
        QTest::newRow("frames") << "frames"
                                << "frames";
        QTest::newRow("positions") << "positions"
                                   << "tools";
    }
    void everyPartShowsItsTab() {
        QFETCH(QString, part);
        QFETCH(QString, shown);
        if (part == "waypoints") {
            project::Waypoint point;
            point.id = QUuid::createUuid();
            point.name = QStringLiteral("point");
            document().insertWaypoints(0, {point}, "Add something");
        } else if (part == "frames") {
            document().insertFrame(0, {QUuid::createUuid(), "frame", Pose(), {}}, "Add something");
        } else {
            project::Positions after = document().positions();
            after.list.append({QUuid::createUuid(), "Home", JointPositions(), {}, {}});
            document().changePositions(after, "Add something");
        }
        for (const char* action : {"waypoint.action.undo", "waypoint.action.redo"}) {
            window().showTab("log");
            said_.clear();
            trigger(action);
            QCOMPARE(tab(), shown);
            QVERIFY2(wasSaid("Add something"), qPrintable(said_.join('\n')));
        }
        if (part == "positions") {
            QVERIFY(tools().positions().isVisible());
        }
    }

    void ctrlZWorksInTools() {
        changeTcp(0.15, "Change the TCP “gripper”");
        window().showTab("tools");
        tools().setFocus();
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().tooling().tools.size(), std::size_t(0));
        QVERIFY(wasSaid("Undone: Change the TCP “gripper”"));
    }

    // After jogging, or after a click on the title of a tab, the focus is not on a list.
    void ctrlZWorksWithTheFocusAnywhere_data() {
        QTest::addColumn<QString>("focus");
        for (const char* focus : {"jog.armKeyboard", "tabs", "plots", ""}) {
            QTest::addRow("%s", *focus == 0 ? "none" : focus) << focus;
        }
    }
    void ctrlZWorksWithTheFocusAnywhere() {
        QFETCH(const QString, focus);
        changeTcp(0.15, "Change the TCP “gripper”");
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        if (focus.isEmpty()) {
            if (QApplication::focusWidget() != nullptr) {
                QApplication::focusWidget()->clearFocus();
            }
        } else {
            bench_->find<QWidget>(focus.toLatin1().constData()).setFocus();
        }
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().tooling().tools.size(), std::size_t(0));
    }

    // When a page opens or closes, the focus must stay in its panel. If it moved to "Arm keyboard", pressing
    // Return would arm the keyboard.
    void theFocusDoesNotFallOnTheJogColumn() {
        window().showTab("frames");
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        auto& key = bench_->find<QWidget>("frame.threePoints");
        QTRY_VERIFY_WITH_TIMEOUT(key.isEnabled(), 60'000);
        const auto isInTabs = [this] {
            const QWidget* focus = QApplication::focusWidget();
            return focus != nullptr && focus->isVisible() &&
                   bench_->find<QWidget>("tabsDock").isAncestorOf(focus);
        };
        key.setFocus();
        trigger("frame.action.threePoints");
        QTRY_VERIFY_WITH_TIMEOUT(!key.isVisible() && isInTabs(), 60'000);
        trigger("frame.action.cancel");
        QTRY_VERIFY_WITH_TIMEOUT(key.isVisible() && isInTabs(), 60'000);
        // A disabled button also loses the focus.
        key.setFocus();
        key.setEnabled(false);
        QTRY_VERIFY_WITH_TIMEOUT(isInTabs(), 60'000);
        // Tab still reaches the jog column.
        auto& arm = bench_->find<QWidget>("jog.armKeyboard");
        arm.setFocus(Qt::TabFocusReason);
        QCoreApplication::processEvents();
        QVERIFY(arm.hasFocus());
    }

    // Return on a button that was used before would start a program, and Return on “Arm keyboard” would arm
    // it.
    void aClickOnATabFocusesNoButton_data() {
        QTest::addColumn<bool>("hasPrograms");
        QTest::newRow("empty project") << false;
        QTest::newRow("sample project") << true;
    }
    void aClickOnATabFocusesNoButton() {
        QFETCH(bool, hasPrograms);
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        if (hasPrograms) {
            document().setProject(program::sampleProject());
            project::ProgramList programs;
            programs.append(program::trayProgram(document().project()));
            document().changePrograms(programs, "open");
        }
        auto& tabs = bench_->find<QTabBar>("tabs");
        auto& panel = bench_->find<QWidget>("tabsDock");
        for (int from = 0; from < tabs.count(); ++from) {
            for (int to = 0; to < tabs.count(); ++to) {
                QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(from).center());
                const QList<QPushButton*> buttons = panel.findChildren<QPushButton*>();
                for (QPushButton* button : buttons) {
                    if (button->isVisible() && button->isEnabled()) {
                        button->setFocus();
                    }
                }
                QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(to).center());
                QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(from).center());
                QCoreApplication::processEvents();
                const QWidget* focus = QApplication::focusWidget();
                const QString names = QStringLiteral("%1, %2: %3")
                                          .arg(tabs.tabText(from), tabs.tabText(to),
                                               focus != nullptr ? focus->objectName() : "none");
                QVERIFY2(focus == nullptr || panel.isAncestorOf(focus), qPrintable(names));
                QVERIFY2(from == to || qobject_cast<const QAbstractButton*>(focus) == nullptr,
                         qPrintable(names));
            }
        }
    }
};

QTEST_MAIN(TestUndoAcrossTabs)
#include "tst_undo_across_tabs.moc"
