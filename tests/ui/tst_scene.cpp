// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 3D view in the real window: what must be seen is in the picture, the standard sides are commands with keys
// of their own, and the jog frame "View" follows.

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
#include "widgets/project/project_document.h"
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
    void pointTo(HoldButton& key, bool there) {
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

    // An upright arm was cut off at the top.
    void theGhostOfHomeIsInThePicture() {
        view().grab();
        const double alone = view().camera().distance();
        auto& home = bench_->find<HoldButton>("homeKey");
        pointTo(home, true);
        QTRY_VERIFY(view().ghost().has_value());
        view().grab();
        keepPicture(window(), QStringLiteral("scene-ghost"));
        QVERIFY(isInThePicture(view().ghost()->q));
        QVERIFY(isInThePicture(window().session().state().q));
        pointTo(home, false);
        QTRY_VERIFY(!view().ghost().has_value());
        view().grab();
        QVERIFY(std::abs(view().camera().distance() - alone) < 1e-6);
    }

    void theStandardSidesAreKeysAndCommands() {
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

    void thePaletteFindsThem() {
        bench_->cell.advanceMs(1500);  // Space means stop for a second after a motion
        QTest::keyClick(&window(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(window().findChild<app::CommandPalette*>() != nullptr);
        auto* words = window().findChild<app::CommandPalette*>()->findChild<QLineEdit*>("paletteWords");
        QTest::keyClicks(words, "look from above");
        const auto& listed = window().findChild<app::CommandPalette*>()->listed();
        QVERIFY2(
            !listed.isEmpty() && listed.first()->objectName() == "view.look.top",
            qPrintable(words->text() + ": " + (listed.isEmpty() ? QString() : listed.first()->objectName())));
        QTest::keyClick(words, Qt::Key_Return);
        QTRY_VERIFY((view().viewRotation().col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-9);
    }

    void fitBringsBackWhatWasPushedOut() {
        view().grab();
        const QPoint from(view().width() / 2, view().height() / 2);
        QTest::mousePress(&view(), Qt::RightButton, {}, from);
        QTest::mouseMove(&view(), from + QPoint(400, 0));
        QTest::mouseRelease(&view(), Qt::RightButton, {}, from + QPoint(400, 0));
        QVERIFY(!isInThePicture(window().session().state().q));
        bench_->cell.advanceMs(100);
        view().grab();
        QVERIFY2(!isInThePicture(window().session().state().q), "the operator's choice stays");
        QTest::keyClick(&window(), Qt::Key_F9);
        QVERIFY(isInThePicture(window().session().state().q));
    }

    // What stands in the way is said where the key is, marked on the way, and gone when it is gone.
    void aBoxInTheWayIsSaidBesideTheKey() {
        const JointPositions here = window().session().state().q;
        window().waypoints().teach();
        project::Waypoint far = window().document().waypoints().at(0);
        far.id = QUuid::createUuid();
        far.name = "far";
        far.joints = here;
        far.joints[0] += 1.2;
        window().document().insertWaypoints(1, {far}, "far");
        window().waypoints().selectWaypoint(far.id);
        QTRY_VERIFY(view().moveReport().has_value());
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

    // Taught at one place, as happens: each name is readable or counted.
    void namesOfWaypointsDoNotPileUp() {
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
