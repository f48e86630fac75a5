// SPDX-License-Identifier: MIT
#pragma once

// How lengths, speeds and rotations are written on the screen, as the operator chose. Inside everything stays
// SI; the choice is made here and nowhere else.

#include <Eigen/Core>
#include <QString>
#include <array>

#include "robot/core/spatial.h"

class QCoreApplication;

namespace tiller {

enum class LengthUnit { Millimetres, Inches };
enum class RotationNotation {
    RollPitchYaw,    ///< degrees
    RotationVector,  ///< radians, as scripts write it
};

struct Notation {
    LengthUnit length = LengthUnit::Millimetres;
    RotationNotation rotation = RotationNotation::RollPitchYaw;

    /// The one set last.
    /// Threads  GUI
    static Notation current();
    friend bool operator==(const Notation&, const Notation&) = default;
};

/// Sets Notation::current(). Windows call applyNotation() (widgets/common/apply_notation.h), which also repaints.
/// Threads  GUI
void setNotation(QCoreApplication& application, const Notation& notation);

namespace format {

/// metres -> "200.00 mm" or "7.874 in"
/// digits  of the millimetres; inches get one more
QString length(double metres, int digits = 2);
/// The same without the unit; a plus sign too, if asked for.
QString lengthNumber(double metres, int digits, bool withSign);
/// With as few digits as needed: "10 mm", "0.05 mm", "0.39 in".
QString shortLength(double metres);
QString shortLengthNumber(double metres);
/// "mm", "in"
QString lengthUnit();
/// One unit of length as shown [m]: 0.001 or 0.0254. What is typed times this is metres.
double metresPerUnit();

/// metres per second -> "250 mm/s" or "9.84 in/s"
QString speed(double metresPerSecond);
QString speedNumber(double metresPerSecond);
/// "mm/s", "in/s"
QString speedUnit();

/// rotationVector  [rad]
/// Returns         three numbers with unit: "179.94°" or "3.1406"
std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector);
/// As rotation(), with the unit behind the last one only.
std::array<QString, 3> rotationFigures(const Eigen::Vector3d& rotationVector);

/// "X 120.00 Y 80.00 Z 150.00 mm"
QString position(const Eigen::Vector3d& metres);
/// "X 120.00 Y 80.00 Z 150.00 mm RX 180.00 RY 0.00 RZ 0.00°"
QString pose(const Pose& pose);
/// How far apart two poses are: "61.2 mm, 4.1°"
QString difference(double metres, double radians);
/// Difference between two positions: "ΔX +1.20 ΔY 0.00 ΔZ −3.00 mm"
QString shift(const Eigen::Vector3d& metres);

}  // namespace format

}  // namespace tiller
