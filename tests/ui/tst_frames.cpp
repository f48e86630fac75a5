// SPDX-License-Identifier: GPL-3.0-or-later
//
// A frame taught from three points of the simulated arm in the real window: taught while jogging, used for
// jogging, undone, saved and loaded. A jog ends when its frame changes.

#include <QAbstractButton>
#include <QAction>
#include <QTabBar>
#include <QTest>

#include "app/action_table.h"
#include "resources/resources.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/frames/frame_model.h"
#include "widgets/frames/frames_tab.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/project/project_files.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestFrames : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    app::MainWindow& window() { return bench_->window; }
    const project::FrameList& frames() { return window().document().frames(); }
    QAction& command(const char* id) { return *window().actions().find(QLatin1String(id)); }
    template <class Widget>
    Widget& find(const char* name) {
        return bench_->find<Widget>(name);
    }

    /// Holds a jog button until the TCP has moved by this distance, and waits until the arm has stopped.
    void jog(const char* key, double mm) {
        const Pose from = cell().truth().tcpPose;
        press(find<HoldToRunButton>(key));
        QVERIFY(cell().advanceUntil([&] { return distanceMm(from, cell().truth().tcpPose) > mm; }, 10'000));
        release(find<HoldToRunButton>(key));
        QVERIFY(cell().advanceUntil([&] { return standsStill(cell()); }, 2000));
        cell().advanceMs(60);
    }
    void take() {
        QTest::keyClick(&window(), Qt::Key_P);
        cell().advanceMs(20);
    }
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
    /// Teaches a frame with X along +Y of the base and Y along -X of the base.
    void teachThreePoints() {
        command("frame.action.threePoints").trigger();
        take();
        jog("jog.Y+", 60);
        take();
        jog("jog.X-", 40);
        take();
        keepPictures("frames-teaching");
        QTest::mouseClick(&find<QAbstractButton>("frame.teacher.make"), Qt::LeftButton);
        QCOMPARE(frames().size(), std::size_t(1));
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), window().jogColumn().holdKeys());
        window().jogColumn().selectors().setSpeedClass(3);
        cell().advanceMs(40);
    }
    void cleanup() { bench_.reset(); }

    void aThreePointFrameIsTaughtUsedUndoneAndSaved() {
        window().showTab("frames");
        keepPictures("frames-empty");
        const Pose origin = cell().truth().tcpPose;
        teachThreePoints();
        auto& tabs = find<QTabBar>("tabs");
        QCOMPARE(tabs.tabData(tabs.currentIndex()).toString(), QStringLiteral("frames"));
        const Eigen::Matrix3d axes = rotationMatrix(frames().at(0).T_base_frame.rotation);
        QVERIFY(distanceMm(frames().at(0).T_base_frame, origin) < 0.1);
        QVERIFY2(axes.col(0).dot(Eigen::Vector3d::UnitY()) > 0.999,
                 "X of the frame does not point in the direction of the jog");
        QVERIFY(axes.col(1).dot(-Eigen::Vector3d::UnitX()) > 0.999);
        QCOMPARE(window().findChild<SceneView*>()->frames().size(), std::size_t(1));

        // Select the frame in the jog column by mouse.
        auto& key = find<QAbstractButton>("jogFrame.3");
        QVERIFY(key.isEnabled());
        QTest::mouseClick(&key, Qt::LeftButton);
        QCOMPARE(window().jogColumn().selection().frame, FrameChoice::Taught);
        cell().advanceMs(60);
        keepPictures("frames-list");
        const Pose before = cell().truth().tcpPose;
        jog("jog.X+", 50);
        const Eigen::Vector3d way = cell().truth().tcpPose.position - before.position;
        QVERIFY2(way.normalized().dot(axes.col(0)) > 0.9999, "X+ does not move along X of the frame");
        QVERIFY(way.norm() > 0.049);
        command("frame.action.touchUp").trigger();
        keepPictures("frames-question");

        // A waypoint in this frame moves with it.
        window().waypoints().teach();
        WaypointModel& model = window().waypoints().model();
        QVERIFY(model.setData(model.index(0, WaypointModel::Frame), frames().at(0).name, Qt::EditRole));
        const QString path = bench_->folder.filePath("cell.tiller");
        window().files().saveAs(path);

        command("waypoint.action.undo").trigger();
        command("waypoint.action.undo").trigger();
        command("waypoint.action.undo").trigger();
        QVERIFY(frames().isEmpty());
        QVERIFY2(window().jogColumn().selection().frame == FrameChoice::Base,
                 "a deleted frame is still selected");
        QVERIFY(!key.isEnabled());
        command("waypoint.action.redo").trigger();
        QCOMPARE(frames().size(), std::size_t(1));
        command("waypoint.action.redo").trigger();
        command("waypoint.action.redo").trigger();
        const project::Frame kept = frames().at(0);
        QVERIFY(window().files().store().saveNow());

        VirtualClock clock;
        app::MainWindow again(app::Settings(bench_->folder.filePath("again.ini")), clock);
        again.openProject(path);
        QCOMPARE(again.document().frames().size(), std::size_t(1));
        QVERIFY(again.document().frames().at(0) == kept);
        QCOMPARE(again.document().waypoints().at(0).frame, kept.id);
        QCOMPARE(again.frames().model().rowCount(), 1);
        QVERIFY(again.findChild<QAbstractButton*>("jogFrame.3")->isEnabled());
    }

    void changingTheFrameStopsTheJogInIt() {
        teachThreePoints();
        command("frame.action.jogIn").trigger();
        QCOMPARE(window().jogColumn().selection().taught->id, frames().at(0).id);
        press(find<HoldToRunButton>("jog.X+"));
        cell().advanceMs(400);
        QVERIFY(tcpSpeed(cell()) > 0.095);
        project::Frame turned = frames().at(0);
        turned.T_base_frame.rotation.z() += 0.3;
        window().document().changeFrame(0, turned, "x");
        QVERIFY(cell().advanceUntil([&] { return standsStill(cell()); }, 300));
        cell().advanceMs(100);
        QCOMPARE(window().session().state().lastStop.cause, control::StopCause::SelectionChanged);
        // The jog does not resume automatically. A new press moves along the new axis.
        const Pose at = cell().truth().tcpPose;
        cell().advanceMs(300);
        QVERIFY(distanceMm(at, cell().truth().tcpPose) < 0.05);
        release(find<HoldToRunButton>("jog.X+"));
        jog("jog.X+", 30);
        const Eigen::Vector3d way = (cell().truth().tcpPose.position - at.position).normalized();
        QVERIFY(way.dot(rotationMatrix(turned.T_base_frame.rotation).col(0)) > 0.9999);
    }

    void tabCannotMoveTheArm() {
        teachThreePoints();
        const Pose at = cell().truth().tcpPose;
        for (QAction* action : window().frames().commandActions()) {
            action->trigger();
            cell().advanceMs(20);
        }
        QVERIFY(distanceMm(at, cell().truth().tcpPose) < 0.01);
        QVERIFY(standsStill(cell()));
    }

    void undoWorksFromTheFramesTab() {
        command("frame.action.fromTcp").trigger();
        QCOMPARE(frames().size(), std::size_t(1));
        find<QWidget>("frame.table").setFocus();
        QTest::keyClick(&find<QWidget>("frame.table"), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(frames().isEmpty());
        command("frame.action.fromTcp").trigger();
        QTest::keyClick(&find<QWidget>("frame.table"), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(frames().size(), std::size_t(2));
        QCOMPARE(window().waypointCount(), 0);
    }
};

QTEST_MAIN(TestFrames)
#include "tst_frames.moc"
