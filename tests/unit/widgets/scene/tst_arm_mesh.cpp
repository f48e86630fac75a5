// SPDX-License-Identifier: GPL-3.0-or-later
//
// The displayed housings. For every model, they are closed and inside the shapes of the collision check. Also
// saves an image of each model in two poses for visual inspection.

#include <QApplication>
#include <QPainter>
#include <QTest>
#include <algorithm>

#include "robot/collision/arm_body.h"
#include "robot/kinematics/arm_kinematics.h"
#include "tests/support/pictures.h"
#include "widgets/common/theme.h"
#include "widgets/scene/arm_mesh.h"
#include "widgets/scene/scene_bodies.h"

using namespace tiller;

namespace {

const JointPositions kFolded(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);
const JointPositions kReaching(2.45, -0.75, 0.85, -1.67, -1.5707, 0.4);

/// Returns the distance of a point from the surface of a rod; negative inside [m].
double outside(const collision::Capsule& rod, const Eigen::Vector3d& place) {
    const Eigen::Vector3d way = rod.to - rod.from;
    const double length2 = way.squaredNorm();
    const double at = length2 > 0 ? std::clamp((place - rod.from).dot(way) / length2, 0.0, 1.0) : 0;
    return (place - (rod.from + at * way)).norm() - rod.radius;
}

QImage picture(const RobotModel& model, const JointPositions& q, const QSize& size, const Theme& theme) {
    Camera camera;
    camera.reset(collision::uprightHeight(model));
    camera.setViewport(size);
    std::vector<Camera::Ball> balls;
    for (const auto& part : collision::placedCapsules(collision::armCapsules(model), model.dh, q)) {
        balls.push_back({part.shape.from, part.shape.radius});
        balls.push_back({part.shape.to, part.shape.radius});
    }
    camera.fit(balls, QMarginsF(16, 36, 16, 16));
    SceneBodies bodies;
    bodies.setModel(model);
    bodies.setArm(q, false);
    bodies.update(camera, size, 1, theme);
    QImage image(size, QImage::Format_RGB32);
    image.fill(theme.panel);
    QPainter painter(&image);
    bodies.paint(painter);
    painter.setFont(textFont(16));
    painter.setPen(theme.text);
    painter.drawText(QPoint(12, 24), QLatin1String(model.name));
    return image;
}

}  // namespace

class TestArmMesh : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void everyFacePointsOutwards() {
        for (const RobotModel& model : robotModels()) {
            for (const Mesh& mesh : armMesh(model)) {
                QVERIFY(!mesh.triangles.empty());
                QCOMPARE(mesh.normals.size(), mesh.places.size());
                for (const Mesh::Triangle& t : mesh.triangles) {
                    const auto& place = mesh.places;
                    const Eigen::Vector3f across = (place[t.corners[1]] - place[t.corners[0]])
                                                       .cross(place[t.corners[2]] - place[t.corners[0]]);
                    for (const std::uint32_t corner : t.corners) {
                        QVERIFY2(across.dot(mesh.normals[corner]) >= 0, model.name);
                        QVERIFY(std::abs(mesh.normals[corner].norm() - 1) < 1e-4F);
                    }
                }
            }
        }
    }

    // The drawn shapes must be inside the collision shapes, so that each visible collision is reported.
    void drawnShapesAreInsideTheCheckedShapes() {
        for (const RobotModel& model : robotModels()) {
            const ArmMesh mesh = armMesh(model);
            const auto rods = collision::armCapsules(model);
            for (std::size_t link = 0; link < mesh.size(); ++link) {
                for (const Eigen::Vector3f& place : mesh[link].places) {
                    double nearest = 1;
                    for (const auto& rod : rods) {
                        if (rod.link == static_cast<int>(link)) {
                            nearest = std::min(nearest, outside(rod.shape, place.cast<double>()));
                        }
                    }
                    // The foot does not move, so a larger distance is permitted.
                    const double allowed = link == 0 ? 0.03 : 0.004;
                    QVERIFY2(nearest < allowed,
                             qPrintable(QStringLiteral("%1, link %2: %3 mm at (%4, %5, %6)")
                                            .arg(QLatin1String(model.name))
                                            .arg(link)
                                            .arg(nearest * 1e3)
                                            .arg(place.x())
                                            .arg(place.y())
                                            .arg(place.z())));
                }
            }
        }
    }

    void theFlangeMatchesTheKinematics() {
        for (const RobotModel& model : robotModels()) {
            const Mesh flange = armMesh(model)[6];
            float end = -1;
            for (const Eigen::Vector3f& place : flange.places) {
                end = std::max(end, place.z());
            }
            QVERIFY2(std::abs(end) < 1e-6F, model.name);
        }
    }

    // Creates images for visual inspection. The test only checks that there are pixels with the colours of
    // the arm.
    void everyModelIsDrawnInTwoPoses() {
        constexpr int kWidth = 360;
        constexpr int kHeight = 340;
        constexpr int kColumns = 7;
        const int rows = 2 * static_cast<int>(robotModels().size()) / kColumns;
        for (const Theme* theme : {&Theme::light(), &Theme::dark()}) {
            QImage sheet(kColumns * kWidth, rows * kHeight, QImage::Format_RGB32);
            QPainter painter(&sheet);
            int n = 0;
            for (const RobotModel& model : robotModels()) {
                for (const JointPositions& q : {kFolded, kReaching}) {
                    const QImage one = picture(model, q, {kWidth, kHeight}, *theme);
                    int blue = 0;
                    int covered = 0;
                    for (int y = 30; y < one.height(); ++y) {
                        for (int x = 0; x < one.width(); ++x) {
                            const QColor c(one.pixel(x, y));
                            covered += c != theme->panel ? 1 : 0;
                            blue += c.blue() - c.red() > 50 ? 1 : 0;
                        }
                    }
                    QVERIFY2(covered > 8000, model.name);
                    QVERIFY2(blue > 150, model.name);
                    painter.drawImage(n / 2 % kColumns * kWidth, (n / 2 / kColumns * 2 + n % 2) * kHeight,
                                      one);
                    ++n;
                }
            }
            painter.end();
            const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
            if (!folder.isEmpty()) {
                QDir().mkpath(folder);
                QVERIFY(sheet.save(folder + (theme->isDark() ? "/arms-dark.png" : "/arms-light.png")));
            }
        }
    }
};

QTEST_MAIN(TestArmMesh)
#include "tst_arm_mesh.moc"
