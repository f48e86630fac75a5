// SPDX-License-Identifier: MIT
#pragma once

// Axes in which the arm can be moved by hand in freedrive, and the check whether the arm can hold its load in
// freedrive.

#include <QString>
#include <array>

#include "robot/control/compliance.h"
#include "robot/station/link/session_state.h"

namespace tiller {

enum class FreedriveAxes {
    All,
    Position,     ///< the tool keeps its orientation
    Orientation,  ///< the TCP keeps its position
    Plane,        ///< motion along X and Y of the chosen frame
    Line,         ///< motion along Z of the chosen frame
};
inline constexpr std::array kFreedriveAxes = {FreedriveAxes::All, FreedriveAxes::Position,
                                              FreedriveAxes::Orientation, FreedriveAxes::Plane,
                                              FreedriveAxes::Line};

/// Label of the selection, e.g. "All axes", "Position only".
QString freedriveAxesText(FreedriveAxes axes);
/// R_base_frame  axes of the selected frame; the origin is the TCP
control::Freedrive freedriveOf(FreedriveAxes axes, const Eigen::Matrix3d& R_base_frame, const Pose& tcp);

/// Maximum force and torque of an arm at rest without contact. Exceeds the noise of every model.
inline constexpr double kPayloadForce = 12;  ///< [N]
inline constexpr double kPayloadTorque = 2;  ///< [Nm]

/// Why freedrive should not start: the arm is moving, or it measures a force without contact, so it would
/// drift. Empty if freedrive can start.
QString payloadDoubt(const SessionState& state);

}  // namespace tiller
