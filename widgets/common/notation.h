// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How lengths and rotations are written on the screen, as the operator chose. Inside everything stays SI; the
// choice is made here and nowhere else.

#include <Eigen/Core>
#include <QString>
#include <array>

class QApplication;

namespace tiller {

enum class LengthUnit { Millimetres, Inches };
enum class RotationNotation {
    RollPitchYaw,    ///< degrees
    RotationVector,  ///< radians, as scripts write it
};

struct Notation {
    LengthUnit length = LengthUnit::Millimetres;
    RotationNotation rotation = RotationNotation::RollPitchYaw;

    /// The one applied last.
    /// Threads  GUI
    static Notation current();
    friend bool operator==(const Notation&, const Notation&) = default;
};

/// Sets it and lets every widget show its numbers anew (QEvent::StyleChange).
/// Threads  GUI
void applyNotation(QApplication& application, const Notation& notation);

namespace format {

/// metres -> "200.00 mm" or "7.874 in"
/// digits  of the millimetres; inches get one more
QString length(double metres, int digits = 2);
/// The same without the unit; a plus sign too, if asked for.
QString lengthNumber(double metres, int digits, bool withSign);
/// "mm", "in"
QString lengthUnit();
/// rotationVector  [rad]
/// Returns         three numbers with unit: "179.94°" or "3.1406"
std::array<QString, 3> rotation(const Eigen::Vector3d& rotationVector);

}  // namespace format

}  // namespace tiller
