// SPDX-License-Identifier: MIT
#pragma once

// Estimates the payload at the flange from force sensor readings at standstill in several poses. The zero offset of
// the sensor and the mounting of the arm are estimated together with the payload.

#include <Eigen/Core>
#include <span>

#include "robot/core/spatial.h"

namespace tiller::kinematics {

inline constexpr double kStandardGravity = 9.82;  ///< value used by the controller [m/s2]

/// A reading at standstill without external contact.
struct PayloadReading {
    Eigen::Matrix3d R_base_flange = Eigen::Matrix3d::Identity();
    /// Force and torque about the flange, in its frame [N, Nm]. Zero the sensor for all readings or none.
    Wrench felt;
};

inline constexpr int kMinPayloadPoses = 4;
/// Minimum rotation about a second axis, as defined for kMinTipSpread.
inline constexpr double kMinPayloadSpread = 0.15;

struct PayloadEstimate {
    enum class Problem {
        None,
        TooFew,     ///< fewer than kMinPayloadPoses
        NotFinite,  ///< a reading is not finite, e.g. because the robot does not send forces
        TooAlike,   ///< the flange was rotated too little, or about one axis only
        NoWeight,   ///< too light for the sensor; the mass is valid, the centre of gravity is not
    };
    Problem problem = Problem::TooFew;
    double mass = 0;                                   ///< [kg]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of gravity in the flange frame [m]
    Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();  ///< direction of gravity in the base frame
    Wrench zero;                                       ///< reading without a load
    double forceResidual = 0;                          ///< rms over the poses [N]
    double torqueResidual = 0;                         ///< rms over the poses [Nm]
    int worst = 0;                                     ///< index of the pose with the largest residual
    double spread = 0;                                 ///< see kMinPayloadSpread

    bool ok() const {
        return problem == Problem::None;
    }  ///< True if mass and centre of gravity were determined.
};

/// Below this mass the centre of gravity is dominated by noise [kg].
inline constexpr double kMinPayloadMass = 0.1;

/// Threads  any. Real-time: no (allocates)
PayloadEstimate estimatePayload(std::span<const PayloadReading> readings, double gravity = kStandardGravity);

/// Wrench about the flange in the flange frame, for controllers that do not report the raw reading. It is
/// computed from the wrench at the TCP in the base frame, from which the controller has subtracted the known
/// payload.
/// mass, centre  mass [kg] and centre of gravity [m] of this payload
/// down          direction of gravity in the base frame
Wrench feltAtFlange(const Wrench& atTcp, const Eigen::Matrix3d& R_base_flange, const Eigen::Vector3d& tcp,
                    double mass, const Eigen::Vector3d& centre, const Eigen::Vector3d& down,
                    double gravity = kStandardGravity);

}  // namespace tiller::kinematics
