// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/arm_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/collision/arm_body.h"

namespace tiller {

namespace {

constexpr int kBigSegments = 28;
constexpr int kSmallSegments = 22;
constexpr double kDrumHalf = 1.08;  // half length of a joint housing, as a multiple of its radius
constexpr double kGap = 0.045;      // gap between two rotating housings, as a multiple of their radius

/// Returns a frame at this position with this Z axis.
Eigen::Isometry3d axisAt(const Eigen::Vector3d& origin, const Eigen::Vector3d& z) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z).toRotationMatrix();
    T.translation() = origin;
    return T;
}

/// Adds a joint housing, a cylinder about the joint axis. `lid` points to the end with the lid. The other end
/// rotates against the adjacent housing.
void addJoint(Mesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& lid, double radius,
              double toLid, double toSeal, int segments) {
    const Eigen::Isometry3d T = axisAt(centre, lid);
    addLathe(mesh, T, drumOutline(radius, -toSeal, toLid, 0.10 * radius), segments, Material::Housing);
    // The lid has a step and a groove around its middle, and is slightly domed.
    const double foot = toLid - 0.02 * radius;
    const double height = 0.17 * radius;
    std::vector<LathePoint> outline = {{0.90 * radius, foot}, {0.90 * radius, foot + 0.45 * height}};
    constexpr int kSteps = 3;
    for (int i = 1; i <= kSteps; ++i) {
        const double angle = std::numbers::pi / 2 * i / kSteps;
        outline.push_back(
            {(0.72 + 0.18 * std::cos(angle)) * radius, foot + height * (0.45 + 0.55 * std::sin(angle))});
    }
    outline.push_back({0, foot + 1.08 * height});
    addLathe(mesh, T, outline, segments, Material::Lid);
}

/// Adds the dark ring in the gap between two housings, and the rim of the adjacent housing.
void addSeal(Mesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             int segments) {
    const Eigen::Vector3d way = to - from;
    const std::vector<LathePoint> outline = {{radius, 0}, {radius, way.norm()}};
    addLathe(mesh, axisAt(from, way.normalized()), outline, segments, Material::Seal);
}

/// Adds a tube that widens at its ends.
/// startHousing, endHousing  radii of the adjacent housings [m]
void addTube(Mesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             double startHousing, double endHousing, int segments) {
    const Eigen::Vector3d way = to - from;
    const double length = way.norm();
    // Each end has a clamp as wide as the housing, with a short conical transition to the tube.
    const double startClamp = std::min(0.97 * startHousing, 1.16 * radius);
    const double endClamp = std::min(0.97 * endHousing, 1.16 * radius);
    const double startEnd = std::min(1.36 * startHousing, 0.42 * length);
    const double endBegin = length - std::min(1.40 * endHousing, 0.42 * length);
    const double cone = 0.14 * radius;
    const double seam = 0.05 * radius;
    const Eigen::Isometry3d T = axisAt(from, way.normalized());
    const auto piece = [&](std::initializer_list<LathePoint> outline, Material material) {
        addLathe(mesh, T, std::vector<LathePoint>(outline), segments, material);
    };
    piece({{startClamp, 0}, {startClamp, startEnd}, {0.96 * startClamp, startEnd + 0.03 * radius}},
          Material::Housing);
    piece({{0.96 * startClamp, startEnd + 0.03 * radius},
           {0.96 * startClamp, startEnd + seam},
           {radius, startEnd + seam}},
          Material::Seal);
    piece({{1.02 * radius, startEnd + seam},
           {radius, startEnd + seam + cone},
           {radius, endBegin - seam - cone},
           {1.02 * radius, endBegin - seam}},
          Material::Tube);
    piece({{radius, endBegin - seam},
           {0.96 * endClamp, endBegin - seam},
           {0.96 * endClamp, endBegin - 0.03 * radius}},
          Material::Seal);
    piece({{0.96 * endClamp, endBegin - 0.03 * radius}, {endClamp, endBegin}, {endClamp, length}},
          Material::Housing);
}

/// Adds a short neck from the side of a housing to the next joint. The neck has the radius of the housing.
void addNeck(Mesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             int segments) {
    const Eigen::Vector3d way = to - from;
    const double length = way.norm();
    const double f = 0.10 * radius;
    const std::vector<LathePoint> outline = {{radius, 0},
                                             {radius, length - f},
                                             {radius - 0.3 * f, length - 0.3 * f},
                                             {radius - f, length},
                                             {0, length}};
    addLathe(mesh, axisAt(from, way.normalized()), outline, segments, Material::Housing);
}

}  // namespace

ArmMesh armMesh(const RobotModel& model) {
    const collision::ArmProportions p = collision::armProportions(model);
    const DhParameters& dh = model.dh;
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    const double upper = std::abs(dh.a[1]);
    const double fore = std::abs(dh.a[2]);
    const double shoulder = p.shoulderRadius;
    const double elbow = p.elbowRadius;
    const double wrist = p.wristRadius;
    ArmMesh links;

    // Base: a foot on the ground and the housing of joint 1.
    {
        const double foot = std::min(0.22 * p.baseRadius, 0.4 * p.baseHeight);
        Mesh& mesh = links[0];
        addLathe(mesh, axisAt(Eigen::Vector3d::Zero(), z),
                 drumOutline(1.12 * p.baseRadius, 0, foot, 0.05 * p.baseRadius), kBigSegments,
                 Material::Flange);
        addLathe(mesh, axisAt(Eigen::Vector3d::Zero(), z),
                 drumOutline(p.baseRadius, 0.5 * foot, p.baseHeight, 0.07 * p.baseRadius), kBigSegments,
                 Material::Housing);
        addSeal(mesh, z * (p.baseHeight - 0.01 * shoulder), z * (p.baseHeight + kGap * shoulder),
                0.95 * shoulder, kBigSegments);
    }
    // Shoulder: the vertical joint 1 with its lid on top, and the connection to joint 2.
    const double joint2Inner = p.shoulderOffset - kDrumHalf * shoulder;
    {
        Mesh& mesh = links[1];
        const double down = dh.d[0] - p.baseHeight - kGap * shoulder;
        addJoint(mesh, Eigen::Vector3d::Zero(), y, shoulder, 1.05 * shoulder, down, kBigSegments);
        addNeck(mesh, z * 0.0, z * (joint2Inner - kGap * shoulder), 0.96 * shoulder, kBigSegments);
        addSeal(mesh, z * (joint2Inner - (kGap + 0.02) * shoulder), z * (joint2Inner + 0.02 * shoulder),
                0.90 * shoulder, kBigSegments);
    }
    // Upper arm: joints 2 and 3 with their lids on the outer side, connected by a tube.
    const double joint3Inner = p.shoulderOffset - kDrumHalf * elbow;
    {
        Mesh& mesh = links[2];
        const Eigen::Vector3d start = x * upper + z * p.shoulderOffset;
        const Eigen::Vector3d end = z * p.shoulderOffset;
        addJoint(mesh, start, z, shoulder, kDrumHalf * shoulder, kDrumHalf * shoulder, kBigSegments);
        addJoint(mesh, end, z, elbow, kDrumHalf * elbow, kDrumHalf * elbow, kBigSegments);
        addTube(mesh, start, end, p.upperRadius, shoulder, elbow, kBigSegments);
    }
    // Forearm: a round elbow on joint 3, a tube, and joint 4 with its lid on the inner side.
    const double joint4Outer = p.elbowOffset + 1.25 * wrist;
    {
        Mesh& mesh = links[3];
        const Eigen::Vector3d start = x * fore + z * p.elbowOffset;
        const Eigen::Vector3d end = z * p.elbowOffset;
        const double top = joint3Inner - p.elbowOffset - kGap * elbow;
        const double r = 0.96 * elbow;
        // A dome closes the inner side, because this part contains no motor.
        std::vector<LathePoint> outline;
        constexpr int kSteps = 5;
        const double dome = 0.95 * r;
        for (int i = 0; i <= kSteps; ++i) {
            const double angle = std::numbers::pi / 2 * (i - kSteps) / kSteps;
            outline.push_back({i == 0 ? 0 : r * std::cos(angle), -0.1 * r + dome * std::sin(angle)});
        }
        outline.push_back({r, top - 0.08 * r});
        outline.push_back({0.93 * r, top});
        outline.push_back({0, top});
        addLathe(mesh, axisAt(start, z), outline, kBigSegments, Material::Housing);
        addSeal(mesh, x * fore + z * (joint3Inner - (kGap + 0.02) * elbow),
                x * fore + z * (joint3Inner + 0.02 * elbow), 0.90 * elbow, kBigSegments);
        addTube(mesh, start, end, p.foreRadius, 0.92 * elbow, wrist, kBigSegments);
        addJoint(mesh, end, -z, wrist, kDrumHalf * wrist, joint4Outer - p.elbowOffset, kSmallSegments);
    }
    // Wrist 1: from joint 4 to joint 5. The lid of joint 5 is opposite wrist 2.
    {
        Mesh& mesh = links[4];
        const double start = joint4Outer - dh.d[3];
        addSeal(mesh, y * (start - 0.02 * wrist), y * (start + (kGap + 0.02) * wrist), 0.90 * wrist,
                kSmallSegments);
        addNeck(mesh, y * 0.0, y * (start + kGap * wrist), 0.96 * wrist, kSmallSegments);
        addJoint(mesh, Eigen::Vector3d::Zero(), -z, wrist, kDrumHalf * wrist, 1.25 * wrist, kSmallSegments);
    }
    // Wrist 2: from joint 5 to joint 6. The lid of joint 6 is opposite the tool.
    {
        Mesh& mesh = links[5];
        const double start = dh.d[4] - 1.25 * wrist;
        addSeal(mesh, y * (start + 0.02 * wrist), y * (start - (kGap + 0.02) * wrist), 0.90 * wrist,
                kSmallSegments);
        addNeck(mesh, y * 0.0, y * (start - kGap * wrist), 0.96 * wrist, kSmallSegments);
        addJoint(mesh, Eigen::Vector3d::Zero(), -z, wrist, kDrumHalf * wrist, 1.12 * wrist, kSmallSegments);
    }
    // Wrist 3: the tool flange with the connector on its side.
    {
        Mesh& mesh = links[6];
        const double start = 1.12 * wrist - dh.d[5];
        const double r = p.flangeRadius;
        const double ring = 0.26 * r;
        addSeal(mesh, z * (start - 0.02 * wrist), z * (start + (kGap + 0.02) * wrist), 0.86 * wrist,
                kSmallSegments);
        addLathe(mesh, axisAt(Eigen::Vector3d::Zero(), z),
                 drumOutline(1.02 * r, start + kGap * wrist, -ring, 0.10 * r), kSmallSegments,
                 Material::Housing);
        addLathe(mesh, axisAt(Eigen::Vector3d::Zero(), z),
                 drumOutline(0.94 * r, -ring - 0.05 * r, 0, 0.05 * r), kSmallSegments, Material::Flange);
        const double plug = 0.20 * r;
        addLathe(mesh, axisAt(y * (0.85 * r) - z * (1.9 * ring), y),
                 drumOutline(plug, 0, 0.30 * r, 0.2 * plug), 16, Material::Seal);
    }
    return links;
}

}  // namespace tiller
