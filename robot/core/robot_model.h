// SPDX-License-Identifier: MIT
#pragma once

// Supported robot models: kinematics, limits, masses and identification, as data.
// Source: Universal Robots' DH-parameter article and description files; see the notes in robot_model.cpp.

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
    std::array<double, 6> theta{};  ///< joint offsets of a calibrated arm [rad]
    /// Deviation of nearly parallel axes of a calibrated arm [rad]: see kinematics/parallel_axes.h
    std::array<double, 6> beta{};

    bool operator==(const DhParameters&) const = default;
};

/// One link in its own DH frame: mass [kg], centre of mass [m], inertia about the centre of mass (ixx, ixy,
/// ixz, iyy, iyz, izz) [kg m2].
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
    const char* name = "";           ///< e.g. "UR5e"
    const char* dashboardName = "";  ///< answer to `get robot model`, e.g. "UR5"
    int robotType = 0;               ///< robot_type in ConfigurationData
    double reach = 0;                ///< [m]
    double maxPayload = 0;           ///< [kg]
    DhParameters dh;
    std::array<double, 6> maxJointSpeed{};     ///< rated joint speed [rad/s]
    std::array<double, 6> maxTorque{};         ///< [Nm]
    std::array<double, 6> torquePerCurrent{};  ///< [Nm/A], on the joint side
    std::array<LinkInertia, 6> links;

    bool isCb3() const {  ///< True for UR3, UR5 and UR10.
        return id == RobotModelId::UR3 || id == RobotModelId::UR5 || id == RobotModelId::UR10;
    }
};

/// Joint range of every model: +-363 deg [rad]. Source: ConfigurationData of a simulated UR5e.
inline constexpr double kJointPositionLimit = 6.3355451848;
/// Joint acceleration limit [rad/s2]. Source: ConfigurationData of a simulated UR5e.
inline constexpr double kJointAccelerationLimit = 40.0;

const RobotModel& robotModel(RobotModelId id);  ///< Data of one model, valid for the whole program.
std::span<const RobotModel> robotModels();      ///< All supported models.
/// Looks up a model by name, ignoring case: "ur5e", "UR8Long", "ur8 long".
std::optional<RobotModelId> robotModelByName(const Text& name);
/// Looks up a model by robot_type in ConfigurationData. If several models share the type, returns the first;
/// their joints are identical.
std::optional<RobotModelId> robotModelByType(int robotType, bool isCb3);

}  // namespace tiller
