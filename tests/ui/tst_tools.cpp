// SPDX-License-Identifier: GPL-3.0-or-later
//
// TCP and payload in the real window with the simulated controller: setting, reading, prompts about
// differences, and measuring a payload in poses that the arm moves to while a button is held. Also tests
// Home.

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QTest>

#include "app/action_table.h"
#include "resources/resources.h"
#include "tests/support/go_on_until.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/notice_bar.h"
#include "widgets/project/undoable_document.h"
#include "widgets/tools/payload_page.h"
#include "widgets/tools/tcp_page.h"
#include "widgets/tools/tools_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestTools : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    const project::Tooling& tooling() { return window().document().tooling(); }
    template <class Widget>
    Widget& find(const char* name) {
        return bench_->find<Widget>(name);
    }
    void click(const char* name) {
        QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton);
        cell().advanceMs(40);
    }
    /// Also waits in real time, because a worker thread sends the settings to the robot.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    NoticeBar& notice(const char* page) { return *find<QWidget>(page).findChild<NoticeBar*>("notice"); }
    void keepPictures(const QString& name) {
        if (qEnvironmentVariableIsEmpty("TILLER_SCREENSHOTS")) {
            return;
        }
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
            window().resize(size);
            for (const char* theme : {"dark", "light"}) {
                window().setTheme(QLatin1String(theme));
                QTest::qWait(150);
                test::keepPicture(
                    window(),
                    QStringLiteral("%1-%2-%3").arg(name).arg(size.width()).arg(QLatin1String(theme)));
            }
        }
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        QVector<HoldToRunButton*> keys = window().jogColumn().holdKeys();
        keys << window().findChild<HoldToRunButton*>("payload.estimator.next");
        driveKeys(cell(), keys);
        cell().advanceMs(40);
        window().showTab("tools");
    }
    void cleanup() { bench_.reset(); }

    void tcpIsSetReadBackAndConfirmed() {
        project::Tooling two;
        two.tools = {{QUuid::createUuid(), "gripper", Pose(0, 0, 0.15, 0, 0, 0), 0.04, {}, {}},
                     {QUuid::createUuid(), "nozzle", Pose(0.01, 0, 0.2, 0, 0, 0), 0, {}, {}}};
        window().document().changeTooling(two, "x");
        window().tools().tcps().selectRow(0);
        window().tools().tcps().setState(window().session().state());
        click("tcp.use");
        QVERIFY(until([&] { return window().session().state().tcpOffset == Pose(0, 0, 0.15, 0, 0, 0); }));
        QCOMPARE(tooling().activeTool, two.tools.at(0).id);
        window().tools().tcps().setState(window().session().state());
        QVERIFY(find<QLabel>("tcp.facts").text().contains("active on the robot"));
        QVERIFY(!notice("tcp.page").isVisible());
        keepPictures("tools-tcp");

        // Another client sets a different TCP. The user is asked, and nothing is changed automatically.
        window().session().tooling().setTcp(Pose(0, 0, 0.1, 0, 0, 0), "other");
        QVERIFY(until([&] { return window().session().state().tcpOffset == Pose(0, 0, 0.1, 0, 0, 0); }));
        window().tools().tcps().setState(window().session().state());
        QVERIFY(notice("tcp.page").isVisible());
        keepPictures("tools-asks");
        cell().advanceMs(200);
        QCOMPARE(window().session().state().tcpOffset, Pose(0, 0, 0.1, 0, 0, 0));
        QTest::mouseClick(notice("tcp.page").findChild<QAbstractButton*>("notice.accept"), Qt::LeftButton);
        QVERIFY(until([&] { return window().session().state().tcpOffset == Pose(0, 0, 0.15, 0, 0, 0); }));
    }

    void payloadIsMeasuredWithin50GramsAnd5Millimetres() {
        // A load of 2.0 kg that is not configured in the controller. The sensor has noise and an offset.
        QVERIFY(cell().robot.inject("load 2.0 0.02 -0.03 0.09").ok());
        window().tools().showPage(ToolsTab::Payloads);
        cell().advanceMs(400);
        click("payload.weigh");
        auto& next = find<HoldToRunButton>("payload.estimator.next");
        for (int n = 0; n < 4; ++n) {
            if (n > 0) {
                const JointPositions from = window().session().state().q;
                press(next);
                QVERIFY2(next.isHolding(), "the hold ended before the arm reached the next pose");
                QVERIFY(cell().advanceUntil([&] { return !next.isHolding(); }, 60'000));
                release(next);
                QVERIFY(cell().advanceUntil([&] { return standsStill(cell()); }, 3000));
                QVERIFY((window().session().state().q.values - from.values).cwiseAbs().maxCoeff() > 0.3);
                cell().advanceMs(500);
            }
            click("payload.estimator.take");
            QVERIFY(cell().advanceUntil(
                [&] { return find<QAbstractButton>("payload.estimator.take").isEnabled(); }, 5000));
            if (n == 2) {
                keepPictures("tools-weighing");
            }
        }
        const QString feedback = find<QLabel>("payload.estimator.feedback").text();
        QVERIFY2(find<QAbstractButton>("payload.estimator.keep").isEnabled(), qPrintable(feedback));
        click("payload.estimator.keep");
        const project::Payload found = tooling().payloads.at(0);
        qInfo("measured %.4f kg at %.4f %.4f %.4f m", found.mass, found.centre.x(), found.centre.y(),
              found.centre.z());
        QVERIFY(std::abs(found.mass - 2.0) < 0.05);
        QVERIFY((found.centre - Eigen::Vector3d(0.02, -0.03, 0.09)).norm() < 0.005);

        // The check fails before the payload is set, and passes afterwards.
        click("payload.check");
        QVERIFY(cell().advanceUntil([&] { return notice("payload.page").isVisible(); }, 5000));
        QVERIFY2(notice("payload.page").title().contains("wrong"),
                 qPrintable(notice("payload.page").title()));
        click("payload.use");
        QVERIFY(until([&] { return std::abs(window().session().state().payloadMass - found.mass) < 1e-6; }));
        cell().advanceMs(400);
        notice("payload.page").dismiss();
        click("payload.check");
        QVERIFY(cell().advanceUntil([&] { return notice("payload.page").isVisible(); }, 5000));
        QVERIFY2(notice("payload.page").title().contains("is correct"),
                 qPrintable(notice("payload.page").title()));
        keepPictures("tools-payload");
    }

    void homeMovesToTheStoredPosition() {
        window().tools().showPage(ToolsTab::Positions);
        // The page reads the robot's state ten times per second, in real time.
        QTRY_VERIFY_WITH_TIMEOUT(
            (click("position.setHome"), window().document().positions().homePosition() != nullptr), 60'000);
        const JointPositions home = window().document().positions().homePosition()->joints;
        keepPictures("tools-positions");
        auto& away = find<HoldToRunButton>("jog.Z+");
        press(away);
        cell().advanceMs(600);
        release(away);
        QVERIFY(cell().advanceUntil([&] { return standsStill(cell()); }, 3000));
        QVERIFY((window().session().state().q.values - home.values).cwiseAbs().maxCoeff() > 0.005);
        cell().advanceMs(100);
        auto& key = find<HoldToRunButton>("homeKey");
        press(key);
        QVERIFY(cell().advanceUntil(
            [&] { return (cell().truth().q.values - home.values).cwiseAbs().maxCoeff() < 1e-3; }, 30'000));
        release(key);
        // After undo, the Home button has its previous target again.
        window().document().undoStack().undo();
        QVERIFY(window().document().positions().homePosition() == nullptr);
    }
};

QTEST_MAIN(TestTools)
#include "tst_tools.moc"
