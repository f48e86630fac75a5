// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws meshes into a picture without a graphics card: with hidden surfaces, shaded, with smooth edges (four samples a
// pixel). Solid bodies hide each other; glass bodies (the ghost, planes of the cell) let what is behind shine through,
// but not one another. It works tile by tile, so that only the part that is asked for is drawn.

#include <QColor>
#include <QImage>
#include <QRect>
#include <array>
#include <vector>

#include "widgets/scene/camera.h"
#include "widgets/scene/mesh.h"

namespace tiller {

/// Colours of one body. All opaque, or all equally transparent.
struct BodyColors {
    std::array<QColor, kMaterialCount> materials;
    double opacity = 1;  ///< below 1: glass
    double shine = 0.3;  ///< of the highlight, 0 ... 1
};

class Rasterizer {
public:
    /// A new picture: nothing is in it.
    /// scale  pixels of it for one of the camera's
    void begin(const QSize& size, const Camera& camera, double scale = 1);
    void add(const Mesh& mesh, const Eigen::Isometry3d& T_base_mesh, const BodyColors& colors);
    /// Where something is, in pixels of the picture; empty when there is nothing.
    QRect covered() const { return covered_; }
    /// Draws what was added, within `part`. Pixels there that nothing covers become transparent.
    /// Returns  the picture, premultiplied; outside `part` as it was before
    const QImage& render(const QRect& part);
    /// True when something solid is nearer to the eye than this place, as rendered last.
    /// pixel  the camera's
    /// depth  along the line of sight [m]
    bool hides(const QPointF& pixel, double depth) const;

private:
    struct Vertex {
        float x, y;  ///< [px]
        float near;  ///< 1 / depth
        float red, green, blue;
    };
    struct Face {
        std::array<double, 3> c;  ///< a x + b y + c >= 0 inside, for each edge
        std::array<float, 3> a, b;
        std::array<float, 3> nearPlane;  ///< 1 / depth = [0] x + [1] y + [2], [2] at the first corner
        std::array<std::array<float, 3>, 3> color;  ///< as nearPlane, for red, green and blue
        float x0, y0;                               ///< the first corner
        std::array<float, 3> least, most;           ///< of red, green and blue at the corners
        std::int16_t left, right, top, bottom;      ///< [px], inclusive
        std::uint8_t alpha;                         ///< below 255: glass
    };
    struct Tile {
        std::vector<std::uint32_t> solids, glasses;
    };

    void addFace(const Vertex& a, const Vertex& b, const Vertex& c, std::uint8_t alpha);
    void draw(const Face& face, int left, int top, bool glass);
    void clearSamples(bool glass);
    void resolve(int left, int top, const QRect& part, bool glass);

    QSize size_;
    Camera::Eye eye_;
    double scale_ = 1;
    std::vector<Face> faces_;
    std::vector<Tile> tiles_;
    int columns_ = 0, rows_ = 0;
    QRect covered_;
    QImage image_;
    std::vector<float> nearest_;  ///< of what is solid, 1 / depth, a pixel each
    struct ScratchVertex {
        Eigen::Vector3f view;
        float red, green, blue;
    };
    std::vector<ScratchVertex> scratch_;
    std::vector<std::int8_t> shaded_;  ///< the material that a corner has been coloured with; -1: none yet

    static constexpr int kTile = 64;
    alignas(16) std::array<float, kTile * kTile * 4> solidNear_;
    alignas(16) std::array<std::int32_t, kTile * kTile * 4> solidColor_;
    alignas(16) std::array<float, kTile * kTile * 4> glassNear_;
    alignas(16) std::array<std::int32_t, kTile * kTile * 4> glassColor_;
};

}  // namespace tiller
