// SPDX-License-Identifier: MIT
#pragma once

// What the hand may move in freedrive, and whether the arm can be trusted to hold its load meanwhile.

#include <QString>
#include <array>

#include "robot/control/compliance.h"
#include "robot/station/link/session_state.h"

namespace tiller {

enum class FreedriveAxes {
    All,
    Position,     ///< the tool keeps its orientation
    Orientation,  ///< the TCP stays where it is
    Plane,        ///< along X and Y of the chosen frame
    Line,         ///< along Z of the chosen frame
};
inline constexpr std::array kFreedriveAxes = {FreedriveAxes::All, FreedriveAxes::Position,
                                              FreedriveAxes::Orientation, FreedriveAxes::Plane,
                                              FreedriveAxes::Line};

/// "All axes", "Position only" ...
QString freedriveAxesText(FreedriveAxes axes);
/// R_base_frame  the chosen frame's axes; the tool's own point is the origin
control::Freedrive freedriveOf(FreedriveAxes axes, const Eigen::Matrix3d& R_base_frame, const Pose& tcp);

/// Force and torque that an arm at rest may feel with nobody touching it: above the noise of every model.
inline constexpr double kPayloadForce = 12;  ///< [N]
inline constexpr double kPayloadTorque = 2;  ///< [Nm]

/// Why freedrive had better not begin: the arm feels what is not there, so it would sink or rise by itself.
/// Empty when nothing speaks against it.
QString payloadDoubt(const SessionState& state);

}  // namespace tiller
