// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>
#include <limits>

#include "robot/collision/arm_body.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/link/robot_session.h"
#include "widgets/common/replay_band.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_dock.h"
#include "widgets/scene/scene_view.h"

using namespace tiller;

namespace {

const JointPositions kStance(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

SessionState live(const JointPositions& q, double time = 1) {
    SessionState state;
    state.link = LinkState::Live;
    state.sequence = 1;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.q = q;
    state.robotTime = time;
    return state;
}

QImage picture(SceneView& view) {
    QImage image(view.size(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Theme::current().panel);
    QPainter painter(&image);
    view.paintScene(painter, view.size());
    return image;
}

/// Returns true if a pixel within `radius` of the point has approximately this colour.
bool hasColorNear(const QImage& image, const QPointF& place, const QColor& color, int radius) {
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            const QPoint at = place.toPoint() + QPoint(dx, dy);
            if (image.rect().contains(at)) {
                const QColor c(image.pixel(at));
                if (std::abs(c.red() - color.red()) + std::abs(c.green() - color.green()) +
                        std::abs(c.blue() - color.blue()) <
                    24) {
                    return true;
                }
            }
        }
    }
    return false;
}

bool isBlue(const QColor& c) {
    return c.blue() - c.red() > 40;
}

int countBlue(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += isBlue(QColor(image.pixel(x, y))) ? 1 : 0;
        }
    }
    return count;
}

/// Returns true if most of the area around the point is blue.
bool isBlueNear(const QImage& image, const QPointF& place) {
    return countBlue(image.copy(QRect(place.toPoint() - QPoint(3, 3), QSize(7, 7)))) > 25;
}

/// Returns the area that an arm covers on the screen.
QRectF coveredBy(const SceneView& view, const JointPositions& q) {
    QRectF covered;
    const RobotModel& model = robotModel(RobotModelId::UR5e);
    for (const auto& part : collision::placedCapsules(collision::armCapsules(model), model.dh, q)) {
        for (const Eigen::Vector3d& end : {part.shape.from, part.shape.to}) {
            const auto at = view.camera().project(end);
            const double radius = part.shape.radius * at.pixelsPerMetre;
            covered |= QRectF(at.point.x() - radius, at.point.y() - radius, 2 * radius, 2 * radius);
        }
    }
    return covered;
}

/// The part of the image below the buttons, with a margin.
QRectF inner(const SceneView& view, double margin) {
    const auto* keys = view.findChild<QWidget*>("scene.keys");
    return QRectF(view.rect()).adjusted(margin, margin + keys->geometry().bottom(), -margin, -margin);
}

QPointF onScreen(const SceneView& view, const Eigen::Vector3d& place) {
    return view.camera().project(place).point;
}

Ghost uprightGhost() {
    Ghost ghost;
    ghost.name = "home";
    ghost.q = JointPositions(0, -M_PI_2, 0, -M_PI_2, 0, 0);
    return ghost;
}

struct ShownView : SceneView {
    explicit ShownView(const QSize& size = {600, 400}) {
        resize(size);
        show();
        if (!QTest::qWaitForWindowExposed(this)) {
            qFatal("the view was not shown");
        }
        setState(live(kStance));
        picture(*this);
    }
};

class PaintCounter : public QObject {
public:
    explicit PaintCounter(QWidget& watched) { watched.installEventFilter(this); }
    /// Waits for ten intervals without a paint event. The count is reset before each interval.
    void waitForQuiet() {
        int quiet = 0;
        for (int looks = 0; looks < 500 && quiet < 10; ++looks) {
            paints = 0;
            QTest::qWait(10);
            quiet = paints == 0 ? quiet + 1 : 0;
        }
        paints = 0;
    }
    int paints = 0;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        paints += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
};

int countColor(const QImage& image, const QColor& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += QColor(image.pixel(x, y)) == color ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

class TestSceneView : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void aReplayWithoutJointPositionsIsNotLabelledAsReplay() {
        SceneView view;
        view.setState(live(kStance));
        QVERIFY(view.replayHeadline().isEmpty());
        ReplayMark mark{kStance, QStringLiteral("REPLAY")};
        view.setReplay(mark);
        QCOMPARE(view.replayHeadline(), QStringLiteral("REPLAY"));
        mark.q[2] = std::numeric_limits<double>::quiet_NaN();
        view.setReplay(mark);
        QCOMPARE(view.replayHeadline(), QStringLiteral("LIVE ARM"));
        view.setState(SessionState());
        QVERIFY2(view.replayHeadline().isEmpty(), "the headline is shown without an arm");
    }

    void aReplayOfAnotherModelIsDrawnAsThatModel() {
        SceneView view;
        view.setModel(robotModel(RobotModelId::UR5e));
        view.setState(live(kStance));
        ReplayMark mark{kStance, QStringLiteral("REPLAY"), RobotModelId::UR5e};
        view.setReplay(mark);
        QCOMPARE(view.replayModel().id, RobotModelId::UR5e);
        const QImage same = view.grab().toImage();
        mark.model = RobotModelId::UR10e;
        view.setReplay(mark);
        QCOMPARE(view.replayModel().id, RobotModelId::UR10e);
        QVERIFY2(view.grab().toImage() != same, "drawn with the geometry of the connected arm");
        mark.model.reset();
        view.setReplay(mark);
        QCOMPARE(view.replayModel().id, RobotModelId::UR5e);
    }

    void theReplayBandReportsAnUnknownModel() {
        RobotSession session;
        session.shutDown();
        SceneDock dock(session);
        ReplayMoment moment;
        moment.source = QStringLiteral("lab.csv");
        const auto layout =
            std::make_shared<const receive::SampleLayout>(std::vector<std::string>{"timestamp", "actual_q"});
        moment.sample = receive::Sample(layout);
        moment.sample.sequence = 1;
        std::fill(moment.sample.values.begin(), moment.sample.values.end(), 0.0);
        const auto* band = dock.findChild<ReplayBand*>();
        dock.setReplay(moment);
        QVERIFY2(band->words().contains("model unknown"), qPrintable(band->words()));
        moment.model = RobotModelId::UR10e;
        dock.setReplay(moment);
        QVERIFY2(!band->words().contains("model unknown"), qPrintable(band->words()));
    }

    void theReplayBandReportsMissingJointPositions() {
        RobotSession session;
        session.shutDown();
        SceneDock dock(session);
        ReplayMoment moment;
        moment.source = QStringLiteral("lab.csv");
        dock.setReplay(moment);
        const auto* band = dock.findChild<ReplayBand*>();
        QVERIFY(band != nullptr);
        QVERIFY2(band->words().contains("No joint positions"), qPrintable(band->words()));
        dock.setReplay({});
        QVERIFY(!band->words().contains("No joint positions"));
    }

    void aPointStraightAheadIsCentred() {
        Camera camera;
        camera.reset(1.08);
        camera.setViewport({800, 600});
        const Eigen::Matrix3d R = camera.viewRotation();
        QVERIFY((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-12);
        QVERIFY(std::abs(R.determinant() - 1) < 1e-12);
        const auto middle = camera.project({0, 0, 0.435 * 1.08});
        QVERIFY(std::hypot(middle.point.x() - 400, middle.point.y() - 300) < 1e-6);
        const Eigen::Vector3d target(0, 0, 0.435 * 1.08);
        // X of the view points right, Y up, and Z towards the viewer. The jog frame "View" depends on this.
        QVERIFY(camera.project(target + 0.1 * R.col(0)).point.x() > middle.point.x() + 10);
        QVERIFY(camera.project(target + 0.1 * R.col(1)).point.y() < middle.point.y() - 10);
        QVERIFY(camera.project(target + 0.1 * R.col(2)).depth < middle.depth);
        QVERIFY(R.col(1).z() > 0.5);
        QVERIFY2(R.col(0).x() > 0.5, "X of the base does not point right in the initial view");
    }

    void pointsBehindTheCameraAreNotDrawn() {
        Camera camera;
        camera.reset(1.08);
        const Eigen::Vector3d behind = 100 * camera.viewRotation().col(2);
        QVERIFY(!camera.project(behind).visible());
    }

    void theWholeReachOfAnUprightArmIsVisible() {
        for (const RobotModel& model : robotModels()) {
            Camera camera;
            camera.reset(collision::uprightHeight(model));
            camera.setViewport({930, 520});
            const auto frames =
                kinematics::linkFrames(model.dh, JointPositions(0, -M_PI_2, 0, -M_PI_2, 0, 0));
            for (const auto& frame : frames) {
                const QPointF at = camera.project(frame.translation()).point;
                QVERIFY2(QRectF(0, -10, 930, 540).contains(at), model.name);
            }
        }
    }

    void theToolFrameIsDrawnAtTheComputedPose() {
        SceneView view;
        view.resize(930, 520);
        SessionState state = live(kStance);
        state.tcpOffset = Pose(0, 0, 0.1, 0, 0, 0);
        view.setState(state);
        const QImage image = picture(view);
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        const Eigen::Isometry3d T = kinematics::forwardTcp(model.dh, kStance, state.tcpOffset).transform();
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d on = T.translation() + 0.06 * T.linear().col(axis);
            QVERIFY2(hasColorNear(image, view.camera().project(on).point, Theme::light().axis(axis), 1),
                     qPrintable(QString::number(axis)));
        }
        const Eigen::Vector3d off = T.translation() + 0.06 * T.linear().col(2) + Eigen::Vector3d(0, 0, 0.3);
        QVERIFY(!hasColorNear(image, view.camera().project(off).point, Theme::light().axis(2), 1));
    }

    void ghostIsShownWithItsValues() {
        SceneView view;
        view.resize(930, 520);
        view.setState(live(kStance));
        const QImage alone = picture(view);
        Ghost ghost;
        ghost.name = "above tray";
        ghost.q = kStance;
        ghost.q[4] += 41 * M_PI / 180;
        ghost.q[0] += 0.3;
        ghost.speed = 1.0;
        ghost.acceleration = 1.0;
        QSignalSpy texts(&view, &SceneView::ghostTextChanged);
        SessionState state = live(kStance);
        state.speedFraction = 0.35;
        view.setState(state);
        view.setGhost(ghost);
        // 41 deg = 0.7156 rad. Full speed is not reached: the move takes 2 sqrt(0.7156) s, or 4.83 s at 35 %.
        QCOMPARE(view.ghostText(),
                 QString("ghost “above tray” · reachable · largest rotation Wrist 2 41° · 4.8 s at 35 %"));
        QCOMPARE(texts.last().first().toString(), view.ghostText());
        // The image is blue at the flange of the ghost, and only there.
        const Eigen::Vector3d flange =
            kinematics::forward(robotModel(RobotModelId::UR5e).dh, ghost.q) * Eigen::Vector3d(0, 0, -0.04);
        const QPointF at = onScreen(view, flange);
        QVERIFY(isBlueNear(picture(view), at));
        QVERIFY(!isBlueNear(alone, at));
        ghost.reachable = false;
        view.setGhost(ghost);
        QVERIFY(view.ghostText().contains("out of reach"));
        view.setGhost(std::nullopt);
        QVERIFY(view.ghostText().isEmpty());
    }

    void staleDataAreGreyAndLabelled() {
        SceneView view;
        view.resize(930, 520);
        view.setState(live(kStance));
        QVERIFY(countBlue(picture(view)) > 500);
        SessionState state = live(kStance);
        state.link = LinkState::Stale;
        view.setState(state);
        const QImage stale = picture(view);
        QVERIFY(countBlue(stale) < 300);  // axis of the tool
        state.link = LinkState::Lost;
        view.setState(state);
        QVERIFY(countColor(picture(view), Theme::light().secondary) >
                countColor(stale, Theme::light().secondary));
        state.link = LinkState::Live;
        view.setState(state);
        QVERIFY(countBlue(picture(view)) > 500);
    }

    void dragOrbitsWheelZoomsAndDoubleClickResets() {
        SceneView view;
        view.resize(600, 400);
        view.show();
        view.setState(live(kStance));
        QSignalSpy moved(&view, &SceneView::viewChanged);
        const Camera before = view.camera();
        QTest::mousePress(&view, Qt::LeftButton, {}, {300, 200});
        QTest::mouseMove(&view, {360, 220});
        QTest::mouseRelease(&view, Qt::LeftButton, {}, {360, 220});
        QVERIFY(view.camera().azimuth() != before.azimuth());
        QVERIFY(view.camera().elevation() > before.elevation());
        QVERIFY(moved.count() > 0);
        const double turned = view.camera().distance();
        QWheelEvent wheel({300, 200}, view.mapToGlobal(QPoint(300, 200)), {}, {0, 240}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &wheel);
        QVERIFY(view.camera().distance() < turned);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, {300, 200});
        QCOMPARE(view.camera().distance(), before.distance());
        QCOMPARE(view.camera().azimuth(), before.azimuth());
        // The right button does not rotate the view.
        QTest::mousePress(&view, Qt::RightButton, {}, {300, 200});
        QTest::mouseMove(&view, {400, 250});
        QTest::mouseRelease(&view, Qt::RightButton, {}, {400, 250});
        QCOMPARE(view.camera().azimuth(), before.azimuth());
    }

    // At every window size, the arm is large and not in the lower half of the view.
    void theArmFillsTheView_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("as designed") << QSize(930, 520);
        QTest::newRow("small") << QSize(520, 340);
        QTest::newRow("wide") << QSize(1400, 400);
        QTest::newRow("high") << QSize(420, 800);
    }
    void theArmFillsTheView() {
        QFETCH(QSize, size);
        ShownView view(size);
        const QRectF arm = coveredBy(view, kStance);
        QVERIFY(inner(view, 8).contains(arm));
        QVERIFY2(arm.height() > 0.55 * size.height() || arm.width() > 0.55 * size.width(),
                 qPrintable(QStringLiteral("%1 x %2").arg(arm.width()).arg(arm.height())));
        QVERIFY(std::abs(arm.center().y() - inner(view, 8).center().y()) < 0.12 * size.height());
    }

    void bottomOverlayDoesNotHideTheTcp() {
        ShownView view({340, 330});
        view.setCoveredBelow(48);
        picture(view);
        QVERIFY(inner(view, 4).adjusted(0, 0, 0, -48).contains(coveredBy(view, kStance)));
        view.setCoveredBelow(1000);  // more than the height of the image: the arm has priority
        picture(view);
        QVERIFY(inner(view, 4).contains(coveredBy(view, kStance)));
        QVERIFY(coveredBy(view, kStance).height() > 0.3 * view.height());
    }

    void theGhostAndTheWaypointsAreVisible() {
        ShownView view({630, 340});
        const double alone = view.camera().distance();
        view.setGhost(uprightGhost());
        picture(view);
        QVERIFY(inner(view, 6).contains(coveredBy(view, uprightGhost().q)));
        QVERIFY(inner(view, 6).contains(coveredBy(view, kStance)));
        QVERIFY(view.camera().distance() > alone);
        // After the preview, the image is the same as before.
        view.setGhost(std::nullopt);
        picture(view);
        QVERIFY(std::abs(view.camera().distance() - alone) < 1e-9);
        const Eigen::Vector3d places[] = {{0.6, 0.6, 0.3}, {-0.7, 0.4, 0.8}, {0, -0.8, 0.1}};
        view.setWaypoints({{"a", places[0], false}, {"b", places[1], false}, {"c", places[2], true}});
        picture(view);
        for (const Eigen::Vector3d& place : places) {
            QVERIFY(inner(view, 6).contains(onScreen(view, place)));
        }
        // A ghost of another robot far away does not make the arm very small.
        const double near = view.camera().distance();
        view.setWaypoints({{"far", Eigen::Vector3d(40, 0, 0), false}});
        picture(view);
        QVERIFY(view.camera().distance() <= near);
    }

    void theArmStaysVisibleWhileItMoves() {
        ShownView view;
        for (int i = 0; i <= 60; ++i) {
            JointPositions q = kStance;
            q[0] += i * 0.05;
            q[1] += i * 0.01;
            view.setState(live(q, 1 + i * 0.02));
            picture(view);
            QVERIFY2(inner(view, 4).contains(coveredBy(view, q)), qPrintable(QString::number(i)));
        }
    }

    // An operator who zooms or pans keeps that view until the complete view is requested.
    void aViewSetByTheOperatorIsKept() {
        ShownView view;
        const Camera before = view.camera();
        QTest::mousePress(&view, Qt::RightButton, {}, {300, 200});
        QTest::mouseMove(&view, {400, 250});
        QTest::mouseRelease(&view, Qt::RightButton, {}, {400, 250});
        const Eigen::Vector3d base = Eigen::Vector3d::Zero();
        QCOMPARE(view.camera().azimuth(), before.azimuth());
        const QPointF moved = onScreen(view, base) - before.project(base).point;
        QVERIFY2(moved.x() > 70 && moved.y() > 35, "the image does not follow the pointer");
        QTest::mousePress(&view, Qt::LeftButton, Qt::ShiftModifier, {300, 200});
        QTest::mouseMove(&view, {200, 150});
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::ShiftModifier, {200, 150});
        QVERIFY((onScreen(view, base) - before.project(base).point).manhattanLength() < 12);
        QTest::keyClick(&view, Qt::Key_Plus);
        const double chosen = view.camera().distance();
        view.setGhost(uprightGhost());
        picture(view);
        QCOMPARE(view.camera().distance(), chosen);
        QTest::mouseClick(view.findChild<QToolButton*>("scene.fit"), Qt::LeftButton);
        picture(view);
        QVERIFY(inner(view, 6).contains(coveredBy(view, uprightGhost().q)));
        QCOMPARE(view.camera().azimuth(), before.azimuth());
    }

    void shiftAndArrowKeysPanTheView() {
        ShownView view;
        const Eigen::Vector3d base = Eigen::Vector3d::Zero();
        const QPointF before = onScreen(view, base);
        const double azimuth = view.camera().azimuth();
        QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(onScreen(view, base).x() > before.x() + 5);
        QCOMPARE(view.camera().azimuth(), azimuth);
        QTest::keyClick(&view, Qt::Key_Left);
        QVERIFY(view.camera().azimuth() != azimuth);
    }

    void theButtonsSelectTheStandardViews_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<int>("right");  // base axes that point right and up
        QTest::addColumn<int>("up");
        QTest::newRow("front") << "scene.front" << 0 << 2;
        QTest::newRow("side") << "scene.side" << 1 << 2;
        QTest::newRow("top") << "scene.top" << 0 << 1;
    }
    void theButtonsSelectTheStandardViews() {
        QFETCH(QString, key);
        QFETCH(int, right);
        QFETCH(int, up);
        ShownView view;
        const Eigen::Matrix3d first = view.viewRotation();
        QSignalSpy moved(&view, &SceneView::viewChanged);
        QTest::mouseClick(view.findChild<QToolButton*>(key), Qt::LeftButton);
        QCOMPARE(moved.count(), 1);
        QVERIFY((view.viewRotation().col(0) - Eigen::Vector3d::Unit(right)).norm() < 1e-9);
        QVERIFY((view.viewRotation().col(1) - Eigen::Vector3d::Unit(up)).norm() < 1e-9);
        picture(view);
        QVERIFY(inner(view, 6).contains(coveredBy(view, kStance)));
        // Rotating with the keys continues from this view, and the 3D button restores the initial view.
        QTest::keyClick(&view, Qt::Key_Right);
        QVERIFY(view.viewRotation().allFinite());
        QTest::mouseClick(view.findChild<QToolButton*>("scene.home"), Qt::LeftButton);
        QVERIFY((view.viewRotation() - first).norm() < 1e-9);
    }

    void theButtonsAreHiddenInAVerySmallView() {
        ShownView view({600, 400});
        auto* keys = view.findChild<QWidget*>("scene.keys");
        QVERIFY(keys->isVisible() && view.rect().contains(keys->geometry()));
        view.resize(100, 180);
        QTRY_VERIFY_WITH_TIMEOUT(!keys->isVisible(), 60'000);
        view.resize(600, 400);
        QTRY_VERIFY_WITH_TIMEOUT(keys->isVisible(), 60'000);
    }

    void labelsDoNotOverlap() {
        ShownView view({930, 520});
        const Eigen::Vector3d tcp =
            kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, kStance).position;
        std::vector<WaypointMark> marks;
        for (int i = 0; i < 3; ++i) {
            marks.push_back(
                {QStringLiteral("above the tray %1").arg(i), tcp + Eigen::Vector3d(0.01 * i, 0, 0), false});
        }
        view.setWaypoints(marks);
        picture(view);
        QCOMPARE(view.labels().size(), std::size_t(3));
        QCOMPARE(view.hiddenLabels(), 0);
        QVERIFY(view.hiddenText().isEmpty());
        // Too many labels at one point: the view shows the number of hidden labels, and the selected waypoint
        // is always labelled.
        for (int i = 3; i < 40; ++i) {
            marks.push_back({QStringLiteral("above the tray %1").arg(i),
                             tcp + Eigen::Vector3d(0.0005 * i, 0, 0), i == 39});
        }
        view.setWaypoints(marks);
        picture(view);
        const auto& labels = view.labels();
        QVERIFY(view.hiddenLabels() > 0);
        QCOMPARE(static_cast<int>(labels.size()) + view.hiddenLabels(), 40);
        QVERIFY(view.hiddenText().startsWith(QString::number(view.hiddenLabels())));
        QCOMPARE(labels.front().text, QString("above the tray 39"));
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(QRectF(view.rect()).contains(labels[i].box));
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY2(!labels[i].box.intersects(labels[j].box), qPrintable(labels[i].text));
            }
        }
        // Zooming in separates the labels.
        const int hidden = view.hiddenLabels();
        for (int i = 3; i < 40; ++i) {
            marks[static_cast<std::size_t>(i)].position =
                Eigen::Vector3d(-0.7 + 0.25 * (i % 6), -0.6 + 0.2 * (i / 6), 0.1 * (i % 3));
        }
        view.setWaypoints(marks);
        picture(view);
        QVERIFY(view.hiddenLabels() < hidden);
    }

    void cameraStaysAboveTheGround() {
        Camera camera;
        camera.reset(1.08);
        camera.orbit(0, -10);
        QVERIFY(camera.elevation() > 0);
        camera.orbit(0, 10);
        QVERIFY(camera.elevation() < M_PI_2);
        camera.zoom(1e-9);
        QVERIFY(camera.distance() > 0.1);
    }

    void viewCannotMoveTheRobot() {
        // The view does not depend on the session. Only the dock does, and it only reads from the session.
        for (const char* file : {"scene_view.h", "scene_view.cpp", "scene_painter.cpp", "scene_dock.cpp"}) {
            const QString folder = qEnvironmentVariable("TILLER_TEST_DATA") + "/../../widgets/scene/";
            QFile source(QDir::cleanPath(folder) + '/' + QLatin1String(file));
            QVERIFY2(source.open(QIODevice::ReadOnly), file);
            const QByteArray text = source.readAll();
            QVERIFY2(qstrcmp(file, "scene_dock.cpp") == 0 || !text.contains("robot_session.h"), file);
            for (const char* call : {"beginJog", "beginMove", "hold(", "endMotion", "controller.h"}) {
                QVERIFY2(!text.contains(call), call);
            }
        }
    }

    void spaceAndEscapeAreLeftToTheStop() {
        SceneView view;
        for (const auto key : {Qt::Key_Space, Qt::Key_Escape}) {
            QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
            QApplication::sendEvent(&view, &event);
            QVERIFY(!event.isAccepted());
        }
    }

    void repaintsOnlyWhenSomethingChanged() {
        SceneView view;
        view.resize(400, 300);
        view.show();
        view.setState(live(kStance));
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        PaintCounter counter(view);
        counter.waitForQuiet();
        for (int i = 0; i < 5; ++i) {
            view.setState(live(kStance, 1));
            QTest::qWait(20);
        }
        QCOMPARE(counter.paints, 0);
        JointPositions moved = kStance;
        moved[0] += 0.1;
        view.setState(live(moved, 1));
        QTRY_VERIFY_WITH_TIMEOUT(counter.paints > 0, 60'000);
    }

    // The TCP rises by a twentieth of a pixel in each step. Most of the steps do not change the image, but
    // all of them together do.
    void hiddenViewsAreNotDrawn() {
        ShownView view;
        PaintCounter counter(view);
        counter.waitForQuiet();
        const RobotModel& model = robotModel(RobotModelId::UR5e);
        const Eigen::Vector3d tcp = kinematics::forwardTcp(model.dh, kStance, {}).position;
        const double scale = view.camera().project(tcp).pixelsPerMetre;
        JointPositions q = kStance;
        const auto turned = [&] {
            return (onScreen(view, kinematics::forwardTcp(model.dh, q, {}).position) - onScreen(view, tcp))
                .manhattanLength();
        };
        const double step = 0.05 / scale / model.reach;
        double time = 1;
        for (int i = 0; i < 4; ++i) {
            q[1] += step;
            view.setState(live(q, time += 0.02));
            QTest::qWait(25);
        }
        QVERIFY2(turned() > 0, qPrintable(QString::number(turned())));
        QCOMPARE(counter.paints, 0);
        for (int i = 0; i < 100; ++i) {
            q[1] += step;
            view.setState(live(q, time += 0.02));
        }
        QTRY_VERIFY_WITH_TIMEOUT(counter.paints > 0, 60'000);
        // A rotation at the same position is also a change, because the axes of the tool rotate.
        counter.waitForQuiet();
        q[5] += 0.3;
        view.setState(live(q, time += 0.02));
        QTRY_VERIFY_WITH_TIMEOUT(counter.paints > 0, 60'000);
    }
};

QTEST_MAIN(TestSceneView)
#include "tst_scene_view.moc"
