// SPDX-License-Identifier: MIT

// The service for power and programs (the dashboard, or the Robot API of PolyScope X), and what the primary
// interface says about the arm.

#include "robot/core/robot_model.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/robot_api_client.h"
#include "robot/doctor/detail/examiner.h"
#include "robot/script/primary_client.h"

namespace tiller::doctor {
namespace {

constexpr int kReplyMs = 2000;
constexpr int kStateMs = 2500;

QString remoteFix() {
    return DoctorText::tr(
        "Switch the robot to Remote control on the teach pendant, at the top right. Without that, Tiller "
        "only "
        "watches.");
}

}  // namespace

void Examiner::examineService() {
    if (isGood(Condition::ServicePort)) {
        examineDashboard();
    } else {
        examineRobotApi();
    }
}

void Examiner::examineDashboard() {
    dashboard::DashboardClient client(address_, patient_.ports.dashboard);
    const Deadline deadline = within(kReplyMs);
    const Result<void> connected = client.connect(deadline);
    Result<SoftwareVersion> version =
        connected ? client.polyscopeVersion(deadline) : Result<SoftwareVersion>(connected.error());
    if (!version) {
        const bool mute = version.error().code == ErrorCode::Timeout;
        // The port was open: what is behind it is the condition's real content.
        findings_.erase(Condition::ServicePort);
        found(
            Condition::ServicePort, Verdict::Bad,
            mute ? QStringLiteral("service.mute") : QStringLiteral("service.not-dashboard"),
            mute ? DoctorText::tr("the dashboard takes connections but does not answer")
                 : DoctorText::tr("what answers on port %1 is not a dashboard").arg(patient_.ports.dashboard),
            mute ? DoctorText::tr("Restart the robot's controller; if it stays like this, see its log.")
                 : DoctorText::tr("Check the address, and that no other program uses this port."));
        return;
    }
    if (version->isCb3()) {
        good(Condition::RemoteControl, DoctorText::tr("this series has no Local/Remote switch"));
        return;
    }
    const Result<bool> remote = client.isInRemoteControl(within(kReplyMs));
    if (remote && *remote) {
        good(Condition::RemoteControl, DoctorText::tr("Remote"));
    } else if (remote) {
        found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
              DoctorText::tr("Local"), remoteFix());
    } else if (remote.error().code == ErrorCode::RemoteControlRequired) {
        found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
              DoctorText::tr("Local"), remoteFix());
    }
}

void Examiner::examineRobotApi() {
    const int port = patient_.ports.robotApi;
    const dashboard::RobotApiClient client(address_, port);
    const Result<QString> version = client.apiVersion(within(kReplyMs));
    if (!version) {
        const bool silent = version.error().code == ErrorCode::Timeout;
        found(Condition::ServicePort, Verdict::Bad,
              silent ? QStringLiteral("port.service.silent") : QStringLiteral("port.service.refused"),
              DoctorText::tr("neither the dashboard (port %1) nor the Robot API (port %2) is there")
                  .arg(patient_.ports.dashboard)
                  .arg(port),
              DoctorText::tr(
                  "Switch the Dashboard Server on at the robot: Settings, Security, Services. PolyScope X "
                  "needs 10.11 "
                  "or newer for the Robot API."));
        return;
    }
    good(Condition::ServicePort,
         DoctorText::tr("Robot API %1, port %2; popups are closed on the tablet").arg(*version).arg(port));
    const Result<bool> remote = client.isInRemoteControl(within(kReplyMs));
    if (!remote) {
        return;  // before 10.12 it cannot be asked
    }
    if (*remote) {
        good(Condition::RemoteControl, DoctorText::tr("Remote"));
    } else {
        found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
              DoctorText::tr("Local"), remoteFix());
    }
}

void Examiner::examineModel() {
    if (!isGood(Condition::PrimaryPort)) {
        return;
    }
    script::PrimaryClientOptions options;
    options.host = address_;
    options.port = patient_.ports.primary;
    options.reconnect = false;
    script::PrimaryClient client(options);
    client.start();
    const Deadline deadline = within(kStateMs);
    const Result<void> heard = client.waitForState(deadline);
    const auto configuration = client.configuration();
    if (!heard || !configuration) {
        found(Condition::Model, Verdict::Bad, QStringLiteral("model.untold"),
              DoctorText::tr("the primary interface does not describe the arm"),
              DoctorText::tr("Check that this is the robot's own address, and restart its controller."));
        return;
    }
    for (const RobotModel& model : robotModels()) {
        // CB3 and e-Series share their numbers: the software tells them apart.
        if (model.robotType == configuration->robotType &&
            (!version_ || model.isCb3() == version_->isCb3())) {
            good(Condition::Model, QLatin1String(model.name));
            return;
        }
    }
    found(Condition::Model, Verdict::Attention, QStringLiteral("model.unknown"),
          DoctorText::tr("robot type %1 is newer than this program").arg(configuration->robotType),
          DoctorText::tr("Watching works. Limits and previews use the dimensions the robot reports; jog "
                         "slowly at first."));
}

}  // namespace tiller::doctor
