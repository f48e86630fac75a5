// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces made of triangles, and the few ways in which the scene makes them: turned on a lathe, or a box.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tiller {

/// What a surface is painted with; the colours belong to the picture, not to the shape.
enum class Material : std::uint8_t { Housing, Tube, Lid, Seal, Flange, Tool, Cell };
inline constexpr int kMaterialCount = 7;

/// Corners go round counter-clockwise seen from outside.
struct Mesh {
    struct Triangle {
        std::array<std::uint32_t, 3> corners;
        Material material;
    };
    std::vector<Eigen::Vector3f> places;   ///< [m]
    std::vector<Eigen::Vector3f> normals;  ///< of length 1, one a place
    std::vector<Triangle> triangles;
};

/// A point of an outline that is turned about the Z axis.
struct LathePoint {
    double radius;  ///< [m]
    double z;       ///< [m]
};

/// Turns an outline about the Z axis of `T_mesh_axis`. Points go along +Z where the surface faces outwards;
/// corners sharper than 35 degrees stay sharp.
/// segments  around the axis
void addLathe(Mesh& mesh, const Eigen::Isometry3d& T_mesh_axis, std::span<const LathePoint> outline,
              int segments, Material material);

/// A drum between two heights, with edges rounded by `fillet` [m].
std::vector<LathePoint> drumOutline(double radius, double low, double high, double fillet);

/// Edges along the axes of `T_mesh_box`, around its origin.
/// size  whole edges [m]
void addBox(Mesh& mesh, const Eigen::Isometry3d& T_mesh_box, const Eigen::Vector3d& size, Material material);

}  // namespace tiller
