// SPDX-License-Identifier: MIT
#pragma once

// Formats lengths, speeds and rotations in the units chosen by the operator. All values are SI internally;
// only this file applies the choice.

#include <Eigen/Core>
#include <QString>
#include <array>

#include "robot/core/spatial.h"

class QCoreApplication;

namespace tiller {

enum class LengthUnit { Millimetres, Inches };
enum class RotationNotation {
    RollPitchYaw,    ///< degrees
    RotationVector,  ///< radians, as in scripts
};

struct Notation {
    LengthUnit length = LengthUnit::Millimetres;
    RotationNotation rotation = RotationNotation::RollPitchYaw;

    /// The notation set last.
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
/// As above without the unit, optionally with a plus sign.
QString lengthNumber(double metres, int digits, bool withSign);
/// With as few digits as needed: "10 mm", "0.05 mm", "0.39 in".
QString shortLength(double metres);
QString shortLengthNumber(double metres);
/// "mm", "in"
QString lengthUnit();
/// One displayed unit of length [m]: 0.001 or 0.0254. Entered value times this is metres.
double metresPerUnit();

/// metres per second -> "250 mm/s" or "9.84 in/s"
QString speed(double metresPerSecond);
QString speedNumber(double metresPerSecond);
/// "mm/s", "in/s"
QString speedUnit();

/// rotationVector  [rad]
/// Returns         three numbers with unit: "179.94°" or "3.1406"
std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector);
/// As rotation(), with the unit after the last number only.
std::array<QString, 3> rotationNumbers(const Eigen::Vector3d& rotationVector);

/// "X 120.00 Y 80.00 Z 150.00 mm"
QString position(const Eigen::Vector3d& metres);
/// "X 120.00 Y 80.00 Z 150.00 mm RX 180.00 RY 0.00 RZ 0.00°"
QString pose(const Pose& pose);
/// Distance between two poses: "61.2 mm, 4.1°"
QString difference(double metres, double radians);
/// Difference between two positions: "ΔX +1.20 ΔY 0.00 ΔZ −3.00 mm"
QString shift(const Eigen::Vector3d& metres);

}  // namespace format

}  // namespace tiller
