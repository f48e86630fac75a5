// SPDX-License-Identifier: MIT
#pragma once

// The arms this project knows: kinematics, limits, masses and identity, as data.
// Source: Universal Robots' DH-parameter article and description files; see each figure's note in
// robot_model.cpp.

#include <QString>
#include <array>
#include <optional>
#include <span>

#include "robot/core/joints.h"
#include "robot/core/text.h"

namespace tiller {

/// Classic Denavit-Hartenberg parameters, and Hayati's beta: T(i-1,i) = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta).
struct DhParameters {
    std::array<double, 6> a{};      ///< [m]
    std::array<double, 6> d{};      ///< [m]
    std::array<double, 6> alpha{};  ///< [rad]
    std::array<double, 6> theta{};  ///< joint offsets of a calibrated robot [rad]
    /// Where the axes of a calibrated robot are not quite parallel [rad]: see kinematics/parallel_axes.h
    std::array<double, 6> beta{};

    bool operator==(const DhParameters&) const = default;
};

/// One link, in its own DH frame: mass [kg], centre of mass [m],
/// inertia about the centre of mass ixx, ixy, ixz, iyy, iyz, izz [kg m2].
struct LinkInertia {
    double mass = 0;
    std::array<double, 3> centreOfMass{};
    std::array<double, 6> inertia{};
};

enum class RobotModelId {
    UR3,
    UR5,
    UR10,
    UR3e,
    UR5e,
    UR7e,
    UR10e,
    UR12e,
    UR16e,
    UR8Long,
    UR15,
    UR18,
    UR20,
    UR30
};

struct RobotModel {
    RobotModelId id = RobotModelId::UR5e;
    const char* name = "";           ///< "UR5e"
    const char* dashboardName = "";  ///< what `get robot model` answers: "UR5"
    int robotType = 0;               ///< ConfigurationData robot_type
    double reach = 0;                ///< [m]
    double maxPayload = 0;           ///< [kg]
    DhParameters dh;
    std::array<double, 6> maxJointSpeed{};     ///< [rad/s], the robot's own limit
    std::array<double, 6> maxTorque{};         ///< [Nm]
    std::array<double, 6> torquePerCurrent{};  ///< [Nm/A], joint side
    std::array<LinkInertia, 6> links;

    bool isCb3() const {  ///< UR3, UR5, UR10.
        return id == RobotModelId::UR3 || id == RobotModelId::UR5 || id == RobotModelId::UR10;
    }
};

/// Joint range of every model: +-363 deg [rad]. Source: ConfigurationData of a simulated UR5e.
inline constexpr double kJointPositionLimit = 6.3355451848;
/// Joint acceleration limit [rad/s2]. Source: as above.
inline constexpr double kJointAccelerationLimit = 40.0;

const RobotModel& robotModel(RobotModelId id);  ///< Its data, for the life of the program.
std::span<const RobotModel> robotModels();      ///< All there are.
/// By name, case ignored: "ur5e", "UR8Long", "ur8 long".
std::optional<RobotModelId> robotModelByName(const Text& name);
/// By ConfigurationData robot_type; the first of those that share it, whose joints are the same.
std::optional<RobotModelId> robotModelByType(int robotType, bool isCb3);

}  // namespace tiller
