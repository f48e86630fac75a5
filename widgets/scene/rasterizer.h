// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Renders meshes without a graphics card, with hidden surface removal, shading and antialiasing (four samples
// per pixel). Solid bodies hide other bodies. Solid bodies are visible through transparent bodies (the ghost,
// planes of the cell), but other transparent bodies are not. The image is rendered in tiles, so that render()
// processes only the requested part.

#include <QColor>
#include <QImage>
#include <QRect>
#include <array>
#include <vector>

#include "widgets/scene/camera.h"
#include "widgets/scene/mesh.h"

namespace tiller {

/// Colours of a body. All colours are opaque, or all have the same transparency.
struct BodyColors {
    std::array<QColor, kMaterialCount> materials;
    double opacity = 1;  ///< below 1: transparent
    double shine = 0.3;  ///< intensity of the highlight, 0 ... 1
};

class Rasterizer {
public:
    /// Starts an empty image.
    /// scale  image pixels per camera pixel
    void begin(const QSize& size, const Camera& camera, double scale = 1);
    void add(const Mesh& mesh, const Eigen::Isometry3d& T_base_mesh, const BodyColors& colors);
    /// Bounding rectangle of the content [image px]; may be empty.
    QRect covered() const { return covered_; }
    /// Renders the added meshes within `part`. Uncovered pixels become transparent.
    /// Returns  premultiplied image, unchanged outside `part`
    const QImage& render(const QRect& part);
    /// True if, in the last rendered image, a solid body is closer to the eye than this position.
    /// pixel  position [camera px]
    /// depth  along the line of sight [m]
    bool hides(const QPointF& pixel, double depth) const;

private:
    struct Vertex {
        float x, y;  ///< [px]
        float near;  ///< 1 / depth
        float red, green, blue;
    };
    struct Face {
        std::array<double, 3> c;  ///< for each edge: a x + b y + c >= 0 inside the face
        std::array<float, 3> a, b;
        /// 1 / depth = [0] x + [1] y + [2], with x and y relative to the first vertex.
        std::array<float, 3> nearPlane;
        std::array<std::array<float, 3>, 3> color;  ///< like nearPlane, for red, green and blue
        float x0, y0;                               ///< position of the first vertex
        std::array<float, 3> least, most;  ///< minimum and maximum of red, green and blue over the vertices
        std::int16_t left, right, top, bottom;  ///< [px], inclusive
        std::uint8_t alpha;                     ///< below 255: transparent
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
    std::vector<float> nearest_;  ///< 1 / depth of solid bodies, per pixel
    struct ScratchVertex {
        Eigen::Vector3f view;
        float red, green, blue;
    };
    std::vector<ScratchVertex> scratch_;
    std::vector<std::int8_t> shaded_;  ///< material of the colour computed for a vertex; -1: none

    static constexpr int kTile = 64;
    alignas(16) std::array<float, kTile * kTile * 4> solidNear_;
    alignas(16) std::array<std::int32_t, kTile * kTile * 4> solidColor_;
    alignas(16) std::array<float, kTile * kTile * 4> glassNear_;
    alignas(16) std::array<std::int32_t, kTile * kTile * 4> glassColor_;
};

}  // namespace tiller
