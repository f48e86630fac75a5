// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 3D view in the real window: relevant objects are visible, the standard directions are commands with
// shortcuts, and the jog frame "View" follows the view.

#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "resources/resources.h"
#include "robot/collision/arm_body.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/pictures.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/theme.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

class TestScene : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;

    app::MainWindow& window() { return bench_->window; }
    SceneView& view() { return *window().findChild<SceneView*>(); }
    bool isInThePicture(const JointPositions& q) {
        const RobotModel& model = robotModel(window().session().state().model);
        for (const auto& part : collision::placedCapsules(collision::armCapsules(model), model.dh, q)) {
            for (const Eigen::Vector3d& end : {part.shape.from, part.shape.to}) {
                const auto at = view().camera().project(end);
                const double radius = part.shape.radius * at.pixelsPerMetre;
                const QRectF ball(at.point.x() - radius, at.point.y() - radius, 2 * radius, 2 * radius);
                if (!QRectF(view().rect()).contains(ball)) {
                    return false;
                }
            }
        }
        return true;
    }
    void pointTo(HoldToRunButton& key, bool there) {
        const QPointF centre = QRectF(key.rect()).center();
        if (there) {
            QEnterEvent event(centre, centre, key.mapToGlobal(centre));
            QApplication::sendEvent(&key, &event);
        } else {
            QEvent event(QEvent::Leave);
            QApplication::sendEvent(&key, &event);
        }
    }

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show(QSize(1280, 720));
        QVERIFY2(bench_->cell.bringUp(), qPrintable(bench_->cell.what()));
        bench_->cell.advanceMs(100);
    }
    void cleanup() { bench_.reset(); }

    // Each arm deviates from its model by some tenths of a millimetre. It reports the deviation as calibrated
    // link frames, which are far from the links.
    void armIsDrawnAndCalculatedWithItsCalibration() {
        simulator::SimulatorOptions robot = VirtualCell::options();
        robot.calibration = 2;
        bench_.reset();
        bench_ = std::make_unique<WindowBench>(robot);
        bench_->show(QSize(1280, 720));
        QVERIFY2(bench_->cell.bringUp(), qPrintable(bench_->cell.what()));
        bench_->cell.advanceMs(100);
        const SessionState& state = window().session().state();
        const DhParameters& nominal = robotModel(state.model).dh;
        QVERIFY(state.dh != nominal);
        QVERIFY(window().document().robot().dh == state.dh);
        const auto off = [&](const DhParameters& dh) {
            return distanceMm(kinematics::forwardTcp(dh, state.q, state.tcpOffset), state.tcpPose);
        };
        QVERIFY2(off(nominal) > 0.5, qPrintable(QString::number(off(nominal))));
        QVERIFY2(off(state.dh) < 1e-6, qPrintable(QString::number(off(state.dh))));
        // The image must show an arm instead of scattered links.
        QVERIFY(isInThePicture(state.q));
        keepPicture(view(), QStringLiteral("scene-calibrated"));
    }

    // Regression test: an upright arm was cut off at the top.
    void theGhostOfHomeIsVisible() {
        view().grab();
        const double alone = view().camera().distance();
        auto& home = bench_->find<HoldToRunButton>("homeKey");
        pointTo(home, true);
        QTRY_VERIFY_WITH_TIMEOUT(view().ghost().has_value(), 60'000);
        view().grab();
        keepPicture(window(), QStringLiteral("scene-ghost"));
        QVERIFY(isInThePicture(view().ghost()->q));
        QVERIFY(isInThePicture(window().session().state().q));
        pointTo(home, false);
        QTRY_VERIFY_WITH_TIMEOUT(!view().ghost().has_value(), 60'000);
        view().grab();
        QVERIFY(std::abs(view().camera().distance() - alone) < 1e-6);
    }

    void theStandardViewsHaveButtonsAndCommands() {
        const struct {
            Qt::Key key;
            const char* button;
            const char* command;
            int right;
            int up;
        } sides[] = {{Qt::Key_F6, "scene.front", "view.look.front", 0, 2},
                     {Qt::Key_F7, "scene.side", "view.look.side", 1, 2},
                     {Qt::Key_F8, "scene.top", "view.look.top", 0, 1}};
        const auto looksSo = [&](int right, int up) {
            const Eigen::Matrix3d R = view().viewRotation();
            return (R.col(0) - Eigen::Vector3d::Unit(right)).norm() < 1e-9 &&
                   (R.col(1) - Eigen::Vector3d::Unit(up)).norm() < 1e-9;
        };
        for (const auto& side : sides) {
            QTest::keyClick(&window(), side.key);
            QVERIFY2(looksSo(side.right, side.up), side.command);
            view().grab();
            QVERIFY2(isInThePicture(window().session().state().q), side.command);
            keepPicture(view(), QLatin1String(side.button));
            QTest::keyClick(&window(), Qt::Key_F5);
            QVERIFY(!looksSo(side.right, side.up));
            QTest::mouseClick(&bench_->find<QToolButton>(side.button), Qt::LeftButton);
            QVERIFY2(looksSo(side.right, side.up), side.button);
            window().actions().find("view.look.home")->trigger();
            window().actions().find(QLatin1String(side.command))->trigger();
            QVERIFY2(looksSo(side.right, side.up), side.command);
            QTest::keyClick(&window(), Qt::Key_F5);
        }
    }

    void thePaletteFindsTheStandardViews() {
        bench_->cell.advanceMs(1500);  // for a second after a motion, Space only stops
        QTest::keyClick(&window(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(window().findChild<app::CommandPalette*>() != nullptr, 60'000);
        auto* words = window().findChild<app::CommandPalette*>()->findChild<QLineEdit*>("paletteWords");
        QTest::keyClicks(words, "look from above");
        const auto& listed = window().findChild<app::CommandPalette*>()->listed();
        QVERIFY2(
            !listed.isEmpty() && listed.first()->objectName() == "view.look.top",
            qPrintable(words->text() + ": " + (listed.isEmpty() ? QString() : listed.first()->objectName())));
        QTest::keyClick(words, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT((view().viewRotation().col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-9,
                                 60'000);
    }

    void fitRestoresAPannedView() {
        view().grab();
        const QPoint from(view().width() / 2, view().height() / 2);
        QTest::mousePress(&view(), Qt::RightButton, {}, from);
        QTest::mouseMove(&view(), from + QPoint(400, 0));
        QTest::mouseRelease(&view(), Qt::RightButton, {}, from + QPoint(400, 0));
        QVERIFY(!isInThePicture(window().session().state().q));
        bench_->cell.advanceMs(100);
        view().grab();
        QVERIFY2(!isInThePicture(window().session().state().q), "the view changed by itself");
        QTest::keyClick(&window(), Qt::Key_F9);
        QVERIFY(isInThePicture(window().session().state().q));
    }

    // An obstacle on the path is reported next to the button and marked on the path. Both disappear with the
    // obstacle.
    void obstacleIsReportedNextToTheKey() {
        const JointPositions here = window().session().state().q;
        window().waypoints().teach();
        project::Waypoint far = window().document().waypoints().at(0);
        far.id = QUuid::createUuid();
        far.name = "far";
        far.joints = here;
        far.joints[0] += 1.2;
        window().document().insertWaypoints(1, {far}, "far");
        window().waypoints().selectWaypoint(far.id);
        QTRY_VERIFY_WITH_TIMEOUT(view().moveReport().has_value(), 60'000);
        QVERIFY2(view().moveLimitText().isEmpty(), qPrintable(view().moveLimitText()));

        JointPositions half = here;
        half[0] += 0.6;
        const Pose between = kinematics::forwardTcp(robotModel(window().session().state().model).dh, half);
        project::CellBox box;
        box.id = QUuid::createUuid();
        box.name = "crate";
        box.pose = Pose(between.position.x(), between.position.y(), between.position.z(), 0, 0, 0);
        project::CellGeometry cell;
        cell.floor = 0;
        cell.boxes.insert(0, box);
        window().document().changeCell(cell, "crate");
        QVERIFY2(view().moveLimitText().contains("crate"), qPrintable(view().moveLimitText()));
        QVERIFY(view().moveReport()->limit->share > 0.1 && view().moveReport()->limit->share < 0.6);
        QVERIFY(view().ghostText().contains("crate"));
        bool said = false;
        for (const QLabel* label : window().findChildren<QLabel*>()) {
            said = said || (label->isVisible() && label->text().contains("crate"));
        }
        QVERIFY(said);
        bench_->cell.advanceMs(100);
        view().grab();
        keepPicture(window(), QStringLiteral("scene-crate"));
        window().document().undoStack().undo();
        QVERIFY(view().moveLimitText().isEmpty());
    }

    // The path of "Back" is drawn as a line from the arm to the start of the path, and disappears after
    // "Back".
    void theRetracePathIsDrawn() {
        driveKeys(bench_->cell, window().jogColumn().holdKeys(), &window().jogColumn().axisJog());
        QVERIFY(view().paths().empty());
        const Eigen::Vector3d from = bench_->cell.truth().tcpPose.position;
        // Move along X, so that the line is not on any axis of the TCP.
        auto& key = bench_->find<HoldToRunButton>("jog.X+");
        press(key);
        bench_->cell.advanceMs(1500);
        release(key);
        QVERIFY(timeToStandstill(bench_->cell) >= 0);
        const Eigen::Vector3d here = bench_->cell.truth().tcpPose.position;
        QVERIFY((here - from).norm() > 0.03);
        bench_->cell.advanceMs(500);
        QCOMPARE(view().paths().size(), std::size_t(1));
        const PathMark way = view().paths().front();
        QVERIFY(way.kind == PathMark::Kind::Breadcrumb);
        QVERIFY((way.places.front() - from).norm() < 0.002);
        QVERIFY((way.places.back() - here).norm() < 0.005);
        const QImage with = view().grab().toImage();
        keepPicture(view(), QStringLiteral("scene-way-back"));
        view().setPaths({});
        QVERIFY2(view().grab().toImage() != with, "the path is not drawn");
        auto& back = bench_->find<HoldToRunButton>("backKey");
        press(back);
        QVERIFY(bench_->cell.advanceUntil([&] { return !back.isHolding(); }, 60'000));
        release(back);
        bench_->cell.advanceMs(500);
        QVERIFY((bench_->cell.truth().tcpPose.position - from).norm() < 0.001);
        QVERIFY(view().paths().empty());
    }

    // Before a touch-up is confirmed, the distance and both positions of the waypoint are displayed.
    void touchUpShowsBothPositionsBeforeConfirmation() {
        driveKeys(bench_->cell, window().jogColumn().holdKeys(), &window().jogColumn().axisJog());
        window().waypoints().teach();
        const project::Waypoint taught = window().document().waypoints().at(0);
        auto& key = bench_->find<HoldToRunButton>("jog.Z+");
        press(key);
        bench_->cell.advanceMs(3000);
        release(key);
        QVERIFY(timeToStandstill(bench_->cell) >= 0);
        bench_->cell.advanceMs(100);
        QVERIFY(!view().secondGhost());
        QTest::keyClick(&window(), Qt::Key_U);
        QVERIFY(view().ghost() && view().secondGhost());
        QVERIFY((view().ghost()->q.values - taught.joints.values).norm() < 1e-6);
        const JointPositions live = bench_->cell.truth().q;
        QVERIFY((view().secondGhost()->q.values - live.values).norm() < 1e-3);
        const QString text = window().waypoints().findChild<QLabel*>("notice.text")->text();
        QVERIFY2(text.contains("mm") && text.contains(QStringLiteral("°")), qPrintable(text));
        view().grab();
        QStringList names;
        for (const PlacedLabel& label : view().labels()) {
            names << label.text;
        }
        QVERIFY2(names.contains("Before: waypoint 1") && names.contains("After: waypoint 1"),
                 qPrintable(names.join(", ")));
        // The arm moves further, but the displayed position must be used.
        press(key);
        bench_->cell.advanceMs(1500);
        release(key);
        QVERIFY(timeToStandstill(bench_->cell) >= 0);
        bench_->cell.advanceMs(100);
        keepPicture(window(), QStringLiteral("scene-touch-up"));
        const QImage two = view().grab().toImage();
        view().setSecondGhost(std::nullopt);
        QVERIFY2(view().grab().toImage() != two, "the second position is not drawn");
        const auto click = [this](const char* name) {
            QTest::mouseClick(window().waypoints().findChild<QAbstractButton*>(name), Qt::LeftButton);
        };
        click("notice.dismiss");
        QVERIFY(!window().waypoints().touchUpGhost());
        QCOMPARE(window().document().waypoints().at(0), taught);
        QTest::keyClick(&window(), Qt::Key_U);
        const JointPositions shown = view().secondGhost()->q;
        click("notice.accept");
        QVERIFY(!view().secondGhost());
        QVERIFY((window().document().waypoints().at(0).joints.values - shown.values).norm() < 1e-9);
        window().document().undoStack().undo();
        QCOMPARE(window().document().waypoints().at(0), taught);
    }

    // The cell of the project is also part of the simulated environment. A jog ends before it reaches the
    // cell.
    void aBoxOfTheCellIsInTheSimulatedWorld() {
        driveKeys(bench_->cell, window().jogColumn().holdKeys(), &window().jogColumn().axisJog());
        window().practiseOn(&bench_->cell.robot);
        const Eigen::Vector3d tcp = bench_->cell.truth().tcpPose.position;
        project::CellBox box;
        box.id = QUuid::createUuid();
        box.name = "crate";
        box.pose = Pose(tcp.x(), tcp.y(), tcp.z() + 0.03 + 0.1, 0, 0, 0);
        box.size = Eigen::Vector3d(0.4, 0.4, 0.2);
        project::CellGeometry cell;
        cell.boxes.insert(0, box);
        window().document().changeCell(cell, "crate");
        bool solid = false;
        bench_->cell.robot.changeWorld([&solid, tcp](simulator::arm::Environment& world) {
            solid = !world.contactForce(tcp + Eigen::Vector3d(0, 0, 0.05), Eigen::Vector3d::Zero()).isZero();
        });
        auto& key = bench_->find<HoldToRunButton>("jog.Z+");
        press(key);
        bench_->cell.advanceMs(2000);
        release(key);
        QVERIFY(solid);
        QCOMPARE(bench_->cell.truth().safetyMode, SafetyMode::Normal);
        QVERIFY(bench_->cell.truth().tcpPose.position.z() < tcp.z() + 0.03);

        // An object that is removed from the project is also removed from the simulator.
        window().document().undoStack().undo();
        bool empty = false;
        bench_->cell.robot.changeWorld([&empty, tcp](simulator::arm::Environment& world) {
            empty = world.contactForce(tcp + Eigen::Vector3d(0, 0, 0.08), Eigen::Vector3d::Zero()).isZero();
        });
        bench_->cell.advanceMs(40);
        QVERIFY(empty);
        window().practiseOn(nullptr);
    }

    // The waypoints are taught at one position. Each name must be legible, or included in the number of
    // hidden names.
    void waypointNamesDoNotOverlap() {
        for (int i = 0; i < 14; ++i) {
            window().waypoints().teach();
        }
        bench_->cell.advanceMs(100);
        view().grab();
        keepPicture(window(), QStringLiteral("scene-names"));
        const auto& labels = view().labels();
        QVERIFY(!labels.empty());
        QCOMPARE(static_cast<int>(labels.size()) + view().hiddenLabels(), window().waypointCount());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY2(!labels[i].box.intersects(labels[j].box), qPrintable(labels[i].text));
            }
        }
        QVERIFY(view().hiddenLabels() > 0);
        QVERIFY(view().hiddenText().contains(QString::number(view().hiddenLabels())));
    }
};

QTEST_MAIN(TestScene)
#include "tst_scene.moc"
