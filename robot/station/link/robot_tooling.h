// SPDX-License-Identifier: MIT
#pragma once

// Sets TCP and payload of the tool on the robot. Requires control. Results are logged, and the values
// accepted by the robot appear in the next session state.

#include <QCoreApplication>
#include <QString>
#include <array>
#include <functional>
#include <optional>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"

namespace tiller {

class RobotSession;
struct SessionBackend;

class RobotTooling {
    Q_DECLARE_TR_FUNCTIONS(RobotTooling)

public:
    RobotTooling(RobotSession& session, SessionBackend& backend) : session_(session), d_(backend) {}

    struct Load {
        double mass = 0;                                   ///< [kg]
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of gravity, from the flange [m]
        std::optional<std::array<double, 6>> inertia;      ///< Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m2]
    };

    /// Sets the TCP. Rejected while the arm moves, because its speed would then refer to a different point.
    /// tcp   T_flange_tcp [m, rad]
    /// name  name for the log
    void setTcp(const Pose& tcp, const QString& name);
    /// Sets the payload. Rejected while the arm moves, because the arm would sag.
    void setPayload(const Load& load, const QString& name);

private:
    void set(const QString& done, std::function<Result<void>(const Deadline&)> order);

    RobotSession& session_;
    SessionBackend& d_;
};

}  // namespace tiller
