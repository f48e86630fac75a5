// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QTest>
#include <cmath>

#include "widgets/scene/rasterizer.h"

using namespace tiller;

namespace {

BodyColors plain(const QColor& color, double opacity = 1) {
    BodyColors colors;
    colors.materials.fill(color);
    colors.opacity = opacity;
    colors.shine = 0;
    return colors;
}

Eigen::Isometry3d at(const Eigen::Vector3d& place) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() = place;
    return T;
}

Mesh cube(double edge) {
    Mesh mesh;
    addBox(mesh, Eigen::Isometry3d::Identity(), Eigen::Vector3d::Constant(edge), Material::Cell);
    return mesh;
}

Camera camera(const QSize& size) {
    Camera result;
    result.reset(1);
    result.setViewport(size);
    return result;
}

const QSize kSize(300, 200);

}  // namespace

class TestRasterizer : public QObject {
    Q_OBJECT

private:
    /// The point on the line of sight that is `nearer` [m] closer to the viewer than the target of the
    /// camera.
    Eigen::Vector3d onSight(const Camera& eye, double nearer) {
        return eye.eye().target + eye.viewRotation().col(2) * nearer;
    }

private Q_SLOTS:
    void nearFacesHideFarOnesInAnyOrder() {
        const Camera eye = camera(kSize);
        for (const bool farFirst : {true, false}) {
            Rasterizer raster;
            raster.begin(kSize, eye);
            const auto add = [&](bool far) {
                raster.add(cube(0.2), at(onSight(eye, far ? -0.5 : 0.5)), plain(far ? Qt::red : Qt::green));
            };
            add(farFirst);
            add(!farFirst);
            const QColor middle(raster.render(QRect(QPoint(0, 0), kSize)).pixel(150, 100));
            QVERIFY(middle.green() > 80 && middle.red() == 0);
            QVERIFY(raster.hides({150, 100}, eye.eye().distance));
            QVERIFY(!raster.hides({150, 100}, 0.2));
            QVERIFY(!raster.hides({2, 2}, 100));
        }
    }

    void transparentFacesShowTheBackground() {
        const Camera eye = camera(kSize);
        Rasterizer raster;
        const auto middle = [&](double glassNearer) {
            raster.begin(kSize, eye);
            raster.add(cube(0.2), at(onSight(eye, 0)), plain(Qt::red));
            raster.add(cube(0.2), at(onSight(eye, glassNearer)), plain(Qt::blue, 0.5));
            return QColor::fromRgba(raster.render(QRect(QPoint(0, 0), kSize)).pixel(150, 100));
        };
        const QColor before = middle(0.5);
        QVERIFY(before.red() > 40 && before.blue() > 40);
        QCOMPARE(before.alpha(), 255);
        const QColor behind = middle(-0.5);
        QCOMPARE(behind.blue(), 0);
        // A single face has exactly the specified transparency.
        raster.begin(kSize, eye);
        raster.add(cube(0.2), at(onSight(eye, 0)), plain(Qt::blue, 0.5));
        const int alpha = qAlpha(raster.render(QRect(QPoint(0, 0), kSize)).pixel(150, 100));
        QVERIFY2(std::abs(alpha - 128) <= 2, qPrintable(QString::number(alpha)));
    }

    void edgesAreSmooth() {
        const Camera eye = camera(kSize);
        Rasterizer raster;
        raster.begin(kSize, eye);
        raster.add(cube(0.3), at(onSight(eye, 0)), plain(Qt::white));
        const QImage& image = raster.render(QRect(QPoint(0, 0), kSize));
        int whole = 0;
        int part = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const int alpha = qAlpha(image.pixel(x, y));
                whole += alpha == 255 ? 1 : 0;
                part += alpha > 0 && alpha < 255 ? 1 : 0;
            }
        }
        QVERIFY(whole > 1000);
        QVERIFY(part > 60 && part < whole / 5);
        // No background is visible between the faces.
        QCOMPARE(qAlpha(image.pixel(150, 100)), 255);
        for (int x = 130; x < 170; ++x) {
            QCOMPARE(qAlpha(image.pixel(x, 100)), 255);
        }
    }

    // Only the changed part is redrawn. It must join the unchanged part without a seam.
    void aPartialRedrawMatchesAFullRedraw() {
        const Camera eye = camera(kSize);
        Rasterizer raster;
        const auto fill = [&] {
            raster.begin(kSize, eye);
            raster.add(cube(0.5), at(onSight(eye, 0)), plain(Qt::yellow));
            raster.add(cube(0.6), at(onSight(eye, -0.2)), plain(Qt::blue, 0.4));
        };
        fill();
        const QImage whole = raster.render(QRect(QPoint(0, 0), kSize)).copy();
        raster.begin(kSize, eye);
        raster.render(QRect(QPoint(0, 0), kSize));
        fill();
        raster.render(QRect(0, 0, 97, 200));
        QVERIFY(raster.render(QRect(97, 0, 203, 200)) == whole);
    }

    void facesAreClippedAtTheCamera() {
        const Camera eye = camera(kSize);
        Rasterizer raster;
        raster.begin(kSize, eye);
        Mesh floor;
        addBox(floor, Eigen::Isometry3d::Identity(), Eigen::Vector3d(60, 60, 0.01), Material::Cell);
        raster.add(floor, Eigen::Isometry3d::Identity(), plain(Qt::gray));
        const QImage& image = raster.render(QRect(QPoint(0, 0), kSize));
        QCOMPARE(qAlpha(image.pixel(150, 195)), 255);
        QCOMPARE(qAlpha(image.pixel(5, 195)), 255);
        QCOMPARE(qAlpha(image.pixel(150, 2)), 0);
    }

    void aHighDpiScreenGetsAHighResolutionPicture() {
        const Camera eye = camera(kSize);
        Rasterizer raster;
        raster.begin(kSize, eye);
        raster.add(cube(0.3), at(onSight(eye, 0)), plain(Qt::white));
        const QRect once = raster.covered();
        raster.begin(kSize * 2, eye, 2);
        raster.add(cube(0.3), at(onSight(eye, 0)), plain(Qt::white));
        QVERIFY(std::abs(raster.covered().width() - 2 * once.width()) <= 2);
        raster.render(raster.covered());
        QVERIFY(raster.hides({150, 100}, 50));  // in pixels of the camera
    }
};

QTEST_MAIN(TestRasterizer)
#include "tst_rasterizer.moc"
