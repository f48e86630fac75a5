// SPDX-License-Identifier: MIT

// Checks of the service for power and programs (the dashboard server, or the Robot API of PolyScope X), and
// of the arm as reported by the primary interface.

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
        "Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can "
        "only monitor.");
}

void examineDashboard(Examiner& examiner) {
    dashboard::DashboardClient client(examiner.address, examiner.patient.ports.dashboard);
    const Deadline deadline = examiner.within(kReplyMs);
    const Result<void> connected = client.connect(deadline);
    Result<SoftwareVersion> version =
        connected ? client.polyscopeVersion(deadline) : Result<SoftwareVersion>(connected.error());
    if (!version) {
        const bool mute = version.error().code == ErrorCode::Timeout;
        // The port is open, so the result now depends on the service on this port.
        examiner.forget(Condition::ServicePort);
        examiner.found(
            Condition::ServicePort, Verdict::Bad,
            mute ? QStringLiteral("service.mute") : QStringLiteral("service.not-dashboard"),
            mute ? DoctorText::tr("the dashboard accepts connections but does not respond")
                 : DoctorText::tr("the service on port %1 is not a dashboard server")
                       .arg(examiner.patient.ports.dashboard),
            mute ? DoctorText::tr(
                       "Restart the robot's controller. If the problem persists, see the controller log.")
                 : DoctorText::tr("Check the address, and check that no other program is using this port."));
        return;
    }
    if (version->isCb3()) {
        examiner.good(Condition::RemoteControl, DoctorText::tr("this series has no Local/Remote switch"));
        return;
    }
    const Result<bool> remote = client.isInRemoteControl(examiner.within(kReplyMs));
    if (remote && *remote) {
        examiner.good(Condition::RemoteControl, DoctorText::tr("Remote"));
    } else if (remote) {
        examiner.found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
                       DoctorText::tr("Local"), remoteFix());
    } else if (remote.error().code == ErrorCode::RemoteControlRequired) {
        examiner.found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
                       DoctorText::tr("Local"), remoteFix());
    }
}

void examineRobotApi(Examiner& examiner) {
    const int port = examiner.patient.ports.robotApi;
    const dashboard::RobotApiClient client(examiner.address, port);
    const Result<QString> version = client.apiVersion(examiner.within(kReplyMs));
    if (!version) {
        const bool silent = version.error().code == ErrorCode::Timeout;
        examiner.found(
            Condition::ServicePort, Verdict::Bad,
            silent ? QStringLiteral("port.service.silent") : QStringLiteral("port.service.refused"),
            DoctorText::tr("neither the dashboard (port %1) nor the Robot API (port %2) is available")
                .arg(examiner.patient.ports.dashboard)
                .arg(port),
            DoctorText::tr("Enable the dashboard server on the robot under Settings > Security > Services. "
                           "On PolyScope X, the Robot API requires version 10.11 or newer."));
        return;
    }
    examiner.good(Condition::ServicePort,
                  DoctorText::tr("Robot API %1, port %2; popups can be closed only on the teach pendant")
                      .arg(*version)
                      .arg(port));
    const Result<bool> remote = client.isInRemoteControl(examiner.within(kReplyMs));
    if (!remote) {
        return;  // no queries are possible before 10.12
    }
    if (*remote) {
        examiner.good(Condition::RemoteControl, DoctorText::tr("Remote"));
    } else {
        examiner.found(Condition::RemoteControl, Verdict::Bad, QStringLiteral("control.local"),
                       DoctorText::tr("Local"), remoteFix());
    }
}

}  // namespace

void examineService(Examiner& examiner) {
    if (examiner.isGood(Condition::ServicePort)) {
        examineDashboard(examiner);
    } else {
        examineRobotApi(examiner);
    }
}

void examineModel(Examiner& examiner) {
    if (!examiner.isGood(Condition::PrimaryPort)) {
        return;
    }
    script::PrimaryClientOptions options;
    options.host = examiner.address;
    options.port = examiner.patient.ports.primary;
    options.reconnect = false;
    script::PrimaryClient client(options);
    client.start();
    const Deadline deadline = examiner.within(kStateMs);
    const Result<void> heard = client.waitForState(deadline);
    const auto configuration = client.configuration();
    if (!heard || !configuration) {
        examiner.found(
            Condition::Model, Verdict::Bad, QStringLiteral("model.untold"),
            DoctorText::tr("the primary interface sends no data about the arm"),
            DoctorText::tr("Check that this is the address of the robot, and restart its controller."));
        return;
    }
    for (const RobotModel& model : robotModels()) {
        // CB3 and e-Series use the same numbers, so the software version distinguishes them.
        if (model.robotType == configuration->robotType &&
            (!examiner.version || model.isCb3() == examiner.version->isCb3())) {
            examiner.good(Condition::Model, QLatin1String(model.name));
            return;
        }
    }
    examiner.found(
        Condition::Model, Verdict::Attention, QStringLiteral("model.unknown"),
        DoctorText::tr("robot type %1 is not known to this version of Tiller").arg(configuration->robotType),
        DoctorText::tr("Monitoring works. Limits and previews use the dimensions that the robot reports; jog "
                       "slowly at first."));
}

}  // namespace tiller::doctor
