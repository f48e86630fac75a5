// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/rasterizer.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene/simd.h"

namespace tiller {

namespace {

constexpr float kNearClip = 0.05F;  // [m]
// Sample positions in a pixel. No two are in the same row or column, so that steep and flat edges are equally
// smooth.
constexpr std::array<float, 4> kSampleX = {0.375F, 0.875F, 0.125F, 0.625F};
constexpr std::array<float, 4> kSampleY = {0.125F, 0.375F, 0.625F, 0.875F};

/// Packs red, green and blue, 0 ... 255, into 0x00RRGGBB.
std::int32_t packed(FourFloats color) {
    const FourBits c = truncated(color);
    return c[0] << 16 | c[1] << 8 | c[2];
}

/// Lighting: a lamp over the viewer's left shoulder, a weaker lamp from the right, and a bright ceiling.
/// Surfaces seen at a grazing angle are darker, which emphasizes outlines.
class Shade {
public:
    Shade(const Eigen::Matrix3f& R_base_view, float shine)
        : key_((R_base_view * Eigen::Vector3f(-0.42F, 0.62F, 0.66F)).normalized())
        , fill_((R_base_view * Eigen::Vector3f(0.80F, 0.10F, 0.45F)).normalized())
        , half_((key_ + R_base_view.col(2)).normalized())
        , shine_(shine) {}

    void at(const Eigen::Vector3f& n, const Eigen::Vector3f& toEye, const std::array<float, 3>& base,
            float& red, float& green, float& blue) const {
        const float key = std::max(0.0F, n.dot(key_));
        const float fill = std::max(0.0F, n.dot(fill_));
        const float facing = std::clamp(n.dot(toEye), 0.0F, 1.0F);
        const float edge = (1 - facing) * (1 - facing) * (1 - facing);
        const float light = (0.50F + 0.10F * n.z() + 0.46F * key + 0.14F * fill) * (1 - 0.34F * edge);
        float gloss = std::max(0.0F, n.dot(half_));
        gloss *= gloss;
        gloss *= gloss;
        gloss *= gloss;
        gloss *= gloss;  // the original value to the power of 16
        const float white = 255 * shine_ * gloss * 0.55F;
        red = std::min(255.0F, base[0] * light + white);
        green = std::min(255.0F, base[1] * light + white);
        blue = std::min(255.0F, base[2] * light + white);
    }

private:
    Eigen::Vector3f key_, fill_, half_;
    float shine_;
};

FourFloats load(const float* from) {
    FourFloats v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

void store(float* to, FourFloats v) {
    std::memcpy(to, &v, sizeof v);
}

FourBits load(const std::int32_t* from) {
    FourBits v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

void store(std::int32_t* to, FourBits v) {
    std::memcpy(to, &v, sizeof v);
}

constexpr std::uint32_t kEvenBytes = 0x00FF00FF;

/// Blends `over` with a premultiplied colour, according to the alpha of `over`.
std::uint32_t blended(std::uint32_t over, std::uint32_t under) {
    const std::uint32_t alpha = (over >> 24) + (over >> 31);  // 0 ... 256
    const std::uint32_t color = over | 0xFF000000;
    const std::uint32_t rest = 256 - alpha;
    const std::uint32_t low = ((color & kEvenBytes) * alpha + (under & kEvenBytes) * rest) >> 8 & kEvenBytes;
    const std::uint32_t high =
        ((color >> 8 & kEvenBytes) * alpha + (under >> 8 & kEvenBytes) * rest) & ~kEvenBytes;
    return low | high;
}

std::uint32_t mean(const std::array<std::uint32_t, 4>& c) {
    if (c[0] == c[1] && c[0] == c[2] && c[0] == c[3]) {
        return c[0];
    }
    constexpr std::uint32_t kHalf = 0x00020002;
    std::uint32_t low = kHalf;
    std::uint32_t high = kHalf;
    for (const std::uint32_t v : c) {
        low += v & kEvenBytes;
        high += v >> 8 & kEvenBytes;
    }
    return (low >> 2 & kEvenBytes) | (high << 6 & ~kEvenBytes);
}

}  // namespace

void Rasterizer::begin(const QSize& size, const Camera& camera, double scale) {
    eye_ = camera.eye();
    scale_ = scale;
    eye_.focal *= scale;
    eye_.middle *= scale;
    faces_.clear();
    covered_ = {};
    if (size != size_) {
        size_ = size;
        image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
        image_.fill(Qt::transparent);
        nearest_.assign(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()),
                        0.0F);
        columns_ = (size.width() + kTile - 1) / kTile;
        rows_ = (size.height() + kTile - 1) / kTile;
        tiles_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), {});
    }
    for (Tile& tile : tiles_) {
        tile.solids.clear();
        tile.glasses.clear();
    }
}

void Rasterizer::add(const Mesh& mesh, const Eigen::Isometry3d& T_base_mesh, const BodyColors& colors) {
    const Eigen::Matrix3f R_base_view = eye_.R_base_view.cast<float>();
    const Eigen::Isometry3d R_view_base(eye_.R_base_view.transpose());
    const Eigen::Isometry3d T_view_mesh = R_view_base * Eigen::Translation3d(-eye_.target) * T_base_mesh;
    const Eigen::Isometry3f T = T_view_mesh.cast<float>();
    const Eigen::Matrix3f R_base_mesh = T_base_mesh.linear().cast<float>();
    const Shade shade(R_base_view, static_cast<float>(colors.shine));
    std::array<std::array<float, 3>, kMaterialCount> base;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const QColor& c = colors.materials[i];
        base[i] = {static_cast<float>(c.red()), static_cast<float>(c.green()), static_cast<float>(c.blue())};
    }
    const auto alpha = static_cast<std::uint8_t>(std::clamp(std::lround(colors.opacity * 255), 1L, 255L));
    const auto distance = static_cast<float>(eye_.distance);
    const auto focal = static_cast<float>(eye_.focal);
    const auto middleX = static_cast<float>(eye_.middle.x());
    const auto middleY = static_cast<float>(eye_.middle.y());

    scratch_.resize(mesh.places.size());
    for (std::size_t i = 0; i < mesh.places.size(); ++i) {
        scratch_[i].view = T * mesh.places[i];
    }
    const Eigen::Vector3f eyeInView(0, 0, distance);
    const auto project = [&](const Eigen::Vector3f& v, float red, float green, float blue) {
        const float near = 1 / (distance - v.z());
        return Vertex{middleX + v.x() * focal * near, middleY - v.y() * focal * near, near, red, green, blue};
    };
    // Compute colours on demand, because half of all vertices belong only to back faces.
    std::vector<std::int8_t>& shaded = shaded_;
    shaded.assign(mesh.places.size(), -1);
    const auto colored = [&](std::uint32_t corner, Material material) -> ScratchVertex& {
        ScratchVertex& s = scratch_[corner];
        if (shaded[corner] != static_cast<std::int8_t>(material)) {
            shaded[corner] = static_cast<std::int8_t>(material);
            const Eigen::Vector3f n = R_base_mesh * mesh.normals[corner];
            const Eigen::Vector3f toEye = R_base_view * (eyeInView - s.view).normalized();
            shade.at(n, toEye, base[static_cast<std::size_t>(material)], s.red, s.green, s.blue);
        }
        return s;
    };
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        const auto& [ia, ib, ic] = triangle.corners;
        const Eigen::Vector3f& a = scratch_[ia].view;
        const Eigen::Vector3f& b = scratch_[ib].view;
        const Eigen::Vector3f& c = scratch_[ic].view;
        if ((b - a).cross(c - a).dot(eyeInView - a) <= 0) {
            continue;  // back face
        }
        std::array<ScratchVertex, 3> corners = {
            colored(ia, triangle.material), colored(ib, triangle.material), colored(ic, triangle.material)};
        const float limit = distance - kNearClip;
        if (a.z() <= limit && b.z() <= limit && c.z() <= limit) {
            std::array<Vertex, 3> v;
            for (std::size_t i = 0; i < 3; ++i) {
                v[i] = project(corners[i].view, corners[i].red, corners[i].green, corners[i].blue);
            }
            addFace(v[0], v[1], v[2], alpha);
            continue;
        }
        // The face is partly behind the eye. Its visible part has up to four corners.
        std::array<Vertex, 4> kept;
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const ScratchVertex& from = corners[i];
            const ScratchVertex& to = corners[(i + 1) % 3];
            if (from.view.z() <= limit) {
                kept[count++] = project(from.view, from.red, from.green, from.blue);
            }
            if ((from.view.z() <= limit) != (to.view.z() <= limit)) {
                const float t = (limit - from.view.z()) / (to.view.z() - from.view.z());
                const Eigen::Vector3f at = from.view + t * (to.view - from.view);
                const auto mix = [t](float p, float q) { return p + t * (q - p); };
                kept[count++] = project(Eigen::Vector3f(at.x(), at.y(), limit), mix(from.red, to.red),
                                        mix(from.green, to.green), mix(from.blue, to.blue));
            }
        }
        for (std::size_t i = 2; i < count; ++i) {
            addFace(kept[0], kept[i - 1], kept[i], alpha);
        }
    }
}

void Rasterizer::addFace(const Vertex& a, const Vertex& b, const Vertex& c, std::uint8_t alpha) {
    const auto [least, most] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const auto width = static_cast<float>(size_.width());
    const auto height = static_cast<float>(size_.height());
    if (!(most >= 0 && least < width && bottom >= 0 && top < height)) {
        return;
    }
    // The vertices are oriented so that the area is positive when the Y axis points down.
    const double area = (double(c.x) - a.x) * (double(b.y) - a.y) - (double(b.x) - a.x) * (double(c.y) - a.y);
    if (!(area > 1e-6)) {
        return;
    }
    Face face;
    const std::array<const Vertex*, 3> corners = {&a, &b, &c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex& p = *corners[i];
        const Vertex& q = *corners[(i + 1) % 3];
        const double ea = double(q.y) - p.y;
        const double eb = double(p.x) - q.x;
        face.a[i] = static_cast<float>(ea);
        face.b[i] = static_cast<float>(eb);
        face.c[i] = -(ea * p.x + eb * p.y);
    }
    const double bx = double(b.x) - a.x;
    const double by = double(b.y) - a.y;
    const double cx = double(c.x) - a.x;
    const double cy = double(c.y) - a.y;
    const auto plane = [&](float va, float vb, float vc) {
        const double db = double(vb) - va;
        const double dc = double(vc) - va;
        return std::array<float, 3>{static_cast<float>((dc * by - db * cy) / area),
                                    static_cast<float>((db * cx - dc * bx) / area), va};
    };
    face.nearPlane = plane(a.near, b.near, c.near);
    face.color = {plane(a.red, b.red, c.red), plane(a.green, b.green, c.green),
                  plane(a.blue, b.blue, c.blue)};
    face.x0 = a.x;
    face.y0 = a.y;
    face.least = {std::min({a.red, b.red, c.red}), std::min({a.green, b.green, c.green}),
                  std::min({a.blue, b.blue, c.blue})};
    face.most = {std::max({a.red, b.red, c.red}), std::max({a.green, b.green, c.green}),
                 std::max({a.blue, b.blue, c.blue})};
    face.left = static_cast<std::int16_t>(std::max(0.0F, std::floor(least)));
    face.right = static_cast<std::int16_t>(std::min(width - 1, std::floor(most)));
    face.top = static_cast<std::int16_t>(std::max(0.0F, std::floor(top)));
    face.bottom = static_cast<std::int16_t>(std::min(height - 1, std::floor(bottom)));
    face.alpha = alpha;
    const auto number = static_cast<std::uint32_t>(faces_.size());
    faces_.push_back(face);
    covered_ |= QRect(QPoint(face.left, face.top), QPoint(face.right, face.bottom));
    for (int row = face.top / kTile; row <= face.bottom / kTile; ++row) {
        for (int column = face.left / kTile; column <= face.right / kTile; ++column) {
            Tile& tile = tiles_[static_cast<std::size_t>(row * columns_ + column)];
            (alpha == 255 ? tile.solids : tile.glasses).push_back(number);
        }
    }
}

const QImage& Rasterizer::render(const QRect& part) {
    const QRect wanted = part & QRect(QPoint(0, 0), size_);
    if (wanted.isEmpty()) {
        return image_;
    }
    for (int row = wanted.top() / kTile; row <= wanted.bottom() / kTile; ++row) {
        for (int column = wanted.left() / kTile; column <= wanted.right() / kTile; ++column) {
            const Tile& tile = tiles_[static_cast<std::size_t>(row * columns_ + column)];
            const int left = column * kTile;
            const int top = row * kTile;
            const bool glass = !tile.glasses.empty();
            clearSamples(glass);
            for (const std::uint32_t number : tile.solids) {
                draw(faces_[number], left, top, false);
            }
            for (const std::uint32_t number : tile.glasses) {
                draw(faces_[number], left, top, true);
            }
            resolve(left, top, wanted, glass);
        }
    }
    return image_;
}

void Rasterizer::clearSamples(bool glass) {
    solidNear_.fill(0);
    solidColor_.fill(0);
    if (glass) {
        glassNear_.fill(0);
        glassColor_.fill(0);
    }
}

void Rasterizer::draw(const Face& face, int left, int top, bool glass) {
    float* const nears = glass ? glassNear_.data() : solidNear_.data();
    std::int32_t* const colors = glass ? glassColor_.data() : solidColor_.data();
    const int y0 = std::max<int>(face.top, top);
    const int y1 = std::min<int>(face.bottom, top + kTile - 1);
    const int x0 = std::max<int>(face.left, left);
    const int x1 = std::min<int>(face.right, left + kTile - 1);
    // Edge functions and depth at the samples of the pixel (0, 0). Samples on an edge belong to both faces,
    // so that no background is visible between them.
    std::array<FourFloats, 3> edgeAt;
    std::array<float, 3> slack;
    std::array<float, 3> edgeRow;
    std::array<float, 3> reciprocal;
    constexpr float kOnEdge = 1e-4F;
    for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 4; ++k) {
            const auto s = static_cast<std::size_t>(k);
            edgeAt[i][k] = face.a[i] * kSampleX[s] + face.b[i] * kSampleY[s] +
                           kOnEdge * (std::abs(face.a[i]) + std::abs(face.b[i]));
        }
        // Maximum of the edge function over all samples of a pixel.
        slack[i] = 0.9F * (std::max(0.0F, face.a[i]) + std::max(0.0F, face.b[i])) +
                   0.1F * (std::abs(face.a[i]) + std::abs(face.b[i]));
        edgeRow[i] = static_cast<float>(double(face.a[i]) * x0 + double(face.b[i]) * y0 + face.c[i]);
        reciprocal[i] = face.a[i] != 0 ? 1 / face.a[i] : 0;
    }
    FourFloats nearAt{};
    for (int k = 0; k < 4; ++k) {
        const auto s = static_cast<std::size_t>(k);
        nearAt[k] = face.nearPlane[0] * kSampleX[s] + face.nearPlane[1] * kSampleY[s];
    }
    const FourFloats zero = four(0.0F);
    FourFloats colorStep = zero;
    FourFloats darkest = zero;
    FourFloats brightest = zero;
    for (int k = 0; k < 3; ++k) {
        const auto channel = static_cast<std::size_t>(k);
        colorStep[k] = face.color[channel][0];
        darkest[k] = face.least[channel];
        brightest[k] = face.most[channel];
    }
    const auto alpha = static_cast<std::int32_t>(std::uint32_t(face.alpha) << 24);
    for (int y = y0; y <= y1; ++y) {
        // Range of pixels in this row that can contain covered samples.
        float from = 0;
        auto to = static_cast<float>(x1 - x0);
        std::array<float, 3> edge;
        for (std::size_t i = 0; i < 3; ++i) {
            edge[i] = edgeRow[i];
            edgeRow[i] += face.b[i];
            const float most = edge[i] + slack[i];
            const float crossed = most * reciprocal[i];
            if (face.a[i] > 0) {
                from = std::max(from, -crossed);
            } else if (face.a[i] < 0) {
                to = std::min(to, -crossed);
            } else if (most < 0) {
                to = -1;
            }
        }
        if (!(from <= to)) {
            continue;
        }
        const int first = x0 + static_cast<int>(from);
        const int last = x0 + static_cast<int>(to);
        from = static_cast<float>(first - x0);
        const float dx = static_cast<float>(first) - face.x0;
        const float dy = static_cast<float>(y) - face.y0;
        const auto planeAt = [dx, dy](const std::array<float, 3>& p) { return p[0] * dx + p[1] * dy + p[2]; };
        float near = planeAt(face.nearPlane);
        // Colour at the centre of the pixel. The centre may be outside the face, so the colour is clamped to
        // the range of the vertex colours.
        FourFloats color = four(0.0F);
        for (int k = 0; k < 3; ++k) {
            const std::array<float, 3>& p = face.color[static_cast<std::size_t>(k)];
            color[k] = planeAt(p) + 0.5F * (p[0] + p[1]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            edge[i] += face.a[i] * from;
        }
        const auto index = static_cast<std::size_t>((y - top) * kTile + (first - left)) * std::size_t{4};
        float* nearHere = nears + index;
        std::int32_t* colorHere = colors + index;
        for (int x = first; x <= last; ++x) {
            FourBits inside =
                both(both(atLeast(four(edge[0]) + edgeAt[0], zero), atLeast(four(edge[1]) + edgeAt[1], zero)),
                     atLeast(four(edge[2]) + edgeAt[2], zero));
            const FourFloats depth = four(near) + nearAt;
            const FourFloats before = load(nearHere);
            inside = both(inside, atLeast(depth, before));
            if (any(inside)) {
                store(nearHere, choose(inside, depth, before));
                const FourFloats shade = all(inside) ? color : larger(smaller(color, brightest), darkest);
                store(colorHere, choose(inside, four(packed(shade) | alpha), load(colorHere)));
            }
            nearHere += 4;
            colorHere += 4;
            edge[0] += face.a[0];
            edge[1] += face.a[1];
            edge[2] += face.a[2];
            near += face.nearPlane[0];
            color = color + colorStep;
        }
    }
}

void Rasterizer::resolve(int left, int top, const QRect& part, bool glass) {
    const QRect inside = QRect(left, top, kTile, kTile) & part;
    for (int y = inside.top(); y <= inside.bottom(); ++y) {
        auto* line = reinterpret_cast<std::uint32_t*>(image_.scanLine(y));
        float* nearestLine =
            nearest_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width());
        for (int x = inside.left(); x <= inside.right(); ++x) {
            const std::size_t index = static_cast<std::size_t>((y - top) * kTile + (x - left)) * 4;
            std::array<std::uint32_t, 4> samples;
            std::memcpy(samples.data(), &solidColor_[index], sizeof samples);
            nearestLine[x] = std::max(std::max(solidNear_[index], solidNear_[index + 1]),
                                      std::max(solidNear_[index + 2], solidNear_[index + 3]));
            if (glass) {
                for (std::size_t k = 0; k < 4; ++k) {
                    const auto over = static_cast<std::uint32_t>(glassColor_[index + k]);
                    if (over != 0 && glassNear_[index + k] > solidNear_[index + k]) {
                        samples[k] = blended(over, samples[k]);
                    }
                }
            }
            line[x] = mean(samples);
        }
    }
}

bool Rasterizer::hides(const QPointF& pixel, double depth) const {
    const int x = static_cast<int>(std::floor(pixel.x() * scale_));
    const int y = static_cast<int>(std::floor(pixel.y() * scale_));
    if (x < 0 || y < 0 || x >= size_.width() || y >= size_.height() || depth <= 0) {
        return false;
    }
    constexpr double kSkin = 1.004;  // tolerance, so that a surface does not hide objects on it
    const float nearest = nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width()) +
                                   static_cast<std::size_t>(x)];
    return static_cast<double>(nearest) > kSkin / depth;
}

}  // namespace tiller
