// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the session that asks the controller for power, recovery and programs, and asks after what RTDE
// does not tell: the control mode, the operational mode and the loaded program.

#include "widgets/session/robot_session.h"
#include "widgets/session/session_backend.h"
#include "widgets/session/texts.h"

namespace tiller {
namespace {

using dashboard::DashboardClient;
using std::chrono::milliseconds;

constexpr milliseconds kDashboardTime{3000};
constexpr std::int64_t kAskEveryNs = kNsPerSecond;

Result<void> carryOut(RobotCommand command, DashboardClient& client, const Deadline& deadline) {
    switch (command) {
        case RobotCommand::PowerOn:
            return client.powerOn(deadline);
        case RobotCommand::ReleaseBrakes:
            return client.brakeRelease(deadline);
        case RobotCommand::PowerOff:
            return client.powerOff(deadline);
        case RobotCommand::RestartSafety:
            return client.restartSafety(deadline);
        case RobotCommand::ClosePopups: {
            Result<void> closed = client.closePopup(deadline);
            return closed ? client.closeSafetyPopup(deadline) : closed;
        }
        case RobotCommand::Play:
            return client.play(deadline);
        case RobotCommand::Pause:
            return client.pause(deadline);
        case RobotCommand::StopProgram:
            return client.stop(deadline);
    }
    return Error{ErrorCode::Internal, QStringLiteral("unknown command"), {}};
}

/// Sends one dashboard command and reports a refusal.
template <class Call>
void send(RobotSession& session, const std::unique_ptr<RobotLink>& link, const QString& what, Call call) {
    if (!link || !link->dashboard) {
        Q_EMIT session.message(Severity::Error, texts::errorText({ErrorCode::NotConnected, what, {}}));
        return;
    }
    link->dashboard->post(
        std::move(call), &session,
        [&session, what](const Result<void>& result) {
            if (result) {
                Q_EMIT session.message(Severity::Info, what, Origin::Operator);
            } else {
                Q_EMIT session.message(
                    Severity::Error,
                    RobotSession::tr("%1 failed. %2").arg(what, texts::errorText(result.error())));
            }
        },
        kDashboardTime);
}

}  // namespace

QString commandText(RobotCommand command) {
    switch (command) {
        case RobotCommand::PowerOn:
            return RobotSession::tr("Power on");
        case RobotCommand::ReleaseBrakes:
            return RobotSession::tr("Release brakes");
        case RobotCommand::PowerOff:
            return RobotSession::tr("Power off");
        case RobotCommand::RestartSafety:
            return RobotSession::tr("Restart safety");
        case RobotCommand::ClosePopups:
            return RobotSession::tr("Close popups");
        case RobotCommand::Play:
            return RobotSession::tr("Play program");
        case RobotCommand::Pause:
            return RobotSession::tr("Pause program");
        case RobotCommand::StopProgram:
            return RobotSession::tr("Stop program");
    }
    return {};
}

void RobotSession::perform(RobotCommand command) {
    if (command == RobotCommand::PowerOff || command == RobotCommand::RestartSafety) {
        stop(control::StopCause::ControlLost);
    }
    send(*this, d_->link, commandText(command),
         [command](DashboardClient& c, const Deadline& d) { return carryOut(command, c, d); });
}

void RobotSession::unlockProtectiveStop(const UnlockConsent&) {
    send(*this, d_->link, tr("Protective stop unlocked by the operator"),
         [](DashboardClient& c, const Deadline& d) { return c.unlockProtectiveStop(d); });
}

void RobotSession::loadProgram(const QString& name) {
    send(*this, d_->link, tr("Load program %1").arg(name),
         [name](DashboardClient& c, const Deadline& d) { return c.loadProgram(name, d); });
}

void RobotSession::stopForeignProgram() {
    send(*this, d_->link, commandText(RobotCommand::StopProgram),
         [](DashboardClient& c, const Deadline& d) { return c.stop(d); });
}

void RobotSession::askDashboard() {
    const std::int64_t now = d_->clock->nowNs();
    if (d_->state.link != LinkState::Live || d_->dashboardAsked || now - d_->dashboardAskedNs < kAskEveryNs) {
        return;
    }
    d_->dashboardAsked = true;
    d_->dashboardAskedNs = now;
    const std::uint64_t generation = d_->generation;
    const SoftwareVersion version = d_->state.version;
    d_->link->dashboard->post(
        [version](DashboardClient& c, const Deadline& d) -> Result<DashboardPicture> {
            DashboardPicture picture;
            if (!version.isCb3()) {
                const Result<bool> remote = c.isInRemoteControl(d);
                if (!remote) {
                    return remote.error();
                }
                picture.remoteControl = *remote;
                if (const auto mode = c.command(QStringLiteral("get operational mode"), d)) {
                    // Anything but the two modes means that none is set, or that the software has none.
                    const QString word = mode->trimmed().toUpper();
                    if (word == QLatin1String("MANUAL") || word == QLatin1String("AUTOMATIC")) {
                        picture.operationalMode = word;
                    }
                }
            }
            if (const auto program = c.programState(d)) {
                picture.program = program->program;
            }
            return picture;
        },
        this,
        [this, generation](const Result<DashboardPicture>& result) {
            if (generation != d_->generation) {
                return;
            }
            d_->dashboardAsked = false;
            d_->dashboardPicture = result ? *result : DashboardPicture{};
        },
        kDashboardTime);
}

}  // namespace tiller
