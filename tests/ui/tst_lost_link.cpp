// SPDX-License-Identifier: GPL-3.0-or-later
//
// A robot stops sending data while the arm moves. The motion of the arm is then unknown, and no part of the
// window may display a motion.

#include <QElapsedTimer>
#include <QTest>

#include "resources/resources.h"
#include "robot/station/station.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/state_chip.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/plots/plot_overlay.h"
#include "widgets/plots/plot_view.h"

using namespace tiller;
using namespace tiller::test;

class TestLostLink : public QObject {
    Q_OBJECT

private:
    /// Advances time for robot and window. All data from the robot are processed.
    static void goOn(WindowBench& bench, int ms) {
        for (int t = 0; t < ms; t += 2) {
            bench.clock.advanceNs(2 * kNsPerMs);
            bench.cell.robot.step();
            if (t % 16 == 0) {
                bench.window.session().refresh();
                QTest::qWait(1);
            }
        }
        bench.window.session().refresh();
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }

    void outageIsReportedAsAnOutage() {
        WindowBench bench;
        bench.show();
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        const RobotSession& session = bench.window.session();
        driveKeys(bench.cell, bench.window.jogColumn().holdKeys());
        auto& key = bench.find<HoldToRunButton>("jog.X+");
        press(key);
        bench.cell.advanceMs(400);
        QVERIFY(!standsStill(bench.cell));
        const double lostAt = session.state().robotTime;

        bench.cell.robot.silence(true);
        goOn(bench, 3000);
        QCOMPARE(session.state().link, LinkState::Lost);
        for (const char* chip : {"robotModeChip", "safetyChip", "controlChip", "linkChip"}) {
            QCOMPARE(bench.find<StateChip>(chip).text(), QString("NO DATA"));
        }
        QCOMPARE(bench.find<StateChip>("lastStopChip").text(), QString("Not measured"));
        auto& line = bench.find<LimiterLine>("limiterLine");
        QVERIFY2(line.quietText().contains("not measured"), qPrintable(line.quietText()));
        auto& view = bench.find<PlotView>("plots.view");
        const auto shown = view.laneItem().segments();
        QVERIFY(!shown.empty());
        QVERIFY2(shown.back().kind == LaneKind::NoData, "the lane does not show the outage while it lasts");
        QVERIFY2(shown.back().end - shown.back().start > 2.5, "the lane does not show the whole outage");
        QVERIFY2(view.window().end() - lostAt > 2.5, "the time axis stopped during the outage");

        bench.cell.robot.silence(false);
        QElapsedTimer waited;
        waited.start();
        while (session.state().link != LinkState::Live && waited.elapsed() < 60'000) {
            goOn(bench, 2);
        }
        QCOMPARE(session.state().link, LinkState::Live);
        const double backAt = session.state().robotTime;
        QVERIFY(backAt - lostAt > 2.5);
        goOn(bench, 500);
        bool toldOfTheOutage = false;
        for (const LaneSegment& segment : bench.window.station().history().lane().segments()) {
            const bool meanwhile = segment.end > lostAt + 0.1 && segment.start < backAt - 0.1;
            if (meanwhile) {
                QVERIFY2(segment.kind == LaneKind::NoData, qPrintable(segment.label));
                toldOfTheOutage = segment.end - segment.start > 2.5;
            }
        }
        QVERIFY(toldOfTheOutage);
        QCOMPARE(bench.find<StateChip>("lastStopChip").text(), QString("Not measured"));
    }
};

QTEST_MAIN(TestLostLink)
#include "tst_lost_link.moc"
