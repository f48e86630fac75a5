// SPDX-License-Identifier: MIT
#include "robot/station/jog/freedrive_axes.h"

#include <QCoreApplication>

#include "robot/station/text/format.h"

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct FreedriveText {
    Q_DECLARE_TR_FUNCTIONS(Freedrive)
};

}  // namespace

QString freedriveAxesText(FreedriveAxes axes) {
    switch (axes) {
        case FreedriveAxes::All:
            return FreedriveText::tr("All axes");
        case FreedriveAxes::Position:
            return FreedriveText::tr("Position only");
        case FreedriveAxes::Orientation:
            return FreedriveText::tr("Orientation only");
        case FreedriveAxes::Plane:
            return FreedriveText::tr("XY plane");
        case FreedriveAxes::Line:
            return FreedriveText::tr("Z only");
    }
    return {};
}

control::Freedrive freedriveOf(FreedriveAxes axes, const Eigen::Matrix3d& R_base_frame, const Pose& tcp) {
    control::Freedrive freedrive;
    if (axes == FreedriveAxes::All) {
        return freedrive;  // omit the frame, so that older software also accepts the command
    }
    switch (axes) {
        case FreedriveAxes::All:
        case FreedriveAxes::Position:
            freedrive.freeAxes = {true, true, true, false, false, false};
            break;
        case FreedriveAxes::Orientation:
            freedrive.freeAxes = {false, false, false, true, true, true};
            break;
        case FreedriveAxes::Plane:
            freedrive.freeAxes = {true, true, false, false, false, false};
            break;
        case FreedriveAxes::Line:
            freedrive.freeAxes = {false, false, true, false, false, false};
            break;
    }
    freedrive.feature.position = tcp.position;
    freedrive.feature.rotation = rotationVector(R_base_frame);
    return freedrive;
}

QString payloadDoubt(const SessionState& state) {
    if (state.moving) {
        return FreedriveText::tr("Wait for standstill before you start Freedrive.");
    }
    const double force = state.tcpForce.force.norm();
    const double torque = state.tcpForce.torque.norm();
    if (force <= kPayloadForce && torque <= kPayloadTorque) {
        return {};
    }
    const QString felt = force > kPayloadForce ? format::newtons(force) : format::newtonMetres(torque);
    return FreedriveText::tr(
               "The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, "
               "or correct the payload and the TCP.")
        .arg(felt, format::number(state.payloadMass, 2));
}

}  // namespace tiller
