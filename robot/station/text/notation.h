// SPDX-License-Identifier: MIT
#pragma once

// Formats lengths, speeds and rotations in the units chosen by the operator. All internal values are in SI
// units. Only this file converts them.

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

    /// The notation set with setNotation().
    /// Threads  GUI
    static Notation current();
    friend bool operator==(const Notation&, const Notation&) = default;
};

/// Sets Notation::current(). Windows call applyNotation() (widgets/common/apply_notation.h), which also
/// repaints.
/// Threads  GUI
void setNotation(QCoreApplication& application, const Notation& notation);

namespace format {

/// Example: "200.00 mm" or "7.874 in" for 0.2.
/// digits  decimal places of millimetres; inches have one more
QString length(double metres, int digits = 2);
/// Like length(), without the unit and optionally with a plus sign.
QString lengthNumber(double metres, int digits, bool withSign);
/// Like length(), with as few digits as possible: "10 mm", "0.05 mm", "0.39 in".
QString shortLength(double metres);
QString shortLengthNumber(double metres);
/// "mm" or "in".
QString lengthUnit();
/// Length of one display unit [m]: 0.001 or 0.0254. Converts an entered value to metres.
double metresPerUnit();

/// Example: "250 mm/s" or "9.84 in/s" for 0.25.
QString speed(double metresPerSecond);
QString speedNumber(double metresPerSecond);
/// "mm/s" or "in/s".
QString speedUnit();

/// rotationVector  [rad]
/// Returns         three numbers, e.g. "179.94°" or "3.1406"
std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector);
/// Like rotation(), with the unit after the last number only.
std::array<QString, 3> rotationNumbers(const Eigen::Vector3d& rotationVector);

/// Example: "X 120.00 Y 80.00 Z 150.00 mm".
QString position(const Eigen::Vector3d& metres);
/// Example: "X 120.00 Y 80.00 Z 150.00 mm RX 180.00 RY 0.00 RZ 0.00°".
QString pose(const Pose& pose);
/// Distance between two poses, e.g. "61.2 mm, 4.1°".
QString difference(double metres, double radians);
/// Difference between two positions, e.g. "ΔX +1.20 ΔY 0.00 ΔZ −3.00 mm".
QString shift(const Eigen::Vector3d& metres);

}  // namespace format

}  // namespace tiller
