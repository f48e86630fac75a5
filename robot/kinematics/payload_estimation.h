// SPDX-License-Identifier: MIT
#pragma once

// What hangs at the flange, from what the force sensor feels while the arm stands in several poses. The zero of the
// sensor and the mounting of the arm need not be known: both are found along with the payload.

#include <Eigen/Core>
#include <span>

#include "robot/core/spatial.h"

namespace tiller::kinematics {

inline constexpr double kStandardGravity = 9.82;  ///< [m/s2] as the controller has it

/// At standstill, with nothing else touching the tool.
struct PayloadReading {
    Eigen::Matrix3d R_base_flange = Eigen::Matrix3d::Identity();
    Wrench
        felt;  ///< force and torque about the flange, in its axes; zeroed or not, but alike in all readings
};

inline constexpr int kLeastPayloadPoses = 4;
/// The least share of a turn about a second axis, as kLeastTipSpread.
inline constexpr double kLeastPayloadSpread = 0.15;

struct PayloadEstimate {
    enum class Problem {
        None,
        TooFew,     ///< fewer than kLeastPayloadPoses
        NotFinite,  ///< the robot sends no force
        TooAlike,   ///< the flange is turned too little, or about one axis only
        NoWeight,   ///< lighter than a sensor can tell; the mass is good, its centre is not
    };
    Problem problem = Problem::TooFew;
    double mass = 0;                                   ///< [kg]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of gravity, from the flange in its axes [m]
    Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();  ///< where it is pulled to, in the base frame
    Wrench zero;                                       ///< what the sensor shows without a load
    double forceResidual = 0;                          ///< rms over the poses [N]
    double torqueResidual = 0;                         ///< rms over the poses [Nm]
    int worst = 0;                                     ///< pose that fits least
    double spread = 0;                                 ///< see kLeastPayloadSpread

    bool ok() const { return problem == Problem::None; }  ///< Mass and centre are known.
};

/// Below this the centre is lost in the noise [kg].
inline constexpr double kLeastPayloadMass = 0.1;

/// Threads  any. Real-time: no (allocates)
PayloadEstimate estimatePayload(std::span<const PayloadReading> readings, double gravity = kStandardGravity);

/// What the sensor feels about the flange, in its axes, from what a controller without the raw reading reports: the
/// wrench at the TCP in the base frame, from which it has taken the payload it knows of.
/// mass, centre  of that payload; down  where the weight pulls, in the base frame
Wrench feltAtFlange(const Wrench& atTcp, const Eigen::Matrix3d& R_base_flange, const Eigen::Vector3d& tcp,
                    double mass, const Eigen::Vector3d& centre, const Eigen::Vector3d& down,
                    double gravity = kStandardGravity);

}  // namespace tiller::kinematics
