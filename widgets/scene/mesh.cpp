// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiller {

void addLathe(Mesh& mesh, const Eigen::Isometry3d& T_mesh_axis, std::span<const LathePoint> outline,
              int segments, Material material) {
    constexpr double kCrease = 0.82;  // cosine of 35 degrees
    if (outline.size() < 2) {
        return;
    }
    // The normal of the outline in (radius, z) points to the right of the direction of the outline.
    const auto normalOf = [&](std::size_t from) -> Eigen::Vector2d {
        const Eigen::Vector2d along(outline[from + 1].radius - outline[from].radius,
                                    outline[from + 1].z - outline[from].z);
        return Eigen::Vector2d(along.y(), -along.x()).normalized();
    };
    const auto addRing = [&](const LathePoint& point, const Eigen::Vector2d& normal) {
        const auto first = static_cast<std::uint32_t>(mesh.places.size());
        for (int i = 0; i < segments; ++i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
            const Eigen::Vector3d place = out * point.radius + Eigen::Vector3d::UnitZ() * point.z;
            const Eigen::Vector3d direction = out * normal.x() + Eigen::Vector3d::UnitZ() * normal.y();
            mesh.places.push_back((T_mesh_axis * place).cast<float>());
            mesh.normals.push_back((T_mesh_axis.linear() * direction).cast<float>());
        }
        return first;
    };
    const std::size_t last = outline.size() - 1;
    std::uint32_t below = 0;
    for (std::size_t i = 0; i < last; ++i) {
        const Eigen::Vector2d normal = normalOf(i);
        const auto meets = [&](std::size_t other) {
            const Eigen::Vector2d next = normalOf(other);
            return next.dot(normal) > kCrease ? Eigen::Vector2d((next + normal).normalized()) : normal;
        };
        const bool goesOn = i > 0 && normalOf(i - 1).dot(normal) > kCrease;
        if (!goesOn) {
            below = addRing(outline[i], normal);
        }
        const std::uint32_t above = addRing(outline[i + 1], i + 1 < last ? meets(i + 1) : normal);
        for (int k = 0; k < segments; ++k) {
            const auto a = static_cast<std::uint32_t>(k);
            const auto b = static_cast<std::uint32_t>((k + 1) % segments);
            if (outline[i].radius > 0) {
                mesh.triangles.push_back({{below + a, below + b, above + b}, material});
            }
            if (outline[i + 1].radius > 0) {
                mesh.triangles.push_back({{below + a, above + b, above + a}, material});
            }
        }
        below = above;
    }
}

std::vector<LathePoint> drumOutline(double radius, double low, double high, double fillet) {
    constexpr int kSteps = 2;
    const double f = std::min({fillet, radius, (high - low) / 2});
    std::vector<LathePoint> outline = {{0, low}};
    const auto arc = [&](double z, double from) {
        for (int i = 0; i <= kSteps; ++i) {
            const double angle = from + std::numbers::pi / 2 * i / kSteps;
            outline.push_back({radius - f + f * std::cos(angle), z + f * std::sin(angle)});
        }
    };
    arc(low + f, -std::numbers::pi / 2);
    arc(high - f, 0);
    outline.push_back({0, high});
    return outline;
}

void addBox(Mesh& mesh, const Eigen::Isometry3d& T_mesh_box, const Eigen::Vector3d& size, Material material) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis) * side;
            const Eigen::Vector3d u = Eigen::Vector3d::Unit((axis + 1) % 3) * side;
            const Eigen::Vector3d v = Eigen::Vector3d::Unit((axis + 2) % 3);
            const auto first = static_cast<std::uint32_t>(mesh.places.size());
            for (const auto& [a, b] :
                 {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
                const Eigen::Vector3d corner = normal + u * a + v * b;
                mesh.places.push_back(
                    (T_mesh_box * Eigen::Vector3d(corner.cwiseProduct(size) / 2)).cast<float>());
                mesh.normals.push_back((T_mesh_box.linear() * normal).cast<float>());
            }
            mesh.triangles.push_back({{first, first + 1, first + 2}, material});
            mesh.triangles.push_back({{first, first + 2, first + 3}, material});
        }
    }
}

}  // namespace tiller
