// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangle meshes, and functions that create them: solids of revolution and boxes.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tiller {

/// Material of a surface. BodyColors defines its colour.
enum class Material : std::uint8_t { Housing, Tube, Lid, Seal, Flange, Tool, Cell };
inline constexpr int kMaterialCount = 7;

/// The vertices of a triangle are counter-clockwise when seen from outside.
struct Mesh {
    struct Triangle {
        std::array<std::uint32_t, 3> corners;
        Material material;
    };
    std::vector<Eigen::Vector3f> places;   ///< [m]
    std::vector<Eigen::Vector3f> normals;  ///< unit vectors, one per vertex
    std::vector<Triangle> triangles;
};

/// A point of an outline that is rotated about the Z axis.
struct LathePoint {
    double radius;  ///< [m]
    double z;       ///< [m]
};

/// Rotates an outline about the Z axis of `T_mesh_axis`. If the points are ordered along +Z, the surface
/// faces outwards. Corners sharper than 35 degrees are not smoothed.
/// segments  number of segments around the axis
void addLathe(Mesh& mesh, const Eigen::Isometry3d& T_mesh_axis, std::span<const LathePoint> outline,
              int segments, Material material);

/// Outline of a cylinder between two heights, with edges rounded by `fillet` [m].
std::vector<LathePoint> drumOutline(double radius, double low, double high, double fillet);

/// Adds a box whose edges are parallel to the axes of `T_mesh_box`, centred at its origin.
/// size  edge lengths [m]
void addBox(Mesh& mesh, const Eigen::Isometry3d& T_mesh_box, const Eigen::Vector3d& size, Material material);

}  // namespace tiller
