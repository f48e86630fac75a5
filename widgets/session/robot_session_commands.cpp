// SPDX-License-Identifier: GPL-3.0-or-later

// The part of the session that asks the controller for power, recovery and programs, and asks after what RTDE
// does not tell: the control mode, the operational mode and the loaded program.

#include "widgets/session/robot_session.h"
#include "widgets/session/session_backend.h"
#include "widgets/session/texts.h"

namespace tiller {
namespace {

using dashboard::RobotService;
using dashboard::ServiceKind;
using std::chrono::milliseconds;

constexpr milliseconds kReplyTime{3000};
/// The Robot API may answer only when it is done.
constexpr milliseconds kDoneTime{10'000};
constexpr std::int64_t kAskEveryNs = kNsPerSecond;

/// Sends one command and reports a refusal.
template <class Call>
void send(RobotSession& session, const std::unique_ptr<RobotLink>& link, const QString& what, Call call) {
    if (!link) {
        Q_EMIT session.message(Severity::Error, texts::errorText({ErrorCode::NotConnected, what, {}}));
        return;
    }
    link->service->post(
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
        session.state().service == ServiceKind::RobotApi ? kDoneTime : kReplyTime);
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
    if (const QString why = texts::serviceObstacle(d_->state, command); !why.isEmpty()) {
        Q_EMIT message(Severity::Error, tr("%1 failed. %2").arg(commandText(command), why));
        return;
    }
    if (command == RobotCommand::PowerOff || command == RobotCommand::RestartSafety) {
        stop(control::StopCause::ControlLost);
    }
    send(*this, d_->link, commandText(command),
         [command](RobotService& s, const Deadline& d) { return s.perform(command, d); });
}

void RobotSession::unlockProtectiveStop(const UnlockConsent&) {
    send(*this, d_->link, tr("Protective stop unlocked by the operator"),
         [](RobotService& s, const Deadline& d) { return s.unlockProtectiveStop(d); });
}

void RobotSession::loadProgram(const QString& name) {
    send(*this, d_->link, tr("Load program %1").arg(name),
         [name](RobotService& s, const Deadline& d) { return s.loadProgram(name, d); });
}

void RobotSession::stopForeignProgram() {
    send(*this, d_->link, commandText(RobotCommand::StopProgram),
         [](RobotService& s, const Deadline& d) { return s.perform(RobotCommand::StopProgram, d); });
}

void RobotSession::askService() {
    const std::int64_t now = d_->clock->nowNs();
    if (d_->state.link != LinkState::Live || d_->reportAsked || now - d_->reportAskedNs < kAskEveryNs) {
        return;
    }
    d_->reportAsked = true;
    d_->reportAskedNs = now;
    const std::uint64_t generation = d_->generation;
    d_->link->service->post([](RobotService& s, const Deadline& d) { return s.look(d); }, this,
                            [this, generation](const Result<dashboard::ServiceReport>& result) {
                                if (generation != d_->generation) {
                                    return;
                                }
                                d_->reportAsked = false;
                                // Which service it is stays known while it does not answer.
                                dashboard::ServiceReport silent;
                                silent.kind = d_->report.kind;
                                d_->report = result ? *result : silent;
                            },
                            kReplyTime);
}

}  // namespace tiller
